//! The same questions with big rationals and other methods: parameters of crossing points, interval
//! clipping, distances between features, projections. They check the judge.

use super::figure::{Figure, Point};
use super::fraction::Fraction as Q;
use num_rational::BigRational;

type V = (Q, Q);

fn q(n: i64) -> Q {
    Q::whole(n)
}

fn v(p: Point) -> V {
    (q(p.0), q(p.1))
}

fn minus(a: &V, b: &V) -> V {
    (&a.0 - &b.0, &a.1 - &b.1)
}

fn dot(a: &V, b: &V) -> Q {
    &a.0 * &b.0 + &a.1 * &b.1
}

fn cross(a: &V, b: &V) -> Q {
    &a.0 * &b.1 - &a.1 * &b.0
}

/// A core: a box keeps its intervals, a segment its ends; a point is a segment of equal ends.
enum Core {
    Rect(V, V),
    Line(V, V),
}

fn core(f: &Figure) -> Core {
    match *f {
        // A flat box is a segment.
        Figure::Aabb { min, max } if min.0 == max.0 || min.1 == max.1 => Core::Line(v(min), v(max)),
        Figure::Aabb { min, max } => Core::Rect(v(min), v(max)),
        Figure::Segment { a, b } => Core::Line(v(a), v(b)),
        Figure::Circle { centre, .. } => Core::Line(v(centre), v(centre)),
    }
}

fn corners(c: &Core) -> Vec<V> {
    match c {
        Core::Line(a, b) => vec![a.clone(), b.clone()],
        Core::Rect(a, b) => {
            vec![a.clone(), (b.0.clone(), a.1.clone()), b.clone(), (a.0.clone(), b.1.clone())]
        }
    }
}

fn sides(c: &Core) -> Vec<(V, V)> {
    let p = corners(c);
    (0..p.len()).map(|i| (p[i].clone(), p[(i + 1) % p.len()].clone())).collect()
}

/// Squared distance from a point to a segment, by the clamped parameter of the foot.
fn to_segment(p: &V, (a, b): &(V, V)) -> Q {
    let e = minus(b, a);
    let square = dot(&e, &e);
    let t = if square == q(0) { q(0) } else { (dot(&minus(p, a), &e) / square).clamp(q(0), q(1)) };
    let d = minus(p, &(&a.0 + &e.0 * &t, &a.1 + &e.1 * &t));
    dot(&d, &d)
}

/// The parameters `t` in 0..=1 at which a segment is inside a box, `None` if it never is; with
/// `strict`, its open interior.
fn clip(a: &V, b: &V, lo: &V, hi: &V, strict: bool) -> bool {
    let e = minus(b, a);
    let (mut from, mut to) = (q(0), q(1));
    let mut open = false;
    for (p, d, l, h) in [(&a.0, &e.0, &lo.0, &hi.0), (&a.1, &e.1, &lo.1, &hi.1)] {
        if *d == q(0) {
            let outside = if strict { p <= l || p >= h } else { p < l || p > h };
            if outside {
                return false;
            }
            continue;
        }
        let (t, u) = ((l - p) / d, (h - p) / d);
        let (t, u) = if t < u { (t, u) } else { (u, t) };
        // An open interval that only meets an end of 0..=1 from outside is empty.
        if strict && (u <= q(0) || t >= q(1)) {
            return false;
        }
        open = true;
        from = from.max(t);
        to = to.min(u);
    }
    if strict && open { from < to } else { from <= to }
}

/// Segments cross in one point interior to both (`strict`), or share any point of a crossing of
/// their lines.
fn cross_lines(a: &(V, V), b: &(V, V), strict: bool) -> bool {
    let (e, f) = (minus(&a.1, &a.0), minus(&b.1, &b.0));
    let det = cross(&e, &f);
    if det == q(0) {
        return false;
    }
    let w = minus(&b.0, &a.0);
    let (t, u) = (cross(&w, &f) / &det, cross(&w, &e) / &det);
    let inside = |x: &Q| if strict { *x > q(0) && *x < q(1) } else { *x >= q(0) && *x <= q(1) };
    inside(&t) && inside(&u)
}

