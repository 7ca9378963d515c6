//! What a segment map is built from: polygons and chains of points.

use crate::num::Vec2;

/// What a [`Path`] is.
///
/// ```text
///   Solid, either way round     Wall             OneWay, y down as on a screen
///      +-->--+                    both sides           ^      ^
///      |#####|                  +----+              +-->--+-->--+   to the right: blocks what falls on it
///      +--<--+                        `--+
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PathKind {
    /// A closed polygon, in either winding, that is solid inside.
    Solid,
    /// A closed polygon, in either winding, that takes its inside out of the solids that it lies in. A part in the open has edges with
    /// nothing behind them, and so have parts of polygons that cross or touch themselves: bodies pass those from behind and stay there. The
    /// example `lint` finds them.
    Hole,
    /// An open chain without thickness that blocks from both sides. Where the last point is the first, it is a loop.
    Wall,
    /// An open chain whose faces block only what comes from their front, `(dir.y, -dir.x)`, around the chain's convex corners too. A free end carries by
    /// its face alone, with nothing around it: a body over the upper end of a slope falls past it, so end a slope with a level piece.
    OneWay,
}

impl PathKind {
    pub(super) const fn is_polygon(self) -> bool {
        matches!(self, Self::Solid | Self::Hole)
    }
}

/// A polygon or a chain of line segments, with flags for all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Path<'a> {
    /// The corners. The last one of a polygon joins the first, which is not repeated.
    pub points: &'a [Vec2],
    /// What it is.
    pub kind: PathKind,
    /// The user's flags.
    pub flags: u8,
}

impl<'a> Path<'a> {
    /// A polygon or a chain without flags.
    #[must_use]
    pub const fn new(kind: PathKind, points: &'a [Vec2]) -> Self {
        Self { points, kind, flags: 0 }
    }

    /// The same path with these flags instead of its own.
    #[must_use]
    pub const fn with_flags(self, flags: u8) -> Self {
        Self { flags, ..self }
    }
}
