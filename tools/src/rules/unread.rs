//! Files that could not be read: whether the level is known without them.

use super::cells::Sheet;
use super::ground::Doubt;
use super::objects;
use super::options::{Options, listed};
use crate::model::map::{Content, Layer, Map, Placed};
use crate::model::object::{Form, Object};

const WHY: &str = "what a missing file makes solid is missing, too";

/// A doubt about each tileset that is missing, and whose tiles are drawn.
///
/// # Errors
///
/// If such tiles are in a layer whose other tiles are solid by their own data. Nobody knows which
/// of them would be.
pub(super) fn tilesets(map: &Map, sheets: &[Sheet<'_>]) -> Result<Vec<Doubt>, String> {
    let mut doubts = Vec::new();
    for (index, set) in map.tilesets.iter().enumerate() {
        let Some(why) = &set.missing else { continue };
        let is_of = |cell: u32| matches!(map.palette[cell as usize], Placed::Tile { tileset, .. } if tileset == index);
        let mut drawn = 0;
        for sheet in sheets {
            let mut unknown = sheet.tiles.drawn().filter(|&(.., cell)| is_of(cell));
            let Some((x, y, cell)) = unknown.next() else { continue };
            drawn += 1 + unknown.count();
            if !sheet.pieces.contains_key(&cell) && !sheet.pieces.is_empty() {
                let name = &sheet.layer.name;
                return Err(format!(
                    "{why}; layer '{name}' has its tiles beside solid ones, the first in column {x}, row {y}: give the \
                     file, or add --solid-layer '{name}' if all of it is solid, or --ignore-layer '{name}'"
                ));
            }
        }
        let stamps =
            objects(map).filter(|(_, object)| matches!(&object.form, Form::Tile(stamp) if stamp.tileset == index));
        let stamps = stamps.count();
        if drawn + stamps > 0 {
            let what = format!(
                "{why}; {drawn} of its tiles are drawn, and {stamps} objects are tiles of it: they have neither classes \
                 nor properties nor shapes, and only their layers can make them solid"
            );
            doubts.push(Doubt { who: format!("tileset '{}'", set.name), what, why: WHY });
        }
    }
    Ok(doubts)
}

/// A doubt about each object whose template is missing.
///
/// # Errors
///
/// If the object is solid by its own values or its layer. Its form is in the template.
pub(super) fn templates(map: &Map, options: &Options) -> Result<Vec<Doubt>, String> {
    let mut doubts = Vec::new();
    for gap in &map.gaps {
        let known = objects(map).find(|(layer, object)| layer.name == gap.layer && object.id == gap.object);
        let Some((layer, object)) = known.filter(|(layer, _)| !listed(&options.ignored_layers, &layer.name)) else {
            continue;
        };
        if objects::kind(object, objects::layer_says(layer, options), options)?.is_some() {
            return Err(format!(
                "layer '{0}': {1}; the object is solid, and its form is not known: give the file, or add \
                 --ignore-layer '{0}'",
                gap.layer, gap.why
            ));
        }
        let what = format!("{}; it has its own values only", gap.why);
        doubts.push(Doubt { who: format!("layer '{}'", gap.layer), what, why: WHY });
    }
    Ok(doubts)
}

fn objects(map: &Map) -> impl Iterator<Item = (&Layer, &Object)> {
    map.layers.iter().flat_map(|layer| {
        let objects = if let Content::Objects(objects) = &layer.content { objects.as_slice() } else { &[] };
        objects.iter().map(move |object| (layer, object))
    })
}
