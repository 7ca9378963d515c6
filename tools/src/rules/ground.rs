//! A level as it is solid, made of one as it was drawn.
//!
//! Of each placed tile the first of these says what it is:
//!
//! 1. `option`: the user, by [`Options`].
//! 2. `a`: its class or a true property is called `Collision`, `Solid`, `Collides`, `Collidable`, `Wall`, `Blocked` or
//!    `OneWay`, or the properties `shape` and `npp` name its shape.
//! 3. `b`: it has shapes of Tiled's collision editor. What is a shape of the library within 1/8 pixel becomes that one;
//!    all else becomes polygons beside the tiles.
//! 4. `c`: its layer or a group around it has a name, a class or a true property with the word collision, collider or solid.
//! 5. `d`: where nothing of the map is solid so far, its layer has a name with the word wall, ground, terrain, platform,
//!    block or obstacle. Values of `LDtk` go by the same words, and by dirt, stone, rock, brick and earth.

use std::collections::HashMap;

use tilesat::{TileKind, TileShape};

use super::cells::{self, Cells, Sheet};
use super::flags::Flags;
use super::kind::Kind;
use super::likeness::Likeness;
use super::objects::{self, Says};
use super::options::{Options, listed};
use super::outline::{LeftOut, Outline, Title};
use super::piece::{self, Piece};
use super::place::{self, Unit};
use super::report::{Applied, Ledger, Rule};
use super::union;
use super::verdict::{self, Meaning, Solid};
use super::words::{self, COLLISION, GUESS};
use crate::fail::{Fail, Result};
use crate::model::map::{Content, Layer, Map, Place, Tiles};

/// What of a level is solid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ground {
    pub name: String,
    /// The layers whose tiles are solid.
    pub layer: String,
    /// All tile layers.
    pub layers: usize,
    /// Side of a cell in pixels.
    pub tile: u16,
    /// Raw: where the first cell begins.
    pub origin: (i32, i32),
    pub width: u16,
    pub height: u16,
    /// Row by row; empty where no tile means anything.
    pub cells: Vec<TileKind>,
    /// Polygons and chains: of tiles, then of objects.
    pub outlines: Vec<Outline>,
    pub left_out: Vec<LeftOut>,
    /// The rules that made something solid.
    pub applied: Vec<Applied>,
    /// What was drawn and is no part of the level.
    pub ignored: Vec<String>,
    /// What else the user should know.
    pub notes: Vec<String>,
    pub place: Option<Place>,
    /// Pixels from where the map has a thing to where the level has it, after scaling.
    pub shift: (i32, i32),
}

impl Ground {
    /// What of a map is solid; new flags take the bits that are left.
    ///
    /// # Errors
    ///
    /// One line that says what the library does not take, and which option would settle it.
    pub fn of(map: &Map, options: &Options, flags: &mut Flags) -> Result<Self> {
        Maker::new(map, options).make(flags).map_err(Fail::new)
    }
}

type Made<T> = std::result::Result<T, String>;

struct Maker<'a> {
    map: &'a Map,
    options: &'a Options,
    unit: Unit,
    likeness: Likeness,
    meanings: HashMap<u32, Meaning>,
    ledger: Ledger,
    ignored: Vec<String>,
    notes: Vec<String>,
}

impl<'a> Maker<'a> {
    fn new(map: &'a Map, options: &'a Options) -> Self {
        let (unit, likeness) = (Unit::new(options.scale), Likeness::new(map.tile));
        let (meanings, ledger, ignored, notes) = (HashMap::new(), Ledger::default(), Vec::new(), Vec::new());
        Self { map, options, unit, likeness, meanings, ledger, ignored, notes }
    }

