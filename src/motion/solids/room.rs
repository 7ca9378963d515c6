//! The displacements that the faces of the solids leave to a body.

use crate::motion::body::Body;
use crate::num::{Axis, MOTION, Raw};
use crate::world::Solid;

/// Bounds of a body's displacement in one tick, axis by axis.
///
/// They only ever shrink, by a maximum and a minimum, so it does not matter which solid is asked first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    pub(super) lo: Raw,
    pub(super) hi: Raw,
}

impl Room {
    const FAR: i32 = MOTION - 1;

    pub(super) const ALL: Self =
        Self { lo: Raw { x: -Self::FAR, y: -Self::FAR }, hi: Raw { x: Self::FAR, y: Self::FAR } };

    /// Behind a solid's face with the outward normal `n`: no nearer to where it stops than touching it.
    pub(super) fn behind<B: Body>(&mut self, body: &B, solid: &Solid, n: Axis) {
        let (lo, hi, motion, bounds) = (solid.lo(), solid.hi(), Raw::of(solid.motion()), body.bounds());
        // From the body's side to the solid's opposite one at its new place.
        let right = hi.add(motion).sub(bounds.lo());
        let left = lo.add(motion).sub(bounds.hi());
        match (n.x.signum(), n.y.signum()) {
            (1, _) => self.lo.x = self.lo.x.max(right.x),
            (-1, _) => self.hi.x = self.hi.x.min(left.x),
            (_, 1) => self.lo.y = self.lo.y.max(right.y),
            _ => self.hi.y = self.hi.y.min(left.y),
        }
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.lo.x > self.hi.x || self.lo.y > self.hi.y
    }

    /// The displacement in the room that is nearest to one.
    pub(super) fn nearest(&self, d: Raw) -> Raw {
        Raw { x: d.x.max(self.lo.x).min(self.hi.x), y: d.y.max(self.lo.y).min(self.hi.y) }
    }

    /// The axes on which a face says where the body has to be.
    pub(super) const fn held(&self) -> (bool, bool) {
        (self.lo.x > -Self::FAR || self.hi.x < Self::FAR, self.lo.y > -Self::FAR || self.hi.y < Self::FAR)
    }

    /// The same room for a body that wanted to make `d` and could only make `made`: on that side the level has no more.
    pub(super) fn in_level(&self, d: Raw, made: Raw) -> Self {
        let mut room = *self;
        if made.x < d.x {
            room.hi.x = room.hi.x.min(made.x);
        } else if made.x > d.x {
            room.lo.x = room.lo.x.max(made.x);
        }
        if made.y < d.y {
            room.hi.y = room.hi.y.min(made.y);
        } else if made.y > d.y {
            room.lo.y = room.lo.y.max(made.y);
        }
        room
    }
}
