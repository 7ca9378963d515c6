//! The sets of shapes of a scene, as either of two shapes: the answers are those of the shape
//! inside, bit for bit.

use tilesat::prelude::*;
use tilesat::scene::{Shape, WithCapsules};
use tilesat::shape::{AnyShape, Compound};
use tilesat::{Aabb, Capsule, Circle, ConvexPolygon, Inside, OrientedBox, RangeError, Segment, Vec2, fx};
use tilesat_judge::{Random, cases};

/// All answers about two shapes and a motion.
macro_rules! answers {
    ($a:expr, $b:expr, $d:expr) => {{
        let (a, b, d) = ($a, $b, $d);
        let closest = (a.distance(b), a.closest_points(b), a.contains(b), a.manifold(b));
        let cast = |inside| (a.cast_shape(b, d, inside), a.would_hit(b, d, inside), a.exact_toi(b, d, inside));
        let casts = (cast(Inside::Ignore), cast(Inside::Hit), a.cast_moving(d, b, Vec2::ZERO, Inside::Hit));
        (a.overlaps(b), a.touches(b), a.contact(b), closest, casts)
    }};
}

/// A set in both roles, with another shape.
macro_rules! same {
    ($($inner:expr => $set:expr),+; $other:expr, $d:expr) => {$(
        let (inner, set, other) = (&$inner, &$set, &$other);
        assert_eq!(answers!(set, other, $d), answers!(inner, other, $d), "{set:?} {other:?} {:?}", $d);
        assert_eq!(answers!(other, set, $d), answers!(other, inner, $d), "{other:?} {set:?} {:?}", $d);
    )+};
}

struct Kit {
    block: Aabb,
    ball: Circle,
    line: Segment,
    pill: Capsule,
    turned: OrientedBox,
    triangle: ConvexPolygon<3>,
    any: AnyShape<4>,
    parts: Compound<Aabb, 2>,
}

impl Kit {
    fn new(r: &mut Random) -> Result<Self, Box<dyn std::error::Error>> {
        let mut p = |n| Vec2::from_ints(r.around(n) as i16, r.around(n) as i16);
        let size = |v: Vec2| Vec2::new(v.x.abs() + fx!(1), v.y.abs() + fx!(1));
        let block = |at, of: Vec2| Aabb::new(at, at + size(of));
        let radius = |v: Vec2| v.x.abs() + fx!(1);
        let (turned, triangle) = (OrientedBox::new(p(6), size(p(3)), tilesat::Axis::new(3, 1))?, [p(6), p(6), p(6)]);
        let triangle = ConvexPolygon::hull(&triangle).unwrap_or(ConvexPolygon::new(&[
            Vec2::ZERO,
            Vec2::from_ints(3, 0),
            Vec2::from_ints(0, 3),
        ])?);
        Ok(Self {
            block: block(p(6), p(4))?,
            ball: Circle::new(p(6), radius(p(4)))?,
            line: Segment::new(p(6), p(6))?,
            pill: Capsule::new(p(6), p(6), radius(p(2)))?,
            turned,
            triangle,
            any: AnyShape::from(turned),
            parts: Compound::new(&[block(p(6), p(3))?, block(p(6), p(3))?])?,
        })
    }
}

#[test]
fn sets_answer_as_the_shape_inside() -> Result<(), Box<dyn std::error::Error>> {
    let mut r = Random::new(11);
    for _ in 0..cases(300) {
        let (a, b) = (Kit::new(&mut r)?, Kit::new(&mut r)?);
        let d = Vec2::from_ints(r.around(20) as i16, r.around(20) as i16);
        macro_rules! each {
            ($other:ident) => {
                same!(
                    a.block => Shape::Aabb(a.block), a.ball => Shape::Circle(a.ball),
                    a.block => WithCapsules::Aabb(a.block), a.ball => WithCapsules::Circle(a.ball),
                    a.pill => WithCapsules::Capsule(a.pill);
                    b.$other, d
                );
            };
        }
        each!(block);
        each!(ball);
        each!(line);
        each!(pill);
        each!(turned);
        each!(triangle);
        each!(any);
        // A compound is contained part by part, and contains only points.
        let parts = &b.parts;
        for (set, inner) in [(Shape::Aabb(a.block), Shape::from(a.block)), (a.ball.into(), a.ball.into())] {
            assert_eq!((set.overlaps(parts), parts.touches(&set)), (parts.overlaps(&inner), inner.touches(parts)));
        }
        assert_eq!(Shape::from(a.ball).contact(parts), a.ball.contact(parts));
        assert_eq!(parts.contact(&Shape::from(a.ball)), parts.contact(&a.ball));
        let hit = Inside::Ignore;
        assert_eq!(Shape::from(a.ball).cast_shape(parts, d, hit), a.ball.cast_shape(parts, d, hit));
        assert_eq!(parts.cast_shape(&WithCapsules::from(a.pill), d, hit), parts.cast_shape(&a.pill, d, hit));
        // Two of a set, a point, and a ray.
        let (x, y) = (WithCapsules::from(a.pill), WithCapsules::from(b.ball));
        assert_eq!(answers!(&x, &y, d), answers!(&a.pill, &b.ball, d));
        assert_eq!(answers!(&Shape::from(a.ball), &Shape::from(b.block), d), answers!(&a.ball, &b.block, d));
        let p = b.block.min();
        assert_eq!((x.contains(&p), x.distance(&p)), (a.pill.contains(&p), a.pill.distance(&p)));
        assert_eq!(x.cast_ray(p, d, Inside::Hit), a.pill.cast_ray(p, d, Inside::Hit));
        assert_eq!(Shape::from(a.block).cast_ray(p, d, Inside::Hit), a.block.cast_ray(p, d, Inside::Hit));
    }
    Ok(())
}

#[test]
fn sets_refuse_what_shapes_refuse() -> Result<(), RangeError> {
    let ball = Circle::new(Vec2::ZERO, fx!(1))?;
    let far = Vec2::from_ints(4096, 0);
    assert!(ball.cast_shape(&ball, far, Inside::Hit).is_err());
    assert_eq!(Shape::from(ball).cast_shape(&ball, far, Inside::Hit), ball.cast_shape(&ball, far, Inside::Hit));
    assert_eq!(ball.would_hit(&Shape::from(ball), far, Inside::Hit), ball.would_hit(&ball, far, Inside::Hit));
    Ok(())
}
