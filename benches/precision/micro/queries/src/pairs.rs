//! Pairs of shapes.

use crate::At;
use parry2d::math::Pose;
use parry2d::query::{self, Contact};

/// The general query, which its users call.
pub fn meets<A: parry2d::shape::Shape, B: parry2d::shape::Shape>(p: &(At<A>, At<B>)) -> bool {
    query::intersection_test(&p.0.0, &p.0.1, &p.1.0, &p.1.1).is_ok_and(|i| i.intersecting)
}

pub fn touching<A: parry2d::shape::Shape, B: parry2d::shape::Shape>(p: &(At<A>, At<B>)) -> Option<Contact> {
    query::contact(&p.0.0, &p.0.1, &p.1.0, &p.1.1, 0.0).ok().flatten()
}

/// The position of the first relative to the second. Nothing is rotated.
pub fn seen<A, B>(p: &(At<A>, At<B>)) -> Pose {
    Pose::from_translation(p.0.0.translation - p.1.0.translation)
}

/// Calls a macro for each query of a pair: the row's keys, its input and answer, the call, and
/// whether the answer is yes.
#[macro_export]
macro_rules! each_pair {
    ($each:ident) => {
        each_pair! { pair $each "circle-circle", Circle, Circle, |p, q| pair::circle_circle(p, q), Ball, Ball }
        each_pair! { pair $each "circle-AABB", Circle, Aabb, |p, q| pair::circle_aabb(p, q), Ball, Cuboid }
        each_pair! { pair $each "circle-segment", Circle, Segment, |p, q| pair::circle_segment(p, q), Ball, PSegment }
        each_pair! { pair $each "AABB-AABB", Aabb, Aabb, |p, q| pair::aabb_aabb(p, q), Cuboid, Cuboid }
        each_pair! { pair $each "segment-AABB", Segment, Aabb, |p, q| pair::aabb_segment(q, p), PSegment, Cuboid }
        each_pair! { pair $each "segment-segment", Segment, Segment, |p, q| pair::segment_segment(p, q), PSegment, PSegment }
        each_pair! { contact $each "circle-circle", Circle, Circle, |p, q| pair::contact_circle_circle(p, q) }
        each_pair! { contact $each "circle-AABB", Circle, Aabb, |p, q| pair::contact_circle_aabb(p, q) }
        each_pair! { contact $each "circle-segment", Circle, Segment, |p, q| pair::contact_circle_segment(p, q) }
        each_pair! { contact $each "AABB-AABB", Aabb, Aabb, |p, q| pair::contact_aabb_aabb(p, q) }
        each_pair! { contact $each "segment-AABB", Segment, Aabb, |p, q| pair::contact_aabb_segment(q, p) }
        // Without a heap it has no contact of two boxes, two segments, or a segment and a box.
        each_pair! { general $each "circle-circle", Ball, Ball }
        each_pair! { general $each "circle-AABB", Ball, Cuboid }
        each_pair! { general $each "circle-segment", Ball, PSegment }
        $each! { "circle-circle", "parry2d (special)", "overlaps", (At<Ball>, At<Ball>), bool,
            |p| details::intersection_test_ball_ball(seen(p).translation, &p.0.1, &p.1.1), |o| *o }
        $each! { "circle-circle", "parry2d (special)", "contact", (At<Ball>, At<Ball>), Option<Contact>,
            |p| details::contact_ball_ball(&seen(p), &p.1.1, &p.0.1, 0.0), |o| o.is_some() }
        $each! { "circle-AABB", "parry2d (special)", "overlaps", (At<Ball>, At<Cuboid>), bool,
            |p| details::intersection_test_point_query_ball(&seen(p), &p.1.1, &p.0.1).intersecting, |o| *o }
        $each! { "circle-AABB", "parry2d (special)", "contact", (At<Ball>, At<Cuboid>), Option<Contact>,
            |p| details::contact_convex_polyhedron_ball(&seen(p), &p.1.1, &p.0.1, 0.0), |o| o.is_some() }
        $each! { "circle-segment", "parry2d (special)", "overlaps", (At<Ball>, At<PSegment>), bool,
            |p| details::intersection_test_point_query_ball(&seen(p), &p.1.1, &p.0.1).intersecting, |o| *o }
        $each! { "circle-segment", "parry2d (special)", "contact", (At<Ball>, At<PSegment>), Option<Contact>,
            |p| details::contact_convex_polyhedron_ball(&seen(p), &p.1.1, &p.0.1, 0.0), |o| o.is_some() }
        $each! { "AABB-AABB", "parry2d (special)", "overlaps", (PAabb, PAabb), bool,
            |p| p.0.intersects(&p.1), |o| *o }
        $each! { "segment-AABB", "parry2d (special)", "overlaps", (At<PSegment>, PAabb), bool,
            |p| details::intersection_test_aabb_segment(&p.1, &p.0.1), |o| *o }
        $each! { "segment-segment", "parry2d (special)", "overlaps", (At<PSegment>, At<PSegment>), bool,
            |p| segments_intersection2d(p.0.1.a, p.0.1.b, p.1.1.a, p.1.1.b, 0.0).is_some(), |o| *o }
    };
    // The library, the textbook's formats, and the general test of parry2d.
    (pair $each:ident $workload:literal, $a:ident, $b:ident, |$p:ident, $q:ident| $ask:expr, $c:ident, $d:ident) => {
        $each! { $workload, "tilesat", "overlaps", (tilesat::$a, tilesat::$b), bool, |p| p.0.overlaps(&p.1), |o| *o }
        $each! { $workload, "tilesat", "contact", (tilesat::$a, tilesat::$b), Option<(tilesat::Fx, tilesat::UnitVec2)>,
            |p| p.0.contact(&p.1).map(|c| (c.depth(), c.normal())), |o| o.is_some() }
        $each! { $workload, "tilesat", "contact (lazy)", (tilesat::$a, tilesat::$b), Option<tilesat::Contact>,
            |p| p.0.contact(&p.1), |o| o.is_some() }
        $each! { $workload, "naive Q16.16", "overlaps", (book::$a<Q16>, book::$b<Q16>), bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "wide Q16.16", "overlaps", (book::$a<Wide>, book::$b<Wide>), bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "textbook f32", "overlaps", (book::$a<f32>, book::$b<f32>), bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "textbook f64", "overlaps", (book::$a<f64>, book::$b<f64>), bool, |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| *o }
        $each! { $workload, "parry2d", "overlaps", (At<$c>, At<$d>), bool, |p| meets(p), |o| *o }
    };
    (contact $each:ident $workload:literal, $a:ident, $b:ident, |$p:ident, $q:ident| $ask:expr) => {
        $each! { $workload, "naive Q16.16", "contact", (book::$a<Q16>, book::$b<Q16>), Option<book::Contact<Q16>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
        $each! { $workload, "wide Q16.16", "contact", (book::$a<Wide>, book::$b<Wide>), Option<book::Contact<Wide>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
        $each! { $workload, "textbook f32", "contact", (book::$a<f32>, book::$b<f32>), Option<book::Contact<f32>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
        $each! { $workload, "textbook f64", "contact", (book::$a<f64>, book::$b<f64>), Option<book::Contact<f64>>,
            |p| { let ($p, $q) = (&p.0, &p.1); $ask }, |o| o.is_some() }
    };
    (general $each:ident $workload:literal, $c:ident, $d:ident) => {
        $each! { $workload, "parry2d", "contact", (At<$c>, At<$d>), Option<Contact>, |p| touching(p), |o| o.is_some() }
    };
}
