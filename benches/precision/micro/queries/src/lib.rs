//! The queries for microcontrollers, the same as on the host. Counts and sizes share one list.

#![no_std]

mod broad;
mod casts;
mod moves;
mod pairs;
mod rays;

pub use broad::{All, Area, Phase, Scene, Sorted};
pub use casts::{Cast, sweep};
pub use moves::{Exact, Level, MOVER, Room, Step};
pub use pairs::{meets, seen, touching};
pub use parry2d::bounding_volume::{Aabb as PAabb, BoundingVolume};
use parry2d::math::Pose;
pub use parry2d::math::Vector as PVector;
pub use parry2d::query::{Contact, ShapeCastHit, ShapeCastOptions, details};
pub use parry2d::shape::{Ball, Cuboid, Segment as PSegment};
pub use parry2d::utils::segments_intersection2d;
pub use rays::{Map, Ray};
pub use tilesat;
pub use tilesat::broad::{BruteForce, LooseGrid, SortSweep, SpatialHash};
pub use tilesat::prelude::*;
use tilesat_textbook::Scalar;
pub use tilesat_textbook::{Q16, Wide, cast, dda, pair, shape as book, walk};

pub type Raw = [i32; 4];

/// A shape from four words: a middle and a radius, two corners, or two ends.
pub trait Shape {
    fn of(raw: &Raw) -> Self;
}

fn legal<T, E>(made: Result<T, E>) -> T {
    match made {
        Ok(shape) => shape,
        Err(_) => panic!("inputs are in the domain"),
    }
}

impl Shape for tilesat::Circle {
    fn of(&[x, y, r, _]: &Raw) -> Self {
        legal(Self::new(tilesat::Vec2::from_raw(x, y), tilesat::Fx::from_bits(r)))
    }
}

impl Shape for tilesat::Aabb {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        legal(Self::new(tilesat::Vec2::from_raw(x, y), tilesat::Vec2::from_raw(z, w)))
    }
}

impl Shape for tilesat::Segment {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        legal(Self::new(tilesat::Vec2::from_raw(x, y), tilesat::Vec2::from_raw(z, w)))
    }
}

impl<S: Scalar> Shape for book::Circle<S> {
    fn of(&[x, y, r, _]: &Raw) -> Self {
        Self { c: book::Vector::of_raw(x, y), r: S::of_raw(r) }
    }
}

impl<S: Scalar> Shape for book::Aabb<S> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        Self { lo: book::Vector::of_raw(x, y), hi: book::Vector::of_raw(z, w) }
    }
}

impl<S: Scalar> Shape for book::Segment<S> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        Self { a: book::Vector::of_raw(x, y), b: book::Vector::of_raw(z, w) }
    }
}

/// A shape of the library at its position.
pub type At<T> = (Pose, T);

fn px(raw: i32) -> f32 {
    raw as f32 / 65536.0
}

impl Shape for At<Ball> {
    fn of(&[x, y, r, _]: &Raw) -> Self {
        (Pose::translation(px(x), px(y)), Ball::new(px(r)))
    }
}

impl Shape for At<Cuboid> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        let middle = Pose::translation((px(x) + px(z)) / 2.0, (px(y) + px(w)) / 2.0);
        (middle, Cuboid::new(PVector::new((px(z) - px(x)) / 2.0, (px(w) - px(y)) / 2.0)))
    }
}

impl Shape for At<PSegment> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        (Pose::identity(), PSegment::new(PVector::new(px(x), px(y)), PVector::new(px(z), px(w))))
    }
}

impl Shape for PAabb {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        Self::new(PVector::new(px(x), px(y)), PVector::new(px(z), px(w)))
    }
}

/// A point or a motion from two words.
pub trait Place {
    fn of(x: i32, y: i32) -> Self;
}

impl Place for tilesat::Vec2 {
    fn of(x: i32, y: i32) -> Self {
        Self::from_raw(x, y)
    }
}

impl Place for (i32, i32) {
    fn of(x: i32, y: i32) -> Self {
        (x, y)
    }
}

impl<S: Scalar> Place for book::Vector<S> {
    fn of(x: i32, y: i32) -> Self {
        Self::of_raw(x, y)
    }
}

impl Place for PVector {
    fn of(x: i32, y: i32) -> Self {
        Self::new(px(x), px(y))
    }
}

/// The input of a query, from the words of the host.
pub trait Input {
    fn of(words: &[i32]) -> Self;
}

/// Four of the words.
fn four(words: &[i32], from: usize) -> Raw {
    core::array::from_fn(|i| words[from + i])
}

impl<A: Shape, B: Shape> Input for (A, B) {
    fn of(words: &[i32]) -> Self {
        (A::of(&four(words, 0)), B::of(&four(words, 4)))
    }
}
