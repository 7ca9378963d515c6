//! Finds the solid from the level's letters and the shapes' definitions, and which points belong to
//! one room.

use tilesat_games::bullets::{ROWS, SIZE};

/// Whether a point is in the solid. `u` and `v` are its position in its cell, from the top left
/// corner.
pub fn solid(x: f64, y: f64) -> bool {
    let (column, row) = ((x / 16.0).floor(), (y / 16.0).floor());
    if column < 0.0 || row < 0.0 || column >= f64::from(SIZE.0) || row >= f64::from(SIZE.1) {
        return true;
    }
    let (u, v) = (x / 16.0 - column, y / 16.0 - row);
    let tile = ROWS.lines().nth(row as usize).and_then(|line| line.as_bytes().get(column as usize).copied());
    // From a corner of the cell, squared.
    let far = |cu: f64, cv: f64| (u - cu).powi(2) + (v - cv).powi(2);
    match tile.unwrap_or(b'#') {
        b'#' | b'*' => true,
        b'_' => v > 0.5,
        b'-' => v < 0.5,
        b'{' => u < 0.5,
        b'}' => u > 0.5,
        b'/' => u + v > 1.0,
        b'P' => u + v < 1.0,
        b'\\' => v > u,
        b'7' => v < u,
        b'm' => v > 1.0 - u / 2.0,
        b'M' => v > 0.5 - u / 2.0,
        b'W' => v > u / 2.0,
        b'w' => v > 0.5 + u / 2.0,
        b'a' => far(1.0, 1.0) < 1.0,
        b'b' => far(0.0, 1.0) < 1.0,
        b'c' => far(1.0, 0.0) < 1.0,
        b'd' => far(0.0, 0.0) < 1.0,
        b'(' => far(1.0, 1.0) > 1.0,
        b')' => far(0.0, 1.0) > 1.0,
        b']' => far(0.0, 0.0) > 1.0,
        b'[' => far(1.0, 0.0) > 1.0,
        _ => false,
    }
}

/// Squares of one unit, each with the number of its room. 0 is in the solid.
pub struct Rooms {
    width: usize,
    of: Vec<u8>,
}

impl Rooms {
    pub fn new() -> Self {
        let (width, height) = (16 * usize::from(SIZE.0), 16 * usize::from(SIZE.1));
        let free: Vec<bool> =
            (0..width * height).map(|i| !solid((i % width) as f64 + 0.5, (i / width) as f64 + 0.5)).collect();
        let (mut of, mut rooms) = (vec![0; free.len()], 0);
        for start in 0..free.len() {
            if !free[start] || of[start] != 0 {
                continue;
            }
            rooms += 1;
            let mut open = vec![start];
            while let Some(at) = open.pop() {
                if free[at] && of[at] == 0 {
                    of[at] = rooms;
                    // The border is solid, so no square is beyond an end.
                    open.extend([at - 1, at + 1, at - width, at + width]);
                }
            }
        }
        Self { width, of }
    }

    /// The room of a point that is at least half a unit from the solid.
    pub fn at(&self, (x, y): (f64, f64)) -> u8 {
        self.of[y as usize * self.width + x as usize]
    }

    pub fn count(&self) -> u8 {
        self.of.iter().copied().max().unwrap_or(0)
    }
}
