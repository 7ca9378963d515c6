//! A body: its shape, its velocity and its response to the level.

use tilesat::motion::{Hit, MoveError, Moved, Mover, Response};
use tilesat::num::DOMAIN;
use tilesat::world::{ShapeSet, TileMap, World};
use tilesat::{Aabb, Axis, Circle, Fx, Vec2};

use super::FrameReport;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    Box(Aabb),
    Ball(Circle),
}

impl Shape {
    /// For a box, the corner with the smaller coordinates. For a ball, the centre.
    pub fn position(&self) -> Vec2 {
        match self {
            Self::Box(aabb) => aabb.min(),
            Self::Ball(circle) => circle.centre(),
        }
    }
}

#[derive(Debug, Clone, Copy)]
pub struct Actor {
    pub shape: Shape,
    /// Units per frame, after the last motion.
    pub velocity: Vec2,
    /// Units per frame that the actor wanted in the last frame.
    pub asked: Vec2,
    pub response: Response,
    /// Whether it falls.
    pub heavy: bool,
    /// The first hit of the last frame.
    pub hit: Option<Hit>,
}

/// The facts about its last motion that an actor needs.
#[derive(Debug, Clone, Copy, Default)]
pub struct Outcome {
    pub floor: bool,
    pub ceiling: bool,
    pub one_way: bool,
    pub flags: u8,
}

impl Actor {
    pub fn new(shape: Shape, response: Response, heavy: bool) -> Self {
        Self { shape, velocity: Vec2::ZERO, asked: Vec2::ZERO, response, heavy, hit: None }
    }

    /// Puts a box with its feet, the middle of its lower side, at a point. Returns whether it is a
    /// box and has room there.
    pub fn stand_at<W: World>(&mut self, world: &W, feet: Vec2) -> bool {
        let Shape::Box(own) = self.shape else { return false };
        let half = own.size() / 2;
        let Ok(body) = Aabb::from_centre(feet - Vec2::new(Fx::ZERO, half.y), half) else { return false };
        let free = !world.overlaps_aabb(&body);
        if free {
            self.shape = Shape::Box(body);
        }
        free
    }

    /// Moves by the velocity for one frame.
    pub fn advance<S: ShapeSet>(&mut self, map: &TileMap<'_, S>, report: &mut FrameReport) -> Outcome {
        let mover = Mover::platformer(Axis::NEG_Y).with_response(self.response);
        self.asked = self.within_domain();
        match self.shape {
            Shape::Box(aabb) => {
                let moved = mover.move_and_slide(map, &aabb, self.asked);
                self.commit(moved, Shape::Box, report)
            }
            Shape::Ball(circle) => {
                let moved = mover.move_and_slide(map, &circle, self.asked);
                self.commit(moved, Shape::Ball, report)
            }
        }
    }

    /// The velocity, cut if the motion could leave the domain. The library refuses such a motion
    /// even with a wall before it. It happens only in levels that nearly fill the domain.
    fn within_domain(&self) -> Vec2 {
        let (right, bottom) = match self.shape {
            Shape::Box(aabb) => aabb.max().raw(),
            Shape::Ball(circle) => circle.aabb().max().raw(),
        };
        let room = DOMAIN - 1 - right.max(bottom);
        let (x, y) = self.velocity.raw();
        if x.abs() + y.abs() <= room {
            return self.velocity;
        }
        Vec2::from_raw(x.clamp(-room / 2, room / 2), y.clamp(-room / 2, room / 2))
    }

    fn commit<B>(
        &mut self,
        moved: Result<Moved<B>, MoveError>,
        shape: fn(B) -> Shape,
        report: &mut FrameReport,
    ) -> Outcome {
        let Ok(moved) = moved else {
            report.refused += 1;
            self.velocity = Vec2::ZERO;
            self.hit = None;
            return Outcome::default();
        };
        self.shape = shape(moved.body);
        self.velocity = moved.velocity;
        report.contacts += moved.hits.len() as u32;
        self.hit = moved.hits.first();
        Outcome {
            floor: moved.floor,
            ceiling: moved.ceiling,
            one_way: moved.hits.iter().any(|hit| hit.one_way),
            flags: moved.flags,
        }
    }
}
