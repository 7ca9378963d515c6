//! Mirrored, exchanged and moved casts are equal, with one exception. If two sides or corners
//! mirror each other at a motion along x or y, the hit is on the one that faces its left.

use super::symmetry::{MAPS, Map};
use tilesat::{Axis, CastHit, Inside};
use tilesat_judge::convex::ask;
use tilesat_judge::convex::shape::{Shape, hull};
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::kernel::point;

fn hit(a: &Shape, b: &Shape, d: Point) -> Option<CastHit> {
    ask::cast(a, b, d, Inside::Hit).expect("motions and shapes are small").hit.filter(|hit| !hit.inside)
}

fn of(axis: Axis) -> Point {
    (i64::from(axis.x), i64::from(axis.y))
}

/// Left of the motion, y up: the same side for exchanged shapes, whose axis and motion are
/// reversed.
fn is_left(axis: Point, d: Point) -> bool {
    d.0 * axis.1 - d.1 * axis.0 > 0
}

/// Whether a cast and its image differ; then in the exception only.
fn differ(name: &str, map: Map, (a, b): (&Shape, &Shape), d: Point) -> bool {
    let (here, there) = (hit(a, b, d), hit(&a.map(map, map), &b.map(map, map), map(d)));
    let case = || format!("{name}: {a:?} {b:?} by {d:?}: {here:?}, {there:?}");
    assert_eq!(here.is_some(), there.is_some(), "{}", case());
    let (Some(here), Some(there)) = (here, there) else { return false };
    assert_eq!(here.toi, there.toi, "{}", case());
    let (image, found) = (map(of(here.axis)), of(there.axis));
    if image == found {
        // On an arc, the place is rounded as the axis is.
        assert_eq!(map(point(here.displacement)), point(there.displacement), "{}", case());
        return false;
    }
    let along = d.0 == 0 || d.1 == 0;
    assert!(along && is_left(of(here.axis), d) && is_left(found, map(d)), "{}", case());
    true
}

fn shapes(unit: i64) -> Vec<Shape> {
    let at = |x: i64, y: i64| (x * unit, y * unit);
    let mut all = vec![
        Shape::Capsule { a: at(0, 0), b: at(2, 1), radius: 0 },
        Shape::Capsule { a: at(1, 0), b: at(-1, 1), radius: unit },
        Shape::Capsule { a: at(1, 0), b: at(1, 2), radius: unit },
        Shape::Circle { centre: at(0, 0), radius: 0 },
        Shape::Circle { centre: at(0, 0), radius: 3 * unit },
        Shape::Segment { a: at(0, 0), b: at(1, 1) },
        Shape::Segment { a: at(0, 1), b: at(2, 0) },
        Shape::Aabb { min: at(-1, 0), max: at(1, 1) },
    ];
    for direction in [(1, 1), (1, -1), (2, 1), (-1, 3)] {
        for radius in [0, 2] {
            all.push(Shape::Turned { centre: at(0, 0), half: at(2, 1), direction, radius });
        }
    }
    for radius in [0, 4] {
        for corners in [[(0, 0), (2, 0), (1, 1)], [(2, -3), (-1, 0), (-1, 1)], [(0, 1), (1, -1), (2, 0)]] {
            all.push(Shape::polygon(&hull(&corners.map(|(x, y)| at(x, y))), radius));
        }
    }
    all
}

#[test]
fn casts_are_mirrored() {
    let (mut count, mut left) = (0u64, 0u64);
    for unit in [4, 1000] {
        let all = shapes(unit);
        for a in &all {
            for b in &all {
                for k in 0..25 {
                    let a = a.moved((k % 5 * 2 * unit - 4 * unit, k / 5 * 2 * unit - 4 * unit));
                    for d in [(8, 0), (-8, 0), (0, 8), (0, -8), (8, 8), (-8, 8), (7, -5), (-3, -9)] {
                        let d = (d.0 * unit, d.1 * unit);
                        // If two sides are equal, the one along x is hit: transposing changes that.
                        for (name, map) in &MAPS[..2] {
                            left += u64::from(differ(name, *map, (&a, b), d));
                            count += 1;
                        }
                        let back = hit(b, &a, (-d.0, -d.1)).map(|hit| (hit.toi, hit.axis.reversed()));
                        assert_eq!(hit(&a, b, d).map(|hit| (hit.toi, hit.axis)), back, "{a:?} {b:?} by {d:?}");
                    }
                }
            }
        }
    }
    println!("{count} casts, {left} hit a mirrored side");
    assert!(left > 0 && left < count / 100, "{left} of {count}");
}

/// Two corners that a motion along x meets within one part of 2^30, one of them more beside it: it
/// is the other one in every image.
#[test]
fn the_corner_less_beside_the_motion() {
    let poly = Shape::polygon(&hull(&[(197, -269), (-70, 42), (-70, 41)]), 4);
    let circle = Shape::Circle { centre: (-54_658, 43), radius: 54_584 };
    for (name, map) in MAPS {
        assert!(!differ(name, map, (&poly, &circle), (-268_435_455, 0)));
    }
}
