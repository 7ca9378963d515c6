//! The constructors of capsules, oriented boxes and polygons: their refusals, their rounding, and
//! orders that do not matter.

use tilesat::prelude::*;
use tilesat::{
    Aabb, Axis, Capsule, ConvexPolygon, Fx, OrientedBox, Quantity, RangeError, Vec2, error::PolygonError, fx,
};
use tilesat_judge::Random;
use tilesat_judge::convex::ask;
use tilesat_judge::convex::shape::{Shape, hull};
use tilesat_judge::oracle::figure::{LIMIT, Point};
use tilesat_judge::oracle::kernel::{point, vec2};

const END: i32 = LIMIT as i32 - 1;

fn raw(x: i32, y: i32) -> Vec2 {
    Vec2::from_raw(x, y)
}

#[test]
fn capsules_are_checked() {
    assert!(Capsule::new(raw(-END, 0), raw(END, 0), Fx::ZERO).is_ok());
    let far = Capsule::new(raw(0, 0), raw(0, END), Fx::DELTA);
    assert_eq!(far, Err(RangeError { what: Quantity::Y, value: END + 1 }));
    let negative = Capsule::new(raw(0, 0), raw(0, 1), -Fx::DELTA);
    assert_eq!(negative.unwrap_err().what, Quantity::Radius);
    let capsule = Capsule::new(raw(1, 2), raw(5, -3), Fx::from_bits(4)).unwrap();
    assert_eq!(capsule.aabb(), Aabb::new(raw(-3, -7), raw(9, 6)).unwrap());
    assert_eq!(capsule.translated(raw(1, 1)).unwrap().b(), raw(6, -2));
    assert!(capsule.translated(raw(END, 0)).is_err());
}

#[test]
fn boxes_are_checked_and_rounded_once() {
    let make = |half, direction| OrientedBox::new(raw(0, 0), half, direction);
    assert_eq!(make(raw(1, 1), Axis::new(0, 0)).unwrap_err().what, Quantity::Direction);
    // No direction is opposite to these, so none is across.
    for direction in [Axis::new(0, i32::MIN), Axis::new(i32::MIN, 7), Axis::new(i32::MIN, i32::MIN)] {
        let refused = make(raw(5 << 16, 1 << 16), direction).unwrap_err();
        assert_eq!(refused, RangeError { what: Quantity::Direction, value: i32::MIN });
        assert!(refused.to_string().contains("i32::MIN"), "{refused}");
    }
    assert!(make(raw(1, 1), Axis::new(0, -i32::MAX)).unwrap().along().raw() == (0, -1));
    assert_eq!(make(raw(-1, 1), Axis::X).unwrap_err().what, Quantity::HalfExtent);
    assert_eq!(make(raw(1, i32::MAX), Axis::X).unwrap_err().what, Quantity::HalfExtent);
    assert!(make(raw(END, END), Axis::X).is_ok());
    assert!(make(raw(END, END), Axis::new(1, 1)).is_err());
    assert!(make(raw(END, 1), Axis::X).unwrap().with_radius(Fx::DELTA).is_err());
    assert!(make(raw(5, 5), Axis::X).unwrap().with_radius(-Fx::DELTA).is_err());
    let mut r = Random::new(5);
    for _ in 0..20_000 {
        let half = (r.magnitude(1 << 28), r.magnitude(1 << 28));
        let direction = (r.magnitude((1 << 31) - 1) * r.sign(), 1 + r.magnitude((1 << 31) - 2));
        let shape = Shape::Turned { centre: (3, -7), half, direction, radius: 0 };
        if shape.in_domain() {
            let made = ask::turned((3, -7), half, direction, 0);
            assert_eq!(made.corners().map(point).to_vec(), shape.vertices(), "{shape:?}");
            // Counter-clockwise, however small.
            let area = made.along().perp_dot(made.across());
            assert_eq!(area > 0, half.0 > 0 && half.1 > 0, "{shape:?}");
            let (lo, hi) = (made.aabb().min().raw(), made.aabb().max().raw());
            let xs = made.corners().map(|p| p.raw().0);
            assert_eq!((lo.0, hi.0), (*xs.iter().min().unwrap(), *xs.iter().max().unwrap()));
        }
    }
}

