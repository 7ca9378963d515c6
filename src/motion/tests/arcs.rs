//! Against quarter discs and quarter pipes, by exact overlap tests at many moments.

use super::super::body::{Body, kernel::Kernel};
use super::std::vec::Vec;
use super::std::{format, println};
use super::{P, Random, capsule, cases, circle, enough, feature, first, raw, vec2};
use crate::num::Axis;
use crate::world::{Feature, Geometry};

/// The quarter disc of radius `a` around the origin toward +x, +y, or what it leaves of its square.
pub(super) fn outline(a: i64, convex: bool) -> Vec<Feature> {
    let face = |from: P, dir: Axis| feature(Geometry::Face { a: vec2(from), dir, len: a as i32, joined: [false; 2] });
    let vertex = |p: P, e_in, e_out| feature(Geometry::Vertex { p: vec2(p), e_in, e_out });
    let arc = feature(Geometry::Arc { centre: vec2((0, 0)), radius: a as i32, quadrant: Axis::new(1, 1), convex });
    let (x, y, left, up) = (Axis::X, Axis::Y, Axis::NEG_X, Axis::NEG_Y);
    if convex {
        // Along x, the arc back to y, down.
        [face((0, 0), x), face((0, a), up), vertex((a, 0), x, y), vertex((0, a), left, up), vertex((0, 0), up, x), arc]
            .into()
    } else {
        // The arc from (0, a) to (a, 0), the far sides.
        let sides = [face((a, 0), y), face((a, a), left)];
        let ends = [vertex((a, 0), up, y), vertex((a, a), y, left), vertex((0, a), left, x)];
        sides.into_iter().chain(ends).chain([arc]).collect()
    }
}

type Wide = (i128, i128);

/// Whether the box that stands or lies around a capsule's core overlaps the solid.
fn box_overlaps(lo: Wide, hi: Wide, a: i128, convex: bool) -> bool {
    if convex {
        // The point of it that is nearest to the centre, in the quarter.
        let (x, y) = (lo.0.max(0), lo.1.max(0));
        return hi.0 > 0 && hi.1 > 0 && x * x + y * y < a * a;
    }
    // The point in the square that is farthest.
    let (x, y) = (hi.0.min(a), hi.1.min(a));
    let in_square = lo.0 < a && hi.0 > 0 && lo.1 < a && hi.1 > 0;
    in_square && x * x + y * y > a * a
}

/// Whether a capsule overlaps the solid, all in units of 1 / `den`; of equal ends a circle.
fn capsule_overlaps(c: Wide, size: Wide, r: i128, a: i128, convex: bool) -> bool {
    let end = (c.0 + size.0, c.1 + size.1);
    let flat = if size.0 == 0 { (r, 0) } else { (0, r) };
    overlaps(c, r, a, convex)
        || (size != (0, 0)
            && (overlaps(end, r, a, convex)
                || box_overlaps((c.0 - flat.0, c.1 - flat.1), (end.0 + flat.0, end.1 + flat.1), a, convex)))
}

/// Whether the circle overlaps the solid, all in units of 1 / `den`.
fn overlaps(c: Wide, r: i128, a: i128, convex: bool) -> bool {
    let near = |p: Wide| (c.0 - p.0).pow(2) + (c.1 - p.1).pow(2) < r * r;
    // To a segment along x or y.
    let side = |p: Wide, q: Wide| near((c.0.clamp(p.0, q.0), c.1.clamp(p.1, q.1)));
    let (inside, square) = (c.0 >= 0 && c.1 >= 0, c.0 * c.0 + c.1 * c.1);
    if convex {
        return if inside { square < (a + r).pow(2) } else { side((0, 0), (a, 0)) || side((0, 0), (0, a)) };
    }
    let in_solid = inside && c.0 <= a && c.1 <= a && square >= a * a;
    let arc = inside && square < a * a && (r > a || square > (a - r).pow(2));
    (in_solid && r > 0) || arc || side((a, 0), (a, a)) || side((0, a), (a, a))
}

