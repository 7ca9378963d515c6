//! Projects of `LDtk`: every level, with the layers of `IntGrid` values, of tiles and of entities.

mod raw;

use std::collections::{HashMap, HashSet};
use std::path::Path;
use std::rc::Rc;

use super::file::Files;
use super::json;
use crate::model::decimal::Decimal;
use crate::model::flip::Flip;
use crate::model::map::{Content, Layer, Map, Place, Placed, Tiles};
use crate::model::object::{Form, Object, Spot};
use crate::model::property::{Properties, Value};
use crate::model::tileset::{Tile, Tileset};

type Result<T> = std::result::Result<T, String>;

/// The limit for all layers of a level together: 4096 x 4096.
const MAX_CELLS: u64 = 1 << 24;
/// The limit for all levels of a project together.
const MAX_PROJECT: u64 = 1 << 25;

/// What a file in JSON looks like, whatever its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Looks {
    Project,
    /// A map of Tiled has a direction of its cells.
    Map,
    Neither,
}

/// Judges by the names of its members: a map can have a property of any name.
pub(super) fn looks(bytes: &[u8]) -> Looks {
    let keys = json::keys(bytes);
    let has = |names: &[&str]| keys.iter().any(|key| names.iter().any(|name| name.as_bytes() == *key));
    if has(&["orientation", "tilewidth"]) {
        Looks::Map
    } else if has(&["defs", "levels", "worlds"]) {
        Looks::Project
    } else {
        Looks::Neither
    }
}

/// All levels of a project, or the one of this name.
pub(super) fn read(bytes: &[u8], level: Option<&str>, path: &Path, files: &mut Files) -> Result<Vec<Map>> {
    let project: raw::Project = json::parse(bytes).map_err(|why| format!("not an LDtk project: {why}"))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let tilesets: Vec<Rc<Tileset>> = project.defs.tilesets.iter().map(|set| Rc::new(tileset(set, folder))).collect();
    let definitions = &project.defs;
    let version = project.version.as_deref();
    let mut reader = Reader { definitions, version, tilesets, folder, files, cells: 0, ids: Ids::default() };
    let alone =
        raw::World { identifier: String::new(), layout: project.layout, levels: project.levels.unwrap_or_default() };
    let worlds: Vec<raw::World> = std::iter::once(alone).chain(project.worlds).collect();
    let many = worlds.iter().filter(|world| !world.levels.is_empty()).count() > 1;
    // Worlds can have levels of the same name.
    let name = |world: &str, level: &str| {
        if many && !world.is_empty() { format!("{world}/{level}") } else { level.to_owned() }
    };
    let names: Vec<String> = worlds
        .iter()
        .flat_map(|world| world.levels.iter().map(|level| name(&world.identifier, &level.identifier)))
        .collect();
    if names.is_empty() {
        return Err("not an LDtk project: it has no levels".to_owned());
    }
    if let Some(wanted) = level.filter(|wanted| !names.iter().any(|name| name == wanted)) {
        return Err(format!("no level '{wanted}'; there are: {}", names.join(", ")));
    }
    let mut maps = Vec::new();
    for (number, world) in worlds.into_iter().enumerate() {
        for found in world.levels {
            let name = name(&world.identifier, &found.identifier);
            if level.is_none_or(|wanted| wanted == name) {
                let of_level = |why: String| format!("level '{name}': {why}");
                let world = world.layout.is_some().then_some(number);
                maps.push(reader.level(found, &name, world).map_err(of_level)?);
            }
        }
    }
    let layers = maps.iter_mut().flat_map(|map| &mut map.layers);
    for layer in layers {
        let Content::Objects(objects) = &mut layer.content else { continue };
        for (_, value) in objects.iter_mut().flat_map(|object| &mut object.fields.0) {
            if matches!(value, Value::Object(id) if !reader.ids.read.contains(id)) {
                *value = Value::Lost("it refers to an entity that is in no level of the input".to_owned());
            }
        }
    }
    Ok(maps)
}

/// Numbers for the entities of a project, by their names in the file.
#[derive(Debug, Default)]
struct Ids {
    known: HashMap<String, u32>,
    /// Those of entities that were read.
    read: HashSet<u32>,
    count: u32,
}

