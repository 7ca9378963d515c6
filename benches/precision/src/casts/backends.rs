//! The backends that cast shapes.

use super::classes::Case;
use super::truth::Answer;
use crate::job::{Format, List};
use crate::peers::textbook::{Named, Shape as Book, vector};
use crate::peers::{box2d, chipmunk, ours};
use boxdd_sys::ffi::{
    b2CastOutput, b2MakeProxy, b2Rot, b2ShapeCast, b2ShapeCastPairInput, b2ShapeProxy, b2Transform, b2Vec2,
};
use chipmunk_sys::{cpSegmentQueryInfo, cpShapeSegmentQuery, cpv};
use std::ptr;
use tilesat::prelude::*;
use tilesat::{CastHit, Inside, RangeError};
use tilesat_judge::oracle::figure::{Figure, Kind};
use tilesat_textbook::shape::{Aabb, Circle, Segment, Vector};
use tilesat_textbook::{Q16, Wide, cast};

pub fn all(kinds: (Kind, Kind)) -> List<Case, Answer> {
    let mut list = List(Vec::new());
    {
        use tilesat::{Aabb, Circle, Segment};
        match kinds {
            (Kind::Circle, Kind::Circle) => library::<Circle, Circle>(&mut list),
            (Kind::Circle, Kind::Segment) => library::<Circle, Segment>(&mut list),
            (Kind::Circle, _) => library::<Circle, Aabb>(&mut list),
            _ => library::<Aabb, Aabb>(&mut list),
        }
    }
    textbook::<Q16>(&mut list, kinds);
    textbook::<Wide>(&mut list, kinds);
    textbook::<f32>(&mut list, kinds);
    textbook::<f64>(&mut list, kinds);
    single::casts(&mut list, kinds);
    double::casts(&mut list, kinds);
    by_box2d(&mut list);
    if kinds.0 == Kind::Circle {
        by_chipmunk(&mut list);
    }
    list
}

fn library<A: ours::Shape + CastShape<B>, B: ours::Shape>(list: &mut List<Case, Answer>) {
    let format = Format::Parts(f64::from(1 << 30));
    let shapes = |c: &Case| (A::of(&c.a), B::of(&c.b), ours::vec2(c.d));
    list.add(
        (ours::NAME, "would hit", format),
        shapes,
        |(a, b, d)| a.would_hit(b, *d, Inside::Hit),
        |hit: &Result<bool, RangeError>| Answer { hit: *hit == Ok(true), toi: None },
    );
    list.add(
        (ours::NAME, "cast", format),
        shapes,
        |(a, b, d)| a.cast_shape(b, *d, Inside::Hit),
        |hit: &Result<Option<CastHit>, RangeError>| {
            let hit = hit.ok().flatten();
            Answer { hit: hit.is_some(), toi: hit.map(|h| f64::from(h.toi.raw()) / f64::from(1 << 30)) }
        },
    );
}

fn told<S: Named, A: Book, B: Book>(
    list: &mut List<Case, Answer>,
    ask: impl Fn(&A, &B, Vector<S>) -> Option<S> + Copy + 'static,
) {
    list.add(
        (S::NAME, "cast", S::FORMAT),
        |c: &Case| (A::of(&c.a), B::of(&c.b), vector::<S>(c.d)),
        move |(a, b, d)| ask(a, b, *d),
        |t: &Option<S>| Answer { hit: t.is_some(), toi: t.map(S::px) },
    );
}

fn textbook<S: Named>(list: &mut List<Case, Answer>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, Kind::Circle) => told::<S, Circle<S>, Circle<S>>(list, cast::circle_circle),
        (Kind::Circle, Kind::Segment) => told::<S, Circle<S>, Segment<S>>(list, cast::circle_segment),
        (Kind::Circle, _) => told::<S, Circle<S>, Aabb<S>>(list, cast::circle_aabb),
        _ => told::<S, Aabb<S>, Aabb<S>>(list, cast::aabb_aabb),
    }
}

