//! The library under test, called with shapes.

use super::shape::{MOST, Shape};
use crate::casts::ask::{Answer, Interval};
use crate::oracle::figure::Point;
use crate::oracle::kernel::{aabb, circle, point, segment, vec2};
use tilesat::prelude::*;
use tilesat::{
    Axis, Capsule, CastHit, Contact, ConvexPolygon, Fx, Inside, OrientedBox, RangeError,
    query::{Manifold, Separation},
};

pub fn capsule(a: Point, b: Point, radius: i64) -> Capsule {
    Capsule::new(vec2(a), vec2(b), Fx::from_bits(radius as i32)).expect("generators stay inside the domain")
}

pub fn turned(centre: Point, half: Point, direction: Point, radius: i64) -> OrientedBox {
    OrientedBox::new(vec2(centre), vec2(half), Axis::new(direction.0 as i32, direction.1 as i32))
        .and_then(|b| b.with_radius(Fx::from_bits(radius as i32)))
        .expect("generators stay inside the domain")
}

pub fn polygon(points: &[Point], radius: i64) -> ConvexPolygon<MOST> {
    let points: Vec<_> = points.iter().map(|p| vec2(*p)).collect();
    let polygon = ConvexPolygon::new(&points).expect("generators make convex polygons inside the domain");
    polygon.with_radius(Fx::from_bits(radius as i32)).expect("generators stay inside the domain")
}

/// Runs `$body` with `$x` the library's shape.
macro_rules! with_shape {
    ($shape:expr, |$x:ident| $body:expr) => {
        match *$shape {
            Shape::Aabb { min, max } => {
                let $x = aabb(min, max);
                $body
            }
            Shape::Circle { centre, radius } => {
                let $x = circle(centre, radius);
                $body
            }
            Shape::Segment { a, b } => {
                let $x = segment(a, b);
                $body
            }
            Shape::Capsule { a, b, radius } => {
                let $x = capsule(a, b, radius);
                $body
            }
            Shape::Turned { centre, half, direction, radius } => {
                let $x = turned(centre, half, direction, radius);
                $body
            }
            Shape::Polygon { points, count, radius } => {
                let $x = polygon(&points[..count], radius);
                $body
            }
        }
    };
}

macro_rules! with_pair {
    ($a:expr, $b:expr, |$x:ident, $y:ident| $body:expr) => {
        with_shape!($a, |$x| with_shape!($b, |$y| $body))
    };
}

pub fn overlaps(a: &Shape, b: &Shape) -> bool {
    with_pair!(a, b, |x, y| x.overlaps(&y))
}

pub fn touches(a: &Shape, b: &Shape) -> bool {
    with_pair!(a, b, |x, y| x.touches(&y))
}

pub fn distance(a: &Shape, b: &Shape) -> i64 {
    i64::from(with_pair!(a, b, |x, y| x.distance(&y)).to_bits())
}

pub fn contact(a: &Shape, b: &Shape) -> Option<Contact> {
    with_pair!(a, b, |x, y| x.contact(&y))
}

pub fn contains(a: &Shape, b: &Shape) -> bool {
    with_pair!(a, b, |x, y| x.contains(&y))
}

pub fn closest_points(a: &Shape, b: &Shape) -> Option<(Point, Point)> {
    with_pair!(a, b, |x, y| x.closest_points(&y)).map(|(p, q)| (point(p), point(q)))
}

pub fn manifold(a: &Shape, b: &Shape) -> Option<Manifold> {
    with_pair!(a, b, |x, y| x.manifold(&y))
}

/// Whether the shape contains a point, its distance, and the shape's nearest point.
pub fn about_point(a: &Shape, p: Point) -> (bool, i64, Point) {
    let p = vec2(p);
    with_shape!(a, |x| (x.contains(&p), i64::from(x.distance(&p).to_bits()), point(x.closest_point(p))))
}

pub fn cast(a: &Shape, b: &Shape, d: Point, inside: Inside) -> Result<Answer, RangeError> {
    let motion = vec2(d);
    with_pair!(a, b, |x, y| Ok(Answer {
        hit: x.cast_shape(&y, motion, inside)?,
        yes: x.would_hit(&y, motion, inside)?,
        exact: x.exact_toi(&y, motion, inside)?,
    }))
}

pub fn interval(a: &Shape, b: &Shape, d: Point) -> Interval {
    with_pair!(a, b, |x, y| x.contact_interval(&y, vec2(d)))
}

pub fn cast_ray(shape: &Shape, origin: Point, d: Point, inside: Inside) -> Option<CastHit> {
    let (o, d) = (vec2(origin), vec2(d));
    match *shape {
        Shape::Aabb { min, max } => aabb(min, max).cast_ray(o, d, inside),
        Shape::Circle { centre, radius } => circle(centre, radius).cast_ray(o, d, inside),
        Shape::Segment { a, b } => segment(a, b).cast_ray(o, d),
        Shape::Capsule { a, b, radius } => capsule(a, b, radius).cast_ray(o, d, inside),
        Shape::Turned { centre, half, direction, radius } => {
            turned(centre, half, direction, radius).cast_ray(o, d, inside)
        }
        Shape::Polygon { points, count, radius } => polygon(&points[..count], radius).cast_ray(o, d, inside),
    }
    .expect("generators stay inside the domain")
}

/// With a hint. Plain shapes among themselves have none.
pub fn overlaps_from(first: &Shape, second: &Shape, last: &mut Separation) -> bool {
    match *first {
        Shape::Capsule { a, b, radius } => {
            let x = capsule(a, b, radius);
            with_shape!(second, |y| x.overlaps_from(&y, last))
        }
        Shape::Turned { centre, half, direction, radius } => {
            let x = turned(centre, half, direction, radius);
            with_shape!(second, |y| x.overlaps_from(&y, last))
        }
        Shape::Polygon { points, count, radius } => {
            let x = polygon(&points[..count], radius);
            with_shape!(second, |y| x.overlaps_from(&y, last))
        }
        _ => panic!("no hint for {first:?}"),
    }
}
