//! Whether a body meets a region anywhere on a straight way, exactly. The positions of a way are a
//! convex set, so no moment must be found.

use super::P;
use super::body::Body;
use crate::shapes::region::{Point, Region};

fn wide(p: P) -> Point {
    (p.0.into(), p.1.into())
}

fn add(a: Point, b: Point) -> Point {
    (a.0 + b.0, a.1 + b.1)
}

fn sub(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn dot(a: Point, b: Point) -> i128 {
    a.0 * b.0 + a.1 * b.1
}

fn cross(a: Point, b: Point) -> i128 {
    a.0 * b.1 - a.1 * b.0
}

/// Whether a body that moves by `d` has a point in the inside of a region at some moment. A body
/// without area is a raw unit larger on every side.
pub fn meets(region: &Region, body: Body, d: P) -> bool {
    if let Some(parts) = body.parts() {
        let has_area = |(lo, hi): (P, P)| lo.0 < hi.0 && lo.1 < hi.1;
        return parts.into_iter().any(|part| has_area(part.bounds()) && meets(region, part, d));
    }
    let (a, d) = (body.bounds(), wide(d));
    match (region, body) {
        (Region::Polygon(points), Body::Disc(c, r)) if r > 0 => near_polygon(points, wide(c), d, r.into()),
        (&Region::Arc { centre, far, outside }, Body::Disc(c, r)) if r > 0 => {
            let (frame, side) = frame(centre, far);
            near_arc(frame(wide(c), centre), frame(d, (0, 0)), r.into(), side, outside)
        }
        (Region::Polygon(points), _) => {
            let (lo, hi) = grown(a);
            apart_at(points, &swept(lo, hi, d), &[(1, 0), (0, 1), d], 0).is_none()
        }
        (&Region::Arc { centre, far, outside }, _) => {
            let (frame, side) = frame(centre, far);
            let (lo, hi) = grown(a);
            let (p, q) = (frame(lo, centre), frame(hi, centre));
            let (lo, hi) = ((p.0.min(q.0), p.1.min(q.1)), (p.0.max(q.0), p.1.max(q.1)));
            box_in_arc(lo, hi, frame(d, (0, 0)), side, outside)
        }
    }
}

fn grown((lo, hi): (P, P)) -> (Point, Point) {
    let more = i128::from(lo.0 == hi.0 || lo.1 == hi.1);
    (sub(wide(lo), (more, more)), add(wide(hi), (more, more)))
}

fn swept(lo: Point, hi: Point, d: Point) -> Vec<Point> {
    [lo, (hi.0, lo.1), hi, (lo.0, hi.1)].into_iter().flat_map(|p| [p, add(p, d)]).collect()
}

/// The frame in which an arc's centre is the origin and its cell the square from there to (side,
/// side).
fn frame(centre: Point, far: Point) -> (impl Fn(Point, Point) -> Point, i128) {
    let q = sub(far, centre);
    (move |p: Point, from: Point| ((p.0 - from.0) * q.0.signum(), (p.1 - from.1) * q.1.signum()), q.0.abs())
}

fn edges(points: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| (a, b))
}

/// A direction across which two convex sets are at least `gap` apart, of those across the polygon's
/// edges and across `ways`.
fn apart_at(polygon: &[Point], other: &[Point], ways: &[Point], gap: i128) -> Option<Point> {
    let normals = edges(polygon).map(|(a, b)| sub(b, a)).chain(ways.iter().copied()).map(|e| (-e.1, e.0));
    let span = |set: &[Point], n: Point| {
        let along = || set.iter().map(|&p| dot(p, n));
        (along().min().unwrap(), along().max().unwrap())
    };
    normals.filter(|&n| n != (0, 0)).find(|&n| {
        let ((a, b), (c, e)) = (span(polygon, n), span(other, n));
        b + gap <= c || e + gap <= a
    })
}

/// Whether the distance from a point to a segment is below `r`.
fn near_segment(p: Point, (a, b): (Point, Point), r: i128) -> bool {
    let (e, m) = (sub(b, a), sub(p, a));
    let square = |v: Point| dot(v, v);
    if dot(m, e) <= 0 {
        square(m) < r * r
    } else if dot(m, e) >= square(e) {
        square(sub(p, b)) < r * r
    } else {
        cross(e, m).pow(2) < r * r * square(e)
    }
}

fn near_polygon(points: &[Point], c: Point, d: Point, r: i128) -> bool {
    let end = add(c, d);
    let reaches = edges(points)
        .any(|edge| near_segment(c, edge, r) || near_segment(end, edge, r) || near_segment(edge.0, (c, end), r));
    // Along the way and the first edge too, for an edge on the line of the way.
    let first = points.get(1).map_or((0, 0), |&b| sub(b, points[0]));
    reaches || apart_at(points, &[c, end], &[d, (-d.1, d.0), (-first.1, first.0)], 1).is_none()
}

