//! Bodies with sides in any direction against quarter discs and quarter pipes, exactly. What a body
//! sweeps is a convex polygon grown by the radius, as against polygons. Its part in the quadrant of
//! the arc tells whether that overlaps the solid.

use super::arcs::outline;
use super::convex::{Figure, Tally, crosses, figures, hull, judge};
use super::polygons::{Big, Wide, near, point_near, zero};
use super::std::{println, vec::Vec};
use super::{P, Random, cases, enough};

/// A rational point: both coordinates over a positive weight.
#[derive(Clone)]
struct Weighted {
    p: Wide,
    w: Big,
}

/// The part of a polygon with `n . p >= k`.
fn clipped(polygon: &[Weighted], n: P, k: &Big) -> Vec<Weighted> {
    let height = |p: &Weighted| &p.p.0 * n.0 + &p.p.1 * n.1 - k * &p.w;
    let mut out = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        let (h, g) = (height(p), height(q));
        if h >= zero() {
            out.push(p.clone());
        }
        if (h > zero() && g < zero()) || (h < zero() && g > zero()) {
            // The heights of both ends cancel each other.
            let (h, g) = (Big::from(h.magnitude().clone()), Big::from(g.magnitude().clone()));
            let mix = |a: &Big, b: &Big| a * &g + b * &h;
            out.push(Weighted { p: (mix(&p.p.0, &q.p.0), mix(&p.p.1, &q.p.1)), w: mix(&p.w, &q.w) });
        }
    }
    out
}

/// `p x q`, times both weights.
fn cross(p: &Weighted, q: &Weighted) -> Big {
    &p.p.0 * &q.p.1 - &p.p.1 * &q.p.0
}

/// Whether the corners of a convex polygon do not lie on one line.
fn has_area(polygon: &[Weighted]) -> bool {
    let [a, rest @ ..] = polygon else { return false };
    rest.windows(2).any(|e| &a.w * cross(&e[0], &e[1]) + &e[1].w * cross(a, &e[0]) != &e[0].w * cross(a, &e[1]))
}

/// Whether a convex polygon, perhaps a segment or a point, comes nearer to the origin than `r`.
fn comes_within(polygon: &[Weighted], r: &Big) -> bool {
    let n = polygon.len();
    let sides = || (0..n).map(|i| (&polygon[i], &polygon[(i + 1) % n]));
    let edge_near = |(p, q): (&Weighted, &Weighted)| {
        let of = |p: &Weighted, w: &Big| (&p.p.0 * w, &p.p.1 * w);
        let r = r * &p.w * &q.w;
        point_near(&(zero(), zero()), &of(p, &q.w), &of(q, &p.w), &(&r * &r))
    };
    (has_area(polygon) && sides().all(|(p, q)| cross(p, q) >= zero())) || sides().any(edge_near)
}

/// Whether a corner is farther from the origin than `r`.
fn goes_beyond(polygon: &[Weighted], r: &Big) -> bool {
    *r < zero() && !polygon.is_empty()
        || polygon.iter().any(|p| &p.p.0 * &p.p.0 + &p.p.1 * &p.p.1 > r * r * &p.w * &p.w)
}

