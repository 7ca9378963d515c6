//! What both parry2d engines share: the obstacles and the two queries, in f32 pixels.

use crate::engine::State;
use crate::scene::{Point, Scene, Shape, Start};
use parry2d::math::{Pose, Vector};
use parry2d::query::{self, ShapeCastOptions};
use parry2d::shape::{Ball, Cuboid, Segment, Shape as ParryShape};

pub struct Obstacles {
    body: Box<dyn ParryShape>,
    /// Half of the body's bounding box.
    half: Vector,
    list: Vec<Obstacle>,
}

struct Obstacle {
    pose: Pose,
    shape: Box<dyn ParryShape>,
    lo: Vector,
    hi: Vector,
}

fn vector(p: Point) -> Vector {
    let [x, y] = p.map(|c| (f64::from(c) / 65536.0) as f32);
    Vector::new(x, y)
}

pub fn start(start: &Start) -> (Vector, Vector) {
    (vector(start.centre), vector(start.velocity))
}

/// Gravity and restitution.
pub fn rules(scene: &Scene) -> (f32, f32) {
    (vector([0, scene.gravity]).y, scene.bounce as f32 / 256.0)
}

pub fn state(p: Vector, v: Vector) -> State {
    let px = |v: Vector| [f64::from(v.x), f64::from(v.y)];
    State { centre: px(p), velocity: px(v) }
}

impl Obstacles {
    pub fn new(scene: &Scene) -> Option<Self> {
        let (body, half): (Box<dyn ParryShape>, _) = match scene.shape {
            Shape::Ball(r) => (Box::new(Ball::new(vector([r, r]).x)), vector([r, r])),
            Shape::Box(half) => (Box::new(Cuboid::new(vector(half))), vector(half)),
        };
        let list = scene.obstacles(i32::MAX)?.into_iter().map(|[a, b]| {
            let (a, b) = (vector(a), vector(b));
            let (pose, shape): (_, Box<dyn ParryShape>) = match scene.shape {
                Shape::Ball(_) => (Pose::identity(), Box::new(Segment::new(a, b))),
                Shape::Box(_) => {
                    let middle = (a + b) * 0.5;
                    (Pose::translation(middle.x, middle.y), Box::new(Cuboid::new((b - a) * 0.5)))
                }
            };
            Obstacle { pose, shape, lo: a.min(b), hi: a.max(b) }
        });
        Some(Self { body, half, list: list.collect() })
    }

    /// The obstacles that meet a bounding box.
    fn near(&self, lo: Vector, hi: Vector) -> impl Iterator<Item = &Obstacle> {
        let (lo, hi) = (lo - self.half, hi + self.half);
        self.list.iter().filter(move |o| o.lo.x <= hi.x && o.lo.y <= hi.y && lo.x <= o.hi.x && lo.y <= o.hi.y)
    }

    /// Pushes the body out of each obstacle in turn, and removes its velocity into the obstacle.
    pub fn push_out(&self, p: &mut Vector, v: &mut Vector, bounce: f32) {
        for o in self.near(*p, *p) {
            let here = Pose::translation(p.x, p.y);
            let contact = query::contact(&o.pose, &*o.shape, &here, &*self.body, 0.0);
            let Ok(Some(contact)) = contact else { continue };
            if contact.dist < 0.0 {
                *p -= contact.normal1 * contact.dist;
                let into = v.dot(contact.normal1);
                if into < 0.0 {
                    *v -= contact.normal1 * (into * (1.0 + bounce));
                }
            }
        }
    }

    /// The first hit of a motion that moves in: the part of the motion before it, and the
    /// obstacle's normal.
    pub fn first_hit(&self, p: Vector, d: Vector) -> Option<(f32, Vector)> {
        let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
        let here = Pose::translation(p.x, p.y);
        self.near(p.min(p + d), p.max(p + d))
            .filter_map(|o| {
                query::cast_shapes(&o.pose, Vector::ZERO, &*o.shape, &here, d, &*self.body, options).ok().flatten()
            })
            .map(|hit| (hit.time_of_impact, hit.normal1))
            .filter(|(_, n)| d.dot(*n) < 0.0)
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }
}
