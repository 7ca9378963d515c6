//! The hobby form with parry2d's shape cast: the body passes through nothing.

use super::parry::Obstacles;
use crate::engine::{Engine, State};
use crate::scene::{Scene, Start};
use parry2d::math::Vector;

/// Casts the body along its motion, moves to the first hit, responds, and continues with the rest,
/// at most four times. Then pushes it out of every remaining overlap by contacts.
pub struct ParryCast {
    obstacles: Obstacles,
    gravity: f32,
    bounce: f32,
    p: Vector,
    v: Vector,
}

impl ParryCast {
    pub fn new(scene: &Scene, start: &Start) -> Option<Self> {
        let (p, v) = super::parry::start(start);
        let (gravity, bounce) = super::parry::rules(scene);
        Some(Self { obstacles: Obstacles::new(scene)?, gravity, bounce, p, v })
    }
}

impl Engine for ParryCast {
    fn frame(&mut self) {
        self.v.y += self.gravity;
        let mut rest = 1.0;
        for _ in 0..4 {
            let Some((t, n)) = self.obstacles.first_hit(self.p, self.v * rest) else {
                self.p += self.v * rest;
                break;
            };
            self.p += self.v * (rest * t);
            rest *= 1.0 - t;
            let into = self.v.dot(n);
            if into < 0.0 {
                self.v -= n * (into * (1.0 + self.bounce));
            }
        }
        self.obstacles.push_out(&mut self.p, &mut self.v, self.bounce);
    }

    fn state(&self) -> State {
        super::parry::state(self.p, self.v)
    }

    fn shift(&mut self, by: i32) {
        self.p.x += by as f32 / 65536.0;
    }
}
