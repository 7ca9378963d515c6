//! Comparison of squared lengths that are fractions: too wide for 128 bits, so cold and out of line.

use crate::num::mul128;

/// The square of a length as an exact fraction: `num / den`, num as `(high, low)`, den not zero.
#[derive(Clone, Copy)]
pub(super) struct Square {
    pub(super) num: (u64, u64),
    pub(super) den: u64,
}

impl Square {
    /// Whether this is less than `rhs`: cross-multiplied, exact in 192 bits.
    #[inline(never)]
    pub(super) const fn less(self, rhs: Self) -> bool {
        let (a, b) = (mul128(self.num, rhs.den), mul128(rhs.num, self.den));
        if a.0 != b.0 {
            return a.0 < b.0;
        }
        if a.1 == b.1 { a.2 < b.2 } else { a.1 < b.1 }
    }
}