#[test]
fn turned_and_mirrored_directions_give_turned_and_mirrored_boxes() {
    let half = raw(12_345, 777);
    for t in (0..1 << 16).step_by(61) {
        let at = |t: i32| OrientedBox::new(raw(0, 0), half, Axis::from_turns(Fx::from_bits(t))).unwrap();
        let (b, quarter, mirrored) = (at(t), at(t + (1 << 14)), at(-t));
        let turned = |v: Vec2| raw(-v.raw().1, v.raw().0);
        assert_eq!((turned(b.along()), turned(b.across())), (quarter.along(), quarter.across()), "{t}");
        let (along, across) = (b.along().raw(), b.across().raw());
        assert_eq!(mirrored.along().raw(), (along.0, -along.1), "{t}");
        assert_eq!(mirrored.across().raw(), (-across.0, across.1), "{t}");
    }
}

#[test]
fn angles_are_directions() {
    for t in 0..=1 << 16 {
        let Axis { x, y } = Axis::from_turns(Fx::from_bits(t));
        let angle = f64::from(t) / 65536.0 * std::f64::consts::TAU;
        let one = f64::from(1 << 30);
        let (dx, dy) = (f64::from(x) / one - angle.cos(), f64::from(y) / one - angle.sin());
        assert!(dx.abs().max(dy.abs()) < 2f64.powi(-23), "{t}: {dx:e} {dy:e}");
    }
    assert_eq!(Axis::from_turns(fx!(3.5)), Axis::from_turns(fx!(-0.5)));
}

#[test]
fn radians_are_directions() {
    use std::f64::consts::FRAC_PI_2;
    let one = f64::from(1 << 30);
    let check = |angle: f32| {
        let Axis { x, y } = Axis::from_radians(angle).unwrap();
        assert_eq!(Axis::from_radians(-angle), Some(Axis::new(x, -y)), "{angle}");
        let wide = f64::from(angle);
        let quarters = (wide / FRAC_PI_2).round();
        let exact = if angle != 0.0 && ((quarters * FRAC_PI_2) as f32).to_bits() == angle.to_bits() {
            assert!(x == 0 || y == 0, "{angle}: {x} {y}");
            [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters as usize % 4]
        } else {
            assert!(angle == 0.0 || angle < 1e-6 || x != 0 && y != 0, "{angle}: {x} {y}");
            let (dx, dy) = (f64::from(x) / one - wide.cos(), f64::from(y) / one - wide.sin());
            assert!(dx.abs().max(dy.abs()) < 2f64.powi(-23), "{angle}: {dx:e} {dy:e}");
            return;
        };
        assert_eq!((x, y), (exact.0 << 30, exact.1 << 30), "{angle}");
    };
    // All exponents, with significands of all sizes, and both neighbours of all quarters.
    for exponent in 0..127 + 20 {
        for significand in (0..1 << 23).step_by(40_009).chain([1, (1 << 23) - 1]) {
            check(f32::from_bits(exponent << 23 | significand));
        }
    }
    for quarters in 0..600_000 {
        let angle = (f64::from(quarters) * FRAC_PI_2) as f32;
        for near in [angle.next_down().max(0.0), angle, angle.next_up()] {
            check(near);
        }
    }
    for angle in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, 1_048_576.0, -1_048_576.0] {
        assert_eq!(Axis::from_radians(angle), None);
    }
    assert!(Axis::from_radians(1_048_576f32.next_down()).is_some());
}

#[test]
fn vectors_turn_by_directions() {
    let exact = |c: i32, x: i32, s: i32, y: i32| {
        let sum = i128::from(c) * i128::from(x) + i128::from(s) * i128::from(y);
        let size = (2 * sum.abs() + (1 << 30)) >> 31;
        (if sum < 0 { -size } else { size }).clamp(-i128::from(i32::MAX), i128::from(i32::MAX)) as i32
    };
    let ends = [0, 1, -1, 2, 3, 1 << 16, -(1 << 16) + 1, 1 << 29, i32::MAX, i32::MIN, i32::MIN + 1];
    for t in (0..1 << 16).step_by(509) {
        let unit = Axis::from_turns(Fx::from_bits(t)).unit();
        let (c, s) = unit.raw();
        for x in ends {
            for y in ends {
                assert_eq!(unit.rotate(raw(x, y)), raw(exact(c, x, -s, y), exact(s, x, c, y)), "{t}: {x} {y}");
            }
        }
    }
}

fn polygon(points: &[Point]) -> Result<ConvexPolygon<6>, PolygonError> {
    ConvexPolygon::new(&points.iter().map(|p| vec2(*p)).collect::<Vec<_>>())
}