impl Ids {
    /// The number of an entity, which may come later.
    fn of(&mut self, iid: &str) -> u32 {
        *self.known.entry(iid.to_owned()).or_insert_with(|| {
            self.count += 1;
            self.count
        })
    }

    /// The number of an entity that is read now. Old files have no names.
    fn of_read(&mut self, iid: &str) -> u32 {
        let mut id = if iid.is_empty() { 0 } else { self.of(iid) };
        // A copy of an entity by hand has its name, too.
        if iid.is_empty() || self.read.contains(&id) {
            self.count += 1;
            id = self.count;
        }
        self.read.insert(id);
        id
    }
}

fn tileset(set: &raw::Tileset, folder: &Path) -> Tileset {
    let along = |length: u32| {
        let room = (u64::from(length) + u64::from(set.spacing)).saturating_sub(2 * u64::from(set.padding));
        room.checked_div(u64::from(set.tile_grid_size) + u64::from(set.spacing)).unwrap_or(0) as u32
    };
    let mut tiles: HashMap<u32, Tile> = HashMap::new();
    for tag in &set.enum_tags {
        for &id in &tag.tile_ids {
            let value = Value::Bool(true);
            tiles.entry(id).or_default().properties.0.push((tag.enum_value_id.clone(), value));
        }
    }
    Tileset {
        name: set.identifier.clone(),
        size: (set.tile_grid_size, set.tile_grid_size),
        columns: along(set.px_wid).max(1),
        margin: set.padding,
        spacing: set.spacing,
        image: set.rel_path.as_ref().map(|path| folder.join(path)),
        tiles,
        ..Tileset::default()
    }
}

struct Reader<'a> {
    definitions: &'a raw::Definitions,
    /// Of the program that saved the project.
    version: Option<&'a str>,
    tilesets: Vec<Rc<Tileset>>,
    folder: &'a Path,
    files: &'a mut Files,
    /// The cells in all levels so far.
    cells: u64,
    ids: Ids,
}

/// The meaning of the numbers of a level's layers, while it grows.
#[derive(Default)]
struct Palette {
    all: Vec<Placed>,
    tiles: HashMap<(usize, u32, Flip), u32>,
    values: HashMap<(String, i64), u32>,
}

