//! The answers of a contact, rounded on request, and how each pair of shapes makes one.

use super::{Contact, Contacts, parallel_to_unit};
use crate::num::{
    Axis, Fx, InverseRoot, LONG, Raw, UnitVec2, Vec2, div_sqrt, isqrt64, less128, mul64, scaled, sqr64, umul, unit_by,
    unit_ceil, usqr,
};
use crate::query::closest::Square;
use crate::query::meet;
use crate::query::meet::{Region, circle_circle, clamp, corners, cross_range, gap, region};
use crate::shape::{Aabb, Circle, Segment};

impl Contact {
    /// How far A must be moved against the axis to end the overlap: the exact depth rounded up, at
    /// least one raw unit.
    ///
    /// Cost on a Cortex-M0: a few instructions for boxes, a square root for circles (300), a
    /// quotient by one beside sloped segments (700).
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Circle, Fx, Vec2};
    /// let a = Circle::new(Vec2::from_ints(0, 0), Fx::from_bits(3))?;
    /// let b = Circle::new(Vec2::from_raw(2, 2), Fx::from_bits(1))?;
    /// assert_eq!(a.contact(&b).unwrap().depth().to_bits(), 2); // 4 - sqrt(8) = 1.17 raw
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[cfg_attr(target_pointer_width = "64", inline)]
    #[must_use]
    #[doc(alias = "penetration")]
    pub const fn depth(&self) -> Fx {
        Fx::from_bits(self.depth_raw())
    }

    /// The [depth](Self::depth) and the [normal](Self::normal), for those who want both.
    ///
    /// The same bits as one by one. On 64-bit processors both come from one reciprocal root, which
    /// is faster.
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Circle, Vec2, fx};
    /// let a = Circle::new(Vec2::from_ints(0, 0), fx!(5))?;
    /// let contact = a.contact(&Circle::new(Vec2::from_ints(3, 4), fx!(2))?).unwrap();
    /// let (depth, normal) = contact.depth_and_normal();
    /// assert_eq!((depth, normal.scaled(depth)), (fx!(2), contact.normal().scaled(fx!(2))));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[must_use]
    pub const fn depth_and_normal(&self) -> (Fx, UnitVec2) {
        if !LONG {
            return (self.depth(), self.normal());
        }
        if self.is_parallel() {
            return (Fx::from_bits(self.depth_along()), UnitVec2::along(self.axis));
        }
        let (depth, normal) = if self.radial {
            let n = self.axis.length_squared();
            let inverse = InverseRoot::of(n);
            (self.radii().wrapping_sub(inverse.root(n) as i32), unit_by(self.axis, inverse))
        } else {
            sloped_exit(self.axis, self.overlap, self.radii())
        };
        (Fx::from_bits(depth), normal)
    }

    /// A displacement of A after which the two do not overlap: against the axis, each component
    /// rounded away from zero.
    ///
    /// Exact where the axis is parallel to x or y. Else a component is at most 4 raw units longer
    /// than the exact least exit needs, or 5 where the depth or the sum of radii is above 8192
    /// units. The result may lead out of the [domain](crate::num::DOMAIN); `translated` then
    /// returns an error.
    ///
    /// Cost on a Cortex-M0: 30 instructions along x and y, 310 for circles, 1050 beside sloped
    /// segments, where the depth is computed first.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2, fx, prelude::*};
    /// let unit = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 10, 10));
    /// let (a, b) = (unit(0)?, unit(7)?);
    /// let contact = a.contact(&b).expect("they overlap by 3");
    /// assert_eq!((contact.depth(), contact.push_out()), (fx!(3), Vec2::from_ints(-3, 0)));
    /// assert!(!a.translated(contact.push_out())?.overlaps(&b));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    #[doc(alias("MTV", "minimum translation vector", "separation"))]
    pub const fn push_out(&self) -> Vec2 {
        let Axis { x, y } = self.axis;
        if self.is_parallel() {
            let d = self.depth_raw();
            return Vec2::from_raw(x.wrapping_neg().wrapping_mul(d), y.wrapping_neg().wrapping_mul(d));
        }
        // Each component below is at least the exact one in size and has its sign. So with n the
        // axis, n.push is at least |n| times the depth: afterwards a line across n has A on one
        // side and B on the other, and convex shapes that a line separates do not overlap.
        let (ux, uy) = unit_ceil(self.axis);
        // Radial: the cores are `axis` apart and have to be radii / |axis| times as far. The
        // difference of the two has the right sign.
        let (length, from) =
            if self.radial { (self.radii(), Raw { x, y }) } else { (self.depth_raw(), Raw { x: 0, y: 0 }) };
        let (px, py) = (times_unit_up(ux, length), times_unit_up(uy, length));
        Vec2::from_raw(
            from.x.wrapping_add(if x > 0 { px.wrapping_neg() } else { px }),
            from.y.wrapping_add(if y > 0 { py.wrapping_neg() } else { py }),
        )
    }

    /// The point of A that lies deepest in B, within 2 raw units per component.
    ///
    /// If a whole side of a box is equally deep: the middle of the part that faces B. Cost: at most
    /// a unit vector and two long divisions, some thousand instructions on a Cortex-M0. For boxes
    /// it is exact and takes a few instructions.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2, prelude::*};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let contact = at(0)?.contact(&at(6)?).unwrap();
    /// assert_eq!(contact.point_on_a(), Vec2::from_ints(8, 4));
    /// assert_eq!(contact.point_on_b(), Vec2::from_ints(6, 4));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn point_on_a(&self) -> Vec2 {
        let core = if self.core_on_b { self.core.add(self.between_cores()) } else { self.core };
        core.add(self.along(self.radius_a)).vec2()
    }

    /// The point of B that lies deepest in A; as [`point_on_a`](Self::point_on_a).
    #[must_use]
    pub const fn point_on_b(&self) -> Vec2 {
        let core = if self.core_on_b { self.core } else { self.core.sub(self.between_cores()) };
        core.sub(self.along(self.radius_b)).vec2()
    }

    /// Parallel to x or y; such an axis has length one.
    const fn is_parallel(&self) -> bool {
        self.axis.x == 0 || self.axis.y == 0
    }

    const fn radii(&self) -> i32 {
        self.radius_a.wrapping_add(self.radius_b)
    }

    /// `ceil(radii + overlap / |axis|)`.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    const fn depth_raw(&self) -> i32 {
        if self.is_parallel() {
            self.depth_along()
        } else {
            sloped_depth(self.axis, self.overlap, self.radii(), self.radial)
        }
    }

    /// Along x or y.
    #[inline(always)]
    const fn depth_along(&self) -> i32 {
        self.radii().wrapping_add(self.overlap as i32)
    }

    /// The deepest point of A's core minus that of B's: `axis * overlap / axis^2`, to nearest.
    const fn between_cores(&self) -> Raw {
        let Axis { x, y } = self.axis;
        if self.is_parallel() {
            let s = self.overlap as i32;
            return Raw { x: x.wrapping_mul(s), y: y.wrapping_mul(s) };
        }
        if self.radial {
            return Raw { x: x.wrapping_neg(), y: y.wrapping_neg() };
        }
        let n = self.axis.length_squared();
        Raw { x: scaled(x, self.overlap, n), y: scaled(y, self.overlap, n) }
    }

    /// The unit vector times a radius, to nearest.
    const fn along(&self, radius: i32) -> Raw {
        if radius == 0 {
            return Raw { x: 0, y: 0 };
        }
        let (x, y) = self.normal().raw();
        Raw { x: times_unit(x, radius), y: times_unit(y, radius) }
    }
}

