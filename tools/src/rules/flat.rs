//! Outlines without an inside or a length: slips of the mouse, and lines drawn as rectangles. They
//! are not solid, and the report names them.

use super::kind::Kind;
use super::knots;
use crate::geometry::{Point, doubled_area};

/// Taking a polygon apart takes seconds if it has ten thousand corners. The library refuses a
/// larger one without an area.
const MOST_CORNERS: usize = 2000;

/// Why an outline is nothing. `None` if it is something.
pub(super) fn why(kind: Kind, closed: bool, points: &[Point]) -> Option<String> {
    let same = |of: fn(&Point) -> i64| points.windows(2).all(|pair| of(&pair[0]) == of(&pair[1]));
    let (x, y) = (same(|p| p.0), same(|p| p.1));
    let is_area = kind.has_area() && closed;
    let (why, fix) = if x && y {
        match points.len() {
            0 | 1 => ("it has no second point", "draw one"),
            _ => ("it is smaller than 1/65536 of a pixel", "make it larger, or remove it"),
        }
    } else if !is_area {
        return None;
    } else if points.len() < 3 {
        ("it has 2 corners", "draw a third one")
    } else if x || y {
        (if x { "its width is 0" } else { "its height is 0" }, "give it one, or draw a polyline, which is a wall")
    } else if points.len() <= MOST_CORNERS && doubled_area(points) == 0 && !knots::has_inside(points) {
        ("it has no area", "give it one, or draw a polyline, which is a wall")
    } else {
        return None;
    };
    Some(format!("{why}, so it is not solid: {fix}"))
}
