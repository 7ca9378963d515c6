//! Whether a shape holds another one.

use super::place::meets;
use super::walk::Core;
use crate::num::{Raw, Vec2, less128, mul64, sqr64, usqr};

/// Whether every point of B is one of A; closed and exact.
///
/// A shape is where its extent in every direction reaches, so A grown by r holds B grown by s where
/// A grown by r - s holds B, or, if that is negative, where A has room for a disc of s - r around
/// every corner of B.
pub(super) fn contains(a: Core<'_>, b: Core<'_>) -> bool {
    let rest = a.radius.wrapping_sub(b.radius);
    b.corners
        .iter()
        .all(|p| if rest < 0 { holds_disc(a, Raw::of(*p), rest.unsigned_abs()) } else { holds(a, *p, rest) })
}

/// Whether the core of A, grown by a radius, holds a point of the domain.
pub(super) fn holds(a: Core<'_>, p: Vec2, radius: i32) -> bool {
    meets::<true>(Core { radius, ..a }, Core { corners: &[p], radius: 0 })
}

/// Whether the disc is on the left of all sides. What has no area holds none.
fn holds_disc(a: Core<'_>, p: Raw, radius: u32) -> bool {
    let clear = |(i, from): (usize, &Vec2)| {
        let from = Raw::of(*from);
        let e = a.corner(a.after(i)).sub(from);
        // Heights below 2^61, square lengths below 2^61 and radii below 2^29.
        let height = e.cross(p.sub(from));
        height >= 0 && !less128(sqr64(height.unsigned_abs()), mul64(usqr(radius), e.len2()))
    };
    a.corners.len() > 2 && a.corners.iter().enumerate().all(clear)
}
