//! The events so far, and the hash by which runs are compared.

use core::fmt;
use tilesat::broad::{BroadPhase, Pair, PairEvent};
use tilesat::{Aabb, Filter};

use super::{BODIES, Game, level};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tally {
    pub fired: u32,
    pub bounces: u32,
    /// Bullets that hit the player, and shots that hit an enemy.
    pub hits: u32,
    pub cover: u32,
    pub rammed: u32,
    pub kills: u32,
    pub deaths: u32,
    pub reflected: u32,
    /// The zone: begun and ended contacts, and the lives that it gave.
    pub visits: u32,
    pub left: u32,
    pub repairs: u32,
    /// Bullets without room.
    pub denied: u32,
    /// Events or exceptions that did not fit. None are expected.
    pub crowded: u32,
    /// Motions that the library refused. None are expected.
    pub refused: u32,
    /// The most bodies at once.
    pub most: u32,
    pub hash: u32,
}

/// FNV-1a.
const PRIME: u32 = 0x0100_0193;
/// The hash of nothing, from a game's start on.
pub(super) const BASIS: u32 = 0x811c_9dc5;

fn fold(hash: u32, word: i32) -> u32 {
    word.to_le_bytes().iter().fold(hash, |hash, &byte| (hash ^ u32::from(byte)).wrapping_mul(PRIME))
}

impl Tally {
    pub const NONE: Self = Self {
        fired: 0,
        bounces: 0,
        hits: 0,
        cover: 0,
        rammed: 0,
        kills: 0,
        deaths: 0,
        reflected: 0,
        visits: 0,
        left: 0,
        repairs: 0,
        denied: 0,
        crowded: 0,
        refused: 0,
        most: 0,
        hash: 0,
    };

    pub(super) fn hash_event(&mut self, event: PairEvent) {
        let (kind, Pair { a, b }) = match event {
            PairEvent::Begin(pair) => (1, pair),
            PairEvent::Stay(pair) => (2, pair),
            PairEvent::End(pair) => (3, pair),
        };
        let words = [kind, a.slot() as i32, a.generation().into(), b.slot() as i32, b.generation().into()];
        self.hash = words.into_iter().fold(self.hash, fold);
    }
}

impl<B: BroadPhase<Tag = Filter>> Game<B> {
    /// Adds all positions to the hash. It sums over the bodies, so their order does not matter.
    pub(super) fn fold(&mut self) {
        let Some(all) = level::bounds() else { return };
        let (near, bodies) = (&self.near, &self.bodies);
        let mut sum = 0u32;
        near.in_region(&all, |handle| {
            let bounds = near.bounds(handle).map_or((0, 0), |bounds: Aabb| bounds.min().raw());
            let Some(body) = bodies.get(handle.slot()) else { return };
            let (velocity, state) = (body.velocity.raw(), (body.kind as i32) << 8 | i32::from(body.life));
            let words = [handle.slot() as i32, bounds.0, bounds.1, velocity.0, velocity.1, state];
            sum = sum.wrapping_add(words.into_iter().fold(BASIS, fold));
        });
        self.tally.most = self.tally.most.max(self.near.len() as u32);
        self.tally.hash = fold(self.tally.hash, sum as i32);
    }
}

/// The line that identifies a run.
impl<B> fmt::Display for Game<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Tally {
            fired, bounces, hits, cover, kills, deaths, reflected, visits, most, crowded, refused, hash, ..
        } = self.tally;
        write!(f, "frames={} bodies={most}/{BODIES} fired={fired} bounces={bounces} ", self.frame)?;
        write!(f, "hits={hits} cover={cover} kills={kills} deaths={deaths} reflected={reflected} visits={visits} ")?;
        write!(f, "crowded={crowded} refused={refused} hash={hash:08x}")
    }
}
