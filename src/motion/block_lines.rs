//! Boxes among blocks: a search that goes from line to line of the grid.

use super::body::{Body, Entry};
use super::order::First;
use super::search::{Search, piece_of};
use crate::num::{Axis, Raw};
use crate::world::{Block, BlockHit, Cell, Feature, Geometry, TileKind, World, normal};

/// Whether all that a body can hit in a level are sides of cells.
pub(super) const fn is_by_lines<W: World, B: Body>() -> bool {
    W::GRID && W::BLOCKS && !B::MEETS_CORNERS
}

impl<B: Body> Search<'_, B> {
    /// Finds the first hit. Each cell behind a line that holds something counts as a feature.
    #[inline(never)]
    pub(super) fn find_by_lines<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        let bounds = self.body.bounds();
        // Along a floor there is mostly nothing, and this costs half as much.
        if world.is_known_empty(&piece_of(&bounds, Raw::ZERO, d, 1)) {
            return;
        }
        let mut lines = world.lines(&bounds, d);
        if let Some(hit) = &world.next_block(&mut lines, self.pass_one_way, &mut self.features) {
            first.take_block(world, hit);
        }
    }
}

impl First {
    /// Takes a hit of a side among blocks, the only one.
    #[inline(never)]
    pub(super) fn take_block<W: World>(&mut self, world: &W, hit: &BlockHit) {
        let (lo, hi) = world.corners(&Block { x: hit.x, y: hit.y, kind: TileKind::EMPTY });
        let (width, height) = (hi.x.wrapping_sub(lo.x), hi.y.wrapping_sub(lo.y));
        // A block's sides in its order, solid on the left.
        let (index, a, dir, len) = match (hit.is_x, hit.step < 0) {
            (true, false) => (3, Raw { x: lo.x, y: hi.y }, Axis::NEG_Y, height),
            (true, true) => (1, Raw { x: hi.x, y: lo.y }, Axis::Y, height),
            (false, false) => (0, lo, Axis::X, width),
            (false, true) => (2, hi, Axis::NEG_X, width),
        };
        let (num, den) = (hit.num as u32, hit.den as u32);
        let geometry = Geometry::Face { a: a.vec2(), dir, len, joined: [false; 2] };
        let cell = Cell::of(hit.x, hit.y);
        self.only_flat(
            Entry { num, den, normal: normal(dir), at_end: hit.at_end, step: None },
            Feature { geometry, cell, index, flags: hit.flags, one_way: hit.one_way, source: 0 },
        );
    }
}
