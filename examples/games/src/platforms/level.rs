//! The walker's level: 50 x 16 cells of 16 pixels.

use tilesat::{AllShapes, TileKind, TileKinds, TileMap, TileMapError, TileShape};

/// The start of the walker's feet.
pub const START: (i16, i16) = (40, 208);
pub const SIZE: (i32, i32) = (50 * 16, 16 * 16);

const ROWS: &str = "\
##################################################
#................................................#
#...........................================.....#
#................................................#
#................................................#
#................................................#
#....................................../#_.......#
#.......................##########...#############
#.......................##########...#############
#....................................#############
#....................................#############
#....................................#############
#...._##\\..abcd......................#############
#################......###########...#############
#################......###########################
##################################################
";
static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'=', TileKind::ONE_WAY_UP)
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight))
    .with(b'c', TileKind::of(TileShape::MildHighBottomLeft))
    .with(b'd', TileKind::of(TileShape::MildLowBottomLeft));

pub fn map() -> Result<TileMap<'static, AllShapes>, TileMapError> {
    TileMap::of_ascii(ROWS, &KINDS)
}
