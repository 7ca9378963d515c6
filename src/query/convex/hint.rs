//! The side that separated two shapes last: asked first, it mostly still does.

use super::place::{Place, sharp};
use super::walk::{Core, PolygonSide, turn};
use crate::num::{Raw, less128, mul64, sqr64, usqr};

/// The side of one of two shapes that last separated them: the other one was behind it.
///
/// Shapes that are near but apart mostly stay so from frame to frame, by the same side. Keep one of
/// these for each pair of bodies, and pass it to
/// [`overlaps_from`](crate::query::OverlapsFrom::overlaps_from). It is only a hint: no content,
/// even of another pair, changes an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Separation {
    /// Corners of A and of B: one is where the side begins, the other is the nearest to its line.
    a: u16,
    b: u16,
    of_b: bool,
}

impl Separation {
    const fn of(side: &PolygonSide) -> Self {
        Self { a: side.a as u16, b: side.b as u16, of_b: !side.of_a }
    }

    /// Whether the side still separates the shapes: three signs of products, and two squares where
    /// there are radii.
    fn separates(self, a: Core<'_>, b: Core<'_>) -> bool {
        let (a, i, b, j) = if self.of_b { (b, self.b, a, self.a) } else { (a, self.a, b, self.b) };
        let (i, j) = (usize::from(i), usize::from(j));
        if a.corners.len() < 2 || i >= a.corners.len() || j >= b.corners.len() {
            return false;
        }
        let (from, near) = (a.corner(i), b.corner(j));
        let edge = a.corner(a.after(i)).sub(from);
        // A corner whose neighbours are not nearer is the nearest one: the shape is convex.
        let is_behind = |v: Raw| turn(edge, v) <= 0;
        let offset = near.sub(from);
        if !is_behind(offset)
            || !is_behind(b.corner(b.after(j)).sub(near))
            || !is_behind(b.corner(b.before(j)).sub(near))
        {
            return false;
        }
        let radius = a.radius.wrapping_add(b.radius);
        // Below 2^122 and 2^121.
        radius == 0 || !less128(sqr64(edge.cross(offset).unsigned_abs()), mul64(usqr(radius as u32), edge.len2()))
    }
}

/// Whether two shapes overlap, the last side first.
pub(super) fn overlaps(a: Core<'_>, b: Core<'_>, last: &mut Separation) -> bool {
    if last.separates(a, b) {
        return false;
    }
    let radius = a.radius.wrapping_add(b.radius);
    let apart_by = if radius == 0 {
        match sharp::<false>(a, b) {
            Ok(()) => return true,
            Err(side) => side,
        }
    } else {
        match Place::of(a, b) {
            place if place.within::<false>(radius) => return true,
            Place::Side(side, _) => Some(side),
            _ => None,
        }
    };
    if let Some(side) = apart_by {
        *last = Separation::of(&side);
    }
    false
}
