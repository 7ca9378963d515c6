//! The tiles of a level: shapes, user flags, and the table from ids to both.

/// The solid part of a tile.
///
/// Lines end in corners and in the middles of sides, and mild and steep slopes continue from tile
/// to tile. Arcs have a radius of one cell, and their tangents continue the sides of the cell.
/// Slopes and arcs come in fours, solid at the top left, top right, bottom right and bottom left.
/// "Top" is toward row 0. Those at the bottom right are:
///
/// ```text
///   Slope       MildLow     MildHigh    SteepLow    SteepHigh   Convex      Concave
///          /|           |       _.-#|          /|      /####|       ,.##|           |
///        /##|           |   _.-#####|         /#|     /#####|     /#####|          /|
///      /####|       _.-#|   ########|        /##|    /######|    /######|         /#|
///    /######|   _.-#####|   ########|       /###|   /#######|   /#######|     _.-###|
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
#[repr(u8)]
pub enum TileShape {
    /// Nothing is solid.
    #[default]
    Empty = 0,
    /// The whole cell is solid.
    Full = 1,
    /// The half toward row 0.
    HalfTop = 2,
    /// The half toward larger x.
    HalfRight = 3,
    /// The half away from row 0.
    HalfBottom = 4,
    /// The half toward smaller x.
    HalfLeft = 5,
    /// Half of the cell, cut from corner to corner. Each slope and arc is named after the corner
    /// where it is solid.
    SlopeTopLeft = 6,
    /// As [`SlopeTopLeft`](Self::SlopeTopLeft), at another corner.
    SlopeTopRight = 7,
    /// As [`SlopeTopLeft`](Self::SlopeTopLeft), at another corner.
    SlopeBottomRight = 8,
    /// As [`SlopeTopLeft`](Self::SlopeTopLeft), at another corner.
    SlopeBottomLeft = 9,
    /// A quarter disc around its corner, radius one cell.
    ConvexTopLeft = 10,
    /// As [`ConvexTopLeft`](Self::ConvexTopLeft), at another corner.
    ConvexTopRight = 11,
    /// As [`ConvexTopLeft`](Self::ConvexTopLeft), at another corner.
    ConvexBottomRight = 12,
    /// As [`ConvexTopLeft`](Self::ConvexTopLeft), at another corner.
    ConvexBottomLeft = 13,
    /// The cell without a quarter disc around the opposite corner: a quarter pipe.
    ConcaveTopLeft = 14,
    /// As [`ConcaveTopLeft`](Self::ConcaveTopLeft), at another corner.
    ConcaveTopRight = 15,
    /// As [`ConcaveTopLeft`](Self::ConcaveTopLeft), at another corner.
    ConcaveBottomRight = 16,
    /// As [`ConcaveTopLeft`](Self::ConcaveTopLeft), at another corner.
    ConcaveBottomLeft = 17,
    /// A slope of one half cell per cell: half a side high at its corner, zero at the other.
    MildLowTopLeft = 18,
    /// As [`MildLowTopLeft`](Self::MildLowTopLeft), at another corner.
    MildLowTopRight = 19,
    /// As [`MildLowTopLeft`](Self::MildLowTopLeft), at another corner.
    MildLowBottomRight = 20,
    /// As [`MildLowTopLeft`](Self::MildLowTopLeft), at another corner.
    MildLowBottomLeft = 21,
    /// [`MildLowTopLeft`](Self::MildLowTopLeft) raised by half a cell: a whole side high at its
    /// corner, half a side at the other.
    MildHighTopLeft = 22,
    /// As [`MildHighTopLeft`](Self::MildHighTopLeft), at another corner.
    MildHighTopRight = 23,
    /// As [`MildHighTopLeft`](Self::MildHighTopLeft), at another corner.
    MildHighBottomRight = 24,
    /// As [`MildHighTopLeft`](Self::MildHighTopLeft), at another corner.
    MildHighBottomLeft = 25,
    /// A slope of two cells per cell: half a side wide at its corner, zero at the other.
    SteepLowTopLeft = 26,
    /// As [`SteepLowTopLeft`](Self::SteepLowTopLeft), at another corner.
    SteepLowTopRight = 27,
    /// As [`SteepLowTopLeft`](Self::SteepLowTopLeft), at another corner.
    SteepLowBottomRight = 28,
    /// As [`SteepLowTopLeft`](Self::SteepLowTopLeft), at another corner.
    SteepLowBottomLeft = 29,
    /// [`SteepLowTopLeft`](Self::SteepLowTopLeft) moved by half a cell: a whole side wide at its
    /// corner, half a side at the other.
    SteepHighTopLeft = 30,
    /// As [`SteepHighTopLeft`](Self::SteepHighTopLeft), at another corner.
    SteepHighTopRight = 31,
    /// As [`SteepHighTopLeft`](Self::SteepHighTopLeft), at another corner.
    SteepHighBottomRight = 32,
    /// As [`SteepHighTopLeft`](Self::SteepHighTopLeft), at another corner.
    SteepHighBottomLeft = 33,
    /// Only the edge toward row 0 blocks, and only bodies that are entirely in front of it and move
    /// in. It has no inside, so nothing overlaps it. Its ends are not corners: a circle whose
    /// centre is beyond an end that nothing continues passes it.
    OneWayUp = 34,
    /// As [`OneWayUp`](Self::OneWayUp), the edge toward larger x.
    OneWayRight = 35,
    /// As [`OneWayUp`](Self::OneWayUp), the edge away from row 0.
    OneWayDown = 36,
    /// As [`OneWayUp`](Self::OneWayUp), the edge toward smaller x.
    OneWayLeft = 37,
}

