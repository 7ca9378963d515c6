//! Writes a level as a firmware includes it: the tile bytes, and the constants that go with them.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use tilesat::TileShape;

use super::fail::{Fail, Result};
use super::level::Level;

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
    let head = "//! Written by `cargo run --example platformer -- LEVEL.tmx --bake STEM`; not edited by hand.\n\
                #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\n";
    let rules = level.rules();
    let flags = [("COIN", rules.coin), ("KILL", rules.kill), ("WIN", rules.win), ("LADDER", rules.ladder)];
    let flags = flags.map(|(name, mask)| (name.to_owned(), mask));
    head.to_owned() + &items(level, &flags, &format!("include_bytes!({bin:?})"))
}

/// The items of that source, with the names of flag bits, and the expression that the bytes of the tiles are.
pub fn items(level: &Level, flags: &[(String, u8)], bytes: &str) -> String {
    let (width, height, tile) = (level.width, level.height, level.tile);
    let count = level.tiles.len();
    let plain = level.ids.iter().all(|k| matches!(k.shape, TileShape::Empty | TileShape::Full | TileShape::OneWayUp));
    let imports = if plain { "{TileKind, TileKinds}" } else { "{TileKind, TileKinds, TileShape}" };
    let mut text = format!(
        "use tilesat::{imports};\n\n\
         pub const WIDTH: u16 = {width};\n\
         pub const HEIGHT: u16 = {height};\n\
         /// Side of a tile in pixels.\n\
         pub const TILE: u16 = {tile};\n"
    );
    // Writing to a string cannot fail.
    for (i, (name, mask)) in flags.iter().enumerate() {
        let comment = if i == 0 { "/// The flag bits of the game's rules.\n" } else { "" };
        let _ = writeln!(text, "{comment}pub const {name}: u8 = {mask};");
    }
    let _ = writeln!(text, "/// Row by row.\npub static TILES: &[u8; {count}] = {bytes};");
    text.push_str("pub static KINDS: TileKinds = TileKinds::EMPTY");
    for (id, kind) in level.ids.iter().enumerate().skip(1) {
        let shape = match kind.shape {
            TileShape::Empty => "EMPTY".to_owned(),
            TileShape::Full => "FULL".to_owned(),
            TileShape::OneWayUp => "ONE_WAY_UP".to_owned(),
            other => format!("of(TileShape::{other:?})"),
        };
        let flags = kind.flags;
        let flags = if flags == 0 { String::new() } else { format!(".with_flags({flags})") };
        let _ = write!(text, "\n    .with({id}, TileKind::{shape}{flags})");
    }
    text.push_str(";\n");
    text
}
