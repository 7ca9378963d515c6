//! The edges that remain when polygons share some, and the edges that can be near one of them.

use super::path::{Path, PathEdge, point, reversed};
use crate::num::Raw;

/// Runs of consecutive edges are at most so many: 1.5 KB of stack while a level is built. Of 4000
/// edges around one polygon building takes 860 M instructions on x86-64 without runs.
const RUNS: usize = 64;

/// The edges of all polygons in their order, in runs of one length, each with a box around it: what
/// is not near the box is near none of the run.
pub(super) struct Runs {
    all: [EdgeRun; RUNS],
    count: usize,
    /// Edges in a run.
    length: usize,
}

/// A first edge, and the closed box of those from there on.
#[derive(Clone, Copy)]
struct EdgeRun {
    path: usize,
    point: usize,
    lo: Raw,
    hi: Raw,
}

impl EdgeRun {
    const NONE: Self = Self { path: 0, point: 0, lo: Raw { x: 0, y: 0 }, hi: Raw { x: 0, y: 0 } };

    const fn with(&mut self, p: Raw) {
        if p.x < self.lo.x {
            self.lo.x = p.x;
        }
        if p.y < self.lo.y {
            self.lo.y = p.y;
        }
        if p.x > self.hi.x {
            self.hi.x = p.x;
        }
        if p.y > self.hi.y {
            self.hi.y = p.y;
        }
    }
}

impl Runs {
    /// The edges of all polygons among the paths.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loops, and by the length of a run")]
    pub(super) const fn of(paths: &[Path<'_>]) -> Self {
        let (mut edges, mut i) = (0, 0);
        while i < paths.len() {
            if paths[i].kind.is_polygon() {
                edges += paths[i].points.len();
            }
            i += 1;
        }
        let mut runs = Self { all: [EdgeRun::NONE; RUNS], count: 0, length: edges.div_ceil(RUNS) };
        let mut left = 0;
        i = 0;
        while i < paths.len() {
            let path = &paths[i];
            let (mut k, count) = (0, if path.kind.is_polygon() { path.points.len() } else { 0 });
            while k < count {
                let p = point(path, k);
                if left == 0 && runs.count < RUNS {
                    runs.all[runs.count] = EdgeRun { path: i, point: k, lo: p, hi: p };
                    runs.count += 1;
                    left = runs.length;
                }
                let last = runs.count.wrapping_sub(1);
                if last < RUNS {
                    runs.all[last].with(p);
                    runs.all[last].with(point(path, k + 1));
                }
                left = left.wrapping_sub(1);
                k += 1;
            }
            i += 1;
        }
        runs
    }
}

/// An edge of a solid or a hole among all of them, by its path and its first point.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeIndex {
    pub(super) path: usize,
    pub(super) point: usize,
}

/// Up to where, in multiples of the edge's direction from `t` on, nothing changes, and whether the
/// edge is left there.
///
/// ```text
///   edge      ------------------------->      Of m edges one way and n the other, the first min(m, n) of each are cancelled:
///   other           <-----  <-----------      an edge is left where at least as many before it run its way as there are
///   is left   ----->|       |->               edges against it. Nothing needs to be remembered.
/// ```
///
/// Cost: all runs, the edges of those whose box meets that of this edge, and the area of the
/// polygons whose edges overlap it.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
pub(super) const fn left_from(
    paths: &[Path<'_>],
    runs: &Runs,
    place: EdgeIndex,
    edge: &PathEdge,
    t: i32,
) -> (i32, bool) {
    let (mut until, mut along, mut against) = (edge.len, 0u32, 0u32);
    let (a, b) = (edge.a, edge.at(edge.len));
    let mut run = 0;
    while run < RUNS && run < runs.count {
        let EdgeRun { path: mut i, point: mut k, lo, hi } = runs.all[run];
        let is_far = a.x < lo.x && b.x < lo.x
            || a.x > hi.x && b.x > hi.x
            || a.y < lo.y && b.y < lo.y
            || a.y > hi.y && b.y > hi.y;
        let mut left = if is_far { 0 } else { runs.length };
        while left > 0 && i < paths.len() {
            let path = &paths[i];
            let count = if path.kind.is_polygon() { path.points.len() } else { 0 };
            let mut q = point(path, k);
            while k < count && left > 0 {
                let p = q;
                q = point(path, k + 1);
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
                left -= 1;
            }
            if k >= count {
                (i, k) = (i + 1, 0);
            }
        }
        run += 1;
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

/// The position of a point on the line of an edge, in multiples of its direction. `None` off the
/// line.
///
/// The lattice points of a line lie at multiples of its reduced direction: the quotients are exact.
const fn along_edge(edge: &PathEdge, p: Raw) -> Option<i32> {
    let m = p.sub(edge.a);
    if (Raw { x: edge.dir.x, y: edge.dir.y }).cross(m) != 0 {
        None
    } else if edge.dir.x != 0 {
        m.x.checked_div(edge.dir.x)
    } else {
        m.y.checked_div(edge.dir.y)
    }
}
