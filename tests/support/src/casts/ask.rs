//! The library under test, called with figures, and the checks of one case.

use super::judge::{Forbidden, ONE};
use super::number::Number;
use crate::oracle::figure::{Figure, Point};
use crate::oracle::kernel::{aabb, circle, point, segment, vec2};
use tilesat::prelude::*;
use tilesat::{Axis, CastHit, Inside, RangeError, Toi, query::MovingHit};

/// Calls `$body` with both figures as the library's shapes.
macro_rules! shapes {
    ($a:expr, $b:expr, |$x:ident, $y:ident| $body:expr) => {{
        macro_rules! second {
            ($first:expr) => {{
                let $x = $first;
                match *$b {
                    Figure::Aabb { min, max } => {
                        let $y = aabb(min, max);
                        $body
                    }
                    Figure::Circle { centre, radius } => {
                        let $y = circle(centre, radius);
                        $body
                    }
                    Figure::Segment { a, b } => {
                        let $y = segment(a, b);
                        $body
                    }
                }
            }};
        }
        match *$a {
            Figure::Aabb { min, max } => second!(aabb(min, max)),
            Figure::Circle { centre, radius } => second!(circle(centre, radius)),
            Figure::Segment { a, b } => second!(segment(a, b)),
        }
    }};
}

/// Everything that a cast reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answer {
    pub hit: Option<CastHit>,
    pub yes: bool,
    pub exact: Option<Toi>,
}

pub fn cast(a: &Figure, b: &Figure, d: Point, inside: Inside) -> Result<Answer, RangeError> {
    let motion = vec2(d);
    shapes!(a, b, |x, y| Ok(Answer {
        hit: x.cast_shape(&y, motion, inside)?,
        yes: x.would_hit(&y, motion, inside)?,
        exact: x.exact_toi(&y, motion, inside)?,
    }))
}

/// The interval of contact; an error if the motion ends outside of the domain.
pub fn interval(a: &Figure, b: &Figure, d: Point) -> Interval {
    shapes!(a, b, |x, y| x.contact_interval(&y, vec2(d)))
}

pub type Interval = Result<Option<(Toi, Toi)>, RangeError>;

pub fn cast_moving(a: &Figure, by_a: Point, b: &Figure, by_b: Point) -> Result<Option<MovingHit>, RangeError> {
    shapes!(a, b, |x, y| x.cast_moving(vec2(by_a), &y, vec2(by_b), Inside::Ignore))
}

/// What a case was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    Overlap,
    Miss,
    Hit,
}

/// Checks one cast against the judge. `tolerance` is how far, in raw units, the moved shape may be
/// from touching.
pub fn check<N: Number>(a: &Figure, b: &Figure, d: Point, tolerance: i64) -> Case {
    let case = || format!("{a:?} by {d:?} on {b:?}");
    let forth = |inside| cast(a, b, d, inside).unwrap_or_else(|e| panic!("{e}: {}", case()));
    let back = || cast(b, a, (-d.0, -d.1), Inside::Ignore);
    check_interval::<N>(&Forbidden::new(a, b), d, interval(a, b, d), case);
    verify::<N>(&Forbidden::new(a, b), d, tolerance, forth, back, case)
}

/// Checks the times of entry and exit: the exit by the way back from the end of the motion.
pub fn check_interval<N: Number>(set: &Forbidden, d: Point, interval: Interval, case: impl Fn() -> String) {
    let Ok(interval) = interval else { return };
    let (end, back) = (set.moved(d), (-d.0, -d.1));
    let overlaps = set.holds::<N>((0, 0)) || set.met::<N>(d, ONE);
    assert_eq!(interval.is_some(), overlaps, "interval: {}", case());
    let Some((entry, exit)) = interval.map(|(entry, exit)| (i64::from(entry.raw()), i64::from(exit.raw()))) else {
        return;
    };
    // The floor of a time: nothing is met up to it, and something in the next part.
    let floors = |set: &Forbidden, d: Point, time: i64| {
        if set.holds::<N>((0, 0)) { time == 0 } else { !set.met::<N>(d, time) && set.met::<N>(d, time + 1) }
    };
    assert!(floors(set, d, entry), "entry at {entry}: {}", case());
    assert!(floors(&end, back, ONE - exit), "exit at {exit}: {}", case());
}

