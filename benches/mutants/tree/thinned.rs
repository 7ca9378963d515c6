//! The lattices of `tests/pairs/lattice.rs` and `tests/casts/lattice.rs`, thinned to seconds.

use tilesat_judge::casts::ask::check;
use tilesat_judge::oracle::figure::{Figure, Kind, PAIRS, Point};
use tilesat_judge::oracle::verify::{self, Pair};

/// Takes one of so many cases of a lattice. These are primes, so no row or column is left out.
const OF_PAIRS: usize = 499;
const OF_CASTS: usize = 97;

/// On a lattice of nine by nine, touches with 5 are exact; points need 0.
const RADII: [i64; 7] = [0, 1, 2, 3, 4, 5, 8];

fn square(from: i64, to: i64) -> impl Iterator<Item = Point> {
    (from..=to).flat_map(move |x| (from..=to).map(move |y| (x, y)))
}

fn figures() -> Vec<Figure> {
    let circles = square(0, 8).flat_map(|centre| RADII.map(|radius| Figure::Circle { centre, radius }));
    let ends = || square(0, 8).flat_map(|p| square(0, 8).map(move |q| (p, q)));
    let boxes = ends().filter(|(p, q)| p.0 <= q.0 && p.1 <= q.1).map(|(min, max)| Figure::Aabb { min, max });
    circles.chain(boxes).chain(ends().map(|(a, b)| Figure::Segment { a, b })).collect()
}

/// Shapes of a kind, at the origin.
fn shapes(kind: Kind) -> Vec<Figure> {
    match kind {
        Kind::Aabb => square(0, 2).map(|max| Figure::Aabb { min: (0, 0), max }).collect(),
        Kind::Circle => (0..=2).map(|radius| Figure::Circle { centre: (0, 0), radius }).collect(),
        Kind::Segment => square(-2, 2).map(|b| Figure::Segment { a: (0, 0), b }).collect(),
    }
}

#[test]
fn lattices_of_pairs() {
    let all = figures();
    let count = all.len() * all.len();
    for i in (0..count).step_by(OF_PAIRS * 4) {
        let pair = Pair::new(&all[i / all.len()], &all[i % all.len()]);
        pair.booleans();
        pair.contact();
        pair.distances();
    }
    for (i, figure) in all.iter().enumerate() {
        verify::point(figure, ((i % 9) as i64, (i / 9 % 9) as i64));
    }
}

#[test]
fn lattices_of_casts() {
    let mut at = 0;
    for (first, second) in PAIRS {
        for (a, b) in shapes(first).into_iter().flat_map(|a| shapes(second).into_iter().map(move |b| (a, b))) {
            for place in square(-3, 3) {
                for d in square(-4, 4) {
                    at += 1;
                    if at % OF_CASTS == 0 {
                        check::<i128>(&a.moved(place), &b, d, 3);
                    }
                }
            }
        }
    }
}
