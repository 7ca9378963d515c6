//! Which part of a segment is nearest to a point.

use crate::num::{Raw, SPLIT};

/// The nearest part of a segment, seen from a point.
#[derive(Clone, Copy)]
pub(crate) enum Region {
    /// This end; equal ends have no other region.
    End(Raw),
    /// A point between the ends.
    Line {
        /// The cross product of the edge with the vector from its first end to the point: distance times length, positive on the left (y up).
        cross: i64,
        /// The square of the edge's length, not zero.
        len2: u64,
    },
}

/// The region of `p` before the segment from `a` to `b`, which is not a point where `inside` is set.
///
/// `FAR` allows any `p`; otherwise it must be inside the domain. The products with `p` itself are below 2^62, those with `a` below
/// 2^60, so the difference is exact in 64 bits even where `p - a` needs 33.
///
/// `inside` says that `p` is known to be in the segment's bounding box. Then both products of the dot product have the sign of a square, and
/// none exceeds that square: the foot is between the ends, at most at one of them.
#[inline]
pub(crate) const fn region<const FAR: bool>(p: Raw, a: Raw, b: Raw, inside: bool) -> Region {
    let e = b.sub(a);
    // Where a signed product is as cheap as an unsigned one, magnitudes are not needed.
    let len2 = if SPLIT { e.len2() } else { e.dot(e) as u64 };
    if !inside {
        let dot = if FAR { e.dot(p).wrapping_sub(e.dot(a)) } else { e.dot(p.sub(a)) };
        if dot <= 0 {
            return Region::End(a);
        }
        if dot as u64 >= len2 {
            return Region::End(b);
        }
    }
    let cross = if FAR { e.cross(p).wrapping_sub(e.cross(a)) } else { e.cross(p.sub(a)) };
    Region::Line { cross, len2 }
}
