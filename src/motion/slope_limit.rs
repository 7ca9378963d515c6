//! Which surfaces are floor: the role of a surface by its normal.

use crate::num::{Axis, umul};

/// The role of a surface for a body that stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SurfaceRole {
    Floor,
    Wall,
    Ceiling,
}

/// The steepest floor, and ceiling: it rises by `rise` over `run`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct SlopeLimit {
    pub(super) rise: u16,
    pub(super) run: u16,
}

impl SlopeLimit {
    /// 45 degrees.
    pub(super) const DEFAULT: Self = Self { rise: 1, run: 1 };

    /// The role of a surface with this normal: floor if `|n x up| run <= (n . up) rise`, exact.
    ///
    /// Blocks need neither product: one of the two is zero.
    pub(super) fn side(self, up: Axis, normal: Axis) -> SurfaceRole {
        // Mostly up is along an axis. Its length is then a factor of both products, and plays no
        // part.
        let (along, across) = if up.x == 0 {
            (if up.y < 0 { normal.y.wrapping_neg() } else { normal.y }, normal.x)
        } else if up.y == 0 {
            (if up.x < 0 { normal.x.wrapping_neg() } else { normal.x }, normal.y)
        } else {
            return self.of_parts(normal.dot(up), normal.perp().dot(up));
        };
        if along == 0 {
            SurfaceRole::Wall
        } else if across != 0 {
            self.of_parts(along.into(), across.into())
        } else if along > 0 {
            SurfaceRole::Floor
        } else {
            SurfaceRole::Ceiling
        }
    }

    /// [`side`](Self::side) by the parts of the normal along "up" and across it, both in the same
    /// scale.
    fn of_parts(self, along: i64, across: i64) -> SurfaceRole {
        let (a, c) = (along.unsigned_abs(), across.unsigned_abs());
        // 45 degrees, the default, need no product.
        let is_steep = |a, c| {
            if self.rise == self.run { a < c && self.run != 0 } else { times(a, self.rise) < times(c, self.run) }
        };
        if a == 0 || (c != 0 && is_steep(a, c)) {
            SurfaceRole::Wall
        } else if along > 0 {
            SurfaceRole::Floor
        } else {
            SurfaceRole::Ceiling
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
