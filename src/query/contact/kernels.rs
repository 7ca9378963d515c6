//! How each pair of shapes makes a contact.

use super::{Contact, Contacts, parallel_to_unit};
use crate::num::{Axis, LONG, Raw, less128, mul64, sqr64, usqr};
use crate::query::closest::Square;
use crate::query::meet;
use crate::query::meet::{Offset, Region, circle_circle, clamp, corners, cross_range, gap, region};
use crate::shape::{Aabb, Circle, Segment};

impl Contacts<Aabb> for Aabb {
    #[inline]
    fn contact(&self, b: &Aabb) -> Option<Contact> {
        let (alo, ahi, blo, bhi) = (self.lo(), self.hi(), b.lo(), b.hi());
        meet::aabb_aabb::<false>(alo, ahi, blo, bhi).then(|| least_exit(alo, ahi, blo, bhi, 1))
    }
}

/// The least exit along one axis: its length, its sign, and whether both directions are as short.
///
/// `prefer` is the sign to take in a tie. It is -1 where the caller will exchange A and B, which
/// makes the final axis positive.
#[inline]
const fn exit(alo: i32, ahi: i32, blo: i32, bhi: i32, prefer: i32) -> (i32, i32, bool) {
    let (positive, negative) = (ahi.wrapping_sub(blo), bhi.wrapping_sub(alo));
    if positive == negative {
        (positive, prefer, true)
    } else if positive < negative {
        (positive, 1, false)
    } else {
        (negative, -1, false)
    }
}

/// The least of the four exits of one box out of another, x before y; a point is a box too.
#[cfg_attr(target_pointer_width = "64", inline)]
pub(super) const fn least_exit(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw, prefer: i32) -> Contact {
    let (x, sign_x, tie_x) = exit(alo.x, ahi.x, blo.x, bhi.x, prefer);
    let (y, sign_y, tie_y) = exit(alo.y, ahi.y, blo.y, bhi.y, prefer);
    if x <= y {
        let core = Raw { x: if sign_x > 0 { ahi.x } else { alo.x }, y: meet::middle(alo.y, ahi.y, blo.y, bhi.y) };
        Contact::new(Axis::new(sign_x, 0), x as i64, core).with_degenerate(tie_x || x == y)
    } else {
        let core = Raw { x: meet::middle(alo.x, ahi.x, blo.x, bhi.x), y: if sign_y > 0 { ahi.y } else { alo.y } };
        Contact::new(Axis::new(0, sign_y), y as i64, core).with_degenerate(tie_y)
    }
}

impl Contacts<Circle> for Circle {
    #[inline]
    fn contact(&self, b: &Circle) -> Option<Contact> {
        let v = b.c().sub(self.c());
        let r = self.r().wrapping_add(b.r());
        // Equal centres: the contact is radial, has length zero, and points along +x, whichever
        // shape is A.
        circle_circle::<false>(self.c(), b.c(), r)
            .then(|| Contact::radial(self.c(), v).with_radii(self.r(), b.r()).with_degenerate(v.is_zero()))
    }
}

impl Contacts<Aabb> for Circle {
    #[inline]
    fn contact(&self, b: &Aabb) -> Option<Contact> {
        circle_aabb(self.c(), self.r(), b.lo(), b.hi(), 1)
    }
}

impl Contacts<Circle> for Aabb {
    #[inline]
    fn contact(&self, b: &Circle) -> Option<Contact> {
        circle_aabb(b.c(), b.r(), self.lo(), self.hi(), -1).map(Contact::flipped)
    }
}

impl Contacts<Segment> for Circle {
    // If a caller keeps only some answers, most of the contact is not computed.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline)]
    fn contact(&self, b: &Segment) -> Option<Contact> {
        circle_segment(self.c(), self.r(), b.ra(), b.rb(), 1)
    }
}

impl Contacts<Circle> for Segment {
    #[inline]
    fn contact(&self, b: &Circle) -> Option<Contact> {
        circle_segment(b.c(), b.r(), self.ra(), self.rb(), -1).map(Contact::flipped)
    }
}

/// Outside of the box the nearest point of it decides, inside (or on it) the nearest face.
#[cfg_attr(target_pointer_width = "64", inline(always))]
fn circle_aabb(c: Raw, r: i32, lo: Raw, hi: Raw, prefer: i32) -> Option<Contact> {
    let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
    if gx >= r || gy >= r {
        return None;
    }
    if gx <= 0 && gy <= 0 {
        return Some(least_exit(c, c, lo, hi, prefer).with_radii(r, 0));
    }
    outside(c, r, lo, hi).map(|contact| contact.with_radii(r, 0))
}

/// A circle whose centre is not in the closed box.
#[cfg_attr(target_pointer_width = "64", inline(always))]
fn outside(c: Raw, r: i32, lo: Raw, hi: Raw) -> Option<Contact> {
    // Clamping gives the nearest point. Beside a face the difference has one zero component: a unit
    // axis.
    let near = clamp(c, lo, hi);
    circle_circle::<false>(c, near, r).then(|| Contact::radial(c, near.sub(c)))
}

