//! A user's options for a project whose names do not suffice.

use tilesat::TileShape;

use super::words::same;
use crate::fail::Result;

/// Names of tiles are classes, true properties, `PROPERTY:VALUE`, values of an `IntGrid` (`NAME`,
/// `2`, `LAYER:2`) and `TILESET:ID`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Options {
    /// The shape of tiles of a name. The later of two for one tile counts.
    pub shapes: Vec<(String, TileShape)>,
    /// Names that are only flags. If there are more than eight flags, these stay.
    pub flags: Vec<String>,
    /// Layers in which every drawn tile is full.
    pub solid_layers: Vec<String>,
    /// Layers in which every drawn tile is one-way from above.
    pub one_way_layers: Vec<String>,
    /// Layers to skip.
    pub ignored_layers: Vec<String>,
    /// Layers that no guess makes solid.
    pub unguessed_layers: Vec<String>,
    /// Layers whose objects are solid.
    pub objects: Vec<String>,
    /// Levels of a project to skip.
    pub ignored_levels: Vec<String>,
    /// The only tile layer with solids.
    pub layer: Option<String>,
    /// A fraction that multiplies all lengths.
    pub scale: Option<(u32, u32)>,
    /// How far a corner of a tile's polygon may move to meet its tile's border or a neighbour's
    /// corner, in raw units. See [`weld`](Self::weld).
    pub weld: Option<i64>,
    /// The level is cut into rooms: it can have any size, and its first cell is at the origin.
    pub rooms: bool,
    /// The level is one of several: it can have nothing solid, as a menu has.
    pub bare: bool,
}

impl Options {
    /// Adds another user's options, which take precedence.
    #[must_use]
    pub fn then(mut self, other: Self) -> Self {
        self.shapes.extend(other.shapes);
        self.flags.extend(other.flags);
        self.solid_layers.extend(other.solid_layers);
        self.one_way_layers.extend(other.one_way_layers);
        self.ignored_layers.extend(other.ignored_layers);
        self.unguessed_layers.extend(other.unguessed_layers);
        self.objects.extend(other.objects);
        self.ignored_levels.extend(other.ignored_levels);
        self.layer = other.layer.or(self.layer);
        self.scale = other.scale.or(self.scale);
        self.weld = other.weld.or(self.weld);
        self.rooms |= other.rooms;
        self.bare |= other.bare;
        self
    }

    /// The tolerance of welding, in raw units: a quarter of a pixel by default.
    pub fn weld(&self) -> i64 {
        self.weld.unwrap_or(1 << 14)
    }

    /// The shape for one of these names, and that name as the user wrote it.
    pub(super) fn shape(&self, names: &[String]) -> Option<(&str, TileShape)> {
        let given = self.shapes.iter().rev().find(|(name, _)| names.iter().any(|own| same(own, name)));
        given.map(|(name, shape)| (name.as_str(), *shape))
    }

    /// Whether the user names it, as a flag or with a shape.
    pub(super) fn names(&self, name: &str) -> bool {
        self.is_flag(name) || self.shape(&[name.to_owned()]).is_some()
    }

    pub(super) fn is_flag(&self, name: &str) -> bool {
        listed(&self.flags, name)
    }
}

/// The levels of a file. One of several can have nothing solid, but not all of them: then the first
/// one with a drawing is refused with its reason, as a single level is.
pub(crate) fn together<T>(
    levels: usize,
    options: &Options,
    all: impl Fn(&Options) -> Result<T>,
    is_solid: impl Fn(&T) -> bool,
) -> Result<T> {
    let lenient = Options { bare: options.bare || levels > 1, ..options.clone() };
    let made = all(&lenient)?;
    if options.bare || is_solid(&made) { Ok(made) } else { all(options) }
}

/// Whether a list contains this name.
pub(crate) fn listed(list: &[String], name: &str) -> bool {
    list.iter().any(|listed| same(listed, name))
}