impl Reader<'_> {
    fn level(&mut self, mut level: raw::Level, name: &str, world: Option<usize>) -> Result<Map> {
        if let (None, Some(file)) = (&level.layer_instances, &level.external_rel_path) {
            let path = self.folder.join(file);
            let of_file = |why: String| format!("{}: {why}", path.display());
            let bytes = self.files.bytes(&path).map_err(of_file)?;
            let apart: raw::Level =
                json::parse(&bytes).map_err(|why| of_file(format!("not a level of LDtk: {why}")))?;
            level.layer_instances = apart.layer_instances;
        }
        let layers = level.layer_instances.ok_or("its layers are neither here nor in a separate file")?;
        let mut palette = Palette { all: vec![Placed::Nothing], ..Palette::default() };
        let (mut read, mut tile) = (Vec::new(), None);
        let start = self.cells;
        // LDtk lists the uppermost layer first.
        for layer in layers.iter().rev() {
            let of_layer = |why: String| format!("layer '{}': {why}", layer.name);
            if layer.form == "Entities" {
                // Only the points of fields need the side of a cell.
                let side = layer.tile.0.min(256) as u16;
                let ids: Vec<u32> = layer.entities.iter().map(|entity| self.ids.of_read(&entity.iid)).collect();
                let objects =
                    layer.entities.iter().zip(ids).map(|(entity, id)| object(entity, id, side, &mut self.ids));
                let objects = Content::Objects(objects.collect());
                read.push(Layer::plain(&layer.name, (layer.x.into(), layer.y.into()), objects));
                continue;
            }
            let (side, before) = (grid(layer).map_err(of_layer)?, read.len());
            self.cells = self.cells.saturating_add(layer.width.0.saturating_mul(layer.height.0));
            if self.cells - start > MAX_CELLS || self.cells > MAX_PROJECT {
                return Err(of_layer(format!("with it the layers have more than {MAX_CELLS} cells")));
            }
            if layer.form == "IntGrid" {
                tile = tile.or(Some(side));
                read.push(self.values(layer, side, &mut palette).map_err(of_layer)?);
            }
            if let Some(uid) = layer.tileset {
                read.extend(self.tiles(layer, uid, side, &mut palette).map_err(of_layer)?);
            }
            let definition = self.definitions.layers.iter().find(|definition| definition.uid == layer.definition);
            for read in read.iter_mut().skip(before) {
                read.hidden = layer.visible == Some(false);
                read.parallax = definition.is_some_and(|of| (of.parallax_x, of.parallax_y) != (0.0, 0.0));
            }
        }
        let sides = read.iter().filter_map(|layer| layer.tiles().map(|tiles| tiles.tile));
        let tile = tile.or_else(|| sides.min()).unwrap_or(16);
        let plane = (world.unwrap_or(0), level.world_depth);
        let place = Place { x: level.world_x, y: level.world_y, width: level.px_wid, height: level.px_hei, plane };
        Ok(Map {
            name: name.to_owned(),
            tile,
            size: (level.px_wid / u32::from(tile), level.px_hei / u32::from(tile)),
            tilesets: self.tilesets.clone(),
            palette: palette.all,
            layers: read,
            place: (world.is_some() && place.width > 0).then_some(place),
            values: true,
        })
    }

    fn values(&self, layer: &raw::Layer, tile: u16, palette: &mut Palette) -> Result<Layer> {
        let (width, height) = (layer.width.0 as u32, layer.height.0 as u32);
        if layer.values.len() as u64 != u64::from(width) * u64::from(height) {
            // Before intGridCsv, LDtk listed only the cells with a value.
            if layer.values.is_empty() {
                let by = self.version.map_or_else(|| "an old LDtk".to_owned(), |version| format!("LDtk {version}"));
                return Err(format!("it has no intGridCsv: saved by {by}: open it in a newer one, and save it"));
            }
            return Err(format!("{} values for {width}x{height} cells", layer.values.len()));
        }
        let mut cells = Vec::with_capacity(layer.values.len());
        let mut last = (0, 0);
        for &value in &layer.values {
            if value != last.0 {
                last = (value, if value == 0 { 0 } else { self.value(layer, value.into(), palette)? });
            }
            cells.push(last.1);
        }
        let content = Content::Tiles(Tiles { tile, at: (0, 0), width, height, cells, derived: false });
        Ok(Layer::plain(&layer.name, (layer.x.into(), layer.y.into()), content))
    }

    /// The index of a value in the palette.
    fn value(&self, layer: &raw::Layer, number: i64, palette: &mut Palette) -> Result<u32> {
        if let Some(&place) = palette.values.get(&(layer.name.clone(), number)) {
            return Ok(place);
        }
        let uid = layer.definition;
        let definition = self.definitions.layers.iter().find(|definition| definition.uid == uid);
        let definition = definition.ok_or_else(|| format!("defs.layers has no uid {uid}"))?;
        let named = definition.values.iter().find(|named| named.value == number);
        let name = named.and_then(|named| named.identifier.clone()).filter(|name| !name.is_empty());
        let place = palette.all.len() as u32;
        palette.all.push(Placed::Value { layer: layer.name.clone(), number, name });
        palette.values.insert((layer.name.clone(), number), place);
        Ok(place)
    }

    /// Tiles can lie over each other. There are as many layers as the highest pile has tiles.
    fn tiles(&self, layer: &raw::Layer, uid: i64, tile: u16, palette: &mut Palette) -> Result<Vec<Layer>> {
        let derived = !layer.auto.is_empty();
        let tiles = if derived { &layer.auto } else { &layer.tiles };
        let known = self.definitions.tilesets.iter().position(|set| set.uid == uid);
        let set = known.ok_or_else(|| format!("defs.tilesets has no uid {uid}"))?;
        let (width, height) = (layer.width.0 as u32, layer.height.0 as u32);
        let side = i32::from(tile);
        let most = (MAX_CELLS / (u64::from(width) * u64::from(height)).max(1)).min(MOST_PILED) as usize;
        let mut piles: Vec<Tiles> = Vec::new();
        for placed in tiles {
            let (x, y) = (placed.px.0.div_euclid(side), placed.px.1.div_euclid(side));
            // Rules of auto layers can draw tiles that cross the border.
            if x < 0 || y < 0 || x as u32 >= width || y as u32 >= height {
                continue;
            }
            let cell = y as usize * width as usize + x as usize;
            let flip = Flip { diagonal: false, horizontal: placed.f & 1 != 0, vertical: placed.f & 2 != 0 };
            let next = palette.all.len() as u32;
            let place = *palette.tiles.entry((set, placed.t, flip)).or_insert(next);
            if place == next {
                palette.all.push(Placed::Tile { tileset: set, id: placed.t, flip });
            }
            match piles.iter().position(|pile| pile.cells[cell] == 0) {
                Some(pile) => piles[pile].cells[cell] = place,
                None if piles.len() < most => {
                    let mut cells = vec![0; width as usize * height as usize];
                    cells[cell] = place;
                    piles.push(Tiles { tile, at: (0, 0), width, height, cells, derived });
                }
                None => {}
            }
        }
        let offset = (layer.x.into(), layer.y.into());
        Ok(piles.into_iter().map(|pile| Layer::plain(&layer.name, offset, Content::Tiles(pile))).collect())
    }
}

