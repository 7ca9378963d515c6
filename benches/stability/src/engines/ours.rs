//! The library's mover, as a game calls it.

use crate::engine::{Engine, State};
use crate::scene::{Point, Scene, Shape, Start};
use tilesat::{Aabb, Axis, Body, Circle, Fx, Mover, Ratio, Response, Surface, Vec2, World, motion::Speed};

/// A ball or a box in tiles or among segments.
pub struct Ours<W, B> {
    world: W,
    /// A surface without restitution: bodies slide.
    surface: Option<Surface>,
    body: Option<B>,
    v: Vec2,
    /// The settings of elastic bounces.
    speed: Speed,
    gravity: Vec2,
}

/// The engine for the scene's body.
pub fn ours<'a, W: World + 'a>(world: W, scene: &Scene, start: &Start) -> Box<dyn Engine + 'a> {
    match scene.shape {
        Shape::Ball(_) => Box::new(Ours::new(world, scene, start, ball(scene, start.centre))),
        Shape::Box(_) => Box::new(Ours::new(world, scene, start, cuboid(scene, start.centre))),
    }
}

pub fn vec2([x, y]: Point) -> Vec2 {
    Vec2::from_raw(x, y)
}

pub fn ball(scene: &Scene, centre: Point) -> Option<Circle> {
    let Shape::Ball(radius) = scene.shape else { return None };
    Circle::new(vec2(centre), Fx::from_bits(radius)).ok()
}

fn cuboid(scene: &Scene, [x, y]: Point) -> Option<Aabb> {
    let Shape::Box([w, h]) = scene.shape else { return None };
    Aabb::new(vec2([x - w, y - h]), vec2([x + w, y + h])).ok()
}

/// Calls of the bench that the mover itself does not need.
pub trait Mobile: Body {
    /// Twice the centre, in raw units.
    fn twice(&self) -> Point;
    fn beside(&self, by: i32) -> Option<Self>;
}

impl Mobile for Circle {
    fn twice(&self) -> Point {
        <[i32; 2]>::from(self.centre().raw()).map(|c| 2 * c)
    }

    fn beside(&self, by: i32) -> Option<Self> {
        let (x, y) = self.centre().raw();
        Self::new(vec2([x + by, y]), self.radius()).ok()
    }
}

impl Mobile for Aabb {
    fn twice(&self) -> Point {
        let (a, b) = (self.min().raw(), self.max().raw());
        [a.0 + b.0, a.1 + b.1]
    }

    fn beside(&self, by: i32) -> Option<Self> {
        let (a, b) = (self.min().raw(), self.max().raw());
        Self::new(vec2([a.0 + by, a.1]), vec2([b.0 + by, b.1])).ok()
    }
}

/// Converts to a state in pixels.
pub fn state<B: Mobile>(body: Option<&B>, v: Vec2) -> State {
    body.map_or(State::LOST, |body| State {
        centre: body.twice().map(|c| f64::from(c) / 131_072.0),
        velocity: <[i32; 2]>::from(v.raw()).map(|c| f64::from(c) / 65536.0),
    })
}

impl<W: World, B: Mobile> Ours<W, B> {
    fn new(world: W, scene: &Scene, start: &Start, body: Option<B>) -> Self {
        let v = vec2(start.velocity);
        let surface = (scene.bounce > 0).then(|| surface(scene));
        Self { world, surface, body, v, speed: Speed::of(v), gravity: vec2([0, scene.gravity]) }
    }
}

/// The response of a scene's walls.
///
/// Gravity g acts once per frame. So bounces at restitution e that meet the floor at the right
/// moment of a frame go on for ever, at up to g / (1 - e). A slower bounce counts as none.
pub fn surface(scene: &Scene) -> Surface {
    let restitution = Ratio::new(scene.bounce as u32, 256).unwrap_or(Ratio::ONE);
    let rest = (scene.gravity * 256).checked_div(256 - scene.bounce).unwrap_or(0);
    Surface::new(restitution, Ratio::ZERO).resting_below(Fx::from_bits(rest))
}

impl<W: World, B: Mobile> Engine for Ours<W, B> {
    fn frame(&mut self) {
        let Some(body) = &self.body else { return };
        let v = self.v + self.gravity;
        self.speed = self.speed.changed(self.v, v);
        let mover = Mover::platformer(Axis::NEG_Y);
        let moved = match self.surface {
            None => mover.move_and_slide(&self.world, body, v),
            Some(surface) => mover
                .with_response(Response::Bounce)
                .with_surface(surface.with_speed(self.speed))
                .move_and_slide(&self.world, body, v),
        };
        self.body = moved.as_ref().ok().map(|m| m.body);
        self.v = moved.map_or(v, |m| m.velocity);
        if self.surface.is_none_or(|s| s.restitution() < Ratio::ONE) {
            self.speed = Speed::of(self.v);
        }
    }

    fn state(&self) -> State {
        state(self.body.as_ref(), self.v)
    }

    fn shift(&mut self, by: i32) {
        self.body = self.body.and_then(|body| body.beside(by));
    }
}
