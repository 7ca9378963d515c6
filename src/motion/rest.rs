//! How a body that is held between surfaces comes to rest.

use super::body::Body;
use super::plane::way;
use super::run::{Run, check_inside};
use crate::num::{Raw, leading_zeros64};

/// How far along what it touches a creeping body looks for what holds it, in raw units.
pub(super) const AHEAD: u32 = 255;

impl<B: Body> Run<'_, B> {
    /// Between surfaces that are not all of blocks a body has found its place when nothing is left of its velocity; roundings to and fro
    /// around it do not move it any more. Where it creeps, what holds it may be less than a rounding away.
    pub(super) fn settle(&mut self) {
        const SLOW: u32 = 64;
        let Some(start) = self.start.filter(|start| self.planes.are_near(self.made(start))) else { return };
        if !self.v.is_zero() {
            self.creeps = way(self.v) <= SLOW && check_inside(&self.moved.body.bounds(), self.ahead()).is_ok();
        } else if self.planes.are_wedge() {
            self.moved.body = start;
        }
    }

    /// The way of a creeping body, at a length of 256 to 511 raw.
    pub(super) fn ahead(&self) -> Raw {
        const BITS: u32 = 9;
        let bits = 64 - leading_zeros64(way(self.v).into());
        Raw { x: self.v.x << (BITS - bits), y: self.v.y << (BITS - bits) }
    }

    /// The displacement since the start of the call.
    pub(super) fn made(&self, start: &B) -> Raw {
        Raw::of(self.moved.body.position()).sub(Raw::of(start.position()))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test")]

    use super::way;
    use crate::motion::Moved;
    use crate::motion::around::Around;
    use crate::motion::run::Run;
    use crate::num::{Fx, Raw, Vec2};
    use crate::shape::Circle;

    #[test]
    fn a_creeping_body_looks_ahead_in_its_direction() {
        let body = Circle::new(Vec2::ZERO, Fx::ONE).unwrap();
        for v in (-64..=64).flat_map(|x| (-64..=64).map(move |y| Raw { x, y })).filter(|v| !v.is_zero()) {
            let (mut moved, mut around) = (Moved::freely(body, v.vec2(), 0), Around::NOTHING);
            let ahead = Run::new(&mut moved, &mut around).ahead();
            assert!((256..512).contains(&way(ahead)), "{v:?} {ahead:?}");
            assert!(v.cross(ahead) == 0 && v.dot(ahead) > 0, "{v:?} {ahead:?}");
        }
    }
}
