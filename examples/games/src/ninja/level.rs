//! The ninja's level: 44 x 24 cells of 16 pixels.

use tilesat::{AllShapes, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2};

pub const START: Vec2 = Vec2::from_ints(40, 340);
/// On the block under the slopes, before its round corner.
pub const NAIL: Vec2 = Vec2::from_ints(592, 110);
pub const SIZE: (i32, i32) = (44 * 16, 24 * 16);

const ROWS: &str = "\
############################################
#(........................................)#
#..........................................#
#..........................................#
#..........................................#
#..........................................#
#............nm......abcd..................#
#.......n#################..##########m....#
#.......#P..............P#..7##########....#
#.......#....................7#########....#
#.......#......................#######P....#
#.......P......................#######.....#
#..............................#######.....#
#..............................#######.....#
#..............................#######.....#
#...................========...#######.....#
#..............................7#####P.....#
#...........=====...............7###P......#
#..........................................#
#..........................................#
#..........................................#
#..........................................#
#L.....abcd..../##\\........nm.............J#
############################################
";

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'=', TileKind::ONE_WAY_UP)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'7', TileKind::of(TileShape::SlopeTopRight))
    .with(b'P', TileKind::of(TileShape::SlopeTopLeft))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight))
    .with(b'c', TileKind::of(TileShape::MildHighBottomLeft))
    .with(b'd', TileKind::of(TileShape::MildLowBottomLeft))
    .with(b'J', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'L', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b')', TileKind::of(TileShape::ConcaveTopRight))
    .with(b'(', TileKind::of(TileShape::ConcaveTopLeft))
    .with(b'n', TileKind::of(TileShape::ConvexBottomRight))
    .with(b'm', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'_', TileKind::of(TileShape::HalfBottom));

pub fn map() -> Result<TileMap<'static, AllShapes>, TileMapError> {
    TileMap::of_ascii(ROWS, &KINDS)
}
