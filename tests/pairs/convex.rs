//! Capsules, oriented boxes and convex polygons, with each other and with the plain shapes. The
//! exact judge checks every answer, in both argument orders.
//!
//! `TILESAT_CASES` sets the number of cases per pair and class (default 2 000; the full run takes
//! 10 000 000).

use std::time::Instant;
use tilesat::prelude::*;
use tilesat::query::Separation;
use tilesat::{Axis, Capsule, OrientedBox, Vec2, fx};
use tilesat_judge::convex::ask::overlaps_from;
use tilesat_judge::convex::generate::{CLASSES, Class, Pairs};
use tilesat_judge::convex::shape::{KINDS, Kind, Shape, pairs};
use tilesat_judge::convex::verify::{Pair, about_point};

fn run(pair: (Kind, Kind), class: Class) -> [u64; 3] {
    let cases: u64 = tilesat_judge::cases(2_000);
    let mut stream = Pairs::new(pair, class, 0x5a7);
    let mut tally = [0; 3];
    // First the hint that other pairs left, and then the hint of this one.
    let mut hint = Separation::default();
    for _ in 0..cases {
        let (a, b) = stream.next();
        let pair = Pair::new(&a, &b);
        pair.all();
        for _ in 0..2 {
            assert_eq!(overlaps_from(&a, &b, &mut hint), pair.exact.overlaps(), "{hint:?}: {a:?} {b:?}");
        }
        let kind = if pair.exact.overlaps() {
            0
        } else if pair.exact.touches() {
            1
        } else {
            2
        };
        tally[kind] += 1;
    }
    tally
}

fn sweep(class: Class) {
    let start = Instant::now();
    let mut sum = [0; 3];
    for pair in pairs() {
        let tally = run(pair, class);
        println!("{:?}-{:?} {class:?}: {tally:?} overlap, only touch, apart; 0 wrong", pair.0, pair.1);
        (0..3).for_each(|i| sum[i] += tally[i]);
    }
    println!("{class:?}: {sum:?} overlap, only touch, apart; {:.1} s", start.elapsed().as_secs_f64());
    assert!(sum[0] > 0 && sum[1] + sum[2] > 0, "{class:?} lacks a case: {sum:?}");
}

#[test]
fn uniform() {
    sweep(Class::Uniform);
}

#[test]
fn lattices() {
    sweep(Class::Lattice);
}

#[test]
fn exact_touch() {
    sweep(Class::Touch);
}

#[test]
fn within_two_raw_of_touching() {
    sweep(Class::Near);
}

#[test]
fn whole_domain() {
    sweep(Class::Domain);
}

#[test]
fn slivers() {
    sweep(Class::Thin);
}

/// A hint that two corners left, for a pair in which they are one point.
#[test]
fn a_hint_of_another_pair_changes_nothing() {
    let dot = |x| Capsule::new(Vec2::from_ints(x, 0), Vec2::from_ints(x, 0), fx!(1)).unwrap();
    let mut last = Separation::default();
    assert!(!dot(0).overlaps_from(
        &Capsule::new(Vec2::new(fx!(1), fx!(1.9)), Vec2::new(fx!(1), fx!(1.9)), fx!(1)).unwrap(),
        &mut last
    ));
    assert_ne!(last, Separation::default());
    let turned = OrientedBox::new(Vec2::ZERO, Vec2::from_ints(2, 1), Axis::new(3, 4)).unwrap();
    assert!(turned.overlaps_from(&turned, &mut last));
}

/// Boxes, circles and segments among themselves, with their manifolds.
#[test]
fn plain_pairs() {
    for (i, j) in (0..3).flat_map(|i| (0..=i).map(move |j| (KINDS[i], KINDS[j]))) {
        for class in CLASSES {
            let mut stream = Pairs::new((i, j), class, 0x3c1);
            for _ in 0..tilesat_judge::cases(500) {
                let (a, b) = stream.next();
                Pair::new(&a, &b).all();
            }
        }
    }
}

/// Points on, near and far from shapes, up to the ends of the numbers.
#[test]
fn points_anywhere() {
    for kind in [Kind::Capsule, Kind::Turned, Kind::Polygon] {
        for class in CLASSES {
            let mut stream = Pairs::new((kind, Kind::Segment), class, 0x9e);
            for _ in 0..tilesat_judge::cases(2_000) {
                let (shape, other) = stream.next();
                let Shape::Segment { a, b } = other else { unreachable!("as asked for") };
                let far = |n: i64| n.clamp(-(1 << 29), 1 << 29) * 4 - i64::from(n > 0);
                for p in [a, b, shape.vertices()[0], (far(a.0 << 9), b.1), (far(b.0 << 20), far(a.1 << 20))] {
                    about_point(&shape, p);
                }
            }
        }
    }
}
