//! Times of impact.

use super::{Fx, Raw, Vec2};

/// A fraction of a motion: 0 at its start, 1 at its end, in steps of 2^-30.
///
/// Rounded down, so that acting on it is never late.
///
/// ```
/// use tilesat::Toi;
/// assert_eq!(Toi::ONE.to_fx(), 1);
/// assert!(Toi::from_raw(1 << 29).unwrap() < Toi::ONE);
/// assert_eq!(Toi::from_raw((1 << 30) + 1), None);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Toi(u32);

impl Toi {
    /// The start of the motion.
    pub const ZERO: Self = Self(0);
    /// The end of the motion.
    pub const ONE: Self = Self(1 << 30);

    /// From parts in 2^30; `None` above one.
    #[must_use]
    pub const fn from_raw(raw: u32) -> Option<Self> {
        if raw <= Self::ONE.0 { Some(Self(raw)) } else { None }
    }

    /// For values that are at most one by construction.
    pub(crate) const fn exact(raw: u32) -> Self {
        Self(raw)
    }

    /// For values that the caller has bounded.
    pub(crate) const fn clamped(raw: u32) -> Self {
        Self(if raw < Self::ONE.0 { raw } else { Self::ONE.0 })
    }

    /// In parts of 2^30.
    #[must_use]
    pub const fn raw(self) -> u32 {
        self.0
    }

    /// As 16.16, rounded down.
    #[must_use]
    pub const fn to_fx(self) -> Fx {
        Fx::from_bits((self.0 >> 14) as i32)
    }

    /// This fraction of a motion, each component rounded toward zero.
    #[must_use]
    pub const fn of(self, motion: Vec2) -> Vec2 {
        let d = Raw::of(motion);
        Raw { x: self.of_raw(d.x), y: self.of_raw(d.y) }.vec2()
    }

    pub(crate) const fn of_raw(self, d: i32) -> i32 {
        if self.0 == Self::ONE.0 {
            return d;
        }
        let part = (super::umul(d.unsigned_abs(), self.0) >> 30) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }

    /// This part of a component `d`, rounded so that `m` plus it is no nearer to zero than the exact sum where `away`, else no farther.
    ///
    /// While the sum is still on the side that `d` comes from, rounding toward zero keeps it away; on zero and beyond it is one more that does.
    pub(crate) const fn of_raw_beside(self, m: i32, d: i32, away: bool) -> i32 {
        let product = super::umul(d.unsigned_abs(), self.0);
        let part = (product >> 30) as i32;
        let part = if d < 0 { part.wrapping_neg() } else { part };
        let at = m.wrapping_add(part);
        let short = product as u32 & (Self::ONE.0 - 1) != 0;
        let outward = at == 0 || (at > 0) == (d > 0);
        if short && outward == away { part.wrapping_add(d.signum()) } else { part }
    }
}

#[cfg(test)]
mod tests {
    use super::Toi;

    #[test]
    fn parts_beside_zero_are_rounded_to_a_side() {
        for raw in [0, 1, 3, 1 << 29, (1 << 29) + 1, (1 << 30) / 3, 3 << 28, (1 << 30) - 1, 1 << 30] {
            for (m, d) in (-9..=9).flat_map(|m| (-9..=9).map(move |d| (m, d))) {
                // In parts of 2^30.
                let (part, at) = (i64::from(d) * i64::from(raw), (i64::from(m) << 30) + i64::from(d) * i64::from(raw));
                for away in [true, false] {
                    let got = i64::from(Toi(raw).of_raw_beside(m, d, away));
                    let size = (i64::from(m) + got).abs() << 30;
                    assert!(if away { size >= at.abs() } else { size <= at.abs() }, "{m} {d} {raw} {away}: {got}");
                    assert!(((got << 30) - part).abs() < 1 << 30, "{m} {d} {raw} {away}: {got}");
                }
            }
        }
    }
}
