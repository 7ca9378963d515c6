//! How two bodies share a push.

use crate::num::Ratio;

/// The masses of two bodies in their lowest terms, or which one of them cannot be moved.
///
/// ```
/// use tilesat::{Ratio, motion::response::Masses};
/// let ball_and_crate = Masses::new(2, 6).unwrap();
/// assert_eq!(ball_and_crate.share_of_a(), Ratio::percent(75).unwrap()); // the lighter one takes more of a push
/// assert_eq!(Masses::B_FIXED.share_of_a(), Ratio::ONE);
/// assert_eq!(ball_and_crate.swapped(), Masses::new(3, 1).unwrap());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Masses {
    /// What A's velocity changes by in one step of the exchange: the mass of B in lowest terms.
    a: u8,
    /// And B's: the mass of A.
    b: u8,
}

impl Masses {
    /// Two bodies of one mass.
    pub const EQUAL: Self = Self { a: 1, b: 1 };
    /// A is not moved, whatever hits it: a wall, a platform, a body asleep.
    pub const A_FIXED: Self = Self { a: 0, b: 1 };
    /// B is not moved.
    pub const B_FIXED: Self = Self { a: 1, b: 0 };

    /// The masses of A and B in any common unit; `None` where one is zero.
    ///
    /// Small whole numbers are meant: the velocities of the two change in multiples of them, so that momentum is exact.
    #[must_use]
    pub const fn new(a: u8, b: u8) -> Option<Self> {
        if a == 0 || b == 0 {
            return None;
        }
        // Euclid's algorithm by subtraction: at most 254 rounds, none in a constant.
        let (mut m, mut n) = (a, b);
        while m != n {
            if m > n {
                m -= n;
            } else {
                n -= m;
            }
        }
        Some(Self { a: quotient(b, m), b: quotient(a, m) })
    }

    /// The same with A and B exchanged.
    #[must_use]
    pub const fn swapped(self) -> Self {
        Self { a: self.b, b: self.a }
    }

    /// The part of a push that A takes: the mass of B in both.
    #[must_use]
    pub const fn share_of_a(self) -> Ratio {
        match Ratio::new(self.a as u32, self.a as u32 + self.b as u32) {
            Some(share) => share,
            None => Ratio::HALF,
        }
    }

    /// By how much A and B change in one step.
    pub(super) const fn steps(self) -> (i32, i32) {
        (self.a as i32, self.b as i32)
    }
}

/// A multiple divided by its divisor.
const fn quotient(of: u8, by: u8) -> u8 {
    crate::num::mul_div(of as u32, 1, by as u32) as u8
}
