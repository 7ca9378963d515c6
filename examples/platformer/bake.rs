//! Writes a level as a firmware includes it: the tile bytes, and the constants that go with them.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use super::fail::{Fail, Result};
use super::level::{Block, Level};

/// Writes `STEM.bin` and `STEM.rs`.
pub fn write(level: &Level, stem: &Path) -> Result<[PathBuf; 2]> {
    let files = [stem.with_extension("bin"), stem.with_extension("rs")];
    let name = files[0].file_name().unwrap_or_default().to_string_lossy();
    let constants = constants(level, &name);
    for (file, bytes) in files.iter().zip([&level.tiles[..], constants.as_bytes()]) {
        fs::write(file, bytes).map_err(|e| Fail::new(format!("cannot write {}: {e}", file.display())))?;
    }
    Ok(files)
}

/// The Rust source that stands beside the bytes in the file `bin`.
pub fn constants(level: &Level, bin: &str) -> String {
    let (width, height, tile) = (level.width, level.height, level.tile);
    let rules = level.rules();
    let count = level.tiles.len();
    let mut text = format!(
        "//! Written by `cargo run --example platformer -- LEVEL.tmx --bake STEM`; not edited by hand.\n\
         #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\n\
         use tilesat::{{TileKind, TileKinds}};\n\n\
         pub const WIDTH: u16 = {width};\n\
         pub const HEIGHT: u16 = {height};\n\
         /// Side of a tile in pixels.\n\
         pub const TILE: u16 = {tile};\n\
         /// The flag bits of the game's rules.\n\
         pub const COIN: u8 = {};\n\
         pub const KILL: u8 = {};\n\
         pub const WIN: u8 = {};\n\
         pub const LADDER: u8 = {};\n\
         /// Row by row.\n\
         pub static TILES: &[u8; {count}] = include_bytes!({bin:?});\n",
        rules.coin, rules.kill, rules.win, rules.ladder
    );
    text.push_str("pub static KINDS: TileKinds = TileKinds::EMPTY");
    for (id, &(block, flags)) in level.ids.iter().enumerate().skip(1) {
        let shape = match block {
            Block::Nothing => "EMPTY",
            Block::All => "FULL",
            Block::FromAbove => "ONE_WAY_UP",
        };
        let flags = if flags == 0 { String::new() } else { format!(".with_flags({flags})") };
        // Writing to a string cannot fail.
        let _ = write!(text, "\n    .with({id}, TileKind::{shape}{flags})");
    }
    text.push_str(";\n");
    text
}
