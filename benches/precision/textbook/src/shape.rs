//! Shapes as plain numbers.

use crate::Scalar;
use core::ops::{Add, Mul, Sub};

#[derive(Clone, Copy, Debug)]
pub struct Vector<S> {
    pub x: S,
    pub y: S,
}

impl<S: Scalar> Add for Vector<S> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self { x: self.x + o.x, y: self.y + o.y }
    }
}

impl<S: Scalar> Sub for Vector<S> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self { x: self.x - o.x, y: self.y - o.y }
    }
}

impl<S: Scalar> Mul<S> for Vector<S> {
    type Output = Self;
    #[inline]
    fn mul(self, k: S) -> Self {
        Self { x: self.x * k, y: self.y * k }
    }
}

impl<S: Scalar> Vector<S> {
    #[inline]
    pub fn of_raw(x: i32, y: i32) -> Self {
        Self { x: S::of_raw(x), y: S::of_raw(y) }
    }

    #[inline]
    pub fn dot(self, o: Self) -> S {
        self.x * o.x + self.y * o.y
    }

    #[inline]
    pub fn cross(self, o: Self) -> S {
        self.x * o.y - self.y * o.x
    }

    #[inline]
    pub fn clamped(self, lo: Self, hi: Self) -> Self {
        Self { x: self.x.most(lo.x).least(hi.x), y: self.y.most(lo.y).least(hi.y) }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Circle<S> {
    pub c: Vector<S>,
    pub r: S,
}

#[derive(Clone, Copy, Debug)]
pub struct Aabb<S> {
    pub lo: Vector<S>,
    pub hi: Vector<S>,
}

#[derive(Clone, Copy, Debug)]
pub struct Segment<S> {
    pub a: Vector<S>,
    pub b: Vector<S>,
}

/// How deep, and the unit vector from A to B.
#[derive(Clone, Copy, Debug)]
pub struct Contact<S> {
    pub depth: S,
    pub normal: Vector<S>,
}
