//! An independent exact check of what the library did.
//!
//! It shares no code with the library: it reads the baked bytes itself, and computes with `i64`
//! raw units (65536 to the pixel). With coordinates below 2^29 every square here is below 2^62.

use super::level::{Block, Level};

/// A body as plain numbers, in raw units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    Box { min: (i64, i64), max: (i64, i64) },
    Disc { centre: (i64, i64), radius: i64 },
}

/// What a body did wrong in one frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Fault {
    /// Its interior meets the interior of a solid tile.
    pub overlap: bool,
    /// It is not within the map, came through a wall, or moved further than its velocity.
    pub escape: bool,
}

pub struct Checker {
    solid: Vec<bool>,
    /// Which of the areas that walls separate a cell belongs to; 0 for solid cells.
    area: Vec<u32>,
    width: i64,
    height: i64,
    cell: i64,
}

impl Checker {
    pub fn new(level: &Level) -> Self {
        let solid: Vec<bool> = level.tiles.iter().map(|&id| level.ids[usize::from(id)].0 == Block::All).collect();
        let area = areas(&solid, usize::from(level.width));
        Self {
            solid,
            area,
            width: i64::from(level.width),
            height: i64::from(level.height),
            cell: i64::from(level.tile) << 16,
        }
    }

    /// Checks a body that moved from `before` to `now` with at most `velocity` in this frame.
    pub fn check(&self, before: &Figure, now: &Figure, velocity: (i64, i64)) -> Fault {
        let (from, to) = (middle(before), middle(now));
        let moved = (to.0 - from.0, to.1 - from.1);
        // A cell of either side of a free body's middle belongs to the same area: the body
        // covers a bit of both, so both are free and they share a side.
        let through = self.area_at(from) != self.area_at(to);
        Fault { overlap: self.overlaps(now), escape: !self.inside(now) || through || further(moved, velocity) }
    }

    /// Whether the interiors of the body and of any solid tile meet.
    pub fn overlaps(&self, figure: &Figure) -> bool {
        let (min, max) = extent(figure);
        let span =
            |lo: i64, hi: i64, count: i64| lo.div_euclid(self.cell).max(0)..=hi.div_euclid(self.cell).min(count - 1);
        span(min.1, max.1, self.height).any(|y| {
            span(min.0, max.0, self.width)
                .any(|x| self.solid[(y * self.width + x) as usize] && self.meets(figure, x, y))
        })
    }

    fn meets(&self, figure: &Figure, x: i64, y: i64) -> bool {
        let (left, top) = (x * self.cell, y * self.cell);
        let (right, bottom) = (left + self.cell, top + self.cell);
        match *figure {
            Figure::Box { min, max } => {
                let wide = right.min(max.0) - left.max(min.0);
                let high = bottom.min(max.1) - top.max(min.1);
                wide > 0 && high > 0
            }
            Figure::Disc { centre, radius } => {
                let dx = (left - centre.0).max(centre.0 - right).max(0);
                let dy = (top - centre.1).max(centre.1 - bottom).max(0);
                dx * dx + dy * dy < radius * radius
            }
        }
    }

    pub fn inside(&self, figure: &Figure) -> bool {
        let (min, max) = extent(figure);
        min.0 >= 0 && min.1 >= 0 && max.0 <= self.width * self.cell && max.1 <= self.height * self.cell
    }

    fn area_at(&self, at: (i64, i64)) -> Option<u32> {
        let (x, y) = (at.0.div_euclid(self.cell), at.1.div_euclid(self.cell));
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then(|| self.area[(y * self.width + x) as usize])
    }
}

fn extent(figure: &Figure) -> ((i64, i64), (i64, i64)) {
    match *figure {
        Figure::Box { min, max } => (min, max),
        Figure::Disc { centre: (x, y), radius: r } => ((x - r, y - r), (x + r, y + r)),
    }
}

fn middle(figure: &Figure) -> (i64, i64) {
    match *figure {
        Figure::Box { min, max } => ((min.0 + max.0) >> 1, (min.1 + max.1) >> 1),
        Figure::Disc { centre, .. } => centre,
    }
}

/// Whether a body moved further than its velocity, with 2 raw of room for rounding. Sliding and
/// bouncing turn a motion, so its length is compared and not each component.
fn further(moved: (i64, i64), velocity: (i64, i64)) -> bool {
    let square = |v: (i64, i64)| v.0 * v.0 + v.1 * v.1;
    let length = square(velocity).isqrt() + 2;
    square(moved) > length * length
}

/// Numbers the connected groups of free cells; cells are neighbours when they share a side.
fn areas(solid: &[bool], width: usize) -> Vec<u32> {
    let mut area = vec![0; solid.len()];
    let mut count = 0;
    for start in 0..solid.len() {
        if solid[start] || area[start] != 0 {
            continue;
        }
        count += 1;
        let mut pending = vec![start];
        area[start] = count;
        while let Some(i) = pending.pop() {
            let left = (i % width != 0).then(|| i - 1);
            let right = (i % width != width - 1).then_some(i + 1);
            for n in [left, right, i.checked_sub(width), Some(i + width)].into_iter().flatten() {
                if solid.get(n) == Some(&false) && area[n] == 0 {
                    area[n] = count;
                    pending.push(n);
                }
            }
        }
    }
    area
}
