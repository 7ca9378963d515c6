//! Motions of rounded bodies that lie on a block, as most bodies at rest and many that run do.

use super::blocks::{feature, side};
use super::body::Body;
use super::mover::Mover;
use super::plane::project;
use super::response::{Law, Response};
use super::run::turned;
use super::search::Around;
use super::{Hit, Moved, Work};
use crate::num::{Axis, Raw, Toi};
use crate::world::{Block, Feature, Fill, Geometry, World, normal};

/// The block on which a rounded body lies. All that is near begins at its line, and the body's core
/// is over that block alone.
///
/// The body touches the line there, and its other points are off the line. So no other hit is at
/// the time 0, and no cell covers the side. Among all shapes the test would take 28 of 3 964
/// instructions of a circle that moves, and 650 bytes.
struct Below {
    block: Block,
    /// The corners of its solid.
    solid: (Raw, Raw),
    /// How many cells were visited.
    seen: u32,
}

impl Below {
    #[inline(always)]
    fn of<W: World, B: Body>(world: &W, body: &B, around: &Around, d: Raw) -> Option<Self> {
        if !W::GRID || !W::BLOCKS || !B::MEETS_CORNERS || B::ANGULAR || d.y == 0 {
            return None;
        }
        let (bounds, held) = (body.bounds(), around.held()?);
        let lies = if d.y < 0 { held.hi().y == bounds.lo().y } else { held.lo().y == bounds.hi().y };
        if lies { Self::find(world, body, around) } else { None }
    }

    #[inline(never)]
    fn find<W: World, B: Body>(world: &W, body: &B, around: &Around) -> Option<Self> {
        let (mut cells, held, core) = (around.known_cells()?, around.held()?, body.core_box());
        let width = cells.row_width()?;
        if width > 2 {
            return None;
        }
        let (mut block, mut solid, mut seen) = (world.next_cell(&mut cells)?, (held.lo(), held.hi()), 1);
        if width == 2 {
            let next = world.next_cell(&mut cells)?;
            let ends = world.corners(&next).0.x;
            seen = 2;
            if ends < core.0.x {
                solid.0.x = ends;
            } else {
                solid.1.x = ends;
            }
            block = if ends < core.0.x { next } else { block };
        }
        let is_over = solid.0.x < core.0.x && core.1.x < solid.1.x;
        let lies = is_over && block.kind.fill() == Fill::Full && body.rounding() != 0;
        lies.then_some(Self { block, solid, seen })
    }

    /// The flat side on which the body lies, facing a motion, and its normal.
    #[inline(always)]
    fn face(&self, d: Raw) -> (Axis, Feature) {
        let (index, a, dir, len) = side(self.solid, false, d.y < 0);
        let face = Geometry::Face { a: a.vec2(), dir, len, joined: [false; 2] };
        (normal(dir), feature(&self.block, index, face))
    }
}

impl<S: Law> Mover<S> {
    /// The motion of a body that lies on a block and slides along it or stays there, as gravity and
    /// a run make it. All that is near is beyond the block's line, so the way along it is free. A
    /// circle at rest then takes 893 instructions on a Cortex-M0 in place of 1442.
    #[inline(always)]
    pub(super) fn slides_on_block<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        around: &Around,
    ) -> Option<Moved<B>> {
        if !around.is_inside() {
            return None;
        }
        let below = Below::of(world, body, around, d)?;
        let (normal, feature) = &below.face(d);
        if !matches!(self.response_to(*normal, feature, Toi::ZERO), Response::Slide | Response::DropThrough) {
            return None;
        }
        let v = if S::SMOOTH { Raw { x: d.x, y: 0 } } else { project::<B, W, S>(d, *normal, &self.surface) };
        let rest = if S::SMOOTH { v } else { turned(d, d, v, Toi::ONE) };
        let moves = !rest.is_zero();
        if moves {
            world.made(rest);
        }
        // As without this, each cell counts as a feature.
        let work = Work { iterations: 1 + u32::from(moves), features: below.seen, checks: 0 };
        let hit = (Hit::of(*normal, feature, Toi::ZERO), self.side(*normal));
        Some(Moved::with_one(body.shifted(rest), v.vec2(), hit, work))
    }
}
