//! Maps of Tiled, in XML and in JSON, and worlds of them. Both formats are read into the same
//! [`raw`] form, from which this makes a level.

mod cells;
mod data;
mod foreign;
mod number;
mod objects;
mod patterns;
mod project;
mod raw;
mod sets;
mod tags;
mod unpack;
mod world;

use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::file::Files;
use super::{GIVE, json};
use crate::model::decimal::Decimal;
use crate::model::map::{Content, Gap, Group, Layer, Map};
use crate::model::object::Spot;
use crate::model::property::Properties;
use data::Form;
pub(super) use foreign::{map as foreign, mark};
use project::Projects;
use sets::Sets;
pub(super) use world::read as world;

type Result<T> = std::result::Result<T, String>;

/// The most layers in a map, with those of groups.
const MAX_LAYERS: usize = 1000;

/// Reads the bytes of a map in this file.
pub(super) fn read(bytes: Vec<u8>, path: &Path, files: &mut Files) -> Result<Map> {
    map(bytes, path, files, &mut Projects::default()).map(|(map, _)| map)
}

/// The same, and whether the map is infinite: then its size is that of nothing.
fn map(bytes: Vec<u8>, path: &Path, files: &mut Files, projects: &mut Projects) -> Result<(Map, bool)> {
    let is_json = json::is_json(&bytes);
    let map: raw::Map = if is_json { json::parse(&bytes) } else { tags::map(&bytes) }
        .map_err(|why| foreign::map(&bytes).unwrap_or_else(|| format!("not a Tiled map: {why}")))?;
    let mut notes = Vec::new();
    if map.orientation.is_empty() {
        if let Some(why) = foreign::map(&bytes) {
            return Err(why);
        }
        if map.tilewidth == 0 || map.layers.is_empty() {
            return Err(format!("not a Tiled map: it has no orientation: {GIVE}"));
        }
        // Scripts and small editors leave it out.
        notes.push("it has no orientation, and is read as an orthogonal map".to_owned());
    }
    drop(bytes);
    let (tile, grid) = side(&map)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let properties = vec![("the map".to_owned(), map.properties.0.with_class(&map.class))];
    let classes = projects.around(folder, files);
    let mut reader = Reader {
        sets: Sets::new((map.tilewidth, map.tileheight), classes),
        layers: Vec::new(),
        properties,
        cells: 0,
        tile,
        grid,
        infinite: map.infinite,
        size: (map.width, map.height),
        is_json,
        folder,
        files,
        warnings: Vec::new(),
        gaps: Vec::new(),
    };
    for set in map.tilesets {
        reader.sets.add(set, folder, reader.files)?;
    }
    for layer in map.layers {
        reader.layer(layer, &Around::default())?;
    }
    notes.append(&mut reader.files.notes);
    if grid != (1, 1) {
        notes.push(format!(
            "cells of {}x{} pixels become cells of {tile}x{tile}: each of them is {}x{} of these, and takes a byte for each",
            map.tilewidth, map.tileheight, grid.0, grid.1
        ));
    }
    if foreign::is_rule(reader.layers.iter().map(|layer| &*layer.name)) {
        let what =
            "its layers are those of a rule of Tiled's automapping, not of a level: give the map that it changes";
        reader.warnings.push(("the map".to_owned(), what.to_owned()));
    }
    reader.warnings.extend(reader.sets.warnings);
    let read = Map {
        name: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        project: PathBuf::new(),
        tile,
        grid,
        size: (map.width.saturating_mul(grid.0), map.height.saturating_mul(grid.1)),
        tilesets: reader.sets.all,
        palette: reader.sets.palette,
        layers: reader.layers,
        place: None,
        values: false,
        properties: reader.properties,
        notes,
        warnings: reader.warnings,
        gaps: reader.gaps,
    };
    Ok((read, map.infinite))
}