fn cores_meet(a: &Core, b: &Core, strict: bool) -> bool {
    match (a, b) {
        (Core::Rect(al, ah), Core::Rect(bl, bh)) => {
            if strict {
                al.0 < bh.0 && bl.0 < ah.0 && al.1 < bh.1 && bl.1 < ah.1
            } else {
                al.0 <= bh.0 && bl.0 <= ah.0 && al.1 <= bh.1 && bl.1 <= ah.1
            }
        }
        (Core::Rect(lo, hi), Core::Line(p, r)) | (Core::Line(p, r), Core::Rect(lo, hi)) => clip(p, r, lo, hi, strict),
        (Core::Line(p, r), Core::Line(s, t)) => {
            cross_lines(&(p.clone(), r.clone()), &(s.clone(), t.clone()), strict)
                || (!strict && square_apart(a, b) == q(0))
        }
    }
}

/// The least squared distance between a corner of one and a side of the other.
fn square_apart(a: &Core, b: &Core) -> Q {
    let mut best: Option<Q> = None;
    for (x, y) in [(a, b), (b, a)] {
        for p in corners(x) {
            for s in sides(y) {
                let d = to_segment(&p, &s);
                best = Some(best.map_or_else(|| d.clone(), |old| old.min(d.clone())));
            }
        }
    }
    best.unwrap_or_else(|| q(0))
}

/// Squared distance between the cores.
pub fn square_distance(a: &Figure, b: &Figure) -> BigRational {
    least_square(a, b).reduced()
}

fn least_square(a: &Figure, b: &Figure) -> Q {
    let (a, b) = (core(a), core(b));
    if cores_meet(&a, &b, false) { q(0) } else { square_apart(&a, &b) }
}

pub fn overlaps(a: &Figure, b: &Figure) -> bool {
    let r = q(a.radius() + b.radius());
    if r == q(0) { cores_meet(&core(a), &core(b), true) } else { least_square(a, b) < &r * &r }
}

pub fn touches(a: &Figure, b: &Figure) -> bool {
    let r = q(a.radius() + b.radius());
    least_square(a, b) <= &r * &r
}

/// For cores that overlap strictly: the squared shortest way out, over the normals of all sides.
pub fn square_exit(a: &Figure, b: &Figure) -> Option<BigRational> {
    let (a, b) = (core(a), core(b));
    if !cores_meet(&a, &b, true) {
        return None;
    }
    let mut best: Option<Q> = None;
    for side in sides(&a).into_iter().chain(sides(&b)) {
        let e = minus(&side.1, &side.0);
        let n = (q(0) - &e.1, e.0);
        let square = dot(&n, &n);
        if square == q(0) {
            continue;
        }
        let most = |c: &Core| corners(c).iter().map(|p| dot(p, &n)).max();
        let least = |c: &Core| corners(c).iter().map(|p| dot(p, &n)).min();
        for way in [most(&a)? - least(&b)?, most(&b)? - least(&a)?] {
            let exit = &way * &way / &square;
            best = Some(best.map_or_else(|| exit.clone(), |old| old.min(exit.clone())));
        }
    }
    best.map(Q::reduced)
}

/// Every corner of `b` is at least its radius inside of `a`.
pub fn contains(a: &Figure, b: &Figure) -> bool {
    let (inner, r) = (corners(&core(b)), q(b.radius()));
    match *a {
        Figure::Aabb { min, max } => {
            let (lo, hi) = (v(min), v(max));
            let (lo, hi) = ((lo.0 + &r, lo.1 + &r), (hi.0 - &r, hi.1 - &r));
            inner.iter().all(|p| p.0 >= lo.0 && p.1 >= lo.1 && p.0 <= hi.0 && p.1 <= hi.1)
        }
        Figure::Circle { centre, radius } => {
            let (c, room) = (v(centre), q(radius) - &r);
            room >= q(0) && inner.iter().all(|p| to_segment(p, &(c.clone(), c.clone())) <= &room * &room)
        }
        Figure::Segment { a, b } => r == q(0) && inner.iter().all(|p| to_segment(p, &(v(a), v(b))) == q(0)),
    }
}