/// The moments at which a coordinate of `c + d t` is 0 or `side`, and the ends, as fractions.
fn moments(c: Point, d: Point, side: i128) -> Vec<(i128, i128)> {
    let across = |c: i128, d: i128| [(-c * d.signum(), d.abs()), ((side - c) * d.signum(), d.abs())];
    let all = across(c.0, d.0).into_iter().chain(across(c.1, d.1)).chain([(0, 1), (1, 1)]);
    let mut all: Vec<_> = all.filter(|&(num, den)| den > 0 && 0 <= num && num <= den).collect();
    all.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
    all
}

/// The place at a moment, times its divisor.
fn place(c: Point, d: Point, (num, den): (i128, i128)) -> Point {
    (c.0 * den + d.0 * num, c.1 * den + d.1 * num)
}

/// Whether a way comes nearer than `r` to the quarter disc of radius `side`, or to what is outside
/// of it in its square.
///
/// From a point in the quarter, the arc is as far as along the radius. From all others a straight
/// side, including its ends, is nearer.
fn near_arc(c: Point, d: Point, r: i128, side: i128, outside: bool) -> bool {
    let corner = if outside { (side, side) } else { (0, 0) };
    let straight = [(side, 0), (0, side)].map(|end| vec![corner, end]);
    if straight.iter().any(|edge| near_polygon(edge, c, d, r)) {
        return true;
    }
    let all = moments(c, d, side);
    let on = |p: Point, den: i128| p.0 >= 0 && p.1 >= 0 && (!outside || (p.0 <= side * den && p.1 <= side * den));
    let length = |p: Point| dot(p, p);
    let there = all.iter().map(|&t| (place(c, d, t), t.1)).filter(|&(p, den)| on(p, den));
    if outside {
        // The farthest place of a straight way is an end.
        return there.into_iter().any(|(p, den)| side < r || length(p) > ((side - r) * den).pow(2));
    }
    // The nearest is an end, or where the way is across the radius.
    let nearest = (-dot(c, d), dot(d, d));
    let turn = nearest.1 > 0 && 0 <= nearest.0 && nearest.0 <= nearest.1 && {
        // c - d (c.d) / d.d is -(c x d) (d.y, -d.x) / d.d: its quadrant is that of its signs.
        let turned = -cross(c, d);
        turned * -d.1 >= 0 && turned * d.0 >= 0 && cross(c, d).pow(2) < (side + r).pow(2) * nearest.1
    };
    turn || there.into_iter().any(|(p, den)| length(p) < ((side + r) * den).pow(2))
}

/// Whether a moving box has a point in the inside of the quarter disc, or of the part outside it
/// in its square.
///
/// Between two moments at which a side of the box passes one of the square, its nearest and its
/// farthest corner in the square go straight.
fn box_in_arc(lo: Point, hi: Point, d: Point, side: i128, outside: bool) -> bool {
    let mut all: Vec<_> = moments(lo, d, side).into_iter().chain(moments(hi, d, side)).collect();
    all.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
    all.windows(2).any(|pair| {
        let (s, t) = (pair[0], pair[1]);
        // The middle of the two moments decides for the time between them.
        let middle = (s.0 * t.1 + t.0 * s.1, 2 * s.1 * t.1);
        let (p, q, full) = (place(lo, d, middle), place(hi, d, middle), side * middle.1);
        if p.0 >= full || p.1 >= full || q.0 <= 0 || q.1 <= 0 {
            return false;
        }
        let corner = |at: (i128, i128)| {
            let (p, q) = (place(lo, d, at), place(hi, d, at));
            if outside { (q.0.min(side * at.1), q.1.min(side * at.1)) } else { (p.0.max(0), p.1.max(0)) }
        };
        let length = |p: Point| dot(p, p);
        if outside {
            return [s, t].into_iter().any(|at| length(corner(at)) > (side * at.1).pow(2));
        }
        // The part of the corner that moves between the two moments, and its position nearest to
        // the centre.
        let (moves_x, moves_y) = (p.0 > 0, p.1 > 0);
        let (c, e) = (
            (if moves_x { lo.0 } else { 0 }, if moves_y { lo.1 } else { 0 }),
            (if moves_x { d.0 } else { 0 }, if moves_y { d.1 } else { 0 }),
        );
        let turn = (-dot(c, e), dot(e, e));
        let within = turn.1 > 0 && s.0 * turn.1 <= turn.0 * s.1 && turn.0 * t.1 <= t.0 * turn.1;
        (within && cross(c, e).pow(2) < side * side * turn.1)
            || [s, t].into_iter().any(|at| length(corner(at)) < (side * at.1).pow(2))
    })
}
