//! The track: round corners, and an island with a passage for the marshal.

use tilesat::{AllShapes, TileKind, TileKinds, TileMap, TileMapError, TileShape};

pub const SIZE: (i32, i32) = (30 * 16, 18 * 16);

/// Cells of 16 units.
const ROWS: &str = "\
##############################
#(..........................)#
#............................#
#............................#
#............................#
#............................#
#.......a####b..a####b.......#
#.......######..######.......#
#.......######..######.......#
#.......######..######.......#
#.......######..######.......#
#.......c####d..c####d.......#
#............................#
#............................#
#............................#
#............................#
#[..........................]#
##############################
";
static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'(', TileKind::of(TileShape::ConcaveTopLeft))
    .with(b')', TileKind::of(TileShape::ConcaveTopRight))
    .with(b'[', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b']', TileKind::of(TileShape::ConcaveBottomRight))
    // Round corners of the island, solid toward its middle.
    .with(b'a', TileKind::of(TileShape::ConvexBottomRight))
    .with(b'b', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'c', TileKind::of(TileShape::ConvexTopRight))
    .with(b'd', TileKind::of(TileShape::ConvexTopLeft));

pub fn track() -> Result<TileMap<'static, AllShapes>, TileMapError> {
    TileMap::of_ascii(ROWS, &KINDS)
}
