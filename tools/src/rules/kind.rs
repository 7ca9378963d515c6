//! The kind of an object, from its author's name for it.

use std::fmt;

use tilesat::TileShape;

use super::traits;
use super::words::plain;

/// The kind of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Solid within.
    Solid,
    /// Free within, cut out of solids.
    Hole,
    /// A chain that blocks from both sides.
    Wall,
    /// A chain that blocks from the left of its way. Drawn to the right, it is a floor (y down).
    OneWay,
}

impl Kind {
    /// Ignores case, hyphens, underscores and a plural. Words for one-way can have others beside
    /// them.
    pub fn from_name(name: &str) -> Option<Self> {
        let text = plain(name);
        Some(match text.strip_suffix('s').unwrap_or(&text) {
            "solid" | "collision" | "collide" | "collidable" | "collider" | "blocked" => Self::Solid,
            "hole" => Self::Hole,
            "wall" => Self::Wall,
            _ if traits::shape(name) == Some(TileShape::OneWayUp) => Self::OneWay,
            _ => return None,
        })
    }

    /// Whether it stops bodies from all sides.
    pub(crate) fn is_solid(self) -> bool {
        matches!(self, Self::Solid | Self::Wall)
    }

    /// Whether the outline has an inside.
    pub fn has_area(self) -> bool {
        matches!(self, Self::Solid | Self::Hole)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Solid => "solid",
            Self::Hole => "hole",
            Self::Wall => "wall",
            Self::OneWay => "one-way",
        })
    }
}
