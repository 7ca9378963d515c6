//! Whether all solid near a body is behind a line: the ground under it, and nothing else.

use super::clear::is_clear;
use super::outline::{Form, FormKind};
use super::shape_surface::corner;
use super::surface::TileSource;
use super::{ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::shape::Aabb;
use crate::world::cell::{Block, Cell, Cells};
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
        let (square, n) = (TileSource::corners(self, block), line.normal);
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

/// Whether the convex hull of a form's solid is behind a line: of a disc only if that touches it.
fn is_form_behind(form: Form, square: (Raw, Raw), line: &Tangent, touches: bool) -> bool {
    if touches && form.kind != FormKind::Concave {
        return true;
    }
    let side = square.1.x.wrapping_sub(square.0.x);
    // In the form's own frame: the ends of the hull's border, which runs from the side of u to that
    // of v.
    let (a, b) = match form.kind {
        FormKind::Line { p, q, k } => {
            let (p, q, far) = (i32::from(p), i32::from(q), i32::from(k).wrapping_mul(side >> 1));
            let end = |p: i32, q: i32| {
                let u = if p == 0 { side } else { (far >> (p - 1)).min(side) };
                let v = if q == 0 { side } else { far.wrapping_sub(p.wrapping_mul(u)) >> (q - 1) };
                (u, v.min(side))
            };
            let ((u, v), (y, x)) = (end(p, q), end(q, p));
            (Raw { x: u, y: v }, Raw { x, y })
        }
        FormKind::Concave => (Raw { x: side, y: 0 }, Raw { x: 0, y: side }),
        FormKind::Empty | FormKind::Full | FormKind::Convex => return false,
    };
    let turned = |part: i32, back: bool| if back { part.wrapping_neg() } else { part };
    let (u, v) = (turned(line.normal.x, form.right), turned(line.normal.y, form.bottom));
    let corner = corner(square, form.right, form.bottom);
    let is_behind = |at: Raw| {
        let at = Raw { x: if u > 0 { at.x } else { 0 }, y: if v > 0 { at.y } else { 0 } };
        line.has_behind(corner.add(Raw { x: turned(at.x, form.right), y: turned(at.y, form.bottom) }))
    };
    if u > 0 && v > 0 { is_behind(a) && is_behind(b) } else { is_behind(if u > 0 { a } else { b }) }
}
