//! Finds where the boundary continues behind the end of a segment: flat, into a concave corner, or
//! around a vertex.

use super::parse::{Size, Tables};
use super::{
    ATTR_AT, END_JOINED, Kind, NEXT_AT, Refs, SEGMENT, START_JOINED, Seg, SegmentMap, half, set_byte, set_half,
};
use crate::num::{Axis, Raw};
use crate::query::meet::corners;

/// Vertices and joints, cell after cell; needs the references.
///
/// Cost: each end of a segment is compared with the picture of each segment of its cell, and with
/// the segments whose picture holds it.
#[inline(never)]
pub(super) const fn join(size: &Size, out: &mut [u8]) {
    let Tables { segments, offsets, refs, .. } = size.tables(out);
    let (mut y, mut crowd) = (0, Crowd::EMPTY);
    while y < size.grid.y.count as i32 {
        let mut x = 0;
        while x < size.grid.x.count as i32 {
            let here = SegmentMap { grid: size.grid, segments: &[], offsets, refs, winding: &[] }.refs(x, y).left;
            crowd.take(&SegmentMap { grid: size.grid, segments, offsets, refs, winding: &[] }, here, x, y);
            let mut left = Refs { left: crowd.refs };
            while let Some(index) = left.advance() {
                let map = SegmentMap { grid: size.grid, segments, offsets, refs, winding: &[] };
                let seg = map.segment(index);
                let start = if crowd.is_home(seg.a) { Some(map.turn(&crowd, index, &seg, false)) } else { None };
                let end = if crowd.is_home(seg.b()) { Some(map.turn(&crowd, index, &seg, true)) } else { None };
                let place = (index as usize).wrapping_mul(SEGMENT);
                write(segments, place, matches!(seg.kind, Kind::OneWay), start, end);
            }
            x += 1;
        }
        y += 1;
    }
}

/// Writes the joints of a segment at those of its ends that its cell holds. Each end is in one
/// cell.
const fn write(
    segments: &mut [u8],
    place: usize,
    is_one_way: bool,
    start: Option<SegmentRay>,
    end: Option<SegmentRay>,
) {
    let mut attr = half(segments, place.wrapping_add(ATTR_AT)) as u8;
    if let Some(ray) = start {
        let joined = if is_one_way { goes_on(&ray) } else { ray.sector < MORE || ray.index.is_none() };
        attr |= if joined { START_JOINED } else { 0 };
    }
    if let Some(ray) = end {
        // Around a convex corner a one-way chain also carries, so there is a vertex. Its faces
        // still block up to there.
        let is_vertex = if is_one_way { ray.sector == MORE && ray.one_way } else { ray.sector >= MORE };
        let next = if is_vertex { ray.index } else { None };
        let joined = if is_one_way { goes_on(&ray) } else { next.is_none() };
        attr |= if joined { END_JOINED } else { 0 };
        if let Some(next) = next {
            set_half(segments, place.wrapping_add(NEXT_AT), next);
        }
    }
    set_byte(segments, place.wrapping_add(ATTR_AT), attr);
}

/// Pictures are kept for this many segments of a cell: 1 KB of stack while a level is built.
/// Further segments are all tested.
const ROOM: usize = 256;

/// The segments of a cell, in a coarse picture: the box of each, in the 256 columns and rows of the
/// cell.
struct Crowd<'a> {
    /// All of the cell.
    refs: &'a [u8],
    lo: Raw,
    hi: Raw,
    is_last_column: bool,
    is_last_row: bool,
    /// The log2 of a square's side.
    shift: u32,
    /// The box of each: the first column and row, the last ones.
    boxes: [[u8; 4]; ROOM],
}

impl<'a> Crowd<'a> {
    const EMPTY: Self = Self {
        refs: &[],
        lo: Raw::ZERO,
        hi: Raw::ZERO,
        is_last_column: false,
        is_last_row: false,
        shift: 0,
        boxes: [[0; 4]; ROOM],
    };

    /// The segments of a cell.
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    const fn take(&mut self, map: &SegmentMap<'_>, refs: &'a [u8], x: i32, y: i32) {
        let grid = &map.grid;
        self.refs = refs;
        if refs.is_empty() {
            return;
        }
        let mut refs = Refs { left: refs };
        (self.lo, self.hi) = grid.corners(x, y);
        (self.is_last_column, self.is_last_row) = (x + 1 == grid.x.count as i32, y + 1 == grid.y.count as i32);
        self.shift = (u32::BITS - (grid.cell as u32).leading_zeros()).saturating_sub(u8::BITS);
        let mut n = 0;
        while let Some(index) = refs.advance() {
            if n < ROOM {
                let seg = map.segment(index);
                let (lo, hi) = corners(seg.a, seg.b());
                let ((x0, y0), (x1, y1)) = (self.square(lo), self.square(hi));
                self.boxes[n] = [x0, y0, x1, y1];
            }
            n += 1;
        }
    }

    /// The column and the row of a point; beyond the cell those at its sides.
    const fn square(&self, p: Raw) -> (u8, u8) {
        (self.along(p.x, self.lo.x), self.along(p.y, self.lo.y))
    }

    const fn along(&self, v: i32, from: i32) -> u8 {
        // Inside the domain: below 2^30.
        let d = v.wrapping_sub(from) >> self.shift;
        if d < 0 {
            0
        } else if d > u8::MAX as i32 {
            u8::MAX
        } else {
            d as u8
        }
    }

