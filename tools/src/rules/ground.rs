//! The solid of a level, derived from the drawing.
//!
//! The first rule that applies to a placed tile decides:
//!
//! 1. `option`: the user's [`Options`].
//! 2. `a`: its class or a true property is `Collision`, `Solid`, `Collide`, `Collides`,
//!    `Collidable`, `Collider`, `Wall` or `Blocked`, or has words for one-way. Or the properties
//!    `shape` and `npp` name its shape. If it is drawn in the collision editor, that is its shape.
//! 3. `b`: it has shapes of Tiled's collision editor. A shape within 1/8 pixel of one of the
//!    library's becomes that one. All others become polygons beside the tiles. Shapes that are
//!    sensors or triggers do not count, nor do those in a layer of coins. A tile with only such
//!    shapes has none: `a` and `c` make it full.
//! 4. `c`: its layer or a group around it has a name, a class or a true property with the word
//!    collision, collider, collide, collidable, solid, blocked or blocking, or with words for
//!    one-way. Values of `LDtk` follow it, except those whose own names say that they are free.
//! 5. `d`: if no tile of the project is solid so far, and its class or a true property has a word
//!    of `c` or is impassable, or its property `walkable` or `passable` is false. Properties such
//!    as `collideUp` name sides: all four are full, and one is one-way. If still no tile is solid:
//!    its layer has a name with the word wall, ground, terrain, platform, block, obstacle or
//!    physics. If still none is: floor, boundary or barrier, then words of other languages. Ground
//!    that walls stand on is not solid, nor are layers that solid objects trace. In a layer of
//!    platforms, tiles without shapes are full if few have some.
//!    For values of `LDtk` the words are the same, and dirt, stone, rock, brick and earth. Values
//!    without an identifier follow the rules `c` and `d` of their layers.
//!
//! Of solid and one-way, one-way says more. What a tile or a layer denies, such as a property
//! `solid` that is false, is not solid because of a weaker rule. A group denies for its layers. A
//! mark and a denial on one element are a doubt. An object denies its template and its tile.

use std::collections::{BTreeSet, HashSet};
use std::fmt;

use tilesat::{TileKind, TileShape};

use super::cells::{self, Cells, Sheet};
use super::flags::Flags;
use super::layers::Layers;
use super::options::Options;
use super::outline::{LeftOut, Outline};
use super::place::{self, Unit};
use super::report::Applied;
use super::search::{self, Search};
use super::{contrary, doubts, nothing, objects, paths, unused};
use crate::fail::{Fail, Result};
use crate::model::map::{Content, Map, Place};

/// The solid of a level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ground {
    pub name: String,
    /// The layers whose tiles are solid.
    pub layer: String,
    /// All tile layers.
    pub layers: usize,
    /// Side of a cell in pixels.
    pub tile: u16,
    /// The first corner of the first cell, in raw units.
    pub origin: (i32, i32),
    pub width: u16,
    pub height: u16,
    /// Row by row. Empty if no tile has a meaning.
    pub cells: Vec<TileKind>,
    /// Polygons and chains: of tiles, then of objects.
    pub outlines: Vec<Outline>,
    pub left_out: Vec<LeftOut>,
    /// The rules that made something solid.
    pub applied: Vec<Applied>,
    /// Drawings that are not part of the level.
    pub ignored: Vec<String>,
    /// What the user has set and no output holds.
    pub unused: Vec<String>,
    /// Further notes for the user.
    pub notes: Vec<String>,
    /// What the author probably did not intend.
    pub doubts: Vec<Doubt>,
    pub place: Option<Place>,
    /// The offset from a point of the map to the level, in pixels, after scaling.
    pub shift: (i32, i32),
}

/// A drawing with an effect that its author probably did not intend.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Doubt {
    pub who: String,
    pub what: String,
    /// Why it matters.
    pub why: &'static str,
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.who, self.what)
    }
}

/// A level whose tiles and objects are decided, together with those of its project.
pub(crate) struct Drawn<'a>(Search<'a>);

