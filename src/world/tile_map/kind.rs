//! What the tiles of a level are: shapes, user flags, and the table from ids to both.

use crate::world::TileShape;

/// A shape and eight flags that mean what the game likes: coin, ladder, deadly, ...
///
/// Flags of tiles that are not solid count too: see [`TileMap::flags_touched`](crate::world::TileMap::flags_touched).
///
/// ```
/// use tilesat::TileKind;
/// const DEADLY: u8 = 1;
/// let spikes = TileKind::FULL.with_flags(DEADLY);
/// assert!(spikes.flag(DEADLY));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TileKind {
    /// The solid part.
    pub shape: TileShape,
    /// The user's flags.
    pub flags: u8,
}

impl TileKind {
    /// Nothing solid, no flags.
    pub const EMPTY: Self = Self::of(TileShape::Empty);
    /// A solid cell.
    pub const FULL: Self = Self::of(TileShape::Full);
    /// A platform that can be entered from below.
    pub const ONE_WAY_UP: Self = Self::of(TileShape::OneWayUp);

    /// A shape without flags.
    #[must_use]
    pub const fn of(shape: TileShape) -> Self {
        Self { shape, flags: 0 }
    }

    /// The same shape with these flags instead of its own.
    #[must_use]
    pub const fn with_flags(self, flags: u8) -> Self {
        Self { shape: self.shape, flags }
    }

    /// Whether any flag of this mask is set.
    #[must_use]
    pub const fn flag(self, mask: u8) -> bool {
        self.flags & mask != 0
    }

    pub(in crate::world) const fn is_full(self) -> bool {
        matches!(self.shape, TileShape::Full)
    }

    pub(in crate::world) const fn is_empty(self) -> bool {
        matches!(self.shape, TileShape::Empty)
    }

    /// The side whose edge blocks, of a one-way tile: 0 toward row 0, turning right.
    pub(in crate::world) const fn one_way_side(self) -> Option<u8> {
        match (self.shape as u8).checked_sub(TileShape::OneWayUp as u8) {
            Some(side) if side < 4 => Some(side),
            _ => None,
        }
    }
}

/// What each of the 256 tile ids is: 512 bytes, usually a `static` in flash, shared by all maps of a game.
///
/// ```
/// use tilesat::{TileKind, TileKinds};
/// static KINDS: TileKinds = TileKinds::EMPTY
///     .with(b'#', TileKind::FULL)
///     .with(b'-', TileKind::ONE_WAY_UP)
///     .with(b'$', TileKind::EMPTY.with_flags(1));
/// assert_eq!(KINDS.get(b'#'), TileKind::FULL);
/// assert_eq!(KINDS.get(b'?'), TileKind::EMPTY);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TileKinds {
    /// Apart, so that a walk over the shapes is one index away from each.
    shapes: [TileShape; 256],
    flags: [u8; 256],
}

impl TileKinds {
    /// Every id is empty.
    pub const EMPTY: Self = Self { shapes: [TileShape::Empty; 256], flags: [0; 256] };

    /// The same table with another kind for one id.
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
    pub const fn with(mut self, id: u8, kind: TileKind) -> Self {
        self.shapes[id as usize] = kind.shape;
        self.flags[id as usize] = kind.flags;
        self
    }

    #[inline]
    #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
    pub(in crate::world) const fn is_empty(&self, id: u8) -> bool {
        matches!(self.shapes[id as usize], TileShape::Empty)
    }

    /// The kind of an id.
    #[inline]
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
    pub const fn get(&self, id: u8) -> TileKind {
        TileKind { shape: self.shapes[id as usize], flags: self.flags[id as usize] }
    }
}

impl Default for TileKinds {
    fn default() -> Self {
        Self::EMPTY
    }
}