macro_rules! parry {
    ($module:ident, $parry:ident, $name:literal) => {
        mod $module {
            use super::super::classes::Case;
            use super::super::truth::Answer;
            use crate::job::List;
            use crate::peers::parry::$module::{FORMAT, Placed, vector};
            use tilesat_judge::oracle::figure::Kind;
            use $parry::math::Vector;
            use $parry::query::{ShapeCastHit, ShapeCastOptions, cast_shapes};
            use $parry::shape::{Ball, Cuboid, Segment};

            fn of<A: Placed, B: Placed>(list: &mut List<Case, Answer>) {
                list.add(
                    ($name, "cast", FORMAT),
                    |c: &Case| (A::of(&c.a), B::of(&c.b), vector(c.d)),
                    |((p, a), (q, b), d)| {
                        let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
                        cast_shapes(p, *d, a, q, Vector::ZERO, b, options).ok().flatten()
                    },
                    |hit: &Option<ShapeCastHit>| Answer {
                        hit: hit.is_some(),
                        toi: hit.map(|h| f64::from(h.time_of_impact)),
                    },
                );
            }

            pub fn casts(list: &mut List<Case, Answer>, kinds: (Kind, Kind)) {
                match kinds {
                    (Kind::Circle, Kind::Circle) => of::<Ball, Ball>(list),
                    (Kind::Circle, Kind::Segment) => of::<Ball, Segment>(list),
                    (Kind::Circle, _) => of::<Ball, Cuboid>(list),
                    _ => of::<Cuboid, Cuboid>(list),
                }
            }
        }
    };
}

parry!(single, parry2d, "parry2d");
parry!(double, parry2d_f64, "parry2d-f64");

/// Corners around the middle, which is the position.
fn proxy(figure: &Figure) -> (b2Vec2, b2ShapeProxy) {
    let (points, middle, radius) = match *figure {
        Figure::Circle { centre, radius } => (vec![(0, 0)], (centre.0 * 2, centre.1 * 2), radius),
        Figure::Aabb { min, max } => {
            let (w, h) = (max.0 - min.0, max.1 - min.1);
            (vec![(-w, -h), (w, -h), (w, h), (-w, h)], (min.0 + max.0, min.1 + max.1), 0)
        }
        Figure::Segment { a, b } => {
            let (w, h) = (b.0 - a.0, b.1 - a.1);
            (vec![(-w, -h), (w, h)], (a.0 + b.0, a.1 + b.1), 0)
        }
    };
    let halved = |(x, y): (i64, i64)| b2Vec2 { x: box2d::length(x as f64 / 2.0), y: box2d::length(y as f64 / 2.0) };
    let points: Vec<b2Vec2> = points.into_iter().map(halved).collect();
    // SAFETY: the count is correct, and it copies the points.
    let proxy = unsafe { b2MakeProxy(points.as_ptr(), points.len() as i32, box2d::length(radius as f64)) };
    (halved(middle), proxy)
}

fn by_box2d(list: &mut List<Case, Answer>) {
    list.add(
        (box2d::NAME, "cast", Format::F32),
        |c: &Case| {
            let ((p, a), (q, b)) = (proxy(&c.a), proxy(&c.b));
            // It moves B.
            b2ShapeCastPairInput {
                proxyA: b,
                proxyB: a,
                transform: b2Transform { p: b2Vec2 { x: p.x - q.x, y: p.y - q.y }, q: b2Rot { c: 1.0, s: 0.0 } },
                translationB: box2d::vector(c.d),
                maxFraction: 1.0,
                canEncroach: false,
            }
        },
        // SAFETY: a valid reference.
        |input| unsafe { b2ShapeCast(input) },
        |out: &b2CastOutput| Answer { hit: out.hit, toi: out.hit.then(|| f64::from(out.fraction)) },
    );
}

/// A segment with a radius against a shape.
fn by_chipmunk(list: &mut List<Case, Answer>) {
    list.add(
        (chipmunk::NAME, "cast", Format::F64),
        |c: &Case| {
            let Figure::Circle { centre, radius } = c.a else { panic!("no such cast") };
            let end = (centre.0 + c.d.0, centre.1 + c.d.1);
            let (from, to) = (chipmunk::vector(centre), chipmunk::vector(end));
            (chipmunk::Shape::of(&c.b), from, to, chipmunk::length(radius as f64))
        },
        |(shape, from, to, radius)| {
            let nothing = cpv(0.0, 0.0);
            let mut info = cpSegmentQueryInfo { shape: ptr::null(), point: nothing, normal: nothing, alpha: 1.0 };
            // SAFETY: the shape lives as long as the loop, and the answer's memory is valid.
            let hit = unsafe { cpShapeSegmentQuery(shape.0, *from, *to, *radius, &mut info) };
            (hit != 0, info.alpha)
        },
        |&(hit, t)| Answer { hit, toi: hit.then_some(t) },
    );
}
