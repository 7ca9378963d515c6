//! The library, by its public interface, as a game calls it.

use crate::job::{Format, List};
use crate::pairs::truth::Answer;
use tilesat::prelude::*;
use tilesat::{Aabb, Circle, Contact, Fx, Segment, UnitVec2, Vec2};
use tilesat_judge::oracle::figure::Figure;

pub const NAME: &str = "tilesat";

/// A shape from a figure that is one.
pub trait Shape<F = Figure>: 'static {
    fn of(figure: &F) -> Self;
}

pub fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

impl Shape for Circle {
    fn of(figure: &Figure) -> Self {
        let Figure::Circle { centre, radius } = *figure else { panic!("{figure:?} is no circle") };
        Self::new(vec2(centre), Fx::from_bits(radius as i32)).expect("classes stay inside the domain")
    }
}

impl Shape for Aabb {
    fn of(figure: &Figure) -> Self {
        let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
        Self::new(vec2(min), vec2(max)).expect("classes stay inside the domain")
    }
}

impl Shape for Segment {
    fn of(figure: &Figure) -> Self {
        let Figure::Segment { a, b } = *figure else { panic!("{figure:?} is no segment") };
        Self::new(vec2(a), vec2(b)).expect("classes stay inside the domain")
    }
}

pub fn px(v: Fx) -> f64 {
    f64::from(v.to_bits()) / 65536.0
}

/// The parts of a contact that a game uses at once.
type Full = Option<(Fx, UnitVec2)>;

pub fn pairs<F: 'static, A, B>(list: &mut List<(F, F), Answer>)
where
    A: Shape<F> + Overlaps<B> + Contacts<B>,
    B: Shape<F>,
{
    let shapes = |(a, b): &(F, F)| (A::of(a), B::of(b));
    list.add((NAME, "overlaps", Format::RAW), shapes, |(a, b)| a.overlaps(b), |&hit| Answer { hit, depth: None });
    // Kept as it is. Those who need depth and normal compute them.
    list.add(
        (NAME, "contact (lazy)", Format::RAW),
        shapes,
        |(a, b)| a.contact(b),
        |c: &Option<Contact>| Answer { hit: c.is_some(), depth: c.map(|c| px(c.depth())) },
    );
    list.add(
        (NAME, "contact", Format::RAW),
        shapes,
        |(a, b)| a.contact(b).map(|c| c.depth_and_normal()),
        |c: &Full| Answer { hit: c.is_some(), depth: c.map(|c| px(c.0)) },
    );
}
