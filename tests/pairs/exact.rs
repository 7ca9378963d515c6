//! Every boolean of every pair against the exact judge, in both argument orders, over the hard
//! classes.
//!
//! `TILESAT_CASES` sets the number of cases per pair and class (default 100 000; the full run takes
//! 10 000 000).

use std::time::Instant;
use tilesat_judge::oracle::figure::{Figure, Kind, PAIRS};
use tilesat_judge::oracle::generate::{Class, Pairs};
use tilesat_judge::oracle::kernel;
use tilesat_judge::oracle::measure::Measure;

const THREADS: u64 = 2;

fn cases() -> u64 {
    tilesat_judge::cases(100_000)
}

#[derive(Clone, Copy, Default)]
struct Tally {
    overlap: u64,
    touch: u64,
}

fn check(a: &Figure, b: &Figure, overlap: bool, touch: bool) {
    assert_eq!(kernel::overlaps(a, b), overlap, "overlaps of {a:?} and {b:?}, the judge on the right");
    assert_eq!(kernel::touches(a, b), touch, "touches of {a:?} and {b:?}, the judge on the right");
    assert_eq!(kernel::contact(a, b).is_some(), overlap, "contact of {a:?} and {b:?}, the judge on the right");
}

fn run(pair: (Kind, Kind), class: Class, seed: u64, cases: u64) -> Tally {
    let mut pairs = Pairs::new(pair, class, seed);
    let mut tally = Tally::default();
    for _ in 0..cases {
        let (a, b) = pairs.next();
        let exact = Measure::new(&a, &b);
        let (overlap, touch) = (exact.overlaps(), exact.touches());
        check(&a, &b, overlap, touch);
        check(&b, &a, overlap, touch);
        tally.overlap += u64::from(overlap);
        tally.touch += u64::from(touch && !overlap);
    }
    tally
}

fn sweep(class: Class) {
    for pair in PAIRS {
        let start = Instant::now();
        let each = cases().div_ceil(THREADS);
        let total = std::thread::scope(|scope| {
            let halves: Vec<_> = (0..THREADS).map(|i| scope.spawn(move || run(pair, class, 0x5a7 + i, each))).collect();
            halves.into_iter().fold(Tally::default(), |sum, half| {
                // The thread has printed the failing pair.
                let half = half.join().unwrap_or_else(|_| panic!("{pair:?} {class:?}: wrong answer"));
                Tally { overlap: sum.overlap + half.overlap, touch: sum.touch + half.touch }
            })
        });
        println!(
            "{:?}-{:?} {class:?}: {} cases, {} overlap, {} only touch, 0 wrong, {:.1} s",
            pair.0,
            pair.1,
            each * THREADS,
            total.overlap,
            total.touch,
            start.elapsed().as_secs_f64()
        );
    }
}

#[test]
fn uniform() {
    sweep(Class::Uniform);
}

#[test]
fn within_two_raw_of_touching() {
    sweep(Class::Near);
}

#[test]
fn exact_touch() {
    sweep(Class::Exact);
}

#[test]
fn far_from_the_origin() {
    sweep(Class::Far);
}

#[test]
fn whole_domain() {
    sweep(Class::Domain);
}

#[test]
fn deep() {
    sweep(Class::Deep);
}
