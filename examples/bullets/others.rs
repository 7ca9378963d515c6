//! The same game on every other broad phase.

use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SpatialHash};
use tilesat::{Filter, Fx, Vec2};
use tilesat_games::bullets::{BODIES, Game, Level};
use tilesat_tools::fail::{Fail, Result};

/// 16 x 8 cells of 64 units.
type Grid = LooseGrid<4, BODIES, Filter>;
/// Cells of 32 units. The zone is larger.
type Hash = SpatialHash<256, BODIES, Filter, true>;

pub struct Others {
    brute: Game<BruteForce<BODIES, Filter>>,
    grid: Game<Grid>,
    hash: Game<Hash>,
}

impl Others {
    pub fn new() -> Result<Self> {
        let grid = Grid::new(Vec2::ZERO, Fx::from_num(64), 16).map_err(|e| Fail::new(e.to_string()))?;
        let hash = Hash::new(Fx::from_num(32)).map_err(|e| Fail::new(e.to_string()))?;
        let mut all = Self { brute: Game::new(BruteForce::new()), grid: Game::new(grid), hash: Game::new(hash) };
        all.brute.start();
        all.grid.start();
        all.hash.start();
        Ok(all)
    }

    /// Plays one frame, to the same hash.
    pub fn step(&mut self, level: &Level, game: &Game) -> std::result::Result<(), String> {
        fn same<B: BroadPhase<Tag = Filter>>(
            name: &str,
            other: &mut Game<B>,
            level: &Level,
            game: &Game,
        ) -> std::result::Result<(), String> {
            other.step(level);
            if other.tally == game.tally { Ok(()) } else { Err(format!("the game differs with {name}: {other}")) }
        }
        same("brute force", &mut self.brute, level, game)?;
        same("a loose grid", &mut self.grid, level, game)?;
        same("a spatial hash", &mut self.hash, level, game)
    }
}
