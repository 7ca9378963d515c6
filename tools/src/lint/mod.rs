//! Looks for mistakes in a level before it is baked.

mod crossings;
mod edges;
mod finding;
mod findings;
mod index;
mod nesting;
mod outlines;
mod pockets;
mod reach;
mod scene;
mod surface;

pub use finding::{Finding, Severity, Who};
pub use findings::{COUNTED, Findings, SHOWN};
pub use scene::{Body, Rules};

use crate::bake::level::Level;
use crate::fail::{Fail, Result};
use crate::rules::ground::Ground;
use scene::Scene;

/// The most edges of a segment map.
const MAX_EDGES: usize = 65_534;

/// All findings about a level.
///
/// Time and memory are n log n in the edges and linear in the tiles. If so many things overlap that
/// all pairs are too many, a check ends early and reports it.
///
/// # Errors
///
/// If it has more edges or faces than can be compared.
pub fn check(drawing: &Ground, rules: &Rules) -> Result<Findings> {
    let edges = edges::of(&drawing.outlines);
    if edges.len() > MAX_EDGES {
        return Err(Fail::new(format!(
            "{} edges, but a segment map holds {MAX_EDGES}: cut the level in two",
            edges.len()
        )));
    }
    let surface = Level::of(drawing, &[])?.map(surface::of).transpose()?;
    let mut scene = Scene::new(drawing, rules, edges, surface);
    outlines::check(&mut scene);
    let crossed = crossings::check(&mut scene);
    nesting::check(&mut scene, &crossed);
    reach::check(&mut scene);
    pockets::check(&mut scene);
    Ok(scene.findings)
}
