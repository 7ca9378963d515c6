//! Computes how many frames a machine had to replay. Uses only the deliveries and the players'
//! scripts, and never looks at the machine.

use super::{DELAY, Keys, Packet, Ring};

/// The account of one machine.
#[derive(Clone, Copy, Debug)]
pub struct Ledger {
    /// The real keys of the other player.
    truth: fn(u32) -> Keys,
    /// Everything up to here was delivered, without a gap.
    delivered: u32,
    before: u32,
    /// The keys with which each frame was last played.
    played: Ring<Keys, 128>,
    /// The number of frames that had to be replayed.
    pub needed: u64,
}

impl Ledger {
    pub fn new(truth: fn(u32) -> Keys) -> Self {
        Self { truth, delivered: DELAY, before: DELAY, played: Ring::new(Keys(0)), needed: 0 }
    }

    /// The best guess of the keys, from the deliveries so far.
    fn best(&self, frame: u32) -> Keys {
        (self.truth)(frame.min(self.delivered - 1))
    }

    pub fn delivered(&mut self, packet: &Packet) {
        if packet.first <= self.delivered {
            self.delivered = self.delivered.max(packet.end);
        }
    }

    /// Applies all deliveries to the frames before `now`.
    pub fn correct(&mut self, now: u32) {
        let news = self.before..self.delivered.min(now);
        let wrong = news.into_iter().find(|&frame| self.played.get(frame) != Some(&(self.truth)(frame)));
        for frame in wrong.unwrap_or(now)..now {
            self.played.set(frame, self.best(frame));
            self.needed += 1;
        }
        self.before = self.delivered;
    }

    /// Notes the first play of a frame.
    pub fn played(&mut self, frame: u32) {
        self.played.set(frame, self.best(frame));
    }
}
