//! The surface of the solid tile layer, as the library itself derives it.

use std::collections::{HashMap, HashSet};

use tilesat::{Feature, Geometry, TileShape, Vec2};

use super::geometry::{Edge, Point, Side};
use crate::bake::level::Level;
use crate::fail::{Fail, Result};

pub(super) struct Surface {
    pub layer: String,
    /// Faces, the aligned ones of neighbours joined to one. Arcs are chords.
    pub edges: Vec<Edge>,
    /// One-way tiles that have no face, by column and row.
    pub hidden: Vec<(u16, u16)>,
    level: Level,
}

/// Those of a checkerboard of 256 x 256 tiles.
const MAX_FEATURES: usize = 1 << 18;

pub(super) fn of(level: Level) -> Result<Surface> {
    let features = level.features();
    if features.len() > MAX_FEATURES {
        let why =
            format!("layer '{}' has {} faces and corners; {MAX_FEATURES} can be compared", level.layer, features.len());
        return Err(Fail::new(why));
    }
    let one_ways: HashSet<_> = features.iter().filter(|f| f.one_way).map(|f| (f.cell.x, f.cell.y)).collect();
    let cells = (0..level.height).flat_map(|y| (0..level.width).map(move |x| (x, y)));
    let bare = |&(x, y): &(u16, u16)| {
        level.kind(x, y).shape as u8 >= TileShape::OneWayUp as u8 && !one_ways.contains(&(x as i16, y as i16))
    };
    Ok(Surface {
        layer: level.layer.clone(),
        edges: joined(features.iter().flat_map(pieces).collect()),
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

fn pieces(feature: &Feature) -> Vec<Edge> {
    let side = if feature.one_way { Side::OneWay } else { Side::Solid };
    let edge = |a, b| Edge { a, b, outline: None, number: 0, side };
    let wide = |v: Vec2| (i64::from(v.raw().0), i64::from(v.raw().1));
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } => {
            let a = wide(a);
            vec![edge(a, (a.0 + i64::from(dir.x) * i64::from(len), a.1 + i64::from(dir.y) * i64::from(len)))]
        }
        Geometry::Arc { centre, radius, quadrant, convex } => {
            let ((x, y), r) = (wide(centre), i64::from(radius));
            let (sx, sy) = (i64::from(quadrant.x), i64::from(quadrant.y));
            // Cosines of 0, 22.5, 45, 67.5 and 90 degrees in 65536ths.
            let cos = [65536, 60547, 46341, 25080, 0];
            let at = |k: usize| (x + sx * ((r * cos[k]) >> 16), y + sy * ((r * cos[4 - k]) >> 16));
            // From the side toward x to the side toward y is to the right (y down) in two of the quadrants.
            let right = (sx * sy > 0) == convex;
            (0..4).map(|k| if right { edge(at(k), at(k + 1)) } else { edge(at(k + 1), at(k)) }).collect()
        }
        _ => Vec::new(),
    }
}

/// Faces in one line, end to end, as one.
fn joined(mut faces: Vec<Edge>) -> Vec<Edge> {
    faces.sort_unstable_by_key(|e| (e.a, e.b));
    let line = |e: &Edge| {
        let (x, y) = e.dir();
        let divisor = gcd(x.unsigned_abs(), y.unsigned_abs()).max(1) as i128;
        (x / divisor, y / divisor, e.side == Side::OneWay)
    };
    let starts: HashMap<_, usize> = faces.iter().enumerate().map(|(i, e)| ((e.a, line(e)), i)).collect();
    let ends: HashSet<_> = faces.iter().map(|e| (e.b, line(e))).collect();
    let mut runs = Vec::new();
    for face in faces.iter().filter(|face| !ends.contains(&(face.a, line(face)))) {
        let mut run = *face;
        while let Some(&next) = starts.get(&(run.b, line(face))) {
            run.b = faces[next].b;
        }
        runs.push(run);
    }
    runs
}

fn gcd(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { gcd(b, a % b) }
}
