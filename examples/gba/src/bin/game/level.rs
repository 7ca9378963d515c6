//! One screen of all shapes: 30 x 19 cells of 16 units, each 8 x 8 pixels.

use tilesat::{AllShapes, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2};

pub const WIDTH: i32 = 30;
pub const HEIGHT: i32 = 19;
pub const START: Vec2 = Vec2::from_ints(30, 270);

const ROWS: &str = "\
##############################
#(......ef#gh......7##P.....)#
#...................}........#
#...~~~......................#
#......n##m.......^^^....q...#
#......u##v..........t...r...#
#....................s...#...#
#abcd................#...x...#
####v....===.........y...w...#
#P...................z.......#
#........_...<..........===..#
#........#...#...ab#cd.......#
#.nm.....#...>...7###P.......#
#.uv.....^...................#
#...........===..............#
#......................{..ab##
#......./\\......nm.....{.7####
#L..._./##\\....n##m...qt....J#
##############################
";

pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'^', TileKind::of(TileShape::HalfTop))
    .with(b'>', TileKind::of(TileShape::HalfRight))
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'<', TileKind::of(TileShape::HalfLeft))
    .with(b'P', TileKind::of(TileShape::SlopeTopLeft))
    .with(b'7', TileKind::of(TileShape::SlopeTopRight))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'v', TileKind::of(TileShape::ConvexTopLeft))
    .with(b'u', TileKind::of(TileShape::ConvexTopRight))
    .with(b'n', TileKind::of(TileShape::ConvexBottomRight))
    .with(b'm', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'(', TileKind::of(TileShape::ConcaveTopLeft))
    .with(b')', TileKind::of(TileShape::ConcaveTopRight))
    .with(b'J', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'L', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b'h', TileKind::of(TileShape::MildLowTopLeft))
    .with(b'e', TileKind::of(TileShape::MildLowTopRight))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'd', TileKind::of(TileShape::MildLowBottomLeft))
    .with(b'g', TileKind::of(TileShape::MildHighTopLeft))
    .with(b'f', TileKind::of(TileShape::MildHighTopRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight))
    .with(b'c', TileKind::of(TileShape::MildHighBottomLeft))
    .with(b'z', TileKind::of(TileShape::SteepLowTopLeft))
    .with(b'w', TileKind::of(TileShape::SteepLowTopRight))
    .with(b'q', TileKind::of(TileShape::SteepLowBottomRight))
    .with(b't', TileKind::of(TileShape::SteepLowBottomLeft))
    .with(b'y', TileKind::of(TileShape::SteepHighTopLeft))
    .with(b'x', TileKind::of(TileShape::SteepHighTopRight))
    .with(b'r', TileKind::of(TileShape::SteepHighBottomRight))
    .with(b's', TileKind::of(TileShape::SteepHighBottomLeft))
    .with(b'=', TileKind::ONE_WAY_UP)
    .with(b'}', TileKind::of(TileShape::OneWayRight))
    .with(b'~', TileKind::of(TileShape::OneWayDown))
    .with(b'{', TileKind::of(TileShape::OneWayLeft));

pub type Level = TileMap<'static, AllShapes>;

pub fn map() -> Result<Level, TileMapError> {
    TileMap::of_ascii(ROWS, &KINDS)
}
