//! The table: tiles for walls and round bumpers, and polygons for shapes off the grid.

use tilesat::{
    AllShapes, Path, PathKind, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2, fx, segment_map,
};

pub const SIZE: (i32, i32) = (22 * 16, 32 * 16);
/// Flags of the parts that a ball can hit.
pub const BUMPER: u8 = 1;
pub const KICKER: u8 = 2;

/// 22 x 32 cells of 16 units.
const ROWS: &str = "\
######################
#(..................)#
#....................#
#....................#
#....................#
#........ab..........#
#....ab..cd..ab......#
#....cd......cd......#
#....................#
#....................#
#.......ab...........#
#.......cd....ab.....#
#.............cd.....#
#....................#
#....................#
#....................#
#\\...................#
##\\................./#
###................/##
###...............####
###...............####
#P.................7##
#...................7#
#....................#
#....................#
#\\................../#
##\\................/##
###\\............../###
####\\............/####
#####\\........../#####
######^^^^^^^^^^######
######################
";

const fn bumper(shape: TileShape) -> TileKind {
    TileKind::of(shape).with_flags(BUMPER)
}

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'^', TileKind::FULL.with_flags(KICKER))
    .with(b'(', TileKind::of(TileShape::ConcaveTopLeft))
    .with(b')', TileKind::of(TileShape::ConcaveTopRight))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'7', TileKind::of(TileShape::SlopeTopRight))
    .with(b'P', TileKind::of(TileShape::SlopeTopLeft))
    // A disc of four quarters, solid toward its middle.
    .with(b'a', bumper(TileShape::ConvexBottomRight))
    .with(b'b', bumper(TileShape::ConvexBottomLeft))
    .with(b'c', bumper(TileShape::ConvexTopRight))
    .with(b'd', bumper(TileShape::ConvexTopLeft));

const fn at(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

const LEFT: [Vec2; 3] = [at(88, 344), at(128, 404), at(80, 388)];
const RIGHT: [Vec2; 3] = [at(264, 344), at(272, 388), at(224, 404)];
const PEGS: [[Vec2; 4]; 4] = [peg(96, 250), peg(150, 290), peg(206, 290), peg(256, 250)];

/// A small square on its corner, not quite a rhombus.
const fn peg(x: i16, y: i16) -> [Vec2; 4] {
    [at(x, y - 7), at(x + 6, y), at(x, y + 7), at(x - 6, y + 1)]
}

segment_map!(
    pub static SLINGSHOTS: [
        Path::new(PathKind::Solid, &LEFT).with_flags(BUMPER),
        Path::new(PathKind::Solid, &RIGHT).with_flags(BUMPER),
        Path::new(PathKind::Solid, &PEGS[0]),
        Path::new(PathKind::Solid, &PEGS[1]),
        Path::new(PathKind::Solid, &PEGS[2]),
        Path::new(PathKind::Solid, &PEGS[3]),
    ],
    fx!(32)
);

pub fn tiles() -> Result<TileMap<'static, AllShapes>, TileMapError> {
    TileMap::of_ascii(ROWS, &KINDS)
}
