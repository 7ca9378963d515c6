//! Shapes that move toward each other: P10 to P13.

use super::config;
use super::scenes::{motions, pairs};
use proptest::prelude::*;
use tilesat::{CastHit, Inside};
use tilesat_judge::casts::ask::{Answer, Case, cast, check};
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::kernel::{self, point, vec2};
use tilesat_judge::oracle::verify::Pair;

fn ask(a: &Figure, b: &Figure, d: Point) -> Answer {
    cast(a, b, d, Inside::Ignore).unwrap_or_else(|e| panic!("{e}: {a:?} by {d:?} on {b:?}"))
}

fn overlaps(a: &Figure, b: &Figure) -> bool {
    Pair::new(a, b).exact.overlaps()
}

proptest! {
    #![proptest_config(config(1))]

    /// The time is a part of the motion: the exact judge's floor, or just before it. The position
    /// is free. A way that is k times as long hits after exactly the k-th part of the time.
    #[test]
    fn p10_moments((a, b, d) in motions(), k in 2i64..=9) {
        check::<Int256>(&a, &b, d, 4);
        let short = ask(&a, &b, d);
        let far = (d.0 * k, d.1 * k);
        if let (Some(hit), Some(exact)) = (short.hit, short.exact)
            && far.0.abs().max(far.1.abs()) < 1 << 28
        {
            prop_assert!(hit.toi <= tilesat::Toi::ONE && !overlaps(&a.moved(point(hit.displacement)), &b));
            let long = ask(&a, &b, far);
            let time = long.exact.map(tilesat::Toi::raw);
            prop_assert_eq!(time, Some(exact.raw() / k as u32), "{} times as far", k);
            let (p, q) = (point(hit.displacement), point(long.hit.unwrap().displacement));
            prop_assert!((p.0 - q.0).abs() <= 3 && (p.1 - q.1).abs() <= 3, "{p:?} {q:?}");
        }
    }

    /// No hit: 64 positions of the way do not overlap, and the last one is its end.
    #[test]
    fn p11_free_all_the_way((a, b, u) in motions()) {
        let d = (u.0 / 64 * 64, u.1 / 64 * 64);
        if !overlaps(&a, &b) && ask(&a, &b, d).hit.is_none() {
            for k in 0..=64 {
                let there = a.moved((d.0 / 64 * k, d.1 / 64 * k));
                prop_assert!(!overlaps(&there, &b), "after {k} of 64");
                prop_assert!(!there.in_domain() || !kernel::overlaps(&there, &b), "after {k} of 64");
            }
        }
    }

    /// No motion, no hit, except for an existing overlap.
    #[test]
    fn p12_no_motion((a, b) in pairs()) {
        prop_assert_eq!(ask(&a, &b, (0, 0)), Answer { hit: None, yes: false, exact: None });
        let inside = cast(&a, &b, (0, 0), Inside::Hit).unwrap();
        prop_assert_eq!(inside.yes, overlaps(&a, &b));
        prop_assert!(inside.hit.is_none_or(|hit| hit.inside && hit.displacement == vec2((0, 0))));
    }

    /// A by d on B is B by -d on A.
    #[test]
    fn p13_exchanged((a, b, d) in motions()) {
        let (one, back) = (ask(&a, &b, d), (-d.0, -d.1));
        if b.moved(back).in_domain() {
            let hit = one.hit.map(|hit| CastHit { axis: -hit.axis, displacement: -hit.displacement, ..hit });
            prop_assert_eq!(ask(&b, &a, back), Answer { hit, ..one });
        }
    }
}

/// A strategy that did not reach its subject would test nothing.
#[test]
fn motions_hit_and_miss() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::{Config, RngSeed, TestRunner};
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(1), ..Config::default() });
    let mut counts = [0; 3];
    for _ in 0..1000 {
        let (a, b, d) = motions().new_tree(&mut runner).unwrap().current();
        counts[check::<Int256>(&a, &b, d, 4) as usize] += 1;
    }
    assert!(counts[Case::Hit as usize] > 150 && counts[Case::Miss as usize] > 150, "{counts:?}");
}
