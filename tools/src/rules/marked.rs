//! A guess by the tiles' own names and properties, if no rule marks a tile or an object. Games have
//! their own words: `isSolid`, `hasCollision`, `impassable`, or `walkable` that is false. They say
//! more than the name of a layer.

use tilesat::TileShape;

use super::cells::Sheet;
use super::guess;
use super::layers::Layers;
use super::options::Options;
use super::piece::Piece;
use super::report::Rule;
use super::verdict::Solid;
use super::{traits, words};
use crate::model::map::{Map, Placed};
use crate::model::property::{Properties, Value};
use crate::model::tileset::Tile;

/// What a tile says of itself: the words for the report, and its name in an option.
struct Said {
    what: String,
    name: String,
    /// The flag that it no longer has to be.
    flag: Option<String>,
}

impl Layers<'_> {
    /// Makes the undecided tiles full that say so in words that are no rule.
    pub(super) fn guess_by_tiles(&mut self, sheets: &mut [Sheet<'_>]) {
        // Values of LDtk have names, and its tiles serve the drawing.
        if self.map.values {
            return;
        }
        for sheet in sheets {
            if sheet.tiles.derived || guess::is_skipped(sheet.layer, self.options) {
                continue;
            }
            for (entry, count) in sheet.used.clone() {
                let tile = tile(self.map, entry).filter(|_| !sheet.pieces.contains_key(&entry));
                let Some(said) = tile.and_then(|tile| said(tile, self.options)) else { continue };
                let piece = self.piece(entry, Solid::Shape(TileShape::Full), sheet.tiles.tile);
                sheet.pieces.insert(entry, piece);
                if let (Some(name), Some(flags)) = (&said.flag, sheet.flags.get_mut(&entry)) {
                    flags.retain(|flag| !words::same(flag, name));
                }
                self.ledger.add(Rule::D, &format!("tiles with the {} are full", said.what), count);
                self.note(format!(
                    "GUESS: nothing marks solid tiles, so those with the {} are full; --solid '{}' confirms it, \
                     --empty '{}' refuses it",
                    said.what, said.name, said.name
                ));
            }
        }
    }

    /// Notes the tiles that are called slopes, and are none: games name directions differently.
    pub(super) fn slopes(&mut self, sheets: &[Sheet<'_>]) {
        for (sheet, (entry, _)) in sheets.iter().flat_map(|sheet| sheet.used.iter().map(move |used| (sheet, used))) {
            let is_block = matches!(sheet.pieces.get(entry), None | Some(Piece::Shape(TileShape::Full)));
            let Some(tile) = tile(self.map, *entry).filter(|_| is_block && !self.map.values) else { continue };
            let own = tile.properties.0.iter().filter(|(_, value)| !value.is_false()).map(|(name, _)| name);
            let is = |name: &&String| words::has(name, &["slope", "ramp"]) && !self.options.is_flag(name);
            if let Some(name) = own.chain([&tile.class]).find(is) {
                self.note(format!(
                    "GUESS: tiles with '{name}' are no slopes; --solid TILESET:ID=slope-bottom-left makes one so"
                ));
            }
        }
    }
}

/// Whether a class or a true property says that a tile or a shape only notices bodies.
pub(super) fn senses(class: &str, properties: &Properties) -> bool {
    properties.marks().chain([class]).any(words::is_sensor)
}

/// Whether a tile says that bodies pass, so that the name of its layer does not make it solid.
pub(super) fn is_free(map: &Map, entry: u32) -> bool {
    let says = |tile: &Tile| {
        let walkable = tile.properties.marks().chain(tile.properties.ones()).any(words::is_walkable);
        walkable || denied(&tile.properties).is_some()
    };
    is_sensor(map, entry) || !map.values && tile(map, entry).is_some_and(says)
}

/// Whether a tile only notices bodies, so that not even a layer of collisions makes it solid.
pub(super) fn is_sensor(map: &Map, entry: u32) -> bool {
    !map.values && tile(map, entry).is_some_and(|tile| senses(&tile.class, &tile.properties))
}

/// The first property that says of its owner that it is not solid: `solid` that is false.
pub(super) fn denied(properties: &Properties) -> Option<&str> {
    let solid = |name: &str| words::is_blocked(name) || traits::shape(name) == Some(TileShape::Full);
    let mut all = properties.0.iter().filter(|(name, value)| value.is_false() && solid(name));
    all.next().map(|(name, _)| name.as_str())
}

fn tile(map: &Map, entry: u32) -> Option<&Tile> {
    match &map.palette[entry as usize] {
        Placed::Tile { tileset, id, .. } => map.tilesets[*tileset].tiles.get(id),
        Placed::Nothing | Placed::Value { .. } => None,
    }
}

fn said(tile: &Tile, options: &Options) -> Option<Said> {
    let is = |name: &str| words::is_blocked(name) && !options.is_flag(name);
    let class = tile.class.trim();
    if is(class) {
        let (what, flag) = (format!("class '{class}'"), Some(class.to_owned()));
        return Some(Said { what, name: class.to_owned(), flag });
    }
    let mut marks = tile.properties.marks().chain(tile.properties.ones());
    if let Some(name) = marks.find(|name| is(name)) {
        let (what, flag) = (format!("property '{name}'"), Some(name.to_owned()));
        return Some(Said { what, name: name.to_owned(), flag });
    }
    let mut blocked = tile.properties.0.iter().filter(|(name, value)| value.is_false() && words::is_walkable(name));
    blocked.next().map(|(name, value)| {
        let value = shown(value);
        Said { what: format!("property '{name}' = '{value}'"), name: format!("{name}:{value}"), flag: None }
    })
}

/// A value of false, as options name it.
fn shown(value: &Value) -> &str {
    match value {
        Value::Number(text) | Value::Text(text) => text,
        Value::Bool(_) | Value::Object(_) | Value::Lost(_) => "false",
    }
}
