//! Written by `tilesat bake LEVEL -o OUT.rs`. Do not edit it.
#![allow(unreachable_pub, reason = "a level is a module of a program")]
#![allow(dead_code, reason = "a game may use only a part")]
#![allow(clippy::unreadable_literal, reason = "raw coordinates")]

use ::tilesat::{TileKind, TileKinds};

/// The flag bits of the game's rules.
pub const FLAG_LADDER: u8 = 1;
pub const FLAG_WATER: u8 = 2;
/// The meaning of the ids of all levels.
#[rustfmt::skip]
pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::EMPTY.with_flags(1))
    .with(3, TileKind::EMPTY.with_flags(2));

/// Cave 1
pub mod cave_1 {
    use super::KINDS;

    pub const WIDTH: u16 = 8;
    pub const HEIGHT: u16 = 6;
    /// Side of a tile in pixels.
    pub const TILE: u16 = 16;
    /// Row by row.
    pub static TILES: &[u8; 48] = b"\
        \x01\x00\x00\x00\x00\x00\x00\x01\
        \x01\x00\x00\x00\x00\x00\x00\x01\
        \x01\x00\x00\x02\x02\x00\x00\x01\
        \x01\x00\x00\x00\x00\x00\x00\x01\
        \x01\x03\x00\x00\x00\x00\x00\x01\
        \x01\x01\x01\x01\x01\x01\x01\x01\
    ";
    /// Where the cells are: the first corner is at the origin.
    #[rustfmt::skip]
    pub const GRID: ::tilesat::Grid = match ::tilesat::Grid::new(WIDTH, HEIGHT, ::tilesat::Fx::lit("16"), ::tilesat::Vec2::ZERO) {
        Ok(grid) => grid,
        Err(_) => panic!("the cells do not fit"),
    };
    /// The level as it was drawn, with nothing outside.
    pub static MAP: ::tilesat::TileMap<::tilesat::Blocks> = match map(TILES) {
        Ok(map) => map,
        Err(_) => panic!("the tiles do not fit"),
    };
    /// The level of other tiles, such as a copy of `TILES` in RAM that the game changes.
    ///
    /// # Errors
    /// None: the array has the size of the level, and the set has all kinds.
    #[rustfmt::skip]
    pub const fn map(tiles: &[u8; 48]) -> Result<::tilesat::TileMap<'_, ::tilesat::Blocks>, ::tilesat::TileMapError> {
        ::tilesat::TileMap::of(tiles, GRID, &KINDS)
    }
    /// Its position in its world, in pixels of the map: x, y, width, height.
    pub const WORLD: [i32; 4] = [0, 0, 128, 96];
}

/// Cave-1
pub mod cave_1_2 {
    use super::KINDS;

    pub const WIDTH: u16 = 8;
    pub const HEIGHT: u16 = 6;
    /// Side of a tile in pixels.
    pub const TILE: u16 = 16;
    /// Row by row.
    pub static TILES: &[u8; 48] = b"\
        \x01\x01\x01\x01\x01\x01\x01\x01\
        \x01\x01\x01\x01\x01\x01\x01\x01\
        \x01\x01\x01\x01\x01\x01\x01\x01\
        \x01\x01\x01\x01\x01\x01\x01\x01\
        \x01\x01\x01\x01\x01\x01\x01\x01\
        \x01\x01\x01\x01\x01\x01\x01\x01\
    ";
    /// Where the cells are: the first corner is at the origin.
    #[rustfmt::skip]
    pub const GRID: ::tilesat::Grid = match ::tilesat::Grid::new(WIDTH, HEIGHT, ::tilesat::Fx::lit("16"), ::tilesat::Vec2::ZERO) {
        Ok(grid) => grid,
        Err(_) => panic!("the cells do not fit"),
    };
    /// The level as it was drawn, with nothing outside.
    pub static MAP: ::tilesat::TileMap<::tilesat::Blocks> = match map(TILES) {
        Ok(map) => map,
        Err(_) => panic!("the tiles do not fit"),
    };
    /// The level of other tiles, such as a copy of `TILES` in RAM that the game changes.
    ///
    /// # Errors
    /// None: the array has the size of the level, and the set has all kinds.
    #[rustfmt::skip]
    pub const fn map(tiles: &[u8; 48]) -> Result<::tilesat::TileMap<'_, ::tilesat::Blocks>, ::tilesat::TileMapError> {
        ::tilesat::TileMap::of(tiles, GRID, &KINDS)
    }
    /// Its position in its world, in pixels of the map: x, y, width, height.
    pub const WORLD: [i32; 4] = [128, 0, 128, 96];
}

/// Hall
pub mod hall {
    use super::KINDS;

    pub const WIDTH: u16 = 8;
    pub const HEIGHT: u16 = 6;
    /// Side of a tile in pixels.
    pub const TILE: u16 = 16;
    /// Row by row.
    pub static TILES: &[u8; 48] = b"\
        \x03\x03\x03\x03\x03\x03\x03\x03\
        \x00\x00\x00\x00\x00\x00\x00\x00\
        \x00\x00\x00\x00\x00\x00\x00\x00\
        \x00\x00\x00\x00\x00\x00\x00\x00\
        \x00\x00\x00\x00\x00\x00\x00\x00\
        \x01\x01\x01\x01\x01\x01\x01\x01\
    ";
    /// Where the cells are: the first corner is at the origin.
    #[rustfmt::skip]
    pub const GRID: ::tilesat::Grid = match ::tilesat::Grid::new(WIDTH, HEIGHT, ::tilesat::Fx::lit("16"), ::tilesat::Vec2::ZERO) {
        Ok(grid) => grid,
        Err(_) => panic!("the cells do not fit"),
    };
    /// The level as it was drawn, with nothing outside.
    pub static MAP: ::tilesat::TileMap<::tilesat::Blocks> = match map(TILES) {
        Ok(map) => map,
        Err(_) => panic!("the tiles do not fit"),
    };
    /// The level of other tiles, such as a copy of `TILES` in RAM that the game changes.
    ///
    /// # Errors
    /// None: the array has the size of the level, and the set has all kinds.
    #[rustfmt::skip]
    pub const fn map(tiles: &[u8; 48]) -> Result<::tilesat::TileMap<'_, ::tilesat::Blocks>, ::tilesat::TileMapError> {
        ::tilesat::TileMap::of(tiles, GRID, &KINDS)
    }
    /// Its position in its world, in pixels of the map: x, y, width, height.
    pub const WORLD: [i32; 4] = [-128, 96, 128, 96];
}
