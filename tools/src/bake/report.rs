//! The costs of a level: bytes, cells, and the pieces of surface that a query meets.

use tilesat::prelude::*;
use tilesat::world::World;
use tilesat::{
    Aabb, Cell, Fx, Grid, Segment, TileKinds, Vec2,
    world::{Feature, Geometry},
};

use super::Baked;
use crate::fail::Result;

/// The role of a cell in a query.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Class {
    Empty,
    Interior,
    Boundary,
}

/// Counts over the cells of a level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Report {
    pub empty: usize,
    pub interior: usize,
    pub boundary: usize,
    /// Pieces in the cell with the most, and in all cells together.
    pub most: usize,
    pub pieces: usize,
    /// The most pieces and cells that one query of a body can visit, at any position.
    pub met: usize,
    pub walked: usize,
}

/// The pieces that belong to a cell. A tile owns its pieces. A segment map stores all that have a
/// point in the cell's closed square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Owner {
    Tile,
    Square,
}

impl Report {
    pub(crate) fn of<W: World>(world: &W, grid: Grid, owner: Owner, body: (i32, i32)) -> Self {
        let (mut empty, mut interior, mut boundary) = (0, 0, 0);
        let (mut most, mut pieces, mut met) = (0, 0, 0);
        for (cell, square) in cells(grid) {
            let own = own(world, cell, &square, owner).len();
            match class(world, &square, own) {
                Class::Empty => empty += 1,
                Class::Interior => interior += 1,
                Class::Boundary => boundary += 1,
            }
            most = most.max(own);
            pieces += own;
            // All positions of the body whose corner lies in this cell are in this region.
            let (x, y) = square.max().raw();
            let end = Vec2::from_raw(clamped(x.saturating_add(body.0)), clamped(y.saturating_add(body.1)));
            if let Ok(region) = Aabb::new(square.min(), end) {
                met = met.max(world.features(&region).count());
            }
        }
        // A closed body touches one cell more on each side than it fills.
        let side = |length: i32, count: u16| (length / grid.cell().to_bits() + 2).min(i32::from(count)) as usize;
        let walked = side(body.0, grid.width()) * side(body.1, grid.height());
        Self { empty, interior, boundary, most, pieces, met, walked }
    }

    /// Lines of the report.
    pub(crate) fn lines(&self, body: (i32, i32)) -> [String; 3] {
        let cells = self.empty + self.interior + self.boundary;
        let mean = |count: usize| format!("{}.{:02}", self.pieces / count, self.pieces * 100 / count % 100);
        [
            format!("cells   {} empty, {} interior, {} boundary", self.empty, self.interior, self.boundary),
            format!(
                "pieces  at most {} in a cell, on average {} ({} in a boundary cell)",
                self.most,
                mean(cells.max(1)),
                mean(self.boundary.max(1))
            ),
            format!(
                "work    a body of {}x{} meets at most {} pieces in {} cells",
                Fx::from_bits(body.0),
                Fx::from_bits(body.1),
                self.met,
                self.walked
            ),
        ]
    }
}

/// The report looks at no more cells than this: it would take too long.
const MOST_COUNTED: usize = 1 << 20;

impl Baked {
    /// The cost of the level, line by line. Uses a body of these sides in raw units, or of one
    /// cell.
    ///
    /// # Errors
    ///
    /// As [`map`](Self::map).
    pub fn report(&self, body: Option<(i32, i32)>) -> Result<Vec<String>> {
        let mut lines = Vec::new();
        let body = |grid: &Grid| body.unwrap_or((grid.cell().to_bits(), grid.cell().to_bits()));
        if let (Some((map, grid)), Some(level)) = (self.map()?, &self.tiles) {
            let (width, height, side) = (level.width, level.height, level.tile);
            lines.push(format!("tiles   layer '{}': {width}x{height} of {side} px", level.layer));
            lines.push(format!("flash   {} bytes of tiles, {} of kinds", level.tiles.len(), size_of::<TileKinds>()));
            if level.tiles.len() > MOST_COUNTED {
                lines.push(format!("cells   not counted: more than {MOST_COUNTED}"));
            } else {
                let report = Report::of(&map, grid, Owner::Tile, body(&grid));
                lines.extend(report.lines(body(&grid)));
            }
        }
        if let (Some(map), Some((shapes, bytes, cell))) = (self.segments()?, &self.objects) {
            let (count, paths) = (map.count(), shapes.kinds.len());
            let (width, height) = (map.width(), map.height());
            lines.push(format!("objects {paths} in {count} segments, {width}x{height} cells of {cell} px"));
            lines.push(format!("flash   {} bytes", bytes.len()));
            let grid = map.grid();
            if usize::from(width) * usize::from(height) > MOST_COUNTED {
                lines.push(format!("cells   not counted: more than {MOST_COUNTED}"));
            } else {
                let report = Report::of(&map, grid, Owner::Square, body(&grid));
                lines.extend(report.lines(body(&grid)));
            }
        }
        let flags: Vec<String> =
            self.flags.iter().enumerate().map(|(bit, name)| format!("{name} = bit {bit}")).collect();
        if !flags.is_empty() {
            lines.push(format!("flags   {}", flags.join(", ")));
        }
        Ok(lines)
    }
}

/// The cells of a grid and their squares.
pub(crate) fn cells(grid: Grid) -> impl Iterator<Item = (Cell, Aabb)> {
    let (x, y) = grid.origin().raw();
    let side = grid.cell().to_bits();
    let square = move |column: u16, row: u16| {
        let at = |origin: i32, index: u16| origin + i32::from(index) * side;
        let min = Vec2::from_raw(at(x, column), at(y, row));
        let max = Vec2::from_raw(clamped(at(x, column) + side), clamped(at(y, row) + side));
        Some((Cell::new(column as i16, row as i16), Aabb::new(min, max).ok()?))
    };
    (0..grid.height()).flat_map(move |row| (0..grid.width()).filter_map(move |column| square(column, row)))
}

pub(crate) fn own<W: World>(world: &W, cell: Cell, square: &Aabb, owner: Owner) -> Vec<Feature> {
    // The iterator may also return pieces that are only near the square.
    let meets = |f: &Feature| match f.geometry {
        Geometry::Face { a, .. } => Segment::new(a, end(f)).is_ok_and(|face| face.touches(square)),
        Geometry::Vertex { p, .. } => square.contains(&p),
        _ => true,
    };
    let owned = |f: &Feature| match owner {
        Owner::Tile => f.cell == cell,
        Owner::Square => meets(f),
    };
    world.features(square).filter(owned).collect()
}

/// The end of a face. Other features give the origin.
fn end(feature: &Feature) -> Vec2 {
    let Geometry::Face { a, dir, len, .. } = feature.geometry else { return Vec2::ZERO };
    let (x, y) = a.raw();
    // Inside the domain: the library has checked it.
    Vec2::from_raw(x + dir.x * len, y + dir.y * len)
}

pub(crate) fn class<W: World>(world: &W, square: &Aabb, own: usize) -> Class {
    match (own, world.overlaps_aabb(square)) {
        (1.., _) => Class::Boundary,
        (0, true) => Class::Interior,
        (0, false) => Class::Empty,
    }
}

/// Contract C1: coordinates are below 2^29 raw.
fn clamped(raw: i32) -> i32 {
    raw.min((1 << 29) - 1)
}
