//! Boxes and balls that fall, slide and bounce without end.

use tilesat::{Aabb, Axis, Circle, Fx, MoveError, Mover, Response, Vec2};

use crate::level::{HEIGHT, Level, WIDTH};

/// The most bodies in a game.
pub const MOST: usize = 64;
/// Half extents of boxes and radii of balls, in units.
pub const BOXES: [(i16, i16); 4] = [(4, 4), (6, 5), (5, 7), (3, 7)];
pub const BALLS: [i16; 4] = [3, 5, 6, 7];

/// Raw units (1/65536 unit) per frame, or per frame squared.
const GRAVITY: i32 = 9_000;
const TOP: i32 = 400_000;
/// A body gets a push every so many frames, so none sleeps.
const KICK: u32 = 128;

#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Box(Aabb),
    Ball(Circle),
}

#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub shape: Shape,
    velocity: Vec2,
    response: Response,
}

const NOBODY: Body = match Circle::new(Vec2::ZERO, Fx::ZERO) {
    Ok(point) => Body { shape: Shape::Ball(point), velocity: Vec2::ZERO, response: Response::Slide },
    Err(_) => panic!(),
};

#[derive(Clone, Copy, Debug)]
pub struct Crowd {
    bodies: [Body; MOST],
    count: usize,
    frame: u32,
    random: u32,
}

impl Crowd {
    /// An entry without a body. As a constant, the stack holds it only once.
    pub const EMPTY: Self = Self { bodies: [NOBODY; MOST], count: 0, frame: 0, random: 1 };

    /// A number of bodies, boxes and balls in turn, at free positions. `None` if there are too few
    /// positions.
    pub fn fill(&mut self, level: &Level, count: usize) -> Option<()> {
        for i in 0..count.min(MOST) {
            let shape = (0..1000).find_map(|_| self.place(level, i))?;
            // Every second box and every second ball bounces.
            let response = if i & 2 == 0 { Response::Slide } else { Response::Bounce };
            *self.bodies.get_mut(i)? = Body { shape, velocity: self.push(), response };
            self.count = i + 1;
        }
        Some(())
    }

    pub fn bodies(&self) -> &[Body] {
        self.bodies.get(..self.count).unwrap_or_default()
    }

    /// Moves all of them by one frame.
    pub fn step(&mut self, level: &Level) -> Result<(), MoveError> {
        for i in 0..self.count {
            let kick = (self.frame + i as u32 * 37).is_multiple_of(KICK).then(|| self.push());
            if let Some(body) = self.bodies.get_mut(i) {
                let (x, y) = body.velocity.raw();
                body.velocity = kick.unwrap_or(Vec2::from_raw(x, (y + GRAVITY).min(TOP)));
                body.step(level)?;
            }
        }
        self.frame += 1;
        Ok(())
    }

    /// FNV-1a over all positions and velocities.
    pub fn hash(&self, hash: u32) -> u32 {
        let words = self.bodies().iter().flat_map(|body| {
            let ((x, y), (vx, vy)) = (body.shape.centre().raw(), body.velocity.raw());
            [x, y, vx, vy]
        });
        words.flat_map(i32::to_le_bytes).fold(hash, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    }

    fn place(&mut self, level: &Level, i: usize) -> Option<Shape> {
        let x = self.below(WIDTH as u32 * 16) as i16;
        let y = self.below(HEIGHT as u32 * 16) as i16;
        let centre = Vec2::from_ints(x, y);
        let shape = if i & 1 == 0 {
            let (w, h) = BOXES[i / 2 % 4];
            Shape::Box(Aabb::from_centre(centre, Vec2::from_ints(w, h)).ok()?)
        } else {
            Shape::Ball(Circle::new(centre, Fx::from_num(BALLS[i / 2 % 4])).ok()?)
        };
        let free = match &shape {
            Shape::Box(aabb) => !level.overlaps(aabb),
            Shape::Ball(circle) => !level.overlaps(circle),
        };
        free.then_some(shape)
    }

    /// Up and to a side.
    fn push(&mut self) -> Vec2 {
        let (x, y) = (self.below(300_000) as i32, self.below(350_000) as i32);
        Vec2::from_raw(x - 150_000, -y)
    }

    /// Marsaglia's xorshift, from 0 to `n - 1`.
    fn below(&mut self, n: u32) -> u32 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 17;
        self.random ^= self.random << 5;
        ((u64::from(self.random) * u64::from(n)) >> 32) as u32
    }
}

impl Shape {
    pub fn centre(&self) -> Vec2 {
        match self {
            Self::Box(aabb) => aabb.centre(),
            Self::Ball(circle) => circle.centre(),
        }
    }
}

impl Body {
    #[inline(never)]
    fn step(&mut self, level: &Level) -> Result<(), MoveError> {
        let mover = Mover::platformer(Axis::NEG_Y).with_response(self.response);
        match &mut self.shape {
            Shape::Box(aabb) => {
                let moved = mover.move_and_slide(level, aabb, self.velocity)?;
                (*aabb, self.velocity) = (moved.body, moved.velocity);
            }
            Shape::Ball(circle) => {
                let moved = mover.move_and_slide(level, circle, self.velocity)?;
                (*circle, self.velocity) = (moved.body, moved.velocity);
            }
        }
        Ok(())
    }
}
