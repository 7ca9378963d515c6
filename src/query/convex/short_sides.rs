//! Whether two polygons overlap, by the leading bits of their corners.
//!
//! For cores on which a long product is a call: each side against the corners of the other polygon,
//! with products of words. It settles nearly all pairs in a third of a walk around the sum.

use super::margins::{shift_to, short, short_cross, spread};
use super::walk::Core;
use crate::num::Raw;
use crate::shape::Aabb;
use core::mem::replace;

/// The most corners of a polygon with short sides.
const CORNERS: usize = 8;

/// A component loses less than one, both in a corner and in a side. So a product of a side and a
/// difference of corners, below 2^14 each, is off by less than the sum of their components and two.
const OFF: i32 = (1 << 16) + 2;

/// The corners of a polygon, relative to a near point, with 13 bits and a sign.
struct ShortPolygon {
    corners: [Raw; CORNERS],
    count: usize,
}

impl ShortPolygon {
    fn of(core: Core<'_>, at: Raw, shift: u32) -> Self {
        let mut corners = [Raw::ZERO; CORNERS];
        for (seen, p) in corners.iter_mut().zip(core.corners) {
            *seen = short(Raw::of(*p).sub(at), shift);
        }
        Self { corners, count: core.corners.len() }
    }

    fn corners(&self) -> &[Raw] {
        self.corners.get(..self.count).unwrap_or(&[])
    }

    /// Whether some corner of the other polygon is surely inside of each side, or all are surely
    /// outside of one.
    fn is_reached_by(&self, other: &Self) -> Option<bool> {
        let mut surely = Some(true);
        let mut from = self.corners().last().copied().unwrap_or(Raw::ZERO);
        for to in self.corners() {
            let edge = to.sub(from);
            let line = short_cross(edge, replace(&mut from, *to));
            let reach = |p: &Raw| short_cross(edge, *p).wrapping_sub(line);
            if !other.corners().iter().any(|p| reach(p) > OFF) {
                if other.corners().iter().all(|p| reach(p) < -OFF) {
                    return Some(false);
                }
                surely = None;
            }
        }
        surely
    }
}

/// Whether two polygons overlap, and whether they touch, if that is as plain as it mostly is.
pub(super) fn shortly(a: Core<'_>, b: Core<'_>, (p, q): &(Aabb, Aabb)) -> Option<bool> {
    let (n, m) = (a.corners.len(), b.corners.len());
    if n < 3 || m < 3 || n > CORNERS || m > CORNERS {
        return None;
    }
    let at = p.lo();
    let far = [p.hi(), q.lo(), q.hi()].iter().fold(0, |bits, p| bits | spread(p.sub(at)));
    let shift = shift_to(13, far);
    let (a, b) = (ShortPolygon::of(a, at, shift), ShortPolygon::of(b, at, shift));
    match a.is_reached_by(&b) {
        Some(true) => b.is_reached_by(&a),
        Some(false) => Some(false),
        None => (b.is_reached_by(&a) == Some(false)).then_some(false),
    }
}
