//! The textbook's formulas in four number formats.

use crate::job::{Format, List};
use crate::pairs::truth::Answer;
use tilesat_judge::oracle::figure::Figure;
use tilesat_textbook::Scalar;
use tilesat_textbook::shape::{Aabb, Circle, Contact, Segment, Vector};

/// A number format with its names.
pub trait Named: Scalar {
    const NAME: &'static str;
    const FORMAT: Format;
}

impl Named for f32 {
    const NAME: &'static str = "textbook f32";
    const FORMAT: Format = Format::F32;
}

impl Named for f64 {
    const NAME: &'static str = "textbook f64";
    const FORMAT: Format = Format::F64;
}

impl Named for tilesat_textbook::Q16 {
    const NAME: &'static str = "naive Q16.16";
    const FORMAT: Format = Format::RAW;
}

impl Named for tilesat_textbook::Wide {
    const NAME: &'static str = "wide Q16.16";
    const FORMAT: Format = Format::RAW;
}

pub trait Shape<F = Figure>: 'static {
    fn of(figure: &F) -> Self;
}

pub fn vector<S: Scalar>((x, y): (i64, i64)) -> Vector<S> {
    Vector::of_raw(x as i32, y as i32)
}

impl<S: Scalar> Shape for Circle<S> {
    fn of(figure: &Figure) -> Self {
        let Figure::Circle { centre, radius } = *figure else { panic!("{figure:?} is no circle") };
        Self { c: vector(centre), r: S::of_raw(radius as i32) }
    }
}

impl<S: Scalar> Shape for Aabb<S> {
    fn of(figure: &Figure) -> Self {
        let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
        Self { lo: vector(min), hi: vector(max) }
    }
}

impl<S: Scalar> Shape for Segment<S> {
    fn of(figure: &Figure) -> Self {
        let Figure::Segment { a, b } = *figure else { panic!("{figure:?} is no segment") };
        Self { a: vector(a), b: vector(b) }
    }
}

/// A yes or no of some shapes.
pub fn overlaps<F: 'static, S: Named, A: Shape<F>, B: Shape<F>>(
    list: &mut List<(F, F), Answer>,
    ask: impl Fn(&A, &B) -> bool + Copy + 'static,
) {
    let shapes = |(a, b): &(F, F)| (A::of(a), B::of(b));
    let answer = |&hit: &bool| Answer { hit, depth: None };
    list.add((S::NAME, "overlaps", S::FORMAT), shapes, move |(a, b)| ask(a, b), answer);
}

/// Depth and normal of some shapes.
pub fn contact<F: 'static, S: Named, A: Shape<F>, B: Shape<F>>(
    list: &mut List<(F, F), Answer>,
    ask: impl Fn(&A, &B) -> Option<Contact<S>> + Copy + 'static,
) {
    let shapes = |(a, b): &(F, F)| (A::of(a), B::of(b));
    let answer = |c: &Option<Contact<S>>| Answer { hit: c.is_some(), depth: c.map(|c| c.depth.px()) };
    list.add((S::NAME, "contact", S::FORMAT), shapes, move |(a, b)| ask(a, b), answer);
}
