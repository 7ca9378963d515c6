//! A corner and a wall that a circle meets at one moment, or a raw unit of way apart. The triangles
//! are 3-4-5, so the moments are fractions.

use super::std::vec::Vec;
use super::{P, circle, first, outline};

/// Seen in each of the eight ways.
const VIEWS: [fn(P) -> P; 8] = [
    |p| (p.0, p.1),
    |p| (-p.0, p.1),
    |p| (p.0, -p.1),
    |p| (-p.0, -p.1),
    |p| (p.1, p.0),
    |p| (-p.1, p.0),
    |p| (p.1, -p.0),
    |p| (-p.1, -p.0),
];

/// A circle of radius 5 that reaches the origin touches the corner (3, 4) and, `late` raw units
/// later, the wall x = 5.
///
/// ```text
///            |####         its corner is that of a step before the wall
///      .-.   |####
///     (   )  |####
///      `-'+---####
///         |#######
/// ```
fn scene(unit: i64, late: i64) -> Vec<P> {
    let wall = 5 * unit + late;
    let points = [(3, 4), (5, 4), (5, -90), (90, -90), (90, 90), (3, 90)];
    points.iter().map(|&(x, y)| (if x == 5 { wall } else { x * unit }, y * unit)).collect()
}

#[test]
fn the_wall_goes_first_at_one_moment() {
    let mut seen = 0;
    for unit in [1i64, 7, 1000, 65_536, 1_000_003, 1 << 22] {
        for (x, y) in (1..=8i64).flat_map(|x| (-5..=8i64).map(move |y| (x, y))) {
            // It comes nearer to both.
            if 3 * x + 4 * y <= 0 {
                continue;
            }
            // The moment is `before` / `whole`.
            for (before, whole) in [(1i64, 2i64), (1, 3), (2, 3), (3, 4), (2, 7)] {
                let (from, d) = ((-x * unit * before, -y * unit * before), (x * unit * whole, y * unit * whole));
                let free = (from.0 - 3 * unit).pow(2) + (from.1 - 4 * unit).pow(2) >= 25 * unit * unit;
                let side = from.1 <= 4 * unit - 5 * unit || from.0 <= 3 * unit;
                if !free || !side || d.0.abs().max(d.1.abs()) >= 1 << 28 {
                    continue;
                }
                for late in [-1, 0, 1] {
                    // So much earlier in raw units of the way along x, and so of the time.
                    let wall = late <= 0;
                    for view in VIEWS {
                        let mut points: Vec<P> = scene(unit, late).into_iter().map(view).collect();
                        let (a, b) = (view((1, 0)), view((0, 1)));
                        if a.0 * b.1 - a.1 * b.0 < 0 {
                            points.reverse();
                        }
                        let entry = first(&circle(view(from), 5 * unit), view(d), &outline(&points));
                        let entry = entry.expect("both are met");
                        let n = view((-1, 0));
                        let is_wall = (i64::from(entry.normal.x), i64::from(entry.normal.y)) == n;
                        assert_eq!(is_wall, wall, "{unit} {late}: from {from:?} by {d:?}, {entry:?}");
                        seen += 1;
                    }
                }
            }
        }
    }
    assert!(seen > 10_000, "{seen}");
}
