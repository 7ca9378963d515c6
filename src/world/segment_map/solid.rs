//! Whether a point is in the solid: the stored winding number of its cell, and what is crossed on the way from there.
//!
//! A query that has met no segment of the boundary asks for one point of the body only. So that no case is left out, that point is moved by an
//! infinitesimal `e` along x and by `e^2` along y, as the reference points of the cells are: then it is on no segment.

use super::{Kind, Seg, SegmentMap};
use crate::num::Raw;

impl SegmentMap<'_> {
    /// The winding number just beside a point, at `p + (e, e^2)`; 0 beyond the grid.
    ///
    /// ```text
    ///   R = corner + (e, e^2):  up along the cell's     p      All that is crossed meets the closed square of the cell. What is at
    ///   side to p's height, then straight to p.    +----->     both ends of a leg, or beyond them, cancels.
    ///                                              R
    /// ```
    ///
    /// Cost: a test of the coordinates for each segment of the cell; for those that reach across, up to four products.
    pub(super) fn winding_beside(&self, p: Raw) -> i32 {
        let (x, y) = (self.grid.column(p.x), self.grid.row(p.y));
        let (corner, _) = self.grid.corners(x, y);
        let turn = Raw { x: corner.x, y: p.y };
        let mut winding = i32::from(self.winding(x, y));
        for index in self.refs(x, y) {
            let seg = self.segment(index);
            if seg.kind == Kind::Solid {
                winding = winding.wrapping_add(below(&seg, turn)).wrapping_sub(below(&seg, corner));
                winding = winding.wrapping_add(before(&seg, p)).wrapping_sub(before(&seg, turn));
            }
        }
        winding
    }

    /// Whether a point is in the inside of the solid: whether it is solid all around it.
    ///
    /// The winding number beside it is counted on around it, ray by ray of the segments through it. Cost: the segments of its cell; their square
    /// where many meet at the point.
    pub(super) fn point_inside(&self, p: Raw) -> bool {
        let start = self.winding_beside(p);
        let after = |ray: Ray| self.rays(p).filter(|r| r.up_to(&ray)).fold(start, |w, r| w.wrapping_add(r.change));
        start > 0 && self.rays(p).all(|ray| after(ray) > 0)
    }

    /// The segments of a cell that holds a point of the closed grid.
    pub(super) fn around(&self, p: Raw) -> impl Iterator<Item = Seg> {
        let cell = self.cells(p, p);
        self.refs(cell.x1, cell.y1).map(|index| self.segment(index))
    }

    /// The rays of the boundary from a point.
    pub(super) fn rays(&self, p: Raw) -> impl Iterator<Item = Ray> {
        self.around(p).flat_map(move |seg| rays(&seg, p)).flatten()
    }
}

/// What the winding number changes by at a segment on the way up along `x = q.x + e` to `q`: +1 from its right to its left.
fn below(seg: &Seg, q: Raw) -> i32 {
    if (seg.a.x <= q.x) == (seg.b().x <= q.x) {
        return 0;
    }
    let side = side(seg, q);
    // Where it goes through `q` it is passed if it does not rise: `slope e` against `e^2`.
    let (forward, rises) = (seg.dir.x > 0, (seg.dir.y > 0) == (seg.dir.x > 0) && seg.dir.y != 0);
    let passed = if forward { side > 0 } else { side < 0 } || (side == 0 && !rises);
    if passed { if forward { 1 } else { -1 } } else { 0 }
}

/// The same to the right along `y = q.y + e^2`. Where it goes through `q` it is passed: `e^2` over its slope against `e`.
fn before(seg: &Seg, q: Raw) -> i32 {
    let upward = seg.a.y <= q.y;
    if upward == (seg.b().y <= q.y) {
        return 0;
    }
    let side = side(seg, q);
    if upward { -i32::from(side <= 0) } else { i32::from(side >= 0) }
}

/// Positive on the left of a segment; below 2^61.
fn side(seg: &Seg, q: Raw) -> i64 {
    Raw { x: seg.dir.x, y: seg.dir.y }.cross(q.sub(seg.a))
}

/// A part of the boundary that leaves a point, as a direction.
#[derive(Clone, Copy)]
pub(super) struct Ray {
    pub(super) dir: Raw,
    /// What the winding number changes by from its right to its left.
    pub(super) change: i32,
}

/// The two rays of a boundary segment from a point on it.
pub(super) fn rays(seg: &Seg, p: Raw) -> [Option<Ray>; 2] {
    if seg.kind != Kind::Solid || !seg.holds(p) {
        return [None, None];
    }
    let dir = Raw { x: seg.dir.x, y: seg.dir.y };
    let back = Raw { x: dir.x.wrapping_neg(), y: dir.y.wrapping_neg() };
    [(seg.b() != p).then_some(Ray { dir, change: 1 }), (seg.a != p).then_some(Ray { dir: back, change: -1 })]
}

impl Ray {
    /// Whether it comes not after `o` on the way around from the direction `(e, e^2)`, to the left.
    pub(super) fn up_to(&self, o: &Self) -> bool {
        let (mine, other) = (self.quarter(), o.quarter());
        mine < other || (mine == other && self.dir.cross(o.dir) >= 0)
    }

    /// Up, straight left, down, straight right in that order: straight right is just before the start.
    fn quarter(&self) -> u8 {
        match (self.dir.y.signum(), self.dir.x > 0) {
            (1, _) => 0,
            (0, false) => 1,
            (0, true) => 3,
            _ => 2,
        }
    }
}
