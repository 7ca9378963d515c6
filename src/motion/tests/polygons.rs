//! Against polygons, exactly: a motion overlaps before a moment iff what its core sweeps comes
//! nearer than the radius to an edge.

use super::super::body::{Entry, kernel::Kernel as _};
use super::std::vec::Vec;
use super::std::{format, println, vec};
use super::{Body, P, Random, capsule, cases, circle, enough, first, outline, raw};
use num_bigint::BigInt;

pub(super) type Big = BigInt;
pub(super) type Wide = (Big, Big);

fn sub(a: &Wide, b: &Wide) -> Wide {
    (&a.0 - &b.0, &a.1 - &b.1)
}

fn dot(a: &Wide, b: &Wide) -> Big {
    &a.0 * &b.0 + &a.1 * &b.1
}

fn cross(a: &Wide, b: &Wide) -> Big {
    &a.0 * &b.1 - &a.1 * &b.0
}

pub(super) fn zero() -> Big {
    Big::from(0)
}

/// Whether a point is nearer to a segment than the root of `rr`.
pub(super) fn point_near(p: &Wide, a: &Wide, b: &Wide, rr: &Big) -> bool {
    let (e, m) = (sub(b, a), sub(p, a));
    let along = dot(&m, &e);
    if along <= zero() {
        return dot(&m, &m) < *rr;
    }
    let square = dot(&e, &e);
    if along >= square {
        let m = sub(p, b);
        return dot(&m, &m) < *rr;
    }
    let across = cross(&m, &e);
    &across * &across < rr * &square
}

pub(super) fn side(p: &Wide, a: &Wide, b: &Wide) -> Big {
    cross(&sub(b, a), &sub(p, a))
}

/// Whether the distance of two intervals alone is at least the root of `rr`.
fn is_far((a, b): (&Big, &Big), (p, q): (&Big, &Big), rr: &Big) -> bool {
    let (low, high) = if a.max(b) < p.min(q) { (a.max(b), p.min(q)) } else { (p.max(q), a.min(b)) };
    low < high && (high - low).pow(2) >= *rr
}

/// Whether two segments are nearer to each other than the root of `rr`, which is not 0.
pub(super) fn near((a, b): (&Wide, &Wide), (p, q): (&Wide, &Wide), rr: &Big) -> bool {
    // Most segments are far apart, which saves two thirds of the time of these tests.
    if is_far((&a.0, &b.0), (&p.0, &q.0), rr) || is_far((&a.1, &b.1), (&p.1, &q.1), rr) {
        return false;
    }
    let apart = |p: &Big, q: &Big| (p < &zero()) != (q < &zero()) && *p != zero() && *q != zero();
    point_near(p, a, b, rr)
        || point_near(q, a, b, rr)
        || point_near(a, p, q, rr)
        || point_near(b, p, q, rr)
        || (apart(&side(a, p, q), &side(b, p, q)) && apart(&side(p, a, b), &side(q, a, b)))
}

/// A body: an end of its core, how far it is to the other one, the radius.
type Round = (P, P, i64);

/// Whether the motion `num / den` of the way comes nearer to the polygon's border than the radius:
/// the core sweeps a parallelogram.
fn enters(solid: &[P], (c, size, r): Round, d: P, num: i64, den: i64) -> bool {
    let big = |p: P| (Big::from(p.0) * den, Big::from(p.1) * den);
    let plus = |p: &Wide, q: P, by: i64| (&p.0 + Big::from(q.0) * by, &p.1 + Big::from(q.1) * by);
    let start = big(c);
    let (far, end) = (plus(&start, size, den), plus(&start, d, num));
    let swept = [start, far.clone(), plus(&far, d, num), end];
    let rr = Big::from(r) * Big::from(r) * den * den;
    let sides = |k: usize| (&swept[k], &swept[(k + 1) % 4]);
    (0..solid.len()).any(|i| {
        let (a, b) = (big(solid[i]), big(solid[(i + 1) % solid.len()]));
        let turns: Vec<_> = (0..4).map(|k| side(&a, sides(k).0, sides(k).1)).collect();
        let is_in = turns.iter().all(|t| *t > zero()) || turns.iter().all(|t| *t < zero());
        is_in || (0..4).any(|k| near(sides(k), (&a, &b), &rr))
    })
}

