//! rapier2d as pixel games use it: length unit 32, sixty steps per second, rotation locked, no
//! sleep, no friction.

use crate::engine::{Engine, State};
use crate::scene::{Point, Scene, Shape, Start};
use rapier2d::prelude::*;

/// Frames per second.
const RATE: f32 = 60.0;

pub struct Rapier {
    world: PhysicsWorld,
    body: RigidBodyHandle,
}

fn vector(p: Point) -> Vector {
    let [x, y] = p.map(|c| (f64::from(c) / 65536.0) as f32);
    Vector::new(x, y)
}

impl Rapier {
    pub fn new(scene: &Scene, start: &Start, ccd: bool) -> Option<Self> {
        let mut world = PhysicsWorld::new();
        world.gravity = vector([0, scene.gravity]) * (RATE * RATE);
        world.integration_parameters.length_unit = 32.0;
        let bounce = scene.bounce as f32 / 256.0;
        let rules = |collider: ColliderBuilder| collider.restitution(bounce).friction(0.0);
        for [a, b] in scene.obstacles(i32::MAX)? {
            let (a, b) = (vector(a), vector(b));
            let obstacle = match scene.shape {
                Shape::Ball(_) => ColliderBuilder::segment(a, b),
                Shape::Box(_) => {
                    let half = (b - a) * 0.5;
                    ColliderBuilder::cuboid(half.x, half.y).translation((a + b) * 0.5)
                }
            };
            world.colliders.insert(rules(obstacle));
        }
        let body = RigidBodyBuilder::dynamic()
            .translation(vector(start.centre))
            .linvel(vector(start.velocity) * RATE)
            .lock_rotations()
            .can_sleep(false)
            .ccd_enabled(ccd);
        let body = world.bodies.insert(body);
        let shape = match scene.shape {
            Shape::Ball(r) => ColliderBuilder::ball(vector([r, r]).x),
            Shape::Box(half) => ColliderBuilder::cuboid(vector(half).x, vector(half).y),
        };
        world.colliders.insert_with_parent(rules(shape), body, &mut world.bodies);
        Some(Self { world, body })
    }
}

impl Engine for Rapier {
    fn frame(&mut self) {
        self.world.step();
    }

    fn state(&self) -> State {
        self.world.bodies.get(self.body).map_or(State::LOST, |body| {
            let px = |v: Vector| [f64::from(v.x), f64::from(v.y)];
            State { centre: px(body.translation()), velocity: px(body.linvel() / RATE) }
        })
    }

    fn forgets(&self) -> bool {
        false
    }

    fn shift(&mut self, by: i32) {
        if let Some(body) = self.world.bodies.get_mut(self.body) {
            let p = body.translation();
            body.set_translation(p + vector([by, 0]), true);
        }
    }
}
