//! The edges of drawn forms that block from one side. A one-way rectangle is a platform: bodies
//! stand on its upper edge, and pass the others.

use tilesat::TileShape;

use crate::geometry::doubled_area;
use crate::model::object::{Spot, raw};

/// As steep as the steepest slope of the library: two cells up per cell. Steeper edges are the
/// flanks of a platform.
const STEEPEST: i64 = 2;

/// The chains along a closed form that face a side. Each blocks from there, however it was drawn.
/// The side is that of a one-way shape.
pub(super) fn facing(points: &[Spot], side: TileShape) -> Vec<Vec<Spot>> {
    let mut points = points.to_vec();
    if doubled_area(&raw(&points)) < 0 {
        points.reverse();
    }
    let count = points.len();
    let steps: Vec<(i64, i64)> = (0..count).map(|at| step(points[at], points[(at + 1) % count], side)).collect();
    let gentle = |(along, across): (i64, i64)| along > 0 && across.abs() <= STEEPEST * along;
    // A peak has only steep edges.
    let any_gentle = steps.iter().any(|step| gentle(*step));
    let faces = |at: usize| if any_gentle { gentle(steps[at % count]) } else { steps[at % count].0 > 0 };
    let starts = (0..count).filter(|&at| faces(at) && !faces(at + count - 1));
    let chain = |start: usize| {
        let length = (start..start + count).take_while(|&at| faces(at)).count();
        (start..=start + length).map(|at| points[at % count]).collect()
    };
    starts.map(chain).collect()
}

/// Turns a line around if it would block from below. A steep line stays as it is drawn: nobody can
/// stand on it.
pub(super) fn upward(points: &mut [Spot]) {
    let [first, .., last] = points else { return };
    let (along, across) = step(*first, *last, TileShape::OneWayUp);
    if along < 0 && across.abs() <= STEEPEST * -along {
        points.reverse();
    }
}

/// The way between two points, in raw units: along an edge that faces the side, and across it.
fn step(from: Spot, to: Spot, side: TileShape) -> (i64, i64) {
    let (x, y) = (to.0.raw() - from.0.raw(), to.1.raw() - from.1.raw());
    match side {
        TileShape::OneWayRight => (y, x),
        TileShape::OneWayDown => (-x, y),
        TileShape::OneWayLeft => (-y, x),
        _ => (x, y),
    }
}
