//! Written by `tilesat bake LEVEL -o OUT.rs`. Do not edit it.
#![allow(unreachable_pub, reason = "a level is a module of a program")]
#![allow(dead_code, reason = "a game may use only a part")]
#![allow(clippy::unreadable_literal, reason = "raw coordinates")]

use ::tilesat::{TileKind, TileKinds, TileShape};

pub const WIDTH: u16 = 24;
pub const HEIGHT: u16 = 14;
/// Side of a tile in pixels.
pub const TILE: u16 = 16;
/// The flag bits of the game's rules.
pub const FLAG_COIN: u8 = 1;
pub const FLAG_KILL: u8 = 2;
pub const FLAG_LADDER: u8 = 4;
pub const FLAG_WATER: u8 = 8;
pub const FLAG_ICE: u8 = 16;
/// Row by row.
pub static TILES: &[u8; 336] = b"\
    \x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\x02\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x03\x03\x03\x03\x03\x03\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x04\x04\x04\x04\x04\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x05\x06\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x05\x01\x01\x00\x01\
    \x01\x00\x00\x00\x00\x07\x01\x01\x08\x00\x00\x00\x00\x00\x00\x00\x00\x09\x0a\x01\x01\x01\x0b\x01\
    \x01\x00\x00\x00\x07\x01\x01\x01\x01\x08\x00\x00\x00\x00\x00\x09\x0a\x01\x01\x01\x01\x01\x0b\x01\
    \x01\x02\x00\x07\x01\x01\x01\x01\x01\x01\x08\x00\x00\x02\x00\x01\x01\x01\x01\x01\x01\x01\x0c\x01\
    \x01\x0d\x0e\x01\x01\x01\x01\x01\x01\x01\x01\x0f\x10\x01\x01\x01\x01\x01\x01\x01\x01\x0c\x0c\x01\
    \x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\
    \x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\
";
#[rustfmt::skip]
pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::EMPTY.with_flags(1))
    .with(3, TileKind::ONE_WAY_UP)
    .with(4, TileKind::of(TileShape::HalfTop).with_flags(2))
    .with(5, TileKind::of(TileShape::ConvexBottomRight))
    .with(6, TileKind::of(TileShape::ConvexBottomLeft))
    .with(7, TileKind::of(TileShape::SlopeBottomRight))
    .with(8, TileKind::of(TileShape::SlopeBottomLeft))
    .with(9, TileKind::of(TileShape::MildLowBottomRight))
    .with(10, TileKind::of(TileShape::MildHighBottomRight))
    .with(11, TileKind::EMPTY.with_flags(4))
    .with(12, TileKind::EMPTY.with_flags(8))
    .with(13, TileKind::of(TileShape::MildLowBottomRight).with_flags(16))
    .with(14, TileKind::of(TileShape::MildHighBottomRight).with_flags(16))
    .with(15, TileKind::of(TileShape::SteepLowBottomLeft))
    .with(16, TileKind::of(TileShape::ConcaveBottomRight));
/// Where the cells are: the first corner is at the origin.
#[rustfmt::skip]
pub const GRID: ::tilesat::Grid = match ::tilesat::Grid::new(WIDTH, HEIGHT, ::tilesat::Fx::lit("16"), ::tilesat::Vec2::ZERO) {
    Ok(grid) => grid,
    Err(_) => panic!("the cells do not fit"),
};
/// The level as it was drawn, with nothing outside.
pub static MAP: ::tilesat::TileMap<::tilesat::AllShapes> = match map(TILES) {
    Ok(map) => map,
    Err(_) => panic!("the tiles do not fit"),
};
/// The level of other tiles, such as a copy of `TILES` in RAM that the game changes.
///
/// # Errors
/// None: the array has the size of the level, and the set has all kinds.
#[rustfmt::skip]
pub const fn map(tiles: &[u8; 336]) -> Result<::tilesat::TileMap<'_, ::tilesat::AllShapes>, ::tilesat::TileMapError> {
    ::tilesat::TileMap::of(tiles, GRID, &KINDS)
}
/// Its position in its world, in pixels of the map: x, y, width, height.
pub const WORLD: [i32; 4] = [0, 0, 384, 224];
