//! Finds solids within solids and holes in nothing.

use std::collections::HashSet;

use super::finding::Severity::{Error, Warning};
use super::index::{Bounds, Work};
use super::scene::Scene;
use crate::geometry::{Edge, Point, crossed, orient};
use crate::rules::kind::Kind;

/// Outlines that cross others are on both sides of them. Another check reports those.
pub(super) fn check(scene: &mut Scene<'_>, crossing: &HashSet<usize>) {
    let mut work = Work::for_edges(scene.edges.len());
    let edges = scene.edges.clone();
    for edges in edges.chunk_by(|a, b| a.outline == b.outline) {
        let Some(i) = edges[0].outline.filter(|i| !crossing.contains(i)) else { continue };
        if !scene.bounds_inside(&edges[0]) {
            continue;
        }
        let surroundings = surroundings(scene, edges, &mut work);
        if work.is_spent() {
            return scene.say_unfinished(&edges[0], "the linter did not check nesting from here on");
        }
        let Some((edge, around)) = surroundings else { continue };
        let (who, at) = (vec![scene.owner(i, None)], edge.middle());
        match (scene.drawing.outlines[i].kind, around) {
            (Kind::Hole, ..=0) => {
                let what = "a hole outside any solid";
                scene.say((Error, "hole-outside"), who, at, what, "its edge blocks bodies from within");
            }
            (Kind::Hole, 2..) => {
                let what = format!("a hole where {around} solids lie on each other");
                scene.say((Error, "hole-buried"), who, at, what, "it stays solid, yet has edges");
            }
            (Kind::Solid, 1..) => {
                let what = "a solid within a solid";
                scene.say((Warning, "solid-buried"), who, at, what, "it changes nothing and costs time");
            }
            _ => {}
        }
    }
}

/// The number of solids, minus holes, around an outline of these edges, and their names. `None` if
/// it lies on others everywhere.
fn surroundings(scene: &Scene<'_>, edges: &[Edge], work: &mut Work) -> Option<(Edge, i32)> {
    for edge in edges {
        let middle = (edge.a.0 + edge.b.0, edge.a.1 + edge.b.1);
        let on_another = scene.index.near(edge, 0, work).any(|j| {
            let other = &scene.edges[j];
            other.outline != edge.outline && on(other, middle)
        });
        if !on_another {
            return Some((*edge, depth(scene, middle, edge.outline, work)));
        }
    }
    None
}

/// The number of solids, minus holes, that contain a point of doubled coordinates. All edges have
/// the solid on the same side.
pub(super) fn depth(scene: &Scene<'_>, point: Point, without: Option<usize>, work: &mut Work) -> i32 {
    let hit = scene.index.within(Bounds::ray(point), work).map(|j| &scene.edges[j]);
    let counts = |edge: &&Edge| scene.bounds_inside(edge) && (without.is_none() || edge.outline != without);
    hit.filter(counts).map(|edge| crossed(edge.a, edge.b, point)).sum()
}

/// Whether a point of doubled coordinates lies on an edge.
fn on(edge: &Edge, p: Point) -> bool {
    let (a, b) = ((2 * edge.a.0, 2 * edge.a.1), (2 * edge.b.0, 2 * edge.b.1));
    let between = |v: i64, a: i64, b: i64| a.min(b) <= v && v <= a.max(b);
    orient(a, b, p) == 0 && between(p.0, a.0, b.0) && between(p.1, a.1, b.1)
}
