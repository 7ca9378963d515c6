//! Random levels.

use super::level::Level;
use crate::Random;
use tilesat::Outside;

pub const OUTSIDES: [Outside; 3] = [Outside::Empty, Outside::Solid, Outside::Edge];

/// Sides of cells: powers of two, 24 units, odd multiples of two, the limits.
pub const CELLS: [i64; 12] =
    [1 << 20, 1 << 8, 258, 24 << 16, 1 << 24, (1 << 24) - 2, 1_048_578, 3 << 19, 2 * 50_021, 1 << 9, 300, 8 << 16];

/// A level of up to 7 x 7 cells anywhere in the domain.
pub fn level(random: &mut Random) -> Level {
    let (width, height) = (random.within(1, 7), random.within(1, 7));
    let cell = CELLS[random.below(CELLS.len() as i64) as usize];
    let origin = |random: &mut Random, count: i64| {
        let lowest = 1 - (1i64 << 29);
        let highest = (1 << 29) - 1 - count * cell;
        match random.below(6) {
            0 => 0,
            1 => -cell * random.within(1, count),
            2 => random.within(lowest, highest),
            3 => lowest,
            4 => highest,
            _ => random.around(4 * cell).clamp(lowest, highest),
        }
    };
    let (x, y) = (origin(random, width), origin(random, height));
    let outside = OUTSIDES[random.below(3) as usize];
    // From almost empty to almost full.
    let (density, one_way) = (random.within(0, 10), random.within(0, 3));
    let tiles = (0..width * height)
        .map(|_| {
            let flags = if random.one_in(3) { 3 } else { 0 };
            flags
                + if random.below(10) < density {
                    1
                } else if random.below(10) < one_way {
                    2
                } else {
                    0
                }
        })
        .collect();
    Level { width, height, cell, x, y, outside, tiles }
}

/// An interesting coordinate on this axis: on a line, beside it, between two, anywhere near,
/// anywhere at all.
pub fn coordinate(random: &mut Random, origin: i64, count: i64, cell: i64) -> i64 {
    let line = |random: &mut Random| origin + cell * random.within(-1, count + 1);
    let v = match random.below(12) {
        0..=3 => line(random),
        4 | 5 => line(random) + random.sign(),
        6 | 7 => line(random) + cell / 2,
        8 => line(random) + random.around(4),
        9 | 10 => random.within(origin - cell, origin + (count + 1) * cell),
        _ => random.around((1 << 29) - 1),
    };
    v.clamp(1 - (1 << 29), (1 << 29) - 1)
}

pub fn point(random: &mut Random, level: &Level) -> (i64, i64) {
    let x = coordinate(random, level.x, level.width, level.cell);
    (x, coordinate(random, level.y, level.height, level.cell))
}
