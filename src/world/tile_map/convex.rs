//! Convex shapes against the solid of a map, tile by tile. A tile is a box, a polygon of up to four
//! corners, a quarter of a disc, or the rest of the square around one.

use super::outline::{Form, FormKind};
use super::overlap::TileSolid;
use super::{ShapeSet, Store, TileMap};
use crate::num::Raw;
use crate::query::ArcCell;
use crate::world::convex::ConvexBody;

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    pub(super) fn convex_meets<const CLOSED: bool>(&self, body: &ConvexBody<'_>) -> bool {
        let (lo, hi) = (body.bounds.lo(), body.bounds.hi());
        if let (false, Some(thin)) = (CLOSED, body.as_box()) {
            return self.overlaps(thin);
        }
        let range = if CLOSED { self.solid_range(self.closed_range(lo, hi)) } else { self.solid_range_of(lo, hi) };
        if S::SHAPED {
            self.any_solid(range, |solid| meets_tile::<S, CLOSED>(body, solid))
        } else {
            self.any_full(range, |(lo, hi)| body.meets_box::<CLOSED>(lo, hi))
        }
    }
}

/// One tile. Slopes and arcs are in square cells; what has none reaches as far as its cell.
fn meets_tile<S: ShapeSet, const CLOSED: bool>(body: &ConvexBody<'_>, solid: &TileSolid) -> bool {
    let (Form { right, bottom, kind }, (lo, hi), half) = solid.parts();
    // A point of the form's own frame.
    let at = |u: i32, v: i32| Raw {
        x: if right { hi.x.wrapping_sub(u) } else { lo.x.wrapping_add(u) },
        y: if bottom { hi.y.wrapping_sub(v) } else { lo.y.wrapping_add(v) },
    };
    let (side, size) = (half << 1, hi.sub(lo));
    let block = |u: i32, v: i32| {
        let (p, q) = (at(0, 0), at(u, v));
        body.meets_box::<CLOSED>(Raw { x: p.x.min(q.x), y: p.y.min(q.y) }, Raw { x: p.x.max(q.x), y: p.y.max(q.y) })
    };
    let arc = |centre: Raw, left: bool, above: bool| ArcCell { centre: centre.add(body.offset), left, above, side };
    match kind {
        FormKind::Empty => false,
        FormKind::Line { p: 0, .. } => block(size.x, half),
        FormKind::Line { q: 0, .. } => block(half, size.y),
        FormKind::Line { p, q, k } => {
            // With k = 4 a quad, whole on the side across from the half one; else a triangle.
            let far = |n: u8| side >> (n >> 1);
            if k != 4 {
                let (a, b) = (at(far(p), 0), at(0, far(q)));
                let (a, b) = if right == bottom { (a, b) } else { (b, a) };
                return body.meets::<CLOSED, 3>([at(0, 0), a, b]);
            }
            let (a, b) = if p < q { (at(side, half), at(0, side)) } else { (at(half, side), at(0, side)) };
            let mut points = [at(0, 0), at(side, 0), a, b];
            if right != bottom {
                points.reverse();
            }
            body.meets::<CLOSED, 4>(points)
        }
        FormKind::Convex if S::ARCS => arc(at(0, 0), right, bottom).convex_meets::<CLOSED>(body.core),
        FormKind::Concave if S::ARCS => arc(at(side, side), !right, !bottom).concave_meets::<CLOSED>(body.core),
        _ => block(size.x, size.y),
    }
}
