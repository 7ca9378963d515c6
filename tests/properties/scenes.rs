//! Pairs of shapes that shrink to small ones at the origin.

use proptest::prelude::*;
use tilesat_judge::oracle::figure::{Figure, Kind, LIMIT, PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Pairs, aabb};

/// The numbers of a shape without its kind: two points and a radius.
type Bare = (Point, Point, i64);

fn made(kind: Kind, (p, q, r): Bare) -> Figure {
    match kind {
        Kind::Aabb => aabb(p, q),
        Kind::Circle => Figure::Circle { centre: p, radius: r.abs() },
        Kind::Segment => Figure::Segment { a: p, b: q },
    }
}

fn point(n: std::ops::RangeInclusive<i64>) -> impl Strategy<Value = Point> {
    (n.clone(), n)
}

fn bare(n: std::ops::RangeInclusive<i64>) -> impl Strategy<Value = Bare> {
    (point(n.clone()), point(n.clone()), n)
}

/// Factors for lattice scenes: 1 raw shapes, odd sizes, whole units, and the greatest in the domain
/// (8 lattice steps).
const UNITS: [i64; 6] = [1, 3, 1 << 16, 65_537, 1 << 21, (LIMIT - 8) / 24];

/// A few points of a lattice of any spacing. So touches, shared corners and ties are frequent, with
/// 3-4-5 triples. In half of the cases, then every number moves by up to 2 raw. In some, then all
/// of it moves far away.
fn lattice() -> impl Strategy<Value = (Figure, Figure)> {
    let jitter = prop_oneof![Just(0i64), 1i64..=2];
    let far = prop_oneof![3 => Just((0, 0)), 1 => point(-LIMIT..=LIMIT)];
    (
        0..PAIRS.len(),
        prop::sample::select(&UNITS[..]),
        bare(-8..=8),
        bare(-8..=8),
        jitter,
        bare(-2..=2),
        bare(-2..=2),
        far,
    )
        .prop_map(|(pair, unit, one, other, jitter, off, out, far)| {
            let place = |(p, q, r): Bare, (o, u, s): Bare| {
                let at = |n: i64, o: i64| n * unit + o.clamp(-jitter, jitter);
                ((at(p.0, o.0), at(p.1, o.1)), (at(q.0, u.0), at(q.1, u.1)), at(r, s))
            };
            let (a, b) = (made(PAIRS[pair].0, place(one, off)), made(PAIRS[pair].1, place(other, out)));
            // Into the domain with both, if there is room.
            let reach = |f: fn(&Point) -> i64| {
                let all = a.vertices().into_iter().chain(b.vertices());
                all.map(|p| f(&p).abs()).max().unwrap_or(0) + a.radius() + b.radius()
            };
            let room = (LIMIT - 1 - reach(|p| p.0), LIMIT - 1 - reach(|p| p.1));
            let by = (far.0.clamp(-room.0.max(0), room.0.max(0)), far.1.clamp(-room.1.max(0), room.1.max(0)));
            (a.moved(by), b.moved(by))
        })
        .prop_filter("outside of the domain", |(a, b)| a.in_domain() && b.in_domain())
}

/// The classes of the exact judge's own tests: uniform, near touching, touching, far, whole domain,
/// deep. A seed does not shrink.
fn generated() -> impl Strategy<Value = (Figure, Figure)> {
    (0..PAIRS.len(), 0..CLASSES.len(), any::<u64>())
        .prop_map(|(pair, class, seed)| Pairs::new(PAIRS[pair], CLASSES[class], seed).next())
}

pub(crate) fn pairs() -> impl Strategy<Value = (Figure, Figure)> {
    prop_oneof![lattice(), generated()]
}

/// At the very ends of the domain: corners of it, a raw unit less, and powers of two.
pub(crate) fn extremes() -> impl Strategy<Value = (Figure, Figure)> {
    let end = || {
        let magnitude = prop_oneof![Just(LIMIT - 1), Just(LIMIT - 2), (0u32..29).prop_map(|k| 1i64 << k), Just(0)];
        (magnitude, any::<bool>()).prop_map(|(n, minus)| if minus { -n } else { n })
    };
    let shape = move || ((end(), end()), (end(), end()), end());
    (0..PAIRS.len(), shape(), shape())
        .prop_map(|(pair, one, other)| {
            // A circle stays in the domain with its whole extent.
            let fit = |kind, (p, q, r): Bare| made(kind, (p, q, r.abs().min(LIMIT - 1 - p.0.abs().max(p.1.abs()))));
            (fit(PAIRS[pair].0, one), fit(PAIRS[pair].1, other))
        })
        .prop_filter("outside of the domain", |(a, b)| a.in_domain() && b.in_domain())
}

/// A motion of A that leads through, from or to its position, within a raw unit. `None` if it
/// leaves the domain.
pub(crate) fn motions() -> impl Strategy<Value = (Figure, Figure, Point)> {
    let direction = prop_oneof![point(-8..=8), (-8i64..=8).prop_map(|x| (x, 0)), (-8i64..=8).prop_map(|y| (0, y))];
    let unit = prop_oneof![Just(1i64), Just(3), Just(1 << 16), Just(65_537), Just(1 << 21)];
    (pairs(), direction, unit, 1i64..=7, 0i64..=7, point(-1..=1))
        .prop_map(|((a, b), u, unit, n, i, off)| {
            let d = (u.0 * unit * n, u.1 * unit * n);
            let i = i.min(n);
            (a.moved((off.0 - u.0 * unit * i, off.1 - u.1 * unit * i)), b, d)
        })
        .prop_filter("outside of the domain", |(a, _, d)| {
            a.in_domain() && a.moved(*d).in_domain() && d.0.abs().max(d.1.abs()) < 1 << 28
        })
}
