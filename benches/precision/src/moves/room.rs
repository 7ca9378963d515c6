//! Levels, as tiles and as point sets of the plane. Decides exactly whether a body is in the solid.
//!
//! A body's position is an exact number of 512ths of a raw unit. So is every f32 at or above one
//! pixel.

use tilesat::{Outside, TileShape};
use tilesat_games::platformer::ninja;
use tilesat_judge::Random;
use tilesat_judge::shapes::level::Level;
use tilesat_judge::shapes::region::Region;

/// Parts of a raw unit, and of a pixel. They are even, because slopes are cut at even positions
/// only.
const FINE: i64 = 512;
pub const FINE_PIXEL: i64 = FINE << 16;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Map {
    /// 64 x 64 cells of 16 pixels, 25 % of them full.
    Blocks,
    /// The same, but any of the 33 solid shapes.
    Mosaic,
    /// The example's level: 48 x 27 cells of 24 pixels. Without its one-way edges, which no other
    /// backend has.
    Ninja,
}

pub const MAPS: [Map; 3] = [Map::Blocks, Map::Mosaic, Map::Ninja];

impl Map {
    pub fn name(self) -> &'static str {
        match self {
            Self::Blocks => "blocks 25 %",
            Self::Mosaic => "all shapes 25 %",
            Self::Ninja => "level ninja",
        }
    }

    fn shape(self, r: &mut Random) -> TileShape {
        match (self, r.below(100) < 25) {
            (_, false) => TileShape::Empty,
            (Self::Blocks, _) => TileShape::Full,
            _ => TileShape::ALL[r.within(1, 33) as usize],
        }
    }
}

/// A body at its exact position, in fine units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    Circle { c: (i64, i64), r: i64 },
    Box { lo: (i64, i64), hi: (i64, i64) },
}

impl Body {
    pub fn moved(&self, by: (i64, i64)) -> Self {
        let at = |p: (i64, i64)| (p.0 + by.0, p.1 + by.1);
        match *self {
            Self::Circle { c, r } => Self::Circle { c: at(c), r },
            Self::Box { lo, hi } => Self::Box { lo: at(lo), hi: at(hi) },
        }
    }

    /// Smaller by this much on all sides. The rest of a box is even, as its sides are.
    pub fn shrunk(&self, by: i64) -> Self {
        match *self {
            Self::Circle { c, r } => Self::Circle { c, r: r - by },
            Self::Box { lo, hi } => {
                let by = by & !1;
                Self::Box { lo: (lo.0 + by, lo.1 + by), hi: (hi.0 - by, hi.1 - by) }
            }
        }
    }

    pub fn middle(&self) -> (i64, i64) {
        match *self {
            Self::Circle { c, .. } => c,
            Self::Box { lo, hi } => (i64::midpoint(lo.0, hi.0), i64::midpoint(lo.1, hi.1)),
        }
    }

    /// From its middle to its nearest side.
    pub fn reach(&self) -> i64 {
        match *self {
            Self::Circle { r, .. } => r,
            Self::Box { lo, hi } => (hi.0 - lo.0).min(hi.1 - lo.1) / 2,
        }
    }
}

/// A level with the solid of each cell.
pub struct Room {
    pub level: Level,
    solids: Vec<Option<Region>>,
}

impl Room {
    /// A map with a full border. Its first corner is `origin` pixels from the origin on both axes.
    pub fn new(map: Map, origin: i64) -> Self {
        let mut r = Random::new(0x5eed + map as u64);
        let (width, height, cell) = match map {
            Map::Ninja => (ninja::WIDTH.into(), ninja::HEIGHT.into(), i64::from(ninja::TILE)),
            _ => (64, 64, 16),
        };
        let tiles = (0..width * height).map(|i| {
            let (x, y) = (i % width, i / width);
            let shape = match map {
                _ if x == 0 || y == 0 || x == width - 1 || y == height - 1 => TileShape::Full,
                Map::Ninja => ninja::KINDS.get(ninja::TILES[i as usize]).shape,
                _ => map.shape(&mut r),
            };
            // One-way edges have the last numbers.
            if shape as u8 > 33 { 0 } else { shape as u8 }
        });
        let tiles = tiles.collect();
        let at = origin << 16;
        Self::of(Level { width, height, cell: cell << 16, x: at, y: at, outside: Outside::Solid, tiles })
    }

    pub fn of(level: Level) -> Self {
        let solids = level.pieces(FINE.into()).into_iter().map(|p| p.solid).collect();
        Self { level, solids }
    }

