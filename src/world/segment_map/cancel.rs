//! The edges that remain when polygons share some.
//!
//! An edge meets few others, and only a fixed amount of memory may be used to find those. So the
//! edges are taken in blocks. All edges are read once per block. A small picture of the block
//! rejects those that are not near any of its edges, in any order of the polygons.

use super::path::{Path, PathEdge, point, reversed};
use crate::num::Raw;

/// Edges in a block, bits of a word: 2.9 KB of stack while a level is built. The edges of a level
/// are read once for this many of them, at about 110 instructions each if none is far away.
const BLOCK: usize = 64;

/// The picture of a block has at most this many columns and rows.
const SIDE: usize = 64;

/// An edge of a solid or a hole among all of them, by its path and its first point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct EdgeIndex {
    pub(super) path: u32,
    pub(super) point: u32,
}

impl EdgeIndex {
    const fn is(self, o: Self) -> bool {
        self.path == o.path && self.point == o.point
    }

    /// The next edge of a polygon from here on, itself included. `None` after the last.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
    const fn here(self, paths: &[Path<'_>]) -> Option<Self> {
        let (mut path, mut k) = (self.path as usize, self.point as usize);
        while path < paths.len() {
            if paths[path].kind.is_polygon() && k < paths[path].points.len() {
                return Some(Self { path: path as u32, point: k as u32 });
            }
            (path, k) = (path + 1, 0);
        }
        None
    }

    const fn is_before(self, o: Self) -> bool {
        self.path < o.path || self.path == o.path && self.point < o.point
    }

    const fn next(self) -> Self {
        Self { point: self.point.wrapping_add(1), ..self }
    }
}

/// The edges that share more than a point with an edge: how many, the first one and the last.
#[derive(Clone, Copy)]
pub(super) struct Shared {
    count: u8,
    first: EdgeIndex,
    last: EdgeIndex,
    /// Whether the segments of their polygons run against the points.
    first_reversed: bool,
    last_reversed: bool,
}

/// An edge, and whether the segments of its polygon run against the points.
#[derive(Clone, Copy)]
struct Other {
    edge: EdgeIndex,
    reversed: bool,
}

impl Shared {
    const NONE: Self = Self {
        count: 0,
        first: EdgeIndex { path: 0, point: 0 },
        last: EdgeIndex { path: 0, point: 0 },
        first_reversed: false,
        last_reversed: false,
    };

    const fn with(&mut self, other: Other) {
        if self.count == 0 {
            (self.first, self.first_reversed) = (other.edge, other.reversed);
        }
        (self.last, self.last_reversed) = (other.edge, other.reversed);
        self.count = self.count.saturating_add(1);
    }

    const fn first(&self) -> Option<Other> {
        if self.count == 0 { None } else { Some(Other { edge: self.first, reversed: self.first_reversed }) }
    }

    /// The one after another one. Other edges may be included.
    const fn after(&self, paths: &[Path<'_>], other: Other) -> Option<Other> {
        if other.edge.is(self.last) {
            return None;
        }
        if self.count == 2 {
            return Some(Other { edge: self.last, reversed: self.last_reversed });
        }
        match other.edge.next().here(paths) {
            Some(edge) if edge.path == other.edge.path => Some(Other { edge, ..other }),
            Some(edge) => Some(Other { edge, reversed: is_reversed(paths, edge.path) }),
            None => None,
        }
    }
}

/// A closed box.
#[derive(Clone, Copy)]
struct Bounds {
    lo: Raw,
    hi: Raw,
}

impl Bounds {
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

/// Consecutive edges of the polygons, and which others share a part of each.
///
/// ```text
///     . . . . . .      The picture: for each column and each row, a bit for each edge of the block whose box meets it.
///     . A A . . .      Edges that share a part have a column and a row in common. So the edges of the block that an
///     . A . B B .      edge is compared with are one word: those of its columns, and those of its rows.
///     . . . . B .
/// ```
pub(super) struct EdgeBlock {
    edges: [EdgeIndex; BLOCK],
    count: usize,
    around: Bounds,
    /// The log2 of a column's and of a row's width.
    shift: (u32, u32),
    columns: [u64; SIDE],
    rows: [u64; SIDE],
    shared: [Shared; BLOCK],
    /// Whether the segments of a polygon run against its points: the last one that was looked at.
    reversed: Option<(u32, bool)>,
    /// The next requested edge.
    asked: usize,
}

impl EdgeBlock {
    /// Before any edge. The first requested edge is the first of all.
    pub(super) const EMPTY: Self = Self {
        edges: [EdgeIndex { path: 0, point: 0 }; BLOCK],
        count: 0,
        around: Bounds { lo: Raw { x: 0, y: 0 }, hi: Raw { x: 0, y: 0 } },
        shift: (0, 0),
        columns: [0; SIDE],
        rows: [0; SIDE],
        shared: [Shared::NONE; BLOCK],
        reversed: None,
        asked: 0,
    };

