//! A moving point that enters a disc: two circles, or a circle and a corner.

use super::moment::{entry_time, last_before};
use crate::num::{Axis, Raw, SPLIT, Toi, add128, imul, less128, mul64, sqr64, umul, usqr};

/// A motion that enters a disc around the origin: what its moment is computed from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    rr: u64,
    /// |d|^2.
    a: u64,
    /// -m.d, positive.
    b: u64,
    pub(crate) cross: i64,
}

impl Crossing {
    /// Of the point `m` that moves by `d` into the disc of radius `r`.
    ///
    /// Decided without root or division: |m + d| < r, or a closest approach inside the motion that is nearer than r (numerics:
    /// cross^2 < r^2 |d|^2, 124 bits).
    #[inline]
    pub(crate) fn of(m: Raw, r: i32, d: Raw) -> Option<Self> {
        let (dot, cross) = m.dot_cross(d);
        let b = dot.wrapping_neg();
        if b <= 0 {
            return None;
        }
        let (rr, a) = (usqr(r as u32), d.len2());
        let passes_inside = (b as u64) < a && passes(cross.unsigned_abs(), r as u32, d);
        if !passes_inside && m.add(d).len2() >= rr {
            return None;
        }
        Some(Self { rr, a, b: b as u64, cross })
    }

    /// Whether the point `m` is inside from the start.
    #[inline]
    pub(crate) fn starts_inside(&self, m: Raw) -> bool {
        m.len2() < self.rr
    }

    /// Of a ray from `m`, which touching stops: from the rim and up to it too. A tangent does not come in.
    pub(crate) fn touching(m: Raw, r: i32, d: Raw) -> Option<Self> {
        let b = m.dot(d).wrapping_neg();
        if b <= 0 {
            return None;
        }
        let (rr, a, cross) = (usqr(r as u32), d.len2(), m.cross(d));
        let reaches = b as u64 <= a || m.add(d).len2() <= rr;
        (reaches && less128(sqr64(cross.unsigned_abs()), mul64(rr, a))).then_some(Self { rr, a, b: b as u64, cross })
    }

    /// A lower bound of the moment of entry, the displacement up to it, rounded away from the centre, and the normal there.
    #[inline]
    pub(crate) fn contact(&self, m: Raw, d: Raw) -> (Toi, Raw, Axis) {
        let t = self.toi(m);
        let step = Raw { x: t.of_raw_beside(m.x, d.x, true), y: t.of_raw_beside(m.y, d.y, true) };
        (t, step, direction(m.add(step)))
    }

    /// The bound alone.
    #[inline]
    pub(crate) fn toi(&self, m: Raw) -> Toi {
        entry_time(m.len2().saturating_sub(self.rr), self.b, mul64(self.rr, self.a), self.cross)
    }

    /// The exact floor of the moment.
    ///
    /// At a moment T, in parts of 2^30, the point is at `2^30 m + T d`, components below 2^61. It has entered where that is nearer than
    /// 2^30 r (squares below 2^123), or where the closest approach is over: T |d|^2 > 2^30 b.
    pub(crate) fn exact_toi(&self, m: Raw, d: Raw) -> Toi {
        last_before(self.toi(m), |t| {
            let at = |m: i32, d: i32| (i64::from(m) << 30).wrapping_add(imul(d, t as i32)).unsigned_abs();
            let square = add128(sqr64(at(m.x, d.x)), sqr64(at(m.y, d.y)));
            less128(square, (self.rr >> 4, self.rr << 60))
                || less128((self.b >> 34, self.b << 30), mul64(self.a, u64::from(t)))
        })
    }
}

/// Whether the point `m` that moves by `d`, outside of the disc of radius `r` before, enters it: [`Crossing::of`] and nothing else.
#[inline]
pub(crate) fn enters(m: Raw, r: i32, d: Raw) -> bool {
    let (dot, cross) = m.dot_cross(d);
    let b = dot.wrapping_neg();
    if b <= 0 {
        return false;
    }
    // Of signed words, where a product is as cheap as their magnitudes.
    let square = |v: Raw| if SPLIT { v.len2() } else { v.dot(v) as u64 };
    let ends_inside = || square(m.add(d)) < usqr(r as u32);
    let passes_inside = || (b as u64) < square(d) && passes(cross.unsigned_abs(), r as u32, d);
    // The cheaper one first, by what a square costs there.
    let first = if SPLIT { passes_inside() } else { ends_inside() };
    first || if SPLIT { ends_inside() } else { passes_inside() }
}

/// Whether `cross < r |d|`, exactly: as squares of 124 bits, where bounds of the length do not settle it by one product of words each.
#[inline]
fn passes(cross: u64, r: u32, d: Raw) -> bool {
    let (below, above) = octagons(d);
    cross < umul(r, below) || (cross < umul(r, above) && passes_closely(cross, r, d))
}

#[inline(never)]
fn passes_closely(cross: u64, r: u32, d: Raw) -> bool {
    less128(sqr64(cross), mul64(usqr(r), d.len2()))
}

/// Bounds of the length of a vector, below 2^30 a component: from x the larger component and y the smaller one, by shifts.
///
/// At least `x + 3 y / 8` less 1/16 and 1/256 of that, since `sqrt(1 + (3/8)^2) < 256 / 239`; at most `x + 7 y / 16`, since that is more than sqrt(2) - 1.
/// The fractions that the shifts drop are made up for.
const fn octagons(d: Raw) -> (u32, u32) {
    let (dx, dy) = (d.x.unsigned_abs(), d.y.unsigned_abs());
    let (x, y) = if dx > dy { (dx, dy) } else { (dy, dx) };
    let below = x.wrapping_add(y >> 2).wrapping_add(y >> 3);
    let below = below.wrapping_sub(below >> 4).wrapping_sub(below >> 8).saturating_sub(2);
    (below, x.wrapping_add(y >> 1).wrapping_sub(y >> 4).wrapping_add(1))
}

/// The direction of a point from the origin: along x or y it has one length, whatever the radius.
pub(crate) fn direction(m: Raw) -> Axis {
    if m.x == 0 || m.y == 0 { Axis::new(m.x.signum(), m.y.signum()) } else { Axis::new(m.x, m.y) }
}

#[cfg(test)]
mod tests {
    use super::{Crossing, octagons};
    use crate::num::Raw;

    #[test]
    fn the_rim_is_not_inside() {
        let crossing = Crossing::of(Raw { x: -5, y: 0 }, 3, Raw { x: 9, y: 0 });
        for (x, inside) in [(0, true), (-2, true), (2, true), (-3, false), (3, false), (-4, false), (1 << 29, false)] {
            assert_eq!(crossing.map(|c| c.starts_inside(Raw { x, y: 0 })), Some(inside), "{x}");
        }
    }

    fn check(x: i32, y: i32) {
        let square = u64::from(x.unsigned_abs()).pow(2) + u64::from(y.unsigned_abs()).pow(2);
        let (below, above) = octagons(Raw { x, y });
        assert!(u64::from(below).pow(2) <= square && square <= u64::from(above).pow(2), "{x} {y}: {below} {above}");
    }

    #[test]
    fn octagons_are_on_both_sides() {
        for x in -700..700 {
            for y in -700..700 {
                check(x, y);
            }
        }
        // All directions, by the slope of long vectors: finer than any of the shifts.
        for k in 0..1 << 16 {
            check((1 << 29) - 1, k << 13);
            check(-k << 13, (1 << 29) - 1);
        }
    }
}
