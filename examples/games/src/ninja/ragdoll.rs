//! The ninja's ragdoll after a mine goes off: six points joined by sticks.
//!
//! ```text
//!      0        0 shoulders, 1 hip
//!    / | \      2, 3 hands: on ropes, so that arms fold
//!   2  |  3
//!      1        4, 5 feet
//!     / \
//!    4   5
//! ```

use tilesat::motion::response::{Link, Particle, Quiet, Stick};
use tilesat::{Fx, RangeError, Vec2, fx};

use super::runner::Ninja;
use super::sticks::Sticks;

/// All points start inside the ninja.
const RADIUS: Fx = fx!(1.5);
/// Relative to the ninja's centre, in raw units (1/65536 pixel).
const POINTS: [(i32, i32); 6] =
    [(0, -262_144), (0, 32_768), (-196_608, -98_304), (196_608, -98_304), (-131_072, 262_144), (131_072, 262_144)];
/// The velocity that the mine adds to each point.
const BLAST: [(i32, i32); 6] = [
    (20_000, -330_000),
    (0, -280_000),
    (-90_000, -300_000),
    (120_000, -360_000),
    (-60_000, -220_000),
    (80_000, -240_000),
];
const BONES: [(u8, u8, Bend); 5] =
    [(0, 2, Bend::Folds), (0, 3, Bend::Folds), (1, 4, Bend::Stiff), (1, 5, Bend::Stiff), (0, 1, Bend::Stiff)];

#[derive(Clone, Copy)]
enum Bend {
    Stiff,
    Folds,
}

/// The limbs of a ninja, with its velocity and the blast.
pub fn ragdoll(ninja: &Ninja) -> Result<Sticks<6, 5>, RangeError> {
    let at = |k: u8| POINTS.get(usize::from(k)).map_or(Vec2::ZERO, |at| Vec2::from_raw(at.0, at.1));
    let mut points = [Particle::default(); 6];
    for ((point, k), by) in points.iter_mut().zip(0..).zip(BLAST) {
        *point = Particle::moving(ninja.body.centre() + at(k), ninja.velocity + Vec2::from_raw(by.0, by.1));
    }
    let bone = |(a, b, bend)| {
        let length = (at(a) - at(b)).length();
        let stick = if matches!(bend, Bend::Folds) { Stick::rope(length)? } else { Stick::new(length)? };
        Ok(Link { a, b, stick })
    };
    let [left_arm, right_arm, left_leg, right_leg, back] = BONES.map(bone);
    let links = [left_arm?, right_arm?, left_leg?, right_leg?, back?];
    Ok(Sticks { points, links, radius: RADIUS, nails: 0, rounds: 8, quiet: Quiet::NOT })
}
