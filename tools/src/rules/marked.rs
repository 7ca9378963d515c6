//! A guess by the tiles' own names and properties, if no rule marks a tile or an object. Games have
//! their own words: `isSolid`, `hasCollision`, `impassable`, or `walkable` that is false. They say
//! more than the name of a layer.

use std::collections::BTreeSet;

use tilesat::TileShape;

use super::cells::Sheet;
use super::guess;
use super::kind::Kind;
use super::layers::Layers;
use super::options::Options;
use super::piece::Piece;
use super::report::Rule;
use super::sides::Sides;
use super::verdict::Solid;
use super::{names, traits, words};
use crate::model::flip::Flip;
use crate::model::map::{Layer, Map, Placed};
use crate::model::property::{Properties, Value};
use crate::model::tileset::Tile;

/// What a tile says of itself: the words for the report, and its name in an option.
struct Said {
    what: String,
    name: String,
    shape: TileShape,
    /// The flags that it no longer has to be.
    flags: Vec<String>,
}

impl Layers<'_> {
    /// Makes the undecided tiles full that say so in words that are no rule.
    pub(super) fn guess_by_tiles(&mut self, sheets: &mut [Sheet<'_>]) {
        // Values of LDtk have names, and its tiles serve the drawing.
        if self.map.values {
            return;
        }
        for sheet in sheets {
            if sheet.tiles.derived || guess::is_settled(sheet.layer, self.options) {
                continue;
            }
            let denied = denial(sheet.layer);
            for (entry, count) in sheet.used.clone() {
                let tile = tile(self.map, entry).filter(|_| !sheet.pieces.contains_key(&entry));
                let tile = tile.filter(|_| !passes(self.map, entry));
                let Some(said) = tile.and_then(|tile| said(tile, self.options)) else { continue };
                if let Some(why) = &denied {
                    self.note(not_solid(&sheet.layer.name, why));
                    break;
                }
                let flip = flip(self.map, entry);
                self.put(sheet, entry, Solid::Shape(flip.of(said.shape)));
                if let Some(flags) = sheet.flags.get_mut(&entry) {
                    flags.retain(|flag| !said.flags.iter().any(|name| words::same(flag, name)));
                }
                let (shape, what, name) = (names::name(said.shape), said.what, said.name);
                let option = match said.shape {
                    TileShape::Full => format!("'{name}'"),
                    _ => format!("'{name}={shape}'"),
                };
                self.ledger.add(Rule::D, &format!("tiles with the {what} are {shape}"), count);
                self.note(format!(
                    "GUESS: nothing marks solid tiles, so those with the {what} are {shape}; --solid {option} confirms \
                     it, --empty '{name}' refuses it"
                ));
            }
        }
    }

    /// A line about the tiles that block from two or three sides, as no shape does.
    pub(super) fn unclear_sides(&self, sheets: &[Sheet<'_>]) -> BTreeSet<String> {
        let mut lines = BTreeSet::new();
        for (sheet, (entry, _)) in sheets.iter().flat_map(|sheet| sheet.used.iter().map(move |used| (sheet, used))) {
            let tile = tile(self.map, *entry).filter(|_| !self.map.values && !sheet.pieces.contains_key(entry));
            let sides = tile.and_then(|tile| Sides::of(tile, self.options)).filter(Sides::is_unclear);
            if let Some((sides, name)) = sides.as_ref().and_then(|sides| Some((sides, sides.names.first()?))) {
                lines.insert(format!(
                    "tiles with the {} are not solid: they block from some sides, and no shape does that; --solid '{name}' \
                     makes them full, --one-way '{name}' one-way from above",
                    sides.what()
                ));
            }
        }
        lines
    }

    /// Notes the tiles and values that are called slopes, and are none: games name directions
    /// differently.
    pub(super) fn slopes(&mut self, sheets: &[Sheet<'_>]) {
        for (sheet, (entry, _)) in sheets.iter().flat_map(|sheet| sheet.used.iter().map(move |used| (sheet, used))) {
            if !matches!(sheet.pieces.get(entry), None | Some(Piece::Shape(TileShape::Full))) {
                continue;
            }
            let is = |name: &str| words::has(name, &["slope", "ramp"]) && !self.options.names(name);
            let note = match &self.map.palette[*entry as usize] {
                Placed::Value { layer, number, name: Some(name), .. } if is(name) => Some(format!(
                    "GUESS: value {number} '{name}' of layer '{layer}' is no slope; --solid \
                     '{layer}:{number}=slope-bottom-left' makes it one"
                )),
                Placed::Tile { .. } if !self.map.values => slope(self.map, *entry, is),
                _ => None,
            };
            if let Some(note) = note {
                self.note(note);
            }
        }
    }
}

/// The note about a tile with such a name.
fn slope(map: &Map, entry: u32, is: impl Fn(&str) -> bool) -> Option<String> {
    let tile = tile(map, entry)?;
    let own = tile.properties.0.iter().filter(|(_, value)| !value.is_false()).map(|(name, _)| name);
    let name = own.chain([&tile.class]).find(|name| is(name))?;
    Some(format!("GUESS: tiles with '{name}' are no slopes; --solid TILESET:ID=slope-bottom-left makes one so"))
}

/// Whether a class or a true property says that a tile or a shape only notices bodies.
pub(super) fn senses(class: &str, properties: &Properties) -> bool {
    properties.marks().chain([class]).any(words::is_sensor)
}

/// Whether a tile says that bodies pass, so that no guess by the name of its layer makes it solid.
pub(super) fn is_free(map: &Map, entry: u32, options: &Options) -> bool {
    let sides = |tile: &Tile| Sides::of(tile, options).is_some_and(|sides| sides.is_none() || sides.is_unclear());
    passes(map, entry) || !map.values && tile(map, entry).is_some_and(sides)
}

/// Whether a tile says that bodies pass, so that not even a layer of collisions makes it solid.
pub(super) fn passes(map: &Map, entry: u32) -> bool {
    let walkable = |own: &Properties| own.marks().chain(own.ones()).any(words::is_walkable);
    let says = |tile: &Tile| {
        let own = &tile.properties;
        senses(&tile.class, own) || walkable(own) || denied(own).is_some()
    };
    !map.values && tile(map, entry).is_some_and(says)
}

/// The first property that says of its owner that it is not solid: `solid` that is false.
pub(super) fn denied(properties: &Properties) -> Option<&str> {
    let whole = |name: &str| words::is_blocked(name) && words::blocked_side(name).is_none();
    let solid = |name: &str| whole(name) || traits::shape(name) == Some(TileShape::Full);
    let mut all = properties.0.iter().filter(|(name, value)| value.is_false() && solid(name));
    all.next().map(|(name, _)| name.as_str())
}

/// Why a layer is not solid, if it denies it. A group says it for its layers. The nearest class or
/// property that says something wins.
pub(super) fn denial(layer: &Layer) -> Option<String> {
    let claims = |class: &str, marks: &[String]| marks.iter().map(String::as_str).chain([class]).any(is_claim);
    if let Some(property) = denied(&layer.properties) {
        return Some(format!("its property '{property}' is false"));
    }
    if claims(&layer.class, &layer.marks) {
        return None;
    }
    for group in layer.groups.iter().rev() {
        if let Some(property) = denied(&group.properties) {
            return Some(format!("the property '{property}' of its group '{}' is false", group.name));
        }
        if claims(&group.class, &group.marks) {
            return None;
        }
    }
    None
}

/// Whether a class or a property of a layer says what is solid in it.
fn is_claim(name: &str) -> bool {
    words::is_one_way(name) || words::has(name, words::COLLISION) || Kind::from_name(name).is_some()
}

/// The note about a layer that is not solid, because it denies it.
pub(super) fn not_solid(layer: &str, why: &str) -> String {
    format!("layer '{layer}' is not solid, because {why}; --solid-layer '{layer}' makes it solid")
}

fn tile(map: &Map, entry: u32) -> Option<&Tile> {
    match &map.palette[entry as usize] {
        Placed::Tile { tileset, id, .. } => map.tilesets[*tileset].tiles.get(id),
        Placed::Nothing | Placed::Value { .. } => None,
    }
}

fn flip(map: &Map, entry: u32) -> Flip {
    if let Placed::Tile { flip, .. } = map.palette[entry as usize] { flip } else { Flip::default() }
}

fn said(tile: &Tile, options: &Options) -> Option<Said> {
    let is = |name: &str| words::is_blocked(name) && !options.is_flag(name);
    let full = |what: String, name: &str| {
        Some(Said { what, name: name.to_owned(), shape: TileShape::Full, flags: vec![name.to_owned()] })
    };
    let class = tile.class.trim();
    if is(class) {
        return full(format!("class '{class}'"), class);
    }
    let mut marks = tile.properties.marks().chain(tile.properties.ones());
    if let Some(name) = marks.find(|name| is(name) && words::blocked_side(name).is_none()) {
        return full(format!("property '{name}'"), name);
    }
    if let Some(sides) = Sides::of(tile, options) {
        let (shape, name) = (sides.shape()?, (*sides.names.first()?).to_owned());
        let flags = sides.names.iter().map(|&name| name.to_owned()).collect();
        return Some(Said { what: sides.what(), name, shape, flags });
    }
    let mut blocked = tile.properties.0.iter().filter(|(name, value)| value.is_false() && words::is_walkable(name));
    blocked.next().map(|(name, value)| {
        let value = shown(value);
        let (what, name) = (format!("property '{name}' = '{value}'"), format!("{name}:{value}"));
        Said { what, name, shape: TileShape::Full, flags: Vec::new() }
    })
}

/// A value of false, as options name it.
fn shown(value: &Value) -> &str {
    match value {
        Value::Number(text) | Value::Text(text) => text.trim(),
        Value::Bool(_) | Value::Object(_) | Value::Lost(_) => "false",
    }
}