/// The side of a cell, and how many of them a cell of the file has along x and y.
fn side(map: &raw::Map) -> Result<(u16, (u32, u32))> {
    if !map.orientation.is_empty() && !map.orientation.eq_ignore_ascii_case("orthogonal") {
        return Err(format!(
            "the map is {}, not orthogonal, and the library has square cells only: in Tiled, under Map > Map \
             Properties, set Orientation to Orthogonal, and Tile Width and Tile Height to the same number",
            map.orientation
        ));
    }
    let (width, height) = (map.tilewidth, map.tileheight);
    let (whole, part) = (Map::tile_of(width.max(height).into())?, gcd(width, height));
    if width == height {
        return Ok((whole, (1, 1)));
    }
    Ok((Map::tile_of(width.min(height).into()).map(|_| part as u16)?, (width / part, height / part)))
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a.max(1) } else { gcd(b, a % b) }
}

/// The settings of the groups around a layer.
#[derive(Default)]
struct Around {
    offset: Spot,
    hidden: bool,
    parallax: bool,
    groups: Vec<Rc<Group>>,
}

struct Reader<'a> {
    sets: Sets,
    layers: Vec<Layer>,
    /// Of the map and its groups.
    properties: Vec<(String, Properties)>,
    /// The cells in all layers so far.
    cells: u64,
    tile: u16,
    /// How many cells a cell of the file has along x and y.
    grid: (u32, u32),
    infinite: bool,
    /// Columns and rows of the file.
    size: (u32, u32),
    is_json: bool,
    folder: &'a Path,
    files: &'a mut Files,
    warnings: Vec<(String, String)>,
    gaps: Vec<Gap>,
}

impl Reader<'_> {
    fn layer(&mut self, layer: raw::Layer, around: &Around) -> Result<()> {
        let name = layer.name.clone();
        let of_layer = |why: String| format!("layer '{name}': {why}");
        if let Some(far) = [layer.offsetx, layer.offsety].into_iter().find(raw::Number::is_far) {
            return Err(of_layer(format!("its offset is {far}, not a number below a million")));
        }
        let offset = (around.offset.0 + layer.offsetx.0, around.offset.1 + layer.offsety.0);
        let hidden = around.hidden || !layer.visible || layer.opacity.0 == Decimal::ZERO;
        let moves = |factor: raw::Number| factor.0 != Decimal::whole(1);
        let parallax = around.parallax || moves(layer.parallaxx) || moves(layer.parallaxy);
        let properties = objects::with_rest(layer.properties.0, self.sets.classes.of(&layer.class, "layer"));
        let layer = raw::Layer { properties: raw::Listed(properties), ..layer };
        let marks: Vec<String> = layer.properties.0.marks().map(str::to_owned).collect();
        let content = match &*layer.form {
            "group" => {
                let properties = layer.properties.0;
                self.properties.push((format!("group '{name}'"), properties.clone().with_class(&layer.class)));
                let group = Group { name: layer.name, class: layer.class, properties, marks };
                let groups = around.groups.iter().cloned().chain([Rc::new(group)]).collect();
                let around = Around { offset, hidden, parallax, groups };
                return layer.layers.into_iter().try_for_each(|inner| self.layer(inner, &around));
            }
            "tilelayer" => {
                // Other programs leave out what a finite map says already.
                let (width, height) = match (layer.width, layer.height) {
                    (0, 0) if !self.infinite => self.size,
                    own => own,
                };
                let form = Form {
                    width,
                    height,
                    encoding: layer.encoding.as_deref(),
                    compression: layer.compression.as_deref(),
                };
                let tiles = self.tiles(&name, (layer.data, layer.chunks), &form).map_err(of_layer)?;
                let tiles = self.placed(tiles, (layer.x, layer.y)).map_err(of_layer)?;
                Content::Tiles(tiles)
            }
            "objectgroup" => {
                let mut objects = Vec::new();
                for object in layer.objects {
                    let id = object.id;
                    let (object, gap) = self.sets.object(object, (self.folder, &name), self.files).map_err(of_layer)?;
                    self.gaps.extend(gap.map(|why| Gap { layer: name.clone(), object: id, why }));
                    objects.push(object);
                }
                Content::Objects(objects)
            }
            "imagelayer" => Content::Image,
            other => return Err(of_layer(format!("a layer of the type '{other}'"))),
        };
        if self.layers.len() == MAX_LAYERS {
            return Err(format!("more than {MAX_LAYERS} layers"));
        }
        let groups = around.groups.clone();
        let (name, class, properties) = (layer.name, layer.class, layer.properties.0);
        self.layers.push(Layer { name, class, properties, marks, groups, offset, hidden, parallax, content });
        Ok(())
    }
}
