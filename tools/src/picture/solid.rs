//! Draws the solid of a level pixel by pixel, from the library's strict overlap test.

use tilesat::{Aabb, Vec2, World};

use super::ink::Ink;
use super::marks::{Scene, Spot};

/// Points per pixel on each axis.
const FINE: i32 = 4;

/// Fills the solid of the first `size` pixels of a level, drawn at `at`, with `scale` pixels per
/// unit.
pub fn fill(scene: &mut Scene, map: &impl World, at: Spot, size: (i32, i32), scale: i32, ink: Ink) {
    for y in 0..size.1 {
        let mut x = 0;
        while x < size.0 {
            let share = share(map, x, y, scale);
            let start = x;
            while x < size.0 && share == self::share(map, x, y, scale) {
                x += 1;
            }
            if share > 0 {
                let ink = ink.alpha(ink.alpha * share as f32 / (FINE * FINE) as f32);
                scene.rect((at.0 + start as f32, at.1 + y as f32), ((x - start) as f32, 1.0), ink);
            }
        }
    }
}

/// The number of points of a pixel that are inside. They are odd fractions of a unit, so none is on
/// a tile's border.
fn share(map: &impl World, x: i32, y: i32, scale: i32) -> i32 {
    let place = |pixel: i32, part: i32| ((pixel * FINE + part) * 2 + 1) * (65536 / (2 * FINE * scale));
    let inside = |i: i32| {
        let p = Vec2::from_raw(place(x, i % FINE), place(y, i / FINE));
        Aabb::new(p, p).is_ok_and(|point| map.overlaps_aabb(&point))
    };
    (0..FINE * FINE).filter(|&i| inside(i)).count() as i32
}
