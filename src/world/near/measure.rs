//! Exact distances to features, for comparison: roots of fractions, and what is between a point and a circle.

use crate::num::{less128, mul64, sub128, usqr};
use crate::world::World;
use core::cmp::Ordering;

/// A distance, not negative.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) enum Measure {
    /// `sqrt(num / den)`: `num` as `(high, low)`, below 2^122; `den` below 2^61, not 0.
    Root { num: (u64, u64), den: u64 },
    /// `|sqrt(square) - radius|`, `square` below 2^61.
    Ring { square: u64, radius: u32 },
}

impl Measure {
    /// The distance between points, by its square.
    pub(in crate::world) const fn root(square: u64) -> Self {
        Self::Root { num: (0, square), den: 1 }
    }

    /// Exact. Up to 24 products of double words where arcs are compared with slopes: a cold path, of which a level links what it has features for.
    #[inline(never)]
    pub(in crate::world) fn order<W: World>(&self, other: &Self) -> Ordering {
        match (self, other) {
            // Distances to lattice points, and to faces along x and y.
            (Self::Root { num: n, den: d }, Self::Root { num: m, den: e }) if W::BLOCKS || d == e => n.cmp(m),
            (Self::Root { num: n, den: d }, Self::Root { num: m, den: e }) => roots(*n, *d, *m, *e),
            _ if !W::ROUND => Ordering::Equal,
            (Self::Ring { square, radius }, Self::Root { num, den }) => ring_and_root(*square, *radius, *num, *den),
            (Self::Root { num, den }, Self::Ring { square, radius }) => {
                ring_and_root(*square, *radius, *num, *den).reverse()
            }
            (Self::Ring { square: a, radius: r }, Self::Ring { square: b, radius: s }) => rings(*a, *r, *b, *s),
        }
    }
}

/// 256 bits, high words first, so that it compares as a number.
type Wide = (u64, u64, u64, u64);

const fn wide(n: (u64, u64)) -> Wide {
    (0, 0, n.0, n.1)
}

/// For products below 2^256.
const fn times(n: Wide, k: u64) -> Wide {
    let (a, b, c, d) = (mul64(n.0, k), mul64(n.1, k), mul64(n.2, k), mul64(n.3, k));
    plus(plus((0, 0, d.0, d.1), (0, c.0, c.1, 0)), plus((b.0, b.1, 0, 0), (a.1, 0, 0, 0)))
}

const fn plus(a: Wide, b: Wide) -> Wide {
    let (w, carry) = a.3.overflowing_add(b.3);
    let (z, carry_z) = add(a.2, b.2, carry);
    let (y, carry_y) = add(a.1, b.1, carry_z);
    (a.0.wrapping_add(b.0).wrapping_add(carry_y as u64), y, z, w)
}

const fn add(a: u64, b: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = a.overflowing_add(b);
    let (sum, second) = sum.overflowing_add(carry as u64);
    (sum, first | second)
}

/// `n / d` against `m / e`: 183 bits.
#[inline(never)]
fn roots(n: (u64, u64), d: u64, m: (u64, u64), e: u64) -> Ordering {
    times(wide(n), e).cmp(&times(wide(m), d))
}

/// `|sqrt(a) - r|` against `t = sqrt(n / d)`.
///
/// Outside, `sqrt(a) < r + t` is `a - r^2 - t^2 < 2 r t`; inside, `r < sqrt(a) + t` is `r^2 - a - t^2 < 2 sqrt(a) t`. Both are, with `w = |a - r^2|` and
/// `k` the lesser of the squares, `w d - n < 2 sqrt(k n d)`: true where the left side is negative, else by its square, 244 bits.
#[inline(never)]
fn ring_and_root(a: u64, r: u32, n: (u64, u64), d: u64) -> Ordering {
    let rr = usqr(r);
    let (w, k) = if a < rr { (rr.wrapping_sub(a), a) } else { (a.wrapping_sub(rr), rr) };
    let wd = mul64(w, d);
    if less128(wd, n) {
        return Ordering::Less;
    }
    let x = sub128(wd, n);
    let (by_high, by_low) = (times(wide(x), x.0), times(wide(x), x.1));
    let square = plus((by_high.1, by_high.2, by_high.3, 0), by_low);
    square.cmp(&times(times(wide(n), d), k << 2))
}

