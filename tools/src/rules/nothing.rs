//! The advice to a user whose level has nothing solid.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::cells::Sheet;
use super::form;
use super::options::Options;
use super::words;
use crate::model::map::{Content, Map, Placed};

/// The most names in a list.
const MOST: usize = 20;

/// An error that names the layers, their counts and the option to add. Without advice if a level of
/// `LDtk` is empty.
pub(super) fn explain(map: &Map, sheets: &[Sheet<'_>], options: &Options) -> Result<(), String> {
    if let Some(layer) = &options.layer {
        return Err(format!("layer '{layer}' has no solid tile; --solid-layer '{layer}' makes every tile of it full"));
    }
    let mut tiles: Vec<String> = Vec::new();
    let mut names: BTreeSet<&str> = BTreeSet::new();
    for sheet in sheets {
        let count = sheet.tiles.drawn().count();
        if count > 0 {
            tiles.push(format!("'{}' ({})", sheet.layer.name, words::several(count, "tile")));
        }
        names.extend(sheet.flags.values().flatten().map(String::as_str));
    }
    let (mut objects, mut marks): (Vec<String>, usize) = (Vec::new(), 0);
    for layer in &map.layers {
        let Content::Objects(all) = &layer.content else { continue };
        let count = all.iter().filter(|object| form::has_extent(object)).count();
        marks += all.len() - count;
        if count > 0 {
            objects.push(format!("'{}' ({})", layer.name, words::several(count, "object")));
        }
    }
    let is_bare = tiles.is_empty() && objects.is_empty() && marks == 0;
    if is_bare && map.values {
        return Ok(());
    }
    // Writing to a string cannot fail.
    let mut why = "nothing is solid: no tile, no object".to_owned();
    if !tiles.is_empty() {
        let _ = write!(why, "; the tile layers are {}: add --solid-layer NAME if all of it is solid", list(&tiles));
    }
    if !names.is_empty() {
        let names: Vec<String> = names.into_iter().map(|name| format!("'{name}'")).collect();
        let _ = write!(why, "; names of tiles are {}: add --solid NAME", list(&names));
    }
    if !objects.is_empty() {
        let _ = write!(why, "; the object layers are {}: add --objects NAME if they are solid", list(&objects));
    } else if marks > 0 {
        why += "; the objects are points and texts, which are never solid: draw rectangles or polygons";
    }
    if is_bare {
        why += "; nothing is drawn in a tile layer or an object layer, and images are not solid: draw tiles or shapes there";
    }
    if only_marks(map) {
        why += "; points and texts of Tiled's collision editor are not solid: draw rectangles or polygons there";
    }
    if map.values && map.palette.iter().any(|placed| matches!(placed, Placed::Value { .. })) {
        why += "; --ignore-level NAME skips a level";
    }
    Err(why)
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

fn list(names: &[String]) -> String {
    let shown = names[..names.len().min(MOST)].join(", ");
    if names.len() > MOST { format!("{shown} and {} more", names.len() - MOST) } else { shown }
}
