//! Every pair of shapes on a small lattice, by every small motion, against the exact judge: hit or
//! miss, time, position, normal.

use tilesat_judge::casts::ask::{Case, check};
use tilesat_judge::oracle::figure::{Figure, Kind, PAIRS, Point};

/// A size that shows every rounding, and one that shows every normal.
const UNITS: [i64; 2] = [1, 4096];

/// Shapes of a kind, at the origin; a segment and its reverse count once.
fn shapes(kind: Kind) -> Vec<Figure> {
    let range = || (0..=2).flat_map(|x| (0..=2).map(move |y| (x, y)));
    match kind {
        Kind::Aabb => range().map(|max| Figure::Aabb { min: (0, 0), max }).collect(),
        Kind::Circle => (0..=2).map(|radius| Figure::Circle { centre: (0, 0), radius }).collect(),
        Kind::Segment => {
            let ends = (-2..=2).flat_map(|x| (-2..=2).map(move |y| (x, y)));
            ends.filter(|&end| end >= (0, 0)).map(|b| Figure::Segment { a: (0, 0), b }).collect()
        }
    }
}

fn square(size: i64) -> impl Iterator<Item = Point> {
    (-size..=size).flat_map(move |x| (-size..=size).map(move |y| (x, y)))
}

fn scaled(f: &Figure, unit: i64) -> Figure {
    match f.map(|p| (p.0 * unit, p.1 * unit)) {
        Figure::Circle { centre, radius } => Figure::Circle { centre, radius: radius * unit },
        other => other,
    }
}

fn run((first, second): (Kind, Kind)) {
    let mut counts = [0u64; 3];
    for unit in UNITS {
        for (a, b) in shapes(first).iter().flat_map(|a| shapes(second).into_iter().map(move |b| (*a, b))) {
            for at in square(3) {
                let (a, b) = (scaled(&a.moved(at), unit), scaled(&b, unit));
                for d in square(4) {
                    let case = check::<i128>(&a, &b, (d.0 * unit, d.1 * unit), 3);
                    counts[case as usize] += 1;
                }
            }
        }
    }
    println!("{first:?} {second:?}: {} overlaps, {} misses, {} hits", counts[0], counts[1], counts[2]);
    assert!(counts[Case::Hit as usize] > 5_000 && counts[Case::Miss as usize] > 5_000);
}

#[test]
fn boxes() {
    run(PAIRS[0]);
}

#[test]
fn circles() {
    run(PAIRS[1]);
}

#[test]
fn circles_and_boxes() {
    run(PAIRS[2]);
}

#[test]
fn circles_and_segments() {
    run(PAIRS[3]);
}

#[test]
fn segments_and_boxes() {
    run(PAIRS[4]);
}

#[test]
fn segments() {
    run(PAIRS[5]);
}
