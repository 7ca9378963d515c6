//! Bodies with sides in any direction as bare integers, so that other views of them can be made.

#![allow(clippy::cast_precision_loss, reason = "widths of bodies, compared with a margin")]

use super::ask;
use super::shape::{MOST, Shape, hull};
use crate::Random;
use crate::oracle::figure::Point;
use crate::rooms::view::View;
use tilesat::Vec2;
use tilesat::shape::AnyShape;

pub type Any = AnyShape<MOST>;

/// An oriented box, a slanted capsule or a polygon around a point, up to about `size` from it.
/// `None` if it would have no area.
pub fn figure(r: &mut Random, c: Point, size: i64) -> Option<Shape> {
    let size = 1 + r.magnitude(size);
    let near = |r: &mut Random| (c.0 + r.around(size), c.1 + r.around(size));
    Some(match r.below(4) {
        0 => {
            let half = (1 + r.magnitude(size), 1 + r.magnitude(size));
            let exact = [(3, 4), (1, 1), (1, 0), (-5, 12)][r.below(4) as usize];
            let any = (r.around(1 << 20) | 1, r.around(1 << 20));
            let radius = if r.one_in(2) { 0 } else { r.magnitude(size / 2) };
            Shape::Turned { centre: c, half, direction: if r.one_in(2) { exact } else { any }, radius }
        }
        1 => Shape::Capsule { a: near(r), b: near(r), radius: 1 + r.magnitude(size / 2) },
        kind => {
            let points: Vec<Point> = (0..r.within(3, MOST as i64)).map(|_| near(r)).collect();
            let corners = hull(&points);
            if corners.len() < 3 {
                return None;
            }
            Shape::polygon(&corners, if kind == 2 { 0 } else { r.magnitude(size / 2) })
        }
    })
}

/// The library's shape.
pub fn any(shape: &Shape) -> Any {
    match *shape {
        Shape::Capsule { a, b, radius } => ask::capsule(a, b, radius).into(),
        Shape::Turned { centre, half, direction, radius } => ask::turned(centre, half, direction, radius).into(),
        Shape::Polygon { points, count, radius } => ask::polygon(&points[..count], radius).into(),
        _ => panic!("no such body: {shape:?}"),
    }
}

/// A body in another view of its level.
pub fn seen(view: View, shape: &Shape) -> Shape {
    let by = if let View::Moved(by) = view { by } else { (0, 0) };
    let point = |p: Point| {
        let p = view.direction(p);
        (p.0 + by.0, p.1 + by.1)
    };
    shape.map(point, |d| view.direction(d))
}

/// The least width of a body in any direction, in raw units.
pub fn width(shape: &Shape) -> f64 {
    let corners = shape.vertices();
    let n = corners.len();
    let height = |p: Point, q: Point| {
        let e = ((q.0 - p.0) as f64, (q.1 - p.1) as f64);
        let across = |c: &Point| (e.0 * (c.1 - p.1) as f64 - e.1 * (c.0 - p.0) as f64).abs() / e.0.hypot(e.1).max(1.0);
        corners.iter().map(across).fold(0.0, f64::max)
    };
    (0..n).map(|i| height(corners[i], corners[(i + 1) % n])).fold(f64::MAX, f64::min) + 2.0 * shape.radius() as f64
}

/// How far a body went.
pub fn way(from: &Any, to: &Any) -> Point {
    let (p, q) = (raw(from.aabb().min()), raw(to.aabb().min()));
    (q.0 - p.0, q.1 - p.1)
}

pub fn raw(v: Vec2) -> Point {
    let (x, y) = v.raw();
    (x.into(), y.into())
}
