//! Mirrored, transposed, exchanged and moved scenes have mirrored manifolds: as many points, at
//! mirrored places. All turned boxes and polygons of a small lattice.

use super::symmetry::MAPS;
use tilesat_judge::convex::ask;
use tilesat_judge::convex::shape::{Shape, hull};
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::kernel::point;

/// The axis, and the points on A and on B in order.
fn seen(a: &Shape, b: &Shape, map: impl Fn(Point) -> Point) -> Option<(Point, Vec<(Point, Point)>)> {
    ask::manifold(a, b).filter(|found| !found.deepest().contact.is_degenerate()).map(|found| {
        let axis = map((i64::from(found.axis().x), i64::from(found.axis().y)));
        let contacts = found.points().map(|p| p.contact);
        let mut points: Vec<_> = contacts.map(|c| (map(point(c.point_on_a())), map(point(c.point_on_b())))).collect();
        points.sort_unstable();
        (axis, points)
    })
}

/// Boxes of two shapes in eight directions, and every third triangle and quadrangle of 4 x 4
/// points.
fn shapes(unit: i64) -> Vec<Shape> {
    let mut all = Vec::new();
    for half in [(2, 1), (1, 1), (3, 0)] {
        for direction in [(1, 0), (1, 1), (1, -1), (2, 1), (1, 2), (-1, 2), (-2, 1), (0, 1)] {
            for radius in [0, 1] {
                let half = (half.0 * unit, half.1 * unit);
                all.push(Shape::Turned { centre: (0, 0), half, direction, radius: radius * unit / 2 });
            }
        }
    }
    let places: Vec<Point> = (0..16).map(|i| ((i % 4 - 1) * unit, (i / 4 - 1) * unit)).collect();
    for bits in (0u32..1 << 16).filter(|bits| matches!(bits.count_ones(), 3 | 4)).step_by(29) {
        let chosen: Vec<Point> = (0..16).filter(|i| bits >> i & 1 == 1).map(|i| places[i]).collect();
        let around = hull(&chosen);
        if around.len() == chosen.len() {
            all.push(Shape::polygon(&around, 0));
        }
    }
    all
}

#[test]
fn points_are_mirrored() {
    let (mut count, mut two) = (0u64, 0u64);
    for unit in [4, 1000] {
        let all = shapes(unit);
        let floors = [((-2, 1), (9, 6)), ((-4, 1), (4, 3)), ((-1, 0), (1, 2))];
        let floors = floors.map(|(min, max): (Point, Point)| Shape::Aabb {
            min: (min.0 * unit, min.1 * unit),
            max: (max.0 * unit, max.1 * unit),
        });
        for (i, a) in all.iter().enumerate() {
            for b in floors.iter().chain(all.iter().skip(i % 7).step_by(7)) {
                for k in 0..9 {
                    let b = b.moved((k % 3 * unit / 2, k / 3 * unit / 2));
                    let here = seen(a, &b, |p| p);
                    for (name, map) in MAPS {
                        let mirrored = seen(&a.map(map, map), &b.map(map, map), |p| p);
                        assert_eq!(seen(a, &b, map), mirrored, "{name}: {a:?} {b:?}");
                    }
                    let by = (7001, -65_537);
                    let moved = seen(&a.moved(by), &b.moved(by), |p| p);
                    let at = |p: Point| (p.0 + by.0, p.1 + by.1);
                    let points = here.clone().map(|(axis, points)| {
                        (axis, points.into_iter().map(|(p, q)| (at(p), at(q))).collect::<Vec<_>>())
                    });
                    assert_eq!(points, moved, "moved: {a:?} {b:?}");
                    let exchanged = seen(&b, a, |p| p).map(|(axis, points)| {
                        let mut points: Vec<_> = points.into_iter().map(|(p, q)| (q, p)).collect();
                        points.sort_unstable();
                        ((-axis.0, -axis.1), points)
                    });
                    assert_eq!(here, exchanged, "exchanged: {a:?} {b:?}");
                    count += 1;
                    two += u64::from(here.is_some_and(|(_, points)| points.len() == 2));
                }
            }
        }
    }
    assert!(count > 10_000 && two > count / 10, "{count} pairs, {two} with two points");
}
