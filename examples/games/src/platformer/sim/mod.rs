//! Everything that happens in a frame.

mod actor;
mod bodies;
mod player;
mod rng;
mod start;

use tilesat::Vec2;
use tilesat::world::{ShapeSet, TileMap};

pub use actor::{Actor, Shape};
pub use player::{MAX_COINS, Score};

use player::Player;
use rng::Rng;

/// The player, 16 boxes and 16 balls.
pub const BODIES: usize = 33;
/// Frames of the run whose hash desktop and firmware compare.
pub const FIRMWARE_FRAMES: u32 = 600;
/// The default seed, and the seed of that run. Its player shows every trick on our level.
pub const SEED: u32 = 11;

/// The meaning of the flag bits in this game. 0 if a level has no such tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rules {
    pub coin: u8,
    pub kill: u8,
    pub win: u8,
    pub ladder: u8,
}

/// The level has no free cell for a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoRoom;

/// The results of one frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameReport {
    /// Faces and corners of the level that bodies hit.
    pub contacts: u32,
    /// Motions that the library refused. None are expected.
    pub refused: u32,
    /// Whether the player died and is back at its start.
    pub respawned: bool,
}

/// The whole state of a run is plain data, so a snapshot is a copy.
#[derive(Debug, Clone, Copy)]
pub struct Sim {
    actors: [Actor; BODIES],
    player: Player,
    rng: Rng,
    frame: u32,
    hash: u32,
}

impl Sim {
    /// Puts all bodies at free positions that the seed chooses.
    pub fn new<S: ShapeSet>(map: &TileMap<'_, S>, rules: Rules, seed: u32) -> Result<Self, NoRoom> {
        let mut rng = Rng::new(seed);
        let (player, first) = Player::new(map, rules, &mut rng).ok_or(NoRoom)?;
        let mut actors = [first; BODIES];
        for (i, slot) in actors.iter_mut().enumerate().skip(1) {
            *slot = bodies::start(map, i, &mut rng).ok_or(NoRoom)?;
        }
        // FNV-1a's offset basis.
        Ok(Self { actors, player, rng, frame: 0, hash: 0x811c_9dc5 })
    }

    /// Puts the player's feet at the start that the level gives, before the first frame. Returns
    /// whether there is room for it.
    pub fn start_at<S: ShapeSet>(&mut self, map: &TileMap<'_, S>, feet: Vec2) -> bool {
        let [actor, ..] = &mut self.actors;
        self.player.start_at(map, actor, feet)
    }

    /// Moves every body by one frame.
    pub fn step<S: ShapeSet>(&mut self, map: &TileMap<'_, S>) -> FrameReport {
        let mut report = FrameReport::default();
        for (i, actor) in self.actors.iter_mut().enumerate() {
            if i == 0 {
                self.player.step(map, actor, &mut self.rng, &mut report);
            } else {
                bodies::step(map, actor, i, self.frame, &mut self.rng, &mut report);
            }
        }
        self.frame = self.frame.wrapping_add(1);
        self.fold();
        report
    }

    fn fold(&mut self) {
        for actor in &self.actors {
            let (position, velocity) = (actor.shape.position().raw(), actor.velocity.raw());
            for word in [position.0, position.1, velocity.0, velocity.1] {
                for byte in word.to_le_bytes() {
                    self.hash = (self.hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
                }
            }
        }
    }

    /// FNV-1a over the raw positions and velocities of all bodies after every frame so far.
    pub fn hash(&self) -> u32 {
        self.hash
    }

    /// The player first.
    pub fn bodies(&self) -> &[Actor; BODIES] {
        &self.actors
    }

    /// The player's state.
    pub fn score(&self) -> Score {
        self.player.score()
    }

    /// Whether this coin, counted row by row from 0, is gone.
    pub fn collected(&self, coin: u32) -> bool {
        self.player.collected(coin)
    }
}