/// Whether a point is inside, by its winding.
pub(super) fn contains(solid: &[P], p: P) -> bool {
    let n = solid.len();
    let mut winding = 0;
    for i in 0..n {
        let (a, b) = (solid[i], solid[(i + 1) % n]);
        let side = i128::from(b.0 - a.0) * i128::from(p.1 - a.1) - i128::from(b.1 - a.1) * i128::from(p.0 - a.0);
        if a.1 <= p.1 && b.1 > p.1 && side > 0 {
            winding += 1;
        } else if a.1 > p.1 && b.1 <= p.1 && side < 0 {
            winding -= 1;
        }
    }
    winding != 0
}

#[derive(Debug, Default)]
struct Tally {
    hits: u64,
    misses: u64,
    /// Hits whose rounded place overlaps something: another feature than the one that was hit.
    aside: u64,
    stays: u64,
    /// Corners before faces.
    ties: u64,
}

/// One motion: hit or not, never late, early by less than a raw unit of way, and a free place at
/// the end.
fn check(solid: &[P], round: Round, d: P, tally: &mut Tally) {
    let (c, size, r) = round;
    if r == 0 || d == (0, 0) || enters(solid, round, (0, 0), 0, 1) || contains(solid, c) {
        return;
    }
    if size == (0, 0) {
        check_body(&circle(c, r), solid, round, d, tally);
    } else {
        check_body(&capsule(c, size, r), solid, round, d, tally);
    }
}

fn check_body<B: Body>(body: &B, solid: &[P], round: Round, d: P, tally: &mut Tally) {
    let case = || format!("{solid:?} {round:?} by {d:?}");
    let (c, size, r) = round;
    let features = outline(solid);
    let Some(entry) = first(body, d, &features) else {
        tally.misses += 1;
        assert!(!enters(solid, round, d, 1, 1), "missed: {}", case());
        return;
    };
    tally.hits += 1;
    let (num, den) = (i64::from(entry.num), i64::from(entry.den));
    assert!(!enters(solid, round, d, num, den), "late {entry:?}: {}", case());
    // A corner goes before a face along x or y only if it is met before the exact moment of that.
    let exact = |e: &Entry| e.step.is_none() && (e.normal.x == 0 || e.normal.y == 0);
    for face in features.iter().filter_map(|f| body.sweep(raw(d), f)).filter(exact) {
        let before = entry.step.is_none() || enters(solid, round, d, face.num.into(), face.den.into());
        assert!(before, "{entry:?} before {face:?}: {}", case());
        tally.ties += u64::from(entry.step.is_some());
    }
    let length = ((d.0 * d.0 + d.1 * d.1) as f64).sqrt();
    let raw_of_way = (f64::from(1 << 30) / length) as i64;
    let until = ((num << 30) / den + 8 + raw_of_way).min(1 << 30);
    assert!(enters(solid, round, d, until, 1 << 30), "early {entry:?}: {}", case());
    let q = entry.displacement(raw(d));
    let place = |x: i32, y: i32| {
        let within = |q: i32, d: i64| i64::from(q).clamp(d.min(0), d.max(0));
        (c.0 + within(q.x + x, d.0), c.1 + within(q.y + y, d.1))
    };
    let free = |at: P| !enters(solid, (at, size, r), (0, 0), 0, 1);
    let (sx, sy) = (d.0.signum() as i32, d.1.signum() as i32);
    if !free(place(0, 0)) {
        tally.aside += 1;
        let near = [(-sx, -sy), (sx, 0), (0, sy), (-sx, 0), (0, -sy), (-2 * sx, -2 * sy)];
        tally.stays += u64::from(!near.iter().any(|&(x, y)| free(place(x, y))));
    }
}

