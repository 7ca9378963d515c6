//! Distances that Verlet points keep.

use crate::error::RangeError;
use crate::num::{Fx, Ratio, Raw, Vec2, check_length, usqr};
use crate::query::round::toward;

/// A distance between two points: a stick keeps it, a rope does not exceed it.
///
/// ```text
///    a o---->     <----o b     too long: both are drawn together, each by its share
///        a o<-> <->o b         too short: a stick drives them apart, a rope lets them
/// ```
///
/// ```
/// use tilesat::{Fx, Vec2, motion::response::Stick};
/// let stick = Stick::new(Fx::from_num(10))?;
/// let (a, b) = (Vec2::from_ints(0, 0), Vec2::from_ints(16, 0));
/// assert_eq!(stick.pull(a, b), (Vec2::from_ints(3, 0), Vec2::from_ints(-3, 0)));
/// assert_eq!(Stick::rope(Fx::from_num(20))?.pull(a, b), (Vec2::ZERO, Vec2::ZERO));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Stick {
    length: Fx,
    share_of_a: Ratio,
    slack: bool,
}

/// What the roundings of one correction leave at most: a component of each share is short by less than a raw unit, together by one, which
/// is sqrt(2), and sqrt(1/2) comes from the direction.
const NEAR: u32 = 3;

impl Stick {
    /// A stick between points of one mass.
    ///
    /// # Errors
    /// [`RangeError`] where the length is negative or outside of the [domain](crate::num::DOMAIN).
    pub const fn new(length: Fx) -> Result<Self, RangeError> {
        match check_length(length) {
            Ok(()) => Ok(Self { length, share_of_a: Ratio::HALF, slack: false }),
            Err(e) => Err(e),
        }
    }

    /// A rope: it pulls and does not push.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn rope(length: Fx) -> Result<Self, RangeError> {
        match Self::new(length) {
            Ok(stick) => Ok(Self { slack: true, ..stick }),
            bad => bad,
        }
    }

    /// The same with another share of A in the corrections: [`Masses::share_of_a`](super::Masses::share_of_a), zero where A is nailed down.
    #[must_use]
    pub const fn with_share_of_a(self, share_of_a: Ratio) -> Self {
        Self { share_of_a, ..self }
    }

    /// The length.
    #[must_use]
    pub const fn length(&self) -> Fx {
        self.length
    }

    /// By how much to move the ends; nothing where their distance is less than 3 raw units off, exactly.
    ///
    /// From the exact difference of the ends, along which each component is rounded to nearest, each end gets its share rounded toward zero: so
    /// nothing is ever corrected too far, and one correction leaves the distance less than 3 raw units off, where it stays as it is. It does
    /// not matter which end is A, and mirrored input gives mirrored bits; only where both ends are one point do they part along x, A to the left.
    /// The ends must be inside the [domain](crate::num::DOMAIN).
    ///
    /// Cost: two quotients by a root where it corrects, some 1380 instructions on a Cortex-M0; 100 where it does not.
    #[must_use]
    pub const fn pull(&self, a: Vec2, b: Vec2) -> (Vec2, Vec2) {
        let (e, length) = (Raw::of(b).sub(Raw::of(a)), self.length.to_bits());
        let square = e.len2();
        let too_long = square >= usqr(length as u32 + NEAR);
        let too_short = !self.slack && length as u32 >= NEAR && square <= usqr(length as u32 - NEAR);
        if !too_long && !too_short {
            return (Vec2::ZERO, Vec2::ZERO);
        }
        let along = if e.is_zero() { Raw { x: 1, y: 0 } } else { e };
        let excess = e.sub(toward(along, length));
        let (of_a, of_b) = (self.share_of_a, self.share_of_a.complement());
        let by_a = Raw { x: of_a.of_raw(excess.x), y: of_a.of_raw(excess.y) };
        let by_b = Raw { x: of_b.of_raw(excess.x).wrapping_neg(), y: of_b.of_raw(excess.y).wrapping_neg() };
        (by_a.vec2(), by_b.vec2())
    }
}
