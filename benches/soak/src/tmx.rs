//! Random levels of Tiled through the reader of the level tools. It writes a file, reads it, bakes
//! it, compares it tile by tile, and moves bodies in it.

use crate::frames::{self, Tally};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::sync::OnceLock;
use tilesat::{AllShapes, Fx, Grid, Outside, TileMap, Vec2};
use tilesat_judge::Random;
use tilesat_judge::rooms::PX;
use tilesat_judge::shapes::level::Level;
use tilesat_tools::bake::level::Level as Baked;
use tilesat_tools::bake::{Settings, bake};
use tilesat_tools::read::load;
use tilesat_tools::rules::names;

/// Bodies per level.
const BODIES: u64 = 2;
/// The first bit of a tile number's flips: across, down, over the diagonal.
const FLIPS: u32 = 29;

/// By shape and flips: a search takes longer than a level.
static TURNED: OnceLock<[[u8; 8]; 38]> = OnceLock::new();

/// Runs one level. Equal numbers give equal levels. Panics with the level if the reader or a frame
/// is wrong.
pub fn level(scratch: &Path, seed: u64, number: u64) -> Tally {
    let mut r = Random::new(seed.wrapping_mul(0xd134_2543_de82_ef95) ^ number);
    let tile = [1, 8, 16, 24, 256][r.below(5) as usize];
    // No motion leaves the domain: the level ends a thousand units before its end.
    let most = 7190 / tile;
    let (width, height) = (r.within(3, most.min(40)), r.within(3, most.min(30)));
    let density = r.within(0, 100);
    let named = r.one_in(2);
    let turned = TURNED
        .get_or_init(|| std::array::from_fn(|shape| std::array::from_fn(|flips| flipped(shape as u8, flips as u32))));
    let mut drawn = Vec::new();
    let mut cells = Vec::new();
    for _ in 0..width * height {
        let shape = if r.below(100) < density { r.within(1, 37) } else { 0 } as u8;
        let flips = if shape == 0 || r.one_in(2) { 0 } else { r.below(8) as u32 };
        cells.push(if shape == 0 { 0 } else { u32::from(shape) | flips << FLIPS });
        drawn.push(turned[usize::from(shape)][flips as usize]);
    }
    if drawn.iter().all(|&id| id == 0 || id > 33) {
        // The reader requires a solid tile.
        (cells[0], drawn[0]) = (1, 1);
    }
    let text = text(width, height, tile, named, &cells);
    let file = scratch.join(format!("soak-{seed}-{number}.tmx"));
    let read = std::fs::write(&file, &text).map_err(|e| e.to_string()).and_then(|()| read(&file));
    let baked = read.unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let shapes: Vec<u8> = (0..height)
        .flat_map(|y| (0..width).map(move |x| (x as u16, y as u16)))
        .map(|(x, y)| baked.kind(x, y).shape as u8)
        .collect();
    assert_eq!(
        (i64::from(baked.width), i64::from(baked.height), i64::from(baked.tile)),
        (width, height, tile),
        "{}",
        file.display()
    );
    assert_eq!(shapes, drawn, "the level differs from the drawing: {}", file.display());
    let kinds = baked.kinds();
    let cell = Fx::from_num(tile);
    let grid =
        Grid::new(baked.width, baked.height, cell, Vec2::ZERO).unwrap_or_else(|e| panic!("{e}: {}", file.display()));
    let map =
        TileMap::<AllShapes>::of(&baked.tiles, grid, &kinds).unwrap_or_else(|e| panic!("{e}: {}", file.display()));
    let level = Level { width, height, cell: tile * PX, x: 0, y: 0, outside: Outside::Solid, tiles: drawn };
    let mut tally = Tally::default();
    for _ in 0..BODIES {
        frames::body(&mut r, &level, &map.with_outside(Outside::Solid), tile * PX, &mut tally);
    }
    let _ = std::fs::remove_file(&file);
    tally
}

fn read(file: &Path) -> Result<Baked, String> {
    let levels = load(file, None).map_err(|e| e.to_string())?;
    let bundle = bake(&levels.maps, &Settings::default()).map_err(|e| e.to_string())?;
    let first = bundle.levels.into_iter().next().and_then(|level| level.tiles);
    first.ok_or_else(|| "no tiles".to_owned())
}

/// Writes the map as an editor does. Each shape is a separate tile, named, or numbered if it has a
/// number.
fn text(width: i64, height: i64, tile: i64, named: bool, cells: &[u32]) -> String {
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<map version=\"1.10\" orientation=\"orthogonal\" renderorder=\"right-down\" \
         width=\"{width}\" height=\"{height}\" tilewidth=\"{tile}\" tileheight=\"{tile}\" infinite=\"0\">\n \
         <tileset firstgid=\"1\" name=\"t\" tilewidth=\"{tile}\" tileheight=\"{tile}\" tilecount=\"37\" columns=\"37\">\n"
    );
    for shape in 1..38 {
        let property = if named || shape > 33 {
            let name = names::name(tilesat::TileShape::ALL[shape]);
            format!("<property name=\"shape\" value=\"{name}\"/>")
        } else {
            format!("<property name=\"npp\" type=\"int\" value=\"{shape}\"/>")
        };
        let _ = writeln!(out, "  <tile id=\"{}\"><properties>{property}</properties></tile>", shape - 1);
    }
    let csv: Vec<String> = cells.iter().map(u32::to_string).collect();
    let _ = write!(
        out,
        " </tileset>\n <layer id=\"1\" name=\"World\" width=\"{width}\" height=\"{height}\"><data encoding=\"csv\">{}</data></layer>\n</map>",
        csv.join(",")
    );
    out
}

/// The shape of a tile that is flipped over its diagonal, then across, then down. Follows its four
/// corners and the four middles of its sides.
fn flipped(shape: u8, flips: u32) -> u8 {
    let (down, across, diagonal) = (flips & 2 != 0, flips & 4 != 0, flips & 1 != 0);
    let turn = |(x, y): (i64, i64)| {
        let (x, y) = if diagonal { (y, x) } else { (x, y) };
        (if across { -x } else { x }, if down { -y } else { y })
    };
    let wanted: BTreeSet<_> = outline(shape).into_iter().map(turn).collect();
    let same = |id: &u8| outline(*id) == wanted && (shape < 34) == (*id < 34);
    (0..38).find(same).unwrap_or_else(|| panic!("shape {shape} flipped by {flips} does not exist"))
}

/// Identifies a shape by the points of a fine lattice around the middle of the cell that are in the
/// solid. For a one-way edge: by its middle.
fn outline(id: u8) -> BTreeSet<(i64, i64)> {
    if let 34..=37 = id {
        return BTreeSet::from([[(0, -1), (1, 0), (0, 1), (-1, 0)][usize::from(id - 34)]]);
    }
    let Some(solid) = tilesat_judge::shapes::level::shape(id).0 else { return BTreeSet::new() };
    let solid = solid.map(|(x, y)| (12 * x, 12 * y));
    let places = (0..144i64).map(|k| (1 + 2 * (k % 12), 1 + 2 * (k / 12)));
    places.filter(|p| solid.contains((p.0.into(), p.1.into()))).map(|(x, y)| (x - 12, y - 12)).collect()
}
