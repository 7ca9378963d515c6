//! Strict overlap and closed touch with the solid of a segment map; points, and boxes without area.
//!
//! A query that has met no segment of the boundary tests only one point of the body. It takes the
//! stored winding number of its cell, and the segments crossed on the line from there. That point
//! is moved by an infinitesimal `e` along x and by `e^2` along y, as the reference points of the
//! cells are. It is then on no segment, and no case is missed.

use super::{Kind, Seg, SegmentMap};
use crate::num::{Raw, imul, less128, mul64};
use crate::query::{Overlaps, Touches, meet};
use crate::shape::{Aabb, Circle};
use crate::world::cell::Range;
use crate::world::level::levels;
use crate::world::probes::Probe;

levels! {
    [] SegmentMap<'_> {
        /// Whether a shape overlaps the solid: a wall or the boundary of a polygon reaches its
        /// inside, or it lies within a polygon.
        ///
        /// Strict and exact: a body that touches a wall or fills a gap exactly does not overlap. A
        /// wall has no thickness, and overlaps the shapes that it crosses. A body without area (a
        /// circle of radius 0, a box without width or height) overlaps only polygons. One-way
        /// segments never overlap anything. Outside of the grid nothing is solid.
        ///
        /// Cost: one test for each segment in each cell under the body, until the first hit, and
        /// one winding number. It cannot fail.
        ///
        /// ```
        /// use tilesat::{Circle, Fx, Path, PathKind, Vec2, fx, segment_map};
        /// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 0), Vec2::from_ints(128, 64)];
        /// const DOOR: [Vec2; 2] = [Vec2::from_ints(128, 64), Vec2::from_ints(128, 0)];
        /// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL), Path::new(PathKind::Wall, &DOOR)], fx!(32));
        /// let ball = |x, y, r| Circle::new(Vec2::from_ints(x, y), Fx::from_num(r)).unwrap();
        /// assert!(LEVEL.overlaps(&ball(64, 40, 2))); // deep in the hill
        /// assert!(LEVEL.touches(&ball(120, 10, 8)) && !LEVEL.overlaps(&ball(120, 10, 8))); // at the door
        /// assert!(LEVEL.overlaps(&ball(120, 10, 9)) && LEVEL.overlaps(&ball(136, 10, 9))); // from both sides
        /// ```
        overlaps,
        /// Whether a shape has a point in common with the solid or a wall, borders
        /// included.
        ///
        /// Exact. One-way segments are not solid. Cost: as [`overlaps`](Self::overlaps).
        touches,
    }
}

impl SegmentMap<'_> {
    /// The flags, or-ed, of all segments that a box, circle or point touches: boundaries, walls and
    /// one-way segments, ends included.
    ///
    /// The flags are those of the lines: a body inside a polygon that touches none of its edges has
    /// none. Exact. Cost: one test for each segment with new flags, in each cell under the shape.
    ///
    /// ```
    /// use tilesat::{Aabb, Path, PathKind, Vec2, fx, segment_map};
    /// const LAVA: [Vec2; 2] = [Vec2::from_ints(0, 48), Vec2::from_ints(40, 48)];
    /// const SHORE: [Vec2; 2] = [Vec2::from_ints(40, 48), Vec2::from_ints(80, 48)];
    /// segment_map!(static LEVEL: [Path::new(PathKind::Wall, &LAVA).with_flags(4), Path::new(PathKind::Wall, &SHORE)], fx!(32));
    /// let flags = |x| LEVEL.flags_touched(&Aabb::from_size(Vec2::from_ints(x, 34), Vec2::from_ints(10, 14)).unwrap());
    /// assert_eq!((flags(20), flags(40), flags(41)), (4, 4, 0));
    /// ```
    #[must_use]
    pub fn flags_touched<B: Probe>(&self, shape: &B) -> u8 {
        let (lo, hi) = shape.bounds();
        let mut flags = 0;
        self.any(self.cells(lo, hi), |seg| {
            if seg.flags & !flags != 0 && shape.meets(seg.a, seg.b()) {
                flags |= seg.flags;
            }
            false
        });
        flags
    }

    /// Whether something is true of a segment of a range of cells. Tests a segment once in each
    /// cell.
    pub(super) fn any(&self, range: Range, mut test: impl FnMut(&Seg) -> bool) -> bool {
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                for index in self.refs(x, y) {
                    if test(&self.segment(index)) {
                        return true;
                    }
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        false
    }

    /// Whether a body meets a segment that blocks from both sides, or has a point in a polygon that
    /// is on no such segment.
    fn meets(&self, range: Range, inner: Raw, test: impl Fn(Raw, Raw) -> bool) -> bool {
        self.any(range, |seg| seg.kind != Kind::OneWay && test(seg.a, seg.b())) || self.winding_beside(inner) > 0
    }
}

