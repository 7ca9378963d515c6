//! Through which of its sides and corners a body enters a full cell.

use crate::num::{Raw, umul};

/// The part of a full cell's outline that a motion enters. A cell grown by a body is convex, so
/// there is only one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EnteredPart {
    /// The side that the motion reaches along x.
    X,
    /// The side that it reaches along y.
    Y,
    /// Both sides at once: a corner of a box meets their corner exactly.
    Both,
    /// The corner of a rounded body toward these sides, each 1 or -1.
    Corner(i32, i32),
}

/// One axis, mirrored if the motion leads against it. The core is a point at 0 that moves by `way`
/// toward the cell, which the core has grown. `way` is not negative.
struct Along {
    /// The nearer side of the cell.
    near: i32,
    /// The farther one.
    far: i32,
    /// From the body to the nearer side. Below zero if it is already past that.
    gap: i32,
    way: i32,
    /// The direction of the nearer side.
    side: i32,
}

impl Along {
    /// Nothing if the body never comes between the sides: at them is not between.
    #[inline]
    fn of((first, last): (i32, i32), r: i32, d: i32, (lo, hi): (i32, i32)) -> Option<Self> {
        let (near, far) = (lo.wrapping_sub(last), hi.wrapping_sub(first));
        let (near, far, way, side) =
            if d < 0 { (far.wrapping_neg(), near.wrapping_neg(), d.wrapping_neg(), 1) } else { (near, far, d, -1) };
        let gap = near.wrapping_sub(r);
        (gap < way && far.wrapping_add(r) > 0).then_some(Self { near, far, gap, way, side })
    }

    /// Where this coordinate is when the body reaches the nearer side of the other axis, after
    /// `gap / way` of the motion. A rounded body enters a side at its ends too.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline)]
    fn place(&self, other: &Self, round: bool) -> Place {
        // That part is from 0 to less than 1. Mostly this decides, without a product.
        if self.near > 0 && self.near >= self.way {
            return Place::Before;
        }
        if self.near < 0 && self.far > 0 && self.far >= self.way {
            return Place::Between;
        }
        let made = umul(self.way as u32, other.gap as u32);
        if self.near >= 0 {
            let at = umul(self.near as u32, other.way as u32);
            if made < at {
                return Place::Before;
            }
            if made == at && !round {
                return Place::AtNear;
            }
        }
        // A rounded body at the end of a side still meets it. Comparisons: orderings took 16 bytes
        // more.
        let is_between = self.far >= 0 && made < umul(self.far as u32, other.way as u32).wrapping_add(round.into());
        if is_between { Place::Between } else { Place::Beyond }
    }
}

/// The position of a body along one axis, relative to the sides of a cell.
enum Place {
    Before,
    /// A box, exactly at the nearer side.
    AtNear,
    Between,
    Beyond,
}

/// The part that the core `first..last`, with the radius `r` around it, enters as it moves by `d`
/// to the cell `lo..hi`. For bodies with area that do not overlap the cell.
///
/// What it says of sides is exact. The corner that it names may be missed, but no other part is
/// entered, and the disc around that corner only in the corner's quadrant.
///
/// ```text
///   both :   Y    : beyond    Where the body reaches the line of the near side along x decides:
///   - - -+--------+- - -      between the lines along y it enters X, after them at most the
///        |        |           corner beyond. Before them, the line along y decides likewise. The
///     X  |  cell  |           body is r before the lines then; if it reaches both before the
///        |        |           sides begin, only the corner of both is ahead.
///   - - -+--------+- - -
/// beyond :        :
/// ```
#[cfg_attr(target_pointer_width = "64", inline(always))]
#[cfg_attr(not(target_pointer_width = "64"), inline)]
pub(super) fn entered((first, last): (Raw, Raw), r: i32, d: Raw, (lo, hi): (Raw, Raw)) -> Option<EnteredPart> {
    let x = Along::of((first.x, last.x), r, d.x, (lo.x, hi.x))?;
    let y = Along::of((first.y, last.y), r, d.y, (lo.y, hi.y))?;
    let (round, both) = (r != 0, EnteredPart::Corner(x.side, y.side));
    let beyond_y = EnteredPart::Corner(x.side, y.side.wrapping_neg());
    let beyond_x = EnteredPart::Corner(x.side.wrapping_neg(), y.side);
    if x.gap >= 0 {
        match y.place(&x, round) {
            Place::Between => return Some(EnteredPart::X),
            Place::AtNear => return Some(EnteredPart::Both),
            Place::Beyond => return round.then_some(beyond_y),
            Place::Before => {}
        }
    }
    if y.gap >= 0 {
        return match x.place(&y, round) {
            Place::Between => Some(EnteredPart::Y),
            Place::AtNear => Some(EnteredPart::Both),
            Place::Beyond => round.then_some(beyond_x),
            Place::Before => round.then_some(both),
        };
    }
    // It is past the lines of both near sides, grown by the radius, or comes before y to that of x:
    // only beside a corner is it outside. Into one that is not ahead along both axes it has to move
    // along the other.
    let (before_x, before_y) = (x.near > 0, y.near > 0);
    let (after_x, after_y) = (x.far < 0, y.far < 0);
    if before_x && before_y {
        Some(both)
    } else if before_x && after_y && x.way > 0 {
        Some(beyond_y)
    } else if after_x && before_y && y.way > 0 {
        Some(beyond_x)
    } else {
        None
    }
}
