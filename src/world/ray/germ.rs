//! The solid of a map around the start of a ray: whether the start is inside, and whether the ray goes in.

use super::walk::Walk;
use crate::num::{Raw, imul, usqr};
use crate::world::tile_map::form::FormKind;
use crate::world::{Set, Store, TileMap};

const NONE: Raw = Raw { x: 0, y: 0 };

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// Whether the start of a walk is strictly inside the solid.
    ///
    /// It is where the inequality of each shape that it touches holds strictly. Where one is an equality, the shape's line or arc ends on the border of its
    /// cell, so that points of the cell nearby are not in it.
    pub(in crate::world) fn start_is_inside(&self, o: Raw, walk: &Walk) -> bool {
        walk.all_at_start(false, self.grid.cell as u32, |x, y| self.holds_just_after(o, NONE, x, y))
    }

    /// Whether a ray is strictly inside the solid just after its start.
    ///
    /// It is within one cell then, or on the line between two whose shapes must both cover the line there. No border of a shape but those on the cell's
    /// own sides runs along a line of the grid between two cells: so both are the same question, in each cell.
    pub(in crate::world) fn start_goes_in(&self, o: Raw, d: Raw, walk: &Walk) -> bool {
        walk.all_at_start(true, self.grid.cell as u32, |x, y| self.holds_just_after(o, d, x, y))
    }

    /// Whether the inequality of a cell's shape holds strictly just after the start of a ray that is in the closed cell then; at the start itself
    /// where there is no motion.
    ///
    /// Only halves reach beyond the map. They depend on one coordinate, which is within a cell there: sums are below 2^27.
    fn holds_just_after(&self, o: Raw, d: Raw, x: i32, y: i32) -> bool {
        let form = self.kind_at(x, y).shape.form();
        let (lo, hi) = self.grid.corners(x, y);
        let (u, du) =
            if form.right { (hi.x.wrapping_sub(o.x), d.x.wrapping_neg()) } else { (o.x.wrapping_sub(lo.x), d.x) };
        let (v, dv) =
            if form.bottom { (hi.y.wrapping_sub(o.y), d.y.wrapping_neg()) } else { (o.y.wrapping_sub(lo.y), d.y) };
        let side = self.grid.cell;
        match form.kind {
            FormKind::Empty => false,
            FormKind::Full => true,
            FormKind::Line { p, q, k } => {
                let (p, q, limit) = (p as i32, q as i32, (k as i32).wrapping_mul(side >> 1));
                let value = p.wrapping_mul(u).wrapping_add(q.wrapping_mul(v));
                value < limit || (value == limit && imul(p, du).wrapping_add(imul(q, dv)) < 0)
            }
            FormKind::Convex => {
                let (square, limit) = (Raw { x: u, y: v }.len2(), usqr(side as u32));
                square < limit || (square == limit && imul(u, du).wrapping_add(imul(v, dv)) < 0)
            }
            FormKind::Concave => {
                // Seen from the other corner; a tangent leaves the disc.
                let (u, v) = (side.wrapping_sub(u), side.wrapping_sub(v));
                let (square, limit) = (Raw { x: u, y: v }.len2(), usqr(side as u32));
                let leaves = imul(u, du).wrapping_add(imul(v, dv)) <= 0 && !d.is_zero();
                square > limit || (square == limit && leaves)
            }
        }
    }
}