impl Overlaps<Aabb> for SegmentMap<'_> {
    fn overlaps(&self, b: &Aabb) -> bool {
        let (lo, hi) = (b.lo(), b.hi());
        if lo.x == hi.x || lo.y == hi.y {
            return self.thin_overlaps(lo, hi);
        }
        // The point just beside its first corner is inside the box.
        self.meets(self.open_cells(lo, hi), lo, |p, q| meet::segment_aabb::<false>(p, q, lo, hi))
    }
}

impl Overlaps<Circle> for SegmentMap<'_> {
    fn overlaps(&self, b: &Circle) -> bool {
        let (c, r, bounds) = (b.c(), b.r(), b.aabb());
        if r == 0 {
            return self.point_inside(c);
        }
        self.meets(self.open_cells(bounds.lo(), bounds.hi()), c, |p, q| meet::circle_segment::<false>(c, r, p, q))
    }
}

impl Touches<Aabb> for SegmentMap<'_> {
    fn touches(&self, b: &Aabb) -> bool {
        let (lo, hi) = (b.lo(), b.hi());
        self.meets(self.cells(lo, hi), lo, |p, q| meet::segment_aabb::<true>(p, q, lo, hi))
    }
}

impl Touches<Circle> for SegmentMap<'_> {
    fn touches(&self, b: &Circle) -> bool {
        let (c, r, bounds) = (b.c(), b.r(), b.aabb());
        self.meets(self.cells(bounds.lo(), bounds.hi()), c, |p, q| meet::circle_segment::<true>(c, r, p, q))
    }
}

impl SegmentMap<'_> {
    /// The winding number just beside a point, at `p + (e, e^2)`; 0 beyond the grid.
    ///
    /// ```text
    ///   R = corner + (e, e^2):  up along the cell's     p      All that is crossed meets the closed square of the cell. What is at
    ///   side to p's height, then straight to p.    +----->     both ends of a leg, or beyond them, cancels.
    ///                                              R
    /// ```
    ///
    /// Cost: a test of the coordinates for each segment of the cell; for those that reach across,
    /// up to four products.
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

    /// Whether a point is in the inside of the solid: the solid is all around it.
    ///
    /// The winding number beside it is counted on around it, ray by ray of the segments through it.
    /// Cost: the segments of its cell; their square if many meet at the point.
    pub(super) fn point_inside(&self, p: Raw) -> bool {
        let start = self.winding_beside(p);
        let after = |ray: Spoke| self.spokes(p).filter(|r| r.up_to(&ray)).fold(start, |w, r| w.wrapping_add(r.change));
        start > 0 && self.spokes(p).all(|ray| after(ray) > 0)
    }

    /// The segments of a cell that holds a point of the closed grid.
    pub(super) fn around(&self, p: Raw) -> impl Iterator<Item = Seg> {
        let cell = self.cells(p, p);
        self.refs(cell.x1, cell.y1).map(|index| self.segment(index))
    }

    /// The rays of the boundary from a point.
    pub(super) fn spokes(&self, p: Raw) -> impl Iterator<Item = Spoke> {
        self.around(p).flat_map(move |seg| spokes(&seg, p)).flatten()
    }
}

/// The change of the winding number at a segment on the line up along `x = q.x + e` to `q`: +1 from
/// its right to its left.
fn below(seg: &Seg, q: Raw) -> i32 {
    if (seg.a.x <= q.x) == (seg.b().x <= q.x) {
        return 0;
    }
    let side = side(seg, q);
    // If it does not rise where it goes through `q`, the ray passes it: `slope e` against `e^2`.
    let (forward, rises) = (seg.dir.x > 0, (seg.dir.y > 0) == (seg.dir.x > 0) && seg.dir.y != 0);
    let passed = if forward { side > 0 } else { side < 0 } || (side == 0 && !rises);
    if passed { if forward { 1 } else { -1 } } else { 0 }
}

