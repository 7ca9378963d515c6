//! Casts of capsules, oriented boxes and polygons, on each other and on plain shapes, against the
//! exact judge: hits and misses, exact moments, free positions, exchanged pairs.
//!
//! `TILESAT_CASES` sets the number of cases per pair and class (default 700).

use tilesat_judge::Random;
use tilesat_judge::casts::ask::Case;
use tilesat_judge::convex::generate::{Class, Pairs};
use tilesat_judge::convex::shape::{Shape, pairs};
use tilesat_judge::convex::verify::cast;
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::int256::Int256;

/// One less than the limit of motions.
const MOST: i64 = (1 << 28) - 1;

/// A start and a motion that pass through the pair's position, or end there, by up to a few
/// lengths.
fn through(r: &mut Random, a: &Shape, size: i64) -> (Shape, Point) {
    let size = size.clamp(1, MOST / 2);
    let d = match r.below(4) {
        0 => (r.around(size), 0),
        1 => (0, r.around(size)),
        _ => (r.around(size), r.around(size)),
    };
    // The pair is met at the start, at the end, or on the way.
    let (i, n) = ([0, 1, 1, r.below(5)][r.below(4) as usize], [1, 1, 2, 4][r.below(4) as usize]);
    (a.moved((-d.0 * i / n, -d.1 * i / n)), d)
}

fn all(class: Class) {
    let mut counts = [0u64; 3];
    for pair in pairs() {
        let mut stream = Pairs::new(pair, class, 0xca57);
        let mut done = 0;
        while done < tilesat_judge::cases(700) {
            let (a, b) = stream.next();
            let r = &mut stream.random;
            let size = [8, 100, 1 << 12, 1 << 22, MOST][r.below(5) as usize];
            let (a, d) = through(r, &a, size);
            if !a.in_domain() {
                continue;
            }
            done += 1;
            let (a, b) = if r.one_in(2) { (a, b) } else { (b, a) };
            // Within two raw along both axes, and one for an early time.
            counts[cast::<Int256>(&a, &b, d, 4) as usize] += 1;
        }
    }
    println!("{class:?}: {} overlaps, {} misses, {} hits", counts[0], counts[1], counts[2]);
    assert!(counts[Case::Hit as usize] > 100, "{class:?}: {counts:?}");
}

#[test]
fn anywhere() {
    all(Class::Uniform);
}

#[test]
fn lattices() {
    all(Class::Lattice);
}

#[test]
fn touching() {
    all(Class::Touch);
}

#[test]
fn nearly_touching() {
    all(Class::Near);
}

#[test]
fn whole_domain() {
    all(Class::Domain);
}

#[test]
fn slivers() {
    all(Class::Thin);
}
