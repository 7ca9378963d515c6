//! Draws a run.
#![allow(clippy::cast_precision_loss, reason = "drawing only; nothing here flows back into the simulation")]

mod bodies;
mod footer;
mod polygons;
mod tiles;

use super::arena::Arena;
use super::run::Run;
use crate::picture::marks::Scene;

/// The greatest side of a picture, in output pixels.
const AIM: f32 = 2000.0;

/// The level, the ways and hits of its bodies, and the counts below.
pub fn scene(arena: &Arena, run: &Run, name: &str, seed: u32) -> Scene {
    let level = &arena.level;
    let tile = f32::from(level.tile);
    let (width, height) = (f32::from(level.width) * tile, f32::from(level.height) * tile);
    let fits = |scale: &&f32| width.max(height) * **scale <= AIM;
    let scale = [3.0, 2.0, 1.5, 1.0, 0.5].iter().find(fits).copied().unwrap_or(0.25);
    let mut scene = Scene::new(width, height, scale, tile / 16.0);
    tiles::draw(&mut scene, level, run);
    let first = scene.marks.len();
    let corner = [level.origin.0, level.origin.1].map(|raw| raw as f32 / 65536.0);
    let polygons = arena.segments.as_deref();
    if let Some(bytes) = polygons {
        polygons::fill(&mut scene, bytes, level);
    }
    tiles::surfaces(&mut scene, level);
    if let Some(bytes) = polygons {
        polygons::surfaces(&mut scene, bytes, tile);
    }
    bodies::trails(&mut scene, run);
    bodies::contacts(&mut scene, run);
    bodies::bodies(&mut scene, run);
    // The picture begins at the first cell.
    scene.shift(first, (-corner[0], -corner[1]));
    footer::draw(&mut scene, level, run, name, seed);
    scene
}