impl TileShape {
    /// All shapes, in the order of their discriminants. The first 34 are the tiles 0 to 33 of N++.
    pub const ALL: [Self; 38] = [
        Self::Empty,
        Self::Full,
        Self::HalfTop,
        Self::HalfRight,
        Self::HalfBottom,
        Self::HalfLeft,
        Self::SlopeTopLeft,
        Self::SlopeTopRight,
        Self::SlopeBottomRight,
        Self::SlopeBottomLeft,
        Self::ConvexTopLeft,
        Self::ConvexTopRight,
        Self::ConvexBottomRight,
        Self::ConvexBottomLeft,
        Self::ConcaveTopLeft,
        Self::ConcaveTopRight,
        Self::ConcaveBottomRight,
        Self::ConcaveBottomLeft,
        Self::MildLowTopLeft,
        Self::MildLowTopRight,
        Self::MildLowBottomRight,
        Self::MildLowBottomLeft,
        Self::MildHighTopLeft,
        Self::MildHighTopRight,
        Self::MildHighBottomRight,
        Self::MildHighBottomLeft,
        Self::SteepLowTopLeft,
        Self::SteepLowTopRight,
        Self::SteepLowBottomRight,
        Self::SteepLowBottomLeft,
        Self::SteepHighTopLeft,
        Self::SteepHighTopRight,
        Self::SteepHighBottomRight,
        Self::SteepHighBottomLeft,
        Self::OneWayUp,
        Self::OneWayRight,
        Self::OneWayDown,
        Self::OneWayLeft,
    ];
}

/// A shape and eight flags, such as coin, ladder or deadly. You choose what the flags mean.
///
/// Tiles that are not solid have flags, too: see
/// [`TileMap::flags_touched`](crate::world::TileMap::flags_touched).
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
    /// An empty tile without flags.
    pub const EMPTY: Self = Self::of(TileShape::Empty);
    /// A solid cell.
    pub const FULL: Self = Self::of(TileShape::Full);
    /// A platform that can be entered from below.
    #[doc(alias("one way platform", "jump-through", "JumpThru", "one_way_collision"))]
    pub const ONE_WAY_UP: Self = Self::of(TileShape::OneWayUp);

    /// A shape without flags.
    #[must_use]
    pub const fn of(shape: TileShape) -> Self {
        Self { shape, flags: 0 }
    }

    /// Sets the flags.
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

    #[inline]
    pub(crate) const fn fill(self) -> Fill {
        match self.shape as u8 {
            1 => Fill::Full,
            2..34 => Fill::Part,
            _ => Fill::None,
        }
    }

    /// The side whose edge blocks, of a one-way tile: 0 toward row 0, turning right.
    pub(in crate::world) const fn one_way_side(self) -> Option<u8> {
        match (self.shape as u8).checked_sub(TileShape::OneWayUp as u8) {
            Some(side) if side < 4 => Some(side),
            _ => None,
        }
    }
}