/// The change on the line to the right along `y = q.y + e^2`. Where it goes through `q` it is
/// passed: `e^2` over its slope against `e`.
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
pub(super) struct Spoke {
    pub(super) dir: Raw,
    /// The change of the winding number from its right to its left.
    pub(super) change: i32,
}

/// The two rays of a boundary segment from a point on it.
pub(super) fn spokes(seg: &Seg, p: Raw) -> [Option<Spoke>; 2] {
    if seg.kind != Kind::Solid || !seg.holds(p) {
        return [None, None];
    }
    let dir = Raw { x: seg.dir.x, y: seg.dir.y };
    let back = Raw { x: dir.x.wrapping_neg(), y: dir.y.wrapping_neg() };
    [(seg.b() != p).then_some(Spoke { dir, change: 1 }), (seg.a != p).then_some(Spoke { dir: back, change: -1 })]
}

impl Spoke {
    /// Whether it comes not after `o` on the way around from the direction `(e, e^2)`, to the left.
    pub(super) fn up_to(&self, o: &Self) -> bool {
        let (mine, other) = (self.quarter(), o.quarter());
        mine < other || (mine == other && self.dir.cross(o.dir) >= 0)
    }

    /// Up, straight left, down, straight right in that order: straight right is just before the
    /// start.
    fn quarter(&self) -> u8 {
        match (self.dir.y.signum(), self.dir.x > 0) {
            (1, _) => 0,
            (0, false) => 1,
            (0, true) => 3,
            _ => 2,
        }
    }
}

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

    /// Whether the inside of the solid has a point between two points of a cell, one straight right
    /// of or above the other.
    ///
    /// The boundary cuts the line into pieces, each of which is in the inside if both sides are
    /// solid. The test looks just after the start and after each crossing, in a frame in which the
    /// line leads right. Cost: the square of the segments that cross it.
    fn piece_inside(&self, x: i32, y: i32, p: Raw, q: Raw) -> bool {
        let upright = p.x == q.x;
        let frame = WayFrame {
            upright,
            p: framed(p, upright),
            length: q.x.wrapping_sub(p.x).wrapping_add(q.y.wrapping_sub(p.y)),
        };
        let segments = || self.refs(x, y).map(|index| self.segment(index)).filter(|s| s.kind == Kind::Solid);
        let mut start = self.winding_beside(p);
        if upright {
            // From (e, e^2) to (e^2, e): over the rays between.
            let between = segments().flat_map(|s| spokes(&s, p)).flatten().filter(|r| r.dir.x > 0 && r.dir.y > 0);
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

/// The line right from `p`; coordinates are exchanged if it leads up in the level.
struct WayFrame {
    upright: bool,
    p: Raw,
    length: i32,
}

/// A boundary segment with its solid on the left.
struct FramedEdge {
    a: Raw,
    b: Raw,
    dir: Raw,
}

/// Where a segment crosses the lines just above and just below that line: after `num / den`, with
/// `num > 0`.
struct Cut {
    num: u64,
    den: u32,
    /// The change of the winding numbers.
    above: i32,
    below: i32,
}

impl Cut {
    /// Below 2^61 times 2^30.
    fn before(&self, o: &Self) -> bool {
        less128(mul64(self.num, u64::from(o.den)), mul64(o.num, u64::from(self.den)))
    }
}

impl WayFrame {
    /// An exchange of coordinates is a mirror: the segment is reversed, which puts its solid on the
    /// left again.
    fn edge(&self, seg: &Seg) -> FramedEdge {
        let (a, b, dir) =
            (framed(seg.a, self.upright), framed(seg.b(), self.upright), Raw { x: seg.dir.x, y: seg.dir.y });
        if self.upright {
            FramedEdge { a: b, b: a, dir: Raw { x: dir.y.wrapping_neg(), y: dir.x.wrapping_neg() } }
        } else {
            FramedEdge { a, b, dir }
        }
    }

    /// The change from below to above of a segment along the line that covers its start.
    fn runs_through_start(&self, seg: &FramedEdge) -> i32 {
        let level = seg.dir.y == 0 && seg.a.y == self.p.y;
        if level && (seg.a.x <= self.p.x) != (seg.b.x <= self.p.x) { seg.dir.x.signum() } else { 0 }
    }

    /// The crossing between the start and the end, both excluded.
    fn cut(&self, seg: &FramedEdge) -> Option<Cut> {
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
        // A ray straight across an upward segment leaves its solid.
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
