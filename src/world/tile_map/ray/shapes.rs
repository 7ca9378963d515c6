//! A ray among tiles of any shape: the pieces of a cell, and the solid around the start.

use crate::num::{Raw, imul, usqr};
use crate::world::cell::Cell;
use crate::world::grid::Grid;
use crate::world::level::{Feature, Geometry};
use crate::world::ray::RayPieces;
use crate::world::ray::scan::RayLevel;
use crate::world::ray::walk::{Beyond, RayWalk, X, Y, along};
use crate::world::tile_map::kind::{TileKind, TileShape};
use crate::world::tile_map::outline::{Form, FormKind, InnerKind, direction, place};
use crate::world::tile_map::shape_surface::{along as along_side, arc};
use crate::world::tile_map::{ShapeSet, Store, TileMap};

impl<S: ShapeSet, T: Store> RayPieces for TileMap<'_, S, T> {
    const WIDE: bool = false;
    const ROUND: bool = S::ARCS;
}

impl<S: ShapeSet, T: Store> RayLevel for TileMap<'_, S, T> {
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

    fn walk(&self, o: Raw, d: Raw) -> RayWalk {
        let (x, y) = (self.lane(&self.grid.x, o.x, d.x), self.lane(&self.grid.y, o.y, d.y));
        RayWalk::new(x, y, self.grid.cell as u32)
    }

    #[inline(never)]
    fn skip(&self, walk: &mut RayWalk) {
        let cell = self.grid.cell as u32;
        let run = if along(&walk.x, &walk.y, cell) != 0 {
            self.run_along::<true>(&walk.x, &walk.y)
        } else if self.holds(walk.x.cell, walk.y.cell) {
            Some(self.run::<true>(&walk.x, &walk.y))
        } else {
            None
        };
        if let Some(run) = run {
            // Before the line that led here: at a corner the ray crosses the lines one after the
            // other, at the same moment.
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

    fn holds_start(&self, o: Raw, walk: &RayWalk) -> bool {
        self.start_is_inside(o, walk)
    }

    fn enters(&self, o: Raw, d: Raw, walk: &RayWalk) -> bool {
        self.start_goes_in(o, d, walk)
    }

    fn flags(&self, x: i32, y: i32) -> u8 {
        self.kind_at(x, y).flags
    }
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// Whether a cell outside the map is not even a band that has features.
    #[cold]
    fn is_beyond_bands(&self, x: i32, y: i32) -> bool {
        let (width, height) = (self.grid.x.count as i32, self.grid.y.count as i32);
        !matches!(self.outer(), Beyond::Bands) || x < -1 || y < -1 || x > width || y > height
    }
}

const NONE: Raw = Raw { x: 0, y: 0 };

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// Whether the start of a walk is strictly inside the solid.
    ///
    /// It is if the inequality of each shape that it touches holds strictly. If one is an equality,
    /// the shape's line or arc ends on the border of its cell. Near points of the cell are then not
    /// in the shape.
    pub(in crate::world) fn start_is_inside(&self, o: Raw, walk: &RayWalk) -> bool {
        walk.all_at_start(false, self.grid.cell as u32, |x, y| self.holds_just_after(o, NONE, x, y))
    }

    /// Whether a ray is strictly inside the solid just after its start.
    ///
    /// It is within one cell then, or on the line between two whose shapes must both cover the line
    /// there. Only those borders of a shape that are sides of its cell run along a line of the
    /// grid. So both are the same question, in each cell.
    pub(in crate::world) fn start_goes_in(&self, o: Raw, d: Raw, walk: &RayWalk) -> bool {
        walk.all_at_start(true, self.grid.cell as u32, |x, y| self.holds_just_after(o, d, x, y))
    }

    /// Whether the inequality of a cell's shape holds strictly just after the start of a ray. The
    /// ray is in the closed cell then. If there is no motion, at the start itself.
    ///
    /// Only halves reach beyond the map. They depend on one coordinate, which is within a cell
    /// there: sums are below 2^27.
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
                // Relative to the other corner; a tangent leaves the disc.
                let (u, v) = (side.wrapping_sub(u), side.wrapping_sub(v));
                let (square, limit) = (Raw { x: u, y: v }.len2(), usqr(side as u32));
                let leaves = imul(u, du).wrapping_add(imul(v, dv)) <= 0 && !d.is_zero();
                square > limit || (square == limit && leaves)
            }
        }
    }
}

/// Cursor over the pieces of a cell, as [`features`](TileMap::features) has them. It omits
/// vertices, sides that the motion does not oppose, and the marks of joints. Rays need none of
/// those, and they are most of the work.
#[derive(Clone, Debug)]
pub(in crate::world) struct TilePieces<'w, S: ShapeSet, T: Store> {
    map: &'w TileMap<'w, S, T>,
    kind: TileKind,
    x: i32,
    y: i32,
    d: Raw,
    stage: PieceStage,
}

