//! The last separation of two shapes. It is tested first, because it mostly still separates them.

use super::each_side;
use super::meets::corners_meet;
use super::place::{NearestPart, sharp};
use super::short_place::place_of;
use super::short_sides::shortly;
use super::walk::{Core, Corner, PolygonSide, turn};
use crate::num::{Raw, SPLIT, less128, mul64, sqr64, usqr};
use crate::query::overlap::Overlaps;

/// The last separation of two shapes: a side of one, or the line between two corners.
///
/// Shapes that are near but apart mostly stay so from frame to frame, by the same side. Keep one of
/// these for each pair of bodies, and pass it to
/// [`overlaps_from`](crate::query::OverlapsFrom::overlaps_from). It is only a hint: no content,
/// even of another pair, changes an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Separation {
    /// Corners of A and of B: a side begins at one, and the other is the nearest to its line. Or
    /// they are the nearest to each other.
    a: u16,
    b: u16,
    by: By,
}

/// Whether two shapes overlap, with a hint from the last frame.
///
/// The answer is that of [`overlaps`](Overlaps::overlaps). It is faster if the side that last
/// separated the shapes still separates them. Two sharp oriented boxes read it only if they nearly
/// touch. It exists for all pairs of shapes except boxes, circles and segments among themselves.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Capsule, Vec2, fx, query::Separation};
/// let wall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(40, 8))?;
/// let mut ship = Capsule::new(Vec2::from_ints(10, 40), Vec2::from_ints(16, 44), fx!(3))?;
/// let mut last = Separation::default(); // one for this pair of bodies
/// while !ship.overlaps_from(&wall, &mut last) {
///     ship = ship.translated(Vec2::from_ints(0, -1))?;
/// }
/// assert_eq!(ship.aabb().min().y, fx!(7));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait OverlapsFrom<B: ?Sized>: Overlaps<B> {
    /// Whether this shape overlaps `b`.
    ///
    /// `last` is the hint that the last call for this pair stored.
    #[must_use]
    fn overlaps_from(&self, b: &B, last: &mut Separation) -> bool;
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum By {
    #[default]
    SideOfA,
    SideOfB,
    Corners,
}

impl Separation {
    const fn side(side: &PolygonSide) -> Self {
        Self { a: side.a as u16, b: side.b as u16, by: if side.of_a { By::SideOfA } else { By::SideOfB } }
    }

    const fn corners(corner: &Corner) -> Self {
        Self { a: corner.a as u16, b: corner.b as u16, by: By::Corners }
    }

    /// Whether it still separates the shapes: by three or four signs of products, and by squares
    /// if there are radii.
    fn separates(self, a: Core<'_>, b: Core<'_>) -> bool {
        let (i, j) = (usize::from(self.a), usize::from(self.b));
        if i >= a.corners.len() || j >= b.corners.len() {
            return false;
        }
        match self.by {
            By::SideOfA => is_behind_side(a, i, b, j),
            By::SideOfB => is_behind_side(b, j, a, i),
            By::Corners => are_nearest_corners(a, i, b, j),
        }
    }
}

/// A corner whose neighbours are not nearer is the nearest one: the shape is convex.
fn is_nearest(core: Core<'_>, i: usize, is_behind: impl Fn(Raw) -> bool) -> bool {
    let at = core.corner(i);
    is_behind(core.corner(core.after(i)).sub(at)) && is_behind(core.corner(core.before(i)).sub(at))
}

/// Whether all of B is behind a side of A, by its corner `j`.
fn is_behind_side(a: Core<'_>, i: usize, b: Core<'_>, j: usize) -> bool {
    let from = a.corner(i);
    let edge = a.corner(a.after(i)).sub(from);
    let offset = b.corner(j).sub(from);
    let is_behind = |v: Raw| turn(edge, v) <= 0;
    if a.corners.len() < 2 || !is_behind(offset) || !is_nearest(b, j, is_behind) {
        return false;
    }
    let radius = a.radius.wrapping_add(b.radius);
    // Below 2^122 and 2^121.
    radius == 0 || !less128(sqr64(edge.cross(offset).unsigned_abs()), mul64(usqr(radius as u32), edge.len2()))
}

/// Whether each shape is behind its corner, relative to the other's, and they are far enough apart.
fn are_nearest_corners(a: Core<'_>, i: usize, b: Core<'_>, j: usize) -> bool {
    let way = b.corner(j).sub(a.corner(i));
    way.len2() >= usqr(a.radius.wrapping_add(b.radius) as u32)
        && !way.is_zero()
        && is_nearest(a, i, |v| way.dot(v) <= 0)
        && is_nearest(b, j, |v| way.dot(v) >= 0)
}

/// Whether two shapes overlap, the last side first.
pub(super) fn overlaps(a: Core<'_>, b: Core<'_>, last: &mut Separation) -> bool {
    if last.separates(a, b) {
        return false;
    }
    let radius = a.radius.wrapping_add(b.radius);
    let meet = if radius != 0 {
        corners_meet::<false>(a, b, radius)
    } else if each_side::are_few(a, b) {
        each_side::meet::<false>(a, b)
    } else {
        SPLIT && shortly(a, b) == Some(true)
    };
    if meet {
        return true;
    }
    let apart_by = if radius == 0 {
        match sharp::<false>(a, b) {
            Ok(()) => return true,
            Err(side) => side.as_ref().map(Separation::side),
        }
    } else {
        match place_of(a, b) {
            place if place.within::<false>(radius) => return true,
            NearestPart::Side(side, _) => Some(Separation::side(&side)),
            NearestPart::Corner(corner) => Some(Separation::corners(&corner)),
            NearestPart::Inside => None,
        }
    };
    if let Some(apart_by) = apart_by {
        *last = apart_by;
    }
    false
}
