//! One of two machines. It plays on without waiting, and corrects the past.
//!
//! ```text
//!   known keys of the other        guessed: the last known ones, held
//!   ------------------------------+- - - - - - - - - - - - - - -+ now
//!                  a packet brings keys up to here:  |
//!                                  ^ the first wrong guess
//!                                    go back to the state before it, and play again up to now
//! ```
//!
//! Correct guesses are not replayed.

use super::{Arena, Game, Keys, Packet, Ring, Saved};
use tilesat::scene::SceneError;

/// A key takes effect this many frames after the press, on both machines. The packet must arrive in
/// this time.
pub const DELAY: u32 = 2;

/// How many frames a machine plays beyond the known keys of the other. Then it waits.
pub const WINDOW: u32 = 16;

/// One machine.
#[derive(Clone, Debug)]
pub struct Peer {
    /// The player who sits there.
    side: usize,
    game: Game,
    /// The next frame that it plays.
    now: u32,
    /// The state before each of the last [`WINDOW`] frames. It never goes back farther.
    states: Ring<Saved, 16>,
    own: Ring<Keys, 128>,
    /// The frame after the last one with final keys of its own player.
    own_end: u32,
    theirs: Ring<Keys, 128>,
    /// The same for the other player, from the packets.
    known: u32,
    /// The other's keys that each frame was played with.
    guesses: Ring<Keys, 16>,
    /// The first frame that was played with wrong keys.
    wrong: Option<u32>,
    /// The frame up to which the other machine knows this one's keys.
    heard: u32,
    /// Replayed frames.
    pub again: u64,
    /// The number of rollbacks.
    pub rollbacks: u64,
    /// Calls in which it had to wait.
    pub waits: u64,
    /// Most frames that were replayed at once.
    pub deepest: u32,
}

impl Peer {
    /// A machine at the start. No keys are down in the first [`DELAY`] frames.
    pub fn new(side: usize) -> Result<Self, SceneError> {
        let game = Game::new()?;
        Ok(Self {
            side,
            states: Ring::new(game.save()),
            game,
            now: 0,
            own: Ring::new(Keys(0)),
            own_end: DELAY,
            theirs: Ring::new(Keys(0)),
            known: DELAY,
            guesses: Ring::new(Keys(0)),
            wrong: None,
            heard: DELAY,
            again: 0,
            rollbacks: 0,
            waits: 0,
            deepest: 0,
        })
    }

    /// The next frame that it plays.
    pub const fn now(&self) -> u32 {
        self.now
    }

    /// The frame up to which nothing can change.
    pub fn confirmed(&self) -> u32 {
        self.known.min(self.now)
    }

    /// The state before one of the last frames.
    pub fn state(&self, frame: u32) -> Saved {
        let kept = self.states.get(frame).filter(|_| frame < self.now);
        kept.copied().unwrap_or_else(|| self.game.save())
    }

    /// Reads a packet: new keys, which may differ from the guess.
    pub fn receive(&mut self, packet: &Packet) {
        self.heard = self.heard.max(packet.known);
        // It arrived before, or too early: a packet between was lost and will come again.
        if packet.first > self.known {
            return;
        }
        for frame in self.known..packet.end {
            let keys = packet.keys.get(frame).copied().unwrap_or_default();
            self.theirs.set(frame, keys);
            if frame < self.now && self.wrong.is_none() && self.guesses.get(frame) != Some(&keys) {
                self.wrong = Some(frame);
            }
        }
        self.known = self.known.max(packet.end);
    }

    /// Rolls back to the first wrong guess, and replays up to now.
    pub fn correct(&mut self, arena: &Arena) -> Result<(), SceneError> {
        let Some(wrong) = self.wrong.take() else { return Ok(()) };
        if let Some(state) = self.states.get(wrong) {
            self.game.load(state);
        }
        for frame in wrong..self.now {
            self.play(arena, frame)?;
        }
        self.again += u64::from(self.now - wrong);
        self.rollbacks += 1;
        self.deepest = self.deepest.max(self.now - wrong);
        Ok(())
    }

    /// Plays the next frame, unless it is too far ahead. `keys` are the keys that the player holds
    /// now.
    pub fn advance(&mut self, arena: &Arena, keys: Keys) -> Result<(), SceneError> {
        if self.now >= self.known + WINDOW {
            self.waits += 1;
            return Ok(());
        }
        self.own.set(self.own_end, keys);
        self.own_end += 1;
        self.play(arena, self.now)?;
        self.now += 1;
        Ok(())
    }

    /// All keys that the other machine may not have yet.
    pub fn packet(&self) -> Packet {
        let mut packet = Packet { first: self.heard, end: self.own_end, known: self.known, keys: Ring::new(Keys(0)) };
        for frame in packet.first..packet.end {
            packet.keys.set(frame, self.own.get(frame).copied().unwrap_or_default());
        }
        packet
    }

    fn play(&mut self, arena: &Arena, frame: u32) -> Result<(), SceneError> {
        self.states.set(frame, self.game.save());
        let own = self.own.get(frame).copied().unwrap_or_default();
        let theirs = self.theirs.get(frame.min(self.known - 1)).copied().unwrap_or_default();
        self.guesses.set(frame, theirs);
        self.game.step(arena, if self.side == 0 { [own, theirs] } else { [theirs, own] })
    }
}
