//! The game: a player that walks, and four machines that carry it, convey it, and would squash it.

use tilesat::{
    Aabb, AllShapes, Axis, Fx, Joined, MoveError, Mover, RangeError, Ride, Side, SlopeSpeed, Solid, Solids, Support,
    TileMap, Vec2, Walker,
};

pub const LIFT: usize = 0;
pub const CRUSHER: usize = 1;
pub const SHELF: usize = 2;
const BELT: usize = 3;

const MOVER: Mover = Mover::platformer(Axis::NEG_Y);
/// Raw units (1/65536 pixel) a frame, or a frame squared.
const SPEED: i32 = 98_304;
const GRAVITY: i32 = 16_384;
const JUMP: i32 = 262_144;

/// A machine's box in pixels, how far it goes down or up (negative) and back, a pixel a frame, and how long it rests at both ends.
pub struct Machine {
    pub at: [i16; 4],
    pub way: i16,
    rest: u32,
}

pub const MACHINES: [Machine; 4] = [
    Machine { at: [544, 208, 592, 216], way: -96, rest: 60 },
    Machine { at: [448, 144, 480, 184], way: 20, rest: 56 },
    Machine { at: [704, 96, 752, 102], way: -64, rest: 40 },
    Machine { at: [272, 208, 368, 216], way: 0, rest: 1 },
];

impl Machine {
    /// Whether it is on its way back in this frame, and since when it is on its way or at the end of it.
    fn phase(&self, frame: u32) -> (bool, u32) {
        let half = u32::from(self.way.unsigned_abs()) + self.rest;
        (frame / half % 2 == 1, frame % half)
    }

    fn motion(&self, frame: u32) -> Vec2 {
        let (back, time) = self.phase(frame);
        let goes = time < u32::from(self.way.unsigned_abs());
        Vec2::from_ints(0, if goes { self.way.signum() * if back { -1 } else { 1 } } else { 0 })
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Keys {
    /// -1, 0 or 1.
    pub run: i32,
    pub jump: bool,
    pub drop: bool,
}

pub struct Game {
    pub level: TileMap<'static, AllShapes>,
    pub solids: [Solid; 4],
    pub body: Aabb,
    pub floor: Option<Support>,
    velocity: Vec2,
    walker: Walker,
    frame: u32,
    pub stepped: Fx,
    pub carried: u32,
}

impl Game {
    pub fn new(level: TileMap<'static, AllShapes>, feet: (i16, i16)) -> Result<Self, RangeError> {
        let boxed = |[x0, y0, x1, y1]: [i16; 4]| Aabb::new(Vec2::from_ints(x0, y0), Vec2::from_ints(x1, y1));
        let solid = |k: usize| Solid::new(boxed(MACHINES[k].at)?, k as u16);
        let shelf = solid(SHELF)?.with_one_way(Side::Up);
        let belt = solid(BELT)?.with_conveyor(Vec2::from_ints(1, 0))?;
        let walker = Walker::new(MOVER).with_slope_speed(SlopeSpeed::Constant);
        Ok(Self {
            level,
            solids: [solid(LIFT)?, solid(CRUSHER)?, shelf, belt],
            body: boxed([feet.0 - 5, feet.1 - 14, feet.0 + 5, feet.1])?,
            floor: None,
            velocity: Vec2::ZERO,
            walker: walker.with_snap(Fx::from_num(8))?.with_step(Fx::from_num(8))?,
            frame: 0,
            stepped: Fx::ZERO,
            carried: 0,
        })
    }

    pub fn at(&self) -> Vec2 {
        self.body.centre()
    }

    /// Whether a machine has just come back to where it began.
    pub fn is_back(&self, machine: usize) -> bool {
        let way = MACHINES[machine].way.unsigned_abs();
        MACHINES[machine].phase(self.frame) == (true, way.into())
    }

    /// One frame: the machines take the player along, and are moved; then the player walks among them.
    pub fn step(&mut self, keys: Keys) -> Result<Ride, MoveError> {
        for (solid, machine) in self.solids.iter_mut().zip(&MACHINES) {
            *solid = solid.with_motion(machine.motion(self.frame))?;
        }
        self.frame += 1;
        let mover = MOVER.with_drop_through(keys.drop);
        let ridden = mover.ride(&self.level, &self.solids, &self.body, Fx::from_num(2))?;
        self.carried += u32::from(ridden.ride == Ride::Carried);
        Solid::move_all(&mut self.solids);
        if let Ride::Squashed { .. } = ridden.ride {
            return Ok(ridden.ride); // the end of the game
        }

        self.velocity = Vec2::from_raw(keys.run * SPEED, self.velocity.raw().1 + GRAVITY);
        if keys.jump && self.floor.is_some() {
            // Off a lift with what the lift gave it.
            self.velocity = Vec2::from_raw(self.velocity.raw().0, -JUMP) + ridden.carry;
        }
        let solids = Solids::new(&self.solids);
        let world = Joined::new(&self.level, &solids);
        let walker = self.walker.with_drop_through(keys.drop);
        let walked = walker.walk(&world, &ridden.body, self.velocity, self.floor)?;
        (self.body, self.velocity, self.floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
        self.stepped += walked.stepped;
        Ok(ridden.ride)
    }
}
