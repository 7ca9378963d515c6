//! The contact of a body with one feature, from the definitions. Decisions use 128 bits,
//! measurements floating point.

#![allow(clippy::cast_precision_loss, reason = "compared with a margin: coordinates below 2^30 keep 22 bits below one")]

use super::judge::Body;
use tilesat::{
    Axis, Vec2,
    world::{Feature, Geometry},
};

type Point = (i128, i128);

fn wide(v: Vec2) -> Point {
    (v.raw().0.into(), v.raw().1.into())
}

fn of(p: (i64, i64)) -> Point {
    (p.0.into(), p.1.into())
}

fn axis(a: Axis) -> Point {
    (a.x.into(), a.y.into())
}

fn sub(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn dot(a: Point, b: Point) -> i128 {
    a.0 * b.0 + a.1 * b.1
}

fn length(a: Point) -> f64 {
    (a.0 as f64).hypot(a.1 as f64)
}

/// The expected contact.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    pub depth: f64,
    pub normal: (f64, f64),
    /// Whether the body is in the feature's region.
    pub in_region: bool,
}

fn expected(depth: f64, normal: Point) -> Expected {
    let n = length(normal);
    Expected { depth, normal: (normal.0 as f64 / n, normal.1 as f64 / n), in_region: true }
}

/// The corners of a box.
fn corners(lo: Point, hi: Point) -> [Point; 4] {
    [lo, (hi.0, lo.1), hi, (lo.0, hi.1)]
}

/// Whether the segment passes the inside of the box: the box's corners are on both sides of it, and
/// neither axis separates them.
fn crosses(lo: Point, hi: Point, a: Point, b: Point) -> bool {
    let apart = |lo: i128, hi: i128, a: i128, b: i128| a.max(b) <= lo || a.min(b) >= hi;
    let e = sub(b, a);
    let sides = corners(lo, hi).map(|p| (e.0 * (p.1 - a.1) - e.1 * (p.0 - a.0)).signum());
    !apart(lo.0, hi.0, a.0, b.0) && !apart(lo.1, hi.1, a.1, b.1) && sides.contains(&1) && sides.contains(&-1)
}

/// The box cut to the quadrant of an arc, in the arc's frame: least and largest coordinates from
/// the centre.
fn in_frame(lo: Point, hi: Point, c: Point, q: Point) -> (Point, Point) {
    let frame = corners(lo, hi).map(|p| ((p.0 - c.0) * q.0, (p.1 - c.1) * q.1));
    let (xs, ys) = (frame.map(|p| p.0), frame.map(|p| p.1));
    ((*xs.iter().min().unwrap(), *ys.iter().min().unwrap()), (*xs.iter().max().unwrap(), *ys.iter().max().unwrap()))
}

impl Expected {
    /// The contact, if there is one. `middle` is the body's, and `behind` says whether it is in the
    /// solid.
    pub fn of(feature: &Feature, body: Body, middle: (i64, i64), behind: bool) -> Option<Self> {
        match body {
            Body::Circle { c, r } => Self::of_circle(feature, of(c), r.into(), behind),
            Body::Box { lo, hi } => Self::of_box(feature, of(lo), of(hi), of(middle), behind),
        }
    }

