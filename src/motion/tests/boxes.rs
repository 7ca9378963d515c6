//! Boxes against convex solids, by their corners and sides.

use super::super::body::kernel::Kernel;
use super::std::{format, vec, vec::Vec};
use crate::num::{Axis, Raw, Vec2};
use crate::shape::Aabb;
use crate::world::{Cell, Feature, Geometry};

type Point = (i32, i32);

/// Triangles, trapezoids and a diamond, on a lattice of four, turning from x toward y.
const SOLIDS: [&[Point]; 8] = [
    &[(0, 4), (4, 0), (4, 4)],
    &[(0, 0), (4, 4), (0, 4)],
    &[(0, 0), (4, 0), (0, 4)],
    &[(0, 4), (4, 2), (4, 4)],
    &[(0, 2), (4, 0), (4, 4), (0, 4)],
    &[(2, 0), (4, 4), (0, 4)],
    &[(0, 2), (2, 0), (4, 2), (2, 4)],
    &[(1, 0), (3, 1), (2, 3)],
];

fn features(solid: &[Point]) -> impl Iterator<Item = Feature> + '_ {
    let n = solid.len();
    let edge = move |i: usize| {
        let (a, b) = (solid[i % n], solid[(i + 1) % n]);
        let (x, y) = (b.0 - a.0, b.1 - a.1);
        let len = (1..=4).rev().find(|k| x % k == 0 && y % k == 0).unwrap_or(1);
        (Vec2::from_raw(a.0, a.1), Axis::new(x / len, y / len), len)
    };
    let feature = |geometry| Feature { geometry, cell: Cell::default(), index: 0, flags: 0, one_way: false, source: 0 };
    (0..n).flat_map(move |i| {
        let ((a, dir, len), (p, e_out, _)) = (edge(i), edge(i + 1));
        let face = Geometry::Face { a, dir, len, joined: [false; 2] };
        [feature(face), feature(Geometry::Vertex { p, e_in: dir, e_out })]
    })
}

/// When the box starts to overlap, as a fraction. It clips the motion by the half-planes of the
/// sum of the solid and the mirrored box. The edges of that sum are the solid's and those along
/// x and y.
fn oracle(solid: &[Point], lo: Point, size: Point, d: Point) -> Option<(i64, i64)> {
    let n = solid.len();
    let mut normals = vec![(1, 0), (-1, 0), (0, 1), (0, -1)];
    normals.extend((0..n).map(|i| {
        let (a, b) = (solid[i], solid[(i + 1) % n]);
        (b.1 - a.1, a.0 - b.0)
    }));
    let (mut from, mut to) = ((0i64, 1i64), (1i64, 1i64));
    for (x, y) in normals {
        let dot = |p: Point| i64::from(x) * i64::from(p.0) + i64::from(y) * i64::from(p.1);
        let solid = solid.iter().map(|&p| dot(p)).max()?;
        let corner = (if x > 0 { lo.0 } else { lo.0 + size.0 }, if y > 0 { lo.1 } else { lo.1 + size.1 });
        let (at, speed) = (dot(corner) - solid, dot(d));
        // Inside while at + speed t < 0.
        match speed.signum() {
            0 if at >= 0 => return None,
            -1 if at * from.1 > from.0 * -speed => from = (at, -speed),
            1 if -at * to.1 < to.0 * speed => to = (-at, speed),
            _ => {}
        }
    }
    (from.0 * to.1 < to.0 * from.1).then_some(from)
}

/// All solids, small boxes (also without width or height), positions and motions: hit or not,
/// and when, exactly.
#[test]
fn box_against_convex_solids() {
    let mut hits = 0u32;
    for solid in SOLIDS {
        let features: Vec<_> = features(solid).collect();
        for (w, h) in [(0, 0), (1, 0), (0, 2), (1, 1), (3, 2), (6, 6)] {
            for (x, y) in (-8..8).flat_map(|x| (-8..8).map(move |y| (x, y))) {
                if oracle(solid, (x, y), (w, h), (0, 0)).is_some() {
                    continue;
                }
                let body = Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).expect("a box of the lattice");
                for (dx, dy) in (-7..8).flat_map(|x| (-7..8).map(move |y| (x, y))) {
                    let d = Raw { x: dx, y: dy };
                    let first = features
                        .iter()
                        .filter_map(|f| body.sweep(d, f))
                        .reduce(|a, b| if b.before(&a, d) { b } else { a });
                    let expected = oracle(solid, (x, y), (w, h), (dx, dy));
                    let case = || format!("{solid:?} {:?} by {:?}", (x, y, w, h), (dx, dy));
                    match (first, expected) {
                        (None, None) => {}
                        (Some(entry), Some((num, den))) => {
                            hits += 1;
                            let (n, d) = (i64::from(entry.num), i64::from(entry.den));
                            assert_eq!(n * den, num * d, "{}", case());
                        }
                        // See `sweep_slope`: a body without area at an acute corner.
                        (Some(entry), None) if entry.at_end && w * h == 0 => {}
                        (found, wanted) => panic!("{found:?}, not {wanted:?}: {}", case()),
                    }
                }
            }
        }
    }
    assert!(hits > 100_000);
}
