//! The library under test, called with figures.

use super::figure::{Figure, Point};
use tilesat::prelude::*;
use tilesat::{Aabb, Circle, Contact, Fx, Segment, Vec2};

pub fn vec2(p: Point) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

pub fn point(v: Vec2) -> Point {
    let (x, y) = v.raw();
    (i64::from(x), i64::from(y))
}

pub fn aabb(min: Point, max: Point) -> Aabb {
    Aabb::new(vec2(min), vec2(max)).expect("generators stay inside the domain")
}

pub fn circle(centre: Point, radius: i64) -> Circle {
    Circle::new(vec2(centre), Fx::from_bits(radius as i32)).expect("generators stay inside the domain")
}

pub fn segment(a: Point, b: Point) -> Segment {
    Segment::new(vec2(a), vec2(b)).expect("generators stay inside the domain")
}

/// Runs `$body` with `$x` the library's shape of a figure.
macro_rules! with_shape {
    ($figure:expr, |$x:ident| $body:expr) => {
        match *$figure {
            Figure::Aabb { min, max } => {
                let $x = aabb(min, max);
                $body
            }
            Figure::Circle { centre, radius } => {
                let $x = circle(centre, radius);
                $body
            }
            Figure::Segment { a, b } => {
                let $x = segment(a, b);
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

pub fn overlaps(a: &Figure, b: &Figure) -> bool {
    with_pair!(a, b, |x, y| x.overlaps(&y))
}

pub fn touches(a: &Figure, b: &Figure) -> bool {
    with_pair!(a, b, |x, y| x.touches(&y))
}

pub fn contact(a: &Figure, b: &Figure) -> Option<Contact> {
    with_pair!(a, b, |x, y| x.contact(&y))
}

pub fn contains(a: &Figure, b: &Figure) -> bool {
    with_pair!(a, b, |x, y| x.contains(&y))
}

pub fn contains_point(a: &Figure, p: Point) -> bool {
    with_shape!(a, |x| x.contains(&vec2(p)))
}

pub fn distance(a: &Figure, b: &Figure) -> i64 {
    i64::from(with_pair!(a, b, |x, y| x.distance(&y)).to_bits())
}

pub fn distance_to_point(a: &Figure, p: Point) -> i64 {
    i64::from(with_shape!(a, |x| x.distance(&vec2(p))).to_bits())
}

pub fn closest_point(a: &Figure, p: Point) -> Point {
    point(with_shape!(a, |x| x.closest_point(vec2(p))))
}

pub fn closest_points(a: &Figure, b: &Figure) -> Option<(Point, Point)> {
    with_pair!(a, b, |x, y| x.closest_points(&y)).map(|(p, q)| (point(p), point(q)))
}

/// The figure moved by the library. `None` if that leaves the domain.
pub fn translated(a: &Figure, by: Point) -> Option<Figure> {
    with_shape!(a, |x| x.translated(vec2(by)).ok().map(|moved| moved.figure()))
}

trait ToFigure {
    fn figure(&self) -> Figure;
}

impl ToFigure for Aabb {
    fn figure(&self) -> Figure {
        Figure::Aabb { min: point(self.min()), max: point(self.max()) }
    }
}

impl ToFigure for Circle {
    fn figure(&self) -> Figure {
        Figure::Circle { centre: point(self.centre()), radius: i64::from(self.radius().to_bits()) }
    }
}

impl ToFigure for Segment {
    fn figure(&self) -> Figure {
        Figure::Segment { a: point(self.a()), b: point(self.b()) }
    }
}
