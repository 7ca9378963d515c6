//! The car: an oriented box that steers toward the next mark, slides along walls and shoves crates.

use tilesat::motion::turn;
use tilesat::prelude::*;
use tilesat::{Axis, Fx, MoveError, Mover, OrientedBox, RangeError, Vec2, World, fx};

use super::out;

const HALF: Vec2 = Vec2::from_ints(9, 5);
const FASTEST: Fx = fx!(2.2);
const THRUST: Fx = fx!(0.04);
/// The part of a turn that it steers per frame: 600 raw.
const STEER: i32 = 600;
/// The marks of a lap, at the corners of the track.
const MARKS: [Vec2; 4] =
    [Vec2::from_ints(410, 56), Vec2::from_ints(416, 230), Vec2::from_ints(64, 230), Vec2::from_ints(64, 60)];

#[derive(Clone, Copy, Debug)]
pub struct Car {
    pub body: OrientedBox,
    heading: Fx,
    speed: Fx,
    pub marks: u32,
    /// How often it shoved a crate.
    pub shoves: u32,
}

impl Car {
    pub fn new(centre: Vec2) -> Result<Self, RangeError> {
        let body = OrientedBox::new(centre, HALF, Axis::X)?;
        Ok(Self { body, heading: Fx::ZERO, speed: Fx::ZERO, marks: 0, shoves: 0 })
    }

    pub fn step(&mut self, level: &impl World, crates: &mut [OrientedBox; 3]) -> Result<(), MoveError> {
        let (start, others) = (self.body, *crates);
        self.steer(level)?;
        let velocity = Axis::from_turns(self.heading).unit().scaled(self.speed);
        let moved = Mover::new().move_and_slide(level, &self.body, velocity)?;
        (self.body, self.speed) = (moved.body, (moved.velocity.length() + THRUST).min(FASTEST));
        for (i, place) in crates.iter_mut().enumerate() {
            let Some(contact) = place.contact(&self.body) else { continue };
            self.shoves += 1;
            self.speed -= self.speed / 16;
            let pushed = out(level, place, Some(contact))?;
            // A crate that meets another one stays, and the car gives way.
            if others.iter().enumerate().all(|(k, other)| k == i || !other.overlaps(&pushed)) {
                *place = pushed;
            }
            self.body = out(level, &self.body, self.body.contact(place))?;
        }
        if crates.iter().any(|other| other.overlaps(&self.body)) {
            (self.body, self.speed, *crates) = (start, Fx::ZERO, others);
        }
        Ok(())
    }

    /// Turns toward the next mark where there is room.
    fn steer(&mut self, level: &impl World) -> Result<(), MoveError> {
        let mark = |marks: u32| MARKS.get(marks as usize % MARKS.len()).copied().unwrap_or(Vec2::ZERO);
        self.marks += u32::from((mark(self.marks) - self.body.centre()).length() < fx!(36));
        let way = mark(self.marks) - self.body.centre();
        let ahead = Axis::from_turns(self.heading);
        let (side, front) = (ahead.perp().dot_vec(way), ahead.dot_vec(way));
        let steer = if side.abs() > front / 8 { STEER } else { STEER / 6 };
        let heading = self.heading + Fx::from_bits(steer * side.signum() as i32);
        let turned = OrientedBox::new(self.body.centre(), HALF, Axis::from_turns(heading))?;
        if let Ok(body) = turn(level, &self.body, &turned) {
            (self.body, self.heading) = (body, heading);
        }
        Ok(())
    }
}