    /// The edges that share a part of an edge. All edges of all polygons must be requested, in
    /// their order.
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    pub(super) const fn shared(&mut self, paths: &[Path<'_>], edge: EdgeIndex) -> Shared {
        if self.asked == self.count {
            self.load(paths, edge);
        }
        let asked = self.asked;
        self.asked += 1;
        if asked < BLOCK { self.shared[asked] } else { Shared::NONE }
    }

    /// The block from an edge on.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loops and the length of a block")]
    const fn load(&mut self, paths: &[Path<'_>], start: EdgeIndex) {
        let first = edge_at(paths, start).0;
        self.around = Bounds { lo: first, hi: first };
        (self.columns, self.rows) = ([0; SIDE], [0; SIDE]);
        (self.shared, self.asked) = ([Shared::NONE; BLOCK], 0);
        let (mut next, mut n) = (start.here(paths), 0);
        while n < BLOCK {
            let Some(edge) = next else { break };
            let (p, q) = edge_at(paths, edge);
            self.around.with(p);
            self.around.with(q);
            self.edges[n] = edge;
            n += 1;
            next = edge.next().here(paths);
        }
        self.count = n;
        let Bounds { lo, hi } = self.around;
        self.shift = (shift((hi.x - lo.x) as u32), shift((hi.y - lo.y) as u32));
        while n > 0 && n <= BLOCK {
            n -= 1;
            let (p, q) = edge_at(paths, self.edges[n]);
            self.mark(n, p, q);
        }
        let mut i = 0;
        while i < paths.len() {
            if paths[i].kind.is_polygon() {
                self.compare(paths, &paths[i], i as u32);
            }
            i += 1;
        }
    }

    /// The first column and the last one of an edge's box, and its rows; for edges outside of the
    /// picture, those at its sides. Without calls, because the compiler counts them in constants.
    #[inline]
    const fn squares(&self, p: Raw, q: Raw) -> [usize; 4] {
        let Bounds { lo, hi } = self.around;
        let (x0, x1) = if p.x < q.x { (p.x, q.x) } else { (q.x, p.x) };
        let (y0, y1) = if p.y < q.y { (p.y, q.y) } else { (q.y, p.y) };
        // Inside the domain: differences are below 2^30.
        let (x0, x1) = (if x0 > lo.x { x0 - lo.x } else { 0 }, if x1 < hi.x { x1 - lo.x } else { hi.x - lo.x });
        let (y0, y1) = (if y0 > lo.y { y0 - lo.y } else { 0 }, if y1 < hi.y { y1 - lo.y } else { hi.y - lo.y });
        [
            (x0 >> self.shift.0) as usize,
            (x1 >> self.shift.0) as usize,
            (y0 >> self.shift.1) as usize,
            (y1 >> self.shift.1) as usize,
        ]
    }

    /// Draws an edge of the block.
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    const fn mark(&mut self, n: usize, p: Raw, q: Raw) {
        let [mut x, x1, mut y, y1] = self.squares(p, q);
        while x <= x1 && x < SIDE {
            self.columns[x] |= 1 << (n & 63);
            x += 1;
        }
        while y <= y1 && y < SIDE {
            self.rows[y] |= 1 << (n & 63);
            y += 1;
        }
    }

    /// Compares the edges of a polygon with those of the block.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loops")]
    const fn compare(&mut self, paths: &[Path<'_>], path: &Path<'_>, index: u32) {
        let (points, count) = (path.points, path.points.len());
        let Bounds { lo, hi } = self.around;
        let first = point(path, 0);
        let (mut k, mut q) = (0, first);
        while k < count {
            let p = q;
            k += 1;
            q = if k < count { Raw { x: points[k].x.to_bits(), y: points[k].y.to_bits() } } else { first };
            if p.x < lo.x && q.x < lo.x
                || p.x > hi.x && q.x > hi.x
                || p.y < lo.y && q.y < lo.y
                || p.y > hi.y && q.y > hi.y
            {
                continue;
            }
            let [mut x, x1, mut y, y1] = self.squares(p, q);
            let (mut across, mut near) = (0, 0);
            while x <= x1 && x < SIDE {
                across |= self.columns[x];
                x += 1;
            }
            while across != 0 && y <= y1 && y < SIDE {
                near |= self.rows[y];
                y += 1;
            }
            near &= across;
            while near != 0 {
                self.compare_edge(
                    paths,
                    near.trailing_zeros() as usize,
                    EdgeIndex { path: index, point: (k - 1) as u32 },
                );
                near &= near - 1;
            }
        }
    }

    /// Compares an edge of the block with another edge.
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    const fn compare_edge(&mut self, paths: &[Path<'_>], n: usize, other: EdgeIndex) {
        if n >= BLOCK || other.is(self.edges[n]) {
            return;
        }
        let ((a, b), (p, q)) = (edge_at(paths, self.edges[n]), edge_at(paths, other));
        if share(a, b, p, q) {
            let reversed = self.is_reversed(paths, other.path);
            self.shared[n].with(Other { edge: other, reversed });
        }
    }

    /// [`reversed`], which reads all points, once for the edges of a polygon in a row.
    const fn is_reversed(&mut self, paths: &[Path<'_>], path: u32) -> bool {
        match self.reversed {
            Some((last, reversed)) if last == path => reversed,
            _ => {
                let reversed = is_reversed(paths, path);
                self.reversed = Some((path, reversed));
                reversed
            }
        }
    }
}

/// The least shift that makes a distance less than [`SIDE`].
const fn shift(distance: u32) -> u32 {
    (u32::BITS - distance.leading_zeros()).saturating_sub(SIDE.trailing_zeros())
}

/// The ends of an edge, which exists.
const fn edge_at(paths: &[Path<'_>], edge: EdgeIndex) -> (Raw, Raw) {
    match path_at(paths, edge.path) {
        Some(path) => (point(path, edge.point as usize), point(path, edge.point as usize + 1)),
        None => (Raw::ZERO, Raw::ZERO),
    }
}

const fn is_reversed(paths: &[Path<'_>], path: u32) -> bool {
    match path_at(paths, path) {
        Some(path) => reversed(path),
        None => false,
    }
}

#[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
const fn path_at<'p, 'a>(paths: &'p [Path<'a>], path: u32) -> Option<&'p Path<'a>> {
    let path = path as usize;
    if path < paths.len() { Some(&paths[path]) } else { None }
}

/// Whether two edges share more than a point. Distances are below 2^30: the products are below
/// 2^61.
const fn share(a: Raw, b: Raw, p: Raw, q: Raw) -> bool {
    let d = b.sub(a);
    if d.cross(p.sub(a)) != 0 || d.cross(q.sub(a)) != 0 {
        return false;
    }
    let ((from, to), (other_from, other_to)) =
        if d.x != 0 { (ordered(a.x, b.x), ordered(p.x, q.x)) } else { (ordered(a.y, b.y), ordered(p.y, q.y)) };
    from < other_to && other_from < to
}

const fn ordered(a: i32, b: i32) -> (i32, i32) {
    if a < b { (a, b) } else { (b, a) }
}

/// The end of the part of an edge from `t` on in which nothing changes, in multiples of the edge's
/// direction. Also whether the edge is left in that part.
///
/// ```text
///   edge      ------------------------->      Of m edges one way and n the other, the first min(m, n) of each are cancelled:
///   other           <-----  <-----------      an edge is left where at least as many before it run its way as there are
///   is left   ----->|       |->               edges against it. Nothing needs to be remembered.
/// ```
///
/// Cost: the edges that share a part of it. If those are more than two, all edges from the first to
/// the last, and the area of their polygons.
pub(super) const fn left_from(
    paths: &[Path<'_>],
    shared: Shared,
    place: EdgeIndex,
    edge: &PathEdge,
    t: i32,
) -> (i32, bool) {
    let (mut until, mut along, mut against) = (edge.len, 0u32, 0u32);
    let mut next = shared.first();
    while let Some(other) = next {
        let (p, q) = edge_at(paths, other.edge);
        let itself = other.edge.is(place);
        if let (Some(from), Some(to), false) = (along_edge(edge, p), along_edge(edge, q), itself) {
            let (lo, hi) = if from < to { (from, to) } else { (to, from) };
            if lo > t && lo < until {
                until = lo;
            } else if lo <= t && hi > t {
                if hi < until {
                    until = hi;
                }
                if (from < to) == other.reversed {
                    against = against.wrapping_add(1);
                } else if other.edge.is_before(place) {
                    along = along.wrapping_add(1);
                }
            }
        }
        next = shared.after(paths, other);
    }
    (until, along >= against)
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
