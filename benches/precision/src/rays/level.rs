//! Grids of 256 x 256 solid and free cells of 16 pixels, with a solid border.

use tilesat_judge::Random;

pub const SIDE: usize = 256;
/// A side of a cell, raw.
pub const CELL: i64 = 16 << 16;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Map {
    /// 5 % solid: blocks of up to 6 x 6 in an empty room.
    Room,
    /// 20 % solid, as a platformer has them: ground in steps, platforms, pillars.
    Platformer,
    /// 50 % solid, in clumps.
    Cave,
}

pub const MAPS: [Map; 3] = [Map::Room, Map::Platformer, Map::Cave];

impl Map {
    pub fn name(self) -> &'static str {
        match self {
            Self::Room => "room 5 %",
            Self::Platformer => "platformer 20 %",
            Self::Cave => "cave 50 %",
        }
    }

    fn share(self) -> usize {
        match self {
            Self::Room => 5,
            Self::Platformer => 20,
            Self::Cave => 50,
        }
    }
}

/// A byte per cell, not zero where it is solid, row by row.
#[derive(Debug)]
pub struct Level {
    pub cells: Vec<u8>,
}

impl Level {
    pub fn new(map: Map) -> Self {
        let mut r = Random::new(0x1e7e1 + map as u64);
        let mut level = Self { cells: vec![0; SIDE * SIDE] };
        let last = SIDE as i64 - 1;
        for i in 0..=last {
            for (x, y) in [(i, 0), (i, last), (0, i), (last, i)] {
                level.fill(x, y, 1, 1);
            }
        }
        if map == Map::Cave {
            level.clump(&mut r);
            return level;
        }
        if map == Map::Platformer {
            level.ground(&mut r);
        }
        while level.cells.iter().filter(|&&c| c != 0).count() * 100 < SIDE * SIDE * map.share() {
            let (w, h) = match (map, r.below(3)) {
                (Map::Room, _) => (r.within(1, 6), r.within(1, 6)),
                (_, 0) => (r.within(1, 2), r.within(2, 10)),
                _ => (r.within(3, 12), 1),
            };
            level.fill(r.within(1, last - w), r.within(1, last - h), w, h);
        }
        level
    }

    pub fn solid(&self, x: i64, y: i64) -> bool {
        let inside = |v: i64| (0..SIDE as i64).contains(&v);
        inside(x) && inside(y) && self.cells[y as usize * SIDE + x as usize] != 0
    }

    /// The positions of all solid cells.
    pub fn solid_cells(&self) -> impl Iterator<Item = (i64, i64)> {
        let side = SIDE as i64;
        (0..side * side).map(move |i| (i % side, i / side)).filter(|&(x, y)| self.solid(x, y))
    }

    fn fill(&mut self, x: i64, y: i64, w: i64, h: i64) {
        for row in y..y + h {
            let from = row as usize * SIDE + x as usize;
            self.cells[from..from + w as usize].fill(1);
        }
    }

    /// The bottom: rows are downward.
    fn ground(&mut self, r: &mut Random) {
        let (mut x, last) = (1, SIDE as i64 - 1);
        while x < last {
            let (w, h) = (r.within(2, 16).min(last - x), r.within(4, 40));
            self.fill(x, last - h, w, h);
            x += w;
        }
    }

    /// Noise, smoothed three times: each cell becomes what most of the nine around it are.
    fn clump(&mut self, r: &mut Random) {
        let inner = 1..SIDE as i64 - 1;
        for y in inner.clone() {
            for x in inner.clone() {
                self.cells[y as usize * SIDE + x as usize] = u8::from(r.below(1000) < 497);
            }
        }
        for _ in 0..3 {
            let before = Self { cells: self.cells.clone() };
            for y in inner.clone() {
                for x in inner.clone() {
                    let around = (-1..=1).flat_map(|j| (-1..=1).map(move |i| (x + i, y + j)));
                    let n = around.filter(|&(i, j)| before.solid(i, j)).count();
                    self.cells[y as usize * SIDE + x as usize] = u8::from(n >= 5);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_as_full_as_they_say() {
        for map in MAPS {
            let solid = Level::new(map).cells.iter().filter(|&&c| c != 0).count();
            let share = solid as f64 * 100.0 / (SIDE * SIDE) as f64;
            assert!((share - map.share() as f64).abs() < 1.5, "{map:?}: {share}");
        }
    }
}
