//! The tilesets of a map, and the meaning of a number in a layer.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::objects::{LOCATE, Templates, alignment, is_flat, is_mirrored, of_tile, shape, with_rest};
use super::project::Classes;
use super::{foreign, raw, tags};
use crate::model::decimal::Decimal;
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
    /// The size of a cell.
    cell: (u32, u32),
    pub(super) classes: Rc<Classes>,
    /// Whether the palette has a tile that its tileset does not have.
    pub(super) beyond: bool,
    pub(super) warnings: Vec<Warning>,
}

/// Whose it is, and what.
type Warning = (String, String);

impl Sets {
    /// For a map with cells of this size, and a project with these classes.
    pub(super) fn new(cell: (u32, u32), classes: Rc<Classes>) -> Self {
        let (palette, places) = (vec![Placed::Nothing], HashMap::from([(0, 0)]));
        Self { places, palette, cell, classes, ..Self::default() }
    }

    /// A tileset of a file in this folder, which may refer to a separate file.
    pub(super) fn add(&mut self, set: raw::Tileset, folder: &Path, files: &mut Files) -> Result<()> {
        let first = set.firstgid;
        if first == 0 {
            let name = set.source.as_deref().unwrap_or(&set.name);
            return Err(format!(
                "tileset '{name}' has no firstgid, or 0: give it the number of its first tile in the layers; that of the \
                 first tileset is 1"
            ));
        }
        let index = self.index(set, folder, files)?;
        // As in Tiled, which then writes other numbers.
        if let Some(other) = self.first.insert(first, index) {
            let names = (&self.all[other].name, &self.all[index].name);
            self.warnings.push((
                format!("tileset '{}'", names.0),
                format!(
                    "it begins at tile {first}, as tileset '{}' after it, which has these tiles, as in Tiled; save the map \
                     again in Tiled",
                    names.1
                ),
            ));
        }
        Ok(())
    }

    /// The tileset's number. A tileset file is read only once.
    pub(super) fn index(&mut self, set: raw::Tileset, folder: &Path, files: &mut Files) -> Result<usize> {
        let Some(source) = &set.source else { return self.push(set, folder, files) };
        let path = files.named(folder, source);
        if let Some(&index) = self.known.get(&path) {
            return Ok(index);
        }
        let of_file = |why: String| format!("tileset {}: {why}", path.display());
        let bytes = match files.utf8_or(&path, LOCATE) {
            Err(why) if !path.exists() => {
                let name =
                    Path::new(&source.replace('\\', "/")).file_stem().unwrap_or_default().to_string_lossy().into();
                let missing = Some(of_file(why));
                let set = Tileset { name, size: self.cell, columns: 1, align: (0, 2), missing, ..Tileset::default() };
                self.all.push(Rc::new(set));
                self.known.insert(path, self.all.len() - 1);
                return Ok(self.all.len() - 1);
            }
            read => read.map_err(of_file)?,
        };
        let read = if json::is_json(&bytes) { json::parse(&bytes) } else { tags::tileset_file(&bytes) };
        let read = read.map_err(|why| {
            of_file(foreign::mark(&bytes).unwrap_or_else(|| format!("not a tileset of Tiled: {why}")))
        })?;
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
        let set = self.tileset(set, folder, files)?;
        self.all.push(Rc::new(set));
        Ok(self.all.len() - 1)
    }

    /// An object of a layer of a map in this folder, with what its template, its tile and its class
    /// give it. Also the reason that it has nothing of its template.
    pub(super) fn object(
        &mut self,
        object: raw::Object,
        (folder, layer): (&Path, &str),
        files: &mut Files,
    ) -> Result<(Object, Option<String>)> {
        let (id, own) = (object.id, object.gid);
        let template = object.template.as_ref().map(|name| files.named(folder, name));
        let (object, gap) = self.templates.filled(object, folder, files)?;
        if is_mirrored(&object) {
            let what = "its size is negative, so its box is on the other side of its point, as in Tiled".to_owned();
            self.warnings.push((format!("object {id} of layer '{layer}'"), what));
        }
        let found = match (own.or(object.gid), template) {
            (None, _) => Ok(None),
            // The numbers of a template are those of its own tileset.
            (Some(gid), Some(path)) if own.is_none() => self.tile_of_template(gid, &path, files),
            (Some(gid), _) => self.tile(gid),
        };
        let mut object = match found.map_err(|why| format!("object {id}: {why}"))? {
            Some(found) => {
                let set = &self.all[found.0];
                if !set.has(found.1) {
                    let what =
                        format!("its tile {} is not in tileset '{}': only its own values count", found.1, set.name);
                    self.warnings.push((format!("object {id} of layer '{layer}'"), what));
                }
                of_tile(object, set, found)
            }
            None => shape(object),
        }?;
        object.properties = with_rest(object.properties, self.classes.of(&object.class, "object"));
        Ok((object, gap))
    }

