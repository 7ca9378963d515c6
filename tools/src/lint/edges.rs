//! Outlines as edges with a solid side.

use crate::geometry::{Edge, Point, Side, doubled_area};
use crate::rules::kind::Kind;
use crate::rules::outline::Outline;

/// Contract C1: coordinates are below 2^29 raw.
pub(super) fn in_domain(p: Point) -> bool {
    p.0.abs() < 1 << 29 && p.1.abs() < 1 << 29
}

/// Whether an outline can be built at all. The checks of outlines report the faults of the others.
pub(super) fn is_sound(outline: &Outline) -> bool {
    let enough = outline.points.len() >= if outline.closed { 3 } else { 2 };
    enough && (outline.closed || !outline.kind.has_area()) && outline.points.iter().all(|&p| in_domain(p))
}

pub(super) fn of(outlines: &[Outline]) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (i, outline) in outlines.iter().enumerate().filter(|(_, outline)| is_sound(outline)) {
        let clockwise = doubled_area(&outline.points) > 0;
        let turn = match outline.kind {
            Kind::Solid => !clockwise,
            Kind::Hole => clockwise,
            Kind::Wall | Kind::OneWay => false,
        };
        let side = match outline.kind {
            Kind::Solid | Kind::Hole => Side::Solid,
            Kind::Wall => Side::Wall,
            Kind::OneWay => Side::OneWay,
        };
        for (number, (a, b)) in outline.edges().enumerate().filter(|(_, (a, b))| a != b) {
            let edge = Edge { a, b, outline: Some(i), number, side };
            edges.push(if turn { edge.reversed() } else { edge });
        }
    }
    edges
}
