//! Two flippers: planks that turn around a pin, up in four frames, and down again.

use tilesat::motion::Ride;
use tilesat::world::{ConvexSolid, ConvexSolids};
use tilesat::{Axis, Fx, MoveError, Mover, OrientedBox, RangeError, Vec2, World, fx};

use super::Ball;

/// The flags of a flipper, for hits.
pub const FLIPPER: u8 = 4;
const PINS: [Vec2; 2] = [Vec2::from_ints(92, 446), Vec2::from_ints(260, 446)];
/// Half of a flipper's length.
const REACH: Fx = fx!(28);
const HALF: Vec2 = Vec2::from_ints(28, 3);
/// The directions of the left one, from the lowest to the highest.
const DIRECTIONS: [Axis; 5] =
    [Axis::new(40, 14), Axis::new(40, 5), Axis::new(40, -4), Axis::new(40, -12), Axis::new(40, -20)];
/// The right one flips half a period later.
const PERIOD: u32 = 48;

/// The flippers, and the frame.
#[derive(Clone, Copy, Debug)]
pub struct Flippers {
    list: [ConvexSolid<OrientedBox>; 2],
    frame: u32,
}

impl Flippers {
    pub fn new() -> Result<Self, RangeError> {
        let rest = |side: usize| Ok(ConvexSolid::new(plank(side, 0)?, side as u16)?.with_flags(FLIPPER));
        Ok(Self { list: [rest(0)?, rest(1)?], frame: 0 })
    }

    /// As a level.
    pub fn level(&self) -> ConvexSolids<'_, OrientedBox> {
        ConvexSolids::new(&self.list)
    }

    /// Turns both, and the balls give way. If one cannot, the flippers wait.
    pub fn step<const N: usize>(&mut self, table: &impl World, balls: &mut [Ball; N]) -> Result<(), MoveError> {
        let mut turned = self.list;
        for (side, solid) in turned.iter_mut().enumerate() {
            *solid = solid.with_turn(plank(side, height(self.frame + side as u32 * PERIOD / 2))?)?;
        }
        let rides = balls.each_ref().map(|ball| Mover::new().ride_convex(table, &turned, &ball.body, Fx::ZERO));
        for ridden in rides {
            if matches!(ridden?.ride, Ride::Squashed { .. }) {
                return Ok(());
            }
        }
        for (ball, ridden) in balls.iter_mut().zip(rides) {
            ball.give_way(&ridden?);
        }
        (self.list, self.frame) = (turned.map(ConvexSolid::moved), self.frame + 1);
        Ok(())
    }
}

/// How far up a flipper is in a frame.
const fn height(frame: u32) -> usize {
    match frame % PERIOD {
        up @ 0..4 => up as usize + 1,
        4..10 => 4,
        down @ 10..14 => 13 - down as usize,
        _ => 0,
    }
}

/// A flipper's shape.
fn plank(side: usize, height: usize) -> Result<OrientedBox, RangeError> {
    let left = DIRECTIONS.get(height).copied().unwrap_or(Axis::X);
    let direction = if side == 0 { left } else { Axis::new(-left.x, left.y) };
    let pin = PINS.get(side).copied().unwrap_or(Vec2::ZERO);
    OrientedBox::new(pin + direction.unit().scaled(REACH), HALF, direction)
}
