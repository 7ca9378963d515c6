//! The Rust items of a level of tiles.

use std::fmt::Write;

use tilesat::TileShape;

use super::level::Level;

/// Constants and statics, with the names of flag bits, and the expression that the bytes of the tiles are.
pub(crate) fn items(level: &Level, flags: &[(String, u8)], bytes: &str) -> String {
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