impl<'a> Drawn<'a> {
    /// All of these levels. Those of one file are a project.
    ///
    /// # Errors
    ///
    /// As [`Ground::of`], with the name of the level that the caller adds.
    pub(crate) fn all(maps: &[&'a Map], options: &'a Options, named: impl Fn(&Map, Fail) -> Fail) -> Result<Vec<Self>> {
        let search = |map: &&'a Map| Search::of(map, options).map_err(|why| named(map, Fail::new(why)));
        let mut levels: Vec<Search<'a>> = maps.iter().map(search).collect::<Result<_>>()?;
        for project in levels.chunk_by_mut(|a, b| a.map.project == b.map.project) {
            search::guess(project).map_err(Fail::new)?;
            search::decide_cells(project);
        }
        Ok(levels.into_iter().map(Self).collect())
    }

    /// Its solid. New flags take the remaining bits.
    ///
    /// # Errors
    ///
    /// As [`Ground::of`].
    pub(crate) fn ground(self, flags: &mut Flags) -> Result<Ground> {
        make(self.0, flags).map_err(Fail::new)
    }
}

impl Ground {
    /// The solid of a map. New flags take the remaining bits.
    ///
    /// # Errors
    ///
    /// One line about the part that the library refuses, and the option that fixes it.
    pub fn of(map: &Map, options: &Options, flags: &mut Flags) -> Result<Self> {
        let mut search = Search::of(map, options).map_err(Fail::new)?;
        search::guess(std::slice::from_mut(&mut search)).map_err(Fail::new)?;
        make(search, flags).map_err(Fail::new)
    }

    /// What the author probably did not intend: a line each.
    pub(crate) fn warnings(&self) -> Vec<String> {
        let slips = self.left_out.iter().filter_map(LeftOut::warning);
        slips.chain(self.doubts.iter().map(Doubt::to_string)).collect()
    }

    /// Whether something is drawn, and nothing of it is solid.
    pub(crate) fn is_hollow(&self) -> bool {
        !self.is_solid() && self.doubts.iter().any(|doubt| doubt.who == LEVEL)
    }