/// `|sqrt(a) - r|` against `|sqrt(b) - s|`.
#[inline(never)]
fn rings(a: u64, r: u32, b: u64, s: u32) -> Ordering {
    match (a < usqr(r), b < usqr(s)) {
        (false, false) => roots_apart(a, b, i64::from(r) - i64::from(s)),
        (true, true) => roots_apart(b, a, i64::from(s) - i64::from(r)),
        (false, true) => roots_together(a, b, r.wrapping_add(s)),
        (true, false) => roots_together(a, b, r.wrapping_add(s)).reverse(),
    }
}

/// `sqrt(a) - sqrt(b)` against `delta`, which is a difference of radii.
fn roots_apart(a: u64, b: u64, delta: i64) -> Ordering {
    if delta < 0 {
        return roots_apart(b, a, -delta).reverse();
    }
    // sqrt(a) against sqrt(b) + delta: a - b - delta^2 against 2 delta sqrt(b).
    let square = usqr(delta as u32);
    if a < b.wrapping_add(square) {
        return Ordering::Less;
    }
    let x = a.wrapping_sub(b).wrapping_sub(square);
    mul64(x, x).cmp(&mul64(square << 2, b))
}

/// `sqrt(a) + sqrt(b)` against a sum of radii, below 2^31.
fn roots_together(a: u64, b: u64, sum: u32) -> Ordering {
    // 2 sqrt(a b) against sum^2 - a - b.
    let (square, both) = (usqr(sum), a.wrapping_add(b));
    if square < both {
        return Ordering::Greater;
    }
    let x = square.wrapping_sub(both);
    mul64(a << 2, b).cmp(&mul64(x, x))
}

#[cfg(test)]
mod tests {
    use super::{Measure, Ordering, usqr};
    use crate::world::{AllShapes, TileMap};

    fn order(a: Measure, b: Measure) -> Ordering {
        a.order::<TileMap<'_, AllShapes>>(&b)
    }

    /// All small measures, compared by their values where those are apart, and as equal where they are so by construction.
    #[test]
    #[allow(
        clippy::cast_precision_loss,
        clippy::float_arithmetic,
        clippy::indexing_slicing,
        reason = "a test; values that differ do so by more than 1e-9"
    )]
    fn orders_as_the_values_do() {
        let at = |i: u64| {
            let (n, kind) = (i / 15, i % 15);
            match kind {
                0..11 => Measure::Ring { square: n, radius: 1 + kind as u32 },
                _ => Measure::Root { num: (0, n), den: [1, 2, 5, 13][kind as usize - 11] },
            }
        };
        let value = |m: &Measure| match *m {
            Measure::Root { num, den } => (num.1 as f64 / den as f64).sqrt(),
            Measure::Ring { square, radius } => ((square as f64).sqrt() - f64::from(radius)).abs(),
        };
        for i in 0..15 * 160 {
            for j in 0..15 * 160 {
                let (a, b) = (at(i), at(j));
                let difference = value(&a) - value(&b);
                let expected = if difference.abs() < 1e-9 { Ordering::Equal } else { difference.total_cmp(&0.0) };
                assert_eq!(order(a, b), expected, "{a:?} {b:?}");
            }
        }
    }

    /// Exact ties and the least differences at the ends of the ranges.
    #[test]
    fn orders_large_measures() {
        let far = (1u64 << 30) - 1;
        for radius in [1u32, 1 << 16, (1 << 24) - 2] {
            // From (3k, 4k), 5k away.
            let k = far / 5;
            let (square, apart) = (25 * k * k, 5 * k - u64::from(radius));
            let ring = Measure::Ring { square, radius };
            for den in [1u64, 5, (1 << 60) - 93] {
                let times = |n: u64| super::mul64(n, den);
                let root = |n| Measure::Root { num: times(n), den };
                assert_eq!(order(ring, root(apart * apart)), Ordering::Equal);
                assert_eq!(order(ring, root(apart * apart + 1)), Ordering::Less);
                assert_eq!(order(root(apart * apart - 1), ring), Ordering::Less);
            }
            assert_eq!(order(ring, Measure::Ring { square: square + 1, radius }), Ordering::Less);
            let inside = Measure::Ring { square: usqr(radius - 1), radius };
            assert_eq!(order(inside, Measure::root(1)), Ordering::Equal);
            assert_eq!(order(inside, Measure::Ring { square: usqr(radius + 1), radius }), Ordering::Equal);
            assert_eq!(order(inside, Measure::Ring { square: usqr(radius + 2), radius: radius + 1 }), Ordering::Equal);
            assert_eq!(order(ring, inside), Ordering::Greater);
        }
    }
}
