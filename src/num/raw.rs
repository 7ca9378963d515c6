//! The pairs of raw integers that kernels compute with.

use super::{LONG, SPLIT, Vec2, imul};

/// Raw coordinates, or a difference of two inside the domain: the kernels' operand.
///
/// Public in a private module, because methods of sealed traits take it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Raw {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Raw {
    pub(crate) const ZERO: Self = Self { x: 0, y: 0 };

    pub(crate) const fn of(v: Vec2) -> Self {
        Self { x: v.x.to_bits(), y: v.y.to_bits() }
    }

    pub(crate) const fn vec2(self) -> Vec2 {
        Vec2::from_raw(self.x, self.y)
    }

    pub(crate) const fn add(self, o: Self) -> Self {
        Self { x: self.x.wrapping_add(o.x), y: self.y.wrapping_add(o.y) }
    }

    /// Both operands inside the domain: the difference is below 2^30.
    pub(crate) const fn sub(self, o: Self) -> Self {
        Self { x: self.x.wrapping_sub(o.x), y: self.y.wrapping_sub(o.y) }
    }

    pub(crate) const fn reversed(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    /// Operands below 2^30: each product is below 2^60, the sum below 2^61.
    pub(crate) const fn dot(self, o: Self) -> i64 {
        super::dot(self.x, o.x, self.y, o.y)
    }

    /// [`dot`](Self::dot) and [`cross`](Self::cross). Where a product is a call, it makes three
    /// calls instead of four (Gauss). Operands and their sums below 2^31.
    #[inline]
    pub(crate) const fn dot_cross(self, o: Self) -> (i64, i64) {
        if !SPLIT {
            return (self.dot(o), self.cross(o));
        }
        let both = imul(o.x, self.x.wrapping_sub(self.y));
        let (dot, cross) = (imul(self.y, o.x.wrapping_add(o.y)), imul(self.x, o.y.wrapping_sub(o.x)));
        (both.wrapping_add(dot), both.wrapping_add(cross))
    }

    pub(crate) const fn cross(self, o: Self) -> i64 {
        if LONG {
            // Where products are as wide as their difference, it saves the negation.
            return imul(self.x, o.y).wrapping_sub(imul(self.y, o.x));
        }
        super::dot(self.x, o.y, self.y.wrapping_neg(), o.x)
    }

    pub(crate) const fn len2(self) -> u64 {
        super::norm(self.x, self.y)
    }

    pub(crate) const fn is_zero(self) -> bool {
        self.x == 0 && self.y == 0
    }
}
