//! The speed that a bouncing body should have.

use super::Surface;
use crate::error::RangeError;
use crate::num::{Axis, DOMAIN, Vec2};

/// The square of the speed that a body should have, exact: what keeps a thousand bounces as fast as the first.
///
/// A lattice holds no vector of exactly the right length in a new direction, so each askew bounce is a little slow: by up to a raw unit. A
/// velocity that is mirrored again and again loses all of that; one whose length is renewed from this reference is never slower than by the
/// last bounce's rounding. It is plain data: keep one beside the velocity.
///
/// - Free flight and bounces at restitution one leave the reference as it is.
/// - What the game does to the velocity (a jump, a brake, a frame's gravity) changes the reference by as much: [`changed`](Self::changed).
/// - After a bounce that is meant to lose, or friction, it is the new velocity's: [`of`](Self::of).
/// - Under gravity, [`Energy::speed`](super::Energy::speed) says what it is at each place.
///
/// ```
/// use tilesat::{Axis, Speed, Vec2};
/// let mut v = Vec2::from_raw(70_001, 12_345);
/// let speed = Speed::of(v);
/// for k in 1..1000 {
///     let wall = Axis::new(-k, 3 * k + 1);
///     let wall = if wall.dot_vec(v) < 0 { wall } else { -wall };
///     v = speed.bounce(v, wall)?;
///     assert!(v.length_squared() <= speed.squared());
/// }
/// assert!(v.length() >= tilesat::Fx::from_bits(71_079)); // from 71 081.2
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Speed(u64);

impl Speed {
    /// The speed of a velocity.
    #[must_use]
    pub const fn of(v: Vec2) -> Self {
        Self(v.length_squared())
    }

    /// The square, in square raw units.
    #[must_use]
    pub const fn squared(self) -> u64 {
        self.0
    }

    pub(super) const fn from_square(square: u64) -> Self {
        Self(square)
    }

    /// What it is after the game has changed the velocity: more or less by as much as the square of that, and not below zero.
    ///
    /// What the last bounce lost to rounding is still to be had at the next one.
    #[must_use]
    pub const fn changed(self, from: Vec2, to: Vec2) -> Self {
        Self(self.0.saturating_add(to.length_squared()).saturating_sub(from.length_squared()))
    }

    /// `v` mirrored at a surface, as fast as this reference; `v` itself where it does not move in or the normal is zero.
    ///
    /// Exact at normals along x or y, where the reference is within 2 raw of the speed of `v`. Elsewhere the mirror image is rounded to nearest, drawn
    /// to the length of the reference (rounded to nearest), and where that is too long or into the surface the nearest vector is taken that is
    /// neither: each component within 2 raw of the exact one, slower than the reference by less than 2 raw, and never faster.
    /// Mirrored input gives mirrored bits. Cost: two long divisions and three roots, some 4460 instructions on a Cortex-M0; a few along x and y.
    ///
    /// # Errors
    /// [`RangeError`] where a component of `v` is outside of the [domain](crate::num::DOMAIN).
    pub fn bounce(self, v: Vec2, normal: Axis) -> Result<Vec2, RangeError> {
        Surface::ELASTIC.with_speed(self).respond(v, normal)
    }

    /// The bound of a bounce: nothing is drawn out of the domain.
    pub(super) fn bound(self) -> u64 {
        self.0.min(FASTEST)
    }
}

/// The square of the fastest velocity that a bounce may draw one to.
const FASTEST: u64 = (DOMAIN as u64 - 1) * (DOMAIN as u64 - 1);
