//! Exact distances to features, for comparison: roots, heights over lines, and what is between a point and a circle.

use crate::num::{add128, cmp_squares, less128, mul64, sqr64, sub128, usqr};
use crate::world::World;
use core::cmp::Ordering;

/// A distance, not negative.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) enum Measure {
    /// `sqrt(square)`, `square` below 2^61.
    Point { square: u64 },
    /// `front / sqrt(den)`, the height over a line whose direction has the square `den`: both below 2^61, `den` above 1. Of the slopes of tiles `den` is
    /// 2 or 5, and `front` at most 3 * 2^30.
    Line { front: u64, den: u64 },
    /// `|sqrt(square) - radius|`, `square` below 2^61, the radius at most 2^24.
    Ring { square: u64, radius: u32 },
}

impl Measure {
    /// The distance between points, by its square.
    pub(in crate::world) const fn root(square: u64) -> Self {
        Self::Point { square }
    }

    /// The distance from a line, by its product with the length of the line's direction, which has the square `den`.
    pub(in crate::world) const fn height(front: u64, den: u64) -> Self {
        if den == 1 { Self::Point { square: usqr(front as u32) } } else { Self::Line { front, den } }
    }

    /// Exact. Two or three products of double words where slopes or arcs are compared; ten where an arc is compared with a free segment. A
    /// level links what it has features for.
    #[inline(never)]
    pub(in crate::world) fn order<W: World>(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Point { square: n }, Self::Point { square: m }) => n.cmp(m),
            _ if W::BLOCKS => Ordering::Equal,
            (Self::Line { front: f, den: d }, Self::Line { front: g, den: e }) if d == e => f.cmp(g),
            (Self::Line { front: f, den: d }, Self::Line { front: g, den: e }) => lines::<W>(*f, *d, *g, *e),
            (Self::Line { front, den }, Self::Point { square }) => line_and_point(*front, *den, *square),
            (Self::Point { square }, Self::Line { front, den }) => line_and_point(*front, *den, *square).reverse(),
            _ if !W::ROUND => Ordering::Equal,
            (Self::Ring { square: a, radius: r }, Self::Ring { square: b, radius: s }) => rings(*a, *r, *b, *s),
            (Self::Ring { square, radius }, line) => ring_and_line::<W>(*square, *radius, line),
            (line, Self::Ring { square, radius }) => ring_and_line::<W>(*square, *radius, line).reverse(),
        }
    }
}

/// `f / sqrt(d)` against `g / sqrt(e)`: 183 bits, of the slopes of tiles 67.
#[inline(never)]
fn lines<W: World>(f: u64, d: u64, g: u64, e: u64) -> Ordering {
    if W::WIDE {
        return cmp_squares((f, e), (g, d));
    }
    mul64(usqr(f as u32), e).cmp(&mul64(usqr(g as u32), d))
}

/// `f / sqrt(d)` against `sqrt(n)`: 122 bits.
#[inline(never)]
fn line_and_point(f: u64, d: u64, n: u64) -> Ordering {
    sqr64(f).cmp(&mul64(n, d))
}

/// `|sqrt(a) - r|` against `t`, which is a root or a height.
///
/// Outside, `sqrt(a) < r + t` is `a - r^2 - t^2 < 2 r t`; inside, `r < sqrt(a) + t` is `r^2 - a - t^2 < 2 sqrt(a) t`. Both are, with `w = |a - r^2|` and
/// `k` the lesser of the squares, `w - t^2 < 2 sqrt(k) t`; for `t = f / sqrt(d)` that is `w d - f^2 < 2 f sqrt(k d)`: true where the left side
/// is negative, else by its square. `k` is at most 2^48; a root and a tile's slope have `w d` and `f^2` below 2^64, and `4 k d` below 2^53.
#[inline(never)]
fn ring_and_line<W: World>(a: u64, r: u32, line: &Measure) -> Ordering {
    let rr = usqr(r);
    let (w, k) = if a < rr { (rr.wrapping_sub(a), a) } else { (a.wrapping_sub(rr), rr) };
    let (square, den) = match *line {
        Measure::Line { front, den } if W::WIDE && den > 5 => return free_line(w, k << 2, front, den),
        Measure::Line { front, den } => (usqr(front as u32), den),
        Measure::Point { square } | Measure::Ring { square, .. } => (square, 1),
    };
    // Below 8.
    let times = |n: u64| n.wrapping_mul(den);
    let wd = times(w);
    if wd < square {
        return Ordering::Less;
    }
    sqr64(wd.wrapping_sub(square)).cmp(&mul64(square, times(k << 2)))
}

/// `w d - f^2` against `f sqrt(c d)`: by 244 bits.
#[inline(never)]
fn free_line(w: u64, c: u64, f: u64, d: u64) -> Ordering {
    let (wd, ff) = (mul64(w, d), sqr64(f));
    if less128(wd, ff) {
        return Ordering::Less;
    }
    let x = sub128(wd, ff);
    product(x, x).cmp(&product(ff, mul64(c, d)))
}

