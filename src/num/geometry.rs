//! Vectors as points and directions: distance, unit vector, quarter turn, interpolation, and
//! operations on each component.

use super::{Axis, Fx, Ratio, UnitVec2, Vec2, isqrt64, umul, usqr};

impl Vec2 {
    /// The distance of two points, rounded down to a raw unit; saturates above 32767 units.
    ///
    /// Exact for any points, also where their difference does not fit 16.16. Cost: as
    /// [`length`](Self::length).
    ///
    /// ```
    /// use tilesat::{Fx, Vec2};
    /// assert_eq!(Vec2::from_ints(1, 1).distance(Vec2::from_ints(4, -3)), 5);
    /// assert_eq!(Vec2::from_ints(-30_000, 0).distance(Vec2::from_ints(30_000, 0)), Fx::MAX);
    /// ```
    #[must_use]
    pub const fn distance(self, rhs: Self) -> Fx {
        let ((ax, ay), (bx, by)) = (self.raw(), rhs.raw());
        let (x, y) = (ax.abs_diff(bx), ay.abs_diff(by));
        // Below 2^31 both, the squares add up to less than 2^63.
        if (x | y) >> 31 != 0 {
            return Fx::MAX;
        }
        let root = isqrt64(usqr(x).wrapping_add(usqr(y)));
        Fx::from_bits(if root > i32::MAX as u32 { i32::MAX } else { root as i32 })
    }

    /// The direction of this vector, with length one: [`Axis::of`] this, and its
    /// [`unit`](Axis::unit).
    ///
    /// Each component is within 1.5 * 2^-30 of the exact value. The zero vector gives +x. Mirrored
    /// vectors give mirrored bits. Cost: about 250 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Vec2, fx};
    /// let aim = Vec2::from_ints(10, -50) - Vec2::from_ints(10, 20);
    /// assert_eq!(aim.unit().scaled(fx!(2.5)), Vec2::new(fx!(0), fx!(-2.5)));
    /// ```
    #[must_use]
    #[doc(alias("normalize", "normalized", "normalize_or"))]
    pub const fn unit(self) -> UnitVec2 {
        Axis::of(self).unit()
    }

    /// The smaller of each component.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2};
    /// let (press, release) = (Vec2::from_ints(40, 10), Vec2::from_ints(12, 30)); // a box that the mouse drew
    /// assert!(Aabb::new(press, release).is_err());
    /// assert_eq!(Aabb::new(press.min(release), press.max(release))?.size(), Vec2::from_ints(28, 20));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn min(self, rhs: Self) -> Self {
        let ((ax, ay), (bx, by)) = (self.raw(), rhs.raw());
        Self::from_raw(if ax < bx { ax } else { bx }, if ay < by { ay } else { by })
    }

    /// The larger of each component.
    #[must_use]
    pub const fn max(self, rhs: Self) -> Self {
        let ((ax, ay), (bx, by)) = (self.raw(), rhs.raw());
        Self::from_raw(if ax > bx { ax } else { bx }, if ay > by { ay } else { by })
    }

    /// Each component brought into the range from `lo` to `hi`: the nearest point of that box.
    ///
    /// If `lo` is above `hi`, the component is that of `hi`: nothing panics.
    ///
    /// ```
    /// use tilesat::Vec2;
    /// let (lo, hi) = (Vec2::ZERO, Vec2::from_ints(320, 180));
    /// assert_eq!(Vec2::from_ints(400, -20).clamp(lo, hi), Vec2::from_ints(320, 0)); // a camera
    /// ```
    #[must_use]
    pub const fn clamp(self, lo: Self, hi: Self) -> Self {
        self.max(lo).min(hi)
    }

    /// The magnitude of each component; that of `Fx::MIN` saturates to `Fx::MAX`.
    ///
    /// ```
    /// use tilesat::Vec2;
    /// let apart = (Vec2::from_ints(3, 9) - Vec2::from_ints(10, 5)).abs();
    /// assert_eq!(apart, Vec2::from_ints(7, 4)); // along x and along y
    /// ```
    #[must_use]
    pub const fn abs(self) -> Self {
        Self { x: self.x.saturating_abs(), y: self.y.saturating_abs() }
    }

    /// The sign of each component, -1, 0 or 1 units: unlike glam's, zero has no sign.
    ///
    /// ```
    /// use tilesat::Vec2;
    /// assert_eq!(Vec2::from_raw(-3, 0).signum(), Vec2::NEG_X);
    /// ```
    #[must_use]
    pub const fn signum(self) -> Self {
        let (x, y) = self.raw();
        Self::from_ints(x.signum() as i16, y.signum() as i16)
    }

    /// This vector turned by a right angle, `(-y, x)`: from +x to +y; `Fx::MIN` saturates.
    ///
    /// ```
    /// use tilesat::Vec2;
    /// assert_eq!(Vec2::X.perp(), Vec2::Y);
    /// ```
    #[must_use]
    pub const fn perp(self) -> Self {
        Self { x: self.y.saturating_neg(), y: self.x }
    }

    /// The motion that two motions have in common: on each axis the shorter one, and none in
    /// opposite directions.
    pub(crate) fn common(self, rhs: Self) -> Self {
        let of = |a: i32, b: i32| if a > 0 { a.min(b).max(0) } else { a.max(b).min(0) };
        let ((ax, ay), (bx, by)) = (self.raw(), rhs.raw());
        Self::from_raw(of(ax, bx), of(ay, by))
    }

    /// The point at a part of the straight line to `to`, each component rounded toward `self`.
    ///
    /// The exact point, or less than a raw unit before it on each axis. For any two points
    /// [`Ratio::ZERO`] gives `self` and [`Ratio::ONE`] gives `to`, and nothing overflows. Mirrored
    /// points give mirrored bits, and moved points moved ones. In the other direction the point may
    /// differ by a raw unit, because it is rounded toward the other end. Cost: two products.
    ///
    /// ```
    /// use tilesat::{Ratio, Vec2};
    /// let (a, b) = (Vec2::from_raw(10, 0), Vec2::from_raw(15, -3));
    /// assert_eq!(a.lerp(b, Ratio::HALF), Vec2::from_raw(12, -1));
    /// assert_eq!(b.lerp(a, Ratio::HALF), Vec2::from_raw(13, -2));
    /// ```
    #[must_use]
    #[doc(alias("mix", "interpolate", "midpoint"))]
    pub const fn lerp(self, to: Self, part: Ratio) -> Self {
        Self { x: between(self.x, to.x, part), y: between(self.y, to.y, part) }
    }
}

/// The difference of any two words fits an unsigned word, so the product is at most 2^62. A part of
/// the difference leads no farther than to `to`.
const fn between(from: Fx, to: Fx, part: Ratio) -> Fx {
    let (from, to) = (from.to_bits(), to.to_bits());
    let by = (umul(from.abs_diff(to), part.raw()) >> 30) as u32;
    Fx::from_bits(if from < to { from.wrapping_add_unsigned(by) } else { from.wrapping_sub_unsigned(by) })
}
