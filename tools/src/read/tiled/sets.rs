//! The tilesets of a map, and the meaning of a number in a layer.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::objects::{Templates, alignment, of_tile, shape};
use super::{raw, tags};
use crate::model::flip::Flip;
use crate::model::map::Placed;
use crate::model::object::{Object, Spot};
use crate::model::tileset::{Tile, Tileset};
use crate::read::file::Files;
use crate::read::json;

type Result<T> = std::result::Result<T, String>;

/// The most tilesets of a map.
const MAX_SETS: usize = 1000;
/// The greatest id of a tile, and the most described tiles in all tilesets of a map.
const MAX_TILES: u32 = 1 << 20;

const HORIZONTAL: u32 = 1 << 31;
const VERTICAL: u32 = 1 << 30;
const DIAGONAL: u32 = 1 << 29;
/// Hexagonal maps turn tiles with this bit.
const FLIPS: u32 = HORIZONTAL | VERTICAL | DIAGONAL | 1 << 28;

/// The tilesets, and the numbers so far.
#[derive(Debug, Default)]
pub(super) struct Sets {
    pub(super) all: Vec<Rc<Tileset>>,
    /// The first number of each.
    first: BTreeMap<u32, usize>,
    known: HashMap<PathBuf, usize>,
    places: HashMap<u32, u32>,
    pub(super) palette: Vec<Placed>,
    templates: Templates,
    /// The first number and the tileset of each template that has one.
    of_templates: HashMap<PathBuf, (u32, usize)>,
    tiles: usize,
}

impl Sets {
    pub(super) fn new() -> Self {
        Self { palette: vec![Placed::Nothing], places: HashMap::from([(0, 0)]), ..Self::default() }
    }

    /// A tileset of a file in this folder, which may refer to a separate file.
    pub(super) fn add(&mut self, set: raw::Tileset, folder: &Path, files: &mut Files) -> Result<()> {
        let first = set.firstgid;
        if first == 0 {
            return Err(format!("tileset '{}' has no firstgid", set.source.as_deref().unwrap_or(&set.name)));
        }
        let index = self.index(set, folder, files)?;
        match self.first.insert(first, index) {
            None => Ok(()),
            Some(_) => Err(format!("two tilesets begin at tile {first}: save the map again in Tiled")),
        }
    }

    /// The tileset's number. A tileset file is read only once.
    pub(super) fn index(&mut self, set: raw::Tileset, folder: &Path, files: &mut Files) -> Result<usize> {
        let Some(source) = &set.source else { return self.push(set, folder, files) };
        let path = folder.join(source);
        if let Some(&index) = self.known.get(&path) {
            return Ok(index);
        }
        let of_file = |why: String| format!("tileset {}: {why}", path.display());
        let bytes = files.bytes(&path).map_err(of_file)?;
        let read = if json::is_json(&bytes) { json::parse(&bytes) } else { tags::tileset_file(&bytes) };
        let read = read.map_err(|why| of_file(format!("not a tileset of Tiled: {why}")))?;
        let index = self.push(read, path.parent().unwrap_or(folder), files).map_err(of_file)?;
        self.known.insert(path, index);
        Ok(index)
    }

    fn push(&mut self, set: raw::Tileset, folder: &Path, files: &mut Files) -> Result<usize> {
        if self.all.len() == MAX_SETS {
            return Err(format!("more than {MAX_SETS} tilesets: join some in Tiled"));
        }
        self.tiles = self.tiles.saturating_add(set.tiles.0.len());
        if self.tiles > MAX_TILES as usize {
            return Err(format!("tilesets that describe more than {MAX_TILES} tiles: remove tiles, or whole tilesets"));
        }
        let set = tileset(set, folder, &mut self.templates, files)?;
        self.all.push(Rc::new(set));
        Ok(self.all.len() - 1)
    }

    /// An object of a map in this folder, with what its template and its tile give it.
    pub(super) fn object(&mut self, object: raw::Object, folder: &Path, files: &mut Files) -> Result<Object> {
        let (id, own) = (object.id, object.gid);
        let template = object.template.as_ref().map(|name| folder.join(name));
        let object = self.templates.filled(object, folder, files)?;
        let found = match (own.or(object.gid), template) {
            (None, _) => Ok(None),
            // The numbers of a template are those of its own tileset.
            (Some(gid), Some(path)) if own.is_none() => self.tile_of_template(gid, &path, files),
            (Some(gid), _) => self.tile(gid),
        };
        match found.map_err(|why| format!("object {id}: {why}"))? {
            Some(found) => of_tile(object, &self.all[found.0], found),
            None => shape(object),
        }
    }

    fn tile_of_template(&mut self, gid: u32, path: &Path, files: &mut Files) -> Result<Option<(usize, u32, Flip)>> {
        if let Some(set) = self.templates.take_set(path) {
            let first = set.firstgid;
            let index = self.index(set, path.parent().unwrap_or(Path::new("")), files)?;
            self.of_templates.insert(path.to_owned(), (first, index));
        }
        self.of_templates.get(path).map_or(Ok(None), |&known| self.tile_of(gid, Some(known)))
    }

