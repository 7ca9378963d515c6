//! Draws the polygons and chains of a level.

use tilesat::world::{Geometry, World};
use tilesat::{Aabb, SegmentMap};

use crate::bake::level::Level;
use crate::picture::ink::{EARTH, PLANK};
use crate::picture::marks::Scene;
use crate::picture::surface;
use crate::play::walls::Walls;

/// The ends of a row's solid, in raw units.
type Span = (f64, f64);
/// The ends of a border, in raw units.
type Border = ((f64, f64), (f64, f64));

/// Fills the polygons, row by row of the picture. Equal rows are one mark.
pub(super) fn fill(scene: &mut Scene, bytes: &[u8], level: &Level) {
    let walls = Walls::new(bytes);
    let edges: Vec<Border> =
        walls.borders().map(|(a, b)| ((a.0 as f64, a.1 as f64), (b.0 as f64, b.1 as f64))).collect();
    let (left, top) = (f64::from(level.origin.0), f64::from(level.origin.1));
    let right = left + f64::from(scene.level.0) * 65536.0;
    let count = (scene.level.1 * scene.scale) as usize;
    let step = 65536.0 / f64::from(scene.scale);
    let row = |index: usize| top + index as f64 * step;
    let (mut start, mut last) = (0, Vec::new());
    for index in 0..=count {
        let spans =
            if index < count { spans(&edges, row(index).midpoint(row(index + 1)), (left, right)) } else { Vec::new() };
        if spans == last {
            continue;
        }
        let (from, to) = (row(start), row(index));
        for (x, end) in last {
            let pixels = |raw: f64| (raw / 65536.0) as f32;
            scene.rect((pixels(x), pixels(from)), (pixels(end - x), pixels(to - from)), EARTH);
        }
        (start, last) = (index, spans);
    }
}

/// The solid at this height, between two sides.
fn spans(edges: &[Border], y: f64, (left, right): Span) -> Vec<Span> {
    let crossed = edges.iter().filter(|(a, b)| (a.1 <= y) != (b.1 <= y));
    let mut crossings: Vec<(f64, i32)> =
        crossed.map(|&(a, b)| (a.0 + (y - a.1) * (b.0 - a.0) / (b.1 - a.1), if a.1 <= y { -1 } else { 1 })).collect();
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut depth, mut from, mut spans) = (0, 0.0, Vec::new());
    for (x, step) in crossings {
        if depth <= 0 && depth + step > 0 {
            from = x;
        } else if depth > 0 && depth + step <= 0 {
            spans.push((from.max(left), x.min(right)));
        }
        depth += step;
    }
    spans.retain(|(from, to)| from < to);
    spans
}

/// The lines that bodies meet: borders and walls on their solid sides, and one-way chains.
pub(super) fn surfaces(scene: &mut Scene, bytes: &[u8], tile: f32) {
    let Ok(map) = SegmentMap::from_bytes(bytes) else { return };
    let Ok(whole) = Aabb::new(map.grid().origin(), map.grid().end()) else { return };
    let features: Vec<_> = World::features(&map, &whole).collect();
    surface::draw(scene, &features, tile);
    for feature in features.iter().filter(|feature| feature.one_way) {
        if matches!(feature.geometry, Geometry::Face { .. }) {
            for (a, b) in surface::lines(&feature.geometry) {
                scene.line(vec![a, b], tile / 8.0, PLANK, false);
            }
        }
    }
}
