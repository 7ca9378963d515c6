//! A ball: gravity, bounces, the pushes of bumpers, of flippers and of the kicker, and other balls.

use tilesat::motion::response::{exchange, separate};
use tilesat::motion::{Response, Ridden, Ride};
use tilesat::prelude::*;
use tilesat::{Axis, Circle, Fx, MoveError, Mover, RangeError, Ratio, Surface, Vec2, World, fx, motion::Masses};

use super::table::{BUMPER, KICKER};

pub const RADIUS: Fx = fx!(5);
/// Raw units per frame, or per frame squared.
const GRAVITY: i32 = 5_000;
const BUMP: i32 = 90_000;
const KICK: i32 = 560_000;

#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub body: Circle,
    pub velocity: Vec2,
    pub bumps: u32,
    pub kicks: u32,
    pub flips: u32,
}

impl Ball {
    pub fn new(centre: Vec2, velocity: Vec2) -> Result<Self, RangeError> {
        Ok(Self { body: Circle::new(centre, RADIUS)?, velocity, bumps: 0, kicks: 0, flips: 0 })
    }

    pub fn step(&mut self, table: &impl World) -> Result<(), MoveError> {
        let rubber = Surface::new(Ratio::percent(80).unwrap_or(Ratio::ONE), Ratio::percent(5).unwrap_or(Ratio::ZERO));
        let mover = Mover::new().with_response(Response::Bounce).with_surface(rubber);
        let moved = mover.move_and_slide(table, &self.body, self.velocity + Vec2::from_raw(0, GRAVITY))?;
        (self.body, self.velocity) = (moved.body, moved.velocity);
        for hit in &moved.hits {
            if hit.flags & BUMPER != 0 {
                self.push(hit.axis, BUMP);
                self.bumps += 1;
            }
            if hit.flags & KICKER != 0 {
                self.push(hit.axis, KICK);
                self.kicks += 1;
            }
        }
        Ok(())
    }

    /// Goes where flippers that turn push it, and keeps that motion as a part of its velocity.
    pub fn give_way(&mut self, ridden: &Ridden<Circle>) {
        self.body = ridden.body;
        if let Ride::Pushed { .. } = ridden.ride {
            self.velocity += ridden.motion;
            self.flips += 1;
        }
    }

    /// Separates two balls that overlap, each by half as far as the table allows. They exchange
    /// their speeds along the line between them.
    pub fn meet(&mut self, other: &mut Self, table: &impl World) -> Result<bool, MoveError> {
        let Some(contact) = self.body.contact(&other.body) else { return Ok(false) };
        let (push, other_push) = separate(&contact, Ratio::HALF);
        self.body = Mover::new().move_and_slide(table, &self.body, push)?.body;
        other.body = Mover::new().move_and_slide(table, &other.body, other_push)?.body;
        let both = exchange(self.velocity, other.velocity, contact.axis(), Masses::EQUAL, &Surface::ELASTIC)?;
        (self.velocity, other.velocity) = both;
        Ok(true)
    }

    /// Adds `speed` along a normal.
    fn push(&mut self, along: Axis, speed: i32) {
        self.velocity += along.unit().scaled(Fx::from_bits(speed));
    }
}
