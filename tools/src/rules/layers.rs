//! Applies the rules layer by layer, to tiles and objects.

use std::collections::HashMap;

use tilesat::TileShape;

use super::called::Guess;
use super::cells::Sheet;
use super::guess;
use super::likeness::Likeness;
use super::marked;
use super::names;
use super::objects::{self, Says};
use super::options::{Options, listed};
use super::outline::{LeftOut, Outline};
use super::piece::{self, Piece};
use super::place::Unit;
use super::report::{Ledger, Rule};
use super::value::Value;
use super::verdict::{self, Meaning, Solid, Verdict};
use super::words::{self, COLLISION};
use crate::model::map::{Content, Layer, Map, Placed, Tiles};

type Made<T> = std::result::Result<T, String>;

/// What a layer says of its tiles.
struct ByLayer {
    rule: Rule,
    shape: TileShape,
    what: String,
}

/// The layers of a map, and the rules used so far.
pub(super) struct Layers<'a> {
    pub(super) map: &'a Map,
    pub(super) options: &'a Options,
    pub(super) unit: Unit,
    likeness: Likeness,
    meanings: HashMap<u32, Meaning>,
    /// The layers that the user does not skip.
    pub(super) all: Vec<&'a Layer>,
    pub(super) ledger: Ledger,
    pub(super) ignored: Vec<String>,
    pub(super) notes: Vec<String>,
    /// Layers that bodies walk on, or that solid objects trace: the reason.
    pub(super) stood_on: Vec<(&'a Layer, String)>,
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
        let mut ignored: Vec<String> =
            out.iter().map(|layer| format!("layer '{}' (--ignore-layer)", layer.name)).collect();
        // A layer of LDtk with tiles over each other is several layers here.
        if map.values {
            ignored.dedup();
        }
        Ok(Self {
            map,
            options,
            unit,
            likeness: Likeness::new(map.tile),
            meanings: HashMap::new(),
            all,
            ledger: Ledger::default(),
            ignored,
            notes: Vec::new(),
            stood_on: Vec::new(),
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
        let passed = by_layer.is_none() && words::is_passed(&layer.name);
        let by_user = by_layer.as_ref().is_some_and(|by| by.rule == Rule::Option);
        let denied = marked::denial(layer).filter(|_| !by_user);
        let only_flags = guess::is_skipped(layer, self.options);
        let (pieces, shapes, flags, flagged) = (HashMap::new(), HashMap::new(), HashMap::new(), HashMap::new());
        let mut by_name = Vec::new();
        let mut sheet = Sheet { layer, tiles, used, pieces, shapes, flags, flagged };
        for (entry, count) in sheet.used.clone() {
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
            let by_layer =
                by_layer.as_ref().filter(|by| by.rule == Rule::Option || !value || self.follows(entry, meaning));
            let Some((rule, mut what, solid)) = decided(meaning.verdict.as_ref(), by_layer) else { continue };
            let is_value = value && rule == Rule::C && meaning.verdict.is_none();
            if let Some(why) = refusal(layer, rule, (denied.as_deref(), passed)) {
                self.note(why);
                continue;
            }
            if rule == Rule::C && marked::passes(self.map, entry) {
                continue;
            }
            if only_flags {
                continue;
            }
            if is_value {
                by_name.push(entry);
            }
            self.put(&mut sheet, entry, solid);
            if let Some(piece) = sheet.pieces.get(&entry).filter(|_| !matches!(solid, Solid::Shape(_))) {
                what = format!("{what} are {}", became(piece));
            }
            self.ledger.add(rule, &what, count);
        }
        if let Some(by) = &by_layer {
            self.assume(&sheet, &by_name, &names::name(by.shape));
        }
        Ok(sheet)
    }

    /// Whether the name of its layer decides about a value: its own name says nothing else.
    fn follows(&self, entry: u32, meaning: &Meaning) -> bool {
        let Some(value) = Value::of(&self.map.palette[entry as usize]) else { return true };
        let known = value.names();
        meaning.verdict.is_none() && !known.iter().any(|name| self.options.is_flag(name)) && !value.is_free()
    }

    /// Gives an entry of a layer its solid.
    pub(super) fn put(&self, sheet: &mut Sheet<'_>, entry: u32, solid: Solid) {
        let (placed, tile) = (&self.map.palette[entry as usize], sheet.tiles.tile);
        let piece = piece::of(self.map, placed, solid, tile, &self.likeness, (self.unit, self.options.weld()));
        sheet.pieces.insert(entry, piece);
        if let Solid::Shape(shape) = solid {
            sheet.shapes.insert(entry, shape);
        }
    }

    /// The shape of all tiles of a layer, and the rule that gives it.
    fn layer_rule(&self, layer: &Layer, tiles: &Tiles) -> Option<ByLayer> {
        let by = |rule, shape| Some(ByLayer { rule, shape, what: format!("layer '{}'", layer.name) });
        if listed(&self.options.one_way_layers, &layer.name) {
            return by(Rule::Option, TileShape::OneWayUp);
        }
        if listed(&self.options.solid_layers, &layer.name) {
            return by(Rule::Option, TileShape::Full);
        }
        let says = |is: fn(&str) -> bool| {
            let own = [&layer.name, &layer.class].into_iter().chain(&layer.marks).map(String::as_str);
            !tiles.derived && own.chain(layer.around()).any(is)
        };
        // One way says more than collision.
        if says(words::is_one_way) {
            return by(Rule::C, TileShape::OneWayUp);
        }
        if says(|name| words::has(name, COLLISION)) { by(Rule::C, TileShape::Full) } else { None }
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

    /// The objects of all layers, also those that a guess makes solid.
    pub(super) fn objects(&mut self, guess: Option<Guess<'_>>) -> Made<(Vec<Outline>, Vec<LeftOut>)> {
        let (mut outlines, mut left_out, mut found, mut rounded) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for layer in self.all.clone() {
            let Content::Objects(objects) = &layer.content else { continue };
            let mut says = objects::layer_says(layer, self.options);
            // Entities of LDtk are for the game.
            let open = says == Says::Nothing
                && !self.map.values
                && marked::denial(layer).is_none()
                && !listed(&self.options.unguessed_layers, &layer.name);
            let fits = guess.filter(|_| open).is_some_and(|guess| guess.fits(&layer.name, objects));
            if fits {
                says = Says::Solid;
            }
            let mut count = 0;
            let own_says = says;
            for object in objects {
                let is_thing = fits && !guess.is_some_and(|guess| guess.takes(object));
                let says = if is_thing { Says::Nothing } else { own_says };
                match objects::outlines(self.map, object, layer, says, self.unit, self.options)
                    .map_err(|why| format!("layer '{}': {why}", layer.name))?
                {
                    Ok(drawn) => {
                        count += 1;
                        if let Some(part) = drawn.iter().find(|drawn| drawn.torn) {
                            rounded.push(format!(
                                "{}: the collision polygon of its tile crosses itself, and each part counts: put its \
                                 corners in order",
                                part.outline.title
                            ));
                        }
                        for objects::Drawn { outline, error, .. } in drawn {
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
            if count > 0 && !fits {
                let rule = if listed(&self.options.objects, &layer.name) {
                    Rule::Option
                } else if says == Says::Nothing {
                    Rule::A
                } else {
                    Rule::C
                };
                found.push((rule, format!("objects of layer '{}'", layer.name), count));
            }
            if let (Some(guess), true, 1..) = (guess, fits, count) {
                self.ledger.add(Rule::D, &format!("objects of layer '{}'", layer.name), count);
                match guess {
                    Guess::Layers { .. } => self.guessed("objects", &layer.name, "--objects"),
                    Guess::Objects(list) => self.guessed_objects(layer, objects, list),
                }
            }
        }
        // A guess is the second pass: the first one found nothing.
        for note in rounded {
            self.note(note);
        }
        for (rule, what, count) in if guess.is_some() { Vec::new() } else { found } {
            self.ledger.add(rule, &what, count);
        }
        Ok((outlines, left_out))
    }
}

/// What decides about an entry: its own verdict, or its layer.
fn decided(verdict: Option<&Verdict>, by: Option<&ByLayer>) -> Option<(Rule, String, Solid)> {
    match (verdict, by) {
        // One way says more than where the shape is.
        (Some(verdict), Some(by)) if verdict.rule == Rule::B && by.shape == TileShape::OneWayUp => {
            Some((by.rule, format!("{}, whose collision shapes", by.what), Solid::Edges(by.shape)))
        }
        (Some(verdict), _) => Some((verdict.rule, verdict.what.clone(), verdict.solid)),
        (None, Some(by)) => {
            Some((by.rule, format!("{} is {}", by.what, names::name(by.shape)), Solid::Shape(by.shape)))
        }
        (None, None) => None,
    }
}

/// Why a layer makes nothing of what this rule decides solid. Its property, or that of a group
/// around it, counts more than all rules except the user's options.
fn refusal(layer: &Layer, rule: Rule, (denied, passed): (Option<&str>, bool)) -> Option<String> {
    let name = &layer.name;
    if let Some(why) = denied.filter(|_| rule != Rule::Option) {
        return Some(marked::not_solid(name, why));
    }
    (passed && rule == Rule::B).then(|| {
        format!("GUESS: collision shapes of layer '{name}' are not solid; --solid-layer '{name}' makes them so")
    })
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
