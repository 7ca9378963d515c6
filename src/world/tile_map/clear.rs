//! Which tiles a body is clear of wherever it is in a region: one half-plane or one disc per tile,
//! in words alone.

use super::outline::FormKind;
use crate::num::{Raw, leading_zeros32};
use crate::world::tile_map::kind::TileShape;

/// Farther from a tile's corner than this there is no answer: all sums below fit a word.
const FAR: i32 = 1 << 27;

/// Whether no body in a region has a point in the inside of a tile's solid. A body is a disc of
/// radius `r`, or fills its bounds.
///
/// It may be false although no body has such a point. It is true only if none has. The inside of
/// the region meets that of the tile's square.
///
/// In the frame of the solid corner (see [`Form`](super::outline::Form)) `u` and `v` are the
/// region's least coordinates. Bounds with their nearest corner there are nearer to the solid than
/// all others in the region. A disc leaves that corner of its bounds free, and is farther from a
/// line than the corner by r (p + q - |(p, q)|).
#[inline(never)]
pub(super) const fn is_clear(shape: TileShape, (at, end): (Raw, Raw), (lo, hi): (Raw, Raw), r: i32) -> bool {
    let (form, side) = (shape.form(), end.x - at.x);
    let u = if form.right { end.x.wrapping_sub(hi.x) } else { lo.x.wrapping_sub(at.x) };
    let v = if form.bottom { end.y.wrapping_sub(hi.y) } else { lo.y.wrapping_sub(at.y) };
    if u < -FAR || v < -FAR {
        return false;
    }
    match form.kind {
        FormKind::Empty | FormKind::Full => false,
        FormKind::Line { p, q, k } => {
            let (p, q, edge) = (p as i32, q as i32, k as i32 * (side >> 1));
            // The line's ends are on the axes: no point of the solid is beyond them.
            p * u >= edge || q * v >= edge || p * u + q * v + spared(r, p, q) >= edge
        }
        FormKind::Convex => is_beyond(positive(u + r), positive(v + r), side + r),
        FormKind::Concave => r < side && is_within(positive(side - u - r), positive(side - v - r), side - r),
    }
}

const fn positive(v: i32) -> i32 {
    if v < 0 { 0 } else { v }
}

/// At most `r (p + q - sqrt(p p + q q))`, for r below 2^28.
///
/// 2 - sqrt 2 > 1/2 + 1/16 + 1/64 + 1/128 - 1/4096, and 3 - sqrt 5 > 3/4 + 1/64 - 1/512; what is
/// subtracted is rounded up.
const fn spared(r: i32, p: i32, q: i32) -> i32 {
    match p + q {
        _ if r == 0 => 0,
        2 => (r >> 1) + (r >> 4) + (r >> 6) + (r >> 7) - (r >> 12) - 1,
        3 => (r >> 1) + (r >> 2) + (r >> 6) - (r >> 9) - 1,
        _ => 0,
    }
}

/// Whether a point is at least `reach` from the origin; it may say no within one part in 2^14 of
/// that.
const fn is_beyond(x: i32, y: i32, reach: i32) -> bool {
    if x >= reach || y >= reach {
        return true;
    }
    let shift = shift(reach);
    let (x, y, reach) = ((x >> shift) as u32, (y >> shift) as u32, (reach >> shift) as u32 + 1);
    x * x + y * y >= reach * reach
}

/// Whether a point is at most `reach` from the origin; it may say no within one part in 2^14 of
/// that.
const fn is_within(x: i32, y: i32, reach: i32) -> bool {
    if x >= reach || y >= reach {
        return false;
    }
    let shift = shift(reach);
    let (x, y, reach) = ((x >> shift) as u32 + 1, (y >> shift) as u32 + 1, (reach >> shift) as u32);
    x * x + y * y <= reach * reach
}

/// The part of a length that fits 15 bits: squares of two such numbers, one of them a unit larger,
/// add up below 2^32.
const fn shift(reach: i32) -> u32 {
    17u32.saturating_sub(leading_zeros32(reach as u32))
}
