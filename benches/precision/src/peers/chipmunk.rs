//! Chipmunk2D, in C and double precision: its query for two shapes.

use crate::job::{Format, List};
use crate::pairs::classes::Pair;
use crate::pairs::truth::Answer;
use chipmunk_sys::{
    Struct_cpBB, cpBody, cpBodyNewStatic, cpBoxShapeNew2, cpCircleShapeNew, cpContactPointSet, cpSegmentShapeNew,
    cpShape, cpShapeFree, cpShapeUpdate, cpShapesCollide, cpTransform, cpVect, cpv,
};
use std::cell::Cell;
use std::ptr;
use tilesat_judge::oracle::figure::{Figure, Kind};

pub const NAME: &str = "Chipmunk2D";

pub fn length(raw: f64) -> f64 {
    raw / 65536.0
}

pub fn vector((x, y): (i64, i64)) -> cpVect {
    cpv(length(x as f64), length(y as f64))
}

pub const HERE: cpTransform = cpTransform { a: 1.0, b: 0.0, c: 0.0, d: 1.0, tx: 0.0, ty: 0.0 };

/// A shape of the library at its position, as after a step.
pub struct Shape(pub *mut cpShape);

/// The one body that holds all shapes at their positions.
pub fn body() -> *mut cpBody {
    thread_local!(static BODY: Cell<*mut cpBody> = const { Cell::new(ptr::null_mut()) });
    BODY.with(|slot| {
        if slot.get().is_null() {
            // SAFETY: makes a new body.
            slot.set(unsafe { cpBodyNewStatic() });
        }
        slot.get()
    })
}

impl Shape {
    pub fn of(figure: &Figure) -> Self {
        let body = body();
        // SAFETY: a new shape of a body that is never freed.
        unsafe {
            Self::cached(match *figure {
                Figure::Circle { centre, radius } => cpCircleShapeNew(body, length(radius as f64), vector(centre)),
                Figure::Segment { a, b } => cpSegmentShapeNew(body, vector(a), vector(b), 0.0),
                Figure::Aabb { min, max } => {
                    let (lo, hi) = (vector(min), vector(max));
                    cpBoxShapeNew2(body, Struct_cpBB { l: lo.x, b: lo.y, r: hi.x, t: hi.y }, 0.0)
                }
            })
        }
    }

    /// # Safety
    /// It is a new shape of [`body`].
    pub unsafe fn cached(shape: *mut cpShape) -> Self {
        // SAFETY: a valid shape, which nobody else has.
        unsafe { cpShapeUpdate(shape, HERE) };
        Self(shape)
    }
}

impl Drop for Shape {
    fn drop(&mut self) {
        // SAFETY: made by `of`, and not shared.
        unsafe { cpShapeFree(self.0) }
    }
}

pub fn answer(set: &cpContactPointSet) -> Answer {
    let deepest = set.points.iter().take(set.count as usize).map(|p| p.distance).reduce(f64::min);
    Answer { hit: deepest.is_some(), depth: deepest.map(|d| -d) }
}

/// In this order of kinds it does not swap them. A swap would change the sign of its distances.
pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    if kinds == (Kind::Segment, Kind::Segment) {
        return;
    }
    list.add(
        (NAME, "contact", Format::F64),
        |(a, b): &Pair| (Shape::of(a), Shape::of(b)),
        // SAFETY: two shapes that live as long as the loop.
        |(a, b)| unsafe { cpShapesCollide(a.0, b.0) },
        answer,
    );
}
