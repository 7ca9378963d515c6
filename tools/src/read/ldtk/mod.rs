//! Projects of `LDtk`: every level, with the layers of `IntGrid` values, of tiles and of entities.

mod entities;
mod raw;
mod tiles;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::file::Files;
use super::{Pick, json};
use crate::model::map::{Content, Layer, Map, Place, Placed, Tiles};
use crate::model::property::{CUSTOM_DATA, Value};
use crate::model::tileset::{Tile, Tileset};
use entities::{Ids, fields, object};
use tiles::{Palette, Set};

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
pub(super) fn read(bytes: &[u8], pick: Pick<'_>, path: &Path, files: &mut Files) -> Result<Vec<Map>> {
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
        // A file of another program has no definitions, either.
        let is_project = json::keys(bytes).iter().any(|key| *key == b"defs");
        let why = if is_project {
            "a project of LDtk without levels: add one"
        } else {
            "not an LDtk project: it has no levels"
        };
        return Err(why.to_owned());
    }
    if let Some(wanted) = pick.level.filter(|wanted| !names.iter().any(|name| name == wanted)) {
        return Err(format!("no level '{wanted}'; there are: {}", names.join(", ")));
    }
    reader.files.levels = names;
    let mut maps = Vec::new();
    for (number, world) in worlds.into_iter().enumerate() {
        for found in world.levels {
            let name = name(&world.identifier, &found.identifier);
            if pick.has(&name) {
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
    for text in &set.custom_data {
        let value = Value::Text(text.data.clone());
        tiles.entry(text.tile_id).or_default().properties.0.push((CUSTOM_DATA.to_owned(), value));
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

impl Reader<'_> {
    fn level(&mut self, mut level: raw::Level, name: &str, world: Option<usize>) -> Result<Map> {
        if let (None, Some(file)) = (&level.layer_instances, &level.external_rel_path) {
            let path = self.files.named(self.folder, file);
            let of_file = |why: String| format!("{}: {why}", path.display());
            let gone = "put it there, or save the project again in LDtk";
            let bytes = self.files.utf8_or(&path, gone).map_err(of_file)?;
            let apart: raw::Level =
                json::parse(&bytes).map_err(|why| of_file(format!("not a level of LDtk: {why}")))?;
            level.layer_instances = apart.layer_instances;
            level.field_instances = apart.field_instances;
        }
        let layers = level.layer_instances.ok_or("its layers are neither here nor in a separate file")?;
        let mut palette = Palette::new();
        let (mut read, mut tile, mut notes) = (Vec::new(), None, std::mem::take(&mut self.files.notes));
        let start = self.cells;
        // LDtk lists the uppermost layer first.
        for layer in layers.iter().rev() {
            let of_layer = |why: String| format!("layer '{}': {why}", layer.name);
            self.known(layer).map_err(of_layer)?;
            let definition = self.definitions.layers.iter().find(|definition| definition.uid == layer.definition);
            if layer.form == "Entities" {
                // Only the points of fields need the side of a cell.
                let side = layer.tile.0.min(Map::MAX_TILE.into()) as u16;
                let ids: Vec<u32> = layer.entities.iter().map(|entity| self.ids.of_read(&entity.iid)).collect();
                let objects =
                    layer.entities.iter().zip(ids).map(|(entity, id)| object(entity, id, side, &mut self.ids));
                let objects = Content::Objects(objects.collect());
                let mut objects = Layer::plain(&layer.name, (layer.x.into(), layer.y.into()), objects);
                show(std::slice::from_mut(&mut objects), layer, definition);
                read.push(objects);
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
                let known = self.definitions.tilesets.iter().position(|set| set.uid == uid);
                let index = known.ok_or_else(|| {
                    of_layer(format!("defs.tilesets has no uid {uid}: save the project again in LDtk"))
                })?;
                let own = Some(self.definitions.tilesets[index].tile_grid_size).filter(|own| *own > 0);
                if let Some(own) = own.filter(|own| *own > Tileset::MAX_SIDE) {
                    return Err(of_layer(format!("tiles of {own} pixels; a side has at most {}", Tileset::MAX_SIDE)));
                }
                let set = Set { index, side: own.unwrap_or(side.into()) };
                read.extend(tiles::read(layer, set, (definition, MAX_CELLS), &mut palette, &mut notes));
            }
            if read.len() == before {
                // Without tiles. Options can name it all the same.
                let none = Content::Tiles(Tiles { tile: side, ..Tiles::default() });
                read.push(Layer::plain(&layer.name, (layer.x.into(), layer.y.into()), none));
            }
            show(&mut read[before..], layer, definition);
        }
        let drawn = read.iter().filter_map(Layer::tiles).filter(|tiles| !tiles.cells.is_empty());
        let sides = drawn.map(|tiles| tiles.tile);
        let tile = tile.or_else(|| sides.min()).unwrap_or(16);
        let plane = (world.unwrap_or(0), level.world_depth);
        let place = Place { x: level.world_x, y: level.world_y, width: level.px_wid, height: level.px_hei, plane };
        Ok(Map {
            grid: (1, 1),
            project: PathBuf::new(),
            name: name.to_owned(),
            tile,
            size: (level.px_wid / u32::from(tile), level.px_hei / u32::from(tile)),
            tilesets: self.tilesets.clone(),
            palette: palette.all,
            layers: read,
            place: (world.is_some() && place.width > 0).then_some(place),
            values: true,
            properties: vec![("the level".to_owned(), fields(&level.field_instances, &mut self.ids))],
            notes,
            warnings: Vec::new(),
            gaps: Vec::new(),
        })
    }

    /// Refuses a layer that would lose its content.
    fn known(&self, layer: &raw::Layer) -> Result<()> {
        if !matches!(layer.form.as_str(), "IntGrid" | "Entities" | "Tiles" | "AutoLayer") {
            return Err(format!(
                "its type '{}' is unknown; the types are IntGrid, Entities, Tiles and AutoLayer",
                layer.form
            ));
        }
        let mut tiles = layer.tiles.iter().chain(&layer.auto).peekable();
        if layer.tileset.is_none() && tiles.peek().is_some() {
            return Err("it has tiles, and no tileset: choose one in LDtk, and save the project".to_owned());
        }
        if tiles.any(|tile| tile.t.is_none()) {
            return Err(self.too_old("its tiles have no t"));
        }
        Ok(())
    }

    fn too_old(&self, what: &str) -> String {
        let by = self.version.map_or_else(|| "an old LDtk".to_owned(), |version| format!("LDtk {version}"));
        format!("{what}: saved by {by}: open it in a newer one, and save it")
    }

    fn values(&self, layer: &raw::Layer, tile: u16, palette: &mut Palette) -> Result<Layer> {
        let (width, height) = (layer.width.0 as u32, layer.height.0 as u32);
        let count = u64::from(width) * u64::from(height);
        let mut spread = Vec::new();
        let values = match &layer.sparse {
            Some(cells) if layer.values.is_empty() => {
                spread.resize(count as usize, 0);
                for cell in cells {
                    let place = spread.get_mut(cell.coord_id).filter(|_| cell.v >= 0);
                    *place.ok_or_else(|| format!("value {} in cell {} of {count}", cell.v, cell.coord_id))? =
                        cell.v.saturating_add(1);
                }
                &spread
            }
            None if layer.values.is_empty() && count > 0 => return Err(self.too_old("it has no intGridCsv")),
            _ => &layer.values,
        };
        if values.len() as u64 != count {
            return Err(format!("{} values for {width}x{height} cells: save the project again in LDtk", values.len()));
        }
        let mut cells = Vec::with_capacity(values.len());
        let mut last = (0, 0);
        for &value in values {
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
        // Other programs write projects without definitions. LDtk always defines all of its layers.
        if definition.is_none() && !self.definitions.layers.is_empty() {
            return Err(format!("defs.layers has no uid {uid}: save the project again in LDtk"));
        }
        let mut values = definition.into_iter().flat_map(|definition| &definition.values).zip(1..);
        let named = values.find(|(named, position)| number == if named.value == 0 { *position } else { named.value });
        let group = named.filter(|(named, _)| named.group != 0).and_then(|(named, _)| {
            let groups = definition.into_iter().flat_map(|definition| &definition.groups);
            groups.into_iter().find(|group| group.uid == named.group)?.identifier.clone()
        });
        let name = named.and_then(|(named, _)| named.identifier.clone());
        let [name, group] = [name, group].map(|name| name.filter(|name| !name.is_empty()));
        let place = palette.all.len() as u32;
        palette.all.push(Placed::Value { layer: layer.name.clone(), number, name, group });
        palette.values.insert((layer.name.clone(), number), place);
        Ok(place)
    }
}

/// Whether the editor shows the layer, and whether it scrolls against others.
fn show(read: &mut [Layer], layer: &raw::Layer, definition: Option<&raw::LayerDefinition>) {
    for read in read {
        read.hidden = layer.visible == Some(false) || layer.opacity == Some(0.0);
        read.parallax = definition.is_some_and(|of| (of.parallax_x, of.parallax_y) != (0.0, 0.0));
    }
}

fn grid(layer: &raw::Layer) -> Result<u16> {
    for (name, count) in [("__cWid", &layer.width), ("__cHei", &layer.height), ("__gridSize", &layer.tile)] {
        if let Some(other) = &count.1 {
            return Err(format!("{name} is {other}, not a count"));
        }
    }
    Map::tile_of(layer.tile.0)
}
