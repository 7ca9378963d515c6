//! The surface of the solid tile layer, as the library itself derives it.

use std::collections::HashSet;
use std::fmt::Display;

use tilesat::{
    Aabb, AllShapes, Fx, Grid, Outside, TileMap, TileShape, Vec2,
    world::{Feature, Geometry},
};

use crate::bake::level::Level;
use crate::fail::{Fail, Result};
use crate::geometry::{Edge, Point, Side};

pub(super) struct Surface {
    pub layer: String,
    /// Faces, with aligned neighbours joined to one. Arcs become chords.
    pub edges: Vec<Edge>,
    /// One-way tiles without a face, by column and row.
    pub hidden: Vec<(u16, u16)>,
    level: Level,
}

/// The features of a checkerboard of 512 x 512 tiles.
const MAX_FEATURES: usize = 1 << 20;

/// The smallest cell of the library, in raw units. Drawn this small, a level of any size fits its
/// domain.
const CELL: i32 = 1 << 8;

pub(super) fn of(level: Level) -> Result<Surface> {
    let kinds = level.kinds();
    let of_layer = |why: &dyn Display| Fail::new(format!("layer '{}' {why}", level.layer));
    let grid = Grid::new(level.width, level.height, Fx::from_bits(CELL), Vec2::ZERO);
    let map = grid.and_then(|grid| TileMap::<AllShapes>::of(&level.tiles, grid, &kinds));
    let map = map.map_err(|e| of_layer(&format!("cannot be compared: {e}")))?.with_outside(Outside::Solid);
    let whole = Aabb::new(map.grid().origin(), map.grid().end()).map_err(|e| of_layer(&e))?;

    // The outside is not part of the level.
    let features = map.features(&whole).filter(|feature| map.tile(feature.cell).is_some());
    let features: Vec<Feature> = features.take(MAX_FEATURES + 1).collect();
    if features.len() > MAX_FEATURES {
        return Err(of_layer(&format!("has more faces and corners than can be compared, which is {MAX_FEATURES}")));
    }
    let one_ways: HashSet<_> = features.iter().filter(|f| f.one_way).map(|f| (f.cell.x, f.cell.y)).collect();
    let cells = (0..level.height).flat_map(|y| (0..level.width).map(move |x| (x, y)));
    let bare = |&(x, y): &(u16, u16)| {
        level.kind(x, y).shape as u8 >= TileShape::OneWayUp as u8 && !one_ways.contains(&(x as i16, y as i16))
    };
    let origin = (i64::from(level.origin.0), i64::from(level.origin.1));
    let place = |p: Point| (p.0 + origin.0, p.1 + origin.1);
    let moved = |edge: Edge| Edge { a: place(edge.a), b: place(edge.b), ..edge };
    let scale = (i64::from(level.tile) << 16) / i64::from(CELL);
    Ok(Surface {
        layer: level.layer.clone(),
        edges: joined(features.iter().flat_map(|feature| pieces(feature, scale)).map(moved).collect()),
        hidden: cells.filter(bare).collect(),
        level,
    })
}

impl Surface {
    /// The middle of a tile.
    pub(super) fn middle(&self, (column, row): (u16, u16)) -> Point {
        let at = |index: u16, origin: i32| {
            (i64::from(index) * 2 + 1) * (i64::from(self.level.tile) << 15) + i64::from(origin)
        };
        (at(column, self.level.origin.0), at(row, self.level.origin.1))
    }

    /// Whether a point of doubled coordinates lies in a full tile or on its edge.
    pub(super) fn is_full(&self, (x, y): Point) -> bool {
        let tile = i64::from(self.level.tile) << 17;
        let from = |at: i64, origin: i32| (at - 2 * i64::from(origin)).div_euclid(tile);
        let (column, row) = (from(x, self.level.origin.0), from(y, self.level.origin.1));
        let within = |index: i64, count: u16| (0..i64::from(count)).contains(&index);
        within(column, self.level.width)
            && within(row, self.level.height)
            && self.level.kind(column as u16, row as u16).shape == TileShape::Full
    }
}

/// The edges of a piece of the surface, scaled up.
fn pieces(feature: &Feature, scale: i64) -> Vec<Edge> {
    let side = if feature.one_way { Side::OneWay } else { Side::Solid };
    let edge = |a, b| Edge { a, b, outline: None, number: 0, side };
    let wide = |v: Vec2| (i64::from(v.raw().0) * scale, i64::from(v.raw().1) * scale);
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } => {
            let (a, len) = (wide(a), i64::from(len) * scale);
            vec![edge(a, (a.0 + i64::from(dir.x) * len, a.1 + i64::from(dir.y) * len))]
        }
        Geometry::Arc { centre, radius, quadrant, convex } => {
            let ((x, y), r) = (wide(centre), i64::from(radius) * scale);
            let (sx, sy) = (i64::from(quadrant.x), i64::from(quadrant.y));
            // Cosines of 0, 22.5, 45, 67.5 and 90 degrees in 65536ths.
            let cos = [65536, 60547, 46341, 25080, 0];
            let at = |k: usize| (x + sx * ((r * cos[k]) >> 16), y + sy * ((r * cos[4 - k]) >> 16));
            // In two of the quadrants, the direction from the side toward x to the side toward y is
            // to the right (y down).
            let right = (sx * sy > 0) == convex;
            (0..4).map(|k| if right { edge(at(k), at(k + 1)) } else { edge(at(k + 1), at(k)) }).collect()
        }
        _ => Vec::new(),
    }
}

/// Joins collinear faces that meet end to end.
fn joined(mut faces: Vec<Edge>) -> Vec<Edge> {
    // Faces of one line and direction are adjacent, in their order along it.
    let line = |e: &Edge| {
        let (x, y) = e.dir();
        let divisor = gcd(x.unsigned_abs(), y.unsigned_abs()).max(1) as i128;
        let (x, y) = (x / divisor, y / divisor);
        let (a, b) = (i128::from(e.a.0), i128::from(e.a.1));
        (x, y, e.side == Side::OneWay, x * b - y * a, x * a + y * b)
    };
    faces.sort_by_cached_key(line);
    let mut runs: Vec<Edge> = Vec::new();
    for face in faces {
        match runs.last_mut() {
            Some(run) if run.b == face.a && same_way(run, &face) => run.b = face.b,
            _ => runs.push(face),
        }
    }
    runs
}

/// Whether two edges have one direction and side.
fn same_way(s: &Edge, t: &Edge) -> bool {
    let ((x, y), (z, w)) = (s.dir(), t.dir());
    s.side == t.side && x * w == y * z && x * z + y * w > 0
}

fn gcd(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { gcd(b, a % b) }
}
