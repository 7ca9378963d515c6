//! Steps: up, forward, down.

use super::Support;
use super::ground::{CONTACT, Ground, Look, along, length, within};
use super::stride::Stride;
use crate::motion::body::{Body, kernel::Kernel};
use crate::motion::plane::{NEAR, into, way};
use crate::motion::search::hull;
use crate::num::{Raw, Toi, mul_div};
use crate::shape::Aabb;
use crate::world::World;

impl<W: World, B: Body> Stride<'_, '_, W, B> {
    /// Climbs the step in front, if there is one: up by its height, forward by the rest of the leg,
    /// down to a floor. Otherwise the body stays where it is.
    #[inline(never)]
    pub(super) fn climb(&mut self) -> bool {
        let forward = self.forward(self.run.rest.of_raw(self.speed as i32) as u32);
        if self.walker.step == 0 || forward.is_zero() {
            return false;
        }
        let start = self.run.here();
        let (room, ..) = self.shift(along(self.up, self.walker.step));
        self.run.put_back(start);
        let least = self.least(room, forward);
        // A step thinner than a leg is passed over its top.
        [least, room].into_iter().any(|raised| {
            let climbed = self.climb_by(raised, room, forward);
            if !climbed {
                self.run.put_back(start);
            }
            climbed
        })
    }

    /// How far the body must rise from its position for the ground ahead, found from `room` above
    /// it.
    ///
    /// ```text
    ///   ________            Obstacles at that height do not count:
    ///   lintel  |           only ground that carries the body from below does.
    ///   --------'  o room
    ///    h _____   ^
    ///     |sill    o
    /// ```
    fn least(&mut self, room: Raw, forward: Raw) -> Raw {
        let down = along(self.up, -CONTACT).sub(room);
        self.run.look_from(self.world, room.add(forward), down).map_or(Raw::ZERO, |ground| room.add(ground.drop()))
    }

    fn climb_by(&mut self, height: Raw, room: Raw, forward: Raw) -> bool {
        let raised = self.run.commit(self.world, height, &[height]);
        if into(raised, self.up) <= 0 {
            return false;
        }
        let bounds = self.run.moved.body.bounds();
        let (made, rest, hit) = self.shift(forward);
        if made.is_zero() {
            return hit.is_some_and(|hit| self.goes_on(&hit, raised));
        }
        if B::MEETS_CORNERS && self.passes_one_way(&bounds, made) {
            return false;
        }
        // Down to where it came from, and a little farther: a floor of that height is only touched.
        let down = along(self.up, -CONTACT).sub(raised);
        let Some(ground) = self.run.look(self.world, down) else { return false };
        // The edge is no floor, however flatly the body meets it: the step's height counts.
        let corner = ground.entry.step.is_some();
        let floor = if corner { None } else { self.walker.mover.support(&ground) };
        let Some(floor) = floor.or_else(|| self.beyond(&ground, room.sub(raised))) else { return false };
        let fall = self.run.advance(self.world, down, &ground.entry);
        (self.floor, self.climbed) = (floor.axis, Some(floor));
        self.run.rest = rest;
        self.stepped += length(raised.add(fall));
        true
    }

    /// Whether the step continues as a slope, which the motion forward hits. A body that is raised
    /// by the step's exact height then touches the slope, and can only move along it.
    fn goes_on(&mut self, hit: &Ground, raised: Raw) -> bool {
        let Some(floor) = self.walker.mover.support(hit).filter(|floor| !floor.one_way) else { return false };
        let before = core::mem::replace(&mut self.floor, floor.axis);
        let along = self.velocity(self.run.rest);
        if self.run.look(self.world, along).is_some_and(|next| way(next.drop()) <= NEAR) {
            self.floor = before;
            return false;
        }
        self.climbed = Some(floor);
        self.stepped += length(raised);
        true
    }

    /// Whether the box around a raised circle meets a one-way face in front of it. The free end of
    /// such a face does not hold a circle. But if it is higher than the circle's lowest point, it
    /// is higher than the step.
    fn passes_one_way(&mut self, bounds: &Aabb, d: Raw) -> bool {
        let mut features = self.world.features(&hull(bounds, Raw::ZERO, d, 1));
        while let Some(feature) = &features.next() {
            self.run.moved.work.features += 1;
            if feature.one_way && !self.run.pass_one_way && bounds.sweep_in::<W>(d, feature).is_some() {
                return true;
            }
        }
        false
    }

    /// The floor that carries the body on this ground.
    ///
    /// A circle, or a polygon on a narrow foot, comes down to the edge of a step before or after it
    /// is over the step. Such a step is not complete. The same motion down is
    /// then tested from farther ahead, by the part of the body in front of its foot. The body
    /// stands if that ends on floor.
    pub(super) fn footing(&mut self, ground: &Ground) -> Option<Support> {
        self.walker.mover.support(ground).or_else(|| self.beyond(ground, Raw::ZERO))
    }

    fn beyond(&mut self, ground: &Ground, raised: Raw) -> Option<Support> {
        if !B::MEETS_CORNERS || (!B::ANGULAR && ground.entry.step.is_none()) {
            return None;
        }
        let body = self.run.moved.body;
        let (foot, overhang) = body.foot(self.up, self.facing());
        let forward = self.forward(overhang as u32);
        if forward.is_zero() {
            return None;
        }
        let to = raised.add(forward);
        // From within ground that is too high, the part behind the foot comes down to the old
        // floor.
        if B::is_inside(self.world, foot.add(along(self.up, -body.rounding())).add(to)) {
            return None;
        }
        let beyond = self.run.look_from(self.world, to, ground.d.sub(raised))?;
        self.walker.mover.support(&beyond)
    }

    /// Moves as far as the motion is free and in the domain. Returns the motion, the time left, and
    /// the hit.
    fn shift(&mut self, d: Raw) -> (Raw, Toi, Option<Ground>) {
        // A motion counts as free only if the level was examined.
        let d = within(&self.run.moved.body.bounds(), d);
        let hit = self.run.look(self.world, d);
        let (made, rest) = match &hit {
            Some(Ground { entry, .. }) => {
                let left = mul_div(self.run.rest.raw(), entry.den - entry.num, entry.den);
                (self.run.advance(self.world, d, entry), Toi::clamped(left))
            }
            None => (self.run.commit(self.world, d, &[d]), Toi::ZERO),
        };
        (made, rest, hit)
    }
}
