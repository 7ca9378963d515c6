//! A race seen from above: a car that turns and shoves crates, and a marshal behind a turnstile.

mod car;
mod track;

pub use car::Car;
pub use track::{SIZE, track};

use tilesat::motion::turn;
use tilesat::prelude::*;
use tilesat::query::Contact;
use tilesat::{Axis, Body, Capsule, Fx, MoveError, Mover, OrientedBox, RangeError, Vec2, World, fx};

/// The part of a turn that the turnstile makes per frame.
const SPIN: Fx = fx!(0.004);
const WALK: Fx = fx!(0.8);
/// Half the length and width of the turnstile.
const PLANK: Vec2 = Vec2::from_ints(14, 2);
/// The ends of the marshal's round, on both sides of the turnstile.
const ENDS: [Vec2; 2] = [Vec2::from_ints(240, 180), Vec2::from_ints(240, 108)];

#[derive(Clone, Copy, Debug)]
pub struct Race {
    pub car: Car,
    pub marshal: Capsule,
    pub plank: OrientedBox,
    pub crates: [OrientedBox; 3],
    /// The frames in which the turnstile moved the marshal.
    pub moved: u32,
    /// How often the marshal came to an end of its round.
    pub rounds: u32,
    spin: Fx,
}

impl Race {
    pub fn new() -> Result<Self, RangeError> {
        let boxed = |x, y, direction| OrientedBox::new(Vec2::from_ints(x, y), Vec2::from_ints(7, 5), direction);
        let (head, feet) = (Vec2::from_ints(240, 105), Vec2::from_ints(240, 111));
        Ok(Self {
            car: Car::new(Vec2::from_ints(60, 56))?,
            marshal: Capsule::new(head, feet, fx!(4))?,
            plank: OrientedBox::new(Vec2::from_ints(240, 144), PLANK, Axis::X)?,
            crates: [
                boxed(200, 60, Axis::new(3, 4))?,
                boxed(416, 150, Axis::new(1, 2))?,
                boxed(260, 236, Axis::new(-5, 12))?,
            ],
            moved: 0,
            rounds: 0,
            spin: Fx::ZERO,
        })
    }

    pub fn step(&mut self, level: &impl World) -> Result<(), MoveError> {
        self.spin_turnstile(level)?;
        self.walk(level)?;
        self.car.step(level, &mut self.crates)
    }

    /// Turns the turnstile, which moves the marshal out of its way or waits.
    fn spin_turnstile(&mut self, level: &impl World) -> Result<(), MoveError> {
        let spin = self.spin + SPIN;
        let next = OrientedBox::new(self.plank.centre(), PLANK, Axis::from_turns(spin))?;
        let marshal = out(level, &self.marshal, self.marshal.contact(&next))?;
        if let Ok(plank) = turn(level, &self.plank, &next)
            && !marshal.overlaps(&plank)
        {
            self.moved += u32::from(marshal != self.marshal);
            (self.plank, self.marshal, self.spin) = (plank, marshal, spin);
        }
        Ok(())
    }

    /// Walks to an end of the round, around the turnstile or along it.
    fn walk(&mut self, level: &impl World) -> Result<(), MoveError> {
        let [far, near] = ENDS;
        let way = if self.rounds & 1 == 0 { far } else { near } - self.marshal.a();
        if way.length() < fx!(3) {
            self.rounds += 1;
            return Ok(());
        }
        let (x, y) = way.raw();
        let walked = Mover::new().move_and_slide(level, &self.marshal, Axis::new(x, y).unit().scaled(WALK))?.body;
        let walked = out(level, &walked, walked.contact(&self.plank))?;
        if !walked.overlaps(&self.plank) {
            self.marshal = walked;
        }
        Ok(())
    }
}

/// A body pushed out of a contact, as far as the level allows.
fn out<B: Body>(level: &impl World, body: &B, contact: Option<Contact>) -> Result<B, MoveError> {
    let push = contact.map_or(Vec2::ZERO, |contact| contact.push_out());
    Ok(Mover::new().move_and_slide(level, body, push)?.body)
}
