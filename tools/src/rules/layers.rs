//! Applies the rules layer by layer, to tiles and objects.

use std::collections::HashMap;

use tilesat::TileShape;

use super::cells::Sheet;
use super::likeness::Likeness;
use super::names;
use super::objects::{self, Says};
use super::options::{Options, listed};
use super::outline::{LeftOut, Outline};
use super::piece::{self, Piece};
use super::place::Unit;
use super::report::{Ledger, Rule};
use super::verdict::{self, Meaning, Solid};
use super::words::{self, COLLISION, GUESS};
use crate::model::map::{Content, Layer, Map, Placed, Tiles};

type Made<T> = std::result::Result<T, String>;

/// The layers of a map, and the rules used so far.
pub(super) struct Layers<'a> {
    map: &'a Map,
    options: &'a Options,
    unit: Unit,
    likeness: Likeness,
    meanings: HashMap<u32, Meaning>,
    /// The layers that the user does not skip.
    pub(super) all: Vec<&'a Layer>,
    pub(super) ledger: Ledger,
    pub(super) ignored: Vec<String>,
    pub(super) notes: Vec<String>,
}

impl<'a> Layers<'a> {
    /// Refuses an option that names a missing layer.
    pub(super) fn new(map: &'a Map, options: &'a Options, unit: Unit) -> Made<Self> {
        if let Some(name) = &options.layer {
            let tiles = map.layers.iter().filter(|layer| layer.tiles().is_some());
            let mut names: Vec<&str> = tiles.map(|layer| layer.name.as_str()).collect();
            names.dedup();
            if !names.contains(&name.as_str()) {
                return Err(format!("no tile layer '{name}'; there are: {}", names.join(", ")));
            }
        }
        let is_ignored = |layer: &&Layer| listed(&options.ignored_layers, &layer.name);
        let (out, all): (Vec<&Layer>, Vec<&Layer>) = map.layers.iter().partition(is_ignored);
        Ok(Self {
            map,
            options,
            unit,
            likeness: Likeness::new(map.tile),
            meanings: HashMap::new(),
            all,
            ledger: Ledger::default(),
            ignored: out.iter().map(|layer| format!("layer '{}' (--ignore-layer)", layer.name)).collect(),
            notes: Vec::new(),
        })
    }