    fn make(mut self, flags: &mut Flags) -> Made<Ground> {
        self.check_names()?;
        let layers: Vec<&Layer> =
            self.map.layers.iter().filter(|layer| !listed(&self.options.ignored_layers, &layer.name)).collect();
        self.ignored.extend(
            self.map
                .layers
                .iter()
                .filter(|layer| listed(&self.options.ignored_layers, &layer.name))
                .map(|layer| format!("layer '{}' (--ignore-layer)", layer.name)),
        );
        let mut sheets = Vec::new();
        for layer in &layers {
            match &layer.content {
                Content::Tiles(tiles) => sheets.push(self.sheet(layer, tiles)?),
                Content::Objects(_) => {}
                Content::Image => self.ignored.push(format!("image layer '{}'", layer.name)),
            }
        }
        let (mut outlines, mut left_out) = self.objects(&layers, false)?;
        let nothing =
            sheets.iter().all(|sheet| sheet.pieces.values().all(|piece| *piece == Piece::Shape(TileShape::Empty)));
        if nothing && outlines.is_empty() {
            for sheet in &mut sheets {
                self.guess(sheet);
            }
            (outlines, left_out) = self.objects(&layers, true)?;
        }
        let cells = cells::merge(&sheets, flags)?;
        for layer in &cells.lost {
            self.notes
                .push(format!("the flags of layer '{layer}' are left out: it lies between the cells of the others"));
        }
        let of_tiles = self.of_tiles(&cells, flags)?;
        outlines.splice(0..0, of_tiles);
        self.settle(&cells, outlines, left_out, &sheets)
    }

    /// Options that name a layer which is not there.
    fn check_names(&self) -> Made<()> {
        let Some(name) = &self.options.layer else { return Ok(()) };
        let mut known = self.map.layers.iter().filter(|layer| layer.tiles().is_some()).map(|layer| layer.name.as_str());
        if known.clone().any(|layer| layer == name) {
            return Ok(());
        }
        let mut names: Vec<&str> = known.by_ref().collect();
        names.dedup();
        Err(format!("no tile layer '{name}'; there are: {}", names.join(", ")))
    }

