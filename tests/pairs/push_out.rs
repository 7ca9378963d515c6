//! Contacts against the exact judge: the axis is the least exit and the depth its ceiling. The push
//! ends the overlap and is not too long. The unit normal is within 1.5 units, and (B, A) mirrors
//! (A, B).
//!
//! `TILESAT_CASES` sets the number of cases per pair and class, ten times as many as run here
//! (default 100 000).

use tilesat_judge::Random;
use tilesat_judge::oracle;
use tilesat_judge::oracle::figure::{Figure, Kind, PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Class, Pairs, aabb};
use tilesat_judge::oracle::kernel;
use tilesat_judge::oracle::verify::Pair;

fn cases() -> u64 {
    let full: u64 = tilesat_judge::cases(100_000);
    full.div_ceil(10)
}

fn sweep(class: Class) {
    std::thread::scope(|scope| {
        for half in [&PAIRS[..3], &PAIRS[3..]] {
            scope.spawn(move || {
                for &pair in half {
                    let mut pairs = Pairs::new(pair, class, 0x9054);
                    let mut deep = 0;
                    for _ in 0..cases() {
                        let (a, b) = pairs.next();
                        let pair = Pair::new(&a, &b);
                        pair.contact();
                        deep += u64::from(pair.exact.overlaps());
                    }
                    println!("{:?}-{:?} {class:?}: {} cases, {deep} contacts", pair.0, pair.1, cases());
                }
            });
        }
    });
}

#[test]
fn contacts_are_exact_and_pushes_separate() {
    CLASSES.into_iter().for_each(sweep);
}

/// Shapes of a few raw units, where every rounding is as large as the shape.
fn tiny(r: &mut Random, kind: Kind) -> Figure {
    let mut point = || -> Point { (r.around(3), r.around(3)) };
    let (p, q) = (point(), point());
    match kind {
        Kind::Aabb => aabb(p, q),
        Kind::Segment => Figure::Segment { a: p, b: q },
        Kind::Circle => Figure::Circle { centre: p, radius: q.0.abs() },
    }
}

#[test]
fn pushes_separate_shapes_of_a_few_raw_units() {
    let mut r = Random::new(21);
    for pair in PAIRS {
        for _ in 0..cases() {
            let (a, b) = (tiny(&mut r, pair.0), tiny(&mut r, pair.1));
            Pair::new(&a, &b).contact();
        }
    }
}

/// Two segments whose exits over each other's lines are equally long, or differ by moving one end
/// by a raw unit.
///
/// With `t` the sine of the angle between them, the exit over a line is `t` times the shorter arm
/// of the other segment. Arms of equal length in two Pythagorean directions tie exactly, and the
/// compared fractions have different denominators.
fn crossing_tie(r: &mut Random) -> (Figure, Figure) {
    let mut triple = || {
        let (m, n) = (r.within(2, 20), r.within(1, 19));
        let (p, q, h) = ((m * m - n * n).abs(), 2 * m * n, m * m + n * n);
        ((r.sign() * p, r.sign() * q), h)
    };
    let ((d, h), (e, k)) = (triple(), triple());
    let most = (oracle::figure::LIMIT / 4) / (h * k);
    let scale = r.within(1, most);
    let mut segment = |d: Point, arm: i64| {
        let longer = r.within(arm, 2 * arm);
        Figure::Segment { a: (-d.0 * arm, -d.1 * arm), b: (d.0 * longer, d.1 * longer) }
    };
    let (a, b) = (segment(d, k * scale), segment(e, h * scale));
    let off = if r.one_in(2) { (0, 0) } else { (r.around(1), r.around(1)) };
    (a, b.moved(off))
}

#[test]
fn exits_that_tie_or_nearly_tie() {
    let mut r = Random::new(22);
    let mut ties = 0;
    for _ in 0..cases() {
        let (a, b) = crossing_tie(&mut r);
        let pair = Pair::new(&a, &b);
        pair.contact();
        ties += u64::from(pair.exact.overlaps() && !pair.exact.one_exit);
    }
    println!("{ties} ties in {} cases", cases());
    assert!(ties > cases() / 4);
}

/// The largest possible shapes, centred on each other: the deepest contacts, whose pushes leave the
/// domain.
#[test]
fn deepest_contacts_of_the_domain() {
    let most = oracle::figure::LIMIT - 1;
    let all = [
        aabb((-most, -most), (most, most)),
        aabb((-most, -1), (most, most)),
        Figure::Circle { centre: (0, 0), radius: most },
        Figure::Circle { centre: (1, 2), radius: most - 2 },
        Figure::Segment { a: (-most, -most), b: (most, most) },
        Figure::Segment { a: (-most, most), b: (most, -most + 1) },
        Figure::Segment { a: (-most, 0), b: (most, 1) },
    ];
    for a in &all {
        for b in &all {
            Pair::new(a, b).contact();
        }
    }
    let big = Figure::Circle { centre: (0, 0), radius: most };
    let push = kernel::contact(&big, &all[0]).map(|c| kernel::point(c.push_out()));
    assert_eq!(push, Some((-2 * most, 0)), "x before y, along +x");
}
