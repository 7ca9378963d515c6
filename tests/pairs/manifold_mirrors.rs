//! Mirrored, transposed, exchanged and moved scenes have mirrored manifolds: as many points, at
//! mirrored places. All oriented boxes and polygons of a small lattice.

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

/// How far the points of two answers are apart, in the component where that is most.
fn apart(p: (Point, Point), q: (Point, Point)) -> i64 {
    let most = |p: Point, q: Point| (p.0 - q.0).abs().max((p.1 - q.1).abs());
    most(p.0, q.0).max(most(p.1, q.1))
}

/// The deepest points of facing sides are in the middle, rounded down; nearest ones of slanted
/// sides are at one of the ends.
#[test]
fn single_points_are_mirrored_to_a_raw_unit() {
    let (mut exact, mut rounded, mut ends) = (0u64, [0u64; 2], [0u64; 2]);
    for unit in [3, 4, 1000] {
        let mut all = shapes(unit);
        let boxes = [((-2, 1), (9, 6)), ((-1, 0), (1, 2)), ((0, 0), (3, 1))];
        all.extend(boxes.map(|(min, max): (Point, Point)| Shape::Aabb {
            min: (min.0 * unit, min.1 * unit),
            max: (max.0 * unit, max.1 * unit),
        }));
        all.extend(
            [((0, 0), (2, 1)), ((0, 1), (3, 0)), ((0, 0), (0, 3))].map(|(a, b): (Point, Point)| Shape::Segment {
                a: (a.0 * unit, a.1 * unit),
                b: (b.0 * unit, b.1 * unit),
            }),
        );
        for (i, a) in all.iter().enumerate() {
            for b in all.iter().skip(i % 5).step_by(5).chain([a]) {
                for by in [(1, 1), (unit + 1, 2 * unit), (-3 * unit, 5 * unit + 1), (3 * unit, 6 * unit)] {
                    let b = b.moved(by);
                    for (name, map) in MAPS {
                        let (c, d) = (a.map(map, map), b.map(map, map));
                        let mapped = |(p, q): (Point, Point)| (map(p), map(q));
                        let deepest = |a, b| {
                            let contact = ask::contact(a, b).filter(|c| !c.is_degenerate());
                            contact.map(|c| (point(c.point_on_a()), point(c.point_on_b())))
                        };
                        if let (Some(here), Some(there)) = (deepest(a, &b), deepest(&c, &d)) {
                            let off = apart(mapped(here), there);
                            assert!(off <= 1, "{name}: {a:?} {b:?}: {here:?} {there:?}");
                            rounded[off as usize] += 1;
                        }
                        if let (Some(here), Some(there)) = (ask::closest_points(a, &b), ask::closest_points(&c, &d)) {
                            let off = apart(mapped(here), there);
                            if off <= 1 {
                                exact += u64::from(off == 0);
                                ends[0] += off as u64;
                                continue;
                            }
                            let ((p, q), (r, s)) = (mapped(here), there);
                            // At a few raw units, rounding hides the direction.
                            let slanted = |way: &Point| way.0.abs().max(way.1.abs()) < 4 || (way.0 != 0 && way.1 != 0);
                            let ways = [(q.0 - p.0, q.1 - p.1), (s.0 - r.0, s.1 - r.1)];
                            let slanted = ways.iter().all(slanted);
                            assert!(
                                slanted && apart((ways[0], p), (ways[1], p)) <= 2,
                                "{name}: {a:?} {b:?}: {here:?} {there:?}"
                            );
                            ends[1] += 1;
                        }
                    }
                }
            }
        }
    }
    println!("{exact} equal; off by 0 and 1: {rounded:?}; nearest in the middle, at an end: {ends:?}");
    assert!(exact > 1000 && rounded[1] > 0 && ends[1] > 0);
}
