//! Overlap of bodies without area: points, and boxes of no width or no height.

use super::solid::rays;
use super::{Kind, Seg, SegmentMap};
use crate::num::{Raw, imul, less128, mul64};

impl SegmentMap<'_> {
    /// Whether a point of a closed box without area is in the inside of the solid.
    pub(super) fn thin_overlaps(&self, lo: Raw, hi: Raw) -> bool {
        if lo == hi {
            return self.point_inside(lo);
        }
        let (range, upright) = (self.cells(lo, hi), lo.x == hi.x);
        let (mut x, mut y) = (range.x0, range.y0);
        while x <= range.x1 && y <= range.y1 {
            let (first, last) = self.grid.corners(x, y);
            let (p, q) = (later(lo, first), earlier(hi, last));
            if p != q && self.piece_inside(x, y, p, q) {
                return true;
            }
            if upright { y = y.wrapping_add(1) } else { x = x.wrapping_add(1) }
        }
        false
    }

    /// Whether the inside of the solid has a point between two points of a cell, one straight right of or above the other.
    ///
    /// The boundary cuts the way in pieces, each of them in the inside where both sides are solid. They are seen from a frame in
    /// which the way leads right, just after its start and after each crossing. Cost: the square of the segments that cross it.
    fn piece_inside(&self, x: i32, y: i32, p: Raw, q: Raw) -> bool {
        let upright = p.x == q.x;
        let frame =
            Frame { upright, p: framed(p, upright), length: q.x.wrapping_sub(p.x).wrapping_add(q.y.wrapping_sub(p.y)) };
        let segments = || self.refs(x, y).map(|index| self.segment(index)).filter(|s| s.kind == Kind::Solid);
        let mut start = self.winding_beside(p);
        if upright {
            // From (e, e^2) to (e^2, e): over the rays between.
            let between = segments().flat_map(|s| rays(&s, p)).flatten().filter(|r| r.dir.x > 0 && r.dir.y > 0);
            start = between.fold(start, |w, r| w.wrapping_add(r.change));
        }
        let sides = |after: Option<&Cut>| {
            let (mut above, mut below) = (start, start);
            for seg in segments() {
                let seg = frame.edge(&seg);
                below = below.wrapping_sub(frame.runs_through_start(&seg));
                let (Some(cut), Some(after)) = (frame.cut(&seg), after) else { continue };
                if !after.before(&cut) {
                    above = above.wrapping_add(cut.above);
                    below = below.wrapping_add(cut.below);
                }
            }
            above > 0 && below > 0
        };
        sides(None) || segments().any(|seg| frame.cut(&frame.edge(&seg)).is_some_and(|cut| sides(Some(&cut))))
    }
}

const fn later(a: Raw, b: Raw) -> Raw {
    Raw { x: if a.x > b.x { a.x } else { b.x }, y: if a.y > b.y { a.y } else { b.y } }
}

const fn earlier(a: Raw, b: Raw) -> Raw {
    Raw { x: if a.x < b.x { a.x } else { b.x }, y: if a.y < b.y { a.y } else { b.y } }
}

const fn framed(p: Raw, upright: bool) -> Raw {
    if upright { Raw { x: p.y, y: p.x } } else { p }
}

/// The way right from `p`; coordinates are exchanged where it leads up in the level.
struct Frame {
    upright: bool,
    p: Raw,
    length: i32,
}

/// A boundary segment with its solid on the left.
struct Edge {
    a: Raw,
    b: Raw,
    dir: Raw,
}

/// Where a segment crosses the lines just above and just below the way: after `num / den`, with `num > 0`.
struct Cut {
    num: u64,
    den: u32,
    /// What the winding numbers change by.
    above: i32,
    below: i32,
}

impl Cut {
    /// Below 2^61 times 2^30.
    fn before(&self, o: &Self) -> bool {
        less128(mul64(self.num, u64::from(o.den)), mul64(o.num, u64::from(self.den)))
    }
}

impl Frame {
    /// An exchange of coordinates is a mirror: the segment is reversed, so that its solid is on the left again.
    fn edge(&self, seg: &Seg) -> Edge {
        let (a, b, dir) =
            (framed(seg.a, self.upright), framed(seg.b(), self.upright), Raw { x: seg.dir.x, y: seg.dir.y });
        if self.upright {
            Edge { a: b, b: a, dir: Raw { x: dir.y.wrapping_neg(), y: dir.x.wrapping_neg() } }
        } else {
            Edge { a, b, dir }
        }
    }

    /// What a segment along the way that covers its start adds from below to above.
    fn runs_through_start(&self, seg: &Edge) -> i32 {
        let level = seg.dir.y == 0 && seg.a.y == self.p.y;
        if level && (seg.a.x <= self.p.x) != (seg.b.x <= self.p.x) { seg.dir.x.signum() } else { 0 }
    }

    /// The crossing between the start and the end, both excluded.
    fn cut(&self, seg: &Edge) -> Option<Cut> {
        let y = self.p.y;
        let (above, below) = ((seg.a.y <= y) != (seg.b.y <= y), (seg.a.y < y) != (seg.b.y < y));
        let den = seg.dir.y.unsigned_abs();
        if den == 0 || !(above || below) {
            return None;
        }
        // Distances inside the domain and directions: the sum is below 2^61.
        let from = seg.a.sub(self.p);
        let num = imul(from.x, seg.dir.y).wrapping_sub(imul(seg.dir.x, from.y));
        let num = if seg.dir.y < 0 { num.wrapping_neg() } else { num };
        // Right across an upward segment is out of its solid.
        let change = seg.dir.y.signum().wrapping_neg();
        let inside = num > 0 && num < imul(self.length, den as i32);
        inside.then_some(Cut {
            num: num as u64,
            den,
            above: change * i32::from(above),
            below: change * i32::from(below),
        })
    }
}
