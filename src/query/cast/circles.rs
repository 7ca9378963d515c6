//! A moving circle against a circle.

use super::crossing::{Crossing, enters};
use super::kernel::{Course, Moment};
use crate::num::{Axis, Raw, SPLIT, Toi, usqr};
use crate::query::meet::circle_circle;

/// A disc around the origin that a point comes into.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    m: Raw,
    crossing: Crossing,
}

/// The disc of radius `r` around `b`, as the point `a` that moves by `d` comes into it.
#[inline]
pub(super) fn enter_disc(a: Raw, b: Raw, r: i32, d: Raw) -> Course<Disc> {
    if is_inside(a, b, r) { Course::Inside } else { Course::of(meet_disc(a.sub(b), r, d)) }
}

/// The same without a time.
#[inline]
pub(super) fn hit_disc(a: Raw, b: Raw, r: i32, d: Raw) -> Course<()> {
    if is_inside(a, b, r) { Course::Inside } else { Course::of(enters(a.sub(b), r, d).then_some(())) }
}

/// Where a product is cheap, so are the squares.
#[inline]
fn is_inside(a: Raw, b: Raw, r: i32) -> bool {
    let m = a.sub(b);
    if SPLIT { circle_circle::<false>(a, b, r) } else { (m.dot(m) as u64) < usqr(r as u32) }
}

/// The same for a start outside, seen from the disc's centre.
#[inline]
pub(super) fn meet_disc(m: Raw, r: i32, d: Raw) -> Option<Disc> {
    Crossing::of(m, r, d).map(|crossing| Disc { m, crossing })
}

impl Moment for Disc {
    fn exact_toi(&self, d: Raw) -> Toi {
        self.crossing.exact_toi(self.m, d)
    }

    #[inline]
    fn contact(&self, d: Raw) -> (Toi, Raw, Axis) {
        self.crossing.contact(self.m, d)
    }
}
