//! Random starts from integers alone: equal on every machine.

use crate::room::Room;
use crate::scene::{PX, Point, Scene, Start};
use tilesat_judge::Random;

/// A direction times a speed: a rational point of the circle in a random quadrant.
fn velocity(random: &mut Random, speed: i32) -> Point {
    let (q, t) = (65536_i64, random.below(65537));
    let part = |n: i64| (n * i64::from(speed) / (q * q + t * t)) as i32;
    let quadrant = random.below(4);
    let sign = |bit: i64| if quadrant & bit == 0 { 1 } else { -1 };
    [part(q * q - t * t) * sign(1), part(2 * q * t) * sign(2)]
}

/// `n` starts in the room, at least a pixel from its walls and above `top` (raw) in its bounding
/// box.
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
                let mut between = |lo: i32, hi: i32| random.within(lo.into(), hi.into()) as i32;
                let at = [between(left, right), between(highest.max(top), bottom)];
                if free(&at) {
                    break at;
                }
            };
            Start { centre, velocity: velocity(&mut random, speed) }
        })
        .collect()
}
