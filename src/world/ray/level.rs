//! What a ray asks of a level, and how a tile map answers.

use super::dda::{X, Y, along};
use super::walk::{Beyond, Walk};
use crate::num::Raw;
use crate::world::grid::Grid;
use crate::world::tile_map::tile_pieces::TilePieces;
use crate::world::{Feature, Set, Store, TileKind, TileMap, TileShape};

/// What the pieces of a level can be.
pub(in crate::world) trait RayPieces {
    /// Whether times of faces can be fractions of more than words; see [`Time`](super::piece::Time).
    const WIDE: bool;
    /// Whether there can be arcs. Every other piece of a cell with an arc is on the cell's border.
    const ROUND: bool;
}

/// A level whose surface is found cell by cell, bands included as [`beyond`](Self::beyond) says.
pub(in crate::world) trait RayLevel: RayPieces {
    /// The pieces of a cell.
    type Pieces<'w>: Iterator<Item = Feature>
    where
        Self: 'w;

    fn grid(&self) -> &Grid;

    fn beyond(&self) -> Beyond;

    /// The start of a ray.
    fn walk(&self, o: Raw, d: Raw) -> Walk {
        let grid = self.grid();
        Walk::new(grid.ray_side(&grid.x, o.x, d.x), grid.ray_side(&grid.y, o.y, d.y), grid.cell as u32)
    }

    /// Goes on from a step that has been looked at over cells that have no pieces, as far as that is faster than step by step.
    fn skip(&self, _: &mut Walk) {}

    /// All pieces that have a point in the closed cell or, where each has a cell of its own, those of this one. Those that the motion `d` does not
    /// oppose may be left out. `None` where there are none, told as fast as it can be, and for cells beyond the bands.
    fn pieces(&self, x: i32, y: i32, d: Raw) -> Option<Self::Pieces<'_>>;

    /// Whether the start of a walk is strictly inside the solid.
    fn holds_start(&self, o: Raw, walk: &Walk) -> bool;

    /// Whether a ray that starts on the border of the solid is strictly inside just after.
    fn enters(&self, o: Raw, d: Raw, walk: &Walk) -> bool;

    /// The user's flags of what is solid in a cell.
    fn flags(&self, x: i32, y: i32) -> u8;
}

impl<S: Set, T: Store> RayPieces for TileMap<'_, S, T> {
    const WIDE: bool = false;
    const ROUND: bool = S::ARCS;
}

impl<S: Set, T: Store> RayLevel for TileMap<'_, S, T> {
    type Pieces<'w>
        = TilePieces<'w, S, T>
    where
        Self: 'w;

    #[inline]
    fn grid(&self) -> &Grid {
        &self.grid
    }

    #[inline]
    fn beyond(&self) -> Beyond {
        self.outer()
    }

    fn walk(&self, o: Raw, d: Raw) -> Walk {
        let (x, y) = (self.side(&self.grid.x, o.x, d.x), self.side(&self.grid.y, o.y, d.y));
        Walk::new(x, y, self.grid.cell as u32)
    }

    #[inline(never)]
    fn skip(&self, walk: &mut Walk) {
        let cell = self.grid.cell as u32;
        let run = if along(&walk.x, &walk.y, cell) != 0 {
            self.run_along::<true>(&walk.x, &walk.y)
        } else if self.holds(walk.x.cell, walk.y.cell) {
            Some(self.run::<true>(&walk.x, &walk.y))
        } else {
            None
        };
        if let Some(run) = run {
            // Before the line that led to something: at a corner the lines are crossed one after the other then, at the same moment.
            walk.jump(run.kx.wrapping_sub(run.met & X), run.ky.wrapping_sub((run.met & Y) >> 1), cell);
        }
    }

    #[inline]
    fn pieces(&self, x: i32, y: i32, d: Raw) -> Option<TilePieces<'_, S, T>> {
        let kind = if self.holds(x, y) {
            self.kinds.get(self.id(x, y))
        } else if self.is_beyond_bands(x, y) {
            TileKind::EMPTY
        } else {
            self.kind_at(x, y)
        };
        if matches!(kind.shape, TileShape::Empty) { None } else { Some(TilePieces::new(self, kind, x, y, d)) }
    }

    fn holds_start(&self, o: Raw, walk: &Walk) -> bool {
        self.start_is_inside(o, walk)
    }

    fn enters(&self, o: Raw, d: Raw, walk: &Walk) -> bool {
        self.start_goes_in(o, d, walk)
    }

    fn flags(&self, x: i32, y: i32) -> u8 {
        self.kind_at(x, y).flags
    }
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// Whether a cell outside of the map is not even a band that has features.
    #[cold]
    fn is_beyond_bands(&self, x: i32, y: i32) -> bool {
        let (width, height) = (i32::from(self.grid.x.count), i32::from(self.grid.y.count));
        !matches!(self.outer(), Beyond::Bands) || x < -1 || y < -1 || x > width || y > height
    }
}
