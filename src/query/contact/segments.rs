//! Contacts of segments with boxes and segments: the least exit over the normals of both.

use super::{Contact, Contacts, boxes, parallel_to_unit};
use crate::num::{Axis, Raw, less128, mul64, sqr64, usqr};
use crate::query::fraction::Square;
use crate::query::meet::{self, corners, cross_range};
use crate::shape::{Aabb, Segment};

impl Contacts<Segment> for Aabb {
    #[inline]
    fn contact(&self, b: &Segment) -> Option<Contact> {
        aabb_segment(self.lo(), self.hi(), b.ra(), b.rb(), 1)
    }
}

impl Contacts<Aabb> for Segment {
    #[inline]
    fn contact(&self, b: &Aabb) -> Option<Contact> {
        aabb_segment(b.lo(), b.hi(), self.ra(), self.rb(), -1).map(Contact::flipped)
    }
}

impl Contacts<Segment> for Segment {
    #[inline]
    fn contact(&self, b: &Segment) -> Option<Contact> {
        segment_segment(self.ra(), self.rb(), b.ra(), b.rb())
    }
}

/// The ends in lexicographic order, so that reversing a segment changes nothing.
const fn ordered(a: Raw, b: Raw) -> (Raw, Raw) {
    if b.x < a.x || (b.x == a.x && b.y < a.y) { (b, a) } else { (a, b) }
}

/// The edge from the smaller to the larger end.
pub(super) const fn ordered_edge(a: Raw, b: Raw) -> Raw {
    let (a, b) = ordered(a, b);
    b.sub(a)
}

/// A is the box.
fn aabb_segment(lo: Raw, hi: Raw, a: Raw, b: Raw, prefer: i32) -> Option<Contact> {
    if !meet::segment_aabb::<false>(a, b, lo, hi) {
        return None;
    }
    let (a, b) = ordered(a, b);
    let (slo, shi) = corners(a, b);
    let flat = boxes::least_exit(lo, hi, slo, shi, prefer);
    let e = b.sub(a);
    if e.x == 0 || e.y == 0 {
        return Some(flat);
    }
    // Along x or y a sloped segment is deepest with an end: the one with the smaller coordinate where B is left along +.
    let Axis { x, y } = flat.axis;
    let first = x > 0 || (x == 0 && (y > 0) == (e.y > 0));
    let flat = Contact { core: if first { a } else { b }, ..flat.on_b() };

    // Along the normal (-e.y, e.x) the box reaches from min < 0 to max > 0, the segment is at 0.
    let (min, max) = cross_range(a, e, lo, hi);
    let back = min.wrapping_neg();
    let tie = max == back;
    let forward = if tie { prefer > 0 } else { max < back };
    let s = if forward { max } else { back };
    let (steep, level) = (sqr64(s as u64), mul64(usqr(flat.overlap as u32), e.len2()));
    if less128(steep, level) {
        let left = Axis::new(e.y.wrapping_neg(), e.x);
        let axis = if forward { left } else { left.reversed() };
        Some(Contact::new(axis, s, support(axis, lo, hi)).with_degenerate(tie))
    } else {
        Some(flat.with_degenerate(flat.degenerate || !less128(level, steep)))
    }
}

/// The corner of a box that reaches farthest along an axis that is parallel to no side.
const fn support(n: Axis, lo: Raw, hi: Raw) -> Raw {
    Raw { x: if n.x > 0 { hi.x } else { lo.x }, y: if n.y > 0 { hi.y } else { lo.y } }
}

/// One segment's shorter way out over the line of another.
struct Exit {
    /// The normal of the line, toward the end that is shorter behind it.
    axis: Axis,
    /// How far that end is behind the line, times the axis' length.
    s: i64,
    /// That end.
    end: Raw,
    tie: bool,
    /// The normal by which ties are decided.
    normal: Axis,
}

/// The exit of segment `p q` over the line of `a b`, which it crosses properly; `axis` points from `a b` to `p q`.
///
/// `prefer` is the side to take in a tie.
fn over(a: Raw, b: Raw, p: Raw, q: Raw, prefer: i32) -> Exit {
    let (a, b) = ordered(a, b);
    let e = parallel_to_unit(b.sub(a));
    let normal = e.perp();
    let side = |v: Raw| Raw { x: e.x, y: e.y }.cross(v.sub(a));
    let (p, q) = if side(p) < 0 { (p, q) } else { (q, p) };
    // p is behind by `back`, q in front by `front`: moving `a b` against the normal leaves p, along it leaves q.
    let (back, front) = (side(p).wrapping_neg(), side(q));
    let tie = back == front;
    if back < front || (tie && prefer > 0) {
        Exit { axis: normal, s: back, end: p, tie, normal }
    } else {
        Exit { axis: normal.reversed(), s: front, end: q, tie, normal }
    }
}

fn segment_segment(a0: Raw, a1: Raw, b0: Raw, b1: Raw) -> Option<Contact> {
    if !meet::segment_segment::<false>(a0, a1, b0, b1) {
        return None;
    }
    // The second exit is seen with the roles exchanged: its axis is reversed below.
    let (of_b, of_a) = (over(a0, a1, b0, b1, 1), over(b0, b1, a0, a1, -1));
    let square = |exit: &Exit| Square { num: sqr64(exit.s as u64), den: exit.axis.length_squared() };
    let (less, more) = (square(&of_b).less(square(&of_a)), square(&of_a).less(square(&of_b)));
    let equal = !less && !more;
    if less || (equal && rank(of_b.normal) < rank(of_a.normal)) {
        Some(Contact::new(of_b.axis, of_b.s, of_b.end).on_b().with_degenerate(of_b.tie || equal))
    } else {
        Some(Contact::new(of_a.axis.reversed(), of_a.s, of_a.end).with_degenerate(of_a.tie || equal))
    }
}

/// The order of normals in a tie; different for normals that are not parallel.
const fn rank(n: Axis) -> (bool, bool, i32, i32) {
    (n.y != 0, n.x != 0, n.x, n.y)
}