#[test]
fn what_is_no_convex_polygon_is_refused() {
    use PolygonError::{Collinear, Range, Reflex, Repeated, TooFew, TooMany, Winds};
    assert_eq!(polygon(&[]), Err(TooFew { count: 0 }));
    assert_eq!(polygon(&[(0, 0), (1, 0)]), Err(TooFew { count: 2 }));
    assert_eq!(polygon(&[(0, 0); 7]), Err(TooMany { capacity: 6 }));
    assert_eq!(polygon(&[(0, 0), (0, 0), (3, 3)]), Err(Repeated { at: 1 }));
    assert_eq!(polygon(&[(0, 0), (2, 0), (2, 2), (0, 0)]), Err(Repeated { at: 0 }));
    assert_eq!(polygon(&[(0, 0), (2, 0), (4, 0), (0, 4)]), Err(Collinear { at: 1 }));
    assert_eq!(polygon(&[(0, 0), (4, 0), (2, 0)]), Err(Collinear { at: 1 }));
    assert_eq!(polygon(&[(0, 0), (4, 0), (1, 1), (0, 4)]), Err(Reflex { at: 2 }));
    // A star: every turn is to the left.
    let star = [(0, 10), (6, -8), (-10, 3), (10, 3), (-6, -8)];
    assert_eq!(polygon(&star), Err(Winds { times: 2 }));
    let Err(Range { at: 2, error }) = polygon(&[(0, 0), (4, 0), (LIMIT, 4)]) else { panic!() };
    assert_eq!((error.what, error.value), (Quantity::X, END + 1));
    assert!(error.to_string().starts_with("X is out of range"));
}

#[test]
fn any_order_of_corners_gives_one_polygon() {
    let mut r = Random::new(9);
    for _ in 0..5_000 {
        let points: Vec<Point> = (0..r.within(3, 12)).map(|_| (r.around(9), r.around(9))).collect();
        let border = hull(&points);
        let all: Vec<Vec2> = points.iter().map(|p| vec2(*p)).collect();
        let made = ConvexPolygon::<6>::hull(&all);
        if border.len() < 3 {
            assert_eq!(made, Err(PolygonError::TooFew { count: border.len() }), "{points:?}");
            continue;
        }
        if border.len() > 6 {
            assert_eq!(made, Err(PolygonError::TooMany { capacity: 6 }), "{points:?}");
            continue;
        }
        let made = made.unwrap();
        for turn in 0..border.len() {
            let mut list = border.clone();
            list.rotate_left(turn);
            assert_eq!(polygon(&list), Ok(made), "{list:?}");
            list.reverse();
            assert_eq!(polygon(&list), Ok(made), "{list:?}");
        }
        assert!(made.overlaps(&made.aabb()));
        let moved = made.translated(raw(7, -3)).unwrap();
        assert_eq!(moved.vertices().len(), border.len());
        assert_eq!(moved.aabb(), made.aabb().translated(raw(7, -3)).unwrap());
    }
    assert_eq!(ConvexPolygon::<6>::hull(&[]), Err(PolygonError::TooFew { count: 0 }));
}

/// Boxes half a unit in extent, nine tenths apart: two points a tenth deep, the same at every
/// origin. (`LargeWorldManifoldTest` of box2d.)
#[test]
fn two_points_at_every_origin() {
    let unit = |at: (i16, i16)| {
        let centre = Vec2::from_ints(at.0, at.1);
        OrientedBox::new(centre, Vec2::new(fx!(0.5), fx!(0.5)), Axis::X).unwrap()
    };
    for at in [(0, 0), (8000, -8000), (-8000, 17)] {
        let (a, b) = (unit(at), unit(at).translated(Vec2::new(fx!(0.9), fx!(0))).unwrap());
        let found = a.manifold(&b).unwrap();
        assert_eq!(found.axis(), Axis::X);
        let depths: Vec<Fx> = found.points().map(|p| p.contact.depth()).collect();
        assert_eq!(depths, [fx!(1) - fx!(0.9); 2]);
    }
}

/// A tilted box rests on a corner. If its lower side is inside, it rests on two, whose names stay
/// while it sinks.
#[test]
fn points_keep_their_names() {
    let floor = Aabb::new(Vec2::from_ints(-100, 0), Vec2::from_ints(100, 50)).unwrap();
    let at = |y| OrientedBox::new(Vec2::from_raw(0, y), Vec2::from_ints(10, 5), Axis::new(100, 1)).unwrap();
    let names = |y| at(y).manifold(&floor).map(|m| m.points().map(|p| (p.part_a, p.part_b)).collect::<Vec<_>>());
    let lowest = at(0).aabb().max().raw().1;
    assert_eq!(names(-lowest), None);
    let one = names(-lowest + 2).expect("2 raw deep");
    assert_eq!(one.len(), 1);
    let two = names(-lowest + (1 << 15)).expect("half a unit deep");
    assert_eq!((two.len(), two[0]), (2, one[0]));
    assert_eq!(names(-lowest + (1 << 16)), Some(two));
}
