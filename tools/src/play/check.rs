//! An independent exact check of the library's results.
//!
//! It shares no code with the library. It reads the baked bytes itself, and computes with whole raw
//! units (65 536 per pixel), wide enough for any product.

use super::figure::Figure;
use super::meets::meets;
use super::outline::Outline;
use super::walls::Walls;
use crate::bake::level::Level;

/// The fault of a body in one frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Fault {
    /// Its interior overlaps the interior of a solid tile.
    pub overlap: bool,
    /// It left the map, crossed a wall, or moved farther than its velocity.
    pub escape: bool,
}

/// A level as plain numbers.
#[derive(Debug, Clone)]
pub struct Checker {
    tiles: Vec<u8>,
    /// The part of its cell that each id fills.
    solid: Vec<Outline>,
    /// The number of the area to which a cell's free part belongs. Walls separate areas. 0 for
    /// cells without a free part.
    area: Vec<u32>,
    width: i64,
    height: i64,
    cell: i64,
    /// The first corner of the first cell.
    origin: (i64, i64),
    walls: Walls,
}

impl Checker {
    /// Reads the bytes of a level's tiles.
    pub fn new(level: &Level) -> Self {
        let solid: Vec<Outline> = level.ids.iter().map(|kind| Outline::of(kind.shape)).collect();
        let area = areas(&level.tiles, &solid, usize::from(level.width));
        Self {
            tiles: level.tiles.clone(),
            solid,
            area,
            width: i64::from(level.width),
            height: i64::from(level.height),
            cell: i64::from(level.tile) << 16,
            origin: (level.origin.0.into(), level.origin.1.into()),
            walls: Walls::default(),
        }
    }

    /// Adds the bytes of its segments.
    #[must_use]
    pub fn with_segments(self, bytes: &[u8]) -> Self {
        Self { walls: Walls::new(bytes), ..self }
    }

    /// Checks a body that moved from `before` to `now` with at most `velocity` in this frame.
    pub fn check(&self, before: &Figure, now: &Figure, velocity: (i64, i64)) -> Fault {
        let (from, to) = (before.middle(), now.middle());
        let moved = (to.0 - from.0, to.1 - from.1);
        // The cells on both sides of a free body's middle belong to the same area. The body covers
        // a bit of each and of the side between them, and all of that is free.
        let through = self.area_at(from) != self.area_at(to);
        Fault { overlap: self.overlaps(now), escape: !self.inside(now) || through || further(moved, velocity) }
    }

    /// Whether the interiors of the body and of any solid tile overlap.
    pub fn overlaps(&self, figure: &Figure) -> bool {
        if self.walls.overlap(figure) {
            return true;
        }
        let figure = &figure.seen_from(self.origin);
        let (min, max) = figure.extent();
        let span =
            |lo: i64, hi: i64, count: i64| lo.div_euclid(self.cell).max(0)..=hi.div_euclid(self.cell).min(count - 1);
        span(min.1, max.1, self.height).any(|y| {
            span(min.0, max.0, self.width).any(|x| {
                let id = self.tiles[(y * self.width + x) as usize];
                meets(figure, &self.solid[usize::from(id)], (x * self.cell, y * self.cell), self.cell)
            })
        })
    }

    /// Whether all of the body is inside the map.
    pub fn inside(&self, figure: &Figure) -> bool {
        let (min, max) = figure.seen_from(self.origin).extent();
        min.0 >= 0 && min.1 >= 0 && max.0 <= self.width * self.cell && max.1 <= self.height * self.cell
    }

    fn area_at(&self, at: (i64, i64)) -> Option<u32> {
        let at = (at.0 - self.origin.0, at.1 - self.origin.1);
        let (x, y) = (at.0.div_euclid(self.cell), at.1.div_euclid(self.cell));
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then(|| self.area[(y * self.width + x) as usize])
    }
}

/// Whether a body moved farther than its velocity, with 2 raw of room for rounding. Sliding and
/// bouncing turn a motion, so this compares lengths and not components.
fn further(moved: (i64, i64), velocity: (i64, i64)) -> bool {
    let square = |v: (i64, i64)| v.0 * v.0 + v.1 * v.1;
    let length = square(velocity).isqrt() + 2;
    square(moved) > length * length
}

/// Numbers the connected groups of cells. Cells are neighbours if a half of the side between them
/// is free. The free part of every shape is connected.
fn areas(tiles: &[u8], solid: &[Outline], width: usize) -> Vec<u32> {
    // For each id, the free halves of its sides, two bits per side. None for a full cell.
    let halves = |o: &Outline| (0..8).filter(|&bit| !o.covers(bit / 2, bit % 2)).fold(0u8, |all, bit| all | 1 << bit);
    let free: Vec<u8> = solid.iter().map(halves).collect();
    let side = |cell: usize, side: usize| free[usize::from(tiles[cell])] >> (2 * side) & 3;
    // The halves of a side turn right in both cells, so the other cell sees them in reverse.
    let open = |from: usize, at: usize, to: usize| {
        let there = side(to, (at + 2) % 4);
        side(from, at) & (there >> 1 | there << 1) != 0
    };
    let mut area = vec![0; tiles.len()];
    let mut count = 0;
    for start in 0..tiles.len() {
        if free[usize::from(tiles[start])] == 0 || area[start] != 0 {
            continue;
        }
        count += 1;
        let mut pending = vec![start];
        area[start] = count;
        while let Some(i) = pending.pop() {
            let left = (i % width != 0).then(|| i - 1);
            let right = (i % width != width - 1).then_some(i + 1);
            for (at, n) in [i.checked_sub(width), right, Some(i + width), left].into_iter().enumerate() {
                let Some(n) = n.filter(|&n| n < tiles.len()) else { continue };
                if area[n] == 0 && open(i, at, n) {
                    area[n] = count;
                    pending.push(n);
                }
            }
        }
    }
    area
}
