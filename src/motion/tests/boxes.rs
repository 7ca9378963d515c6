//! Boxes against convex solids, by their corners and sides.

use super::super::body::kernel::Kernel;
use super::polygons::SOLIDS;
use super::std::{format, vec, vec::Vec};
use super::{P, outline, raw, vec2};
use crate::shape::Aabb;

/// Another corner of a cell. The convex ones of [`SOLIDS`] come first.
const MORE: &[P] = &[(0, 0), (4, 0), (0, 4)];
const CONVEX: usize = 7;

/// When the box starts to overlap, as a fraction. It clips the motion by the half-planes of the
/// sum of the solid and the mirrored box. The edges of that sum are the solid's and those along
/// x and y.
fn oracle(solid: &[P], lo: P, size: P, d: P) -> Option<(i64, i64)> {
    let n = solid.len();
    let mut normals = vec![(1, 0), (-1, 0), (0, 1), (0, -1)];
    normals.extend((0..n).map(|i| {
        let (a, b) = (solid[i], solid[(i + 1) % n]);
        (b.1 - a.1, a.0 - b.0)
    }));
    let (mut from, mut to) = ((0i64, 1i64), (1i64, 1i64));
    for (x, y) in normals {
        let dot = |p: P| x * p.0 + y * p.1;
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
    for solid in SOLIDS[..CONVEX].iter().copied().chain([MORE]) {
        let features: Vec<_> = outline(solid);
        for (w, h) in [(0, 0), (1, 0), (0, 2), (1, 1), (3, 2), (6, 6)] {
            for (x, y) in (-8..8).flat_map(|x| (-8..8).map(move |y| (x, y))) {
                if oracle(solid, (x, y), (w, h), (0, 0)).is_some() {
                    continue;
                }
                let body = Aabb::new(vec2((x, y)), vec2((x + w, y + h))).expect("a box of the lattice");
                for (dx, dy) in (-7..8).flat_map(|x| (-7..8).map(move |y| (x, y))) {
                    let d = raw((dx, dy));
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
