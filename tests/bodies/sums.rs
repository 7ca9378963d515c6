//! Times and overlaps of two shapes, judged by their exact sum.

use tilesat::Inside;
use tilesat_judge::casts::judge::{Forbidden, ONE};
use tilesat_judge::convex::shape::hull;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::solids::P;
use tilesat_judge::solids::shapes::{Any, Figure};

/// The positions of `a`, relative to its own, at which it overlaps `b`.
pub(super) fn sum(a: &Any, b: &Any) -> Forbidden {
    let (a, b) = (Figure::of(a), Figure::of(b));
    let all: Vec<P> = a.points.iter().flat_map(|p| b.points.iter().map(|q| (q.0 - p.0, q.1 - p.1))).collect();
    Forbidden { hull: hull(&all), radius: a.radius + b.radius }
}

/// The last whole part of a motion up to which it has no point in the open set.
pub(super) fn floor(set: &Forbidden, d: P) -> i64 {
    let (mut low, mut high) = (0, ONE + 1);
    while high - low > 1 {
        let middle = i64::midpoint(low, high);
        if set.met::<Int256>(d, middle) { high = middle } else { low = middle }
    }
    low
}

/// The time of a cast.
pub(super) fn cast_time(a: &Any, b: &Any, d: P, inside: Inside) -> Option<i64> {
    let set = sum(a, b);
    if set.holds::<Int256>((0, 0)) {
        return (inside == Inside::Hit).then_some(0);
    }
    set.met::<Int256>(d, ONE).then(|| floor(&set, d))
}
