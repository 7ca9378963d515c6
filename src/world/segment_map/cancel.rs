//! What is left of an edge where polygons share it.

use super::Path;
use super::orient::{Edge, point, reversed};
use crate::num::Raw;

/// An edge of a solid or a hole among all of them, by its path and its first point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) path: usize,
    pub(super) point: usize,
}

/// Up to where, in multiples of the edge's direction from `t` on, nothing changes, and whether the edge is left there.
///
/// ```text
///   edge      ------------------------->      Of m edges one way and n the other, the first min(m, n) of each are cancelled:
///   other           <-----  <-----------      an edge is left where at least as many before it run its way as there are
///   is left   ----->|       |->               edges against it. Nothing needs to be remembered.
/// ```
///
/// Cost: all edges of all polygons, and the area of those that overlap this one.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
pub(super) const fn left_from(paths: &[Path<'_>], place: Place, edge: &Edge, t: i32) -> (i32, bool) {
    let (mut until, mut along, mut against) = (edge.len, 0u32, 0u32);
    let b = edge.at(edge.len);
    let mut i = 0;
    while i < paths.len() {
        let path = &paths[i];
        if path.kind.is_polygon() {
            let (points, count) = (path.points, path.points.len());
            let (mut k, mut q) = (0, point(path, 0));
            while k < count {
                let p = q;
                q = Raw::of(points[if k + 1 < count { k + 1 } else { 0 }]);
                let itself = i == place.path && k == place.point;
                if !itself && boxes_meet(edge.a, b, p, q) {
                    if let (Some(from), Some(to)) = (along_edge(edge, p), along_edge(edge, q)) {
                        let (lo, hi) = if from < to { (from, to) } else { (to, from) };
                        if lo > t && lo < until {
                            until = lo;
                        } else if lo <= t && hi > t {
                            if hi < until {
                                until = hi;
                            }
                            if (from < to) == reversed(path) {
                                against = against.wrapping_add(1);
                            } else if i < place.path || (i == place.path && k < place.point) {
                                along = along.wrapping_add(1);
                            }
                        }
                    }
                }
                k += 1;
            }
        }
        i += 1;
    }
    (until, along >= against)
}

/// Whether the closed boxes of two edges meet.
const fn boxes_meet(a: Raw, b: Raw, p: Raw, q: Raw) -> bool {
    !(a.x < p.x && a.x < q.x && b.x < p.x && b.x < q.x
        || a.x > p.x && a.x > q.x && b.x > p.x && b.x > q.x
        || a.y < p.y && a.y < q.y && b.y < p.y && b.y < q.y
        || a.y > p.y && a.y > q.y && b.y > p.y && b.y > q.y)
}

/// Where a point is on the line of an edge, in multiples of its direction; `None` off the line.
///
/// The lattice points of a line lie at multiples of its reduced direction: the quotients are exact.
const fn along_edge(edge: &Edge, p: Raw) -> Option<i32> {
    let m = p.sub(edge.a);
    if (Raw { x: edge.dir.x, y: edge.dir.y }).cross(m) != 0 {
        None
    } else if edge.dir.x != 0 {
        m.x.checked_div(edge.dir.x)
    } else {
        m.y.checked_div(edge.dir.y)
    }
}
