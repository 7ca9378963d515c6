//! How many frames a machine had to play again: from what was delivered and from the players'
//! scripts alone, without a look at the machine.

use super::{DELAY, Keys, Packet, Ring};

/// The account of one machine.
#[derive(Clone, Copy, Debug)]
pub struct Ledger {
    /// The real keys of the other player.
    truth: fn(u32) -> Keys,
    /// Delivered up to here, without a gap.
    delivered: u32,
    before: u32,
    /// What each frame was played with at last.
    played: Ring<Keys, 128>,
    /// How many frames had to be played again.
    pub needed: u64,
}

impl Ledger {
    pub fn new(truth: fn(u32) -> Keys) -> Self {
        Self { truth, delivered: DELAY, before: DELAY, played: Ring::new(Keys(0)), needed: 0 }
    }

    /// The keys that are the best guess, by what was delivered.
    fn best(&self, frame: u32) -> Keys {
        (self.truth)(frame.min(self.delivered - 1))
    }

    pub fn delivered(&mut self, packet: &Packet) {
        if packet.first <= self.delivered {
            self.delivered = self.delivered.max(packet.end);
        }
    }

    /// All that was delivered counts now, for frames before `now`.
    pub fn correct(&mut self, now: u32) {
        let news = self.before..self.delivered.min(now);
        let wrong = news.into_iter().find(|&frame| self.played.get(frame) != Some(&(self.truth)(frame)));
        for frame in wrong.unwrap_or(now)..now {
            self.played.set(frame, self.best(frame));
            self.needed += 1;
        }
        self.before = self.delivered;
    }

    /// A frame is played for the first time.
    pub fn played(&mut self, frame: u32) {
        self.played.set(frame, self.best(frame));
    }
}
