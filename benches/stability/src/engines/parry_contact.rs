//! The hobby form with parry2d's contact query instead of formulas.

use super::parry::Obstacles;
use crate::engine::{Engine, State};
use crate::scene::{Scene, Start};
use parry2d::math::Vector;

/// Moves by the whole velocity. Then pushes the body out of one obstacle after the other by the
/// contact's normal and depth.
pub struct ParryContact {
    obstacles: Obstacles,
    gravity: f32,
    bounce: f32,
    p: Vector,
    v: Vector,
}

impl ParryContact {
    pub fn new(scene: &Scene, start: &Start) -> Option<Self> {
        let (p, v) = super::parry::start(start);
        let (gravity, bounce) = super::parry::rules(scene);
        Some(Self { obstacles: Obstacles::new(scene)?, gravity, bounce, p, v })
    }
}

impl Engine for ParryContact {
    fn frame(&mut self) {
        self.v.y += self.gravity;
        self.p += self.v;
        self.obstacles.push_out(&mut self.p, &mut self.v, self.bounce);
    }

    fn state(&self) -> State {
        super::parry::state(self.p, self.v)
    }

    fn shift(&mut self, by: i32) {
        self.p.x += by as f32 / 65536.0;
    }
}
