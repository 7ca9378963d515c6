//! Box2D, in C and f32: its manifold functions, and its distance for yes or no.

use super::local::Local;
use crate::convex::classes::Pair;
use crate::job::{Format, List};
use crate::pairs::truth::Answer;
use crate::peers::box2d::{NAME, answer, length};
use boxdd_sys::ffi::{
    b2Capsule, b2Circle, b2CollideCapsules, b2CollidePolygonAndCircle, b2CollidePolygons, b2ComputeHull,
    b2DistanceInput, b2LocalManifold, b2MakeBox, b2MakePolygon, b2MakeProxy, b2Polygon, b2Rot, b2SegmentDistance,
    b2ShapeDistance, b2ShapeProxy, b2SimplexCache, b2Transform, b2Vec2,
};
use std::ptr;
use tilesat_judge::convex::shape::{Kind, Shape};

const NONE: b2Rot = b2Rot { c: 1.0, s: 0.0 };

fn vector((x, y): (f64, f64)) -> b2Vec2 {
    b2Vec2 { x: length(x), y: length(y) }
}

fn corners(shape: &Shape) -> Vec<b2Vec2> {
    Local::of(shape).corners.into_iter().map(vector).collect()
}

/// A shape around its middle, and its position.
trait Placed: 'static {
    fn of(shape: &Shape) -> Self;

    fn at(shape: &Shape) -> b2Transform {
        b2Transform { p: vector(Local::of(shape).middle), q: NONE }
    }
}

impl Placed for b2Circle {
    fn of(shape: &Shape) -> Self {
        Self { center: b2Vec2 { x: 0.0, y: 0.0 }, radius: length(shape.radius() as f64) }
    }
}

impl Placed for b2Capsule {
    fn of(shape: &Shape) -> Self {
        let ends = corners(shape);
        Self { center1: ends[0], center2: ends[1], radius: length(shape.radius() as f64) }
    }
}

/// A box turns by its position.
impl Placed for b2Polygon {
    fn of(shape: &Shape) -> Self {
        // SAFETY, both: plain numbers in, a plain value out.
        if let Shape::Turned { half, .. } = *shape {
            return unsafe { b2MakeBox(length(half.0 as f64), length(half.1 as f64)) };
        }
        let corners = corners(shape);
        unsafe { b2MakePolygon(&b2ComputeHull(corners.as_ptr(), corners.len() as i32), 0.0) }
    }

    fn at(shape: &Shape) -> b2Transform {
        let p = vector(Local::of(shape).middle);
        let Shape::Turned { .. } = *shape else { return b2Transform { p, q: NONE } };
        let turned = Local::turned(shape);
        b2Transform { p, q: b2Rot { c: turned.cos as f32, s: turned.sin as f32 } }
    }
}

/// Its inline function of that name.
#[inline]
fn inv_mul_transforms(a: &b2Transform, b: &b2Transform) -> b2Transform {
    let (d, q) = (b2Vec2 { x: b.p.x - a.p.x, y: b.p.y - a.p.y }, a.q);
    b2Transform {
        p: b2Vec2 { x: q.c * d.x + q.s * d.y, y: q.c * d.y - q.s * d.x },
        q: b2Rot { s: q.c * b.q.s - q.s * b.q.c, c: q.c * b.q.c + q.s * b.q.s },
    }
}

type Both<A, B> = ((b2Transform, A), (b2Transform, B));

fn shapes<A: Placed, B: Placed>((a, b): &Pair) -> Both<A, B> {
    ((A::at(a), A::of(a)), (B::at(b), B::of(b)))
}

fn contact<A: Placed, B: Placed>(
    list: &mut List<Pair, Answer>,
    collide: impl Fn(&Both<A, B>) -> b2LocalManifold + Copy + 'static,
) {
    list.add((NAME, "contact", Format::F32), shapes::<A, B>, collide, answer);
}

