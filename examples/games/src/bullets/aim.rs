//! Directions without sines.

use tilesat::Vec2;

/// A quarter of a turn in 32nds, cosines and sines in 256ths.
const QUARTER: [(i32, i32); 8] =
    [(256, 0), (251, 50), (237, 98), (213, 142), (181, 181), (142, 213), (98, 237), (50, 251)];

/// The direction after so many 32nds of a turn, at a speed in 256ths of a unit.
pub(super) fn course(turn: u32, speed: i32) -> Vec2 {
    let (x, y) = QUARTER.get(turn as usize % 8).copied().unwrap_or((256, 0));
    let (x, y) = match turn / 8 % 4 {
        0 => (x, y),
        1 => (-y, x),
        2 => (-x, -y),
        _ => (y, -x),
    };
    Vec2::from_raw(x * speed, y * speed)
}

/// The 32nd of a turn nearest to the direction of `by`. On a tie, the first.
pub(super) fn turn_toward(by: Vec2) -> u32 {
    let (mut best, mut most) = (0, i64::MIN);
    for turn in 0..32 {
        let along = course(turn, 1).dot(by);
        if along > most {
            (best, most) = (turn, along);
        }
    }
    best
}
