//! The tiles that a level is drawn with.

use std::collections::HashMap;
use std::path::PathBuf;

use super::object::Object;
use super::property::Properties;

/// Tiles of one picture, or with a picture each.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tileset {
    pub name: String,
    /// Size of a tile, in pixels.
    pub size: (u32, u32),
    /// Tiles per row of the picture.
    pub columns: u32,
    /// Ids are below this. `None` if the file does not say.
    pub count: Option<u32>,
    /// The margin around the tiles of the picture, and the spacing between them.
    pub margin: u32,
    pub spacing: u32,
    /// The drawing offset of the tiles.
    pub offset: (i32, i32),
    /// For tiles as objects, see [`Stamp`](super::object::Stamp).
    pub align: (u32, u32),
    /// Whether tiles are drawn as large as a cell, whatever their size.
    pub fits_grid: bool,
    /// Whether a picture that is drawn at another size keeps its aspect, in the middle.
    pub keeps_aspect: bool,
    pub image: Option<PathBuf>,
    pub properties: Properties,
    /// The tiles with more data than their picture.
    pub tiles: HashMap<u32, Tile>,
    /// Why its file cannot be read, if it cannot. Then nothing is known about its tiles.
    pub missing: Option<String>,
}

/// The data of a tile.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tile {
    pub class: String,
    pub properties: Properties,
    /// Shapes from the collision editor.
    pub shapes: Vec<Object>,
    /// Its own picture, and the part of it that is the tile.
    pub image: Option<(PathBuf, Part)>,
}

/// A rectangle of a picture, in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Part {
    pub at: (u32, u32),
    pub size: (u32, u32),
}

impl Tileset {
    /// The longest side of a tile, in pixels. Images are smaller.
    pub(crate) const MAX_SIDE: u32 = 1 << 16;

    /// Whether the tileset has this tile.
    pub fn has(&self, id: u32) -> bool {
        self.tiles.contains_key(&id) || !self.is_collection() && self.count.is_none_or(|count| id < count)
    }

    /// Whether each tile has its own picture. Then ids can have gaps.
    fn is_collection(&self) -> bool {
        self.image.is_none() && self.tiles.values().any(|tile| tile.image.is_some())
    }

    /// The size of a tile in pixels. 0 if nobody knows it: Tiled draws such a tile as large as a
    /// cell.
    pub fn size_of(&self, id: u32) -> (u32, u32) {
        let own = self.tiles.get(&id).and_then(|tile| tile.image.as_ref());
        match own {
            Some((_, part)) => part.size,
            None if !self.has(id) && self.is_collection() => (0, 0),
            None => self.size,
        }
    }
}
