//! A link that loses and doubles packets, and delays each by a different time, so that it reorders
//! them.

use super::keys::mix;
use super::{Keys, Ring};
use tilesat::heapless::Vec;

/// Most packets in flight. It loses more.
const UNDER_WAY: usize = 64;

/// The keys of some frames, and the frame up to which the sender knows the other side's keys.
#[derive(Clone, Copy, Debug)]
pub struct Packet {
    /// The frame of the first keys.
    pub first: u32,
    /// The frame after the last ones.
    pub end: u32,
    /// The frame up to which the sender knows the receiver's keys.
    pub known: u32,
    pub keys: Ring<Keys, 64>,
}

/// The faults of a link. Shares are percentages.
#[derive(Clone, Copy, Debug)]
pub struct Weather {
    pub loss: u64,
    pub doubled: u64,
    /// The least and the greatest delay, in frames.
    pub least: u32,
    pub most: u32,
}

/// One direction of a link.
#[derive(Clone, Debug)]
pub struct Link {
    weather: Weather,
    seed: u64,
    under_way: Vec<(u32, Packet), UNDER_WAY>,
    pub sent: u32,
    pub lost: u32,
    pub doubled: u32,
    /// Packets delivered after one that was sent later.
    pub overtaken: u32,
    newest: u32,
}

impl Link {
    pub const fn new(weather: Weather, seed: u64) -> Self {
        Self { weather, seed, under_way: Vec::new(), sent: 0, lost: 0, doubled: 0, overtaken: 0, newest: 0 }
    }

    /// A random number below another one.
    fn below(&mut self, n: u64) -> u64 {
        self.seed = mix(self.seed);
        self.seed % n.max(1)
    }

    /// Sends a packet, or loses it.
    pub fn send(&mut self, now: u32, packet: &Packet) {
        self.sent += 1;
        if self.below(100) < self.weather.loss {
            self.lost += 1;
            return;
        }
        let twice = self.below(100) < self.weather.doubled;
        self.doubled += u32::from(twice);
        for _ in 0..=u32::from(twice) {
            let Weather { least, most, .. } = self.weather;
            let due = now + least + self.below(u64::from(most.saturating_sub(least)) + 1) as u32;
            self.lost += u32::from(self.under_way.push((due, *packet)).is_err());
        }
    }

    /// A packet that is due, in any order. `None` if no more are due.
    pub fn receive(&mut self, now: u32) -> Option<Packet> {
        let at = self.under_way.iter().position(|(due, _)| *due <= now)?;
        let (_, packet) = self.under_way.swap_remove(at);
        self.overtaken += u32::from(packet.end < self.newest);
        self.newest = self.newest.max(packet.end);
        Some(packet)
    }
}
