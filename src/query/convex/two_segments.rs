//! Two segments that are not parallel, without a walk around their sum.

use super::place::{NearestCorner, NearestPart};
use super::walk::PolygonSide;
use crate::num::{Raw, usqr};
use crate::query::meet::{Offset, is_within, near_line};

/// Two segments, and where the ends of each are relative to the line of the other one.
pub(super) struct TwoSegments {
    a: [Raw; 2],
    b: [Raw; 2],
    e: Offset,
    f: Offset,
    /// From the start of A to that of B.
    way: Offset,
    /// The heights of B's ends over A, and of A's ends over B, times the lengths: below 2^61.
    over_a: (i64, i64),
    over_b: (i64, i64),
}

impl TwoSegments {
    /// `None` for parallel segments, because two of their ends can be equally near.
    #[inline(always)]
    pub(super) fn of(a: [Raw; 2], b: [Raw; 2]) -> Option<Self> {
        let [e, f] = [a, b].map(|[from, to]| Offset::between(from, to));
        let way = Offset::between(a[0], b[0]);
        // From one end to the other, a height changes by the turn between the segments.
        let (turn, of_b, of_a) = (e.cross(f), e.cross(way), way.cross(f));
        let (over_a, over_b) = ((of_b, of_b.wrapping_add(turn)), (of_a, of_a.wrapping_sub(turn)));
        (turn != 0).then_some(Self { a, b, e, f, way, over_a, over_b })
    }

    /// Whether a point of A and one of B are nearer than the radius, or as near.
    #[inline(always)]
    pub(super) fn meet<const CLOSED: bool>(&self, radius: i32) -> bool {
        let (on_a, on_b) = (on_both_sides(self.over_a), on_both_sides(self.over_b));
        if on_a && on_b {
            return true;
        }
        if !on_a {
            let (is_last, height) = nearer(self.over_a);
            let from = if is_last { self.way.add(self.f) } else { self.way };
            if let Some(meet) = near_end::<CLOSED>(from, self.e, height, radius) {
                return meet;
            }
        }
        !on_b && {
            let (is_last, height) = nearer(self.over_b);
            let from = self.way.reversed();
            let from = if is_last { from.add(self.e) } else { from };
            near_end::<CLOSED>(from, self.f, height, radius) == Some(true)
        }
    }

    /// Where the origin is relative to their sum. None if an end is on the line of the other
    /// one.
    #[inline(always)]
    pub(super) fn place(&self) -> Option<NearestPart> {
        if self.over_a.0 == 0 || self.over_a.1 == 0 || self.over_b.0 == 0 || self.over_b.1 == 0 {
            return None;
        }
        let mut nearest = NearestCorner::none();
        for (heights, of_a) in [(self.over_a, true), (self.over_b, false)] {
            // With one on both sides of the line, the origin is before neither of these two sides.
            if !on_both_sides(heights) {
                let (side, height, end) = self.side(heights, of_a);
                let place = nearest.add(&side, height, end);
                if place.is_some() {
                    return place;
                }
            }
        }
        Some(nearest.place())
    }

    /// The side of the sum that comes from one segment and has the origin on its right. Also
    /// returns the height of the origin, and the corners at which the side ends.
    #[inline(always)]
    fn side(&self, heights: (i64, i64), of_a: bool) -> (PolygonSide, u64, (usize, usize)) {
        let (is_last, height) = nearer(heights);
        let near = usize::from(is_last);
        // Sides of the reversed B run backward.
        let begin = usize::from(heights.0 > 0);
        let edge = if of_a { self.e } else { self.f }.raw();
        let edge = if (begin == 0) == of_a { edge } else { edge.reversed() };
        let ((i, j), end) = if of_a { ((begin, near), (1 - begin, near)) } else { ((near, begin), (near, 1 - begin)) };
        let side = PolygonSide { from: end_of(self.a, i).sub(end_of(self.b, j)), edge, a: i, b: j, of_a, of_b: !of_a };
        (side, height.unsigned_abs(), end)
    }
}

/// Whether the ends are on different sides of a line, and not on it.
#[inline(always)]
const fn on_both_sides(heights: (i64, i64)) -> bool {
    heights.0 ^ heights.1 < 0 && heights.0 != 0 && heights.1 != 0
}

/// Whether the last end is the nearer one to the line, and the height of the nearer one.
#[inline(always)]
const fn nearer((first, last): (i64, i64)) -> (bool, i64) {
    if first.unsigned_abs() < last.unsigned_abs() { (false, first) } else { (true, last) }
}

/// The first or the last end of a segment.
#[inline(always)]
pub(super) const fn end_of([first, last]: [Raw; 2], index: usize) -> Raw {
    if index == 0 { first } else { last }
}

/// Whether an end of a segment is near enough to another segment; `None` if the other side decides.
/// It is the end nearest to the line of `edge`, and `from` leads to it from the start of `edge`.
#[inline(always)]
const fn near_end<const CLOSED: bool>(from: Offset, edge: Offset, height: i64, radius: i32) -> Option<bool> {
    if !near_line::<CLOSED>(height, radius, edge.len2()) {
        return Some(false);
    }
    let foot = edge.dot(from);
    let corner = if foot < 0 {
        from
    } else if foot as u64 > edge.len2() {
        from.sub(edge)
    } else {
        return Some(true);
    };
    if is_within::<CLOSED>(corner.len2(), usqr(radius as u32)) { Some(true) } else { None }
}
