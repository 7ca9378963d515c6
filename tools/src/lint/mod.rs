//! Looks for mistakes in a level before it is baked.

mod crossings;
mod edges;
mod finding;
pub mod geometry;
mod index;
mod nesting;
mod outlines;
mod pockets;
mod reach;
mod scene;
mod surface;

pub use finding::{Finding, Severity, Who};
pub use scene::{Body, Rules};

use crate::bake::level::Level;
use crate::fail::{Fail, Result};
use crate::rules::ground::Ground;
use index::Index;
use scene::Scene;

/// As many edges as a segment map can hold.
const MAX_EDGES: usize = 65_534;

/// All findings about a level, the worst first.
///
/// # Errors
///
/// It has more edges or faces than can be compared.
pub fn check(drawing: &Ground, rules: &Rules) -> Result<Vec<Finding>> {
    let edges = edges::of(&drawing.outlines);
    if edges.len() > MAX_EDGES {
        return Err(Fail::new(format!("{} edges; a segment map holds {MAX_EDGES}", edges.len())));
    }
    let surface = Level::of(drawing, &[])?.map(surface::of).transpose()?;
    let index = Index::new(&edges);
    let mut scene = Scene { drawing, rules, edges, index, surface, findings: Vec::new() };
    outlines::check(&mut scene);
    let crossed = crossings::check(&mut scene);
    nesting::check(&mut scene, &crossed);
    reach::check(&mut scene);
    pockets::check(&mut scene);
    let mut findings = scene.findings;
    findings.sort_unstable();
    findings.dedup();
    Ok(findings)
}