#[derive(Debug, Default)]
struct Tally {
    arcs: u64,
    others: u64,
    misses: u64,
    /// Hits that no sampled moment confirms: grazes.
    unconfirmed: u64,
    aside: u64,
}

fn check(arc: (i64, bool), (c, size, r): (P, P, i64), d: P, tally: &mut Tally) {
    if size == (0, 0) {
        check_body(&circle(c, r), arc, (c, size, r), d, tally);
    } else {
        check_body(&capsule(c, size, r), arc, (c, size, r), d, tally);
    }
}

fn check_body<B: Body>(body: &B, (a, convex): (i64, bool), (c, size, r): (P, P, i64), d: P, tally: &mut Tally) {
    let wide = |p: P, by: i128| (i128::from(p.0) * by, i128::from(p.1) * by);
    let at = |num: i128, den: i128| {
        let part = |c: i64, d: i64| i128::from(c) * den + i128::from(d) * num;
        let c = (part(c.0, d.0), part(c.1, d.1));
        capsule_overlaps(c, wide(size, den), i128::from(r) * den, i128::from(a) * den, convex)
    };
    if r == 0 || d == (0, 0) || at(0, 1) {
        return;
    }
    let case = || format!("{convex} {a} {c:?} {size:?} {r} by {d:?}");
    let features = outline(a, convex);
    let Some(entry) = first(body, d, &features) else {
        tally.misses += 1;
        for k in 0..=64 {
            assert!(!at(k, 64), "missed at {k}: {}", case());
        }
        return;
    };
    let (num, den) = (i128::from(entry.num), i128::from(entry.den));
    for k in 0..=64 {
        assert!(!at(num * k, den * 64), "late {entry:?}: {}", case());
    }
    // Within a few raw units of way it overlaps.
    let length = ((d.0 * d.0 + d.1 * d.1) as f64).sqrt();
    let start = (num << 30) / den;
    let reach = i128::from((f64::from(1 << 30) * 4.0 / length) as i64) + 64;
    let confirmed = (1..=64).any(|k| at((start + reach * k / 64).min(1 << 30), 1 << 30));
    tally.unconfirmed += u64::from(!confirmed);
    if entry.step.is_some() {
        tally.arcs += 1;
    } else {
        tally.others += 1;
    }
    let q = entry.displacement(raw(d));
    let (x, y) = (i128::from(c.0) + i128::from(q.x), i128::from(c.1) + i128::from(q.y));
    tally.aside += u64::from(capsule_overlaps((x, y), wide(size, 1), r.into(), a.into(), convex));
    assert!(entry.normal.x != 0 || entry.normal.y != 0);
}

fn balanced(tally: &Tally, few: u64) {
    println!("{tally:?}");
    assert!(enough(tally.arcs > few && tally.misses > few), "{tally:?}");
    assert!(enough(tally.unconfirmed <= tally.arcs / 50), "{tally:?}");
    assert!(enough(tally.aside <= tally.arcs / 50), "{tally:?}");
}

/// All circles of three sizes around arcs of radius 5 and 10 (3-4-5), all small motions.
#[test]
fn exhaustively() {
    for convex in [true, false] {
        let mut tally = Tally::default();
        for (a, r) in [(10, 5), (5, 5), (5, 8), (10, 1)] {
            for x in -7_i64..=14 {
                for y in -7_i64..=14 {
                    let every = tilesat_judge::thorough(3_i64, 1);
                    for k in ((x + y).rem_euclid(every)..11 * 11).step_by(every as usize) {
                        let d = (3 * (k % 11 - 5), k / 11 - 5);
                        check((a, convex), ((x, y), (0, 0), r), d, &mut tally);
                    }
                }
            }
        }
        balanced(&tally, 1000);
    }
}

