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
