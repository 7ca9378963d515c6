//! Written by `cargo run --example platformer -- LEVEL.tmx --bake STEM`. Do not edit it.
#![allow(unreachable_pub, reason = "a level is a module of a program")]

use tilesat::{TileKind, TileKinds};

pub const WIDTH: u16 = 60;
pub const HEIGHT: u16 = 24;
/// Side of a tile in pixels.
pub const TILE: u16 = 16;
/// The flag bits of the game's rules.
pub const COIN: u8 = 1;
pub const KILL: u8 = 8;
pub const WIN: u8 = 4;
pub const LADDER: u8 = 2;
/// Row by row.
pub static TILES: &[u8; 1440] = include_bytes!("meadow.bin");
pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::EMPTY.with_flags(1))
    .with(3, TileKind::ONE_WAY_UP)
    .with(4, TileKind::EMPTY.with_flags(2))
    .with(5, TileKind::EMPTY.with_flags(4))
    .with(6, TileKind::EMPTY.with_flags(8));
