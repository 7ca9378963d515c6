//! What is asked on microcontrollers: the same queries as on the host, one list for the counts and for the sizes.

pub use parry2d::bounding_volume::{Aabb as PAabb, BoundingVolume};
use parry2d::math::{Pose, Vector};
use parry2d::query;
pub use parry2d::query::{Contact, details};
pub use parry2d::shape::{Ball, Cuboid, Segment as PSegment};
pub use parry2d::utils::segments_intersection2d;
pub use tilesat::prelude::*;
use tilesat_textbook::Scalar;
pub use tilesat_textbook::{Q16, Wide, pair, shape as book};

pub type Raw = [i32; 4];

/// A shape from four words: a middle and a radius, two corners, or two ends.
pub trait Shape {
    fn of(raw: &Raw) -> Self;
}

fn legal<T, E>(made: Result<T, E>) -> T {
    match made {
        Ok(shape) => shape,
        Err(_) => panic!("inputs are in the domain"),
    }
}

impl Shape for tilesat::Circle {
    fn of(&[x, y, r, _]: &Raw) -> Self {
        legal(Self::new(tilesat::Vec2::from_raw(x, y), tilesat::Fx::from_bits(r)))
    }
}

impl Shape for tilesat::Aabb {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        legal(Self::new(tilesat::Vec2::from_raw(x, y), tilesat::Vec2::from_raw(z, w)))
    }
}

impl Shape for tilesat::Segment {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        legal(Self::new(tilesat::Vec2::from_raw(x, y), tilesat::Vec2::from_raw(z, w)))
    }
}

impl<S: Scalar> Shape for book::Circle<S> {
    fn of(&[x, y, r, _]: &Raw) -> Self {
        Self { c: book::Vector::of_raw(x, y), r: S::of_raw(r) }
    }
}

impl<S: Scalar> Shape for book::Aabb<S> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        Self { lo: book::Vector::of_raw(x, y), hi: book::Vector::of_raw(z, w) }
    }
}

impl<S: Scalar> Shape for book::Segment<S> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        Self { a: book::Vector::of_raw(x, y), b: book::Vector::of_raw(z, w) }
    }
}

/// A shape of the library with its place.
pub type At<T> = (Pose, T);

fn px(raw: i32) -> f32 {
    raw as f32 / 65536.0
}

impl Shape for At<Ball> {
    fn of(&[x, y, r, _]: &Raw) -> Self {
        (Pose::translation(px(x), px(y)), Ball::new(px(r)))
    }
}

impl Shape for At<Cuboid> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        let middle = Pose::translation((px(x) + px(z)) / 2.0, (px(y) + px(w)) / 2.0);
        (middle, Cuboid::new(Vector::new((px(z) - px(x)) / 2.0, (px(w) - px(y)) / 2.0)))
    }
}

impl Shape for At<PSegment> {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        (Pose::identity(), PSegment::new(Vector::new(px(x), px(y)), Vector::new(px(z), px(w))))
    }
}

impl Shape for PAabb {
    fn of(&[x, y, z, w]: &Raw) -> Self {
        Self::new(Vector::new(px(x), px(y)), Vector::new(px(z), px(w)))
    }
}

/// The general query: what its users call.
pub fn meets<A: parry2d::shape::Shape, B: parry2d::shape::Shape>(p: &(At<A>, At<B>)) -> bool {
    query::intersection_test(&p.0.0, &p.0.1, &p.1.0, &p.1.1).is_ok_and(|i| i.intersecting)
}

pub fn touching<A: parry2d::shape::Shape, B: parry2d::shape::Shape>(p: &(At<A>, At<B>)) -> Option<Contact> {
    query::contact(&p.0.0, &p.0.1, &p.1.0, &p.1.1, 0.0).ok().flatten()
}

