//! The advice to a user whose level has nothing solid.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::cells::Sheet;
use super::form;
use super::guess;
use super::options::Options;
use super::{traits, words};
use crate::model::map::{Content, Map, Placed};
use crate::model::property::Value;

/// The most names in a list.
const MOST: usize = 20;

/// A message that names the layers, their counts and the option to add. `None` if a level of `LDtk`
/// is empty.
pub(super) fn why(map: &Map, sheets: &[Sheet<'_>], options: &Options) -> Option<String> {
    if let Some(layer) = &options.layer {
        return Some(format!("layer '{layer}' has no solid tile; --solid-layer '{layer}' makes every tile of it full"));
    }
    // A layer of LDtk with tiles over each other is several sheets.
    let mut tiles: Vec<(&str, usize)> = Vec::new();
    for sheet in sheets {
        let (name, count) = (sheet.layer.name.as_str(), sheet.tiles.drawn().count());
        match tiles.last_mut().filter(|(last, _)| *last == name) {
            Some((_, all)) => *all += count,
            None => tiles.push((name, count)),
        }
    }
    tiles.retain(|(_, count)| *count > 0);
    let (mut objects, mut marks): (Vec<(&str, usize)>, usize) = (Vec::new(), 0);
    for layer in &map.layers {
        let Content::Objects(all) = &layer.content else { continue };
        let count = all.iter().filter(|object| form::has_extent(object)).count();
        marks += all.len() - count;
        if count > 0 {
            objects.push((&layer.name, count));
        }
    }
    let is_bare = tiles.is_empty() && objects.is_empty() && marks == 0;
    if is_bare && map.values {
        return None;
    }
    // Writing to a string cannot fail.
    let mut why = "nothing is solid: no tile, no object".to_owned();
    if let Some(advice) = guess::advice(map, sheets, options) {
        let _ = write!(why, "; {advice}");
    }
    if let [(first, _), ..] = tiles[..] {
        let (layers, name) = (counted(&tiles, "tile"), only(tiles.len(), first));
        let are = if tiles.len() == 1 { "layer is" } else { "layers are" };
        let _ = write!(why, "; the tile {are} {layers}: add --solid-layer {name} if all of it is solid");
    }
    if let Some((names, option)) = names_of_tiles(sheets) {
        let are = if option == "NAME" { "names of tiles are" } else { "the name of tiles is" };
        let _ = write!(why, "; {are} {names}: add --solid {option}");
    }
    if let Some((names, option)) = tags(map) {
        let are = if option == "NAME" { "tags of tiles are" } else { "the tag of tiles is" };
        let _ = write!(why, "; {are} {names}: add --solid {option}");
    }
    for hint in hints(map) {
        let _ = write!(why, "; {hint}");
    }
    if let [(first, _), ..] = objects[..] {
        let (layers, name) = (counted(&objects, "object"), only(objects.len(), first));
        let are = if objects.len() == 1 { "layer is" } else { "layers are" };
        let _ = write!(why, "; the object {are} {layers}: add --objects {name} if they are solid");
    } else if marks > 0 {
        why += "; the objects are points and texts, which are never solid: draw rectangles or polygons";
    }
    if is_bare {
        why += "; nothing is drawn in a tile layer or an object layer, and images are not solid: draw tiles or shapes there";
    }
    if only_marks(map) {
        why += "; points and texts of Tiled's collision editor are not solid: draw rectangles or polygons there";
    }
    Some(why)
}

/// The names of tiles that no rule knows, and the one for an option. Tiles that bodies walk on are
/// the wrong ones.
pub(super) fn names_of_tiles(sheets: &[Sheet<'_>]) -> Option<(String, String)> {
    choices(sheets.iter().flat_map(|sheet| sheet.flags.values().flatten()).map(String::as_str))
}

/// The tags of drawn tiles of `LDtk`, and the one for an option.
fn tags(map: &Map) -> Option<(String, String)> {
    let tile = |placed: &Placed| match placed {
        Placed::Tile { tileset, id, .. } if map.values => map.tilesets[*tileset].tiles.get(id),
        _ => None,
    };
    choices(map.palette.iter().filter_map(tile).flat_map(|tile| tile.properties.marks()))
}

fn choices<'a>(names: impl Iterator<Item = &'a str>) -> Option<(String, String)> {
    let names: BTreeSet<&str> = names.filter(|name| !words::is_walkable(name)).collect();
    let option = only(names.len(), names.first()?);
    let names: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
    Some((list(&names), option))
}

/// Whether a tile in a layer has collision shapes without an extent only.
fn only_marks(map: &Map) -> bool {
    let shapes = |placed: &Placed| match placed {
        Placed::Tile { tileset, id, .. } => map.tilesets[*tileset].tiles.get(id).map(|tile| tile.shapes.as_slice()),
        Placed::Nothing | Placed::Value { .. } => None,
    };
    let mut drawn = map.palette.iter().filter_map(shapes).filter(|shapes| !shapes.is_empty());
    drawn.any(|shapes| !shapes.iter().any(form::has_extent))
}

/// What tiles in a layer say in a way that is no rule: a rule's word whose value is a text.
pub(super) fn hints(map: &Map) -> BTreeSet<String> {
    let mut hints = BTreeSet::new();
    for placed in &map.palette {
        let Placed::Tile { tileset, id, .. } = placed else { continue };
        let Some(tile) = map.tilesets[*tileset].tiles.get(id) else { continue };
        for (name, value) in &tile.properties.0 {
            if let (Value::Text(text), Some(_), false) = (value, traits::shape(name), value.is_false()) {
                let kind = if TOP.contains(&text.trim()) { "one-way" } else { "solid" };
                let option = if text.is_empty() { String::new() } else { format!(", or add --{kind} '{name}:{text}'") };
                hints.insert(format!(
                    "tiles have the property '{name}' = '{text}', a text: make it a bool that is true{option}"
                ));
            } else if let (Value::Text(text), true) = (value, MEANINGS.iter().any(|known| words::same(name, known))) {
                if traits::shape(text).is_some() {
                    hints.insert(format!("tiles have the property '{name}' = '{text}': add --solid '{name}:{text}'"));
                }
            }
        }
    }
    hints
}

/// Properties whose value authors use as a class.
const MEANINGS: [&str; 4] = ["type", "kind", "class", "collision"];

/// Values for tiles that block from above only.
const TOP: [&str; 3] = ["top", "up", "above"];

/// `'Trees' (3 tiles), ..`
fn counted(layers: &[(&str, usize)], what: &str) -> String {
    list(&layers.iter().map(|(name, count)| format!("'{name}' ({})", words::several(*count, what))).collect::<Vec<_>>())
}

/// A name for an option: that of the only choice, or a placeholder.
fn only(count: usize, first: &str) -> String {
    if count == 1 { format!("'{first}'") } else { "NAME".to_owned() }
}

fn list(names: &[String]) -> String {
    let shown = names[..names.len().min(MOST)].join(", ");
    if names.len() > MOST { format!("{shown} and {} more", names.len() - MOST) } else { shown }
}
