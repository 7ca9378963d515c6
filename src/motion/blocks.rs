//! The first hit in a level that is a grid of tiles. It reads full cells straight from the grid,
//! and makes only the features that a motion reaches.

use super::block_entry::{EnteredPart, entered};
use super::body::{Body, Entry};
use super::order::First;
use super::plane::into;
use super::search::{Search, hull};
use super::sweep_body::corner;
use super::sweep_face::{Face, sweep_face};
use super::sweep_round::{self, enter_quarter};
use crate::num::{Axis, LONG, Raw, umul};
use crate::query::cast::crossing::Crossing;
use crate::world::{Block, Cell, Cells, Feature, Fill, Geometry, Way, World};
use core::marker::PhantomData;

/// The cells to visit: those of a range, or those of a way.
pub(super) trait Walk {
    /// The next cell that may hold the first hit.
    fn next_block<W: World>(&mut self, world: &W, first: &First) -> Option<Block>;
}

impl Walk for Cells {
    #[inline]
    fn next_block<W: World>(&mut self, world: &W, _: &First) -> Option<Block> {
        world.next_cell(self)
    }
}

impl Walk for Way {
    #[inline]
    fn next_block<W: World>(&mut self, world: &W, first: &First) -> Option<Block> {
        loop {
            let block = world.next_on_way(self);
            if block.is_some() {
                return block;
            }
            let (part, of) = self.next_part()?;
            // Later strips hold only later hits.
            if first.is_within(part, of) {
                return None;
            }
            world.next_strip(self);
        }
    }
}

/// The bound of a time may be early by less than a raw unit of way.
const EARLY: i32 = 4;

/// A motion among blocks.
struct BlockSweep<'a, W, B> {
    world: &'a W,
    body: PhantomData<B>,
    d: Raw,
    /// The corner of the bounds that goes first. The motion reaches no face behind it.
    front: Raw,
    /// The part of the body that meets a face: its core.
    span: (Raw, Raw),
    /// The radius around it.
    r: i32,
    /// Whether the body has no extent along one of the axes. The cells beside a face then matter.
    thin: bool,
    /// A velocity: only surfaces that oppose it are hits.
    pressed: Option<Raw>,
    /// Whether the cell is beside a partly solid one, so its features must be read.
    is_odd: bool,
    first: &'a mut First,
}

impl<B: Body> Search<'_, B> {
    /// Takes the hits of some cells. Each full cell counts as a feature.
    #[inline(never)]
    pub(super) fn meet_cells<W: World, K: Walk>(&mut self, world: &W, walk: &mut K, d: Raw, first: &mut First) {
        let body = self.body;
        let bounds = body.bounds();
        let (a, b) = (bounds.lo(), bounds.hi());
        let front = Raw { x: if d.x > 0 { b.x } else { a.x }, y: if d.y > 0 { b.y } else { a.y } };
        let (span, r) = (body.core_box(), body.rounding());
        let (thin, pressed) = (a.x == b.x || a.y == b.y, self.pressed);
        let mut sweep = BlockSweep { world, body: PhantomData, d, front, span, r, thin, pressed, is_odd: false, first };
        let Some(mut block) = self.next_odd(&mut sweep, walk) else { return };
        if W::BLOCKS && !B::ANGULAR {
            return;
        }
        // One cursor for all cells of other shapes.
        let whole = hull(&bounds, Raw::ZERO, d, 1);
        let against = if B::NOTCHED { Raw::ZERO } else { d };
        let mut features = world.features_of_cells(&whole, against, body.meets_joints());
        loop {
            if !sweep.is_late(&block) {
                world.enter(&mut features, &block);
                self.meet_all(world, &mut features, d, sweep.first);
            }
            match self.next_odd(&mut sweep, walk) {
                Some(next) => block = next,
                None => return,
            }
        }
    }

    /// Takes the hits of cells up to the next one whose features must be read.
    #[cfg_attr(target_pointer_width = "64", inline)]
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    fn next_odd<W: World, K: Walk>(&mut self, sweep: &mut BlockSweep<'_, W, B>, walk: &mut K) -> Option<Block> {
        while let Some(block) = walk.next_block(sweep.world, sweep.first) {
            let is_full = block.kind.fill() == Fill::Full;
            sweep.is_odd = B::ANGULAR || (!W::BLOCKS && (sweep.thin || !is_full));
            if !sweep.is_odd {
                self.features += 1;
                if is_full {
                    sweep.meet_full(&block);
                } else if !self.pass_one_way {
                    sweep.meet_one_way(&block);
                }
            }
            if sweep.is_odd {
                return Some(block);
            }
        }
        None
    }
}

