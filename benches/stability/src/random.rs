//! Random starts, from integers alone, so that they are the same everywhere.

use crate::room::Room;
use crate::scene::{PX, Point, Scene, Start};

/// `SplitMix64`.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// 0 to n - 1.
    fn below(&mut self, n: u64) -> u64 {
        ((u128::from(self.next()) * u128::from(n)) >> 64) as u64
    }

    /// lo to hi, both included.
    pub fn between(&mut self, lo: i32, hi: i32) -> i32 {
        lo + self.below((hi - lo) as u64 + 1) as i32
    }

    /// A direction times a speed: a rational point of the circle in a random quadrant.
    pub fn velocity(&mut self, speed: i32) -> Point {
        let (q, t) = (65536_i64, self.below(65537) as i64);
        let part = |n: i64| (n * i64::from(speed) / (q * q + t * t)) as i32;
        let quadrant = self.below(4);
        let sign = |bit: u64| if quadrant & bit == 0 { 1 } else { -1 };
        [part(q * q - t * t) * sign(1), part(2 * q * t) * sign(2)]
    }
}

/// `n` starts in the room, at least a pixel from its walls, in the part of its bounding box below `top` (raw).
pub fn starts(scene: &Scene, seed: u64, n: usize, top: i32, speed: i32) -> Vec<Start> {
    let mut random = Random::new(seed);
    let room = Room::new(scene);
    let range = |i: usize| {
        let values = || scene.room.iter().map(|p| p[i]);
        (values().min().unwrap_or(0), values().max().unwrap_or(0))
    };
    let ((left, right), (highest, bottom)) = (range(0), range(1));
    let free = |centre: &Point| room.depth(centre.map(|c| f64::from(c) / f64::from(PX))) < -1.0;
    (0..n)
        .map(|_| {
            let centre = loop {
                let at = [random.between(left, right), random.between(highest.max(top), bottom)];
                if free(&at) {
                    break at;
                }
            };
            Start { centre, velocity: random.velocity(speed) }
        })
        .collect()
}
