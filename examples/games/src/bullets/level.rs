//! The level in flash: an arena and two galleries with a closed wall between them.

use tilesat::{Aabb, AllShapes, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2};

use super::body::Kind;

/// Flag of tiles that swallow bullets.
pub const SPONGE: u8 = 1;
/// Cells of 16 units.
pub const SIZE: (u8, u8) = (40, 24);

/// Letters are empty tiles at which a body starts: turrets, spinners, patrols that walk sideways
/// (p) and down (q), the player (@), the middle of the zone (z).
pub const ROWS: &str = "\
########################################
#(...)#(........................)#(...)#
#.....#..........................#.....#
#.....#..t......p...s.........t..#..t..#
#..s..#..../##\\........../##\\....#.....#
#.....#....7##P.......p..7##P....#.....#
#.q...#..........................#.../##
#.....#.......q...ab.............#...###
#..ab.#..s........cd.....q....s..#.....#
#..cd.#..........................#.....#
#.....#........__......--........#.s...#
#.....#...**......t..s......**...#.....#
#.t...#...**................**...#..q..#
#.....#..........................#.....#
#.....#..t..s...p...ab.....s..t..#.ab..#
##\\...#.............cd..p........#.cd..#
###...##\\.............z......../##.....#
#.....###\\....{..........}..../###.....#
#.....#.......{...p@.....}.......#..p..#
#...p.#....s..........--.........#.....#
#.....#..q..................s.q..#.....#
#.....#.......t.mM##Ww...t.......#.....#
#[...]#[........................]#[...]#
########################################
";

pub(super) static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'*', TileKind::FULL.with_flags(SPONGE))
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'-', TileKind::of(TileShape::HalfTop))
    .with(b'{', TileKind::of(TileShape::HalfLeft))
    .with(b'}', TileKind::of(TileShape::HalfRight))
    .with(b'(', TileKind::of(TileShape::ConcaveTopLeft))
    .with(b')', TileKind::of(TileShape::ConcaveTopRight))
    .with(b']', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'[', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'7', TileKind::of(TileShape::SlopeTopRight))
    .with(b'P', TileKind::of(TileShape::SlopeTopLeft))
    .with(b'm', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'M', TileKind::of(TileShape::MildHighBottomRight))
    .with(b'W', TileKind::of(TileShape::MildHighBottomLeft))
    .with(b'w', TileKind::of(TileShape::MildLowBottomLeft))
    // A disc of four quarters, solid toward its middle.
    .with(b'a', TileKind::of(TileShape::ConvexBottomRight))
    .with(b'b', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'c', TileKind::of(TileShape::ConvexTopRight))
    .with(b'd', TileKind::of(TileShape::ConvexTopLeft));

pub type Level = TileMap<'static, AllShapes>;

pub fn level() -> Result<Level, TileMapError> {
    TileMap::of_ascii(ROWS, &KINDS)
}

/// All kinds of tiles.
pub fn bounds() -> Option<Aabb> {
    Aabb::new(Vec2::ZERO, Vec2::from_ints(16 * i16::from(SIZE.0), 16 * i16::from(SIZE.1))).ok()
}

/// The bodies that start in each cell, row by row, with the direction of their motion.
pub(super) fn posts() -> impl Iterator<Item = (Kind, (u8, u8), (i8, i8))> {
    let (mut x, mut y) = (0, 0);
    ROWS.bytes().filter_map(move |tile| {
        let at = (x, y);
        (x, y) = if tile == b'\n' { (0, y + 1) } else { (x + 1, y) };
        let (kind, course) = match tile {
            b't' => (Kind::Turret, (0, 0)),
            b's' => (Kind::Spinner, (0, 0)),
            b'p' => (Kind::Patrol, (1, 0)),
            b'q' => (Kind::Patrol, (0, 1)),
            b'@' => (Kind::Player, (0, 0)),
            b'z' => (Kind::Zone, (0, 0)),
            _ => return None,
        };
        Some((kind, at, course))
    })
}