/// The corners of a shape around its middle. Those of a box do not turn: its position does.
fn proxy<A: Placed>(shape: &Shape) -> (b2Transform, b2ShapeProxy) {
    let corners = match *shape {
        Shape::Turned { half: (w, h), .. } => {
            let corner = |x: i64, y: i64| vector(((x * w) as f64, (y * h) as f64));
            vec![corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)]
        }
        _ => corners(shape),
    };
    // SAFETY: the count is correct, and it copies the points.
    let proxy = unsafe { b2MakeProxy(corners.as_ptr(), corners.len() as i32, length(shape.radius() as f64)) };
    (A::at(shape), proxy)
}

type Proxies = ((b2Transform, b2ShapeProxy), (b2Transform, b2ShapeProxy));

fn proxies<A: Placed, B: Placed>((a, b): &Pair) -> Proxies {
    (proxy::<A>(a), proxy::<B>(b))
}

#[inline]
fn gap(((p, a), (q, b)): &Proxies) -> f32 {
    let input = b2DistanceInput { proxyA: *a, proxyB: *b, transform: inv_mul_transforms(p, q), useRadii: true };
    let mut cache = b2SimplexCache { count: 0, indexA: [0; 3], indexB: [0; 3] };
    // SAFETY: two valid references, and no room for simplexes.
    unsafe { b2ShapeDistance(&raw const input, &raw mut cache, ptr::null_mut(), 0) }.distance
}

/// As in its own test for overlaps, which compares with a slop instead of zero.
fn overlaps<A: Placed, B: Placed>(list: &mut List<Pair, Answer>) {
    list.add(
        (NAME, "overlaps", Format::F32),
        proxies::<A, B>,
        |both| gap(both) <= 0.0,
        |&hit| Answer { hit, depth: None },
    );
}

/// The square of the distance between the cores. Nothing rotates.
#[inline]
fn cores(((p, a), (q, b)): &Both<b2Capsule, b2Capsule>) -> f32 {
    let (x, y) = (q.p.x - p.p.x, q.p.y - p.p.y);
    let in_a = |v: b2Vec2| b2Vec2 { x: v.x + x, y: v.y + y };
    // SAFETY: plain numbers in, a plain value out.
    unsafe { b2SegmentDistance(a.center1, a.center2, in_a(b.center1), in_a(b.center2)) }.distanceSquared
}

fn capsules_overlap(list: &mut List<Pair, Answer>) {
    list.add(
        (NAME, "overlaps", Format::F32),
        shapes::<b2Capsule, b2Capsule>,
        |both| {
            let radii = both.0.1.radius + both.1.1.radius;
            cores(both) <= radii * radii
        },
        |&hit| Answer { hit, depth: None },
    );
}

pub fn distances(list: &mut List<Pair, f64>, kinds: (Kind, Kind)) {
    let key = (NAME, "distance", Format::F32);
    match kinds {
        (Kind::Circle, _) => list.add(key, proxies::<b2Circle, b2Polygon>, gap, |d| f64::from(*d)),
        (Kind::Turned, _) => list.add(key, proxies::<b2Polygon, b2Polygon>, gap, |d| f64::from(*d)),
        _ => list.add(
            key,
            shapes::<b2Capsule, b2Capsule>,
            |both| (cores(both).sqrt() - both.0.1.radius - both.1.1.radius).max(0.0),
            |d| f64::from(*d),
        ),
    }
}

pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    // SAFETY, all of them: two valid references and a value.
    match kinds {
        (Kind::Circle, _) => {
            contact::<b2Circle, b2Polygon>(list, |((p, a), (q, b))| unsafe {
                b2CollidePolygonAndCircle(b, a, inv_mul_transforms(q, p))
            });
            overlaps::<b2Circle, b2Polygon>(list);
        }
        (Kind::Capsule, _) => {
            contact::<b2Capsule, b2Capsule>(list, |((p, a), (q, b))| unsafe {
                b2CollideCapsules(a, b, inv_mul_transforms(p, q))
            });
            capsules_overlap(list);
        }
        _ => {
            contact::<b2Polygon, b2Polygon>(list, |((p, a), (q, b))| unsafe {
                b2CollidePolygons(a, b, inv_mul_transforms(p, q))
            });
            overlaps::<b2Polygon, b2Polygon>(list);
        }
    }
}
