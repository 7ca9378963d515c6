//! All pairs of strictly convex polygons with their corners on a small lattice.
//!
//! No pair is left out for a symmetry: each list holds the polygons of the lattice in every
//! position and every turned or mirrored image. The library answers each pair in both orders, once
//! with a spacing of one raw unit and once with one of a unit. The corners come from each first
//! corner and either way round in turn.

use crate::convex;
use crate::queries::Tally;
use crate::selftest;
use std::time::{Duration, Instant};
use tilesat::query::Separation;
use tilesat_judge::convex::shape::{Shape, hull};
use tilesat_judge::oracle::figure::Point;

/// Spacings of the lattice, in raw units.
const SPACINGS: [i64; 2] = [1, 1 << 16];
/// The exact fractions of the tests' judge also check one pair in so many.
const SLOW: u64 = 997;
const TELL: Duration = Duration::from_secs(10);

/// The lists to pair, by the corners of each polygon.
pub const NAMES: [(&str, i64, usize, usize); 6] = [
    ("triangles3", 3, 3, 3),
    ("quads3", 3, 4, 4),
    ("triangles5", 5, 3, 3),
    ("mixed5", 5, 4, 3),
    ("quads5", 5, 4, 4),
    ("quads4", 4, 4, 4),
];

/// Every strictly convex polygon of `corners` corners on a lattice of `side` by `side` points.
fn polygons(side: i64, corners: usize) -> Vec<Vec<Point>> {
    let all: Vec<Point> = (0..side * side).map(|i| (i % side, i / side)).collect();
    let (mut found, mut chosen) = (Vec::new(), Vec::new());
    choose(&all, corners, &mut chosen, &mut found);
    found
}

/// All sets of `left` more points, of those after the last chosen one.
fn choose(rest: &[Point], left: usize, chosen: &mut Vec<Point>, found: &mut Vec<Vec<Point>>) {
    if left == 0 {
        let around = hull(chosen);
        if around.len() == chosen.len() {
            found.push(around);
        }
        return;
    }
    for (i, p) in rest.iter().enumerate() {
        chosen.push(*p);
        choose(&rest[i + 1..], left - 1, chosen, found);
        chosen.pop();
    }
}

/// A polygon from its corner `turn / 2` on, either way round.
fn shape(corners: &[Point], spacing: i64, turn: usize) -> Shape {
    let mut points: Vec<Point> = corners.iter().map(|p| (p.0 * spacing, p.1 * spacing)).collect();
    points.rotate_left(turn / 2 % corners.len());
    if turn % 2 == 1 {
        points.reverse();
    }
    Shape::polygon(&points, 0)
}

/// Runs a list of pairs, and prints what was found. `Err` if there is none of that name, or an
/// answer is wrong.
pub fn run(name: &str) -> Result<(), String> {
    let &(_, side, first, second) = NAMES
        .iter()
        .find(|n| n.0 == name)
        .ok_or_else(|| format!("--lattice {name}: one of {}", NAMES.map(|n| n.0).join(", ")))?;
    let (a, b) = (polygons(side, first), polygons(side, second));
    let goal = SPACINGS.len() * a.len() * b.len();
    let (began, mut told) = (Instant::now(), Instant::now());
    let (mut tally, mut ordered) = (Tally::default(), 0u64);
    for spacing in SPACINGS {
        for (i, p) in a.iter().enumerate() {
            let p = shape(p, spacing, i);
            // Each answer is compared in both orders. A pair of one list is met once.
            let from = if first == second { i } else { 0 };
            for (j, q) in b.iter().enumerate().skip(from) {
                let q = shape(q, spacing, i / 8 + j);
                let mut hint = Separation::default();
                convex::check(&p, &q, &mut hint, true, &mut tally);
                ordered += if first == second && i != j { 2 } else { 1 };
                if tally.pairs % SLOW == 0 {
                    selftest::agree(&p, &q)?;
                    tally.thorough += 1;
                }
            }
            if told.elapsed() >= TELL {
                told = Instant::now();
                let seconds = began.elapsed().as_secs_f64();
                let rate = ordered as f64 / seconds;
                eprintln!(
                    "{name}: {ordered} of {goal} pairs, {rate:.0}/s, left {:.0} s",
                    (goal as f64 - ordered as f64) / rate
                );
            }
        }
    }
    let apart = tally.pairs - tally.overlaps - tally.touches;
    if ordered != goal as u64 {
        return Err(format!("{name}: {ordered} pairs of {goal}"));
    }
    println!(
        "| {name} | {} x {} | {} | {ordered} | {} | {} | {apart} | {} | {} | 0 | {:.0} |",
        a.len(),
        b.len(),
        SPACINGS.len(),
        tally.overlaps,
        tally.touches,
        tally.answers,
        tally.thorough,
        began.elapsed().as_secs_f64()
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::polygons;
    use tilesat_judge::oracle::figure::Point;

    fn side(p: Point, q: Point, r: Point) -> i64 {
        ((q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0)).signum()
    }

    /// Four points are the corners of a convex polygon exactly if no three are on a line and none
    /// is inside the triangle of the others.
    fn convex(p: [Point; 4]) -> bool {
        (0..4).all(|i| {
            let [a, b, c] = [1, 2, 3].map(|k| p[(i + k) % 4]);
            let turns = [side(a, b, p[i]), side(b, c, p[i]), side(c, a, p[i])];
            side(a, b, c) != 0 && turns.contains(&1) && turns.contains(&-1)
        })
    }

    #[test]
    fn lists_are_complete() {
        let all: Vec<Point> = (0..25).map(|i| (i % 5, i / 5)).collect();
        let (mut triangles, mut quads) = (0, 0);
        for (i, &p) in all.iter().enumerate() {
            for (j, &q) in all.iter().enumerate().skip(i + 1) {
                for (k, &r) in all.iter().enumerate().skip(j + 1) {
                    triangles += usize::from(side(p, q, r) != 0);
                    quads += all[k + 1..].iter().filter(|s| convex([p, q, r, **s])).count();
                }
            }
        }
        assert_eq!((polygons(5, 3).len(), polygons(5, 4).len()), (triangles, quads));
        assert_eq!((triangles, quads), (2148, 7398));
    }
}
