//! Whether two shapes overlap, or touch: by the shortest test that settles it.

use super::boxes::Parallelogram;
use super::place::sharp;
use super::short_place::place_of;
use super::short_sides::shortly;
use super::walk::Core;
use crate::num::{Raw, SPLIT, Vec2};
use crate::query::meet::{circle_circle, circle_segment, segment_segment};

/// Whether two shapes overlap, or touch: exact.
pub(crate) fn meets<const CLOSED: bool>(a: Core<'_>, b: Core<'_>) -> bool {
    meets_by::<CLOSED>(a, b, false)
}

/// [`meets`]. For polygons, it may test the leading bits first.
pub(super) fn meets_by<const CLOSED: bool>(a: Core<'_>, b: Core<'_>, is_short: bool) -> bool {
    let radius = a.radius.wrapping_add(b.radius);
    if radius != 0 {
        return corners_meet::<CLOSED>(a, b, radius) || place_of(a, b).within::<CLOSED>(radius);
    }
    if let (Some(p), Some(q)) = (Parallelogram::of(a), Parallelogram::of(b)) {
        return p.meets::<CLOSED>(&q);
    }
    let settled = if SPLIT && is_short { shortly(a, b) } else { None };
    settled.unwrap_or_else(|| sharp::<CLOSED>(a, b).is_ok())
}

/// Whether two of the corners are near enough. That holds for most shapes that overlap and have few
/// corners.
pub(super) fn corners_meet<const CLOSED: bool>(a: Core<'_>, b: Core<'_>, radius: i32) -> bool {
    let near = |p: &Vec2, q: &Vec2| circle_circle::<CLOSED>(Raw::of(*p), Raw::of(*q), radius);
    a.corners.len().wrapping_add(b.corners.len()) <= 4 && a.corners.iter().any(|p| b.corners.iter().any(|q| near(p, q)))
}

/// Whether two segments are nearer than the radius, or as near. Where they do not cross, an end of
/// one is the nearest point to the other: for most that overlap, to an end of it.
pub(super) fn capsules_meet<const CLOSED: bool>([p, q]: [Raw; 2], [s, t]: [Raw; 2], radius: i32) -> bool {
    let near_end = |p: Raw, q: Raw| circle_circle::<CLOSED>(p, q, radius);
    let near = |end: Raw, a: Raw, b: Raw| circle_segment::<CLOSED>(end, radius, a, b);
    near_end(p, s)
        || near_end(p, t)
        || near_end(q, s)
        || near_end(q, t)
        || near(p, s, t)
        || near(q, s, t)
        || near(s, p, q)
        || near(t, p, q)
        || segment_segment::<false>(p, q, s, t)
}
