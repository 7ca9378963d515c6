//! The pieces of one tile that can oppose a ray: two sides and what is within, without their joints.

use super::form::Form;
use super::outline::{InnerKind, direction, place};
use super::shape_surface::{along, arc};
use crate::num::Raw;
use crate::world::{Cell, Feature, Geometry, Set, Store, TileKind, TileMap, TileShape};

/// Cursor over the pieces of a cell, as [`features`](TileMap::features) has them, less vertices, sides that the motion does not oppose, and the
/// marks of joints: a ray has no use for those, and they are most of the work.
#[derive(Clone, Debug)]
pub(in crate::world) struct TilePieces<'w, S: Set, T: Store> {
    map: &'w TileMap<'w, S, T>,
    kind: TileKind,
    x: i32,
    y: i32,
    d: Raw,
    stage: Stage,
}

#[derive(Clone, Copy, Debug)]
enum Stage {
    X,
    Y,
    Inner,
    Over,
}

impl<'w, S: Set, T: Store> TilePieces<'w, S, T> {
    pub(in crate::world) const fn new(map: &'w TileMap<'w, S, T>, kind: TileKind, x: i32, y: i32, d: Raw) -> Self {
        Self { map, kind, x, y, d, stage: Stage::X }
    }

    /// The part of side `k` that bounds the solid, or blocks, and is not covered by the tile across.
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
        // Where a band is merged with a cell, its side goes on along the band; a side across which the band lies is covered.
        let ((lo, hi), (cell_lo, cell_hi)) = (self.map.extent(self.x, self.y), self.map.grid.corners(self.x, self.y));
        let (from, to) = if k & 1 == 0 { (lo.x, hi.x) } else { (lo.y, hi.y) };
        let (from, to) = if k < 2 { (from, to) } else { (to, from) };
        let start = if halves == 2 { along(from, to, 1) } else { from };
        let end = if halves == 1 { along(from, to, 1) } else { to };
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
                    Raw { x: along(corners.0.x, corners.1.x, i), y: along(corners.0.y, corners.1.y, j) }
                };
                let (a, dir) = (node(piece.start), direction(piece.dir));
                // One component of a reduced direction is one, so that the other way is the length.
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

impl<S: Set, T: Store> Iterator for TilePieces<'_, S, T> {
    type Item = Feature;

    #[inline(never)]
    fn next(&mut self) -> Option<Feature> {
        loop {
            let (index, geometry) = match self.stage {
                Stage::X => {
                    self.stage = Stage::Y;
                    let k = if self.d.x > 0 { 3 } else { 1 };
                    (k, if self.d.x == 0 { None } else { self.side(k) })
                }
                Stage::Y => {
                    self.stage = Stage::Inner;
                    let k = if self.d.y > 0 { 0 } else { 2 };
                    (k, if self.d.y == 0 { None } else { self.side(k) })
                }
                Stage::Inner => {
                    self.stage = Stage::Over;
                    (8, if S::SHAPED { self.inner() } else { None })
                }
                Stage::Over => return None,
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
