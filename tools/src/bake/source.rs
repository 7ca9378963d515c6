//! A level as Rust source.

use std::fmt::Write;

use tilesat::{Fx, Grid, PathKind, Vec2};

use super::items::items;
use super::level::Level;
use super::segments::Shapes;

/// Constants, the tiles, and the objects as `segment_map!` takes them, so that the compiler builds and checks the map.
pub(crate) fn source(level: Option<&Level>, objects: Option<(&Shapes, Fx)>, flags: &[String]) -> String {
    let mut text = "//! Written by `tilesat bake LEVEL -o OUT.rs`; not edited by hand.\n\
                    #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\
                    #![allow(clippy::unreadable_literal, reason = \"raw coordinates\")]\n\n"
        .to_owned();
    let named: Vec<(String, u8)> = flags.iter().enumerate().map(|(bit, name)| (constant(name), 1 << bit)).collect();
    if let Some(level) = level {
        let items = items(level, &named, &bytes(&level.tiles, usize::from(level.width)));
        text += &items.replace("pub static KINDS", "#[rustfmt::skip]\npub static KINDS");
        text += &map(level);
    }
    // Writing to a string cannot fail.
    if let Some((shapes, cell)) = objects {
        if level.is_none() {
            for (name, mask) in &named {
                let _ = writeln!(text, "pub const {name}: u8 = {mask};");
            }
        }
        segments(&mut text, shapes, cell);
    }
    text
}

/// The map of the tiles, for levels that fit the library's domain.
fn map(level: &Level) -> String {
    let tile = Fx::from_num(level.tile);
    if Grid::new(level.width, level.height, tile, Vec2::ZERO).is_err() {
        return String::new();
    }
    let set = if level.is_blocks() { "Blocks" } else { "AllShapes" };
    format!(
        "/// The tiles as a level whose first corner is at the origin, with nothing outside.\n\
         pub static MAP: tilesat::TileMap<tilesat::{set}> =\n    \
         match tilesat::Grid::new(WIDTH, HEIGHT, tilesat::Fx::lit(\"{tile}\"), tilesat::Vec2::ZERO) {{\n        \
         Ok(grid) => match tilesat::TileMap::of(TILES, grid, &KINDS) {{\n            \
         Ok(map) => map,\n            \
         Err(_) => panic!(\"the tiles do not fit\"),\n        \
         }},\n        \
         Err(_) => panic!(\"the cells do not fit\"),\n    \
         }};\n"
    )
}

fn segments(text: &mut String, shapes: &Shapes, cell: Fx) {
    text.push_str("\nuse tilesat::{Fx, Path, PathKind, Vec2, segment_map};\n\n");
    for (i, points) in shapes.points.iter().enumerate() {
        let _ = writeln!(text, "#[rustfmt::skip]\nconst POINTS_{i}: [Vec2; {}] = [", points.len());
        for point in points {
            let (x, y) = point.raw();
            let _ = match (x % 65536, y % 65536) {
                (0, 0) => writeln!(text, "    Vec2::from_ints({}, {}),", x >> 16, y >> 16),
                _ => writeln!(text, "    Vec2::from_raw({x}, {y}),"),
            };
        }
        text.push_str("];\n");
    }
    let attribute = "#[allow(long_running_const_eval, reason = \"it ends: the level is as large as it is\")]";
    let _ = writeln!(text, "\nsegment_map!(\n    {attribute}\n    pub static SEGMENTS: [");
    for (i, &(kind, flags)) in shapes.kinds.iter().enumerate() {
        let kind = match kind {
            PathKind::Solid => "Solid",
            PathKind::Hole => "Hole",
            PathKind::Wall => "Wall",
            PathKind::OneWay => "OneWay",
        };
        let flags = if flags == 0 { String::new() } else { format!(".with_flags({flags})") };
        let _ = writeln!(text, "        Path::new(PathKind::{kind}, &POINTS_{i}){flags},");
    }
    let _ = writeln!(text, "    ],\n    Fx::lit(\"{cell}\")\n);");
}

/// Bytes in rows.
fn bytes(tiles: &[u8], row: usize) -> String {
    let mut text = "b\"\\\n".to_owned();
    for line in tiles.chunks(row.max(1)) {
        text.push_str("    ");
        for id in line {
            let _ = write!(text, "\\x{id:02x}");
        }
        text.push_str("\\\n");
    }
    text + "\""
}

/// `FLAG_` and the name in capitals, with nothing that is no identifier.
fn constant(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    format!("FLAG_{}", name.chars().map(plain).collect::<String>())
}
