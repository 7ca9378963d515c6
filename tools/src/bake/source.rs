//! Writes levels as Rust source.

use std::fmt::Write;

use tilesat::{Fx, PathKind, Vec2};

use super::bundle::Bundle;
use super::level::Level;
use super::segments::Shapes;
use super::{Baked, items, names, things};
use crate::fail::one_line;
use crate::rules::outline::LeftOut;

/// The compiler takes too long to build a map with more segments than this. Such a level includes
/// bytes.
const MOST_BUILT: u16 = 300;

const HEAD: &str = "//! Written by `tilesat bake LEVEL -o OUT.rs`. Do not edit it.\n\
                    #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\
                    #![allow(dead_code, reason = \"a game may use only a part\")]\n\
                    #![allow(clippy::unreadable_literal, reason = \"raw coordinates\")]\n\n";

/// The source of the bytes.
pub(crate) enum Bytes {
    /// In the Rust source itself.
    Here,
    /// In files beside the source, for the tiles and for the segments.
    Files(String, String),
}

/// Writes constants, the tiles, and the objects as `segment_map!` takes them: the compiler builds
/// and checks the map. Several levels are modules, and share the table of kinds.
pub(crate) fn source(bundle: &Bundle) -> String {
    HEAD.to_owned() + &items(bundle)
}

/// The same without the attributes that only the start of a file can have.
pub(crate) fn items(bundle: &Bundle) -> String {
    let mut text = String::new();
    let flags = flags(bundle);
    if let [level] = &bundle.levels[..] {
        alone(&mut text, level, &flags, &Bytes::Here);
    } else {
        text += &several(bundle);
    }
    text
}

