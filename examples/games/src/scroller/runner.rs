//! The runner. It runs to the right, over every obstacle, from room to room.

use core::fmt;
use tilesat::{Aabb, AllShapes, Axis, MoveError, Mover, Room, Rooms, Vec2, Walker, fx, motion::Support};

use super::world::{CELL, WIDTH};

/// Raw units per frame, or per frame squared.
const SPEED: i32 = 163_840;
const GRAVITY: i32 = 16_384;
const JUMP: i32 = 327_680;

/// The result of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    pub frames: u32,
    pub jumps: u32,
    /// The distance in whole pixels of the world.
    pub pixels: u32,
    /// A hash of all its positions in the world.
    pub hash: u32,
}

#[derive(Clone, Debug)]
pub struct Runner<'a> {
    pub room: Room<'a>,
    /// In coordinates of the room.
    pub body: Aabb,
    velocity: Vec2,
    floor: Option<Support>,
    walker: Walker,
    pub outcome: Outcome,
    /// The number of crossings into another room.
    pub rooms: u32,
}

impl<'a> Runner<'a> {
    /// Starts in the first room. `None` in a world without one.
    pub fn new(world: &Rooms<'a, AllShapes>) -> Result<Option<Self>, MoveError> {
        let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_step(fx!(6))?.with_snap(fx!(6))?;
        let body = Aabb::new(Vec2::from_ints(8, 60), Vec2::from_ints(18, 74))?;
        Ok(world.room(0, 0).map(|room| Self {
            room,
            body,
            velocity: Vec2::ZERO,
            floor: None,
            walker,
            outcome: Outcome::default(),
            rooms: 0,
        }))
    }

    /// Its position in the world, in raw units. They exceed the range of a coordinate.
    pub fn place(&self) -> (i64, i64) {
        let (x, y) = self.body.min().raw();
        let cell = i64::from(CELL.to_bits());
        let (column, row) = self.room.first();
        (i64::from(column) * cell + i64::from(x), i64::from(row) * cell + i64::from(y))
    }

    /// Whether it is in the last cells of the world.
    pub fn has_arrived(&self) -> bool {
        self.place().0 >= (i64::from(WIDTH) - 2) * i64::from(CELL.to_bits())
    }

    /// Moves for one frame: it runs, and jumps at obstacles.
    pub fn step(&mut self, world: &Rooms<'a, AllShapes>) -> Result<(), MoveError> {
        self.velocity = Vec2::from_raw(SPEED, self.velocity.raw().1 + GRAVITY);
        let walked = self.walker.walk(self.room.map(), &self.body, self.velocity, self.floor)?;
        (self.body, self.velocity, self.floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
        if walked.moved.wall && self.floor.is_some() {
            self.velocity = Vec2::from_raw(0, -JUMP);
            self.floor = None;
            self.outcome.jumps += 1;
        }
        // Crosses the border: the same position in other coordinates.
        if let Some((room, by)) = world.next(&self.room, self.body.min()) {
            (self.room, self.body) = (room, self.body.translated(by)?);
            self.rooms += 1;
        }
        let (x, y) = self.place();
        self.outcome.frames += 1;
        self.outcome.pixels = (x >> 16) as u32;
        self.outcome.hash = (self.outcome.hash ^ x as u32 ^ (y as u32).rotate_left(16)).wrapping_mul(0x0100_0193);
        Ok(())
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { frames, jumps, pixels, hash } = self;
        write!(f, "frames={frames} jumps={jumps} pixels={pixels} hash={hash:08X}")
    }
}
