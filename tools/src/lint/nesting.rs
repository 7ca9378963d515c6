//! Solids within solids and holes in nothing.

use std::collections::HashSet;

use super::edges::is_sound;
use super::finding::Severity::{Error, Warning};
use super::geometry::{Edge, Point, doubled_area, orient, winding};
use super::scene::Scene;
use crate::rules::kind::Kind;

/// Outlines that cross others are on both sides of them; that has been said.
pub(super) fn check(scene: &mut Scene<'_>, crossed: &HashSet<usize>) {
    for i in 0..scene.drawing.outlines.len() {
        let outline = &scene.drawing.outlines[i];
        if !is_sound(outline) || crossed.contains(&i) || doubled_area(&outline.points) == 0 {
            continue;
        }
        let Some((edge, around)) = surroundings(scene, i) else { continue };
        let (who, at) = (vec![scene.owner(i, None)], edge.middle());
        match (outline.kind, around) {
            (Kind::Hole, ..=0) => {
                let what = "a hole outside of any solid";
                scene.say((Error, "hole-outside"), who, at, what, "its edge blocks what comes from within");
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

/// How many solids, less holes, lie around an outline, and by which of its edges; `None` if it lies on others all along.
fn surroundings(scene: &Scene<'_>, outline: usize) -> Option<(Edge, i32)> {
    for edge in scene.edges.iter().filter(|edge| edge.outline == Some(outline)) {
        let middle = (edge.a.0 + edge.b.0, edge.a.1 + edge.b.1);
        let on_another = scene
            .index
            .near(edge, 0)
            .iter()
            .any(|&j| scene.edges[j].outline != Some(outline) && on(&scene.edges[j], middle));
        if !on_another {
            return Some((*edge, depth(scene, middle, Some(outline))));
        }
    }
    None
}

/// How many solids, less holes, hold a point of doubled coordinates.
pub(super) fn depth(scene: &Scene<'_>, point: Point, without: Option<usize>) -> i32 {
    let mut depth = 0;
    for (i, outline) in scene.drawing.outlines.iter().enumerate() {
        if Some(i) != without && outline.kind.has_area() && is_sound(outline) {
            let wound = winding(&outline.points, point) * doubled_area(&outline.points).signum() as i32;
            depth += if outline.kind == Kind::Solid { wound } else { -wound };
        }
    }
    depth
}

/// Whether a point of doubled coordinates lies on an edge.
fn on(edge: &Edge, p: Point) -> bool {
    let (a, b) = ((2 * edge.a.0, 2 * edge.a.1), (2 * edge.b.0, 2 * edge.b.1));
    let between = |v: i64, a: i64, b: i64| a.min(b) <= v && v <= a.max(b);
    orient(a, b, p) == 0 && between(p.0, a.0, b.0) && between(p.1, a.1, b.1)
}