/// The product of two numbers below 2^124, high words first, so that it compares as a number.
#[inline(never)]
fn product(a: (u64, u64), b: (u64, u64)) -> ((u64, u64), (u64, u64)) {
    let (low, high) = (mul64(a.1, b.1), mul64(a.0, b.0));
    // Below 2^125.
    let mid = add128(mul64(a.0, b.1), mul64(a.1, b.0));
    let (word, carry) = low.0.overflowing_add(mid.1);
    (add128(high, (0, mid.0.wrapping_add(u64::from(carry)))), (word, low.1))
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
    let (a, b, square) =
        (if delta < 0 { b } else { a }, if delta < 0 { a } else { b }, usqr(delta.unsigned_abs() as u32));
    // sqrt(a) against sqrt(b) + |delta|: a - b - delta^2 against 2 |delta| sqrt(b).
    let order = if a < b.wrapping_add(square) {
        Ordering::Less
    } else {
        sqr64(a.wrapping_sub(b).wrapping_sub(square)).cmp(&mul64(square << 2, b))
    };
    if delta < 0 { order.reverse() } else { order }
}

/// `sqrt(a) + sqrt(b)` against a sum of radii, below 2^31.
fn roots_together(a: u64, b: u64, sum: u32) -> Ordering {
    // 2 sqrt(a b) against sum^2 - a - b.
    let (square, both) = (usqr(sum), a.wrapping_add(b));
    if square < both {
        return Ordering::Greater;
    }
    mul64(a << 2, b).cmp(&sqr64(square.wrapping_sub(both)))
}

#[cfg(test)]
mod tests {
    use super::{Measure, Ordering, usqr};
    use crate::world::{AllShapes, Joined, SegmentMap, TileMap};

    type Tiles = TileMap<'static, AllShapes>;
    type Both = Joined<'static, Tiles, SegmentMap<'static>>;

    /// Of a level with free lines, and of one of tiles where it can have both.
    fn order(a: Measure, b: Measure) -> Ordering {
        let free = |m: &Measure| matches!(m, Measure::Line { den, .. } if ![2, 5].contains(den));
        let order = a.order::<Both>(&b);
        if !free(&a) && !free(&b) {
            assert_eq!(a.order::<Tiles>(&b), order, "{a:?} {b:?}");
        }
        order
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
            let (n, kind) = (i / 16, i % 16);
            match kind {
                0..11 => Measure::Ring { square: n, radius: 1 + kind as u32 },
                11 => Measure::root(n),
                _ => Measure::height(n / 4, [1, 2, 5, 13][kind as usize - 12]),
            }
        };
        let value = |m: &Measure| match *m {
            Measure::Point { square } => (square as f64).sqrt(),
            Measure::Line { front, den } => front as f64 / (den as f64).sqrt(),
            Measure::Ring { square, radius } => ((square as f64).sqrt() - f64::from(radius)).abs(),
        };
        for i in 0..16 * 160 {
            for j in 0..16 * 160 {
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
            // Of the directions whose length is a number, the heights over lines are too.
            for length in [1u64, 2, 5, (1 << 30) - 35] {
                let height = |front| Measure::height(front, length * length);
                assert_eq!(order(ring, height(length * apart)), Ordering::Equal);
                assert_eq!(order(ring, height(length * apart + 1)), Ordering::Less);
                assert_eq!(order(height(length * apart - 1), ring), Ordering::Less);
                assert_eq!(order(height(length * apart), Measure::root(apart * apart)), Ordering::Equal);
                assert_eq!(order(height(length * apart), Measure::root(apart * apart - 1)), Ordering::Greater);
            }
            assert_eq!(order(ring, Measure::root(apart * apart)), Ordering::Equal);
            assert_eq!(order(ring, Measure::root(apart * apart + 1)), Ordering::Less);
            assert_eq!(order(Measure::root(apart * apart - 1), ring), Ordering::Less);
            assert_eq!(order(ring, Measure::Ring { square: square + 1, radius }), Ordering::Less);
            let inside = Measure::Ring { square: usqr(radius - 1), radius };
            assert_eq!(order(inside, Measure::root(1)), Ordering::Equal);
            assert_eq!(order(inside, Measure::Ring { square: usqr(radius + 1), radius }), Ordering::Equal);
            assert_eq!(order(inside, Measure::Ring { square: usqr(radius + 2), radius: radius + 1 }), Ordering::Equal);
            assert_eq!(order(ring, inside), Ordering::Greater);
            // A tile's slopes: the heights on both sides of sqrt(d) times the distance.
            for den in [2u64, 5] {
                let front = (den * apart * apart).isqrt();
                assert_eq!(order(Measure::height(front, den), ring), Ordering::Less);
                assert_eq!(order(Measure::height(front + 1, den), ring), Ordering::Greater);
            }
        }
    }
}
