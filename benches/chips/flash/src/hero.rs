//! Shared code of the hero programs: a level of 8 x 5 tiles, keys and a lift.

use super::port;
use tilesat::{
    Aabb, Character, Feel, Grid, Input, Solid, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2, fx,
};

use tilesat::world::ShapeSet;

static BLOCKS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL).with(2, TileKind::ONE_WAY_UP);
static SLOPES: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::ONE_WAY_UP)
    .with(3, TileKind::of(TileShape::SlopeBottomRight));
static TILES: [u8; 40] = [
    0, 0, 0, 0, 0, 0, 0, 0, //
    0, 0, 0, 0, 0, 2, 2, 0, //
    0, 0, 2, 2, 0, 0, 0, 0, //
    0, 0, 0, 0, 0, 0, 0, 3, //
    1, 1, 1, 1, 1, 1, 1, 1, //
];

/// The level, with a ramp if the set has one.
#[inline(always)]
pub fn level<S: ShapeSet>() -> Result<TileMap<'static, S>, TileMapError> {
    let grid = const {
        match Grid::new(8, 5, fx!(16), Vec2::ZERO) {
            Ok(grid) => grid,
            Err(_) => panic!("the grid"),
        }
    };
    let slopes = S::SHAPES >> TileShape::SlopeBottomRight as u64 & 1 != 0;
    TileMap::of(&TILES, grid, if slopes { &SLOPES } else { &BLOCKS })
}

/// A hero of ten by fourteen units.
#[inline(always)]
pub fn begin() -> Option<Character> {
    let body = Aabb::new(Vec2::from_ints(20, 20), Vec2::from_ints(30, 34)).ok()?;
    let limits = Aabb::new(Vec2::ZERO, Vec2::from_ints(128, 80)).ok()?;
    Some(Character::new(body, limits, Feel::DEFAULT))
}

/// Two keys for running, one for jumping, one for dropping.
#[inline(always)]
pub fn input() -> Input {
    let keys = port();
    let run = match keys & 3 {
        1 => fx!(2),
        2 => fx!(-2),
        _ => fx!(0),
    };
    Input { run, jump: keys & 4 != 0, drop: keys & 8 != 0 }
}

/// A lift of two cells.
#[inline(always)]
pub fn lift() -> Option<[Solid; 1]> {
    let shape = Aabb::new(Vec2::from_ints(64, 40), Vec2::from_ints(96, 48)).ok()?;
    Some([Solid::new(shape, 1).ok()?])
}

/// Moves the lift for this frame: up while the port says so, else down.
#[inline(always)]
pub fn moved([lift]: [Solid; 1]) -> [Solid; 1] {
    let by = if port() & 16 == 0 { Vec2::from_ints(0, 1) } else { Vec2::from_ints(0, -1) };
    [lift.with_motion(by).unwrap_or(lift)]
}