/// [`Contact::depth`] where the axis is parallel to neither x nor y, by values: a contact that is
/// only asked stays in registers. On 64-bit processors a call.
#[cfg_attr(target_pointer_width = "64", inline(never))]
#[cfg_attr(not(target_pointer_width = "64"), inline(always))]
const fn sloped_depth(axis: Axis, overlap: i64, radii: i32, radial: bool) -> i32 {
    let n = axis.length_squared();
    // R - floor(x) = ceil(R - x).
    if radial {
        return radii.wrapping_sub(isqrt64(n) as i32);
    }
    ceil(radii, overlap, n, div_sqrt(overlap.unsigned_abs(), n))
}

/// The same, not radial, and the unit vector.
#[inline(never)]
const fn sloped_exit(axis: Axis, overlap: i64, radii: i32) -> (i32, UnitVec2) {
    let n = axis.length_squared();
    let inverse = InverseRoot::of(n);
    (ceil(radii, overlap, n, inverse.times(overlap.unsigned_abs(), n)), unit_by(axis, inverse))
}

/// `ceil(radii + overlap / sqrt(n))`, by the floor of the size of that quotient.
#[inline(always)]
const fn ceil(radii: i32, overlap: i64, n: u64, floor: u32) -> i32 {
    if overlap < 0 {
        return radii.wrapping_sub(floor as i32);
    }
    let exact = !less128(mul64(usqr(floor), n), sqr64(overlap as u64));
    radii.wrapping_add(floor as i32).wrapping_add(!exact as i32)
}