/// The slopes of tiles, and shapes that are not convex, on a lattice of 4.
pub(super) const SOLIDS: [&[P]; 12] = [
    &[(0, 4), (4, 0), (4, 4)],
    &[(0, 0), (4, 4), (0, 4)],
    &[(0, 4), (4, 2), (4, 4)],
    &[(0, 2), (4, 0), (4, 4), (0, 4)],
    &[(2, 0), (4, 4), (0, 4)],
    &[(0, 2), (2, 0), (4, 2), (2, 4)],
    &[(1, 0), (3, 1), (2, 3)],
    // A V of 45 degrees, one of 45 and of half of that slope, a slope that ends at a wall, a wedge
    // under a ceiling, a peak.
    &[(0, 0), (2, 2), (4, 0), (4, 4), (0, 4)],
    &[(0, 0), (2, 2), (4, 1), (4, 4), (0, 4)],
    &[(0, 3), (3, 2), (3, 0), (4, 0), (4, 4), (0, 4)],
    &[(0, 4), (4, 2), (0, 3), (0, 0), (5, 0), (5, 5), (0, 5)],
    &[(0, 4), (2, 0), (3, 4)],
];

/// A convex polygon, or a triangle, of any size and direction.
pub(super) fn any_polygon(r: &mut Random, size: i64) -> Vec<P> {
    if r.one_in(2) {
        let scale = r.within(1, (size / 5).max(1));
        return SOLIDS[r.below(12) as usize].iter().map(|p| (p.0 * scale, p.1 * scale)).collect();
    }
    let mut p = vec![(0, 0); 3];
    for p in &mut p {
        *p = (r.sign() * r.magnitude(size), r.sign() * r.magnitude(size));
    }
    let area = i128::from(p[1].0 - p[0].0) * i128::from(p[2].1 - p[0].1)
        - i128::from(p[1].1 - p[0].1) * i128::from(p[2].0 - p[0].0);
    match area {
        0 => vec![(0, 0), (size, 0), (0, size)],
        1.. => p,
        _ => vec![p[0], p[2], p[1]],
    }
}

/// A point of an edge: an end, near one, or between.
pub(super) fn target(r: &mut Random, solid: &[P]) -> (P, P) {
    let i = r.below(solid.len() as i64) as usize;
    let (a, b) = (solid[i], solid[(i + 1) % solid.len()]);
    let e = (b.0 - a.0, b.1 - a.1);
    let k = if r.one_in(3) { 0 } else { r.within(0, 1 << 20) };
    let part = |c: i64| ((i128::from(c) * i128::from(k)) >> 20) as i64;
    ((a.0 + part(e.0), a.1 + part(e.1)), e)
}

/// `v` turned by a right angle away from the solid, with a length.
pub(super) fn across(e: P, length: i64) -> P {
    let scale = length as f64 / (e.0 as f64).hypot(e.1 as f64).max(1.0);
    ((e.1 as f64 * scale).round() as i64, (-e.0 as f64 * scale).round() as i64)
}

fn random(seed: u64, n: u64, size: i64, longest: i64, is_capsule: bool) -> Tally {
    let (mut r, mut tally) = (Random::new(seed), Tally::default());
    for _ in 0..n {
        let solid = any_polygon(&mut r, size);
        let radius = 1 + r.magnitude(longest.min(4 * size));
        let motion = if r.one_in(3) { 64 } else { longest };
        let d = (r.sign() * r.magnitude(motion), r.sign() * r.magnitude(motion));
        let (at, e) = target(&mut r, &solid);
        // The centre reaches the radius from an edge, or passes a point at that distance, or
        // anything near; within two raw.
        let offset = match r.below(4) {
            0 => across(d, radius * r.sign()),
            1 => (r.around(radius), r.around(radius)),
            _ => across(e, radius),
        };
        let back = r.within(0, 1 << 20);
        let part = |c: i64| (c * back) >> 20;
        let c = (at.0 + offset.0 - part(d.0) + r.around(2), at.1 + offset.1 - part(d.1) + r.around(2));
        // Of a capsule, an end of the core comes there, or a point between the ends.
        let long = if is_capsule { 1 + r.magnitude(longest.min(4 * size)) } else { 0 };
        let size = if r.one_in(2) { (long, 0) } else { (0, long) };
        let part = if r.one_in(2) { r.below(2) << 10 } else { r.within(0, 1 << 10) };
        let c = (c.0 - ((size.0 * part) >> 10), c.1 - ((size.1 * part) >> 10));
        if c.0.abs().max(c.1.abs()) + long < (1 << 29) {
            check(&solid, (c, size, radius), d, &mut tally);
        }
    }
    println!("{tally:?}");
    tally
}