/// Checks the answers of a cast by `d` and of the exchanged one, which may be out of range.
pub fn verify<N: Number>(
    set: &Forbidden,
    d: Point,
    tolerance: i64,
    forth: impl Fn(Inside) -> Answer,
    back: impl Fn() -> Result<Answer, RangeError>,
    case: impl Fn() -> String,
) -> Case {
    let (answer, other) = (forth(Inside::Ignore), forth(Inside::Hit));
    if set.holds::<N>((0, 0)) {
        assert_eq!(answer, Answer { hit: None, yes: false, exact: None }, "ignored overlap: {}", case());
        let hit = other.hit.unwrap_or_else(|| panic!("overlap not hit: {}", case()));
        assert!(other.yes && other.exact == Some(Toi::ZERO) && hit.inside, "{other:?}: {}", case());
        assert_eq!((hit.toi, hit.displacement, hit.axis), (Toi::ZERO, vec2((0, 0)), against(d)), "{}", case());
        return Case::Overlap;
    }
    assert_eq!(answer, other, "no overlap, so no choice: {}", case());
    exchanged(&answer, back(), &case);
    let wanted = set.met::<N>(d, ONE);
    assert_eq!(answer.yes, wanted, "the judge on the right: {}", case());
    assert_eq!((answer.hit.is_some(), answer.exact.is_some()), (wanted, wanted), "{}", case());
    let (Some(hit), Some(exact)) = (answer.hit, answer.exact) else { return Case::Miss };
    let (toi, exact) = (i64::from(hit.toi.raw()), i64::from(exact.raw()));
    assert!(exact < ONE && !set.met::<N>(d, exact), "exact toi {exact} is late: {}", case());
    assert!(set.met::<N>(d, exact + 1), "exact toi {exact} is early: {}", case());
    assert!(toi <= exact, "toi {toi} is late, {exact}: {}", case());
    assert!(set.radius > 0 || toi == exact, "toi {toi} is not the floor {exact}: {}", case());
    let square = i128::from(d.0).pow(2) + i128::from(d.1).pow(2);
    assert!(
        i128::from(exact - toi).pow(2) * square < i128::from(ONE).pow(2),
        "toi {toi} is early, {exact}: {}",
        case()
    );
    check_place::<N>(set, &hit, d, tolerance, case);
    Case::Hit
}

/// B by the reversed motion on A: the same time, and everything else reversed.
fn exchanged(answer: &Answer, other: Result<Answer, RangeError>, case: impl Fn() -> String) {
    // Its end may be outside the domain.
    let Ok(other) = other else { return };
    let back = answer.hit.map(|hit| CastHit { axis: -hit.axis, displacement: -hit.displacement, ..hit });
    assert_eq!(other, Answer { hit: back, ..*answer }, "exchanged: {}", case());
}

fn check_place<N: Number>(set: &Forbidden, hit: &CastHit, d: Point, tolerance: i64, case: impl Fn() -> String) {
    let step = point(hit.displacement);
    let part = |s: i64, d: i64| (0..=d.abs()).contains(&(s * d.signum())) && (d != 0 || s == 0);
    assert!(part(step.0, d.0) && part(step.1, d.1), "{step:?} is not a part: {}", case());
    assert!(!set.holds::<N>(step), "ends inside at {step:?}: {}", case());
    assert!(set.is_near::<N>(step, set.radius + tolerance), "ends short of it at {step:?}: {}", case());
    assert!(!hit.inside, "{}", case());
    // The axis opposes the motion, and the point is as far out along it as the set, within the
    // tolerance.
    let (nx, ny) = (i128::from(hit.axis.x), i128::from(hit.axis.y));
    let along = |p: Point| nx * i128::from(p.0) + ny * i128::from(p.1);
    assert!((nx != 0 && ny != 0) || nx.abs() + ny.abs() == 1, "{:?} is not a unit: {}", hit.axis, case());
    // At a corner it is the way from it to the point: as fine as the radius is large.
    let axis = (i64::from(hit.axis.x), i64::from(hit.axis.y));
    let radial = |v: &Point| {
        let way = (step.0 - v.0, step.1 - v.1);
        if way.0 == 0 || way.1 == 0 { (way.0.signum(), way.1.signum()) == axis } else { way == axis }
    };
    if set.radius > 0 && set.hull.iter().any(radial) {
        // In a graze it is across the motion, within the rounding of the point.
        let (with, square) = (along(d).max(0), i128::from(d.0).pow(2) + i128::from(d.1).pow(2));
        assert!(with * with <= 2 * square, "{:?} does not oppose: {}", hit.axis, case());
        return;
    }
    assert!(along(d) < 0, "{:?} does not oppose: {}", hit.axis, case());
    let core = set.hull.iter().map(|&v| along(v)).max().expect("a set has points");
    let out = is_out(along(step) - core, nx * nx + ny * ny, set.radius, tolerance);
    assert!(out, "{:?} is no normal there: {}", hit.axis, case());
}

/// Whether a height in units of an axis, whose square is given, is that of a distance, within a
/// tolerance.
pub fn is_out(height: i128, square: i128, distance: i64, tolerance: i64) -> bool {
    let above = |r: i64| {
        let r = i128::from(r);
        height.signum() * height * height - r.signum() * r * r * square
    };
    above(distance - tolerance) >= 0 && above(distance + tolerance) <= 0
}

/// The report of a start inside.
fn against(d: Point) -> Axis {
    if d.1.abs() > d.0.abs() {
        Axis::new(0, if d.1 > 0 { -1 } else { 1 })
    } else {
        Axis::new(if d.0 > 0 { -1 } else { 1 }, 0)
    }
}
