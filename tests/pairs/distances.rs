//! Distances, closest points and containment against the exact judge, in both argument orders and
//! against points.
//!
//! `TILESAT_CASES` sets the number of cases per pair and class, ten times as many as run here
//! (default 100 000).

use tilesat_judge::Random;
use tilesat_judge::oracle::figure::{PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Class, Pairs};
use tilesat_judge::oracle::verify::{self, Pair};

fn cases() -> u64 {
    let full: u64 = tilesat_judge::cases(100_000);
    full.div_ceil(10)
}

fn sweep(class: Class) {
    std::thread::scope(|scope| {
        for half in [&PAIRS[..3], &PAIRS[3..]] {
            scope.spawn(move || {
                for &pair in half {
                    let mut pairs = Pairs::new(pair, class, 0xd157);
                    let mut apart = 0;
                    for _ in 0..cases() {
                        let (a, b) = pairs.next();
                        let pair = Pair::new(&a, &b);
                        pair.distances();
                        apart += u64::from(!pair.exact.touches());
                        // A vertex of the other shape is a point near to this one; its opposite
                        // lies anywhere.
                        for p in b.vertices().into_iter().take(2) {
                            verify::point(&a, p);
                            verify::point(&b, (-p.1, p.0));
                        }
                    }
                    println!("{:?}-{:?} {class:?}: {} cases, {apart} apart", pair.0, pair.1, cases());
                }
            });
        }
    });
}

#[test]
fn distances_and_closest_points_are_exact() {
    CLASSES.into_iter().for_each(sweep);
}

/// Points may be outside the domain: every pair of `i32` is a `Vec2`.
fn any_point(r: &mut Random) -> Point {
    let mut coordinate = || match r.below(4) {
        0 => i64::from(i32::MIN) + r.below(3),
        1 => i64::from(i32::MAX) - r.below(3),
        2 => r.sign() * (1 << r.below(31)),
        _ => i64::from(r.next() as i32),
    };
    (coordinate(), coordinate())
}

#[test]
fn points_outside_of_the_domain() {
    let mut r = Random::new(31);
    for pair in PAIRS {
        for class in CLASSES {
            let mut pairs = Pairs::new(pair, class, 0xfa4);
            for _ in 0..cases() {
                let (a, b) = pairs.next();
                verify::point(&a, any_point(&mut r));
                verify::point(&b, any_point(&mut r));
            }
        }
    }
}
