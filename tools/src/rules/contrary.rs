//! What says of itself that it is solid, and that it is not.

use std::collections::BTreeMap;

use tilesat::TileShape;

use super::cells::Sheet;
use super::ground::Doubt;
use super::options::Options;
use super::outline::Title;
use super::words::several;
use super::{Rule, marked, names, objects, traits, verdict};
use crate::model::map::{Content, Layer, Map, Placed};
use crate::model::property::Properties;

const WHY: &str = "one of the two is a mistake";

/// A doubt about the solid tiles of each tileset that have such a mark, and deny it. A mark for
/// one-way contradicts nothing: such a tile is not quite solid.
pub(super) fn tiles(map: &Map, sheets: &[Sheet<'_>], options: &Options) -> Result<Vec<Doubt>, String> {
    let mut found: BTreeMap<(usize, String, String), Vec<u32>> = BTreeMap::new();
    let solid = sheets.iter().flat_map(|sheet| sheet.pieces.keys());
    for placed in solid.map(|entry| &map.palette[*entry as usize]) {
        let Placed::Tile { tileset, id, .. } = placed else { continue };
        let Some(tile) = map.tilesets[*tileset].tiles.get(id) else { continue };
        let Some(denial) = marked::denied(&tile.properties) else { continue };
        let marked = verdict::of(map, placed, options)?.verdict.filter(|verdict| verdict.rule == Rule::A);
        let is_one_way = |solid: verdict::Solid| match solid {
            verdict::Solid::Shape(shape) => names::is_one_way(shape),
            verdict::Solid::Drawn => false,
            verdict::Solid::Edges(_) => true,
        };
        if marked.is_some_and(|verdict| !is_one_way(verdict.solid)) {
            let mark = mark(&tile.class, &tile.properties).unwrap_or_else(|| "property shape or npp".to_owned());
            let ids = found.entry((*tileset, mark, denial.to_owned())).or_default();
            if !ids.contains(id) {
                ids.push(*id);
            }
        }
    }
    let doubt = |((index, mark, denial), ids): ((usize, String, String), Vec<u32>)| {
        let (name, first) = (&map.tilesets[index].name, ids.iter().min().copied().unwrap_or_default());
        let who = match ids.len() {
            1 => format!("tile {first} of tileset '{name}'"),
            count => format!("{} of tileset '{name}', the first of them {first}", several(count, "tile")),
        };
        Doubt { who, what: both(&mark, &denial), why: WHY }
    };
    Ok(found.into_iter().map(doubt).collect())
}

/// A doubt about each object with such a mark that denies it.
pub(super) fn objects(layers: &[&Layer], options: &Options) -> Result<Vec<Doubt>, String> {
    let mut doubts = Vec::new();
    for layer in layers {
        let Content::Objects(all) = &layer.content else { continue };
        for object in all {
            let Some(denial) = objects::contradicted(object, layer, options)? else { continue };
            let name = || format!("name '{}'", object.name);
            let by_name = || traits::shape(&object.name).map(|_| name());
            let mark = mark(&object.class, &object.properties).or_else(by_name);
            let mark = mark.unwrap_or_else(|| "property kind, type, class or name".to_owned());
            let title = Title { id: object.id, name: object.name.clone(), layer: layer.name.clone() };
            doubts.push(Doubt { who: title.to_string(), what: both(&mark, &denial), why: WHY });
        }
    }
    Ok(doubts)
}

fn both(mark: &str, denial: &str) -> String {
    format!(
        "its {mark} says solid, and counts; its property '{denial}' is false, and does not count: remove one of them"
    )
}

/// The class or the property that says solid.
fn mark(class: &str, properties: &Properties) -> Option<String> {
    let solid = |name: &&str| traits::shape(name) == Some(TileShape::Full);
    let of_class = Some(class.trim()).filter(solid).map(|class| format!("class '{class}'"));
    of_class.or_else(|| {
        let property = properties.marks().chain(properties.ones()).find(solid)?;
        Some(format!("property '{property}'"))
    })
}
