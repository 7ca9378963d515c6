//! Runs every row of pairs, closest points, casts and rays through the library.

use super::stored;
use super::table::reduced;
use tilesat::{Axis, CastHit, Inside};
use tilesat_judge::casts::ask::cast;
use tilesat_judge::num_bigint::BigInt;
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::kernel::{self, point, vec2};

#[test]
fn pairs() {
    stored("pairs.csv").each(|row| {
        let (a, b) = (row.figure("a"), row.figure("b"));
        assert_eq!(kernel::overlaps(&a, &b), row.yes("overlaps"), "{row:?}");
        assert_eq!(kernel::touches(&a, &b), row.yes("touches"), "{row:?}");
        assert_eq!(kernel::contains(&a, &b), row.yes("a_contains_b"), "{row:?}");
        assert_eq!(kernel::contains(&b, &a), row.yes("b_contains_a"), "{row:?}");
        assert_eq!(kernel::distance(&a, &b), row.number("distance_down"), "{row:?}");
        let contact = kernel::contact(&a, &b);
        assert_eq!(contact.map(|c| i64::from(c.depth().to_bits())), row.maybe("depth_up"), "{row:?}");
        if let Some(contact) = contact {
            let axis = contact.axis();
            let normal = row.points("normal").first().copied();
            assert_eq!(contact.is_degenerate(), normal.is_none(), "{row:?}");
            assert!(normal.is_none_or(|n| n == reduced((axis.x.into(), axis.y.into()))), "{axis:?}: {row:?}");
        }
    });
}

/// `n` is at most one half (for the f64 2^-20) from `num / den + arm * u / |u|`.
#[allow(clippy::cast_precision_loss, reason = "a tolerance is left for it")]
fn is_nearest(n: i64, num: &BigInt, den: &BigInt, arm: i64, (u, w): (i64, i64)) -> bool {
    let twice: BigInt = (BigInt::from(n) * den - num) * 2;
    if arm == 0 {
        return twice.magnitude() <= den.magnitude();
    }
    // For circles the denominator is one.
    let off = twice.to_string().parse::<f64>().unwrap() / 2.0;
    let unit = (u as f64) / (u as f64).hypot(w as f64);
    (off - arm as f64 * unit).abs() <= 0.500_001
}

#[test]
fn closest_points() {
    stored("closest.csv").each(|row| {
        let (shape, p, u) = (row.figure("shape"), row.point("point"), row.point("u"));
        let big = |name| row.text(name).parse::<BigInt>().unwrap();
        let (x, y, den, arm) = (big("x_num"), big("y_num"), big("den"), row.number("arm"));
        let seen = kernel::closest_point(&shape, p);
        assert_eq!(kernel::contains_point(&shape, p), row.yes("inside"), "{row:?}");
        assert!(
            is_nearest(seen.0, &x, &den, arm, u) && is_nearest(seen.1, &y, &den, arm, (u.1, u.0)),
            "{seen:?}: {row:?}"
        );
    });
}

/// A normal of the list. At a touched corner, one between two of them.
fn is_one_of(axis: Axis, normals: &[Point]) -> bool {
    let n = reduced((axis.x.into(), axis.y.into()));
    normals.is_empty() || normals.contains(&n)
}

#[test]
fn casts() {
    stored("casts.csv").each(|row| {
        let (a, d, b) = (row.figure("a"), row.point("motion"), row.figure("b"));
        let answer = cast(&a, &b, d, Inside::Ignore).unwrap();
        assert_eq!(answer.yes, row.yes("hit"), "{row:?}");
        assert_eq!(answer.exact.map(|t| i64::from(t.raw())), row.maybe("toi30"), "{row:?}");
        assert_eq!(answer.hit.is_some(), row.yes("hit"), "{row:?}");
        let inside = cast(&a, &b, d, Inside::Hit).unwrap();
        assert_eq!(inside.hit.is_some_and(|h| h.inside), row.yes("inside"), "{row:?}");
        if let Some(hit) = answer.hit {
            assert!(is_one_of(hit.axis, &row.points("normals")), "{:?}: {row:?}", hit.axis);
        }
    });
}

fn ray(shape: &Figure, o: Point, d: Point, inside: Inside) -> Option<CastHit> {
    match *shape {
        Figure::Aabb { min, max } => kernel::aabb(min, max).cast_ray(vec2(o), vec2(d), inside),
        Figure::Circle { centre, radius } => kernel::circle(centre, radius).cast_ray(vec2(o), vec2(d), inside),
        Figure::Segment { a, b } => kernel::segment(a, b).cast_ray(vec2(o), vec2(d)),
    }
    .unwrap()
}

#[test]
fn rays() {
    stored("rays.csv").each(|row| {
        let (shape, o, d) = (row.figure("shape"), row.point("from"), row.point("motion"));
        let hit = ray(&shape, o, d, Inside::Ignore);
        assert_eq!(hit.is_some(), row.yes("hit"), "{row:?}");
        assert_eq!(ray(&shape, o, d, Inside::Hit).is_some_and(|h| h.inside), row.yes("inside"), "{row:?}");
        if let (Some(hit), Some(toi)) = (hit, row.maybe("toi30")) {
            let raw = i64::from(hit.toi.raw());
            // Within an arc it is a lower bound, less than a raw unit of way early.
            let early = i128::from(toi - raw).pow(2) * (i128::from(d.0).pow(2) + i128::from(d.1).pow(2));
            let round = matches!(shape, Figure::Circle { radius, .. } if radius > 0);
            assert!(raw == toi || (round && raw < toi && early < 1 << 60), "{raw}: {row:?}");
            assert!(is_one_of(hit.axis, &row.points("normals")), "{:?}: {row:?}", hit.axis);
            let p = point(hit.displacement);
            assert!(p.0.abs() <= d.0.abs() + 2 && p.1.abs() <= d.1.abs() + 2, "{row:?}");
        }
    });
}
