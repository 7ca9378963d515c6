//! The ninja: how the keys change its velocity. The library does the rest.

use tilesat::{Axis, Circle, Fx, MoveError, Mover, RangeError, Vec2, World, fx};

#[derive(Clone, Copy, Debug, Default)]
pub struct Keys {
    /// -1, 0 or 1.
    pub run: i32,
    pub jump: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Floor,
    Wall,
    Ceiling,
    Air,
}

/// Raw units (1/65536 pixel) per frame, or per frame squared.
pub(super) const GRAVITY: i32 = 4400;
const RISE: i32 = 2000;
const RUN: i32 = 4400;
const FLY: i32 = 2900;
const TOP: i32 = 218_000;
const JUMP: i32 = 170_000;
const SIDE: i32 = 150_000;
const SLIP: i32 = 30_000;
/// A held jump gains height for this many frames.
const HOLD: u32 = 30;

#[derive(Clone, Copy, Debug)]
pub struct Ninja {
    pub body: Circle,
    pub velocity: Vec2,
    pub state: State,
    /// Normals of the surfaces that it stands on or leans against.
    pub normal: Axis,
    pub jumps: u32,
    pub wall_jumps: u32,
    /// Frames since the last contact. Frames since the jump began, while the key is held.
    air: u32,
    held: u32,
    pressed: bool,
}

impl Ninja {
    pub fn new(centre: Vec2) -> Result<Self, RangeError> {
        let body = Circle::new(centre, fx!(6))?;
        Ok(Self {
            body,
            velocity: Vec2::ZERO,
            state: State::Air,
            normal: Axis::NEG_Y,
            jumps: 0,
            wall_jumps: 0,
            air: 0,
            held: 0,
            pressed: false,
        })
    }

    pub fn step(&mut self, world: &impl World, keys: Keys) -> Result<(), MoveError> {
        let wanted = self.steer(keys);
        let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(world, &self.body, wanted)?;
        (self.body, self.velocity) = (moved.body, moved.velocity);
        self.air += 1;
        // A hit of this frame is a contact now. It stays a contact for a few frames, for a late
        // key.
        if let Some(hit) = moved.hits.iter().last() {
            self.normal = hit.axis;
            self.air = 0;
            let state = |is: bool, state| is.then_some(state);
            let found = state(moved.floor, State::Floor).or(state(moved.wall, State::Wall));
            self.state = found.unwrap_or(State::Ceiling);
        } else if self.air > 4 {
            self.state = State::Air;
        }
        Ok(())
    }

    /// The next velocity, from the last one, the keys and gravity.
    fn steer(&mut self, keys: Keys) -> Vec2 {
        let (mut x, mut y) = self.velocity.raw();
        let grounded = self.state == State::Floor;
        if keys.run != 0 && x * keys.run < TOP {
            x += keys.run * if grounded { RUN } else { FLY };
        } else if keys.run == 0 && grounded {
            x -= x / 12;
        }
        let sliding = self.state == State::Wall && keys.run * self.normal.x < 0;
        if sliding && y > SLIP {
            y -= (y - SLIP) / 6;
        }
        let start = keys.jump && !self.pressed && matches!(self.state, State::Floor | State::Wall);
        if start {
            self.jump(&mut x, &mut y);
        }
        self.pressed = keys.jump;
        self.held = if start {
            1
        } else if keys.jump && self.held > 0 {
            self.held + 1
        } else {
            0
        };
        let rising = self.held > 0 && self.held < HOLD && y < 0;
        Vec2::from_raw(x, y + if rising { RISE } else { GRAVITY })
    }

    /// Jumps off a floor along its normal, and off a wall to the side and up.
    fn jump(&mut self, x: &mut i32, y: &mut i32) {
        if self.state == State::Floor {
            let (dx, dy) = self.normal.unit().scaled(Fx::from_bits(JUMP)).raw();
            *x += dx;
            *y = (*y).min(0) + dy;
        } else {
            *x = self.normal.x.signum() * SIDE;
            *y = -JUMP;
            self.wall_jumps += 1;
        }
        self.jumps += 1;
        self.state = State::Air;
    }
}
