//! The tile layers of a Tiled map: for each cell its traits.

use std::cell::Cell;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Once;

use tiled::{FiniteTileLayer, LayerType, Loader, Map, Orientation, PropertyValue};

use super::guard;
use crate::fail::{Fail, Result};
use crate::read::drawing::{DOMAIN, TileLayer, TileLayers};
use crate::rules::flip::Flip;
use crate::rules::traits::Traits;

/// Reads the tile layers of a map and of the tilesets that it names.
///
/// # Errors
///
/// One line that names the map and says what in it, or in a tileset, is not for the library.
pub fn load(path: &Path) -> Result<TileLayers> {
    let fail = |why: String| Fail::new(format!("{}: {why}", path.display()));
    quietly(|| {
        let map = Loader::with_reader(guard::read).load_tmx_map(path);
        reduce(&map.map_err(|e| why(&e))?)
    })
    .unwrap_or_else(|| Err("a tile layer holds less than its width and height say".to_owned()))
    .map_err(fail)
}

fn why(error: &tiled::Error) -> String {
    match error {
        tiled::Error::ResourceLoadingError { path, err } => {
            format!("cannot read {}: {err}", path.display())
        }
        other => format!("not a Tiled map: {other}"),
    }
}

fn reduce(map: &Map) -> std::result::Result<TileLayers, String> {
    if map.infinite() {
        return Err("the map is infinite; turn that off in Tiled's map properties".to_owned());
    }
    if map.orientation != Orientation::Orthogonal {
        return Err(format!("the map is {:?}, not orthogonal", map.orientation).to_lowercase());
    }
    let (tile, tile_height) = (map.tile_width, map.tile_height);
    if tile != tile_height {
        return Err(format!("tiles of {tile}x{tile_height} pixels are not square"));
    }
    if !(1..=256).contains(&tile) {
        return Err(format!("tiles of {tile} pixels; the library takes 1 to 256"));
    }
    let mut drawn = TileLayers { tile: tile as u16, layers: Vec::new(), palette: vec![Traits::default()] };
    let mut seen = HashMap::new();
    let mut pending: Vec<_> = map.layers().collect();
    pending.reverse();
    while let Some(layer) = pending.pop() {
        match layer.layer_type() {
            LayerType::Tiles(tiled::TileLayer::Finite(tiles)) => {
                let layer = read_layer(&layer.name, &tiles, &mut drawn, &mut seen)?;
                drawn.layers.push(layer);
            }
            LayerType::Group(group) => {
                let mut inner: Vec<_> = group.layers().collect();
                inner.reverse();
                pending.extend(inner);
            }
            _ => {}
        }
    }
    Ok(drawn)
}

fn read_layer(
    name: &str,
    tiles: &FiniteTileLayer<'_>,
    drawn: &mut TileLayers,
    seen: &mut HashMap<(usize, u32, Flip), u32>,
) -> std::result::Result<TileLayer, String> {
    let (width, height) = (tiles.width(), tiles.height());
    if u64::from(width.max(height)) * u64::from(drawn.tile) >= DOMAIN {
        return Err(format!(
            "layer '{name}' of {width}x{height} tiles of {} pixels is beyond the domain: \
             a side must be shorter than {DOMAIN} pixels",
            drawn.tile
        ));
    }
    let mut cells = Vec::new();
    for y in 0..height as i32 {
        for x in 0..width as i32 {
            let Some(tile) = tiles.get_tile(x, y) else {
                cells.push(0);
                continue;
            };
            let flip = Flip { diagonal: tile.flip_d, horizontal: tile.flip_h, vertical: tile.flip_v };
            cells.push(match seen.entry((tile.tileset_index(), tile.id(), flip)) {
                Entry::Occupied(known) => *known.get(),
                Entry::Vacant(new) => {
                    let named = |why| format!("tile {} of tileset '{}': {why}", tile.id(), tile.get_tileset().name);
                    let mut traits = tile.get_tile().map_or(Ok(Traits::default()), |t| traits(&t)).map_err(named)?;
                    traits.shape = flip.of(traits.shape);
                    drawn.palette.push(traits);
                    *new.insert(drawn.palette.len() as u32 - 1)
                }
            });
        }
    }
    Ok(TileLayer { name: name.to_owned(), width: width as u16, height: height as u16, cells })
}

fn traits(tile: &tiled::Tile<'_>) -> std::result::Result<Traits, String> {
    let mut names: Vec<&str> = tile
        .properties
        .iter()
        .filter(|(_, value)| matches!(value, PropertyValue::BoolValue(true)))
        .map(|(name, _)| name.as_str())
        .collect();
    // The crate keeps properties in a hash map, whose order differs from run to run.
    names.sort_unstable();
    names.insert(0, tile.user_type.as_str());
    // The guard has made them text, whatever their type is in the file.
    let text = |name: &str| match tile.properties.get(name) {
        Some(PropertyValue::StringValue(text)) => Some(text.as_str()),
        _ => None,
    };
    Traits::from_names(&names).with_properties(text(guard::SHAPE), text(guard::NPP))
}

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// `None` when `work` panics, without a message.
///
/// `tiled` 0.16 indexes a layer's tiles by width and height without looking how many there are,
/// and shows that number to nobody, so a short layer can only be noticed like this.
fn quietly<T>(work: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let default = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !QUIET.get() {
                default(info);
            }
        }));
    });
    QUIET.set(true);
    let result = catch_unwind(AssertUnwindSafe(work));
    QUIET.set(false);
    result.ok()
}