/// The nearest end, or the perpendicular.
#[cfg_attr(target_pointer_width = "64", inline(always))]
fn circle_segment(c: Raw, r: i32, a: Raw, b: Raw, prefer: i32) -> Option<Contact> {
    if LONG {
        return by_region(c, r, a, b, prefer);
    }
    let (lo, hi) = corners(a, b);
    let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
    if gx >= r || gy >= r {
        return None;
    }
    let inside = gx <= 0 && gy <= 0;
    if lo.x == hi.x || lo.y == hi.y {
        let contact = if inside { on_segment(c, b.sub(a), prefer) } else { outside(c, r, lo, hi)? };
        return Some(contact.with_radii(r, 0));
    }
    let contact = match region::<false>(c, a, b, inside) {
        Region::End(p) => {
            if !circle_circle::<false>(c, p, r) {
                return None;
            }
            Contact::radial(c, p.sub(c))
        }
        Region::Line { cross: 0, .. } if r > 0 => on_segment(c, b.sub(a), prefer),
        Region::Line { cross, len2 } => {
            if !meet::near_line::<false>(cross, r, len2) {
                return None;
            }
            beside(c, b.sub(a), cross)
        }
    };
    Some(contact.with_radii(r, 0))
}

/// The contact without a test of the bounding box, as in [`meet::circle_segment`], and relative to
/// the first end, which takes the fewest registers.
#[inline(always)]
fn by_region(c: Raw, r: i32, a: Raw, b: Raw, prefer: i32) -> Option<Contact> {
    let (e, m) = (Offset::between(a, b), Offset::between(a, c));
    let (dot, len2) = (e.dot(m), e.dot(e));
    let contact = if dot > 0 && dot < len2 {
        let cross = e.cross(m);
        if !meet::near_line::<false>(cross, r, len2 as u64) {
            return None;
        }
        let (e, m) = (e.raw(), m.raw());
        if cross == 0 {
            on_segment(c, e, prefer)
        } else if e.x == 0 {
            Contact::radial(c, Raw { x: m.x.wrapping_neg(), y: 0 })
        } else if e.y == 0 {
            Contact::radial(c, Raw { x: 0, y: m.y.wrapping_neg() })
        } else {
            beside(c, e, cross)
        }
    } else {
        let from = if dot <= 0 { m } else { m.sub(e) };
        let square = from.dot(from) as u64;
        if square >= usqr(r as u32) {
            return None;
        }
        if square == 0 { on_segment(c, e.raw(), prefer) } else { Contact::radial(c, from.raw().reversed()) }
    };
    Some(contact.with_radii(r, 0))
}

/// A circle beside the edge `e`, at this cross product with it. If that is positive, the circle is
/// on the side of the normal (-e.y, e.x), so the segment is in the opposite direction.
#[inline(always)]
fn beside(c: Raw, e: Raw, cross: i64) -> Contact {
    let left = Axis::new(e.y.wrapping_neg(), e.x);
    let axis = if cross > 0 { left.reversed() } else { left };
    Contact::new(axis, (cross.unsigned_abs() as i64).wrapping_neg(), c)
}

/// A circle whose centre is on the segment with this edge: both sides are equally near.
#[inline]
fn on_segment(c: Raw, e: Raw, prefer: i32) -> Contact {
    Contact::new(across(e, prefer), 0, c).with_degenerate(true)
}

/// The normal of a segment by its ends, or the other one where `prefer` is negative.
#[cold]
#[inline(never)]
fn across(e: Raw, prefer: i32) -> Axis {
    let turned = e.x < 0 || (e.x == 0 && e.y < 0);
    let normal = parallel_to_unit(Raw { x: e.y.wrapping_neg(), y: e.x });
    if turned == (prefer < 0) { normal } else { normal.reversed() }
}

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

/// The ends in lexicographic order: reversing a segment changes nothing.
const fn ordered(a: Raw, b: Raw) -> (Raw, Raw) {
    if b.x < a.x || (b.x == a.x && b.y < a.y) { (b, a) } else { (a, b) }
}

/// A is the box.
fn aabb_segment(lo: Raw, hi: Raw, a: Raw, b: Raw, prefer: i32) -> Option<Contact> {
    if !meet::segment_aabb::<false>(a, b, lo, hi) {
        return None;
    }
    let (a, b) = ordered(a, b);
    let (slo, shi) = corners(a, b);
    let flat = least_exit(lo, hi, slo, shi, prefer);
    let e = b.sub(a);
    if e.x == 0 || e.y == 0 {
        return Some(flat);
    }
    // Along x or y, a sloped segment is deepest at an end. It is the end with the smaller
    // coordinate if B is left along +.
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
struct SegmentExit {
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

/// The exit of segment `p q` over the line of `a b`, which it crosses properly; `axis` points from
/// `a b` to `p q`.
///
/// `prefer` is the side to take in a tie.
fn over(a: Raw, b: Raw, p: Raw, q: Raw, prefer: i32) -> SegmentExit {
    let (a, b) = ordered(a, b);
    let e = parallel_to_unit(b.sub(a));
    let normal = e.perp();
    let side = |v: Raw| Raw { x: e.x, y: e.y }.cross(v.sub(a));
    let (p, q) = if side(p) < 0 { (p, q) } else { (q, p) };
    // p is behind by `back`, q in front by `front`: moving `a b` against the normal leaves p, along
    // it leaves q.
    let (back, front) = (side(p).wrapping_neg(), side(q));
    let tie = back == front;
    if back < front || (tie && prefer > 0) {
        SegmentExit { axis: normal, s: back, end: p, tie, normal }
    } else {
        SegmentExit { axis: normal.reversed(), s: front, end: q, tie, normal }
    }
}

fn segment_segment(a0: Raw, a1: Raw, b0: Raw, b1: Raw) -> Option<Contact> {
    if !meet::segment_segment::<false>(a0, a1, b0, b1) {
        return None;
    }
    // The second exit is seen with the roles exchanged: its axis is reversed below.
    let (of_b, of_a) = (over(a0, a1, b0, b1, 1), over(b0, b1, a0, a1, -1));
    let square = |exit: &SegmentExit| Square { num: sqr64(exit.s as u64), den: exit.axis.length_squared() };
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
