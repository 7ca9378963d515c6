//! Bodies with sides in any direction against polygons, exactly. A convex body sweeps the hull of
//! its corners at the start and at the end. It overlaps during the motion iff the inside of that
//! hull, grown by the radius, meets an edge of the solid.

use super::super::body::Entry;
use super::polygons::{Big, SOLIDS, Wide, across, any_polygon, contains, near, side, target, zero};
use super::std::{format, println, vec, vec::Vec};
use super::{AnyShape, ConvexPolygon, Feature, Fx, P, Random, capsule, cases, enough, first, outline, raw, vec2};

const MOST: usize = 6;
type Shape = AnyShape<MOST>;

/// Corners counter-clockwise, and the radius.
#[derive(Clone, Debug)]
pub(super) struct Figure {
    pub(super) corners: Vec<P>,
    pub(super) r: i64,
}

impl Figure {
    pub(super) fn at(&self, by: P) -> Self {
        Self { corners: self.corners.iter().map(|p| (p.0 + by.0, p.1 + by.1)).collect(), r: self.r }
    }

    pub(super) fn shape(&self) -> Shape {
        let radius = Fx::from_bits(self.r as i32);
        if let [a, b] = self.corners[..] {
            return capsule(a, (b.0 - a.0, b.1 - a.1), self.r).into();
        }
        let corners: Vec<_> = self.corners.iter().map(|p| vec2(*p)).collect();
        ConvexPolygon::new(&corners).expect("convex").with_radius(radius).expect("inside the domain").into()
    }
}

fn turn(p: &Wide, q: &Wide, r: &Wide) -> Big {
    side(r, p, q)
}

/// The convex hull, strictly, counter-clockwise.
pub(super) fn hull(mut points: Vec<Wide>) -> Vec<Wide> {
    points.sort();
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = &Wide>| {
        let mut chain: Vec<Wide> = Vec::new();
        for p in points {
            while chain.len() > 1 && turn(&chain[chain.len() - 2], &chain[chain.len() - 1], p) <= zero() {
                chain.pop();
            }
            chain.push(p.clone());
        }
        chain.pop();
        chain
    };
    let mut lower = chain(&mut points.iter());
    lower.extend(chain(&mut points.iter().rev()));
    lower
}

/// Whether a segment meets the inside of a polygon: where the intervals of all sides have a common
/// part with a length.
pub(super) fn crosses(polygon: &[Wide], a: &Wide, b: &Wide) -> bool {
    let n = polygon.len();
    if n < 3 {
        return false;
    }
    // Fractions with a positive divisor.
    let (mut from, mut to) = ((zero(), Big::from(1)), (Big::from(1), Big::from(1)));
    for i in 0..n {
        let (p, q) = (&polygon[i], &polygon[(i + 1) % n]);
        let (start, end) = (side(a, p, q), side(b, p, q));
        let rise = &end - &start;
        if rise == zero() {
            if start <= zero() {
                return false;
            }
        } else if rise > zero() {
            // From the moment -start / rise on.
            if -&start * &from.1 > &from.0 * &rise {
                from = (-start, rise);
            }
        } else if &start * &to.1 < &to.0 * -&rise {
            to = (start, -rise);
        }
    }
    // Both ends may be one point strictly inside of all sides.
    &from.0 * &to.1 < &to.0 * &from.1 || (a == b && from.0 == zero() && to.0 == to.1)
}

/// Whether the motion `num / den` of the way overlaps an edge of the solid.
fn enters(solid: &[P], body: &Figure, d: P, num: i64, den: i64) -> bool {
    let big = |p: P| (Big::from(p.0) * den, Big::from(p.1) * den);
    let moved = |p: P| (Big::from(p.0) * den + Big::from(d.0) * num, Big::from(p.1) * den + Big::from(d.1) * num);
    let swept = hull(body.corners.iter().flat_map(|&p| [big(p), moved(p)]).collect());
    let rr = Big::from(body.r) * body.r * den * den;
    let n = swept.len();
    (0..solid.len()).any(|i| {
        let (a, b) = (big(solid[i]), big(solid[(i + 1) % solid.len()]));
        crosses(&swept, &a, &b) || (body.r > 0 && (0..n).any(|k| near((&swept[k], &swept[(k + 1) % n]), (&a, &b), &rr)))
    })
}

