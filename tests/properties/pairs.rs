//! Two shapes at rest: P1 to P4, P23, P27.

use super::config;
use super::scenes::{extremes, pairs};
use proptest::prelude::*;
use tilesat_judge::casts;
use tilesat_judge::num_rational::BigRational;
use tilesat_judge::oracle;
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::kernel::{self, point};
use tilesat_judge::oracle::rational;
use tilesat_judge::oracle::verify::Pair;

/// The nine by nine lattice and the radii of the exhaustive test.
fn small() -> impl Strategy<Value = Figure> {
    let at = || (0i64..9, 0i64..9);
    let radius = prop::sample::select(&[0i64, 1, 2, 3, 4, 5, 8][..]);
    prop_oneof![
        (at(), at()).prop_map(|(p, q)| oracle::generate::aabb(p, q)),
        (at(), radius).prop_map(|(centre, radius)| Figure::Circle { centre, radius }),
        (at(), at()).prop_map(|(a, b)| Figure::Segment { a, b }),
    ]
}

fn whole(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

proptest! {
    #![proptest_config(config(1))]

    /// A on B is B on A. Contacts mirror each other to the bit; for degenerate ones, except for the
    /// convention.
    #[test]
    fn p1_exchanged((a, b) in pairs()) {
        prop_assert_eq!(kernel::overlaps(&a, &b), kernel::overlaps(&b, &a));
        prop_assert_eq!(kernel::touches(&a, &b), kernel::touches(&b, &a));
        prop_assert_eq!(kernel::distance(&a, &b), kernel::distance(&b, &a));
        let (one, other) = (kernel::contact(&a, &b), kernel::contact(&b, &a));
        prop_assert_eq!(one.is_some(), other.is_some());
        if let (Some(one), Some(other)) = (one, other) {
            prop_assert_eq!((one.depth(), one.is_degenerate()), (other.depth(), other.is_degenerate()));
            if !one.is_degenerate() {
                prop_assert_eq!((one.axis(), one.push_out()), (-other.axis(), -other.push_out()));
                prop_assert_eq!((one.point_on_a(), one.point_on_b()), (other.point_on_b(), other.point_on_a()));
            }
        }
    }

    /// A push ends the overlap, at any size.
    #[test]
    fn p2_pushed_out((a, b) in pairs()) {
        for (a, b) in [(a, b), (b, a)] {
            if let Some(contact) = kernel::contact(&a, &b) {
                // Outside the domain, the exact judge still knows.
                let free = a.moved(point(contact.push_out()));
                prop_assert!(!Pair::new(&free, &b).exact.overlaps(), "{:?}", contact.push_out());
                if let Some(free) = kernel::translated(&a, point(contact.push_out())) {
                    prop_assert!(!kernel::overlaps(&free, &b), "{:?}", contact.push_out());
                }
            }
        }
    }

    /// An overlap is at least one raw unit deep, and nothing else is.
    #[test]
    fn p3_depth_of_an_overlap((a, b) in pairs()) {
        let contact = kernel::contact(&a, &b);
        prop_assert_eq!(kernel::overlaps(&a, &b), contact.is_some());
        if let Some(contact) = contact {
            prop_assert!(contact.depth().to_bits() >= 1);
            prop_assert!(Pair::new(&a, &b).exact.depth_is(contact.depth().to_bits().into()), "{}", contact.depth());
        }
    }

    /// The distance is the distance to the closest point, which is rounded to nearest. It is exact
    /// for boxes, and at most 0.71 raw off for others.
    #[test]
    fn p4_distance_and_closest_point((a, b) in pairs()) {
        let p = b.vertices()[0];
        let (d, x) = (kernel::distance_to_point(&a, p), kernel::closest_point(&a, p));
        let square = (i128::from(x.0 - p.0)).pow(2) + (i128::from(x.1 - p.1)).pow(2);
        let slack = i64::from(!matches!(a, Figure::Aabb { .. }));
        prop_assert!(square >= i128::from((d - slack).max(0)).pow(2), "{d} {x:?}");
        prop_assert!(square < i128::from(d + 1 + slack).pow(2), "{d} {x:?}");
        prop_assert_eq!(kernel::contains_point(&a, p), x == p && d == 0 && kernel::touches(&a, &Figure::Circle { centre: p, radius: 0 }));
        // Two shapes have closest points exactly if they are apart, and the points are as far from
        // each other.
        let points = kernel::closest_points(&a, &b);
        prop_assert_eq!(points.is_none(), kernel::touches(&a, &b));
        if let Some((p, q)) = points {
            let (d, far) = (kernel::distance(&a, &b), (p.0 - q.0, p.1 - q.1));
            let square = i128::from(far.0).pow(2) + i128::from(far.1).pow(2);
            prop_assert!(square >= i128::from((d - 2).max(0)).pow(2) && square <= i128::from(d + 3).pow(2), "{d} {far:?}");
        }
    }

    /// Every query at the ends of the domain: checked arithmetic, and the exact judge.
    #[test]
    fn p23_extremes((a, b) in extremes(), along in any::<bool>()) {
        let pair = Pair::new(&a, &b);
        pair.booleans();
        pair.contact();
        pair.distances();
        let most = (1i64 << 28) - 1;
        for d in [(most, most), (-most, most), (if along { most } else { 0 }, if along { 0 } else { -most })] {
            casts::ask::check::<oracle::int256::Int256>(&a, &b, d, 4);
        }
        let far: Point = (i64::from(i32::MAX), i64::from(i32::MIN));
        oracle::verify::point(&a, far);
    }

    /// The small lattice against big rationals, which share nothing with the judge of the other
    /// tests.
    #[test]
    fn p27_lattice_and_rationals(a in small(), b in small()) {
        prop_assert_eq!(kernel::overlaps(&a, &b), rational::overlaps(&a, &b));
        prop_assert_eq!(kernel::touches(&a, &b), rational::touches(&a, &b));
        prop_assert_eq!(kernel::contains(&a, &b), rational::contains(&a, &b));
        let r = whole(a.radius() + b.radius());
        if let Some(contact) = kernel::contact(&a, &b) {
            let depth = i64::from(contact.depth().to_bits());
            if let Some(exit) = rational::square_exit(&a, &b) {
                // depth - 1 < r + sqrt(exit) <= depth
                let (up, down) = (whole(depth) - &r, whole(depth - 1) - &r);
                prop_assert!(up >= whole(0) && exit <= &up * &up, "{depth}");
                prop_assert!(down < whole(0) || exit > &down * &down, "{depth}");
            }
        } else if !rational::touches(&a, &b) {
            let (square, d) = (rational::square_distance(&a, &b), kernel::distance(&a, &b));
            let (down, up) = (&r + whole(d), &r + whole(d + 1));
            prop_assert!(square >= &down * &down && square < &up * &up, "{d}");
        }
    }
}
