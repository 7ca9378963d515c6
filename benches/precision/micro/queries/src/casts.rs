//! Motions of one shape toward another.

use crate::{At, Input, PVector, Place, Shape, four};
use parry2d::query::{ShapeCastHit, ShapeCastOptions, cast_shapes};

/// A moves by `d`. B stays.
pub struct Cast<A, B, V> {
    pub a: A,
    pub b: B,
    pub d: V,
}

impl<A: Shape, B: Shape, V: Place> Input for Cast<A, B, V> {
    fn of(words: &[i32]) -> Self {
        Self { a: A::of(&four(words, 0)), b: B::of(&four(words, 4)), d: V::of(words[8], words[9]) }
    }
}

/// The general query, which its users call.
pub fn sweep<A: parry2d::shape::Shape, B: parry2d::shape::Shape>(
    c: &Cast<At<A>, At<B>, PVector>,
) -> Option<ShapeCastHit> {
    let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
    cast_shapes(&c.a.0, c.d, &c.a.1, &c.b.0, PVector::ZERO, &c.b.1, options).ok().flatten()
}

/// Calls a macro for each cast: the row's keys, its input and answer, the call, and whether the
/// answer is a hit.
#[macro_export]
macro_rules! each_cast {
    ($each:ident) => {
        each_cast! { $each "cast: circle-circle", Circle, Circle, cast::circle_circle }
        each_cast! { $each "cast: circle-AABB", Circle, Aabb, cast::circle_aabb }
        each_cast! { $each "cast: circle-segment", Circle, Segment, cast::circle_segment }
        each_cast! { $each "cast: AABB-AABB", Aabb, Aabb, cast::aabb_aabb }
        // Without a heap it casts no boxes.
        $each! { "cast: circle-circle", "parry2d", "cast", Cast<At<Ball>, At<Ball>, PVector>, Option<ShapeCastHit>,
            |c| sweep(c), |o| o.is_some() }
        $each! { "cast: circle-circle", "parry2d (special)", "cast", Cast<At<Ball>, At<Ball>, PVector>, Option<ShapeCastHit>,
            |c| {
                let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
                details::cast_shapes_ball_ball(&c.a.0.inv_mul(&c.b.0), -c.d, &c.a.1, &c.b.1, options)
            }, |o| o.is_some() }
    };
    ($each:ident $workload:literal, $a:ident, $b:ident, $ask:expr) => {
        $each! { $workload, "tilesat", "would hit", Cast<tilesat::$a, tilesat::$b, tilesat::Vec2>, Result<bool, tilesat::RangeError>,
            |c| c.a.would_hit(&c.b, c.d, tilesat::Inside::Hit), |o| *o == Ok(true) }
        $each! { $workload, "tilesat", "cast", Cast<tilesat::$a, tilesat::$b, tilesat::Vec2>,
            Result<Option<tilesat::CastHit>, tilesat::RangeError>,
            |c| c.a.cast_shape(&c.b, c.d, tilesat::Inside::Hit), |o| matches!(o, Ok(Some(_))) }
        each_cast! { book $each $workload, "naive Q16.16", $a, $b, Q16, $ask }
        each_cast! { book $each $workload, "wide Q16.16", $a, $b, Wide, $ask }
        each_cast! { book $each $workload, "textbook f32", $a, $b, f32, $ask }
        each_cast! { book $each $workload, "textbook f64", $a, $b, f64, $ask }
    };
    (book $each:ident $workload:literal, $backend:literal, $a:ident, $b:ident, $s:ty, $ask:expr) => {
        $each! { $workload, $backend, "cast", Cast<book::$a<$s>, book::$b<$s>, book::Vector<$s>>, Option<$s>,
            |c| $ask(&c.a, &c.b, c.d), |o| o.is_some() }
    };
}
