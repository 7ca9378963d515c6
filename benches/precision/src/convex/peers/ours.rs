//! The library, by its public interface.

use crate::convex::classes::Pair;
use crate::job::{Format, List};
use crate::pairs::truth::Answer;
use crate::peers::ours::{NAME, Shape as Of, pairs as of, px, vec2};
use tilesat::prelude::*;
use tilesat::{Axis, Capsule, Circle, ConvexPolygon, Fx, OrientedBox};
use tilesat_judge::convex::shape::{Kind, Shape};

fn fx(raw: i64) -> Fx {
    Fx::from_bits(raw as i32)
}

impl Of<Shape> for Circle {
    fn of(shape: &Shape) -> Self {
        let Shape::Circle { centre, radius } = *shape else { panic!("{shape:?} is no circle") };
        Self::new(vec2(centre), fx(radius)).expect("classes stay inside the domain")
    }
}

impl Of<Shape> for Capsule {
    fn of(shape: &Shape) -> Self {
        let Shape::Capsule { a, b, radius } = *shape else { panic!("{shape:?} is no capsule") };
        Self::new(vec2(a), vec2(b), fx(radius)).expect("classes stay inside the domain")
    }
}

impl Of<Shape> for OrientedBox {
    fn of(shape: &Shape) -> Self {
        let Shape::Turned { centre, half, direction, .. } = *shape else { panic!("{shape:?} is no box") };
        let direction = Axis::new(direction.0 as i32, direction.1 as i32);
        Self::new(vec2(centre), vec2(half), direction).expect("classes stay inside the domain")
    }
}

impl Of<Shape> for ConvexPolygon<4> {
    fn of(shape: &Shape) -> Self {
        let corners: Vec<_> = shape.vertices().into_iter().map(vec2).collect();
        Self::new(&corners).expect("classes make convex polygons inside the domain")
    }
}

pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, _) => of::<_, Circle, OrientedBox>(list),
        (Kind::Turned, _) => of::<_, OrientedBox, OrientedBox>(list),
        (Kind::Polygon, _) => of::<_, ConvexPolygon<4>, ConvexPolygon<4>>(list),
        _ => of::<_, Capsule, Capsule>(list),
    }
}

fn distance<A: Of<Shape> + Distance<B>, B: Of<Shape>>(list: &mut List<Pair, f64>) {
    let shapes = |(a, b): &Pair| (A::of(a), B::of(b));
    list.add((NAME, "distance", Format::RAW), shapes, |(a, b)| a.distance(b), |d| px(*d));
}

pub fn distances(list: &mut List<Pair, f64>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, _) => distance::<Circle, OrientedBox>(list),
        (Kind::Turned, _) => distance::<OrientedBox, OrientedBox>(list),
        _ => distance::<Capsule, Capsule>(list),
    }
}