    /// Whether a segment of the cell can go through a point in this column and row.
    #[inline]
    #[expect(clippy::indexing_slicing, reason = "behind a comparison with the length")]
    const fn may_hold(&self, n: usize, (x, y): (u8, u8)) -> bool {
        if n >= ROOM {
            return true;
        }
        let [x0, y0, x1, y1] = self.boxes[n];
        x0 <= x && x <= x1 && y0 <= y && y <= y1
    }

    /// Whether a point is in the cell, and not on a side that the next cell has too.
    const fn is_home(&self, p: Raw) -> bool {
        p.x >= self.lo.x
            && p.y >= self.lo.y
            && (p.x < self.hi.x || self.is_last_column && p.x == self.hi.x)
            && (p.y < self.hi.y || self.is_last_row && p.y == self.hi.y)
    }
}

/// A ray from a point where segments meet.
#[derive(Clone, Copy, Debug)]
struct SegmentRay {
    dir: Axis,
    sector: Sector,
    /// The first segment on it in the required direction.
    index: Option<u16>,
    /// Whether one of those is one-way.
    one_way: bool,
}

/// The direction of a ray, relative to another one.
type Sector = u8;

/// Less than half a turn, or half of one.
const LESS: Sector = 1;
const HALF: Sector = 2;
/// More than half a turn.
const MORE: Sector = 3;
/// A whole turn: the same direction.
const WHOLE: Sector = 4;

impl SegmentMap<'_> {
    /// Turns from a segment, at its end (or its start), through the free side to the first ray of
    /// any segment.
    ///
    /// ```text
    ///          ^  free  (y up)      At the end P of e, from -e through the side of its outward normal: the first ray is that of f.
    ///     -e   |n                   More than half a turn: P is a vertex, and f, which leaves P, is next. Else the boundary goes
    ///   <======P======= e           on. Of T-junctions count both rays of the segment that passes through P:
    ///   ..../  .......
    ///   .../ f .......                  |e|
    ///   ../ solid ....              ----vP^----> through: next to e is a quarter turn away, P is no vertex
    /// ```
    ///
    /// The free side of a direction is on its right, where y grows up: from the end one turns left
    /// there, from the start right. Segments that block only from one side are not part of the
    /// solid, and count only for their own kind.
    const fn turn(&self, crowd: &Crowd<'_>, itself: u16, seg: &Seg, at_end: bool) -> SegmentRay {
        let (p, base) = if at_end { (seg.b(), seg.dir.reversed()) } else { (seg.a, seg.dir) };
        let one_way = matches!(seg.kind, Kind::OneWay);
        let mut best = SegmentRay { dir: base, sector: WHOLE, index: None, one_way: false };
        let (mut refs, mut n, at) = (Refs { left: crowd.refs }, 0, crowd.square(p));
        while let Some(index) = refs.advance() {
            let may_hold = crowd.may_hold(n, at);
            n += 1;
            // Its own other end is a whole turn away, which is where the search begins.
            if !may_hold || index == itself {
                continue;
            }
            let other = self.segment(index);
            let other_one_way = matches!(other.kind, Kind::OneWay);
            if other_one_way && !one_way || !other.holds(p) {
                continue;
            }
            let (leaves, arrives) = (!same(p, other.b()), !same(p, other.a));
            let wanted = if at_end { leaves } else { arrives };
            if wanted {
                let dir = if at_end { other.dir } else { other.dir.reversed() };
                best = nearer(base, at_end, best, dir, Some(index), other_one_way);
            }
            if !other_one_way && if at_end { arrives } else { leaves } {
                let dir = if at_end { other.dir.reversed() } else { other.dir };
                best = nearer(base, at_end, best, dir, None, false);
            }
        }
        best
    }
}

/// For a one-way face: whether the next one also blocks a body on the face. Its own kind does, even
/// around a corner.
const fn goes_on(ray: &SegmentRay) -> bool {
    ray.sector <= HALF || ray.sector == MORE && ray.one_way
}

/// The ray that comes first of two. Rays of the same direction are one.
const fn nearer(base: Axis, left: bool, best: SegmentRay, dir: Axis, index: Option<u16>, one_way: bool) -> SegmentRay {
    let sector = sector(base, dir, left);
    let ray = SegmentRay { dir, sector, index, one_way };
    if sector != best.sector {
        return if sector < best.sector { ray } else { best };
    }
    let turn = turned(dir, best.dir, left);
    if turn > 0 {
        return ray;
    }
    if turn == 0 {
        let index = if best.index.is_some() { best.index } else { index };
        return SegmentRay { index, one_way: best.one_way || one_way, ..best };
    }
    best
}

/// Directions are below 2^30: the product is below 2^61.
const fn turned(from: Axis, to: Axis, left: bool) -> i64 {
    let cross = from.perp_dot(to);
    if left { cross } else { cross.wrapping_neg() }
}

/// Reduced directions on one line are the same or opposite.
const fn sector(base: Axis, dir: Axis, left: bool) -> Sector {
    let turn = turned(base, dir, left);
    if turn > 0 {
        LESS
    } else if turn < 0 {
        MORE
    } else if base.x == dir.x && base.y == dir.y {
        WHOLE
    } else {
        HALF
    }
}

const fn same(p: Raw, q: Raw) -> bool {
    p.x == q.x && p.y == q.y
}
