//! Other views of the same scene: P5 to P9, for pairs and casts.

use super::config;
use super::scenes::{motions, pairs};
use proptest::prelude::*;
use tilesat::Inside;
use tilesat_judge::casts::ask::cast;
use tilesat_judge::oracle::figure::{Figure, LIMIT, Point};
use tilesat_judge::oracle::kernel;

type Map = fn(Point) -> Point;

const MIRRORS: [Map; 2] = [|p| (-p.0, p.1), |p| (p.0, -p.1)];
const TRANSPOSE: Map = |p| (p.1, p.0);
const TURNS: [Map; 3] = [|p| (-p.1, p.0), |p| (-p.0, -p.1), |p| (p.1, -p.0)];

/// Depth, and axis, push and normal.
type Exit = (i64, Option<[Point; 3]>);
/// Overlaps, touches, contains, distance, contact.
type Answers = (bool, bool, bool, i64, Option<Exit>);

/// All answers of two shapes, with mapped directions. A degenerate contact has no axis here: it is
/// a convention.
fn answers(a: &Figure, b: &Figure, map: impl Fn(Point) -> Point) -> Answers {
    let contact = kernel::contact(a, b).map(|c| {
        let n = c.normal().raw();
        let axis = (i64::from(c.axis().x), i64::from(c.axis().y));
        let ways = [axis, kernel::point(c.push_out()), (i64::from(n.0), i64::from(n.1))].map(&map);
        (i64::from(c.depth().to_bits()), (!c.is_degenerate()).then_some(ways))
    });
    let (overlap, touch) = (kernel::overlaps(a, b), kernel::touches(a, b));
    (overlap, touch, kernel::contains(a, b), kernel::distance(a, b), contact)
}

fn seen(f: &Figure, map: Map) -> Figure {
    f.map(map)
}

/// Hit or not, the time, the exact time.
fn moment(a: &Figure, b: &Figure, d: Point) -> (bool, Option<u32>, Option<u32>) {
    let answer = cast(a, b, d, Inside::Ignore).unwrap_or_else(|e| panic!("{e}: {a:?} by {d:?} on {b:?}"));
    (answer.yes, answer.hit.map(|h| h.toi.raw()), answer.exact.map(tilesat::Toi::raw))
}

fn scaled(f: &Figure, j: u32) -> Figure {
    match f.map(|p| (p.0 << j, p.1 << j)) {
        Figure::Circle { centre, radius } => Figure::Circle { centre, radius: radius << j },
        other => other,
    }
}

proptest! {
    #![proptest_config(config(1))]

    #[test]
    fn p5_mirrored((a, b) in pairs()) {
        for map in MIRRORS {
            prop_assert_eq!(answers(&a, &b, map), answers(&seen(&a, map), &seen(&b, map), |p| p));
        }
    }

    #[test]
    fn p5_mirrored_motions((a, b, d) in motions()) {
        for map in MIRRORS {
            prop_assert_eq!(moment(&a, &b, d), moment(&seen(&a, map), &seen(&b, map), map(d)));
        }
    }

    #[test]
    fn p6_transposed((a, b) in pairs()) {
        prop_assert_eq!(answers(&a, &b, TRANSPOSE), answers(&seen(&a, TRANSPOSE), &seen(&b, TRANSPOSE), |p| p));
    }

    #[test]
    fn p6_transposed_motions((a, b, d) in motions()) {
        prop_assert_eq!(moment(&a, &b, d), moment(&seen(&a, TRANSPOSE), &seen(&b, TRANSPOSE), TRANSPOSE(d)));
    }

    #[test]
    fn p7_moved((a, b, d) in motions(), by in (-LIMIT..LIMIT, -LIMIT..LIMIT)) {
        for by in [by, (by.0 % 3, by.1 % 3), (by.0 % 65_537, 0)] {
            let (c, e) = (a.moved(by), b.moved(by));
            if c.in_domain() && e.in_domain() {
                prop_assert_eq!(answers(&a, &b, |p| p), answers(&c, &e, |p| p), "{:?}", by);
                if c.moved(d).in_domain() {
                    let of = |a: &Figure, b: &Figure| cast(a, b, d, Inside::Ignore).unwrap();
                    prop_assert_eq!(of(&a, &b), of(&c, &e), "{:?}", by);
                }
            }
        }
    }

    /// Booleans equal those of the scene times a power of two. A depth, rounded up, grows by at
    /// most that factor.
    #[test]
    fn p8_scaled((a, b, d) in motions(), j in 1u32..=16) {
        let (c, e) = (scaled(&a, j), scaled(&b, j));
        if c.in_domain() && e.in_domain() {
            let (small, large) = (answers(&a, &b, |p| p), answers(&c, &e, |p| p));
            prop_assert_eq!((small.0, small.1, small.2), (large.0, large.1, large.2));
            prop_assert!(large.3 >= small.3 << j && large.3 < (small.3 + 1) << j, "{} {}", small.3, large.3);
            if let (Some(small), Some(large)) = (small.4, large.4) {
                prop_assert!(large.0 <= small.0 << j && large.0 > (small.0 - 1) << j, "{} {}", small.0, large.0);
            }
            let far = (d.0 << j, d.1 << j);
            if far.0.abs().max(far.1.abs()) < 1 << 28 && c.moved(far).in_domain() {
                let (small, large) = (moment(&a, &b, d), moment(&c, &e, far));
                prop_assert_eq!((small.0, small.2), (large.0, large.2));
            }
        }
    }

    #[test]
    fn p9_turned((a, b) in pairs()) {
        for map in TURNS {
            prop_assert_eq!(answers(&a, &b, map), answers(&seen(&a, map), &seen(&b, map), |p| p));
        }
    }

    #[test]
    fn p9_turned_motions((a, b, d) in motions()) {
        for map in TURNS {
            prop_assert_eq!(moment(&a, &b, d), moment(&seen(&a, map), &seen(&b, map), map(d)));
        }
    }
}
