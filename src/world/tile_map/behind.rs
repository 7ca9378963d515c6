//! Whether all solid near a body is behind a line: the ground under it, and nothing else.

use super::clear::is_clear;
use super::outline::{Form, FormKind};
use super::shape_surface::corner;
use super::{ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::cell::{Block, Cell, Cells};
use crate::world::level::World;
use crate::world::tangent::Tangent;

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// Whether no body in a region, rounded by `r`, can reach solid in front of a line.
    #[inline(never)]
    pub(in crate::world) fn is_behind(&self, region: &Aabb, r: i32, line: &Tangent) -> bool {
        let mut cells = Cells::of(self.solid_range_of(region.lo(), region.hi()));
        while let Some(block) = &self.next_cell(&mut cells) {
            if !self.is_tile_behind(block, region, r, line) {
                return false;
            }
        }
        true
    }

    #[inline]
    fn is_tile_behind(&self, block: &Block, region: &Aabb, r: i32, line: &Tangent) -> bool {
        let (square, n) = (World::corners(self, block), line.normal);
        if line.has_behind(corner(square, n.x > 0, n.y > 0)) {
            return true;
        }
        // Beyond the map a cell is a band without a shape.
        if !S::SHAPED || block.kind.is_full() || !self.holds(block.x, block.y) {
            return false;
        }
        let (shape, touches) = (block.kind.shape, Cell::of(block.x, block.y) == line.cell);
        is_form_behind(shape.form(), square, line, touches) || is_clear(shape, square, (region.lo(), region.hi()), r)
    }
}

/// Whether the solid of a form is behind a line: any convex one that touches it, and the next one
/// of the same slope.
fn is_form_behind(form: Form, square: (Raw, Raw), line: &Tangent, touches: bool) -> bool {
    match form.kind {
        FormKind::Convex => touches,
        FormKind::Line { p, q, k } => {
            let turned = |part: i32, back: bool| if back { part.wrapping_neg() } else { part };
            let half = square.1.x.wrapping_sub(square.0.x) >> 1;
            // In the form's own frame: the normal, and a point of its edge.
            let (u, v) = (turned(line.normal.x, form.right), turned(line.normal.y, form.bottom));
            let (p, q, far) = (i32::from(p), i32::from(q), i32::from(k).wrapping_mul(half));
            let (at_u, at_v) = if p == 0 { (0, far) } else { (if p == 2 { far >> 1 } else { far }, 0) };
            let is_parallel = u >= 0 && v >= 0 && u.wrapping_mul(q) == v.wrapping_mul(p);
            let edge = Raw { x: turned(at_u, form.right), y: turned(at_v, form.bottom) };
            touches || (is_parallel && line.has_behind(corner(square, form.right, form.bottom).add(edge)))
        }
        FormKind::Empty | FormKind::Full | FormKind::Concave => false,
    }
}
