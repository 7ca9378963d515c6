//! What a body stands on.

use crate::motion::body::Body;
use crate::motion::facing::Side;
use crate::motion::response::Law;
use crate::motion::{Mover, walk::CONTACT};
use crate::num::{Axis, Raw, usqr};
use crate::query::meet;
use crate::world::Solid;

/// A solid under a body.
#[derive(Clone, Copy)]
pub(super) struct Carrier {
    pub(super) key: u16,
    /// Its motion with the conveyor's.
    pub(super) carry: Raw,
    /// How far it rises in this tick, scaled by the length of "up".
    rise: i64,
}

impl Carrier {
    /// Of several the one that rises most (it lifts the body off the others), then the smaller key, then geometry: the order of the list plays no
    /// part.
    fn goes_before(&self, other: &Self) -> bool {
        let key = |c: &Self| (c.rise, u16::MAX - c.key, c.carry.x, c.carry.y);
        key(self) > key(other)
    }
}

impl<S: Law> Mover<S> {
    /// What carries a body: the solid whose floor it touches, unless that sinks away by more than `follow`.
    #[inline(never)]
    pub(super) fn carrier<B: Body>(&self, solids: &[Solid], body: &B, follow: i32) -> Option<Carrier> {
        let up = self.up?;
        // What is farther than a contact carries nothing.
        let (bounds, near) = (body.bounds(), Raw { x: CONTACT, y: CONTACT });
        let (lo, hi) = (bounds.lo().sub(near), bounds.hi().add(near));
        let mut best: Option<Carrier> = None;
        for solid in solids.iter().filter(|s| !(self.passes_one_way() && s.one_way().is_some())) {
            if !meet::aabb_aabb::<true>(lo, hi, solid.lo(), solid.hi()) {
                continue;
            }
            let motion = Raw::of(solid.motion());
            // Along an axis: below 2^28.
            let rises = |n: Axis| motion.x.wrapping_mul(n.x).wrapping_add(motion.y.wrapping_mul(n.y));
            let stands = SIDES.iter().any(|&(bit, n)| {
                solid.pieces() & bit != 0 && rises(n).wrapping_neg() <= follow && self.lies_on(solid, n, body)
            });
            if !stands {
                continue;
            }
            let carrier = Carrier {
                key: solid.key(),
                carry: motion.add(Raw::of(solid.conveyor())),
                rise: up.dot(Axis::new(motion.x, motion.y)),
            };
            if best.is_none_or(|b| carrier.goes_before(&b)) {
                best = Some(carrier);
            }
        }
        best
    }

    /// Whether a body touches that side of a solid, with the part of it that is floor.
    ///
    /// A face is touched exactly. A circle beyond its end stands on the corner, within what a motion that ends there leaves.
    fn lies_on<B: Body>(&self, solid: &Solid, n: Axis, body: &B) -> bool {
        let (lo, hi, bounds) = (solid.lo(), solid.hi(), body.bounds());
        let (b_lo, b_hi) = (bounds.lo(), bounds.hi());
        let (gap, along) = if n.x == 0 {
            (if n.y > 0 { b_lo.y - hi.y } else { lo.y - b_hi.y }, (b_lo.x, b_hi.x, lo.x, hi.x))
        } else {
            (if n.x > 0 { b_lo.x - hi.x } else { lo.x - b_hi.x }, (b_lo.y, b_hi.y, lo.y, hi.y))
        };
        let (from, to, start, end) = along;
        if !B::MEETS_CORNERS {
            return gap == 0 && from < end && start < to && self.side(n) == Side::Floor;
        }
        // How far the centre is beyond the nearer end of the side; 0 over the side itself.
        let middle = from + (to - from) / 2;
        let beyond = (start - middle).max(middle - end).max(0);
        if beyond == 0 || solid.one_way().is_some() {
            return beyond == 0 && gap == 0 && self.side(n) == Side::Floor;
        }
        let radius = (to - from) / 2;
        let (above, reach) = (gap + radius, radius + CONTACT);
        if above <= 0 || beyond > reach || above > reach {
            return false;
        }
        let aside = if middle < start { beyond.wrapping_neg() } else { beyond };
        let normal = if n.x == 0 { Axis::new(aside, n.y * above) } else { Axis::new(n.x * above, aside) };
        let square = |v: i32| usqr(v.unsigned_abs());
        square(above) + square(beyond) <= square(reach) && self.side(normal) == Side::Floor
    }
}

/// The faces of a box as [`Solid::pieces`] counts them, and their normals.
const SIDES: [(u8, Axis); 4] = [(1, Axis::NEG_Y), (2, Axis::X), (4, Axis::Y), (8, Axis::NEG_X)];