/// Standing and lying capsules, of which an end or a side reaches an arc.
#[test]
fn capsules_exhaustively() {
    for convex in [true, false] {
        let mut tally = Tally::default();
        for (a, r, size) in [(10, 5, (0, 3)), (5, 5, (4, 0)), (5, 8, (0, 2)), (10, 1, (12, 0)), (10, 4, (0, 7))] {
            for x in -18_i64..=14 {
                for y in -14_i64..=14 {
                    // Another part of the motions at each place.
                    let every = tilesat_judge::thorough(7_i64, 1);
                    for k in ((x + 3 * y).rem_euclid(every)..11 * 11).step_by(every as usize) {
                        let d = (3 * (k % 11 - 5), k / 11 - 5);
                        check((a, convex), ((x, y), size, r), d, &mut tally);
                    }
                }
            }
        }
        balanced(&tally, 1000);
    }
}

#[test]
fn on_all_scales() {
    for (seed, bits) in [(1, 8), (2, 14), (3, 20), (4, 24)] {
        all_scales(seed, bits, false);
    }
}

#[test]
fn capsules_on_all_scales() {
    for (seed, bits) in [(5, 8), (6, 14), (7, 20), (8, 24)] {
        all_scales(seed, bits, true);
    }
}

fn all_scales(seed: u64, bits: u32, is_capsule: bool) {
    let (mut r, mut tally) = (Random::new(seed), Tally::default());
    for _ in 0..cases(20_000) {
        let a = (1 << bits) - r.magnitude(1 << (bits - 1));
        let convex = r.one_in(2);
        let radius = 1 + if r.one_in(2) { r.below(a) } else { r.magnitude(2 * a) };
        let longest = if r.one_in(4) { 16 } else { 1 << (bits + 1) };
        let d = (r.sign() * r.magnitude(longest), r.sign() * r.magnitude(longest));
        // The centre on the arc of the sum or difference, or near an end of it.
        let rim = if convex { a + radius } else { (a - radius).max(0) };
        let angle = f64::from(r.below(1 << 20) as i32) / f64::from(1 << 20) * core::f64::consts::FRAC_PI_2;
        let there = match r.below(4) {
            0 => (rim, 0),
            1 => (0, rim),
            _ => ((rim as f64 * angle.cos()) as i64, (rim as f64 * angle.sin()) as i64),
        };
        let d = if r.one_in(4) {
            // Along the arc.
            let scale = longest as f64 / rim.max(1) as f64 * f64::from(r.sign() as i32);
            ((-there.1 as f64 * scale) as i64, (there.0 as f64 * scale) as i64)
        } else {
            d
        };
        let back = if r.one_in(3) { 0 } else { r.below(1 << 20) };
        let c = (there.0 - ((d.0 * back) >> 20) + r.around(1), there.1 - ((d.1 * back) >> 20) + r.around(1));
        let long = if is_capsule { 1 + r.magnitude(2 * a) } else { 0 };
        let size = if r.one_in(2) { (long, 0) } else { (0, long) };
        let c = if is_capsule && r.one_in(2) { (c.0 - size.0, c.1 - size.1) } else { c };
        check((a, convex), (c, size, radius), d, &mut tally);
    }
    balanced(&tally, cases(20_000) / 20);
}

/// Along a floor into a quarter pipe: the line touches the arc's inner disc in its end only. Out of
/// it again nothing is hit.
#[test]
fn a_tangent_floor() {
    let arc = feature(Geometry::Arc { centre: vec2((0, 0)), radius: 100, quadrant: Axis::new(1, 1), convex: false });
    let sweep = |c: P, d: P| circle(c, 40).sweep(raw(d), &arc);
    let entry = sweep((-50, 60), (100, 0)).unwrap();
    assert_eq!((entry.num, entry.den, entry.normal), (1 << 29, 1 << 30, Axis::NEG_Y));
    assert_eq!(sweep((0, 60), (3, 0)).unwrap().num, 0);
    assert!(sweep((0, 60), (-3, 0)).is_none());
    assert!(sweep((60, 0), (0, -9)).is_none());
    assert!(sweep((0, 60), (-3, 1)).is_some());
    assert!(sweep((0, 60), (-3, -1)).is_none());
    assert!(sweep((-50, 59), (100, 0)).is_some_and(|e| e.num > 1 << 29));
    assert!(sweep((-50, 60), (50, 0)).is_none());
}
