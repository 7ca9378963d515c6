//! Contacts of boxes: the least of four exits.

use super::{Contact, Contacts};
use crate::num::{Axis, Raw};
use crate::query::meet;
use crate::shape::Aabb;

impl Contacts<Aabb> for Aabb {
    #[inline]
    fn contact(&self, b: &Aabb) -> Option<Contact> {
        let (alo, ahi, blo, bhi) = (self.lo(), self.hi(), b.lo(), b.hi());
        meet::aabb_aabb::<false>(alo, ahi, blo, bhi).then(|| least_exit(alo, ahi, blo, bhi, 1))
    }
}

/// The least exit along one axis: its length, its sign, and whether both directions are as short.
///
/// `prefer` is the sign to take in a tie: -1 where the caller will exchange A and B, so that the final axis is the positive one.
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
