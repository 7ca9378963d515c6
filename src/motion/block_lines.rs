//! Boxes among blocks: a search that goes from line to line of the grid.

use super::blocks::{feature, side};
use super::body::{Body, Entry};
use super::order::First;
use super::search::{Search, piece_of};
use crate::num::Raw;
use crate::world::{Block, BlockHit, Feature, Geometry, TileKind, World, normal};

impl<B: Body> Search<'_, B> {
    /// Finds the first hit. Each line that it looks behind counts as a feature.
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
        let block = Block { x: hit.x, y: hit.y, kind: TileKind::EMPTY.with_flags(hit.flags) };
        let (index, a, dir, len) = side(world.corners(&block), hit.is_x, hit.step < 0);
        let (num, den) = (hit.num as u32, hit.den as u32);
        let face = Geometry::Face { a: a.vec2(), dir, len, joined: [false; 2] };
        self.only_flat(
            Entry { num, den, normal: normal(dir), at_end: hit.at_end, step: None },
            Feature { one_way: hit.one_way, ..feature(&block, index, face) },
        );
    }
}
