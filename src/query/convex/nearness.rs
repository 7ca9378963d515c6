//! Which of two sides is nearer, mostly by a few leading bits.

use super::walk::PolygonSide;
#[cfg(not(all(target_pointer_width = "64", not(tilesat_split))))]
use crate::num::leading_zeros64;
use crate::num::sqr64;
use crate::query::closest::Square;
use core::cmp::Ordering;

/// The square distance of the origin from a side's line, rounded.
///
/// Half of the instructions of leading bits in words.
#[cfg(all(target_pointer_width = "64", not(tilesat_split)))]
pub(super) struct Nearness(f64);

#[cfg(all(target_pointer_width = "64", not(tilesat_split)))]
#[expect(clippy::cast_precision_loss, clippy::float_arithmetic, reason = "what is near is compared exactly")]
impl Nearness {
    /// From the height times the side's length, not negative, and the square of that. A signed
    /// conversion is one instruction; both are below 2^63.
    pub(super) fn of(height: i64, len2: u64) -> Self {
        let (height, len2) = (height as f64, len2 as i64 as f64);
        Self(height * height / len2)
    }

    /// `None` if they are too near: five roundings of 2^-53 make up less than 2^-50.
    fn cmp(&self, rhs: &Self) -> Option<Ordering> {
        const SHORT: f64 = 1.0 - 1.0 / (1u64 << 48) as f64;
        if self.0 * SHORT > rhs.0 {
            Some(Ordering::Greater)
        } else if rhs.0 * SHORT > self.0 {
            Some(Ordering::Less)
        } else {
            None
        }
    }
}

/// The square distance of the origin from a side's line, as a fraction of 16 leading bits each.
///
/// On a Cortex-M0 it takes a tenth of the exact quotient.
#[cfg(not(all(target_pointer_width = "64", not(tilesat_split))))]
pub(super) struct Nearness {
    square: u32,
    len2: u32,
    exponent: i32,
}

#[cfg(not(all(target_pointer_width = "64", not(tilesat_split))))]
impl Nearness {
    pub(super) const fn of(height: i64, len2: u64) -> Self {
        let height = height.unsigned_abs();
        let (h, l) = (leading_zeros64(height | 1), leading_zeros64(len2 | 1));
        // Above 2^15, and less than 1 below the value that it stands for.
        let top = (height << (h & 63) >> 48) as u32;
        // A line through the origin is nearer than all others: exponents are above -126.
        let exponent = if height == 0 { -256 } else { (l as i32).wrapping_sub(h.wrapping_shl(1) as i32) };
        Self { square: top.wrapping_mul(top) >> 16, len2: (len2 << (l & 63) >> 48) as u32, exponent }
    }

    /// `None` if the leading bits are too few.
    ///
    /// Squares are at least 2^14 and lengths 2^15, so products are in 2^29..2^32. A product is
    /// short by less than 5/8 of 2^-12 of itself: 2^-14 each for the height and for the square,
    /// 2^-15 for the length.
    const fn cmp(&self, rhs: &Self) -> Option<Ordering> {
        let (p, q) = (self.square.wrapping_mul(rhs.len2), rhs.square.wrapping_mul(self.len2));
        let apart = self.exponent.wrapping_sub(rhs.exponent);
        if apart > 3 {
            return Some(Ordering::Greater);
        } else if apart < -3 {
            return Some(Ordering::Less);
        }
        let (p, q) = if apart > 0 { (p, q >> apart) } else { (p >> apart.wrapping_neg(), q) };
        if p.wrapping_sub(p >> 12) > q {
            Some(Ordering::Greater)
        } else if q.wrapping_sub(q >> 12) > p {
            Some(Ordering::Less)
        } else {
            None
        }
    }
}

/// Two sides are equally near, or nearly so.
pub(super) struct Unsure;

/// The nearest one so far, which is surely nearer than the others.
pub(super) struct Least<T>(Option<(Nearness, T)>);

impl<T> Least<T> {
    pub(super) const fn new() -> Self {
        Self(None)
    }

    /// An error if the leading bits do not distinguish the next one from the nearest.
    #[inline]
    pub(super) fn add(&mut self, near: Nearness, value: impl FnOnce() -> T) -> Result<(), Unsure> {
        match self.0.as_ref().map(|(least, _)| near.cmp(least)) {
            Some(None) => return Err(Unsure),
            Some(Some(Ordering::Greater)) => {}
            _ => self.0 = Some((near, value())),
        }
        Ok(())
    }

    pub(super) fn get(self) -> Result<T, Unsure> {
        self.0.map(|(_, value)| value).ok_or(Unsure)
    }
}

/// The order of the distances of the origin, inside or on the border, from the lines of two sides.
pub(super) fn order((near, side): &(Nearness, PolygonSide), (kept_near, kept): &(Nearness, PolygonSide)) -> Ordering {
    if let Some(order) = near.cmp(kept_near) {
        return order;
    }
    // A height's square is below 2^124: fractions are compared in 187 bits.
    let square = |side: &PolygonSide| Square { num: sqr64(side.height().unsigned_abs()), den: side.len2() };
    let (s, t) = (square(side), square(kept));
    if s.less(t) {
        Ordering::Less
    } else if t.less(s) {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}
