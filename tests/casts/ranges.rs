//! Casts of shapes refuse motions of 2^28 raw or more and points outside the domain, and nothing
//! else.

use tilesat::num::{DOMAIN, MOTION};
use tilesat::prelude::*;
use tilesat::{Aabb, Circle, Fx, Inside, Quantity, RangeError, Segment, Vec2};

fn at(x: i32, y: i32) -> Vec2 {
    Vec2::from_raw(x, y)
}

/// All verbs of one pair by one motion: all refuse it, or none.
fn told<A: CastShape<B>, B: CastShape<A>>(a: &A, b: &B, motion: Vec2) -> Option<RangeError> {
    let told = a.cast_shape(b, motion, Inside::Hit).err();
    assert_eq!(a.would_hit(b, motion, Inside::Hit).err(), told);
    assert_eq!(a.exact_toi(b, motion, Inside::Hit).err(), told);
    assert_eq!(a.cast_moving(motion, b, Vec2::ZERO, Inside::Hit).err(), told);
    assert_eq!(a.cast_moving(Vec2::ZERO, b, motion, Inside::Hit).err(), told);
    told
}

fn check<A: CastShape<B>, B: CastShape<A>>(a: &A, b: &B) {
    let most = MOTION - 1;
    for (x, y) in [(most, most), (-most, most), (most, -most), (-most, -most), (0, 0), (most, 0), (0, -most)] {
        assert_eq!(told(a, b, at(x, y)), None, "{x} {y}");
    }
    for over in [MOTION, -MOTION, MOTION + 1, DOMAIN, -DOMAIN, 3 << 28, i32::MAX, i32::MIN, i32::MIN + 1] {
        let error = |what| Some(RangeError { what, value: over });
        for other in [0, 5, -most] {
            assert_eq!(told(a, b, at(over, other)), error(Quantity::MotionX));
            assert_eq!(told(a, b, at(other, over)), error(Quantity::MotionY));
        }
        assert_eq!(told(a, b, at(over, i32::MAX)), error(Quantity::MotionX), "x is told first");
    }
}

#[test]
fn motions_end_below_two_to_the_28th() {
    let a = Aabb::new(at(0, 0), at(9, 9)).expect("inside");
    let c = Circle::new(at(40, 0), Fx::from_bits(7)).expect("inside");
    let s = Segment::new(at(60, -9), at(70, 9)).expect("inside");
    check(&a, &a);
    check(&a, &c);
    check(&s, &a);
    check(&c, &c);
    check(&c, &s);
    check(&s, &s);
}

#[test]
fn points_are_in_the_domain() {
    let a = Aabb::new(at(0, 0), at(9, 9)).expect("inside");
    let c = Circle::new(at(40, 0), Fx::from_bits(7)).expect("inside");
    for end in [DOMAIN - 1, 1 - DOMAIN] {
        for inside in [at(end, 0), at(0, end), at(end, -end)] {
            assert_eq!(inside.cast_shape(&a, at(1, 1), Inside::Hit), Ok(None));
            assert_eq!(inside.would_hit(&c, at(1, 1), Inside::Hit), Ok(false));
        }
        let over = end + end.signum();
        for (point, what) in [(at(over, 0), Quantity::X), (at(0, over), Quantity::Y), (at(over, over), Quantity::X)] {
            let error = Err(RangeError { what, value: over });
            assert_eq!(point.cast_shape(&a, at(1, 1), Inside::Hit).map(|_| ()), error);
            assert_eq!(point.would_hit(&c, at(1, 1), Inside::Hit).map(|_| ()), error);
            assert_eq!(point.exact_toi(&c, at(1, 1), Inside::Hit).map(|_| ()), error);
        }
    }
}