    fn tile_of_template(&mut self, gid: u32, path: &Path, files: &mut Files) -> Result<Option<(usize, u32, Flip)>> {
        if let Some(set) = self.templates.take_set(path) {
            let first = set.firstgid;
            let index = self.index(set, path.parent().unwrap_or(Path::new("")), files)?;
            self.of_templates.insert(path.to_owned(), (first, index));
        }
        self.of_templates.get(path).map_or(Ok(None), |&known| Self::tile_of(gid, Some(known)))
    }

    /// The palette index for a number in a layer.
    pub(super) fn place(&mut self, gid: u32) -> Result<u32> {
        if let Some(&place) = self.places.get(&gid) {
            return Ok(place);
        }
        let tile = self.tile(gid)?;
        if let Some((tileset, id, flip)) = tile {
            self.turned(&self.all[tileset], id, flip)?;
        }
        self.beyond |= tile.is_some_and(|(tileset, id, _)| !self.all[tileset].has(id));
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

    /// Refuses a turned tile that is drawn as large as a cell that is not square. Its position is
    /// not documented.
    fn turned(&self, set: &Tileset, id: u32, flip: Flip) -> Result<()> {
        let (size, (width, height)) = (set.size_of(id), self.cell);
        if !flip.diagonal || !set.fits_grid || width == height || size == self.cell || size.0 == 0 || size.1 == 0 {
            return Ok(());
        }
        Err(format!(
            "tile {id} of tileset '{}' is turned, and drawn as large as a cell, and cells are not square: in Tiled, \
             under Tileset > Tileset Properties, set Tile Render Size to Tile Size",
            set.name
        ))
    }

    /// The tileset, its tile and the flips. `None` for no tile.
    fn tile(&self, gid: u32) -> Result<Option<(usize, u32, Flip)>> {
        let known = self.first.range(..=gid & !FLIPS).next_back();
        Self::tile_of(gid, known.map(|(&first, &index)| (first, index)))
    }

    /// The same in a tileset with this first number.
    fn tile_of(gid: u32, known: Option<(u32, usize)>) -> Result<Option<(usize, u32, Flip)>> {
        let flip =
            Flip { diagonal: gid & DIAGONAL != 0, horizontal: gid & HORIZONTAL != 0, vertical: gid & VERTICAL != 0 };
        let gid = gid & !FLIPS;
        if gid == 0 {
            return Ok(None);
        }
        let Some((first, index)) = known.filter(|(first, _)| *first <= gid) else {
            return Err(format!("tile {gid} belongs to no tileset: erase it, or add its tileset to the map"));
        };
        // Tiled keeps tiles that a tileset no longer has.
        Ok(Some((index, gid - first, flip)))
    }

    fn tileset(&mut self, set: raw::Tileset, folder: &Path, files: &mut Files) -> Result<Tileset> {
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
            let group = tile.objectgroup.map(|group| *group).unwrap_or_default();
            if [group.offsetx, group.offsety].iter().any(|by| by.0 != Decimal::ZERO) {
                let what =
                    format!("the layer of the collision shapes of tile {} has an offset: Tiled ignores it", tile.id);
                self.warnings.push((format!("tileset '{name}'"), what));
            }
            let shapes = group.objects;
            let shapes = shapes
                .into_iter()
                .map(|drawn| self.shape(drawn, (tile.id, &name), folder, files).map_err(&of_set))
                .collect::<Result<_>>()?;
            let image = path(tile.image).map(|image| (image, part));
            let class = if tile.kind.is_empty() { tile.class } else { tile.kind };
            let properties = with_rest(tile.properties.0, self.classes.of(&class, "tile"));
            tiles.insert(tile.id, Tile { class, properties, shapes, image });
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
            properties: set.properties.0.with_class(&set.class),
            tiles,
            missing: None,
        })
    }

    /// A shape of the collision editor, of this tile of a tileset.
    fn shape(
        &mut self,
        drawn: raw::Object,
        (tile, set): (u32, &str),
        folder: &Path,
        files: &mut Files,
    ) -> Result<Object> {
        let (drawn, gap) = self.templates.filled(drawn, folder, files)?;
        if let Some(why) = gap {
            return Err(format!("tile {tile}: {why}"));
        }
        let corners = drawn.polygon.as_ref().map_or(3, Vec::len);
        let flat = corners < 3 || is_flat(&drawn) && drawn.class.as_ref().is_none_or(String::is_empty);
        if flat || is_mirrored(&drawn) {
            let what = match corners {
                0..3 => {
                    format!("the collision polygon of tile {tile} has {corners} corners: it needs 3, and is not solid")
                }
                _ if flat => format!("a collision shape of tile {tile} has no width or no height: it is not solid"),
                _ => format!(
                    "the size of a collision shape of tile {tile} is negative: its box is on the other side of its point"
                ),
            };
            self.warnings.push((format!("tileset '{set}'"), what));
        }
        shape(drawn)
    }
}
