//! Bodies in levels of all shapes, judged frame by frame by sets of points of the plane.

pub mod body;
pub mod frames;
pub mod hull;
pub mod room;
pub mod view;

use crate::Random;
use crate::shapes::level::Level;
use tilesat::Outside;

pub type P = (i64, i64);

pub const PX: i64 = 1 << 16;

/// A level of tiles, a `dense` percentage of them any shape, `one_way` of them one-way.
pub fn mosaic(r: &mut Random, size: P, cell: i64, dense: i64, one_way: i64) -> Level {
    let tiles = (0..size.0 * size.1).map(|_| {
        let k = r.below(100);
        (if k < dense {
            r.within(1, 33)
        } else if k < dense + one_way {
            r.within(34, 37)
        } else {
            0
        }) as u8
    });
    Level { tiles: tiles.collect(), width: size.0, height: size.1, cell, x: 0, y: 0, outside: Outside::Solid }
}

/// The tiles of a picture: `.` empty, `#` full, else a letter and its shape.
pub fn drawn(rows: &[&str], cell: i64, shapes: &[(char, u8)]) -> Level {
    let id = |c: char| match c {
        '.' => 0,
        '#' => 1,
        _ => shapes.iter().find(|s| s.0 == c).unwrap_or_else(|| panic!("no shape {c}")).1,
    };
    let width = rows[0].chars().count() as i64;
    let tiles = rows.iter().flat_map(|row| row.chars().map(id)).collect();
    Level { tiles, width, height: rows.len() as i64, cell, x: 0, y: 0, outside: Outside::Solid }
}

pub fn len2(v: P) -> i128 {
    i128::from(v.0).pow(2) + i128::from(v.1).pow(2)
}
