//! Converts tile layers to one byte per tile.

use tilesat::world::ShapeSet;
use tilesat::{
    Aabb, AllShapes, Blocks, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileMapError, Vec2, world::Feature,
};

use crate::fail::{Fail, Result};
use crate::rules::ground::Ground;

/// A level as the library reads it, and the names that the user gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Level {
    /// The layers that are solid.
    pub layer: String,
    pub width: u16,
    pub height: u16,
    /// Side of a tile in pixels.
    pub tile: u16,
    /// The first corner of the tiles, in raw units.
    pub origin: (i32, i32),
    /// One id per tile, row by row.
    pub tiles: Vec<u8>,
    /// The meaning of each id; id 0 is empty.
    pub ids: Vec<TileKind>,
    /// The name of each flag bit, bit 0 first.
    pub flags: Vec<String>,
}

/// The table of one or more levels, while it grows.
#[derive(Debug, Clone)]
pub struct Ids {
    kinds: Vec<TileKind>,
    /// The id of each combination of shape and flags.
    known: Vec<Option<u8>>,
}

impl Default for Ids {
    fn default() -> Self {
        let mut ids = Self { kinds: Vec::new(), known: vec![None; 1 << 14] };
        // The table is empty, so this is id 0.
        let _ = ids.id(TileKind::EMPTY);
        ids
    }
}

impl Ids {
    fn id(&mut self, kind: TileKind) -> Result<u8> {
        let slot = &mut self.known[usize::from(kind.shape as u8) << 8 | usize::from(kind.flags)];
        if let Some(id) = *slot {
            return Ok(id);
        }
        let full = "more than 256 combinations of shape and flags; --empty NAME and --flag NAME make fewer";
        let id = u8::try_from(self.kinds.len()).map_err(|_| Fail::new(full))?;
        *slot = Some(id);
        self.kinds.push(kind);
        Ok(id)
    }

    /// The meaning of each id.
    pub fn kinds(&self) -> &[TileKind] {
        &self.kinds
    }
}

impl Level {
    /// The tiles of a single level. `None` if no tile has a meaning: objects may be the solid.
    ///
    /// # Errors
    ///
    /// If there are more than 256 combinations of shape and flags.
    pub fn of(ground: &Ground, flags: &[String]) -> Result<Option<Self>> {
        Self::with(ground, flags, &mut Ids::default())
    }

    /// The tiles of one level of several, with the shared table.
    ///
    /// # Errors
    ///
    /// The same as [`of`](Self::of).
    pub fn with(ground: &Ground, flags: &[String], ids: &mut Ids) -> Result<Option<Self>> {
        if ground.cells.is_empty() {
            return Ok(None);
        }
        let tiles = ground.cells.iter().map(|&kind| ids.id(kind)).collect::<Result<_>>()?;
        Ok(Some(Self {
            layer: ground.layer.clone(),
            width: ground.width,
            height: ground.height,
            tile: ground.tile,
            origin: ground.origin,
            tiles,
            ids: ids.kinds.clone(),
            flags: flags.to_vec(),
        }))
    }

    /// The grid of the cells.
    ///
    /// # Errors
    ///
    /// If the level is too large for the library.
    pub fn grid(&self) -> std::result::Result<Grid, TileMapError> {
        let origin = Vec2::from_raw(self.origin.0, self.origin.1);
        Grid::new(self.width, self.height, Fx::from_num(self.tile), origin)
    }

    /// The table in which the library looks up the kind of each id.
    pub fn kinds(&self) -> TileKinds {
        let mut kinds = TileKinds::EMPTY;
        for (id, &kind) in self.ids.iter().enumerate() {
            kinds = kinds.with(id as u8, kind);
        }
        kinds
    }

    /// Whether the level needs only blocks. Then it links less code.
    pub fn is_blocks(&self) -> bool {
        self.ids.iter().all(|kind| Blocks::SHAPES >> kind.shape as u8 & 1 != 0)
    }

    /// The surface as the library derives it: the pieces of the level's own cells in a closed room.
    pub fn features(&self) -> Vec<Feature> {
        let kinds = self.kinds();
        let grid = self.grid();
        let map = grid.and_then(|grid| TileMap::<AllShapes>::of(&self.tiles, grid, &kinds));
        let region = grid.ok().and_then(|grid| Aabb::new(grid.origin(), grid.end()).ok());
        let (Ok(map), Some(region)) = (map, region) else { return Vec::new() };
        let map = map.with_outside(Outside::Solid);
        map.features(&region).filter(|feature| map.tile(feature.cell).is_some()).collect()
    }

    /// The bit of a flag, or 0 if no tile has it.
    pub fn mask(&self, name: &str) -> u8 {
        self.flags.iter().position(|f| f.eq_ignore_ascii_case(name)).map_or(0, |bit| 1 << bit)
    }

    /// The content of a cell.
    pub fn kind(&self, x: u16, y: u16) -> TileKind {
        let id = self.tiles[usize::from(y) * usize::from(self.width) + usize::from(x)];
        self.ids[usize::from(id)]
    }
}
