//! Which way a surface faces: floor, wall or ceiling.

use crate::num::{Axis, umul};

/// What a surface is to a body that stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Floor,
    Wall,
    Ceiling,
}

/// The steepest floor, and ceiling: as high as `rise` where it is as wide as `run`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct SlopeLimit {
    pub(super) rise: u16,
    pub(super) run: u16,
}

impl SlopeLimit {
    /// 45 degrees.
    pub(super) const DEFAULT: Self = Self { rise: 1, run: 1 };

    /// What a surface with this normal is: floor where `|n x up| run <= (n . up) rise`, exact.
    ///
    /// Blocks need neither product: one of the two is zero.
    pub(super) fn side(self, up: Axis, normal: Axis) -> Side {
        let (along, across) = (normal.dot(up), normal.perp_dot(up));
        let (a, c) = (along.unsigned_abs(), across.unsigned_abs());
        // At 45 degrees, as at first, no product is needed.
        let is_steep = |a, c| {
            if self.rise == self.run { a < c && self.run != 0 } else { times(a, self.rise) < times(c, self.run) }
        };
        if a == 0 || (c != 0 && is_steep(a, c)) {
            Side::Wall
        } else if along > 0 {
            Side::Floor
        } else {
            Side::Ceiling
        }
    }
}

/// A product of 80 bits, high and low part.
#[inline(never)]
fn times(a: u64, by: u16) -> (u64, u32) {
    let low = umul(a as u32, by.into());
    (umul((a >> 32) as u32, by.into()).wrapping_add(low >> 32), low as u32)
}

impl Default for SlopeLimit {
    fn default() -> Self {
        Self::DEFAULT
    }
}
