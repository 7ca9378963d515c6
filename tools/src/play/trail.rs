//! The way of a body, for the picture.
#![allow(clippy::cast_precision_loss, reason = "drawing only; nothing here flows back into the simulation")]

use tilesat::{Hit, Toi, Vec2};

use super::figure::Figure;

/// One point of a trail, in pixels: the position of a body after a frame or at a hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    pub at: (f32, f32),
    /// The normal of the surface that the body hit, if any.
    pub hit: Option<(i32, i32)>,
    /// Whether the body was put here instead of moving from the point before.
    pub fresh: bool,
}

impl Point {
    /// Where a frame ended.
    pub fn end(now: &Figure, fresh: bool) -> Self {
        Self { at: pixel(now), hit: None, fresh }
    }

    /// The body's position at the hit.
    pub fn contact(from: &Figure, hit: &Hit, asked: Vec2) -> Self {
        let ((x, y), part) = (pixel(from), hit.toi.raw() as f32 / Toi::ONE.raw() as f32);
        let at = (x + asked.x.to_num::<f32>() * part, y + asked.y.to_num::<f32>() * part);
        Self { at, hit: Some((hit.axis.x, hit.axis.y)), fresh: false }
    }
}

/// The middle in pixels.
fn pixel(figure: &Figure) -> (f32, f32) {
    let (x, y) = match *figure {
        Figure::Box { min, max } => (min.0 + max.0, min.1 + max.1),
        Figure::Disc { centre, .. } => (2 * centre.0, 2 * centre.1),
    };
    (x as f32 / 131_072.0, y as f32 / 131_072.0)
}
