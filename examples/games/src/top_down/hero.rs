//! The hero of a game seen from above.

use tilesat::{Aabb, Axis, Fx, MoveError, Mover, RangeError, Vec2, World};

/// Raw units per frame.
const SPEED: i32 = 98_304;
const PIXEL: i32 = 65_536;

#[derive(Clone, Copy, Debug)]
pub struct Hero {
    body: Aabb,
    /// How far it slips aside to get around a corner, in pixels.
    slip: i32,
}

impl Hero {
    pub fn new(min: Vec2, slip: i32) -> Result<Self, RangeError> {
        Ok(Self { body: Aabb::new(min, min + Vec2::from_ints(12, 12))?, slip })
    }

    pub fn centre(&self) -> Vec2 {
        self.body.min() + Vec2::from_ints(6, 6)
    }

    /// Walks one frame. It is as fast along a diagonal as along the axes.
    pub fn step(&mut self, world: &impl World, (x, y): (i32, i32)) -> Result<(), MoveError> {
        if (x, y) == (0, 0) {
            return Ok(()); // no direction
        }
        let velocity = Axis::new(x, y).unit().scaled(Fx::from_bits(SPEED));
        let moved = Mover::new().move_and_slide(world, &self.body, velocity)?;
        let stopped = moved.body == self.body;
        self.body = moved.body;
        if stopped && (x == 0) != (y == 0) {
            let aside = self.way_around(world, Axis::new(x, y));
            self.body = Mover::new().move_and_slide(world, &self.body, aside)?.body;
        }
        Ok(())
    }

    /// The slip to the nearer side from which the way ahead is free, at most as fast as it walks.
    /// Zero if there is none within reach.
    fn way_around(&self, world: &impl World, ahead: Axis) -> Vec2 {
        let side = ahead.perp();
        for pixels in 1..=self.slip {
            for sign in [1, -1] {
                let far = pixels * sign * PIXEL;
                let aside = Vec2::from_raw(side.x * far, side.y * far);
                let next = aside + Vec2::from_raw(ahead.x * PIXEL, ahead.y * PIXEL);
                if self.is_free(world, aside) && self.is_free(world, next) {
                    let near = far.clamp(-SPEED, SPEED);
                    return Vec2::from_raw(side.x * near, side.y * near);
                }
            }
        }
        Vec2::ZERO
    }

    fn is_free(&self, world: &impl World, offset: Vec2) -> bool {
        self.body.translated(offset).is_ok_and(|body| !world.overlaps_aabb(&body))
    }
}
