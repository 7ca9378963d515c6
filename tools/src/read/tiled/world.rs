//! Worlds of Tiled: maps in separate files, each at a position.

use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::path::{Component, Path, PathBuf};

use serde::Deserialize;

use super::data::MAX_CELLS;
use super::patterns::{self, Entry, Pattern};
use super::project::Projects;
use super::raw::Listed;
use crate::model::map::{Map, Place, Tiles};
use crate::read::file::Files;
use crate::read::{Pick, json, lax};

type Result<T> = std::result::Result<T, String>;

/// The most maps of a world.
const MAX_MAPS: usize = 4096;
/// The limit for all maps of a world together, as for the levels of an `LDtk` project.
const MAX_WORLD: u64 = 2 * MAX_CELLS;

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct World {
    #[serde(deserialize_with = "lax::given")]
    maps: Vec<Entry>,
    #[serde(deserialize_with = "lax::given")]
    patterns: Vec<Pattern>,
    #[serde(deserialize_with = "lax::given")]
    properties: Listed,
}

/// All maps of a world, or the one of this name.
pub(in crate::read) fn read(bytes: &[u8], pick: Pick<'_>, path: &Path, files: &mut Files) -> Result<Vec<Map>> {
    let mut world: World = json::parse(bytes)
        .map_err(|why| super::foreign::mark(bytes).unwrap_or_else(|| format!("not a world of Tiled: {why}")))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    patterns::add(&mut world.maps, &world.patterns, folder, files)?;
    if world.maps.is_empty() {
        return Err("a world of Tiled without maps: add some with Tiled's World Tool".to_owned());
    }
    if world.maps.len() > MAX_MAPS {
        return Err(format!("a world of Tiled with more than {MAX_MAPS} maps"));
    }
    let names = names(&world.maps)?;
    if let Some(wanted) = pick.level.filter(|wanted| !names.iter().any(|name| name == wanted)) {
        return Err(format!("no level '{wanted}'; there are: {}", names.join(", ")));
    }
    files.levels.clone_from(&names);
    let (mut maps, mut cells, mut projects): (Vec<Map>, _, _) = (Vec::new(), 0, Projects::default());
    for (listed, name) in world.maps.iter().zip(names) {
        if !pick.has(&name) {
            continue;
        }
        let file = files.named(folder, &listed.file_name);
        let of_map = |why: String| format!("map '{name}': {}: {why}", file.display());
        let gone = "put it there, or remove it with Tiled's World Tool";
        let bytes = files.utf8_or(&file, gone).map_err(of_map)?;
        let (mut map, infinite) = super::map(bytes, &file, files, &mut projects).map_err(of_map)?;
        let tiles = map.layers.iter().filter_map(|layer| layer.tiles());
        cells += tiles.map(|tiles| tiles.cells.len() as u64).sum::<u64>();
        if cells > MAX_WORLD {
            return Err(of_map(format!("with it the world has more than {MAX_WORLD} cells")));
        }
        map.place = Some(place(listed, &map, infinite).map_err(of_map)?);
        map.name = name;
        maps.push(map);
    }
    if let Some(first) = maps.first_mut() {
        first.properties.push(("the world".to_owned(), world.properties.0));
    }
    Ok(maps)
}

/// The name of each file without its extension. With its folder, if another one has the same name.
fn names(maps: &[Entry]) -> Result<Vec<String>> {
    let mut seen: HashSet<PathBuf> = HashSet::new();
    for listed in maps {
        if listed.file_name.is_empty() {
            return Err("a world of Tiled with a map that has no fileName".to_owned());
        }
        if !seen.insert(Path::new(&listed.file_name).components().filter(|part| *part != Component::CurDir).collect()) {
            return Err(format!("the world lists the map '{}' twice: remove one", listed.file_name));
        }
    }
    let stem = |listed: &Entry| Path::new(&listed.file_name).file_stem().unwrap_or_default().to_os_string();
    let mut counts: HashMap<OsString, usize> = HashMap::new();
    for listed in maps {
        *counts.entry(stem(listed)).or_default() += 1;
    }
    let name = |listed: &Entry| match counts[&stem(listed)] {
        1 => stem(listed).to_string_lossy().into_owned(),
        _ => Path::new(&listed.file_name).with_extension("").to_string_lossy().into_owned(),
    };
    Ok(maps.iter().map(name).collect())
}

/// The area of a map in its world. A finite map has its own size.
fn place(listed: &Entry, map: &Map, infinite: bool) -> Result<Place> {
    let side = u32::from(map.tile);
    let own = (map.size.0.saturating_mul(side), map.size.1.saturating_mul(side));
    let (width, height) = match (infinite, listed.width.zip(listed.height)) {
        (false, _) => own,
        (true, Some(given)) => given,
        (true, None) => return Err("it is infinite, and the world does not give its width and height".to_owned()),
    };
    let (columns, rows) = (i64::from(width.div_ceil(side)), i64::from(height.div_ceil(side)));
    for (x, y, _) in map.layers.iter().filter_map(|layer| layer.tiles()).flat_map(Tiles::drawn) {
        if !(0..columns).contains(&i64::from(x)) || !(0..rows).contains(&i64::from(y)) {
            return Err(format!(
                "its tile in column {x}, row {y} is outside of the {columns}x{rows} cells that it has in the world"
            ));
        }
    }
    Ok(Place { x: listed.x, y: listed.y, width, height, plane: (0, 0) })
}
