//! Contacts of circles. A is the circle throughout, its core is its centre.

use super::{Contact, Contacts, boxes, parallel_to_unit, segments};
use crate::num::{Axis, Raw, less128, mul64, sqr64, usqr};
use crate::query::meet::{circle_circle, clamp, corners, gap};
use crate::query::region::{Region, region};
use crate::shape::{Aabb, Circle, Segment};

impl Contacts<Circle> for Circle {
    #[inline]
    fn contact(&self, b: &Circle) -> Option<Contact> {
        let v = b.c().sub(self.c());
        let r = self.r().wrapping_add(b.r());
        // Equal centres: a radial contact of length zero along +x, whichever is A.
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
    #[inline]
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
fn circle_aabb(c: Raw, r: i32, lo: Raw, hi: Raw, prefer: i32) -> Option<Contact> {
    let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
    if gx >= r || gy >= r {
        return None;
    }
    if gx <= 0 && gy <= 0 {
        return Some(boxes::least_exit(c, c, lo, hi, prefer).with_radii(r, 0));
    }
    outside(c, r, lo, hi).map(|contact| contact.with_radii(r, 0))
}

/// A circle whose centre is not in the closed box.
fn outside(c: Raw, r: i32, lo: Raw, hi: Raw) -> Option<Contact> {
    // Clamping gives the nearest point. Beside a face the difference has one zero component: a unit axis.
    let near = clamp(c, lo, hi);
    circle_circle::<false>(c, near, r).then(|| Contact::radial(c, near.sub(c)))
}

/// The nearest end, or the perpendicular.
fn circle_segment(c: Raw, r: i32, a: Raw, b: Raw, prefer: i32) -> Option<Contact> {
    let (lo, hi) = corners(a, b);
    let (gx, gy) = (gap(c.x, lo.x, hi.x), gap(c.y, lo.y, hi.y));
    if gx >= r || gy >= r {
        return None;
    }
    let contact = if lo.x == hi.x || lo.y == hi.y {
        if gx <= 0 && gy <= 0 { on_segment(c, a, b, prefer) } else { outside(c, r, lo, hi)? }
    } else {
        match region::<false>(c, a, b, gx <= 0 && gy <= 0) {
            Region::End(p) => circle_circle::<false>(c, p, r).then(|| Contact::radial(c, p.sub(c)))?,
            Region::Line { cross: 0, .. } if r > 0 => on_segment(c, a, b, prefer),
            Region::Line { cross, len2 } => {
                if !less128(sqr64(cross.unsigned_abs()), mul64(usqr(r as u32), len2)) {
                    return None;
                }
                // A positive cross product is on the side of the normal (-e.y, e.x): the segment lies against it.
                let e = b.sub(a);
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
    let e = segments::ordered_edge(a, b);
    let normal = parallel_to_unit(Raw { x: e.y.wrapping_neg(), y: e.x });
    Contact::new(if prefer < 0 { normal.reversed() } else { normal }, 0, c).with_degenerate(true)
}
