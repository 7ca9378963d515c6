//! All verbs of all pairs of shapes.

use tilesat::prelude::*;
use tilesat::query::BoxColumns;
use tilesat::{Aabb, Circle, Inside, Segment, Vec2};

use super::VECTORS;
use super::family::Run;
use super::hash::Hash;
use super::random::{Class, Draw, any_motion, any_point, pair};

const VERBS: [&str; 10] = [
    "overlaps",
    "touches",
    "contact",
    "push_out",
    "contains",
    "distance",
    "closest_points",
    "cast_shape",
    "exact_toi",
    "cast_moving",
];

/// The queries that all shapes have about each other.
trait Verbs<B>:
    Overlaps<B> + Touches<B> + Contacts<B> + Contains<B> + Distance<B> + ClosestPoint<B> + CastShape<B> + Sized
{
}
impl<A, B> Verbs<B> for A where
    A: Overlaps<B> + Touches<B> + Contacts<B> + Contains<B> + Distance<B> + ClosestPoint<B> + CastShape<B>
{
}

/// Every verb once, in this order of the two.
#[inline(never)]
fn ask<A: Verbs<B>, B: Verbs<A>>(a: &A, b: &B, motion: Vec2, inside: Inside, hashes: &mut [Hash; VERBS.len()]) {
    let [overlaps, touches, contact, push_out, contains, distance, points, cast, exact, moving] = hashes;
    overlaps.add(a.overlaps(b));
    touches.add(a.touches(b));
    let found = a.contact(b);
    contact.add(found);
    push_out.add(found.map(|contact| contact.push_out()));
    contains.add(a.contains(b));
    distance.add(a.distance(b));
    points.add(a.closest_points(b));
    cast.add(a.would_hit(b, motion, inside));
    cast.add(a.cast_shape(b, motion, inside));
    exact.add(a.exact_toi(b, motion, inside));
    // B moves by the other half of the way, and a little aside.
    let (x, y) = motion.raw();
    let of_b = Vec2::from_raw(-x / 2 + (y >> 9), -y / 2);
    moving.add(a.cast_moving(motion, b, of_b, inside));
}

/// The six pairs have a fifth of the vectors each.
fn one<A: Draw + Verbs<B>, B: Draw + Verbs<A>>(run: &mut Run<'_>, of: &'static str) {
    run.family(of, VECTORS / 5, VERBS, |number, r, hashes| {
        let (a, b, motion) = pair::<A, B>(r, Class::of(number));
        let inside = if number & 8 == 0 { Inside::Hit } else { Inside::Ignore };
        // Both orders: the library has code for one of them.
        if number & 16 == 0 { ask(&a, &b, motion, inside, hashes) } else { ask(&b, &a, motion, inside, hashes) }
    });
}

/// A point and a shape, and a ray. Two fifths of the vectors for each of the three.
fn with_point<S>(run: &mut Run<'_>, of: &'static str, ask: impl Fn(&S, Vec2, Vec2, Inside, &mut [Hash; 4]))
where
    S: Draw + Contains<Vec2> + Distance<Vec2>,
{
    run.family(of, VECTORS * 2 / 5, ["contains", "distance", "closest_point", "cast_ray"], |number, r, hashes| {
        let class = Class::of(number);
        // Touching: the end of a segment that does is the point.
        let (shape, line, motion) = pair::<S, Segment>(r, class);
        let p = if number & 8 == 0 { line.a() } else { any_point(r, class, shape.place()) };
        let motion = if number & 16 == 0 { motion } else { any_motion(r, class, p, shape.place()) };
        hashes[0].add(shape.contains(&p));
        hashes[1].add(shape.distance(&p));
        ask(&shape, p, motion, if number & 32 == 0 { Inside::Hit } else { Inside::Ignore }, hashes);
    });
}

/// One box against up to eight in columns.
fn columns(run: &mut Run<'_>) {
    run.family("aabb-columns", VECTORS / 5, ["overlaps", "touches"], |number, r, [overlaps, touches]| {
        let (a, first, _) = pair::<Aabb, Aabb>(r, Class::of(number));
        let mut boxes = [first; 8];
        for b in &mut boxes[1..] {
            *b = pair::<Aabb, Aabb>(r, Class::of(number)).1;
        }
        let count = 1 + number as usize % boxes.len();
        if let Ok(columns) = BoxColumns::<8>::of(&boxes[..count]) {
            columns.overlaps(&a).into_iter().for_each(|answer| overlaps.add(answer));
            columns.touches(&a).into_iter().for_each(|answer| touches.add(answer));
        }
    });
}

pub(crate) fn run(run: &mut Run<'_>) {
    columns(run);
    one::<Aabb, Aabb>(run, "aabb-aabb");
    one::<Circle, Circle>(run, "circle-circle");
    one::<Segment, Segment>(run, "segment-segment");
    one::<Circle, Aabb>(run, "circle-aabb");
    one::<Circle, Segment>(run, "circle-segment");
    one::<Segment, Aabb>(run, "segment-aabb");
    with_point::<Aabb>(run, "aabb-point", |shape, p, motion, inside, [.., closest, ray]| {
        closest.add(shape.closest_point(p));
        ray.add(shape.cast_ray(p, motion, inside));
        ray.add(p.cast_shape(shape, motion, inside));
    });
    with_point::<Circle>(run, "circle-point", |shape, p, motion, inside, [.., closest, ray]| {
        closest.add(shape.closest_point(p));
        ray.add(shape.cast_ray(p, motion, inside));
        ray.add(p.cast_shape(shape, motion, inside));
        ray.add(p.exact_toi(shape, motion, inside));
    });
    with_point::<Segment>(run, "segment-point", |shape, p, motion, _, [.., closest, ray]| {
        closest.add(shape.closest_point(p));
        ray.add(shape.cast_ray(p, motion));
    });
}