/// Tiles in one cell of a layer. More cannot be distinguished in a picture.
const MOST_PILED: u64 = 8;

fn grid(layer: &raw::Layer) -> Result<u16> {
    for (name, count) in [("__cWid", &layer.width), ("__cHei", &layer.height), ("__gridSize", &layer.tile)] {
        if let Some(other) = &count.1 {
            return Err(format!("{name} is {other}, not a count"));
        }
    }
    let tile = layer.tile.0;
    if !(1..=256).contains(&tile) {
        return Err(format!("cells of {tile} pixels; the library accepts 1 to 256"));
    }
    Ok(tile as u16)
}

/// An entity is a rectangle with its name, its tags and its fields.
fn object(entity: &raw::Entity, id: u32, side: u16, ids: &mut Ids) -> Object {
    let pixels = |value: u32| Decimal::whole(value.into());
    let corner =
        |at: i32, size: u32, pivot: f64| Decimal::whole(at.into()) - Decimal::from_f64(f64::from(size) * pivot);
    let marks = entity.tags.iter().map(|tag| (tag.clone(), Value::Bool(true)));
    let (paths, fields): (Vec<_>, Vec<_>) =
        entity.fields.iter().partition(|field| matches!(field.form.as_str(), "Point" | "Array<Point>"));
    let values = fields.into_iter().flat_map(|field| values(field, ids)).collect();
    let points = |field: &raw::Field| each(&field.value).filter_map(|point| middle(point, side)).collect::<Vec<Spot>>();
    let paths = paths.into_iter().map(|field| (field.name.clone(), points(field))).filter(|path| !path.1.is_empty());
    Object {
        id,
        name: entity.name.clone(),
        class: entity.name.clone(),
        properties: Properties(marks.collect()),
        fields: Properties(values),
        paths: paths.collect(),
        at: (corner(entity.px.0, entity.width, entity.pivot.0), corner(entity.px.1, entity.height, entity.pivot.1)),
        size: (pixels(entity.width), pixels(entity.height)),
        rotation: Decimal::ZERO,
        hidden: false,
        form: Form::Rectangle,
    }
}

/// The values of a field: a list has several, and a field without a value none.
fn values(field: &raw::Field, ids: &mut Ids) -> Vec<(String, Value)> {
    let value = |value: &serde_json::Value| match value {
        serde_json::Value::Object(reference) => match reference.get("entityIid").and_then(|iid| iid.as_str()) {
            Some(iid) => Value::Object(ids.of(iid)),
            None => Value::Lost(format!("its type '{}' has no value here", field.form)),
        },
        plain => Value::from(plain),
    };
    let values: Vec<Value> = each(&field.value).map(value).collect();
    values.into_iter().map(|value| (field.name.clone(), value)).collect()
}

fn each(value: &serde_json::Value) -> impl Iterator<Item = &serde_json::Value> {
    let list = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
    list.iter().filter(|value| !value.is_null())
}

/// The middle of the cell that a point of `LDtk` names.
fn middle(point: &serde_json::Value, side: u16) -> Option<Spot> {
    let along = |name: &str| {
        let cell = i32::try_from(point.get(name)?.as_i64()?).ok()?;
        Some(Decimal::whole(i64::from(cell) * i64::from(side)) + Decimal::whole(side.into()).scaled(1, 2))
    };
    Some((along("cx")?, along("cy")?))
}
