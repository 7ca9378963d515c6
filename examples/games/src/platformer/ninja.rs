//! Written by `cargo run --example platformer -- LEVEL.tmx --bake STEM`. Do not edit it.
#![allow(unreachable_pub, reason = "a level is a module of a program")]

use tilesat::{TileKind, TileKinds, TileShape};

pub const WIDTH: u16 = 48;
pub const HEIGHT: u16 = 27;
/// Side of a tile in pixels.
pub const TILE: u16 = 24;
/// The flag bits of the game's rules.
pub const COIN: u8 = 1;
pub const KILL: u8 = 8;
pub const WIN: u8 = 2;
pub const LADDER: u8 = 4;
/// Row by row.
pub static TILES: &[u8; 1296] = include_bytes!("ninja.bin");
pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::of(TileShape::MildLowTopRight))
    .with(3, TileKind::of(TileShape::MildHighTopRight))
    .with(4, TileKind::of(TileShape::MildHighTopLeft))
    .with(5, TileKind::of(TileShape::MildLowTopLeft))
    .with(6, TileKind::of(TileShape::SlopeTopRight))
    .with(7, TileKind::of(TileShape::SlopeTopLeft))
    .with(8, TileKind::of(TileShape::ConcaveTopRight))
    .with(9, TileKind::of(TileShape::ConcaveTopLeft))
    .with(10, TileKind::of(TileShape::SteepHighTopRight))
    .with(11, TileKind::of(TileShape::SteepHighTopLeft))
    .with(12, TileKind::of(TileShape::ConvexTopRight))
    .with(13, TileKind::of(TileShape::ConvexTopLeft))
    .with(14, TileKind::of(TileShape::SteepLowTopRight))
    .with(15, TileKind::of(TileShape::SteepLowTopLeft))
    .with(16, TileKind::of(TileShape::OneWayRight))
    .with(17, TileKind::of(TileShape::ConcaveBottomLeft))
    .with(18, TileKind::EMPTY.with_flags(1))
    .with(19, TileKind::ONE_WAY_UP)
    .with(20, TileKind::of(TileShape::HalfLeft))
    .with(21, TileKind::of(TileShape::HalfTop))
    .with(22, TileKind::of(TileShape::ConvexBottomRight))
    .with(23, TileKind::of(TileShape::ConvexBottomLeft))
    .with(24, TileKind::of(TileShape::ConcaveBottomRight))
    .with(25, TileKind::of(TileShape::OneWayLeft))
    .with(26, TileKind::of(TileShape::SlopeBottomLeft))
    .with(27, TileKind::EMPTY.with_flags(2))
    .with(28, TileKind::of(TileShape::MildLowBottomRight))
    .with(29, TileKind::of(TileShape::MildHighBottomRight))
    .with(30, TileKind::of(TileShape::MildHighBottomLeft))
    .with(31, TileKind::of(TileShape::MildLowBottomLeft))
    .with(32, TileKind::of(TileShape::HalfRight))
    .with(33, TileKind::EMPTY.with_flags(4))
    .with(34, TileKind::of(TileShape::SteepLowBottomRight))
    .with(35, TileKind::of(TileShape::SteepLowBottomLeft))
    .with(36, TileKind::of(TileShape::SteepHighBottomRight))
    .with(37, TileKind::of(TileShape::SteepHighBottomLeft))
    .with(38, TileKind::of(TileShape::SlopeBottomRight))
    .with(39, TileKind::EMPTY.with_flags(8))
    .with(40, TileKind::of(TileShape::HalfBottom))
    .with(41, TileKind::of(TileShape::OneWayDown))
    .with(42, TileKind::of(TileShape::ConcaveBottomLeft).with_flags(16))
    .with(43, TileKind::EMPTY.with_flags(16))
    .with(44, TileKind::of(TileShape::ConcaveBottomRight).with_flags(16));