    /// Whether anything is solid or one-way.
    pub(crate) fn is_solid(&self) -> bool {
        !self.outlines.is_empty() || self.cells.iter().any(|kind| kind.shape != TileShape::Empty)
    }
}

/// The most reasons of the reader after the advice for a level without a solid.
const MOST_REASONS: usize = 3;
/// Who has a doubt about a whole level.
const LEVEL: &str = "the level";
const READ: &str = "the file is not quite what was meant";
const FALL: &str = "bodies pass through what is not solid";

type Made<T> = std::result::Result<T, String>;

fn make(search: Search<'_>, flags: &mut Flags) -> Made<Ground> {
    let Search { map, mut layers, mut sheets, mut outlines, mut left_out, mut doubts, side } = search;
    let options = layers.options;
    let unit = Unit::new(options.scale);
    let (named, dropped) = (flags.names.len(), flags.dropped.len());
    layers.forgotten(&mut sheets, &outlines);
    layers.oversize(&mut sheets);
    layers.slopes(&sheets);
    let sides = layers.unclear_sides(&sheets);
    for line in &sides {
        layers.note(format!("GUESS: {line}"));
    }
    let cells = cells::merge(&sheets, side, flags)?;
    layers.unseen(&sheets, &outlines);
    let of_tiles = paths::outlines(&cells, unit, options.weld(), flags, &mut layers.notes)?;
    outlines.splice(0..0, of_tiles);
    layers.stray_holes(&mut outlines, &mut left_out);
    if outlines.is_empty() && cells.kinds.iter().all(|kind| kind.shape == TileShape::Empty) {
        let explained =
            nothing::why(map, &sheets, options).map(|why| explained(map, &why, (&sides, &layers.notes), &left_out));
        match explained {
            None => layers.notes.push("it is empty: nothing is drawn".to_owned()),
            Some(why) if options.bare => {
                let what = format!("{why}; --ignore-level '{}' skips the level", map.name);
                doubts.push(Doubt { who: LEVEL.to_owned(), what, why: FALL });
            }
            Some(why) => return Err(why),
        }
    } else {
        layers.undecided(&sheets);
        layers.crowded(&sheets, &cells);
    }
    doubts.extend(map.warnings.iter().map(|(who, what)| Doubt { who: who.clone(), what: what.clone(), why: READ }));
    doubts.extend(contrary::tiles(map, &sheets, options)?);
    doubts.extend(contrary::objects(&layers.all, options)?);
    for layer in &cells.lost {
        let what = "its flags are in no output: its cells are not those of the solid; give both layers one grid";
        doubts.push(Doubt {
            who: format!("layer '{layer}'"),
            what: what.to_owned(),
            why: "a flag belongs to a cell of the solid",
        });
    }
    let new = flags.names.iter().skip(named).chain(flags.dropped.iter().skip(dropped));
    let classes = left_out.iter().map(|object| &object.class);
    let said = new.chain(classes).map(String::as_str).filter(|name| !options.is_flag(name));
    let near = doubts::near_misses(said).into_iter();
    doubts.extend(near.chain(doubts::shapes(map)).map(|(who, what)| Doubt { who, what, why: FALL }));
    let blocks = |kind: &TileKind| super::names::is_solid(kind.shape);
    let hollow = doubts.iter().any(|doubt| doubt.who == LEVEL);
    if !hollow && outlines.is_empty() && !cells.kinds.is_empty() && !cells.kinds.iter().any(blocks) {
        let names = nothing::names_of_tiles(&sheets).map_or(String::new(), |(names, option)| {
            format!("; tiles have the names {names}: add --solid {option} if they are solid")
        });
        let what = format!("it has no solid tile and no solid object{names}");
        doubts.push(Doubt { who: LEVEL.to_owned(), what, why: "bodies fall through this level" });
    }
    let Layers { ledger, ignored, notes, .. } = layers;
    let solid = names(&sheets);
    let told = |(layer, count): &(String, usize)| {
        let tiles = super::words::several(*count, "tile");
        format!(
            "flags of {tiles} of layer '{layer}' beyond the cells of the map: no output has them; draw more rows or \
             columns"
        )
    };
    let beyond_cells: Vec<String> = cells.beyond.iter().map(told).collect();
    let mut ground = settled(map, cells, outlines, (unit, options.rooms), &solid)?;
    ground.layers = sheets.len();
    ground.left_out = left_out;
    let shift = (i64::from(ground.shift.0) << 16, i64::from(ground.shift.1) << 16);
    ground.left_out.iter_mut().for_each(|object| object.shift(shift));
    if !options.rooms {
        beyond(&mut ground.left_out);
        references(&mut ground.left_out, map);
    }
    // Fields of LDtk's entities are for the game, whatever their names.
    ground.notes.extend(objects::other_kinds(&ground.left_out).filter(|_| !map.values));
    ground.unused = unused::lines(map, options, &ground.outlines, &ground.left_out);
    ground.unused.extend(beyond_cells);
    ground.doubts = doubts;
    ground.applied = ledger.0;
    ground.ignored = ignored;
    ground.notes.splice(0..0, map.notes.iter().cloned().chain(notes));
    Ok(ground)
}

/// The reason that nothing is solid, with what tiles say of sides, what the rules refuse, and what
/// the reader says.
fn explained(map: &Map, why: &str, (sides, notes): (&BTreeSet<String>, &[String]), left_out: &[LeftOut]) -> String {
    let missing = map.tilesets.iter().find_map(|set| set.missing.as_ref());
    let why = missing.map_or(why.to_owned(), |missing| format!("{missing}; without it, {why}"));
    // The words about sides are a guess in the notes.
    let refused = notes.iter().filter(|note| !note.starts_with("GUESS"));
    let lines = sides.iter().take(MOST_REASONS).chain(refused.take(MOST_REASONS));
    let why = lines.fold(why, |why, line| format!("{why}; {line}"));
    let slips = left_out.iter().filter(|object| object.suspicious);
    let slips = slips.map(|object| (object.title.to_string(), object.why.clone()));
    let read = map.warnings.iter().cloned().chain(doubts::shapes(map)).chain(slips);
    read.take(MOST_REASONS).fold(why, |why, (who, what)| format!("{why}; {who}: {what}"))
}

/// Marks the objects that are outside of the domain. A solid there is refused.
fn beyond(objects: &mut [LeftOut]) {
    for object in objects.iter_mut().filter(|object| !object.is_inside()) {
        "it is outside of the domain: coordinates stay below 8192 pixels; move it, or --scale makes everything smaller"
            .clone_into(&mut object.why);
        object.suspicious = true;
    }
}

/// Drops references to objects that are in no output. Those to other levels of a project stay.
fn references(objects: &mut [LeftOut], map: &Map) {
    let listed = objects.iter().filter(|object| object.is_listed()).map(|object| object.title.id);
    let listed: HashSet<u32> = listed.collect();
    let all = map.layers.iter().filter_map(|layer| match &layer.content {
        Content::Objects(objects) => Some(objects),
        _ => None,
    });
    let own: HashSet<u32> = all.flatten().map(|object| object.id).collect();
    for object in objects {
        object.settle(|id| listed.contains(&id) || map.values && !own.contains(&id));
    }
}

/// The layers whose tiles are solid. If there are none, the first one.
fn names(sheets: &[Sheet<'_>]) -> String {
    let mut solid: Vec<&str> =
        sheets.iter().filter(|sheet| !sheet.pieces.is_empty()).map(|sheet| sheet.layer.name.as_str()).collect();
    solid.dedup();
    let first = || sheets.first().map(|sheet| sheet.layer.name.clone()).unwrap_or_default();
    if solid.is_empty() { first() } else { solid.join(" + ") }
}

/// Puts everything into the library's domain.
fn settled(
    map: &Map,
    cells: Cells,
    mut outlines: Vec<Outline>,
    (unit, rooms): (Unit, bool),
    solid: &str,
) -> Made<Ground> {
    let own = if cells.tile == 0 { map.tile } else { cells.tile };
    let tile = unit.side(own)?;
    let side = i64::from(tile) << 16;
    // Without tiles, the map gives the size of the level.
    let of_map = |count: u32| (u64::from(count) * u64::from(map.tile)).div_ceil(own.into()) as u32;
    let of_map = (of_map(map.size.0), of_map(map.size.1));
    let (width, height) = if cells.kinds.is_empty() { of_map } else { (cells.width, cells.height) };
    let at = (unit.raw_of_raw(cells.at.0), unit.raw_of_raw(cells.at.1));
    let ends = |from: i64, count: u32| (from >> 16, (from + side * i64::from(count) + 65535) >> 16);
    let (x, y) = (ends(at.0, width), ends(at.1, height));
    let whose = if solid.is_empty() { "the level".to_owned() } else { format!("layer '{solid}'") };
    let of_layer = |why: String| format!("{whose} of {width}x{height} tiles of {tile} pixels: {why}");
    let along = |(lo, hi): (i64, i64)| if rooms { Ok(-lo) } else { place::shift(lo, hi, tile).map_err(of_layer) };
    let shift = (along(x)?, along(y)?);
    for point in outlines.iter_mut().flat_map(|outline| &mut outline.points) {
        *point = (point.0 + (shift.0 << 16), point.1 + (shift.1 << 16));
    }
    let mut notes = Vec::new();
    if shift != (0, 0) && !rooms {
        notes.push(format!("moved by ({}, {}) pixels, so that it lies around the origin", shift.0, shift.1));
    }
    let has_tiles = cells.kinds.iter().any(|kind| *kind != TileKind::EMPTY);
    let fit = |count: u32| u16::try_from(count).map_err(|_| of_layer(format!("{count} cells")));
    Ok(Ground {
        name: map.name.clone(),
        layer: solid.to_owned(),
        layers: 0,
        tile,
        origin: ((at.0 + (shift.0 << 16)) as i32, (at.1 + (shift.1 << 16)) as i32),
        width: fit(width)?,
        height: fit(height)?,
        cells: if has_tiles { cells.kinds } else { Vec::new() },
        outlines,
        left_out: Vec::new(),
        applied: Vec::new(),
        ignored: Vec::new(),
        unused: Vec::new(),
        notes,
        doubts: Vec::new(),
        place: map.place,
        shift: (shift.0 as i32, shift.1 as i32),
    })
}
