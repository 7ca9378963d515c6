//! The way of a body, for the picture.
#![allow(clippy::cast_precision_loss, reason = "drawing only; nothing here flows back into the simulation")]

use tilesat::{Hit, Toi, Vec2};

use super::figure::Figure;

/// One point of a trail, in pixels: where a body was after a frame or when it met something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    pub at: (f32, f32),
    /// The normal of what the body met, if it met something.
    pub hit: Option<(i32, i32)>,
    /// Whether the body was put here and did not come from the point before.
    pub fresh: bool,
}

impl Point {
    /// Where a frame ended.
    pub fn end(now: &Figure, fresh: bool) -> Self {
        Self { at: pixel(now), hit: None, fresh }
    }

    /// Where the body was when it met something.
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