/// Whether it starts in the solid: its sides cross an edge, or one holds the other.
fn starts_inside(solid: &[P], body: &Figure) -> bool {
    if enters(solid, body, (0, 0), 0, 1) {
        return true;
    }
    // A point of its inside that is on no border, in sixths of a raw unit for three corners.
    let n = body.corners.len() as i64;
    let middle = body.corners.iter().fold((0, 0), |m, p| (m.0 + p.0, m.1 + p.1));
    let fine: Vec<P> = solid.iter().map(|p| (p.0 * n, p.1 * n)).collect();
    contains(&fine, middle)
}

#[derive(Debug, Default)]
pub(super) struct Tally {
    pub(super) hits: u64,
    /// Hits of corners and arcs.
    pub(super) round: u64,
    pub(super) misses: u64,
    /// Hits whose rounded place overlaps something: another feature than the one that was hit.
    pub(super) aside: u64,
    pub(super) stays: u64,
}

/// Whether a body overlaps the solid within a part of a motion, `num / den`.
type Enters<'a> = &'a dyn Fn(&Figure, P, i64, i64) -> bool;

fn check(solid: &[P], body: &Figure, d: P, tally: &mut Tally) {
    if d != (0, 0) && !starts_inside(solid, body) {
        let enters: Enters<'_> = &|body, d, num, den| enters(solid, body, d, num, den);
        judge(&outline(solid), enters, body, d, tally);
    }
}

/// One motion of a body that starts outside: hit or not, never late, and early by less than a raw
/// unit of way.
pub(super) fn judge(features: &[Feature], enters: Enters<'_>, body: &Figure, d: P, tally: &mut Tally) {
    let case = || format!("{features:?} {body:?} by {d:?}");
    let shape = body.shape();
    let Some(entry) = first(&shape, d, features) else {
        tally.misses += 1;
        assert!(!enters(body, d, 1, 1), "missed: {}", case());
        return;
    };
    tally.hits += 1;
    tally.round += u64::from(entry.step.is_some());
    let (num, den) = (i64::from(entry.num), i64::from(entry.den));
    assert!(!enters(body, d, num, den), "late {entry:?}: {}", case());
    let length = ((d.0 * d.0 + d.1 * d.1) as f64).sqrt();
    let raw_of_way = (f64::from(1 << 30) / length) as i64;
    let until = ((num << 30) / den + 8 + raw_of_way).min(1 << 30);
    assert!(enters(body, d, until, 1 << 30), "early {entry:?}: {}", case());
    opposed(&entry, d, &case);
    let q = entry.displacement(raw(d));
    let place = |x: i32, y: i32| {
        let within = |q: i32, d: i64| i64::from(q).clamp(d.min(0), d.max(0));
        body.at((within(q.x + x, d.0), within(q.y + y, d.1)))
    };
    let free = |at: &Figure| !enters(at, (0, 0), 0, 1);
    let (sx, sy) = (d.0.signum() as i32, d.1.signum() as i32);
    if !free(&place(0, 0)) {
        tally.aside += 1;
        let near = [(-sx, -sy), (sx, 0), (0, sy), (-sx, 0), (0, -sy), (-2 * sx, -2 * sy)];
        tally.stays += u64::from(!near.iter().any(|&(x, y)| free(&place(x, y))));
    }
}

fn opposed(entry: &Entry, d: P, case: &dyn Fn() -> super::std::string::String) {
    let along = i64::from(entry.normal.x) * d.0 + i64::from(entry.normal.y) * d.1;
    // The position at a corner is rounded, and its normal with it.
    assert!(along < 0 || entry.step.is_some(), "{entry:?}: {}", case());
}

