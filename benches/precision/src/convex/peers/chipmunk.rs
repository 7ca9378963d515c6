//! Chipmunk2D, in C and double precision: its query for two shapes, at their positions.

use crate::convex::classes::Pair;
use crate::job::{Format, List};
use crate::pairs::truth::Answer;
use crate::peers::chipmunk::{HERE, NAME, Shape as Own, answer, body, length, vector};
use chipmunk_sys::{cpCircleShapeNew, cpPolyShapeNew, cpSegmentShapeNew, cpShapesCollide};
use tilesat_judge::convex::shape::Shape;

fn of(shape: &Shape) -> Own {
    let (corners, radius) = (shape.vertices(), length(shape.radius() as f64));
    let points: Vec<_> = corners.into_iter().map(vector).collect();
    // SAFETY: a new shape of a body that is never freed. The count is correct, and it copies them.
    unsafe {
        Own::cached(match points[..] {
            [centre] => cpCircleShapeNew(body(), radius, centre),
            [a, b] => cpSegmentShapeNew(body(), a, b, radius),
            _ => cpPolyShapeNew(body(), points.len() as i32, points.as_ptr(), HERE, radius),
        })
    }
}

pub fn pairs(list: &mut List<Pair, Answer>) {
    list.add(
        (NAME, "contact", Format::F64),
        |(a, b): &Pair| (of(a), of(b)),
        // SAFETY: two shapes that live as long as the loop.
        |(a, b)| unsafe { cpShapesCollide(a.0, b.0) },
        answer,
    );
}