/// Whether the motion `num / den` of the way overlaps the solid at an arc of radius `a`.
///
/// Of what comes to be over the arc, the point nearest to the centre decides, of a pipe the
/// farthest one. All else is nearer to the straight sides.
fn enters((a, convex): (i64, bool), body: &Figure, d: P, num: i64, den: i64) -> bool {
    let big = |p: P| (Big::from(p.0) * den, Big::from(p.1) * den);
    let moved = |p: P| (Big::from(p.0) * den + Big::from(d.0) * num, Big::from(p.1) * den + Big::from(d.1) * num);
    let swept = hull(body.corners.iter().flat_map(|&p| [big(p), moved(p)]).collect());
    let whole: Vec<_> = swept.iter().map(|p| Weighted { p: p.clone(), w: Big::from(1) }).collect();
    let (rim, r) = (Big::from(a) * den, Big::from(body.r) * den);
    let quadrant = clipped(&clipped(&whole, (1, 0), &zero()), (0, 1), &zero());
    let over = if convex { quadrant } else { clipped(&clipped(&quadrant, (-1, 0), &-&rim), (0, -1), &-&rim) };
    let meets_arc = if convex { comes_within(&over, &(&rim + &r)) } else { goes_beyond(&over, &(&rim - &r)) };
    if body.r == 0 {
        return meets_arc && has_area(&over);
    }
    let sides = if convex { [((0, 0), (a, 0)), ((0, 0), (0, a))] } else { [((a, 0), (a, a)), ((0, a), (a, a))] };
    let n = swept.len();
    meets_arc
        || sides.iter().any(|side| {
            let (p, q) = (big(side.0), big(side.1));
            crosses(&swept, &p, &q) || (0..n).any(|k| near((&swept[k], &swept[(k + 1) % n]), (&p, &q), &(&r * &r)))
        })
}

fn check(arc: (i64, bool), body: &Figure, d: P, tally: &mut Tally) {
    if d != (0, 0) && !enters(arc, body, (0, 0), 0, 1) {
        let enters = |body: &Figure, d: P, num: i64, den: i64| enters(arc, body, d, num, den);
        judge(&outline(arc.0, arc.1), &enters, body, d, tally);
    }
}

fn balanced(tally: &Tally, few: u64) {
    println!("{tally:?}");
    assert!(enough(tally.round > few && tally.hits - tally.round > few && tally.misses > few), "{tally:?}");
    assert!(enough(tally.aside <= tally.hits / 25) && tally.stays <= tally.aside, "{tally:?}");
}

/// Small figures around arcs of radius 5 and 10 (3-4-5), on a lattice.
#[test]
fn lattice() {
    let mut r = Random::new(41);
    let figures = figures();
    for convex in [true, false] {
        let mut tally = Tally::default();
        for _ in 0..cases(20_000) {
            let a = if r.one_in(2) { 5 } else { 10 };
            let body = &figures[r.below(figures.len() as i64) as usize];
            let body = body.at((r.within(-10, 12), r.within(-10, 12)));
            check((a, convex), &body, (r.around(9), r.around(9)), &mut tally);
        }
        balanced(&tally, cases(20_000) / 100);
    }
}

#[test]
fn on_all_scales() {
    let mut r = Random::new(42);
    let figures = figures();
    for bits in [8, 14, 20, 24] {
        for convex in [true, false] {
            let mut tally = Tally::default();
            for _ in 0..cases(4_000) {
                let a = (1 << bits) - r.magnitude(1 << (bits - 1));
                let by = 1 + r.magnitude(a / 4);
                let figure = &figures[r.below(figures.len() as i64) as usize];
                let slack = (r.around(2), r.around(2));
                let corners =
                    figure.corners.iter().map(|p| (p.0 * by + slack.0, p.1 * by + slack.1)).collect::<Vec<_>>();
                let body = Figure { corners, r: figure.r * by };
                let longest = if r.one_in(4) { 16 } else { 1 << (bits + 1) };
                let d = (r.sign() * r.magnitude(longest), r.sign() * r.magnitude(longest));
                // A corner reaches the arc, or near an end of it.
                let angle = f64::from(r.below(1 << 20) as i32) / f64::from(1 << 20) * core::f64::consts::FRAC_PI_2;
                let there = match r.below(4) {
                    0 => (a, 0),
                    1 => (0, a),
                    _ => ((a as f64 * angle.cos()) as i64, (a as f64 * angle.sin()) as i64),
                };
                let own = body.corners[r.below(body.corners.len() as i64) as usize];
                let back = if r.one_in(3) { 0 } else { r.below(1 << 20) };
                let part = |c: i64| (c * back) >> 20;
                let by = (there.0 - own.0 - part(d.0) + r.around(1), there.1 - own.1 - part(d.1) + r.around(1));
                check((a, convex), &body.at(by), d, &mut tally);
            }
            balanced(&tally, cases(4_000) / 200);
        }
    }
}
