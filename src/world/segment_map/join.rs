//! Where the boundary goes on behind the end of a segment: flat or into a concave corner, or around a vertex.

use super::{Kind, Refs, Seg, SegmentMap};
use crate::num::{Axis, Raw};

/// How a segment is joined to others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joints {
    /// The segment that leaves the vertex at the end.
    pub(super) next: Option<u16>,
    pub(super) start_joined: bool,
    pub(super) end_joined: bool,
}

/// A ray from a point where segments meet.
#[derive(Clone, Copy, Debug)]
struct Ray {
    dir: Axis,
    sector: Sector,
    /// The first segment that runs on it the way that is asked for.
    index: Option<u16>,
    /// Whether one of those is one-way.
    one_way: bool,
}

/// Where a ray is, turned away from another one.
type Sector = u8;

/// Less than half a turn, or half of one.
const LESS: Sector = 1;
const HALF: Sector = 2;
/// More than half a turn.
const MORE: Sector = 3;
/// A whole turn: the same direction.
const WHOLE: Sector = 4;

impl SegmentMap<'_> {
    /// The joints of a segment.
    pub(super) const fn joints(&self, index: u16) -> Joints {
        let seg = self.segment(index);
        let (end, start) = (self.turn(&seg, true), self.turn(&seg, false));
        if matches!(seg.kind, Kind::OneWay) {
            // Around a convex corner the chain carries as well, so there is a vertex; its faces block up to there all the same.
            let next = if end.sector == MORE && end.one_way { end.index } else { None };
            return Joints { next, start_joined: goes_on(&start), end_joined: goes_on(&end) };
        }
        let next = if end.sector >= MORE { end.index } else { None };
        Joints { next, start_joined: start.sector < MORE || start.index.is_none(), end_joined: next.is_none() }
    }

    /// From a segment, at its end (or its start), through the free side to the first ray of any segment.
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
    /// The free side of a direction is on its right, where y grows up: from the end one turns left there, from the start right.
    /// Segments that block from one side only are no part of the solid, so that only their own kind sees them.
    const fn turn(&self, seg: &Seg, at_end: bool) -> Ray {
        let (p, base) = if at_end { (seg.b(), seg.dir.reversed()) } else { (seg.a, seg.dir) };
        let one_way = matches!(seg.kind, Kind::OneWay);
        let mut best = Ray { dir: base, sector: WHOLE, index: None, one_way: false };
        let mut refs = self.refs_at(p);
        while let Some(index) = refs.advance() {
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

    /// The segments of a cell that holds a point of the grid: every segment through the point is among them.
    const fn refs_at(&self, p: Raw) -> Refs<'_> {
        let (x, y) = (self.grid.column(p.x), self.grid.row(p.y));
        let (last_x, last_y) = (self.grid.x.count as i32 - 1, self.grid.y.count as i32 - 1);
        self.refs(if x < last_x { x } else { last_x }, if y < last_y { y } else { last_y })
    }
}

/// Of a one-way face: whether what is next blocks a body on the face, too. Its own kind does around a corner as well.
const fn goes_on(ray: &Ray) -> bool {
    ray.sector <= HALF || ray.sector == MORE && ray.one_way
}

/// The ray that comes first, of two. Rays of one direction are one.
const fn nearer(base: Axis, left: bool, best: Ray, dir: Axis, index: Option<u16>, one_way: bool) -> Ray {
    let sector = sector(base, dir, left);
    let ray = Ray { dir, sector, index, one_way };
    if sector != best.sector {
        return if sector < best.sector { ray } else { best };
    }
    let turn = turned(dir, best.dir, left);
    if turn > 0 {
        return ray;
    }
    if turn == 0 {
        let index = if best.index.is_some() { best.index } else { index };
        return Ray { index, one_way: best.one_way || one_way, ..best };
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
