//! Writes a world as Rust source.

use std::fmt::Write;

use super::{Baked, Whole, World};
use crate::bake::source::{bytes, constants};
use crate::bake::{items, names, things};

/// The tiles, the table of rooms, and the segments of those that have some.
pub(crate) fn source(world: &World) -> String {
    let mut text = "//! Written by `tilesat rooms LEVEL -o OUT.rs`. Do not edit it.\n\
                    #![allow(unreachable_pub, reason = \"a world is a module of a program\")]\n\
                    #![allow(dead_code, reason = \"a game may use only a part\")]\n\
                    #![allow(clippy::unreadable_literal, reason = \"raw coordinates\")]\n\n"
        .to_owned();
    let _ = writeln!(text, "use tilesat::{};\n", items::imports(&world.kinds));
    let _ = writeln!(text, "/// Side of a cell in pixels.\npub const CELL: u16 = {};", world.cell);
    let _ =
        writeln!(text, "/// Cells around each room that are its neighbours'.\npub const APRON: u16 = {};", world.apron);
    text += &items::flags(&constants(&world.flags));
    text += "#[rustfmt::skip]\n";
    text += &items::kinds(&world.kinds);
    let set = items::set(&world.kinds);
    match &world.whole {
        Some(whole) => windows(&mut text, world, whole, set),
        None => table(&mut text, world, set),
    }
    segments(&mut text, world);
    objects(&mut text, world);
    text
}

fn windows(text: &mut String, world: &World, whole: &Whole, set: &str) {
    let Whole { width, height, tiles, room: (columns, rows) } = whole;
    let _ = writeln!(
        text,
        "/// The whole world, row by row.\npub static TILES: &[u8; {}] = {};",
        tiles.len(),
        bytes(tiles, usize::from(*width))
    );
    let _ = writeln!(
        text,
        "/// {width} x {height} cells in rooms of {columns} x {rows}.\n\
         pub static ROOMS: tilesat::Rooms<'static, tilesat::{set}> =\n    \
         match tilesat::Rooms::of(TILES, ({width}, {height}), tilesat::Fx::lit(\"{}\"), &KINDS, ({columns}, {rows}), APRON) {{\n        \
         Ok(rooms) => rooms,\n        \
         Err(_) => panic!(\"the rooms do not fit\"),\n    \
         }};",
        world.cell
    );
}

fn table(text: &mut String, world: &World, set: &str) {
    let modules = names::modules(world.rooms.iter().map(|room| room.name.as_str()));
    let _ = writeln!(
        text,
        "/// All rooms. `next_of` finds the room into which a body crosses.\n\
         #[rustfmt::skip]\n\
         pub static ROOMS: [tilesat::Room<'static, tilesat::{set}>; {}] = [",
        world.rooms.len()
    );
    for (room, module) in world.rooms.iter().zip(&modules) {
        let (x, y) = room.first;
        let side = |cells: u16| u32::from(cells) + 2 * u32::from(world.apron);
        let (width, height) = (side(room.size.0), side(room.size.1));
        let _ = writeln!(text, "    room({module}::TILES, {width}, {height}, {x}, {y}),");
    }
    let _ = writeln!(
        text,
        "];\n\
         #[rustfmt::skip]\n\
         const fn room(tiles: &'static [u8], width: u16, height: u16, x: i32, y: i32) -> tilesat::Room<'static, tilesat::{set}> {{\n    \
         match tilesat::Grid::new(width, height, tilesat::Fx::lit(\"{}\"), tilesat::Vec2::ZERO) {{\n        \
         Ok(grid) => match tilesat::TileMap::of(tiles, grid, &KINDS) {{\n            \
         Ok(map) => match tilesat::Room::new(map, x, y, APRON) {{\n                \
         Ok(room) => room,\n                \
         Err(_) => panic!(\"a room does not fit\"),\n            \
         }},\n            \
         Err(_) => panic!(\"the tiles do not fit\"),\n        \
         }},\n        \
         Err(_) => panic!(\"the cells do not fit\"),\n    \
         }}\n\
         }}",
        world.cell
    );
    near(text, world);
    for (index, (room, module)) in world.rooms.iter().zip(&modules).enumerate() {
        let title: String = room.name.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
        let row = usize::from(room.size.0) + 2 * usize::from(world.apron);
        let _ = writeln!(
            text,
            "\n/// {title}\n#[rustfmt::skip]\npub mod {module} {{\n    /// In the table of rooms.\n    pub const INDEX: usize = {index};\n    \
             /// With the apron, row by row.\n    pub static TILES: &[u8; {}] = {};\n}}",
            room.tiles.len(),
            bytes(&room.tiles, row)
        );
    }
}

