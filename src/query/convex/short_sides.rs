//! Whether two polygons overlap, by the leading bits of their corners.
//!
//! This is for cores on which a long product is a call. With products of words, it tests each side
//! against a point between the polygons, then against the corners of the other polygon. Most
//! polygons that overlap have that point in common, which takes half of the instructions of sides
//! and corners. Few pairs need a walk around the sum.

use super::margins::{shift_to, short, short_cross, spread};
use super::walk::Core;
use crate::num::{Raw, Vec2};
use core::mem::replace;

/// The most corners of a polygon with short sides.
const CORNERS: usize = 8;

/// A component loses less than one, both in a corner and in a side. All components of a side and of
/// a difference of corners are below 2^14. Their product is off by less than the sum of the four,
/// and two.
const OFF: i32 = (1 << 16) + 2;

/// The corners of a polygon, relative to a near point, with 13 bits and a sign.
struct ShortPolygon<const N: usize> {
    corners: [Raw; N],
    count: usize,
}

impl<const N: usize> ShortPolygon<N> {
    /// The corners, not yet short.
    #[inline(always)]
    fn of(corners: &[Vec2], at: Raw, bits: &mut u32) -> Self {
        let mut seen = [Raw::ZERO; N];
        for (seen, p) in seen.iter_mut().zip(corners) {
            *seen = Raw::of(*p).sub(at);
            *bits |= spread(*seen);
        }
        Self { corners: seen, count: corners.len() }
    }

    #[inline(always)]
    fn shorten(&mut self, shift: u32) {
        for p in self.corners.iter_mut().take(self.count) {
            *p = short(*p, shift);
        }
    }

    #[inline(always)]
    fn corners(&self) -> &[Raw] {
        self.corners.get(..self.count).unwrap_or(&[])
    }

    #[inline(always)]
    fn last(&self) -> Raw {
        self.corners().last().copied().unwrap_or(Raw::ZERO)
    }

    /// Whether the near point is surely inside. It is zero, and loses nothing: twice the area of a
    /// triangle with a side is off by less than that side's components and two.
    #[inline(always)]
    fn is_around(&self) -> bool {
        let mut from = self.last();
        self.corners().iter().all(|to| short_cross(replace(&mut from, *to), *to) > OFF)
    }
}

/// Whether some corner of the other polygon is surely inside of each side, or all are surely
/// outside of one.
fn is_reached_by(of: &[Raw], other: &[Raw]) -> Option<bool> {
    let mut surely = Some(true);
    let mut from = of.last().copied().unwrap_or(Raw::ZERO);
    for to in of {
        let edge = to.sub(from);
        let line = short_cross(edge, replace(&mut from, *to));
        let reach = |p: &Raw| short_cross(edge, *p).wrapping_sub(line);
        if !other.iter().any(|p| reach(p) > OFF) {
            if other.iter().all(|p| reach(p) < -OFF) {
                return Some(false);
            }
            surely = None;
        }
    }
    surely
}

/// [`shortly`], with arrays of this length.
#[inline(always)]
fn plainly<const N: usize>(a: &[Vec2], b: &[Vec2]) -> Option<bool> {
    let middle = |of: &[Vec2]| {
        let corner = |i: usize| of.get(i).map_or(Raw::ZERO, |p| Raw::of(*p));
        corner(0).add(corner(of.len() >> 1))
    };
    // The sums of four components are below 2^31.
    let at = short(middle(a).add(middle(b)), 2);
    let mut bits = 0;
    let (mut a, mut b) = (ShortPolygon::<N>::of(a, at, &mut bits), ShortPolygon::<N>::of(b, at, &mut bits));
    let shift = shift_to(13, bits);
    a.shorten(shift);
    b.shorten(shift);
    if a.is_around() && b.is_around() {
        return Some(true);
    }
    let (a, b) = (a.corners(), b.corners());
    match is_reached_by(a, b) {
        Some(true) => is_reached_by(b, a),
        Some(false) => Some(false),
        None => (is_reached_by(b, a) == Some(false)).then_some(false),
    }
}

/// Whether two polygons overlap, and also touch; `None` if the leading bits do not decide.
#[inline(never)]
pub(super) fn shortly(a: Core<'_>, b: Core<'_>) -> Option<bool> {
    let (n, m) = (a.corners.len(), b.corners.len());
    if n < 3 || m < 3 || n > CORNERS || m > CORNERS {
        return None;
    }
    // A copy for quads takes a quarter less.
    if let (Ok(p), Ok(q)) = (<&[Vec2; 4]>::try_from(a.corners), <&[Vec2; 4]>::try_from(b.corners)) {
        return plainly::<4>(p, q);
    }
    plainly::<CORNERS>(a.corners, b.corners)
}
