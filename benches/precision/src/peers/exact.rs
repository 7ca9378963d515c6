//! Exact integers without filters.

use crate::job::{Format, List};
use crate::pairs::classes::Pair;
use crate::pairs::truth::Answer;
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_textbook::exact::{Aabb, Circle, Point as Raw, Segment};

pub const NAME: &str = "exact (no filters)";

pub trait Shape: 'static {
    fn of(figure: &Figure) -> Self;
}

fn raw((x, y): Point) -> Raw {
    Raw { x: x as i32, y: y as i32 }
}

impl Shape for Circle {
    fn of(figure: &Figure) -> Self {
        let Figure::Circle { centre, radius } = *figure else { panic!("{figure:?} is no circle") };
        Self { c: raw(centre), r: radius as i32 }
    }
}

impl Shape for Aabb {
    fn of(figure: &Figure) -> Self {
        let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
        Self { lo: raw(min), hi: raw(max) }
    }
}

impl Shape for Segment {
    fn of(figure: &Figure) -> Self {
        let Figure::Segment { a, b } = *figure else { panic!("{figure:?} is no segment") };
        Self { a: raw(a), b: raw(b) }
    }
}

pub fn overlaps<A: Shape, B: Shape>(list: &mut List<Pair, Answer>, ask: impl Fn(&A, &B) -> bool + Copy + 'static) {
    let shapes = |(a, b): &Pair| (A::of(a), B::of(b));
    let answer = |&hit: &bool| Answer { hit, depth: None };
    list.add((NAME, "overlaps", Format::RAW), shapes, move |(a, b)| ask(a, b), answer);
}