#[derive(Clone, Copy, Debug)]
enum PieceStage {
    X,
    Y,
    Inner,
    Over,
}

impl<'w, S: ShapeSet, T: Store> TilePieces<'w, S, T> {
    pub(in crate::world) const fn new(map: &'w TileMap<'w, S, T>, kind: TileKind, x: i32, y: i32, d: Raw) -> Self {
        Self { map, kind, x, y, d, stage: PieceStage::X }
    }

    /// The part of side `k` that bounds the solid, or blocks, and is not covered by the tile
    /// across.
    #[inline(never)]
    fn side(&self, k: u8) -> Option<Geometry> {
        let own = match self.kind.one_way_side() {
            Some(side) => 3 * u8::from(side == k),
            None if S::SHAPED => self.kind.shape.outline().halves(k),
            None => 3,
        };
        if own == 0 {
            return None;
        }
        let step = direction(4 * k).reversed().perp();
        let across = self.map.kind_at(self.x.wrapping_add(step.x), self.y.wrapping_add(step.y)).shape;
        let covered = if S::SHAPED {
            across.outline().covers >> (2 * k) & 3
        } else {
            3 * u8::from(matches!(across, TileShape::Full))
        };
        let halves = own & !covered;
        if halves == 0 {
            return None;
        }
        // If a band is merged with a cell, the cell's side continues along the band. The band
        // covers a side that it lies across.
        let ((lo, hi), (cell_lo, cell_hi)) = (self.map.extent(self.x, self.y), self.map.grid.corners(self.x, self.y));
        let (from, to) = if k & 1 == 0 { (lo.x, hi.x) } else { (lo.y, hi.y) };
        let (from, to) = if k < 2 { (from, to) } else { (to, from) };
        let start = if halves == 2 { along_side(from, to, 1) } else { from };
        let end = if halves == 1 { along_side(from, to, 1) } else { to };
        let a = match k {
            0 => Raw { x: start, y: cell_lo.y },
            1 => Raw { x: cell_hi.x, y: start },
            2 => Raw { x: start, y: cell_hi.y },
            _ => Raw { x: cell_lo.x, y: start },
        };
        let len = end.wrapping_sub(start).wrapping_abs();
        Some(Geometry::Face { a: a.vec2(), dir: direction(4 * k), len, joined: [false; 2] })
    }

    #[inline(never)]
    fn inner(&self) -> Option<Geometry> {
        let outline = self.kind.shape.outline();
        let corners = self.map.grid.corners(self.x, self.y);
        match outline.inner_kind() {
            InnerKind::None => None,
            InnerKind::Line => {
                let piece = outline.inner_piece();
                let node = |node| {
                    let (i, j) = place(node);
                    Raw { x: along_side(corners.0.x, corners.1.x, i), y: along_side(corners.0.y, corners.1.y, j) }
                };
                let (a, dir) = (node(piece.start), direction(piece.dir));
                // One component of a reduced direction is one: the other way is the length.
                let way = node(piece.end).sub(a);
                let len = if dir.x.unsigned_abs() == 1 { way.x } else { way.y }.wrapping_abs();
                Some(Geometry::Face { a: a.vec2(), dir, len, joined: [false; 2] })
            }
            _ => {
                let form: Form = self.kind.shape.form();
                Some(arc(form, matches!(outline.inner_kind(), InnerKind::Convex), corners))
            }
        }
    }
}

impl<S: ShapeSet, T: Store> Iterator for TilePieces<'_, S, T> {
    type Item = Feature;

    #[inline(never)]
    fn next(&mut self) -> Option<Feature> {
        loop {
            let (index, geometry) = match self.stage {
                PieceStage::X => {
                    self.stage = PieceStage::Y;
                    let k = if self.d.x > 0 { 3 } else { 1 };
                    (k, if self.d.x == 0 { None } else { self.side(k) })
                }
                PieceStage::Y => {
                    self.stage = PieceStage::Inner;
                    let k = if self.d.y > 0 { 0 } else { 2 };
                    (k, if self.d.y == 0 { None } else { self.side(k) })
                }
                PieceStage::Inner => {
                    self.stage = PieceStage::Over;
                    (8, if S::SHAPED { self.inner() } else { None })
                }
                PieceStage::Over => return None,
            };
            if let Some(geometry) = geometry {
                return Some(Feature {
                    geometry,
                    cell: Cell::of(self.x, self.y),
                    index: u16::from(index),
                    flags: self.kind.flags,
                    one_way: self.kind.one_way_side().is_some(),
                    source: 0,
                });
            }
        }
    }
}