impl<W: World, B: Body> BlockSweep<'_, W, B> {
    /// The face or corner that the motion enters. It is no hit if cells beside it cover it, because
    /// the motion enters them earlier.
    fn meet_full(&mut self, block: &Block) {
        let cell = self.world.corners(block);
        let part = if self.thin { Some(EnteredPart::Both) } else { entered(self.span, self.r, self.d, cell) };
        match part {
            Some(EnteredPart::X) => self.meet_face(block, cell, true, false),
            Some(EnteredPart::Y) => self.meet_face(block, cell, false, false),
            Some(EnteredPart::Both) => {
                self.meet_face(block, cell, true, true);
                self.meet_face(block, cell, false, true);
            }
            Some(EnteredPart::Corner(x, y)) if B::MEETS_CORNERS => self.meet_corner(block, cell, x, y),
            Some(EnteredPart::Corner(..)) | None => {}
        }
    }

    /// A face that the body enters between its ends, or of which it may meet only an end.
    #[inline(never)]
    fn meet_face(&mut self, block: &Block, cell: (Raw, Raw), along_x: bool, at_end: bool) {
        let (index, a, dir, len) = side(cell, along_x, if along_x { self.d.x < 0 } else { self.d.y < 0 });
        let normal = crate::world::normal(dir);
        if !self.is_free(block, normal.x, normal.y) {
            return;
        }
        let joined = [false; 2];
        let mut found = feature(block, index, Geometry::Face { a: a.vec2(), dir, len, joined });
        if !at_end {
            let (gap, into) = if along_x { (a.x - self.front.x, self.d.x) } else { (a.y - self.front.y, self.d.y) };
            let entry = Entry { num: gap.unsigned_abs(), den: into.unsigned_abs(), normal, at_end, step: None };
            return self.add(Some(&entry), &found);
        }
        // Corner to corner, the cells beside the face matter.
        if !W::BLOCKS {
            self.is_odd = true;
            return;
        }
        let before = self.is_full(block, dir.x.wrapping_neg(), dir.y.wrapping_neg());
        let joined = [before, self.is_full(block, dir.x, dir.y)];
        found.geometry = Geometry::Face { a: a.vec2(), dir, len, joined };
        self.sweep(&Face { a, dir, len, joined }, &found);
    }

    /// Whether the motion reaches a cell only after its first hit so far, by more raw units than
    /// bounds of times may be early. One-way tiles always count.
    fn is_late(&self, block: &Block) -> bool {
        let Some((num, den)) = self.first.time() else { return false };
        if block.kind.fill() != Fill::Part {
            return false;
        }
        let (lo, hi) = self.world.corners(block);
        let after = |gap: i32, d: i32| {
            let gap = if d < 0 { gap.wrapping_neg() } else { gap };
            d != 0 && gap > EARLY && umul(gap.wrapping_sub(EARLY) as u32, den) > umul(d.unsigned_abs(), num)
        };
        let (x, y) = (if self.d.x < 0 { hi.x } else { lo.x }, if self.d.y < 0 { hi.y } else { lo.y });
        after(x.wrapping_sub(self.front.x), self.d.x) || after(y.wrapping_sub(self.front.y), self.d.y)
    }

    /// The corner of the sides toward `x` and `y`.
    #[inline(never)]
    fn meet_corner(&mut self, block: &Block, (lo, hi): (Raw, Raw), x: i32, y: i32) {
        if !self.is_free(block, x, 0) || !self.is_free(block, 0, y) {
            return;
        }
        let (first, last) = self.span;
        let (p, end) = (corner(lo, hi, Axis::new(x, y)), corner(last, first, Axis::new(x, y)));
        let m = end.sub(p);
        // Known to be in the corner's quadrant. On chips the sweep that tests it is linked anyway.
        let entry = if LONG {
            Crossing::of(m, self.r, self.d).and_then(|hit| sweep_round::entry(&hit, m, self.d))
        } else {
            enter_quarter(m, self.r, self.d, Axis::new(x, y), false)
        };
        // The edges in a block's order, solid on the left: of the two orders the one that turns.
        let (along, down) = (Axis::new(x, 0), Axis::new(0, y.wrapping_neg()));
        let (e_in, e_out) = if x == y { (down.reversed(), along.reversed()) } else { (along, down) };
        let index = match (x > 0, y > 0) {
            (true, false) => 4,
            (true, true) => 5,
            (false, true) => 6,
            (false, false) => 7,
        };
        let found = feature(block, index, Geometry::Vertex { p: p.vec2(), e_in, e_out });
        self.add(entry.as_ref(), &found);
    }

    /// A block that is solid on its upper side alone. Shaped ones are read as features.
    #[inline(never)]
    fn meet_one_way(&mut self, block: &Block) {
        let Some(found) = &self.world.one_way_face(block) else { return };
        let Geometry::Face { a, dir, len, joined } = found.geometry else { return };
        let face = Face { a: Raw::of(a), dir, len, joined };
        self.sweep(&face, found);
    }

    #[inline(never)]
    fn sweep(&mut self, face: &Face, found: &Feature) {
        self.add(sweep_face(self.span, self.r, self.d, face).as_ref(), found);
    }

    fn add(&mut self, entry: Option<&Entry>, found: &Feature) {
        let Some(entry) = entry else { return };
        if W::BLOCKS || self.pressed.is_none_or(|v| into(v, entry.normal) < 0) {
            self.first.add::<B, W>(entry, found, self.d);
        }
    }

    /// Whether no cell beside a full cell covers its side. If a cell covers it in part, the
    /// features decide.
    fn is_free(&mut self, block: &Block, x: i32, y: i32) -> bool {
        let fill = self.world.fill(block.x.wrapping_add(x), block.y.wrapping_add(y));
        self.is_odd |= !W::BLOCKS && fill == Fill::Part;
        fill == Fill::None
    }

    fn is_full(&self, block: &Block, x: i32, y: i32) -> bool {
        self.world.fill(block.x.wrapping_add(x), block.y.wrapping_add(y)) == Fill::Full
    }
}

/// The side across x or y of a cell that a motion comes to, `back` toward smaller coordinates.
/// Returns its index in a block's order, solid on the left, its first point, direction and length.
#[inline]
pub(super) fn side((lo, hi): (Raw, Raw), across_x: bool, back: bool) -> (u16, Raw, Axis, i32) {
    let (width, height) = (hi.x.wrapping_sub(lo.x), hi.y.wrapping_sub(lo.y));
    match (across_x, back) {
        (true, false) => (3, Raw { x: lo.x, y: hi.y }, Axis::NEG_Y, height),
        (true, true) => (1, Raw { x: hi.x, y: lo.y }, Axis::Y, height),
        (false, false) => (0, lo, Axis::X, width),
        (false, true) => (2, hi, Axis::NEG_X, width),
    }
}

pub(super) fn feature(block: &Block, index: u16, geometry: Geometry) -> Feature {
    let cell = Cell::of(block.x, block.y);
    Feature { geometry, cell, index, flags: block.kind.flags, one_way: false, source: 0 }
}
