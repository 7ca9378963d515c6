//! A moving circle against a box: a box with rounded corners that its centre comes into.

use super::boxes::{Side, meet_box};
use super::circles::{Disc, meet_disc};
use super::crossing::enters;
use super::kernel::Moment;
use crate::num::{Axis, Raw, Toi, imul};
use crate::shape::{Aabb, Circle};

/// The part of a rounded box that a point meets.
#[derive(Clone, Copy, Debug)]
pub enum Rounded {
    /// A straight side, the box's own moved out by the radius.
    Side(Side),
    /// The disc around a corner.
    Corner(Disc),
}

/// The only part of a rounded box that a motion can come in through.
#[derive(Clone, Copy)]
pub(super) enum Gate {
    /// A side, which it does come through.
    Side(Side),
    /// The disc around a corner.
    Corner(Raw),
}

impl Gate {
    /// What a circle that moves by `d` meets of it.
    #[inline]
    pub(super) fn enter(self, circle: &Circle, d: Raw) -> Option<Rounded> {
        match self {
            Self::Side(side) => Some(Rounded::Side(side)),
            Self::Corner(corner) => meet_disc(circle.c().sub(corner), circle.r(), d).map(Rounded::Corner),
        }
    }

    /// Whether it meets any.
    #[inline]
    pub(super) fn hits(self, circle: &Circle, d: Raw) -> bool {
        match self {
            Self::Side(_) => true,
            Self::Corner(corner) => enters(circle.c().sub(corner), circle.r(), d),
        }
    }
}

/// Where a circle that moves by `d` can start to overlap a box, where it does not overlap already: a call of its own, whose stack
/// is free again when a disc is tested.
#[inline(never)]
pub(super) fn gate(circle: &Circle, b: &Aabb, d: Raw) -> Option<Gate> {
    gate_here(circle, b, d)
}

/// The same without a call.
///
/// The rounded box lies in the box grown by r. Where a motion comes into that beside a side of the box itself, it has met the
/// rounded box; else it is in the square of radius r beside one corner, and leaves it through the corner's disc, or leaves
/// the grown box: one disc is enough. The same holds for a start in the grown box.
///
/// ```text
///       .-------------.        ,  the square of a corner
///     ,   +---------+  `
///     |   |   box   |   |
///     '   +---------+  ,
///       `-------------'
/// ```
#[inline(always)]
pub(super) fn gate_here(circle: &Circle, b: &Aabb, d: Raw) -> Option<Gate> {
    let (c, r, lo, hi) = (circle.c(), circle.r(), b.lo(), b.hi());
    let (far_lo, far_hi) = grown(lo, hi, r);
    let within = c.x > far_lo.x && c.x < far_hi.x && c.y > far_lo.y && c.y < far_hi.y;
    let corner = if within {
        Raw { x: if c.x < lo.x { lo.x } else { hi.x }, y: if c.y < lo.y { lo.y } else { hi.y } }
    } else {
        let side = meet_box(c, c, far_lo, far_hi, d)?;
        // A circle of no radius has no corners to meet: its grown box is the box, and that is open.
        let beyond = if r == 0 { 0 } else { side.beyond(c, lo, hi, d) };
        if beyond == 0 {
            return Some(Gate::Side(side));
        }
        side.corner(lo, hi, beyond)
    };
    Some(Gate::Corner(corner))
}

/// A box with its sides moved out, by a length below 2^29.
pub(super) const fn grown(lo: Raw, hi: Raw, by: i32) -> (Raw, Raw) {
    let by = Raw { x: by, y: by };
    (lo.sub(by), hi.add(by))
}

impl Side {
    /// On which side of the box the point `c` is, along this side, when it meets it: -1, 0 (ends included), 1.
    ///
    /// Offsets and speeds below 2^30: sums of two products below 2^61.
    fn beyond(&self, c: Raw, lo: Raw, hi: Raw, d: Raw) -> i32 {
        let (c, lo, hi, d) = if self.axis.x != 0 { (c.y, lo.y, hi.y, d.y) } else { (c.x, lo.x, hi.x, d.x) };
        let way = imul(d, self.gap as i32);
        let at = |end: i32| imul(c.wrapping_sub(end), self.speed as i32).wrapping_add(way);
        if at(lo) < 0 { -1 } else { i32::from(at(hi) > 0) }
    }

    /// The corner of the box at an end of this side.
    fn corner(&self, lo: Raw, hi: Raw, end: i32) -> Raw {
        let along = |lo: i32, hi: i32, sign: i32| if sign < 0 { lo } else { hi };
        if self.axis.x != 0 {
            Raw { x: along(lo.x, hi.x, self.axis.x), y: along(lo.y, hi.y, end) }
        } else {
            Raw { x: along(lo.x, hi.x, end), y: along(lo.y, hi.y, self.axis.y) }
        }
    }
}

impl Moment for Rounded {
    fn exact_toi(&self, d: Raw) -> Toi {
        match self {
            Self::Side(side) => side.exact_toi(d),
            Self::Corner(disc) => disc.exact_toi(d),
        }
    }

    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        match self {
            Self::Side(side) => side.contact(d),
            Self::Corner(disc) => disc.contact(d),
        }
    }
}
