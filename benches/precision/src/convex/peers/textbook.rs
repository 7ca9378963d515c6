//! The textbook's formulas in four number formats.

use crate::convex::classes::Pair;
use crate::job::List;
use crate::pairs::truth::Answer;
use crate::peers::textbook::{Named, Shape as Of, contact, overlaps, vector};
use tilesat_judge::convex::shape::{Kind, Shape};
use tilesat_judge::oracle::figure::Point;
use tilesat_textbook::Scalar;
use tilesat_textbook::capsule::{Capsule, capsule_capsule, contact_capsule_capsule, distance_capsule_capsule};
use tilesat_textbook::polygon::{Polygon, contact_polygon_polygon, polygon_polygon};
use tilesat_textbook::shape::{Circle, Segment, Vector};
use tilesat_textbook::turned::{
    Turned, circle_turned, contact_circle_turned, contact_turned_turned, distance_circle_turned,
    distance_turned_turned, turned_turned,
};

impl<S: Scalar> Of<Shape> for Circle<S> {
    fn of(shape: &Shape) -> Self {
        let Shape::Circle { centre, radius } = *shape else { panic!("{shape:?} is no circle") };
        Self { c: vector(centre), r: S::of_raw(radius as i32) }
    }
}

impl<S: Scalar> Of<Shape> for Capsule<S> {
    fn of(shape: &Shape) -> Self {
        let Shape::Capsule { a, b, radius } = *shape else { panic!("{shape:?} is no capsule") };
        Self { core: Segment { a: vector(a), b: vector(b) }, r: S::of_raw(radius as i32) }
    }
}

impl<S: Scalar> Of<Shape> for Turned<S> {
    fn of(shape: &Shape) -> Self {
        let Shape::Turned { centre, half, direction: (x, y), .. } = *shape else { panic!("{shape:?} is no box") };
        let h = (x * x + y * y).isqrt();
        let (k, l) = (half.0 / h, half.1 / h);
        let part = |v: i64| S::of_int(v as i32) / S::of_int(h as i32);
        Self {
            c: vector(centre),
            along: vector((k * x, k * y)),
            across: vector((-l * y, l * x)),
            unit: Vector { x: part(x), y: part(y) },
            half: vector(half),
        }
    }
}

/// Outward normals of any length, for yes or no: without a rounding.
struct Plain<S>(Polygon<S, 4>);

impl<S: Scalar> Of<Shape> for Plain<S> {
    fn of(shape: &Shape) -> Self {
        let corners: Vec<Point> = shape.vertices();
        let at = |i: usize| corners[i % 4];
        let across = |i: usize| vector((at(i + 1).1 - at(i).1, at(i).0 - at(i + 1).0));
        Self(Polygon { corners: [0, 1, 2, 3].map(|i| vector(at(i))), normals: [0, 1, 2, 3].map(across) })
    }
}

/// The same with unit normals.
impl<S: Scalar> Of<Shape> for Polygon<S, 4> {
    fn of(shape: &Shape) -> Self {
        let Plain(plain) = Plain::<S>::of(shape);
        let unit = |n: Vector<S>| {
            let length = n.dot(n).root();
            Vector { x: n.x / length, y: n.y / length }
        };
        Self { normals: plain.normals.map(unit), ..plain }
    }
}

pub fn pairs<S: Named>(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, _) => {
            overlaps::<_, S, Circle<S>, Turned<S>>(list, circle_turned);
            contact::<_, S, Circle<S>, Turned<S>>(list, contact_circle_turned);
        }
        (Kind::Turned, _) => {
            overlaps::<_, S, Turned<S>, Turned<S>>(list, turned_turned);
            contact::<_, S, Turned<S>, Turned<S>>(list, contact_turned_turned);
        }
        (Kind::Polygon, _) => {
            overlaps::<_, S, Plain<S>, Plain<S>>(list, |a, b| polygon_polygon(&a.0, &b.0));
            contact::<_, S, Polygon<S, 4>, Polygon<S, 4>>(list, contact_polygon_polygon);
        }
        _ => {
            overlaps::<_, S, Capsule<S>, Capsule<S>>(list, capsule_capsule);
            contact::<_, S, Capsule<S>, Capsule<S>>(list, contact_capsule_capsule);
        }
    }
}

fn distance<S: Named, A: Of<Shape>, B: Of<Shape>>(
    list: &mut List<Pair, f64>,
    ask: impl Fn(&A, &B) -> S + Copy + 'static,
) {
    let shapes = |(a, b): &Pair| (A::of(a), B::of(b));
    list.add((S::NAME, "distance", S::FORMAT), shapes, move |(a, b)| ask(a, b), |d: &S| d.px());
}

pub fn distances<S: Named>(list: &mut List<Pair, f64>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, _) => distance::<S, Circle<S>, Turned<S>>(list, distance_circle_turned),
        (Kind::Turned, _) => distance::<S, Turned<S>, Turned<S>>(list, distance_turned_turned),
        _ => distance::<S, Capsule<S>, Capsule<S>>(list, distance_capsule_capsule),
    }
}