#[test]
fn slopes_on_all_scales() {
    for (seed, bits) in [(1, 6), (2, 12), (3, 20), (4, 24)] {
        let tally = random(seed, cases(4000), 1 << bits, 1 << (bits + 2), false);
        assert!(enough(tally.hits > cases(4000) / 8 && tally.misses > cases(4000) / 16));
        assert!(enough(tally.aside <= tally.hits / 20) && tally.stays <= tally.aside);
    }
}

/// Edges and motions as long as the domain allows: directions of 2^29, motions and radii of 2^28.
#[test]
fn at_the_limits() {
    for is_capsule in [false, true] {
        let tally = random(9, cases(4000), (1 << 28) - 1, (1 << 28) - 1, is_capsule);
        assert!(enough(tally.hits > cases(4000) / 16 && tally.misses > cases(4000) / 32));
    }
}

/// Tiny numbers, where every tie happens.
#[test]
fn exhaustively() {
    let (mut tally, every) = (Tally::default(), tilesat_judge::thorough(3, 1));
    for solid in SOLIDS {
        let solid: Vec<P> = solid.iter().map(|p| (2 * p.0, 2 * p.1)).collect();
        for k in (0..14 * 14 * 7 * 7 * 2).step_by(every) {
            let at = (k % 14 - 4, k / 14 % 14 - 4);
            let d = (3 * (k / 196 % 7 - 3), 2 * (k / 1372 % 7 - 3));
            check(&solid, (at, (0, 0), if k / 9604 == 0 { 2 } else { 5 }), d, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > 10_000 / every as u64 && tally.misses > 5_000 / every as u64);
}

#[test]
fn capsules_on_all_scales() {
    for (seed, bits) in [(5, 6), (6, 12), (7, 20), (8, 24)] {
        let tally = random(seed, cases(4000), 1 << bits, 1 << (bits + 2), true);
        assert!(enough(tally.hits > cases(4000) / 8 && tally.misses > cases(4000) / 32));
        assert!(enough(tally.aside <= tally.hits / 20) && tally.stays <= tally.aside);
    }
}

/// Standing and lying, on the lattice where every tie happens.
#[test]
fn capsules_exhaustively() {
    let (mut tally, every) = (Tally::default(), tilesat_judge::thorough(5, 1));
    for solid in SOLIDS {
        let solid: Vec<P> = solid.iter().map(|p| (2 * p.0, 2 * p.1)).collect();
        // The step has no factor in common with the sides of the lattice.
        for k in (0..14 * 14 * 7 * 7 * 4).step_by(every) {
            let at = (k % 14 - 4, k / 14 % 14 - 4);
            let d = (3 * (k / 196 % 7 - 3), 2 * (k / 1372 % 7 - 3));
            let (size, r) = [((0, 3), 2), ((4, 0), 2), ((0, 2), 5), ((8, 0), 1)][(k / 9604) as usize];
            check(&solid, (at, size, r), d, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > 20_000 / every as u64 && tally.misses > 10_000 / every as u64);
}

/// All segments of a lattice around capsules: within a distance or not, its border included.
#[test]
fn within_a_distance_of_capsules() {
    let (mut yes, mut no) = (0, 0);
    for (size, r, reach) in [((0, 5), 2, 1), ((4, 0), 1, 4), ((0, 7), 1, 0), ((0, 0), 3, 2)] {
        let body = capsule((0, 0), size, r);
        for k in 0..11 * 13 * 11 * 13 {
            let (a, b) = ((k % 11 - 5, k / 11 % 13 - 4), (k / 143 % 11 - 5, k / 1573 - 4));
            // In thousandths: squares of distances are multiples of 1 / 245 at most.
            let fine = |p: P| (Big::from(1000 * p.0), Big::from(1000 * p.1));
            let rr = Big::from((1000 * (r + reach)).pow(2) + 1);
            let wanted = near((&fine((0, 0)), &fine(size)), (&fine(a), &fine(b)), &rr);
            assert_eq!(body.is_within(raw(a), raw(b), reach as i32), wanted, "{size:?} {r} {a:?} {b:?} {reach}");
            *if wanted { &mut yes } else { &mut no } += 1;
        }
    }
    assert!(yes > 10_000 && no > 5_000, "{yes} {no}");
}
