//! A ray against one piece of a surface: whether it is met, when as an exact fraction, and which of two pieces comes first.

use super::arc;
use super::level::RayPieces;
use crate::num::{Axis, Raw, less128, mul64, umul};
use crate::world::{Feature, Geometry};

/// A fraction of a motion, `num / den` with `num <= den` and `den > 0`.
///
/// On tiles both are words: slopes are (1, 1), (1, 2) and (2, 1), so they are below 3 * 2^30. On free segments they are below 2^61.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Time {
    pub(in crate::world) num: u64,
    pub(in crate::world) den: u64,
}

impl Time {
    /// Whether this is less than `rhs`, exactly.
    #[inline]
    pub(in crate::world) fn before<L: RayPieces>(self, rhs: Self) -> bool {
        if L::WIDE {
            less128(mul64(self.num, rhs.den), mul64(rhs.num, self.den))
        } else {
            umul(self.num as u32, rhs.den as u32) < umul(rhs.num as u32, self.den as u32)
        }
    }
}

/// How a piece is met.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Touch {
    /// `None` for a point within an arc, which is no fraction in general.
    pub(in crate::world) time: Option<Time>,
    /// The outward normal, reduced; of a point within an arc the zero axis.
    pub(in crate::world) normal: Axis,
}

/// A piece that is met, and how.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Met {
    pub(in crate::world) feature: Feature,
    pub(in crate::world) touch: Touch,
}

impl Touch {
    /// Whether a ray by `d` meets the piece `of` so before another one, or at the same moment and this is to be reported instead.
    ///
    /// A point within an arc is later than any fraction that a ray meets in the same step: the tile's other pieces are on the border of
    /// its cell, and what is met on the border is met where the ray comes in. (A face on the border opposes rays that come in
    /// across it, so one that is met where the ray leaves is met by a ray that has a single point in the cell.)
    pub(in crate::world) fn precedes<L: RayPieces>(&self, of: &Feature, other: &Met, d: Raw) -> bool {
        let (Some(a), Some(b)) = (self.time, other.touch.time) else { return self.time.is_some() };
        if a.before::<L>(b) {
            return true;
        }
        !b.before::<L>(a) && self.ranks_above(of, other, d)
    }

    /// At one moment: the normal that is more along x, then the one that opposes the motion more, then +x, then +y; then straight before round.
    #[inline(never)]
    pub(in crate::world) fn ranks_above(&self, of: &Feature, other: &Met, d: Raw) -> bool {
        let (n, m) = (self.normal, other.touch.normal);
        // n.x^2 / |n|^2 is decreasing in |n.y| / |n.x|; the products are below 2^60.
        let (a, b) = (cross_size(n.y, m.x), cross_size(m.y, n.x));
        if a != b {
            return a < b;
        }
        // Equal shares of reduced axes are equal components, signs apart: so are the lengths.
        if n != m {
            // The motion against a normal is below 2^61.
            let (by_n, by_m) = (d.dot(Raw { x: n.x, y: n.y }), d.dot(Raw { x: m.x, y: m.y }));
            return by_n < by_m || (by_n == by_m && (n.x > m.x || (n.x == m.x && n.y > m.y)));
        }
        matches!(other.feature.geometry, Geometry::Arc { .. }) && matches!(of.geometry, Geometry::Face { .. })
    }
}

fn cross_size(a: i32, b: i32) -> u64 {
    umul(a.unsigned_abs(), b.unsigned_abs())
}

/// How a ray from `o` by `d` meets a piece, if it does.
///
/// Vertices are ends of other pieces, which are closed.
#[inline]
pub(in crate::world) fn meet<L: RayPieces>(o: Raw, d: Raw, feature: &Feature) -> Option<Touch> {
    match &feature.geometry {
        Geometry::Face { a, dir, len, .. } => meet_face(o.sub(Raw::of(*a)), d, *dir, *len),
        Geometry::Arc { centre, radius, quadrant, convex } if L::ROUND => {
            arc::meet(o.sub(Raw::of(*centre)), d, *radius, *quadrant, *convex)
        }
        _ => None,
    }
}

/// When a ray from `w` (relative to the start of the face) crosses the closed face against its normal `(dir.y, -dir.x)`.
///
/// At the moment T = (w x dir) / (dir x d) it is at the place s = (w x d) / (dir x d) along dir. The face is `e = dir len` long,
/// so s <= len is w x d <= e x d. Differences and motions are below 2^30 and `e` is a difference: all products are below 2^61.
#[inline(never)]
fn meet_face(w: Raw, d: Raw, dir: Axis, len: i32) -> Option<Touch> {
    let t = Raw { x: dir.x, y: dir.y };
    let den = t.cross(d);
    if den <= 0 {
        return None;
    }
    let num = w.cross(t);
    if num < 0 || num > den {
        return None;
    }
    let place = w.cross(d);
    let end = Raw { x: dir.x.wrapping_mul(len), y: dir.y.wrapping_mul(len) };
    if place < 0 || place > end.cross(d) {
        return None;
    }
    let time = Time { num: num as u64, den: den as u64 };
    Some(Touch { time: Some(time), normal: Axis::new(dir.y, dir.x.wrapping_neg()) })
}