/// The neighbours of each room, if there are several planes. They are sorted by plane.
fn near(text: &mut String, world: &World) {
    let mut end = 0;
    let mut arms = Vec::new();
    for plane in world.rooms.chunk_by(|a, b| a.plane == b.plane) {
        let start = end;
        end += plane.len();
        arms.push((start, end));
    }
    let Some((last, rest)) = arms.split_last().filter(|(_, rest)| !rest.is_empty()) else { return };
    text.push_str(
        "/// The rooms of the same world and depth as this one: `next_of` takes `&ROOMS[near(room)]`.\n\
         pub const fn near(room: usize) -> core::ops::Range<usize> {\n    match room {\n",
    );
    for (start, end) in rest {
        let these = if end - start == 1 { start.to_string() } else { format!("{start}..={}", end - 1) };
        let _ = writeln!(text, "        {these} => {start}..{end},");
    }
    let _ = writeln!(text, "        _ => {}..{},\n    }}\n}}", last.0, last.1);
}

/// A map of segments for each room that has some.
fn segments(text: &mut String, world: &World) {
    if world.rooms.iter().all(|room| room.segments.is_none()) {
        return;
    }
    let (count, order) = (world.rooms.len(), order(world));
    let _ = writeln!(
        text,
        "\n/// The polygons of each room, in the order of the rooms{order}.\n\
         #[allow(long_running_const_eval, reason = \"it ends, because the level is finite\")]\n\
         #[rustfmt::skip]\n\
         pub static SEGMENTS: [Option<tilesat::SegmentMap<'static>>; {count}] = ["
    );
    for Baked { segments, .. } in &world.rooms {
        let _ = match segments {
            None => writeln!(text, "None,"),
            Some(segments) => writeln!(text, "Some(segments({})),", bytes(segments, 64)),
        };
    }
    let _ = writeln!(
        text,
        "];\n\
         const fn segments(bytes: &'static [u8]) -> tilesat::SegmentMap<'static> {{\n    \
         match tilesat::SegmentMap::from_bytes(bytes) {{\n        \
         Ok(map) => map,\n        \
         Err(_) => panic!(\"the segments are damaged\"),\n    \
         }}\n\
         }}"
    );
}

/// Windows have an order of their own. Levels are in that of the project.
fn order(world: &World) -> &'static str {
    if world.whole.is_some() { ", row after row" } else { "" }
}

/// The objects of each room, if there are any.
fn objects(text: &mut String, world: &World) {
    if world.rooms.iter().all(|room| room.objects.is_empty()) {
        return;
    }
    *text += things::TYPE;
    let _ = writeln!(
        text,
        "/// The objects of each room that are not solid, in coordinates of the room. They\n\
         /// are in the order of the rooms{}.\n\
         #[rustfmt::skip]\n\
         pub static OBJECTS: [&[Object]; {}] = [",
        order(world),
        world.rooms.len()
    );
    for room in &world.rooms {
        let entries = things::entries(&room.objects);
        let _ = if entries.is_empty() { writeln!(text, "    &[],") } else { writeln!(text, "    &[\n{entries}    ],") };
    }
    text.push_str("];\n");
}