/// A module for each level, and their shared items. It belongs into a module.
pub(crate) fn several(bundle: &Bundle) -> String {
    let mut text = format!("use ::tilesat::{};\n\n", items::imports(&bundle.kinds));
    text += &items::flags(&flags(bundle));
    text += "/// The meaning of the ids of all levels.\n#[rustfmt::skip]\n";
    text += &items::kinds(&bundle.kinds);
    let objects = bundle.levels.iter().any(has_objects);
    if objects {
        text += things::TYPE;
    }
    for (level, module) in bundle.levels.iter().zip(modules(bundle)) {
        let title = one_line(&level.ground.name);
        let _ = writeln!(text, "\n/// {title}\npub mod {module} {{");
        let mut inner = String::new();
        if let Some(tiles) = &level.tiles {
            inner += "use super::KINDS;\n\n";
            inner += &items::size(tiles);
            inner += &items::tiles(tiles, &bytes(&tiles.tiles, usize::from(tiles.width)));
            map(&mut inner, tiles);
        }
        if objects {
            inner += things::IMPORT;
            inner += &things::list(&level.ground.left_out);
        }
        rest(&mut inner, level, &Bytes::Here);
        // A byte string continues after any white space at the start of a line.
        let lines = inner.lines().map(|line| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") });
        text.extend(lines);
        text += "}\n";
    }
    text
}

/// The module of each level.
pub(crate) fn modules(bundle: &Bundle) -> Vec<String> {
    names::modules(bundle.levels.iter().map(|level| level.ground.name.as_str()))
}

/// The facts that a level's bytes do not contain, as source that includes the bytes.
pub(crate) fn beside(bundle: &Bundle, level: &Baked, tiles: String, segments: String) -> String {
    let mut text = HEAD.replace("OUT.rs", "OUT.bin");
    alone(&mut text, level, &flags(bundle), &Bytes::Files(tiles, segments));
    text
}

fn flags(bundle: &Bundle) -> Vec<(String, u8)> {
    constants(&bundle.flags)
}

/// The constant of each flag, and its bit.
pub(crate) fn constants(flags: &[String]) -> Vec<(String, u8)> {
    names::constants(flags.iter().map(String::as_str)).into_iter().zip((0..8).map(|bit| 1 << bit)).collect()
}

fn alone(text: &mut String, level: &Baked, flags: &[(String, u8)], from: &Bytes) {
    if let Some(tiles) = &level.tiles {
        let _ = writeln!(text, "use ::tilesat::{};\n", items::imports(&tiles.ids));
        *text += &items::size(tiles);
        *text += &items::flags(flags);
        let bytes = match from {
            Bytes::Here => bytes(&tiles.tiles, usize::from(tiles.width)),
            Bytes::Files(file, _) => format!("include_bytes!({file:?})"),
        };
        *text += &items::tiles(tiles, &bytes);
        *text += "#[rustfmt::skip]\n";
        *text += &items::kinds(&tiles.ids);
        map(text, tiles);
    } else {
        *text += &items::flags(flags).replace("/// The flag bits of the game's rules.\n", "");
    }
    if has_objects(level) {
        *text += things::TYPE;
        *text += &things::list(&level.ground.left_out);
    }
    rest(text, level, from);
}

fn has_objects(level: &Baked) -> bool {
    level.ground.left_out.iter().any(LeftOut::is_listed)
}

/// The position of a level, and its segments.
fn rest(text: &mut String, level: &Baked, from: &Bytes) {
    if let Some(place) = level.ground.place {
        let (x, y, width, height) = (place.x, place.y, place.width, place.height);
        let _ = writeln!(
            text,
            "/// Its position in its world, in pixels of the map: x, y, width, height.\npub const WORLD: [i32; 4] = [{x}, {y}, {width}, {height}];"
        );
    }
    if level.ground.shift != (0, 0) {
        let (x, y) = level.ground.shift;
        let _ = writeln!(
            text,
            "/// Add this to a position of the map to get it here, in pixels.\npub const SHIFT: [i32; 2] = [{x}, {y}];"
        );
    }
    if let Some((shapes, bytes, cell)) = &level.objects {
        let count = bytes.get(6..8).map_or(0, |count| u16::from_le_bytes([count[0], count[1]]));
        match from {
            Bytes::Here if count <= MOST_BUILT => built(text, shapes, *cell),
            Bytes::Here => included(text, &self::bytes(bytes, 64)),
            Bytes::Files(_, file) => included(text, &format!("include_bytes!({file:?})")),
        }
    }
}

/// The map of the tiles.
fn map(text: &mut String, level: &Level) {
    let (tile, bytes) = (Fx::from_num(level.tile), level.tiles.len());
    let set = items::set(&level.ids);
    let (origin, place) = match level.origin {
        (0, 0) => ("::tilesat::Vec2::ZERO".to_owned(), "at the origin"),
        (x, y) => (format!("::tilesat::Vec2::from_raw({x}, {y})"), "at this place"),
    };
    let _ = write!(
        text,
        "/// Where the cells are: the first corner is {place}.\n\
         #[rustfmt::skip]\n\
         pub const GRID: ::tilesat::Grid = match ::tilesat::Grid::new(WIDTH, HEIGHT, ::tilesat::Fx::lit(\"{tile}\"), {origin}) {{\n    \
         Ok(grid) => grid,\n    \
         Err(_) => panic!(\"the cells do not fit\"),\n\
         }};\n\
         /// The level as it was drawn, with nothing outside.\n\
         pub static MAP: ::tilesat::TileMap<::tilesat::{set}> = match map(TILES) {{\n    \
         Ok(map) => map,\n    \
         Err(_) => panic!(\"the tiles do not fit\"),\n\
         }};\n\
         /// The level of other tiles, such as a copy of `TILES` in RAM that the game changes.\n\
         ///\n\
         /// # Errors\n\
         /// None: the array has the size of the level, and the set has all kinds.\n\
         #[rustfmt::skip]\n\
         pub const fn map(tiles: &[u8; {bytes}]) -> Result<::tilesat::TileMap<'_, ::tilesat::{set}>, ::tilesat::TileMapError> {{\n    \
         ::tilesat::TileMap::of(tiles, GRID, &KINDS)\n\
         }}\n"
    );
}

fn included(text: &mut String, bytes: &str) {
    let _ = write!(
        text,
        "/// Polygons and chains, built beforehand.\n\
         #[allow(long_running_const_eval, reason = \"it ends, because the level is finite\")]\n\
         #[rustfmt::skip]\n\
         pub static SEGMENTS: ::tilesat::SegmentMap = match ::tilesat::SegmentMap::from_bytes({bytes}) {{\n    \
         Ok(map) => map,\n    \
         Err(_) => panic!(\"the segments are damaged\"),\n\
         }};\n"
    );
}

fn built(text: &mut String, shapes: &Shapes, cell: Fx) {
    text.push_str("\nuse ::tilesat::{Fx, Path, PathKind, Vec2, segment_map};\n\n");
    for (i, points) in shapes.points.iter().enumerate() {
        let _ = writeln!(text, "#[rustfmt::skip]\nconst POINTS_{i}: [Vec2; {}] = [", points.len());
        for point in points {
            let _ = writeln!(text, "    {},", spot(*point));
        }
        text.push_str("];\n");
    }
    let attribute = "#[allow(long_running_const_eval, reason = \"it ends, because the level is finite\")]";
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

fn spot(point: Vec2) -> String {
    let (x, y) = point.raw();
    match (x % 65536, y % 65536) {
        (0, 0) => format!("Vec2::from_ints({}, {})", x >> 16, y >> 16),
        _ => format!("Vec2::from_raw({x}, {y})"),
    }
}

/// Bytes in rows.
pub(crate) fn bytes(tiles: &[u8], row: usize) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let mut text = String::with_capacity(tiles.len() * 4 + tiles.len() / row.max(1) * 8 + 16);
    text.push_str("b\"\\\n");
    for line in tiles.chunks(row.max(1)) {
        text.push_str("    ");
        for id in line {
            let digit = |value: u8| char::from(DIGITS[usize::from(value)]);
            text.extend(['\\', 'x', digit(id >> 4), digit(id & 15)]);
        }
        text.push_str("\\\n");
    }
    text + "\""
}
