//! Which ends of a face block by themselves, among those that have no vertex.

use super::{Kind, SegmentMap};
use crate::num::{Axis, Raw};

/// A direction from a point in which segments run, less than half a turn from another one.
#[derive(Clone, Copy)]
struct Ray {
    dir: Axis,
    /// Whether what comes after it, on the way around, is solid by one of them.
    after: bool,
    /// Whether what comes before it is.
    before: bool,
}

impl SegmentMap<'_> {
    /// Whether the solid goes on from the end `p` of a face so that `p` blocks what is in front: `along` leads from `p` along the face, and
    /// `left` says on which side of that the front is.
    ///
    /// It does where the surface goes on straight, or turns toward the front and is solid as far as beyond `p`. It does not where the face meets
    /// a wall or a spike from below, or the surface of a solid that it is in: a body above comes as far as `p`.
    ///
    /// ```text
    ///      |####        ####|####         box                 f: the face, its front is on the right
    ///      |####        ####|####        -----P========  wall
    ///      P----- yes   ----P----  no         |          or spike: no
    ///      f                f                 f
    /// ```
    ///
    /// Cost: the segments of a cell, three products for each one through `p`.
    pub(super) fn end_blocks(&self, p: Raw, along: Axis, left: bool) -> bool {
        let turn = |from: Axis, to: Axis| if left { from.perp_dot(to) } else { to.perp_dot(from) };
        let (mut last, mut straight): (Option<Ray>, bool) = (None, false);
        for seg in self.around(p) {
            if seg.kind == Kind::OneWay || !seg.holds(p) {
                continue;
            }
            for (there, dir, leaves) in [(seg.b() != p, seg.dir, true), (seg.a != p, seg.dir.reversed(), false)] {
                // The solid is on the left of what leaves, so it is after it on the way to the left.
                let ray = Ray { dir, after: leaves == left, before: leaves != left };
                let ahead = turn(along, dir);
                if there && ahead > 0 {
                    last = Some(match last {
                        Some(last) if last.dir == dir => {
                            Ray { dir, after: last.after || ray.after, before: last.before || ray.before }
                        }
                        Some(last) if turn(last.dir, dir) < 0 => last,
                        _ => ray,
                    });
                }
                straight |= there && ahead == 0 && dir != along && ray.after;
            }
        }
        straight || last.is_some_and(|last| last.after && !last.before)
    }
}