    fn of_circle(feature: &Feature, c: Point, r: i128, behind: bool) -> Option<Self> {
        match feature.geometry {
            Geometry::Face { a, dir, len, .. } => {
                let (a, d) = (wide(a), axis(dir));
                let b = (a.0 + d.0 * i128::from(len), a.1 + d.1 * i128::from(len));
                let n = (d.1, -d.0);
                let front = dot(n, sub(c, a));
                let out = expected(r as f64 - front as f64 / length(n), n);
                // Behind its line, beyond an end that the disc covers: where no other feature
                // counts.
                if dot(d, sub(c, a)) < 0 || dot(d, sub(c, b)) > 0 {
                    let covers = [a, b].iter().any(|&p| dot(sub(c, p), sub(c, p)) < r * r);
                    let counts = behind && front <= 0 && covers;
                    return counts.then_some(Self { in_region: false, ..out });
                }
                if front * front >= r * r * dot(d, d) {
                    return None;
                }
                if front < 0 && !behind { None } else { Some(out) }
            }
            Geometry::Vertex { p, e_in, e_out } => {
                let m = sub(c, wide(p));
                let near = dot(m, m) < r * r;
                let cone = dot(m, axis(e_in)) > 0 && dot(m, axis(e_out)) < 0;
                if near && cone { Some(expected(r as f64 - length(m), m)) } else { None }
            }
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let (m, q, s) = (sub(c, wide(centre)), axis(quadrant), i128::from(radius));
                let d2 = dot(m, m);
                let meets = d2 < (s + r).pow(2) && (r > s || d2 > (s - r).pow(2));
                let front = if convex { d2 >= s * s } else { d2 <= s * s };
                if m.0 * q.0 < 0 || m.1 * q.1 < 0 || !meets || (!front && !behind) {
                    return None;
                }
                let gap = if convex { length(m) - s as f64 } else { s as f64 - length(m) };
                let out = if m == (0, 0) { q } else { m };
                Some(expected(r as f64 - gap, if convex { out } else { (-out.0, -out.1) }))
            }
            _ => panic!("another feature"),
        }
    }

    fn of_box(feature: &Feature, lo: Point, hi: Point, middle: Point, behind: bool) -> Option<Self> {
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                let (a, d) = (wide(a), axis(dir));
                let b = (a.0 + d.0 * i128::from(len), a.1 + d.1 * i128::from(len));
                let n = (d.1, -d.0);
                if !crosses(lo, hi, a, b) || (!behind && dot(n, sub(middle, a)) < 0) {
                    return None;
                }
                let deepest = corners(lo, hi).into_iter().min_by_key(|&p| dot(n, p)).unwrap();
                // Along x and y a side is deepest, not a corner.
                let slope = d.0 != 0 && d.1 != 0;
                let before = slope && dot(d, sub(deepest, a)) < 0 && !joined[0];
                let after = slope && dot(d, sub(deepest, b)) > 0 && !joined[1];
                let all = expected(-(dot(n, sub(deepest, a)) as f64) / length(n), n);
                Some(Self { in_region: !before && !after, ..all })
            }
            Geometry::Vertex { p, e_in, e_out } => {
                let p = wide(p);
                if !(lo.0 < p.0 && p.0 < hi.0 && lo.1 < p.1 && p.1 < hi.1) {
                    return None;
                }
                let exits = [((1, 0), p.0 - lo.0), ((-1, 0), hi.0 - p.0), ((0, 1), p.1 - lo.1), ((0, -1), hi.1 - p.1)];
                let allowed = exits.into_iter().filter(|&(n, _)| {
                    dot(n, axis(e_in)) > 0 && dot(n, axis(e_out)) < 0 && (behind || dot(n, sub(middle, p)) >= 0)
                });
                let (n, depth) = allowed.min_by_key(|&(_, depth)| depth)?;
                Some(expected(depth as f64, n))
            }
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let (c, q, s) = (wide(centre), axis(quadrant), i128::from(radius));
                let (near, far) = in_frame(lo, hi, c, q);
                let (m, _) = in_frame(middle, middle, c, q);
                let first = (near.0.max(0), near.1.max(0));
                if far.0 <= 0 || far.1 <= 0 || dot(first, first) >= s * s || dot(far, far) <= s * s {
                    return None;
                }
                let quadrant = m.0 >= 0 && m.1 >= 0;
                let level = |v: Point| (v.0 * q.0, v.1 * q.1);
                if !convex {
                    let front = !quadrant || dot(m, m) <= s * s;
                    return if front || behind {
                        Some(expected(length(far) - s as f64, level((-far.0, -far.1))))
                    } else {
                        None
                    };
                }
                // From beside the quadrant only its ends are visible. From inside the disc nothing
                // is.
                let ends = [(s - near.0, (1, 0), m.0 >= s), (s - near.1, (0, 1), m.1 >= s)];
                let end = |in_sight: bool| ends.into_iter().filter(|e| !in_sight || e.2).min_by_key(|e| e.0);
                if !quadrant && !behind {
                    let (depth, n, _) = end(true)?;
                    return Some(expected(depth as f64, level(n)));
                }
                if !behind && dot(m, m) < s * s {
                    None
                } else if near.0 > 0 && near.1 > 0 {
                    Some(expected(s as f64 - length(near), level(near)))
                } else {
                    let (depth, n, _) = end(false)?;
                    Some(expected(depth as f64, level(n)))
                }
            }
            _ => panic!("another feature"),
        }
    }

    /// Whether a pushed body no longer overlaps the feature, or cannot be pushed off it.
    pub fn is_clear(feature: &Feature, body: Body) -> bool {
        match (feature.geometry, body) {
            (Geometry::Arc { radius, convex: false, .. }, Body::Circle { r, .. }) if r >= i64::from(radius) => true,
            (Geometry::Face { a, dir, len, .. }, Body::Box { lo, hi }) => {
                let (a, d) = (wide(a), axis(dir));
                !crosses(of(lo), of(hi), a, (a.0 + d.0 * i128::from(len), a.1 + d.1 * i128::from(len)))
            }
            (Geometry::Vertex { p, .. }, Body::Box { lo, hi }) => {
                let (p, lo, hi) = (wide(p), of(lo), of(hi));
                p.0 <= lo.0 || p.0 >= hi.0 || p.1 <= lo.1 || p.1 >= hi.1
            }
            // The contact itself sees the rest, also from behind.
            _ => Self::of(feature, body, (0, 0), true).is_none(),
        }
    }
}