/// Calls a macro for each query: the row's keys, the shapes of A and B, the answer and how it is asked.
macro_rules! each_query {
    ($each:ident) => {
        each_query! { pair $each "circle-circle", Circle, Circle, |p, q| pair::circle_circle(p, q), Ball, Ball }
        each_query! { pair $each "circle-AABB", Circle, Aabb, |p, q| pair::circle_aabb(p, q), Ball, Cuboid }
        each_query! { pair $each "circle-segment", Circle, Segment, |p, q| pair::circle_segment(p, q), Ball, PSegment }
        each_query! { pair $each "AABB-AABB", Aabb, Aabb, |p, q| pair::aabb_aabb(p, q), Cuboid, Cuboid }
        each_query! { pair $each "segment-AABB", Segment, Aabb, |p, q| pair::aabb_segment(q, p), PSegment, Cuboid }
        each_query! { pair $each "segment-segment", Segment, Segment, |p, q| pair::segment_segment(p, q), PSegment, PSegment }
        each_query! { contact $each "circle-circle", Circle, Circle, |p, q| pair::contact_circle_circle(p, q) }
        each_query! { contact $each "circle-AABB", Circle, Aabb, |p, q| pair::contact_circle_aabb(p, q) }
        each_query! { contact $each "circle-segment", Circle, Segment, |p, q| pair::contact_circle_segment(p, q) }
        each_query! { contact $each "AABB-AABB", Aabb, Aabb, |p, q| pair::contact_aabb_aabb(p, q) }
        each_query! { contact $each "segment-AABB", Segment, Aabb, |p, q| pair::contact_aabb_segment(q, p) }
        // Without a heap it has no contact of two boxes, of two segments or of a segment and a box.
        each_query! { general $each "circle-circle", Ball, Ball }
        each_query! { general $each "circle-AABB", Ball, Cuboid }
        each_query! { general $each "circle-segment", Ball, PSegment }
        $each! { "circle-circle", "parry2d (special)", "overlaps", At<Ball>, At<Ball>, bool,
            |p| details::intersection_test_ball_ball(p.0.0.inv_mul(&p.1.0).translation, &p.0.1, &p.1.1), |o| *o }
        $each! { "circle-circle", "parry2d (special)", "contact", At<Ball>, At<Ball>, Option<Contact>,
            |p| details::contact_ball_ball(&p.0.0.inv_mul(&p.1.0), &p.0.1, &p.1.1, 0.0), |o| o.is_some() }
        $each! { "circle-AABB", "parry2d (special)", "contact", At<Ball>, At<Cuboid>, Option<Contact>,
            |p| details::contact_ball_convex_polyhedron(&p.0.0.inv_mul(&p.1.0), &p.0.1, &p.1.1, 0.0), |o| o.is_some() }
        $each! { "circle-segment", "parry2d (special)", "contact", At<Ball>, At<PSegment>, Option<Contact>,
            |p| details::contact_ball_convex_polyhedron(&p.0.0.inv_mul(&p.1.0), &p.0.1, &p.1.1, 0.0), |o| o.is_some() }
        $each! { "AABB-AABB", "parry2d (special)", "overlaps", PAabb, PAabb, bool,
            |p| p.0.intersects(&p.1), |o| *o }
        $each! { "segment-AABB", "parry2d (special)", "overlaps", At<PSegment>, PAabb, bool,
            |p| details::intersection_test_aabb_segment(&p.1, &p.0.1), |o| *o }
        $each! { "segment-segment", "parry2d (special)", "overlaps", At<PSegment>, At<PSegment>, bool,
            |p| segments_intersection2d(p.0.1.a, p.0.1.b, p.1.1.a, p.1.1.b, 0.0).is_some(), |o| *o }
    };
    // The library, the textbook's formats, and the general test of parry2d.
    (pair $each:ident $workload:literal, $a:ident, $b:ident, |$p:ident, $q:ident| $ask:expr, $c:ident, $d:ident) => {
        $each! { $workload, "tilesat", "overlaps", tilesat::$a, tilesat::$b, bool, |p| p.0.overlaps(&p.1), |o| *o }
        $each! { $workload, "tilesat", "contact", tilesat::$a, tilesat::$b, Option<(tilesat::Fx, tilesat::UnitVec2)>,
            |p| p.0.contact(&p.1).map(|c| (c.depth(), c.normal())), |o| o.is_some() }
        $each! { $workload, "tilesat", "contact (lazy)", tilesat::$a, tilesat::$b, Option<tilesat::Contact>,
            |p| p.0.contact(&p.1), |o| o.is_some() }
        $each! { $workload, "naive Q16.16", "overlaps", book::$a<Q16>, book::$b<Q16>, bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "wide Q16.16", "overlaps", book::$a<Wide>, book::$b<Wide>, bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "textbook f32", "overlaps", book::$a<f32>, book::$b<f32>, bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "parry2d", "overlaps", At<$c>, At<$d>, bool, |p| meets(p), |o| *o }
    };
    (contact $each:ident $workload:literal, $a:ident, $b:ident, |$p:ident, $q:ident| $ask:expr) => {
        $each! { $workload, "naive Q16.16", "contact", book::$a<Q16>, book::$b<Q16>, Option<book::Contact<Q16>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
        $each! { $workload, "wide Q16.16", "contact", book::$a<Wide>, book::$b<Wide>, Option<book::Contact<Wide>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
        $each! { $workload, "textbook f32", "contact", book::$a<f32>, book::$b<f32>, Option<book::Contact<f32>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
    };
    (general $each:ident $workload:literal, $c:ident, $d:ident) => {
        $each! { $workload, "parry2d", "contact", At<$c>, At<$d>, Option<Contact>, |p| touching(p), |o| o.is_some() }
    };
}

pub(crate) use each_query;
