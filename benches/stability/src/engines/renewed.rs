//! The library's mover in a game that keeps the energy of a ball, as a pinball table does.

use super::ours::{self, vec2};
use crate::engine::{Engine, State};
use crate::scene::{Scene, Start};
use tilesat::{Circle, Mover, Response, Surface, Vec2, World};

/// Gravity acts in two halves, around the motion, so a flight is an exact parabola. Only the frame
/// of a bounce is not exact: the ball meets the wall at some moment of it, with the speed of its
/// middle. There the game computes the speed again from the height:
/// |v|^2 = |v0|^2 + 2 g (y - y0), exact in integers.
pub struct Renewed<W> {
    world: W,
    surface: Surface,
    ball: Option<Circle>,
    v: Vec2,
    gravity: i32,
    /// |v0|^2 - 2 g y0.
    energy: i64,
}

impl<W: World> Renewed<W> {
    /// Only for elastic bounces under gravity.
    pub fn new(world: W, scene: &Scene, start: &Start) -> Option<Self> {
        let v = vec2(start.velocity);
        let energy = v.length_squared() as i64 - 2 * i64::from(scene.gravity) * i64::from(start.centre[1]);
        let ball = ours::ball(scene, start.centre);
        let made = Self { world, surface: ours::surface(scene), ball, v, gravity: scene.gravity, energy };
        (made.ball.is_some() && scene.bounce == 256 && scene.gravity > 0).then_some(made)
    }

    /// The velocity in the same direction with the speed for this height, rounded toward zero.
    fn renewed(&self, v: Vec2, y: i32) -> Vec2 {
        let square = self.energy + 2 * i64::from(self.gravity) * i64::from(y);
        let wanted = square.max(0).isqrt();
        let length = v.length_squared().isqrt() as i64 + 1;
        let (vx, vy) = v.raw();
        vec2([vx, vy].map(|c| (i64::from(c) * wanted / length) as i32))
    }
}

impl<W: World> Engine for Renewed<W> {
    fn frame(&mut self) {
        let Some(ball) = &self.ball else { return };
        let first = self.gravity / 2;
        let mover = Mover::new().with_response(Response::Bounce).with_surface(self.surface);
        let moved = mover.move_and_slide(&self.world, ball, self.v + vec2([0, first]));
        self.ball = moved.as_ref().ok().map(|m| m.body);
        let Ok(moved) = moved else { return };
        self.v = moved.velocity + vec2([0, self.gravity - first]);
        if !moved.hits.is_empty() {
            self.v = self.renewed(self.v, moved.position().raw().1);
        }
    }

    fn state(&self) -> State {
        ours::state(self.ball.as_ref(), self.v)
    }

    fn shift(&mut self, _: i32) {}
}
