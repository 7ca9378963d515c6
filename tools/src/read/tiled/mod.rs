//! Maps of Tiled, in XML and in JSON, and worlds of them. Both formats are read into the same
//! [`raw`] form, from which this makes a level.

mod data;
mod lax;
mod objects;
mod raw;
mod sets;
mod tags;
mod unpack;
mod world;

use std::path::Path;

use super::file::Files;
use super::json;
use crate::model::decimal::Decimal;
use crate::model::map::{Content, Layer, Map, Tiles};
use crate::model::object::Spot;
use crate::model::property::Properties;
use data::{Form, MAX_CELLS};
use sets::Sets;
pub(super) use world::read as world;

type Result<T> = std::result::Result<T, String>;

/// Columns and rows are at most this far from the origin: their pixels stay below 2^30.
const FARTHEST: i64 = (1 << 30) / Map::MAX_TILE as i64;
/// The most layers in a map, with those of groups.
const MAX_LAYERS: usize = 1000;

/// Reads the bytes of a map in this file.
pub(super) fn read(bytes: Vec<u8>, path: &Path, files: &mut Files) -> Result<Map> {
    map(bytes, path, files).map(|(map, _)| map)
}

/// The same, and whether the map is infinite: then its size is that of nothing.
fn map(bytes: Vec<u8>, path: &Path, files: &mut Files) -> Result<(Map, bool)> {
    let map: raw::Map = if json::is_json(&bytes) { json::parse(&bytes) } else { tags::map(&bytes) }
        .map_err(|why| format!("not a Tiled map: {why}"))?;
    drop(bytes);
    let tile = side(&map)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let properties = vec![("the map".to_owned(), map.properties.0)];
    let mut reader = Reader {
        sets: Sets::new(),
        layers: Vec::new(),
        properties,
        cells: 0,
        tile,
        infinite: map.infinite,
        folder,
        files,
    };
    for set in map.tilesets {
        reader.sets.add(set, folder, reader.files)?;
    }
    for layer in map.layers {
        reader.layer(layer, &Around::default())?;
    }
    let read = Map {
        name: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        tile,
        size: (map.width, map.height),
        tilesets: reader.sets.all,
        palette: reader.sets.palette,
        layers: reader.layers,
        place: None,
        values: false,
        properties: reader.properties,
        notes: Vec::new(),
    };
    Ok((read, map.infinite))
}

fn side(map: &raw::Map) -> Result<u16> {
    // What every refusal here asks for, in the words of the editor.
    const IN_TILED: &str = "in Tiled, under Map > Map Properties, set";
    const ONE_NUMBER: &str = "Tile Width and Tile Height to the same number";
    match &*map.orientation {
        "orthogonal" => {}
        "" => return Err("not a Tiled map: it has no orientation".to_owned()),
        other => {
            return Err(format!(
                "the map is {other}, not orthogonal, and the library has square cells only: {IN_TILED} Orientation to \
                 Orthogonal, and {ONE_NUMBER}"
            ));
        }
    }
    let (width, height) = (map.tilewidth, map.tileheight);
    if width != height {
        return Err(format!(
            "tiles of {width}x{height} pixels are not square, and the library has square tiles only: {IN_TILED} \
             {ONE_NUMBER}"
        ));
    }
    Map::tile_of(width.into())
}

/// The first column and row of tiles that are moved by so many.
fn placed(tiles: &Tiles, by: (i32, i32)) -> Result<(i32, i32)> {
    let along = |at: i32, by: i32, count: u32| {
        let start = i64::from(at) + i64::from(by);
        let inside = start >= -FARTHEST && start + i64::from(count) <= FARTHEST;
        i32::try_from(start).ok().filter(|_| inside)
    };
    let moved = along(tiles.at.0, by.0, tiles.width).zip(along(tiles.at.1, by.1, tiles.height));
    moved.ok_or_else(|| {
        let (x, y) = (i64::from(tiles.at.0) + i64::from(by.0), i64::from(tiles.at.1) + i64::from(by.1));
        format!("it begins in column {x}, row {y}: move it nearer, columns and rows stay below {FARTHEST}")
    })
}

/// The settings of the groups around a layer.
#[derive(Default)]
struct Around {
    offset: Spot,
    hidden: bool,
    parallax: bool,
    says: Vec<String>,
}

struct Reader<'a> {
    sets: Sets,
    layers: Vec<Layer>,
    /// Of the map and its groups.
    properties: Vec<(String, Properties)>,
    /// The cells in all layers so far.
    cells: u64,
    tile: u16,
    infinite: bool,
    folder: &'a Path,
    files: &'a mut Files,
}

