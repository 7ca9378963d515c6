//! The platformer's bodies as on a chip: some frames with the level in flash, and the hash of all
//! of them.

use core::fmt;

use super::{meadow, sim};
use tilesat::{Fx, Grid, Outside, TileMap, TileMapError, Vec2};

/// The result of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    pub frames: u32,
    pub contacts: u32,
    pub refused: u32,
    pub hash: u32,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { frames, contacts, refused, hash } = self;
        let bodies = sim::BODIES;
        write!(f, "frames={frames} bodies={bodies} contacts={contacts} refused={refused} hash={hash:08x}")
    }
}

/// The error if there was no run.
#[derive(Clone, Copy, Debug)]
pub enum Failure {
    Level(TileMapError),
    NoRoom,
}

pub const RULES: sim::Rules =
    sim::Rules { coin: meadow::COIN, kill: meadow::KILL, win: meadow::WIN, ladder: meadow::LADDER };

/// The level in flash, a closed room.
pub fn level() -> Result<TileMap<'static>, TileMapError> {
    let grid = Grid::new(meadow::WIDTH, meadow::HEIGHT, Fx::from_num(meadow::TILE), Vec2::ZERO)?;
    Ok(TileMap::on_grid(meadow::TILES, grid, &meadow::KINDS)?.with_outside(Outside::Solid))
}

/// Runs a number of frames. Calls `each` with every frame's number and report.
pub fn run(frames: u32, mut each: impl FnMut(u32, &sim::FrameReport)) -> Result<Outcome, Failure> {
    let map = level().map_err(Failure::Level)?;
    let mut sim = sim::Sim::new(&map, RULES, sim::SEED).map_err(|sim::NoRoom| Failure::NoRoom)?;
    let (mut contacts, mut refused) = (0, 0);
    for frame in 0..frames {
        let report = sim.step(&map);
        contacts += report.contacts;
        refused += report.refused;
        each(frame, &report);
    }
    Ok(Outcome { frames, contacts, refused, hash: sim.hash() })
}
