//! The game: a walking player, and four machines that carry it, convey it, and can squash it.

use tilesat::{
    Aabb, AllShapes, Axis, Fx, Joined, MoveError, Mover, RangeError, Side, SlopeSpeed, Solid, Solids, TileMap, Vec2,
    Walker,
    motion::{Ride, Support},
};

use super::machine::{BELT, CRUSHER, LIFT, MACHINES, Machine, SHELF};

const MOVER: Mover = Mover::platformer(Axis::NEG_Y);
/// Raw units (1/65536 pixel) per frame, or per frame squared.
const SPEED: i32 = 98_304;
const GRAVITY: i32 = 16_384;
const JUMP: i32 = 262_144;

#[derive(Clone, Copy, Debug, Default)]
pub struct Keys {
    /// -1, 0 or 1.
    pub run: i32,
    pub jump: bool,
    pub drop: bool,
}

#[derive(Clone, Debug)]
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
        let solid = |machine: &Machine, name| Solid::new(boxed(machine.at)?, name);
        let shelf = solid(&SHELF, 2)?.with_one_way(Side::Up);
        let belt = solid(&BELT, 3)?.with_conveyor(Vec2::from_ints(1, 0))?;
        let walker = Walker::new(MOVER).with_slope_speed(SlopeSpeed::Constant);
        Ok(Self {
            level,
            solids: [solid(&LIFT, 0)?, solid(&CRUSHER, 1)?, shelf, belt],
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

    /// Whether a machine has just returned to its start.
    pub fn is_back(&self, machine: &Machine) -> bool {
        machine.phase(self.frame) == (true, machine.way.unsigned_abs().into())
    }

    /// Plays one frame. The machines carry the player and move. Then the player walks among them.
    pub fn step(&mut self, keys: Keys) -> Result<Ride, MoveError> {
        for (solid, machine) in self.solids.iter_mut().zip(&MACHINES) {
            solid.set_motion(machine.motion(self.frame))?;
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
        let jumps = keys.jump && self.floor.is_some();
        if jumps {
            self.velocity = Vec2::from_raw(self.velocity.raw().0, -JUMP);
        }
        let solids = Solids::new(&self.solids);
        let world = Joined::new(&self.level, &solids);
        let walker = self.walker.with_drop_through(keys.drop);
        let walked = walker.walk(&world, &ridden.body, self.velocity, self.floor)?;
        (self.body, self.velocity, self.floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
        if jumps {
            // The ride already made the lift's part of this frame. The player keeps that velocity.
            self.velocity += ridden.carry;
        }
        self.stepped += walked.stepped;
        Ok(ridden.ride)
    }
}