impl Reader<'_> {
    fn layer(&mut self, layer: raw::Layer, around: &Around) -> Result<()> {
        let name = layer.name.clone();
        let of_layer = |why: String| format!("layer '{name}': {why}");
        let offset = (around.offset.0 + layer.offsetx.0, around.offset.1 + layer.offsety.0);
        let hidden = around.hidden || !layer.visible || layer.opacity.0 == Decimal::ZERO;
        let moves = |factor: raw::Number| factor.0 != Decimal::whole(1);
        let parallax = around.parallax || moves(layer.parallaxx) || moves(layer.parallaxy);
        let marks: Vec<String> = layer.properties.0.marks().map(str::to_owned).collect();
        let content = match &*layer.form {
            "group" => {
                let own = [&layer.name, &layer.class].into_iter().chain(&marks).filter(|name| !name.is_empty());
                let says = around.says.iter().chain(own).cloned().collect();
                let around = Around { offset, hidden, parallax, says };
                self.properties.push((format!("group '{name}'"), layer.properties.0));
                return layer.layers.into_iter().try_for_each(|inner| self.layer(inner, &around));
            }
            "tilelayer" => {
                let form = Form {
                    width: layer.width,
                    height: layer.height,
                    encoding: layer.encoding.as_deref(),
                    compression: layer.compression.as_deref(),
                };
                let mut tiles = self.tiles(layer.data, layer.chunks, &form).map_err(of_layer)?;
                tiles.at = placed(&tiles, (layer.x, layer.y)).map_err(of_layer)?;
                Content::Tiles(tiles)
            }
            "objectgroup" => {
                let objects = layer.objects.into_iter();
                let read = objects.map(|object| self.sets.object(object, self.folder, self.files));
                Content::Objects(read.collect::<Result<_>>().map_err(of_layer)?)
            }
            "imagelayer" => Content::Image,
            other => return Err(of_layer(format!("a layer of the type '{other}'"))),
        };
        if self.layers.len() == MAX_LAYERS {
            return Err(format!("more than {MAX_LAYERS} layers"));
        }
        let groups = around.says.clone();
        let (name, class, properties) = (layer.name, layer.class, layer.properties.0);
        self.layers.push(Layer { name, class, properties, marks, groups, offset, hidden, parallax, content });
        Ok(())
    }

    fn tiles(&mut self, data: Option<raw::Data>, chunks: Vec<raw::Chunk>, form: &Form<'_>) -> Result<Tiles> {
        if chunks.is_empty() && self.infinite {
            return Ok(Tiles { tile: self.tile, ..Tiles::default() });
        }
        if chunks.is_empty() {
            self.count(form.width, form.height)?;
            let data = data.ok_or("it has no data: save the map again in Tiled")?;
            let cells = self.places(data, form)?;
            return Ok(Tiles {
                tile: self.tile,
                at: (0, 0),
                width: form.width,
                height: form.height,
                cells,
                derived: false,
            });
        }
        // Chunks can overlap, and each one is unpacked.
        let all = chunks
            .iter()
            .fold(0, |all: u64, chunk| all.saturating_add(u64::from(chunk.width) * u64::from(chunk.height)));
        if all > MAX_CELLS {
            return Err(format!("its chunks have more than {MAX_CELLS} tiles"));
        }
        let sides = |chunk: &raw::Chunk| {
            (i64::from(chunk.x) + i64::from(chunk.width), i64::from(chunk.y) + i64::from(chunk.height))
        };
        let (left, top) = chunks.iter().fold((i32::MAX, i32::MAX), |at, chunk| (at.0.min(chunk.x), at.1.min(chunk.y)));
        let (right, bottom) =
            chunks.iter().map(sides).fold((i64::MIN, i64::MIN), |at, end| (at.0.max(end.0), at.1.max(end.1)));
        let side = |from: i32, to: i64| u32::try_from(to - i64::from(from)).unwrap_or(u32::MAX);
        let (width, height) = (side(left, right), side(top, bottom));
        self.count(width, height)?;
        let mut cells = vec![0; width as usize * height as usize];
        for chunk in chunks {
            let form = Form { width: chunk.width, height: chunk.height, ..*form };
            let of_chunk = |why: String| format!("the chunk at ({}, {}): {why}", chunk.x, chunk.y);
            let data = chunk.data.ok_or_else(|| of_chunk("it has no data: save the map again in Tiled".to_owned()))?;
            let places = self.places(data, &form).map_err(of_chunk)?;
            let (x, y) = ((chunk.x - left) as usize, (chunk.y - top) as usize);
            for (row, line) in places.chunks(chunk.width.max(1) as usize).enumerate() {
                let from = (y + row) * width as usize + x;
                cells[from..from + line.len()].copy_from_slice(line);
            }
        }
        Ok(Tiles { tile: self.tile, at: (left, top), width, height, cells, derived: false })
    }

    /// Refuses more cells than a map may have.
    fn count(&mut self, width: u32, height: u32) -> Result<()> {
        self.cells = self.cells.saturating_add(u64::from(width) * u64::from(height));
        if self.cells > MAX_CELLS {
            return Err(format!("with it the layers have more than {MAX_CELLS} tiles"));
        }
        Ok(())
    }

    fn places(&mut self, data: raw::Data, form: &Form<'_>) -> Result<Vec<u32>> {
        let mut cells = data::gids(data, form)?;
        let mut last = (0, 0);
        for (i, cell) in cells.iter_mut().enumerate() {
            if *cell != last.0 {
                let (column, row) = (i as u32 % form.width.max(1), i as u32 / form.width.max(1));
                let of_cell = |why: String| format!("column {column}, row {row}: {why}");
                last = (*cell, self.sets.place(*cell).map_err(of_cell)?);
            }
            *cell = last.1;
        }
        Ok(cells)
    }
}