    /// The kinds of the tiles of a layer, by all rules except the guess.
    pub(super) fn sheet(&mut self, layer: &'a Layer, tiles: &'a Tiles) -> Made<Sheet<'a>> {
        let mut counts: HashMap<u32, u64> = HashMap::new();
        for line in tiles.cells.chunk_by(|a, b| a == b).filter(|line| line[0] != 0) {
            *counts.entry(line[0]).or_default() += line.len() as u64;
        }
        let mut used: Vec<(u32, u64)> = counts.into_iter().collect();
        used.sort_unstable();
        let by_layer = self.layer_rule(layer, tiles);
        let only_flags = self.options.layer.as_ref().is_some_and(|name| *name != layer.name);
        let mut sheet = Sheet { layer, tiles, pieces: HashMap::new(), flags: HashMap::new(), flagged: HashMap::new() };
        for (entry, count) in used {
            if !self.meanings.contains_key(&entry) {
                let meaning = verdict::of(self.map, &self.map.palette[entry as usize], self.options)?;
                self.meanings.insert(entry, meaning);
            }
            let meaning = &self.meanings[&entry];
            if !meaning.flags.is_empty() {
                sheet.flags.insert(entry, meaning.flags.clone());
                let cells = piece::drawn_on(self.map, &self.map.palette[entry as usize], tiles.tile);
                sheet.flagged.insert(entry, cells);
            }
            let value = matches!(self.map.palette[entry as usize], Placed::Value { .. });
            let by_layer = by_layer.as_ref().filter(|(rule, _)| !value || *rule == Rule::Option);
            let (rule, what, solid) = match (&meaning.verdict, by_layer) {
                (Some(verdict), _) => (verdict.rule, &verdict.what, verdict.solid),
                (None, Some((rule, what))) => (*rule, what, Solid::Shape(TileShape::Full)),
                (None, None) => continue,
            };
            if only_flags {
                continue;
            }
            let piece = self.piece(entry, solid, tiles.tile);
            let what = if solid == Solid::Drawn { format!("{what} are {}", became(&piece)) } else { what.clone() };
            self.ledger.add(rule, &what, count);
            sheet.pieces.insert(entry, piece);
        }
        Ok(sheet)
    }

    fn piece(&self, entry: u32, solid: Solid, tile: u16) -> Piece {
        piece::of(self.map, &self.map.palette[entry as usize], solid, tile, &self.likeness, self.options.weld())
    }

    /// The reason that all tiles of a layer are full, if they are.
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

    /// Applies rule d to a layer.
    pub(super) fn guess(&mut self, sheet: &mut Sheet<'_>) {
        let layer = sheet.layer;
        let says = [&layer.name, &layer.class].into_iter().chain(&layer.marks).any(|name| words::has(name, GUESS));
        let other = self.options.layer.as_ref().is_some_and(|name| *name != layer.name);
        if !says || sheet.tiles.derived || other {
            return;
        }
        let mut count = 0;
        for (_, _, entry) in sheet.tiles.drawn() {
            let known = self.meanings.get(&entry).is_some_and(|meaning| meaning.verdict.is_some());
            let value = matches!(self.map.palette[entry as usize], Placed::Value { .. });
            if known || value {
                continue;
            }
            count += 1;
            sheet.pieces.entry(entry).or_insert_with(|| {
                let (full, tile) = (Solid::Shape(TileShape::Full), sheet.tiles.tile);
                piece::of(self.map, &self.map.palette[entry as usize], full, tile, &self.likeness, 0)
            });
        }
        if count > 0 {
            self.ledger.add(Rule::D, &format!("layer '{}' is full", layer.name), count);
            self.guessed(&layer.name, &format!("--solid-layer '{}'", layer.name));
        }
    }

    /// Notes the solid layers that the editor does not show as they are.
    pub(super) fn unseen(&mut self, sheets: &[Sheet<'_>], outlines: &[Outline]) {
        let solid = |piece: &Piece| *piece != Piece::Shape(TileShape::Empty);
        for layer in &self.all {
            let tiles =
                sheets.iter().any(|sheet| std::ptr::eq(sheet.layer, *layer) && sheet.pieces.values().any(solid));
            let objects = layer.tiles().is_none() && outlines.iter().any(|outline| outline.title.layer == layer.name);
            if !tiles && !objects {
                continue;
            }
            let name = &layer.name;
            if layer.hidden {
                self.notes.push(format!(
                    "layer '{name}' is hidden, and solid all the same; --ignore-layer '{name}' skips it"
                ));
            }
            if layer.parallax {
                self.notes.push(format!(
                    "layer '{name}' scrolls with a parallax factor, but its solid stays where it is drawn; --ignore-layer '{name}' skips it"
                ));
            }
        }
    }

    fn guessed(&mut self, layer: &str, option: &str) {
        self.notes.push(format!(
            "GUESS: nothing marks solid tiles, so layer '{layer}' is solid because of its name; {option} confirms it, --ignore-layer '{layer}' refuses it"
        ));
    }

    /// The objects of all layers. For a guess by the layer's name, only the layers that it fits.
    pub(super) fn objects(&mut self, guess: bool) -> Made<(Vec<Outline>, Vec<LeftOut>)> {
        let (mut outlines, mut left_out, mut found, mut rounded) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for layer in self.all.clone() {
            let Content::Objects(objects) = &layer.content else { continue };
            let mut says = objects::layer_says(layer, self.options);
            // Entities of LDtk are for the game.
            let guessed = guess && says == Says::Nothing && !self.map.values && words::has(&layer.name, GUESS);
            if guessed {
                says = Says::Solid;
            }
            let mut count = 0;
            for object in objects {
                match objects::outlines(self.map, object, layer, says, self.unit, self.options)
                    .map_err(|why| format!("layer '{}': {why}", layer.name))?
                {
                    Ok(drawn) => {
                        count += 1;
                        for (outline, error) in drawn {
                            if error > 0 {
                                rounded.push(format!(
                                    "{} is a polygon of {} corners within it, off by at most 0.{error:03} px",
                                    outline.title,
                                    outline.points.len()
                                ));
                            }
                            outlines.push(outline);
                        }
                    }
                    Err(object) => left_out.push(object),
                }
            }
            if count > 0 && !guessed {
                let rule = if listed(&self.options.objects, &layer.name) {
                    Rule::Option
                } else if says == Says::Nothing {
                    Rule::A
                } else {
                    Rule::C
                };
                found.push((rule, format!("objects of layer '{}'", layer.name), count));
            }
            if guessed && count > 0 {
                self.ledger.add(Rule::D, &format!("objects of layer '{}'", layer.name), count);
                self.guessed(&layer.name, &format!("--objects '{}'", layer.name));
            }
        }
        // A guess is the second pass: the first one found nothing.
        self.notes.extend(rounded);
        for (rule, what, count) in if guess { Vec::new() } else { found } {
            self.ledger.add(rule, &what, count);
        }
        Ok((outlines, left_out))
    }
}

/// Finds the library's shapes for drawn ones.
fn became(piece: &Piece) -> String {
    match piece {
        Piece::Shape(shape) => names::name(*shape),
        Piece::Paths(paths) if paths.is_empty() => "nothing".to_owned(),
        Piece::Cells { .. } => "full and polygons".to_owned(),
        Piece::Paths(_) => "polygons".to_owned(),
    }
}
