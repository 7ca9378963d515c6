//! A level: its layers, and the meaning of the numbers in them.

use std::path::PathBuf;
use std::rc::Rc;

use super::decimal::Decimal;
use super::flip::Flip;
use super::object::{Object, Spot};
use super::property::Properties;
use super::tileset::Tileset;

/// A level as drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// `LDtk`'s name of the level. For Tiled's maps, the name of the file.
    pub name: String,
    /// The file with all levels that belong together: a map, a project or a world.
    pub project: PathBuf,
    /// Side of a cell in pixels.
    pub tile: u16,
    /// How many cells a cell of the file is along x and y: cells that are not square are several.
    pub grid: (u32, u32),
    /// Columns and rows, if there are no layers.
    pub size: (u32, u32),
    pub tilesets: Vec<Rc<Tileset>>,
    /// The meaning of the numbers in the layers. 0 is empty.
    pub palette: Vec<Placed>,
    /// The lowest comes first. Groups are flattened.
    pub layers: Vec<Layer>,
    /// Its position among the levels of its world.
    pub place: Option<Place>,
    /// Whether its name and classes come from `LDtk`, which names values instead of layers.
    pub values: bool,
    /// Its own properties and those of its groups, tilesets and world, each with their owner.
    pub properties: Vec<(String, Properties)>,
    /// For the user: what was read otherwise than the file suggests.
    pub notes: Vec<String>,
    /// What was dropped or guessed: whose it is, and what.
    pub warnings: Vec<(String, String)>,
    pub gaps: Vec<Gap>,
}

/// An object that was read without its template. Whether it is solid is not known, unless its own
/// values say so.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gap {
    pub layer: String,
    pub object: u32,
    /// Why the template cannot be read.
    pub why: String,
}

impl Map {
    /// The largest side of a cell in a file, in pixels. The library's cells have at most 256, but a
    /// level can be scaled.
    pub(crate) const MAX_TILE: u16 = 1024;

    /// The side of a cell in a file.
    pub(crate) fn tile_of(pixels: u64) -> Result<u16, String> {
        let side = u16::try_from(pixels).ok().filter(|side| (1..=Self::MAX_TILE).contains(side));
        side.ok_or_else(|| format!("cells of {pixels} pixels; a file may have cells of 1 to {} pixels", Self::MAX_TILE))
    }
}

/// The content of a cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Placed {
    Nothing,
    Tile {
        tileset: usize,
        id: u32,
        flip: Flip,
        /// Its picture is moved by this from the usual corner.
        moved: Spot,
    },
    /// A value of an `IntGrid` layer.
    Value {
        layer: String,
        number: i64,
        name: Option<String>,
        /// The name of its group.
        group: Option<String>,
    },
}

/// The area of a level in its world, in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    pub x: i32,
    pub y: i32,
    pub width: u32,
    pub height: u32,
    /// The number of its world in the project, and its depth there. Levels of other planes are no
    /// neighbours.
    pub plane: (usize, i32),
}

/// A layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    pub name: String,
    pub class: String,
    pub properties: Properties,
    /// The names of the true ones.
    pub marks: Vec<String>,
    /// The groups around it, the nearest one last.
    pub groups: Vec<Rc<Group>>,
    /// The offset of the layer and of the groups around it, in pixels.
    pub offset: Spot,
    /// Whether the editor does not show it, or moves it against the other layers.
    pub hidden: bool,
    pub parallax: bool,
    pub content: Content,
}

/// A group of layers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    pub name: String,
    pub class: String,
    pub properties: Properties,
    /// The names of the true ones.
    pub marks: Vec<String>,
}

impl Group {
    fn names(&self) -> impl Iterator<Item = &str> + Clone {
        [&self.name, &self.class].into_iter().chain(&self.marks).map(String::as_str)
    }
}

/// The content of a layer.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    Tiles(Tiles),
    Objects(Vec<Object>),
    /// A picture.
    Image,
}

/// The cells of a tile layer, from the column and row `at` on.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tiles {
    /// Side of a cell in pixels. The layers of an `LDtk` level may differ.
    pub tile: u16,
    pub at: (i32, i32),
    pub width: u32,
    pub height: u32,
    /// Indices into the palette, row by row.
    pub cells: Vec<u32>,
    /// Whether the editor has drawn it from another layer. Then its name has no meaning.
    pub derived: bool,
}

impl Tiles {
    /// The cells that are not empty.
    pub fn drawn(&self) -> impl Iterator<Item = (i32, i32, u32)> + '_ {
        let rows = self.cells.chunks(self.width.max(1) as usize).zip(self.at.1..);
        rows.flat_map(|(row, y)| {
            row.iter().zip(self.at.0..).filter(|(cell, _)| **cell != 0).map(move |(&cell, x)| (x, y, cell))
        })
    }

    /// The palette entry in a column and row, unless the cell is empty or outside of the layer.
    pub(crate) fn entry(&self, (x, y): (i64, i64)) -> Option<u32> {
        let (x, y) = (x - i64::from(self.at.0), y - i64::from(self.at.1));
        let inside = (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height)).contains(&y);
        let cell = if inside { self.cells.get((y * i64::from(self.width) + x) as usize) } else { None };
        cell.copied().filter(|cell| *cell != 0)
    }
}

impl Layer {
    /// A layer of a format that knows neither classes nor groups.
    pub fn plain(name: &str, offset: (i64, i64), content: Content) -> Self {
        let offset = (Decimal::whole(offset.0), Decimal::whole(offset.1));
        let (name, class) = (name.to_owned(), String::new());
        let (properties, marks, groups) = (Properties::default(), Vec::new(), Vec::new());
        Self { name, class, properties, marks, groups, offset, hidden: false, parallax: false, content }
    }

    /// The names, classes and true properties of the groups around it.
    pub(crate) fn around(&self) -> impl Iterator<Item = &str> + Clone {
        self.groups.iter().flat_map(|group| group.names())
    }

    /// The tiles, if it has any.
    pub fn tiles(&self) -> Option<&Tiles> {
        if let Content::Tiles(tiles) = &self.content { Some(tiles) } else { None }
    }
}
