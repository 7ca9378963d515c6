//! Box2D, in C and f32: its manifold functions, which its own narrow phase calls.

use crate::job::{Format, List};
use crate::pairs::classes::Pair;
use crate::pairs::truth::Answer;
use boxdd_sys::ffi::{
    b2Circle, b2CollideCircles, b2CollidePolygonAndCircle, b2CollidePolygons, b2CollideSegmentAndCircle,
    b2CollideSegmentAndPolygon, b2LocalManifold, b2MakeBox, b2Polygon, b2RayCastInput, b2RayCastSegment, b2Rot,
    b2Segment, b2Transform, b2Vec2,
};
use tilesat_judge::oracle::figure::{Figure, Kind};

pub const NAME: &str = "Box2D";

pub fn length(raw: f64) -> f32 {
    (raw / 65536.0) as f32
}

pub fn vector((x, y): (i64, i64)) -> b2Vec2 {
    b2Vec2 { x: length(x as f64), y: length(y as f64) }
}

const ORIGIN: b2Vec2 = b2Vec2 { x: 0.0, y: 0.0 };

/// A shape and its position: the middle of a circle or box, and the origin for a segment, which is
/// a wall.
trait Placed: 'static {
    fn of(figure: &Figure) -> (b2Vec2, Self);
}

impl Placed for b2Circle {
    fn of(figure: &Figure) -> (b2Vec2, Self) {
        let Figure::Circle { centre, radius } = *figure else { panic!("{figure:?} is no circle") };
        (vector(centre), Self { center: ORIGIN, radius: length(radius as f64) })
    }
}

impl Placed for b2Polygon {
    fn of(figure: &Figure) -> (b2Vec2, Self) {
        let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
        let middle = |a: i64, b: i64| length((a + b) as f64 / 2.0);
        let half = |a: i64, b: i64| length((b - a) as f64 / 2.0);
        // SAFETY: plain numbers in, a plain value out.
        let shape = unsafe { b2MakeBox(half(min.0, max.0), half(min.1, max.1)) };
        (b2Vec2 { x: middle(min.0, max.0), y: middle(min.1, max.1) }, shape)
    }
}

impl Placed for b2Segment {
    fn of(figure: &Figure) -> (b2Vec2, Self) {
        let Figure::Segment { a, b } = *figure else { panic!("{figure:?} is no segment") };
        (ORIGIN, Self { point1: vector(a), point2: vector(b) })
    }
}

/// The position of B relative to A. Nothing rotates.
fn relative(a: b2Vec2, b: b2Vec2) -> b2Transform {
    b2Transform { p: b2Vec2 { x: b.x - a.x, y: b.y - a.y }, q: b2Rot { c: 1.0, s: 0.0 } }
}

/// The deepest of its points. It also makes points for shapes that are only near.
pub fn answer(m: &b2LocalManifold) -> Answer {
    let deepest = m.points.iter().take(m.pointCount as usize).map(|p| p.separation).reduce(f32::min);
    match deepest {
        Some(s) if s <= 0.0 => Answer { hit: true, depth: Some(f64::from(-s)) },
        _ => Answer { hit: false, depth: None },
    }
}

fn contact<A: Placed, B: Placed>(
    list: &mut List<Pair, Answer>,
    collide: impl Fn(&A, &B, b2Transform) -> b2LocalManifold + Copy + 'static,
) {
    list.add(
        (NAME, "contact", Format::F32),
        |(a, b): &Pair| (A::of(a), B::of(b)),
        move |((p, a), (q, b))| collide(a, b, relative(*p, *q)),
        answer,
    );
}

/// The function takes B first.
fn turned<A: Placed, B: Placed>(
    list: &mut List<Pair, Answer>,
    collide: impl Fn(&B, &A, b2Transform) -> b2LocalManifold + Copy + 'static,
) {
    list.add(
        (NAME, "contact", Format::F32),
        |(a, b): &Pair| (A::of(a), B::of(b)),
        move |((p, a), (q, b))| collide(b, a, relative(*q, *p)),
        answer,
    );
}

/// It has no pair of two segments, but it has the ray along one.
fn segments(list: &mut List<Pair, Answer>) {
    let ray = |figure: &Figure| {
        let s = b2Segment::of(figure).1;
        let (origin, end) = (s.point1, s.point2);
        let translation = b2Vec2 { x: end.x - origin.x, y: end.y - origin.y };
        b2RayCastInput { origin, translation, maxFraction: 1.0 }
    };
    list.add(
        (NAME, "overlaps", Format::F32),
        move |(a, b): &Pair| (ray(a), b2Segment::of(b).1),
        // SAFETY: two valid references.
        |(ray, segment)| unsafe { b2RayCastSegment(segment, ray, false) },
        |out| Answer { hit: out.hit, depth: None },
    );
}

pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    // SAFETY, all of them: two valid references and a value.
    match kinds {
        (Kind::Circle, Kind::Circle) => {
            contact::<b2Circle, b2Circle>(list, |a, b, t| unsafe { b2CollideCircles(a, b, t) });
        }
        (Kind::Circle, Kind::Aabb) => {
            turned::<b2Circle, b2Polygon>(list, |b, a, t| unsafe { b2CollidePolygonAndCircle(b, a, t) });
        }
        (Kind::Circle, Kind::Segment) => {
            turned::<b2Circle, b2Segment>(list, |b, a, t| unsafe { b2CollideSegmentAndCircle(b, a, t) });
        }
        (Kind::Aabb, Kind::Aabb) => {
            contact::<b2Polygon, b2Polygon>(list, |a, b, t| unsafe { b2CollidePolygons(a, b, t) });
        }
        (Kind::Segment, Kind::Aabb) => {
            contact::<b2Segment, b2Polygon>(list, |a, b, t| unsafe { b2CollideSegmentAndPolygon(a, b, t) });
        }
        (Kind::Segment, Kind::Segment) => segments(list),
        _ => {}
    }
}
