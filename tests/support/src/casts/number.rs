//! Integers wide enough for a case: 128 bits on a lattice of small numbers, 256 anywhere.

use crate::oracle::int256::Int256;
use std::ops::{Add, Mul, Sub};

pub trait Number: Clone + Ord + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn of(n: i64) -> Self;

    fn zero() -> Self {
        Self::of(0)
    }

    fn square(&self) -> Self {
        self.clone() * self.clone()
    }
}

impl Number for i128 {
    fn of(n: i64) -> Self {
        n.into()
    }
}

impl Number for Int256 {
    fn of(n: i64) -> Self {
        Self::new(n)
    }
}

/// A vector of such.
#[derive(Clone, Debug)]
pub struct V<N>(pub N, pub N);

impl<N: Number> V<N> {
    pub fn of((x, y): (i64, i64)) -> Self {
        Self(N::of(x), N::of(y))
    }

    pub fn times(&self, k: &N) -> Self {
        Self(self.0.clone() * k.clone(), self.1.clone() * k.clone())
    }

    pub fn minus(&self, o: &Self) -> Self {
        Self(self.0.clone() - o.0.clone(), self.1.clone() - o.1.clone())
    }

    pub fn dot(&self, o: &Self) -> N {
        self.0.clone() * o.0.clone() + self.1.clone() * o.1.clone()
    }

    pub fn cross(&self, o: &Self) -> N {
        self.0.clone() * o.1.clone() - self.1.clone() * o.0.clone()
    }
}
