//! The library's exact sweeps with the response of Quake: it clips the velocity at one plane after
//! the other.

use super::ours::{self, vec2};
use crate::engine::{Engine, State};
use crate::scene::{Point, Scene, Shape, Start};
use tilesat::{Axis, Circle, Fx, Mover, Response, World};

/// Only shows why the mover projects on a cone.
pub struct Clip<W> {
    world: W,
    ball: Option<Circle>,
    v: Point,
    gravity: i32,
}

impl<W: World> Clip<W> {
    pub fn new(world: W, scene: &Scene, start: &Start) -> Option<Self> {
        let Shape::Ball(radius) = scene.shape else { return None };
        let ball = Circle::new(vec2(start.centre), Fx::from_bits(radius)).ok();
        (scene.bounce == 0 && scene.period == 0).then_some(Self {
            world,
            ball,
            v: start.velocity,
            gravity: scene.gravity,
        })
    }
}

/// Without its part into the plane, rounded toward zero.
fn clipped(v: Point, n: Axis) -> Point {
    let into = n.dot(Axis::new(v[0], v[1])).min(0);
    let part = |c: i32| i128::from(into) * i128::from(c) / i128::from(n.length_squared());
    [v[0] - part(n.x) as i32, v[1] - part(n.y) as i32]
}

impl<W: World> Engine for Clip<W> {
    fn frame(&mut self) {
        self.v[1] += self.gravity;
        let mover = Mover::new().with_response(Response::Touch);
        let mut motion = self.v;
        for _ in 0..Mover::ITERATIONS {
            let Some(ball) = &self.ball else { return };
            let Ok(moved) = mover.move_and_slide(&self.world, ball, vec2(motion)) else {
                self.ball = None;
                return;
            };
            self.ball = Some(moved.body);
            let Some(hit) = moved.hits.first() else { break };
            self.v = clipped(self.v, hit.axis);
            motion = clipped(moved.remaining.raw().into(), hit.axis);
        }
    }

    fn state(&self) -> State {
        ours::state(self.ball.as_ref(), vec2(self.v))
    }

    fn shift(&mut self, _: i32) {}
}