    /// Whether the body and the solid share an area.
    pub fn overlaps(&self, body: &Body) -> bool {
        let l = &self.level;
        let (lo, hi) = match *body {
            Body::Circle { c, r } => ((c.0 - r, c.1 - r), (c.0 + r, c.1 + r)),
            Body::Box { lo, hi } => (lo, hi),
        };
        let cells = |lo: i64, hi: i64, origin: i64, count: i64| {
            let cell = |x: i64| (x - origin * FINE).div_euclid(l.cell * FINE).clamp(-1, count);
            cell(lo)..=cell(hi)
        };
        let wide = |p: (i64, i64)| (i128::from(p.0), i128::from(p.1));
        cells(lo.1, hi.1, l.y, l.height).any(|row| {
            cells(lo.0, hi.0, l.x, l.width).any(|column| {
                let k = (row + 1) * (l.width + 2) + column + 1;
                self.solids[k as usize].as_ref().is_some_and(|solid| match *body {
                    Body::Circle { c, r } => solid.contains(wide(c)) || solid.border_within(wide(c), r.into(), false),
                    Body::Box { lo, hi } => solid.meets_box(wide(lo), wide(hi), true),
                })
            })
        })
    }

    /// How much the body must shrink on all sides to be free, within a fine unit or two. At most
    /// its whole size.
    pub fn depth(&self, body: &Body) -> i64 {
        if !self.overlaps(body) {
            return 0;
        }
        let (mut inside, mut free) = (0, body.reach());
        while free - inside > 2 {
            let middle = i64::midpoint(inside, free);
            if self.overlaps(&body.shrunk(middle)) {
                inside = middle;
            } else {
                free = middle;
            }
        }
        free
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(x: f64, y: f64, r: f64) -> Body {
        let fine = |v: f64| (v * FINE_PIXEL as f64) as i64;
        Body::Circle { c: (fine(x), fine(y)), r: fine(r) }
    }

    fn boxed(lo: (i64, i64), hi: (i64, i64)) -> Body {
        let fine = |p: (i64, i64)| (p.0 * FINE_PIXEL, p.1 * FINE_PIXEL);
        Body::Box { lo: fine(lo), hi: fine(hi) }
    }

    fn one(id: TileShape) -> Room {
        let mut tiles = vec![0; 25];
        tiles[12] = id as u8;
        Room::of(Level { width: 5, height: 5, cell: 16 << 16, x: 0, y: 0, outside: Outside::Solid, tiles })
    }

    #[test]
    fn depths_are_those_of_the_definition() {
        let full = one(TileShape::Full);
        // The cell spans 32 to 48.
        assert_eq!(full.depth(&boxed((22, 36), (32, 46))), 0);
        assert!((full.depth(&boxed((23, 36), (33, 46))) - FINE_PIXEL).abs() <= 2);
        assert!((full.depth(&circle(28.0, 40.0, 5.0)) - FINE_PIXEL).abs() <= 2);
        assert_eq!(full.depth(&circle(27.0, 40.0, 5.0)), 0);
        assert_eq!(full.depth(&circle(40.0, 40.0, 5.0)), 5 * FINE_PIXEL);
        // Past the corner (32, 32) by the triangle 3 4 5, and out of the level.
        assert_eq!(full.depth(&circle(29.0, 28.0, 5.0)), 0);
        assert!((full.depth(&circle(29.0, 28.0, 6.0)) - FINE_PIXEL).abs() <= 2);
        assert!((full.depth(&circle(4.0, 40.0, 5.0)) - FINE_PIXEL).abs() <= 2);
        // The quarter disc around (32, 32) with radius 16.
        let arc = one(TileShape::ConvexTopLeft);
        assert_eq!(arc.depth(&circle(44.0, 48.0, 4.0)), 0);
        assert!((arc.depth(&circle(44.0, 48.0, 5.0)) - FINE_PIXEL).abs() <= 2);
    }

    #[test]
    fn one_fine_unit_is_seen() {
        for map in MAPS {
            let room = Room::new(map, 0);
            let cell = room.level.cell * FINE;
            // The border's inner side is at one cell.
            let side = 8 * FINE_PIXEL;
            let find = |x: i64| Body::Box { lo: (x, 0), hi: (x + side, side) };
            let row = (1..room.level.height - 1).find(|y| room.level.tiles[(y * room.level.width + 1) as usize] == 0);
            let down = row.expect("a free cell beside the border") * cell;
            assert!(!room.overlaps(&find(cell).moved((0, down))), "{map:?}");
            assert!(room.overlaps(&find(cell - 2).moved((0, down))), "{map:?}");
        }
    }
}
