//! Casts in the hard classes, against the exact judge: motions through a position where the shapes
//! touch (grazing, head-on, to the very end), within 2 raw, near the origin, far from it, over the
//! whole domain. Mirrored, exchanged and translated scenes give the same answer.
//!
//! `TILESAT_CASES` sets the number of cases per pair and class (default 4 000).

use tilesat_judge::casts::ask::{Case, check};
use tilesat_judge::casts::motions::{MOST, Motion, moving, through, views};
use tilesat_judge::oracle::figure::{Kind, PAIRS};
use tilesat_judge::oracle::generate::{CLASSES, Class, Pairs};
use tilesat_judge::oracle::int256::Int256;

fn cases() -> u64 {
    tilesat_judge::cases(4_000)
}

fn run(pair: (Kind, Kind), class: Class) -> [u64; 3] {
    let mut pairs = Pairs::new(pair, class, 0xca57);
    let mut counts = [0; 3];
    let most = if matches!(class, Class::Domain) { MOST - 1 } else { 64 << 16 };
    let mut done = 0;
    while done < cases() {
        let (a, b) = pairs.next();
        let most = pairs.random.magnitude(most).max(1);
        let Some(Motion { a, d }) = through(&mut pairs.random, &a, &b, most) else { continue };
        done += 1;
        // Within two raw along both axes, and one for an early time.
        counts[check::<Int256>(&a, &b, d, 4) as usize] += 1;
        views(&a, &b, d);
        moving(&mut pairs.random, &a, &b, d);
    }
    counts
}

fn all(class: Class) {
    for pair in PAIRS {
        let counts = run(pair, class);
        println!("{class:?} {pair:?}: {} overlaps, {} misses, {} hits", counts[0], counts[1], counts[2]);
        assert!(counts[Case::Hit as usize] > cases() / 1000, "{class:?} {pair:?}: {counts:?}");
    }
}

#[test]
fn anywhere() {
    all(CLASSES[0]);
}

#[test]
fn near_touching() {
    all(CLASSES[1]);
}

#[test]
fn touching() {
    all(CLASSES[2]);
}

#[test]
fn far_from_the_origin() {
    all(CLASSES[3]);
}

#[test]
fn whole_domain() {
    all(CLASSES[4]);
}

#[test]
fn deep_and_flat() {
    all(CLASSES[5]);
}