/// Triangles, quads, a hexagon and slanted capsules, sharp and round.
pub(super) fn figures() -> Vec<Figure> {
    let corners: [&[P]; 9] = [
        &[(0, 0), (3, 0), (0, 3)],
        &[(0, 0), (4, 1), (1, 3)],
        &[(0, 0), (5, 0), (1, 1)],
        &[(0, 0), (3, 1), (2, 4), (-1, 3)],
        &[(0, 0), (2, -2), (4, 0), (2, 2)],
        &[(0, 0), (4, 0), (4, 2), (0, 2)],
        &[(0, 0), (6, 2), (5, 2)],
        &[(1, 0), (3, 0), (4, 2), (3, 4), (1, 4), (0, 2)],
        &[(0, 0), (3, 2)],
    ];
    let round = |corners: &[P]| if corners.len() < 3 { vec![1, 2] } else { vec![0, 0, 2] };
    corners.iter().flat_map(|c| round(c).into_iter().map(|r| Figure { corners: c.to_vec(), r })).collect()
}

/// All places of a lattice around small solids, and small motions: every tie happens.
#[test]
fn lattice() {
    let mut tally = Tally::default();
    let mut r = Random::new(11);
    let figures = figures();
    for k in 0..cases(60_000) {
        let solid: Vec<P> = SOLIDS[k as usize % 12].iter().map(|p| (2 * p.0, 2 * p.1)).collect();
        let body = figures[r.below(figures.len() as i64) as usize].at((r.within(-7, 10), r.within(-7, 10)));
        check(&solid, &body, (r.around(8), r.around(8)), &mut tally);
    }
    println!("{tally:?}");
    assert!(enough(tally.hits > cases(60_000) / 8 && tally.misses > cases(60_000) / 12), "{tally:?}");
}

fn random(seed: u64, n: u64, size: i64, longest: i64) -> Tally {
    let (mut r, mut tally) = (Random::new(seed), Tally::default());
    for _ in 0..n {
        let solid = any_polygon(&mut r, size);
        let long = longest.min(2 * size);
        let count = r.within(2, MOST as i64);
        let points: Vec<Wide> = (0..count).map(|_| (Big::from(r.around(long)), Big::from(r.around(long)))).collect();
        let small = |n: &Big| i64::try_from(n.clone()).expect("as it was made");
        let corners: Vec<P> = hull(points).iter().map(|p| (small(&p.0), small(&p.1))).collect();
        if corners.len() < 2 {
            continue;
        }
        let round = corners.len() < 3 || r.one_in(2);
        let body = Figure { corners, r: if round { 1 + r.magnitude(long) } else { 0 } };
        let motion = if r.one_in(3) { 64 } else { longest };
        let d = (r.sign() * r.magnitude(motion), r.sign() * r.magnitude(motion));
        // One of its corners, or a point of a side, reaches a point of the solid, less the radius.
        let (at, e) = target(&mut r, &solid);
        let i = r.below(body.corners.len() as i64) as usize;
        let (p, q) = (body.corners[i], body.corners[(i + 1) % body.corners.len()]);
        let k = if r.one_in(2) { 0 } else { r.within(0, 1 << 10) };
        let own = (p.0 + (((q.0 - p.0) * k) >> 10), p.1 + (((q.1 - p.1) * k) >> 10));
        let offset = match r.below(3) {
            0 => across((q.0 - p.0, q.1 - p.1), -body.r),
            1 => (0, 0),
            _ => across(e, body.r),
        };
        let back = r.within(0, 1 << 20);
        let part = |c: i64| (c * back) >> 20;
        let by = (at.0 + offset.0 - own.0 - part(d.0) + r.around(2), at.1 + offset.1 - own.1 - part(d.1) + r.around(2));
        let body = body.at(by);
        if body.corners.iter().all(|c| c.0.abs().max(c.1.abs()) + body.r < (1 << 29)) {
            check(&solid, &body, d, &mut tally);
        }
    }
    println!("{tally:?}");
    tally
}

#[test]
fn on_all_scales() {
    for (seed, bits) in [(21, 6), (22, 12), (23, 20), (24, 24)] {
        let tally = random(seed, cases(2000), 1 << bits, 1 << (bits + 2));
        assert!(enough(tally.hits > cases(2000) / 16 && tally.misses > cases(2000) / 64), "{tally:?}");
    }
}

/// Bodies with half extents of 2^27, and motions of 2^28.
#[test]
fn at_the_limits() {
    let tally = random(29, cases(2000), (1 << 26) - 1, (1 << 28) - 1);
    assert!(enough(tally.hits > cases(2000) / 16 && tally.misses > cases(2000) / 100), "{tally:?}");
}