/// A magnitude in Q30 times a length below 2^30, rounded up, one unit more where it is whole.
///
/// Depths are below 2^30 as well: the normal of a segment is the axis only where it gives less
/// than x and y do.
const fn times_unit_up(unit: u32, length: i32) -> i32 {
    ((umul(unit, (length as u32) << 2) >> 32) as i32).wrapping_add(1)
}

/// A component in Q30 times a length that is not negative, to nearest, halves away from zero.
const fn times_unit(unit: i32, length: i32) -> i32 {
    let product = (umul(unit.unsigned_abs(), length as u32).wrapping_add(1 << 29) >> 30) as i32;
    if unit < 0 { product.wrapping_neg() } else { product }
}

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
    // Where only what is asked of it is kept, most of it is not computed.
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
    let mut inside = false;
    if !LONG {
        let (lo, hi) = corners(a, b);
        let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
        if gx >= r || gy >= r {
            return None;
        }
        inside = gx <= 0 && gy <= 0;
        if lo.x == hi.x || lo.y == hi.y {
            let contact = if inside { on_segment(c, a, b, prefer) } else { outside(c, r, lo, hi)? };
            return Some(contact.with_radii(r, 0));
        }
    }
    let e = b.sub(a);
    let contact = match region::<false>(c, a, b, inside) {
        Region::End(p) => {
            if !circle_circle::<false>(c, p, r) {
                return None;
            }
            let v = p.sub(c);
            // Without a look at the box, the centre may be at this end.
            if LONG && v.is_zero() { on_segment(c, a, b, prefer) } else { Contact::radial(c, v) }
        }
        Region::Line { cross: 0, .. } if r > 0 => on_segment(c, a, b, prefer),
        Region::Line { cross, len2 } => {
            if !meet::near_line::<false>(cross, r, len2) {
                return None;
            }
            if LONG && e.x == 0 {
                Contact::radial(c, Raw { x: a.x.wrapping_sub(c.x), y: 0 })
            } else if LONG && e.y == 0 {
                Contact::radial(c, Raw { x: 0, y: a.y.wrapping_sub(c.y) })
            } else {
                // A positive cross product is on the side of the normal (-e.y, e.x): the segment
                // lies against it.
                let left = Axis::new(e.y.wrapping_neg(), e.x);
                let axis = if cross > 0 { left.reversed() } else { left };
                Contact::new(axis, (cross.unsigned_abs() as i64).wrapping_neg(), c)
            }
        }
    };
    Some(contact.with_radii(r, 0))
}

/// A circle whose centre is on the segment: both sides are as near.
fn on_segment(c: Raw, a: Raw, b: Raw, prefer: i32) -> Contact {
    let e = ordered_edge(a, b);
    let normal = parallel_to_unit(Raw { x: e.y.wrapping_neg(), y: e.x });
    Contact::new(if prefer < 0 { normal.reversed() } else { normal }, 0, c).with_degenerate(true)
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

/// The exit of segment `p q` over the line of `a b`, which it crosses properly; `axis` points from
/// `a b` to `p q`.
///
/// `prefer` is the side to take in a tie.
fn over(a: Raw, b: Raw, p: Raw, q: Raw, prefer: i32) -> Exit {
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
