//! Draws a run.
#![allow(clippy::cast_precision_loss, reason = "drawing only; nothing here flows back into the simulation")]

mod bodies;
mod footer;
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
    bodies::trails(&mut scene, run);
    bodies::contacts(&mut scene, run);
    bodies::bodies(&mut scene, run);
    footer::draw(&mut scene, level, run, name, seed);
    scene
}
