//! Steps: up, forward, down.

use super::Support;
use super::ground::CONTACT;
use super::ground::{Ground, Look, along, within};
use super::stride::Stride;
use super::walker::length;
use crate::motion::body::Body;
use crate::motion::body::kernel::Kernel;
use crate::motion::search::hull;
use crate::num::{Raw, Toi, mul_div};
use crate::shape::Aabb;
use crate::world::World;

impl<W: World, B: Body> Stride<'_, W, B> {
    /// Climbs the step in front, if it is one: up by at most the walker's step, forward by the rest of the leg, down to level ground. Else the body
    /// stays where it is.
    #[inline(never)]
    pub(super) fn climb(&mut self) -> bool {
        if self.walker.step == 0 {
            return false;
        }
        // Under a low ceiling half of it may be enough, above all for a circle that is on its way up already.
        self.climb_by(self.walker.step) || self.climb_by(self.walker.step >> 1)
    }

    fn climb_by(&mut self, height: i32) -> bool {
        let start = self.run.here();
        let climbed = self.try_climb(height);
        if climbed {
            // What it is over by now blocks no more; what still does is met by the rest of the frame.
            self.run.moved.wall = false;
        } else {
            self.run.put_back(start);
        }
        climbed
    }

    fn try_climb(&mut self, height: i32) -> bool {
        let forward = self.forward(self.run.rest.of_raw(self.speed as i32) as u32);
        let (raised, _) = self.shift(along(self.up, height));
        if raised.is_zero() || forward.is_zero() {
            return false;
        }
        let bounds = self.run.moved.body.bounds();
        let (made, rest) = self.shift(forward);
        if made.is_zero() || (B::MEETS_CORNERS && self.passes_one_way(&bounds, made)) {
            return false;
        }
        // To where it came from, and a little farther: on a floor of that height it touches only.
        let down = along(self.up, -CONTACT).sub(raised);
        let Some(ground) = self.run.look(self.world, down) else { return false };
        // The edge is no floor, however flat it is met: the step's height counts.
        let corner = ground.entry.step.is_some();
        let floor = if corner { self.beyond(&ground) } else { self.level(&ground) };
        let Some(floor) = floor else { return false };
        let fall = self.run.advance(self.world, down, &ground.entry);
        (self.floor, self.climbed) = (floor.axis, Some(floor));
        self.run.rest = rest;
        self.stepped += length(raised.add(fall));
        true
    }

    /// Whether the box around a raised circle meets a one-way face in front of it: the free end of such a face holds no circle, but where it is higher than
    /// the circle's lowest point, it is higher than the step.
    fn passes_one_way(&mut self, bounds: &Aabb, d: Raw) -> bool {
        let mut features = self.world.features(&hull(bounds, Raw::ZERO, d, 1));
        while let Some(feature) = &features.next() {
            self.run.moved.work.features += 1;
            if feature.one_way && !self.run.pass_one_way && bounds.sweep(d, feature).is_some() {
                return true;
            }
        }
        false
    }

    /// What carries the body on this ground.
    ///
    /// A circle comes down to the edge of a step before it is over the step, or still when it is beyond. There it is on its way, and stands,
    /// if there is level floor at the end of the same way down from half its width farther on.
    pub(super) fn footing(&mut self, ground: &Ground) -> Option<Support> {
        self.walker.mover.support(ground).or_else(|| self.beyond(ground))
    }

    fn beyond(&mut self, ground: &Ground) -> Option<Support> {
        if !B::MEETS_CORNERS || ground.entry.step.is_none() {
            return None;
        }
        let start = self.run.here();
        let size = Raw::of(self.run.moved.body.bounds().size());
        let forward = self.forward((size.x.max(size.y) >> 1) as u32);
        if forward.is_zero() {
            return None;
        }
        self.shift(forward);
        let beyond = self.run.look(self.world, ground.d);
        self.run.put_back(start);
        self.level(&beyond?)
    }

    /// The ground as a support, where it is level.
    fn level(&self, ground: &Ground) -> Option<Support> {
        self.walker.mover.support(ground).filter(|floor| floor.axis.perp_dot(self.up) == 0)
    }

    /// As far as it is free and in the domain; the part of the time that is left.
    fn shift(&mut self, d: Raw) -> (Raw, Toi) {
        // What is not looked at is not free.
        let d = within(&self.run.moved.body.bounds(), d);
        match self.run.look(self.world, d) {
            Some(Ground { entry, .. }) => {
                let left = mul_div(self.run.rest.raw(), entry.den - entry.num, entry.den);
                (self.run.advance(self.world, d, &entry), Toi::clamped(left))
            }
            None => (self.run.commit(self.world, d, &[d]), Toi::ZERO),
        }
    }
}