    /// The palette index for a number in a layer.
    pub(super) fn place(&mut self, gid: u32) -> Result<u32> {
        if let Some(&place) = self.places.get(&gid) {
            return Ok(place);
        }
        let tile = self.tile(gid)?;
        let place = self.palette.len() as u32;
        self.palette.push(tile.map_or(Placed::Nothing, |(tileset, id, flip)| Placed::Tile {
            tileset,
            id,
            flip,
            moved: Spot::default(),
        }));
        self.places.insert(gid, place);
        Ok(place)
    }

    /// The tileset, its tile and the flips. `None` for no tile.
    fn tile(&self, gid: u32) -> Result<Option<(usize, u32, Flip)>> {
        let known = self.first.range(..=gid & !FLIPS).next_back();
        self.tile_of(gid, known.map(|(&first, &index)| (first, index)))
    }

    /// The same in a tileset with this first number.
    fn tile_of(&self, gid: u32, known: Option<(u32, usize)>) -> Result<Option<(usize, u32, Flip)>> {
        let flip =
            Flip { diagonal: gid & DIAGONAL != 0, horizontal: gid & HORIZONTAL != 0, vertical: gid & VERTICAL != 0 };
        let gid = gid & !FLIPS;
        if gid == 0 {
            return Ok(None);
        }
        let Some((first, index)) = known.filter(|(first, _)| *first <= gid) else {
            return Err(format!("tile {gid} belongs to no tileset: erase it, or add its tileset to the map"));
        };
        let (set, id) = (&self.all[index], gid - first);
        if set.has(id) {
            Ok(Some((index, id, flip)))
        } else {
            let count = set.count.unwrap_or(0);
            let name = &set.name;
            Err(format!(
                "tile {gid} belongs to no tileset: it would be tile {id} of '{name}', which has {count} tiles; erase it, or add tiles"
            ))
        }
    }
}

fn tileset(set: raw::Tileset, folder: &Path, templates: &mut Templates, files: &mut Files) -> Result<Tileset> {
    let name = set.name.clone();
    let of_set = |why: String| format!("tileset '{name}': {why}");
    if set.tilecount.is_some_and(|count| count > MAX_TILES) {
        return Err(of_set(format!("more than {MAX_TILES} tiles")));
    }
    let fits = |width: u32, height: u32| match width.max(height) {
        0..=Tileset::MAX_SIDE => Ok(()),
        _ => Err(of_set(format!("tiles of {width}x{height} pixels; a side has at most {}", Tileset::MAX_SIDE))),
    };
    fits(set.tilewidth, set.tileheight)?;
    let path = |image: Option<String>| image.filter(|image| !image.is_empty()).map(|image| folder.join(image));
    let along = |length: u32, tile: u32| {
        let step = u64::from(tile) + u64::from(set.spacing);
        // As Tiled counts: the margin is only before the first tile.
        let room = (u64::from(length) + u64::from(set.spacing)).saturating_sub(u64::from(set.margin));
        room.checked_div(step).unwrap_or(0) as u32
    };
    let columns = if set.columns > 0 { set.columns } else { along(set.imagewidth, set.tilewidth) };
    // Old files do not have the number of tiles.
    let counted = u64::from(columns) * u64::from(along(set.imageheight, set.tileheight));
    let count = set.tilecount.or(u32::try_from(counted).ok().filter(|&count| count > 0));
    let mut tiles = HashMap::new();
    for tile in set.tiles.0 {
        let part = tile.part();
        fits(part.size.0, part.size.1)?;
        let shapes = tile.objectgroup.map_or_else(Vec::new, |group| group.objects);
        let shapes = shapes
            .into_iter()
            .map(|drawn| templates.filled(drawn, folder, files).and_then(shape).map_err(&of_set))
            .collect::<Result<_>>()?;
        let image = path(tile.image).map(|image| (image, part));
        let class = if tile.kind.is_empty() { tile.class } else { tile.kind };
        tiles.insert(tile.id, Tile { class, properties: tile.properties.0, shapes, image });
    }
    for (id, properties) in set.tileproperties {
        tiles.entry(id).or_default().properties.0.extend(properties.0.0);
    }
    Ok(Tileset {
        name: set.name,
        size: (set.tilewidth, set.tileheight),
        columns: columns.max(1),
        count,
        margin: set.margin,
        spacing: set.spacing,
        offset: (set.tileoffset.x, set.tileoffset.y),
        align: alignment(&set.objectalignment).map_err(&of_set)?,
        fits_grid: set.tilerendersize == "grid",
        keeps_aspect: match set.fillmode.as_str() {
            "" | "stretch" => false,
            "preserve-aspect-fit" => true,
            other => return Err(of_set(format!("fillmode '{other}' is unknown"))),
        },
        image: path(set.image),
        properties: set.properties.0,
        tiles,
    })
}