    /// What the tiles of a layer are, all rules but the guess.
    fn sheet(&mut self, layer: &'a Layer, tiles: &'a Tiles) -> Made<Sheet<'a>> {
        let mut counts: HashMap<u32, u64> = HashMap::new();
        for line in tiles.cells.chunk_by(|a, b| a == b).filter(|line| line[0] != 0) {
            *counts.entry(line[0]).or_default() += line.len() as u64;
        }
        let mut used: Vec<(u32, u64)> = counts.into_iter().collect();
        used.sort_unstable();
        let by_layer = self.layer_rule(layer, tiles);
        let only_flags = self.options.layer.as_ref().is_some_and(|name| *name != layer.name);
        let mut sheet = Sheet { layer, tiles, pieces: HashMap::new(), flags: HashMap::new() };
        for (entry, count) in used {
            if !self.meanings.contains_key(&entry) {
                let meaning = verdict::of(self.map, &self.map.palette[entry as usize], self.options)?;
                self.meanings.insert(entry, meaning);
            }
            let meaning = &self.meanings[&entry];
            if !meaning.flags.is_empty() {
                sheet.flags.insert(entry, meaning.flags.clone());
            }
            let value = matches!(self.map.palette[entry as usize], crate::model::map::Placed::Value { .. });
            let by_layer = by_layer.as_ref().filter(|(rule, _)| !value || *rule == Rule::Option);
            let (rule, what, solid) = match (&meaning.verdict, by_layer) {
                (Some(verdict), _) => (verdict.rule, &verdict.what, verdict.solid),
                (None, Some((rule, what))) => (*rule, what, Solid::Shape(TileShape::Full)),
                (None, None) => continue,
            };
            if only_flags {
                continue;
            }
            self.ledger.add(rule, what, count);
            let piece = piece::of(self.map, &self.map.palette[entry as usize], solid, tiles.tile, &self.likeness);
            sheet.pieces.insert(entry, piece);
        }
        Ok(sheet)
    }

    /// Why all tiles of a layer are full, if they are.
    fn layer_rule(&self, layer: &Layer, tiles: &Tiles) -> Option<(Rule, String)> {
        let what = format!("layer '{}' is full", layer.name);
        if listed(&self.options.solid_layers, &layer.name) {
            return Some((Rule::Option, what));
        }
        let says = [&layer.name, &layer.class]
            .into_iter()
            .chain(&layer.marks)
            .chain(&layer.groups)
            .any(|name| words::has(name, COLLISION));
        (says && !tiles.derived).then_some((Rule::C, what))
    }

    /// Rule d for a layer.
    fn guess(&mut self, sheet: &mut Sheet<'_>) {
        let layer = sheet.layer;
        let says = [&layer.name, &layer.class].into_iter().chain(&layer.marks).any(|name| words::has(name, GUESS));
        let other = self.options.layer.as_ref().is_some_and(|name| *name != layer.name);
        if !says || sheet.tiles.derived || other {
            return;
        }
        let mut count = 0;
        for (_, _, entry) in sheet.tiles.drawn() {
            let known = self.meanings.get(&entry).is_some_and(|meaning| meaning.verdict.is_some());
            let value = matches!(self.map.palette[entry as usize], crate::model::map::Placed::Value { .. });
            if known || value {
                continue;
            }
            count += 1;
            sheet.pieces.entry(entry).or_insert_with(|| {
                let solid = Solid::Shape(TileShape::Full);
                piece::of(self.map, &self.map.palette[entry as usize], solid, sheet.tiles.tile, &self.likeness)
            });
        }
        if count > 0 {
            self.ledger.add(Rule::D, &format!("layer '{}' is full", layer.name), count);
            self.guessed(&layer.name, &format!("--solid-layer '{}'", layer.name));
        }
    }

    fn guessed(&mut self, layer: &str, option: &str) {
        self.notes.push(format!(
            "GUESS: nothing says what is solid, so layer '{layer}' is, for its name; {option} says so, --ignore-layer '{layer}' says no"
        ));
    }

    /// The objects of all layers; where the layer's name is guessed by, those of layers that it is a guess for.
    fn objects(&mut self, layers: &[&Layer], guess: bool) -> Made<(Vec<Outline>, Vec<LeftOut>)> {
        let (mut outlines, mut left_out) = (Vec::new(), Vec::new());
        for layer in layers {
            let Content::Objects(objects) = &layer.content else { continue };
            let mut says = objects::layer_says(layer, self.options);
            // Entities of LDtk are for the game.
            let guessed = guess && says == Says::Nothing && !self.map.values && words::has(&layer.name, GUESS);
            if guessed {
                says = Says::Solid;
            }
            let before = outlines.len();
            for object in objects {
                match objects::outline(object, layer, says, self.unit, self.options)
                    .map_err(|why| format!("layer '{}': {why}", layer.name))?
                {
                    Ok(outline) => outlines.push(outline),
                    Err(object) => left_out.push(object),
                }
            }
            let count = (outlines.len() - before) as u64;
            if guessed && count > 0 {
                self.ledger.add(Rule::D, &format!("objects of layer '{}'", layer.name), count);
                self.guessed(&layer.name, &format!("--objects '{}'", layer.name));
            }
        }
        Ok((outlines, left_out))
    }

    /// The paths of tiles, polygons of the same flags joined.
    fn of_tiles(&mut self, cells: &Cells, flags: &Flags) -> Made<Vec<Outline>> {
        let mut outlines = Vec::new();
        let mut polygons: Vec<(u8, Vec<Vec<(i64, i64)>>)> = Vec::new();
        let (mut error, mut layers): (u32, Vec<&str>) = (0, Vec::new());
        for placed in cells.paths.iter().filter(|placed| !cells.hides(&placed.path)) {
            let raw = placed.path.points.iter().map(|&(x, y)| (self.unit.raw(x).0, self.unit.raw(y).0)).collect();
            error = error.max(placed.path.error);
            if !layers.contains(&placed.layer.as_str()) {
                layers.push(&placed.layer);
            }
            if placed.path.closed && placed.path.kind == Kind::Solid {
                match polygons.iter_mut().find(|(flags, _)| *flags == placed.flags) {
                    Some((_, all)) => all.push(raw),
                    None => polygons.push((placed.flags, vec![raw])),
                }
            } else {
                outlines.push(self.outline(
                    placed.path.kind,
                    placed.path.closed,
                    raw,
                    placed.flags,
                    &placed.layer,
                    flags,
                ));
            }
        }
        let title = layers.join(" + ");
        for (mask, all) in polygons {
            for path in union::union(&all) {
                let kind = if path.hole { Kind::Hole } else { Kind::Solid };
                outlines.push(self.outline(kind, true, path.points, mask, &title, flags));
            }
        }
        if error > 0 {
            self.notes.push(format!("ellipses of tiles are polygons within them, off by at most 0.{error:03} px"));
        }
        Ok(outlines)
    }

    fn outline(
        &self,
        kind: Kind,
        closed: bool,
        points: Vec<(i64, i64)>,
        mask: u8,
        layer: &str,
        flags: &Flags,
    ) -> Outline {
        let title = Title::tiles(layer);
        let rounding = vec![0; points.len()];
        let named = flags.names.iter().enumerate().filter(|(bit, _)| mask >> bit & 1 != 0);
        Outline { title, kind, closed, points, rounding, flags: named.map(|(_, name)| name.clone()).collect() }
    }

    /// Puts everything into the library's domain.
    fn settle(
        mut self,
        cells: &Cells,
        mut outlines: Vec<Outline>,
        left_out: Vec<LeftOut>,
        sheets: &[Sheet<'_>],
    ) -> Made<Ground> {
        let has_tiles = cells.kinds.iter().any(|kind| *kind != TileKind::EMPTY);
        let any = !outlines.is_empty() || cells.kinds.iter().any(|kind| kind.shape != TileShape::Empty);
        if !any {
            super::nothing::explain(self.map, sheets, self.options)?;
            self.notes.push("it is empty: nothing is drawn".to_owned());
        }
        let tile = self.unit.side(if cells.tile == 0 { self.map.tile } else { cells.tile })?;
        let side = i64::from(tile) << 16;
        let scaled = |raw: i64| self.unit.raw_of_raw(raw);
        // Without tiles the map itself says how large the level is.
        let (width, height) = if cells.kinds.is_empty() { self.map.size } else { (cells.width, cells.height) };
        let at = (scaled(cells.at.0), scaled(cells.at.1));
        let ends = |from: i64, count: u32| (from >> 16, (from + side * i64::from(count) + 65535) >> 16);
        let (x, y) = (ends(at.0, width), ends(at.1, height));
        let layer = |why: String| match cells.kinds.is_empty() {
            true => why,
            false => format!(
                "layer '{}' of {width}x{height} tiles of {tile} pixels: {why}",
                sheets.first().map_or("", |sheet| &sheet.layer.name)
            ),
        };
        let shift = |(lo, hi): (i64, i64)| if self.options.rooms { Ok(-lo) } else { place::shift(lo, hi, tile).map_err(layer) };
        let shift = (shift(x)?, shift(y)?);
        for point in outlines.iter_mut().flat_map(|outline| &mut outline.points) {
            *point = (point.0 + (shift.0 << 16), point.1 + (shift.1 << 16));
        }
        if shift != (0, 0) && !self.options.rooms {
            self.notes.push(format!("moved by ({}, {}) pixels, so that it lies around the origin", shift.0, shift.1));
        }
        let mut solid: Vec<&str> =
            sheets.iter().filter(|sheet| !sheet.pieces.is_empty()).map(|sheet| sheet.layer.name.as_str()).collect();
        solid.dedup();
        let first = sheets.first().map(|sheet| sheet.layer.name.clone()).unwrap_or_default();
        let fit = |count: u32| {
            if has_tiles { u16::try_from(count).map_err(|_| layer(format!("{count} cells"))) } else { Ok(0) }
        };
        Ok(Ground {
            name: self.map.name.clone(),
            layer: if solid.is_empty() { first } else { solid.join(" + ") },
            layers: sheets.len(),
            tile,
            origin: ((at.0 + (shift.0 << 16)) as i32, (at.1 + (shift.1 << 16)) as i32),
            width: fit(width)?,
            height: fit(height)?,
            cells: if has_tiles { cells.kinds.clone() } else { Vec::new() },
            outlines,
            left_out,
            applied: self.ledger.0,
            ignored: self.ignored,
            notes: self.notes,
            place: self.map.place,
            shift: (shift.0 as i32, shift.1 as i32),
        })
    }
}
