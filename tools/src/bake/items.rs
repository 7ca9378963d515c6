//! The Rust items of a tile level.

use std::fmt::Write;

use tilesat::world::ShapeSet;
use tilesat::{Blocks, Slopes, TileKind, TileShape};

use super::level::Level;

/// The imports for the items of a table.
pub(crate) fn imports(kinds: &[TileKind]) -> &'static str {
    let plain = kinds.iter().all(|k| matches!(k.shape, TileShape::Empty | TileShape::Full | TileShape::OneWayUp));
    if plain { "{TileKind, TileKinds}" } else { "{TileKind, TileKinds, TileShape}" }
}

/// The smallest set of shapes that holds a table: it links the least code.
pub(crate) fn set(kinds: &[TileKind]) -> &'static str {
    let within = |shapes: u64| kinds.iter().all(|kind| shapes >> kind.shape as u8 & 1 != 0);
    if within(Blocks::SHAPES) {
        "Blocks"
    } else if within(Slopes::SHAPES) {
        "Slopes"
    } else {
        "AllShapes"
    }
}

/// Constants for the number, size and position of the cells.
pub(crate) fn size(level: &Level) -> String {
    let (width, height, tile) = (level.width, level.height, level.tile);
    format!(
        "pub const WIDTH: u16 = {width};\n\
         pub const HEIGHT: u16 = {height};\n\
         /// Side of a tile in pixels.\n\
         pub const TILE: u16 = {tile};\n"
    )
}

/// The bits of the game's rules.
pub(crate) fn flags(named: &[(String, u8)]) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    for (i, (name, mask)) in named.iter().enumerate() {
        let comment = if i == 0 { "/// The flag bits of the game's rules.\n" } else { "" };
        let _ = writeln!(text, "{comment}pub const {name}: u8 = {mask};");
    }
    text
}

/// The tiles, with the expression for their bytes.
pub(crate) fn tiles(level: &Level, bytes: &str) -> String {
    format!("/// Row by row.\npub static TILES: &[u8; {}] = {bytes};\n", level.tiles.len())
}

/// The table with the meaning of the ids.
pub(crate) fn kinds(ids: &[TileKind]) -> String {
    let mut text = "pub static KINDS: TileKinds = TileKinds::EMPTY".to_owned();
    for (id, kind) in ids.iter().enumerate().skip(1) {
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