/// How much of a cell is solid.
///
/// Public in a private module, because a sealed trait's method returns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// Nothing; it may have a one-way face.
    None,
    Part,
    Full,
}

/// The kinds of the 256 tile ids: 520 bytes, usually in a `static` in flash that all maps of a game
/// share.
///
/// The table stores which shapes it has. So making a map takes one test against its set, not 256.
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
#[doc(alias("TileSet", "tile properties"))]
pub struct TileKinds {
    /// A separate array, so a walk over the shapes reads each by one index.
    shapes: [TileShape; 256],
    flags: [u8; 256],
    /// One bit for each shape of the table, and that of `Empty`.
    named: u64,
}

impl TileKinds {
    /// Every id is empty.
    pub const EMPTY: Self = Self { shapes: [TileShape::Empty; 256], flags: [0; 256], named: 1 };

    /// Sets the kind of one id.
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
    pub const fn with(mut self, id: u8, kind: TileKind) -> Self {
        let replaced = self.get(id);
        self.shapes[id as usize] = kind.shape;
        self.flags[id as usize] = kind.flags;
        self.named |= 1 << kind.shape as u64;
        if !replaced.is_empty() {
            // It may have been the last one of its shape.
            self.named = 1;
            let mut other = 0;
            while other < self.shapes.len() {
                self.named |= 1 << self.shapes[other] as u64;
                other += 1;
            }
        }
        self
    }

    /// This table for bodies that pass the tiles with any of these flags: such tiles are not solid.
    /// They keep their flags, so [`TileMap::flags_swept`](crate::world::TileMap::flags_swept) and
    /// [`tiles_in`](crate::world::TileMap::tiles_in) report all tiles that a body passes.
    ///
    /// Make one table per kind of body, as a `static`, and use it for the same tiles by
    /// [`TileMap::with_kinds`](crate::world::TileMap::with_kinds). An occupancy stays valid. Moves
    /// and casts cost the same as in any map.
    ///
    /// ```
    /// use tilesat::{AllShapes, Inside, TileKind, TileKinds, TileMap, Vec2};
    /// const CURTAIN: u8 = 1;
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'c', TileKind::FULL.with_flags(CURTAIN));
    /// static GHOSTS: TileKinds = KINDS.passing(CURTAIN);
    ///
    /// let level = TileMap::from_ascii("..c.#", &KINDS)?;
    /// let of_ghosts = level.with_kinds::<AllShapes>(&GHOSTS)?;
    /// let (from, way) = (Vec2::from_ints(4, 8), Vec2::from_ints(100, 0));
    /// assert_eq!(level.cast_ray(from, way, Inside::Ignore)?.unwrap().cell.x, 2);
    /// assert_eq!(of_ghosts.cast_ray(from, way, Inside::Ignore)?.unwrap().cell.x, 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias("cross", "ghost", "collision mask"))]
    pub const fn passing(&self, flags: u8) -> Self {
        let (mut table, mut id) = (Self::EMPTY, 0u8);
        loop {
            let kind = self.get(id);
            table = table.with(id, if kind.flag(flags) { TileKind::EMPTY.with_flags(kind.flags) } else { kind });
            id = match id.checked_add(1) {
                Some(next) => next,
                None => return table,
            };
        }
    }

    /// The first id whose shape is not among these; a bit for each shape.
    pub(super) const fn beyond(&self, shapes: u64) -> Option<u8> {
        if self.named & !shapes == 0 {
            return None;
        }
        let mut id = 0u8;
        while shapes >> self.get(id).shape as u64 & 1 != 0 {
            id = match id.checked_add(1) {
                Some(next) => next,
                None => return None,
            };
        }
        Some(id)
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
