//! A level in the forms that the library reads.

use tilesat::{AllShapes, Fx, Grid, SegmentMap, TileKinds, TileMap, TileShape};

use super::level::Level;
use super::segments::Shapes;
use crate::fail::{Fail, Result};
use crate::rules::ground::Ground;

/// A baked level: tiles, objects, or both.
#[derive(Debug, Clone)]
pub struct Baked {
    /// The parts of the level, without its cells.
    pub ground: Ground,
    /// The solid tile layer, with the flags of all layers.
    pub tiles: Option<Level>,
    /// The meaning of its ids.
    pub kinds: TileKinds,
    /// The objects, their bytes, and the side of a cell.
    pub objects: Option<(Shapes, Vec<u8>, Fx)>,
    /// The name of each flag bit, bit 0 first.
    pub flags: Vec<String>,
}

impl Baked {
    /// Whether anything of it is solid or one-way.
    pub(crate) fn is_solid(&self) -> bool {
        let shape = |id: &u8| self.kinds.get(*id).shape;
        let tiles = self.tiles.as_ref().map_or(&[][..], |level| level.tiles.as_slice());
        self.objects.is_some() || tiles.iter().any(|id| shape(id) != TileShape::Empty)
    }

    /// The tiles as the library's map, and their grid.
    ///
    /// # Errors
    ///
    /// If the layer is too large for the library.
    pub fn map(&self) -> Result<Option<(TileMap<'_, AllShapes>, Grid)>> {
        let Some(level) = &self.tiles else { return Ok(None) };
        let map = level.grid().and_then(|grid| Ok((TileMap::<AllShapes>::of(&level.tiles, grid, &self.kinds)?, grid)));
        map.map(Some).map_err(|e| Fail::new(format!("layer '{}': {e}", level.layer)))
    }

    /// The objects as the library's map.
    ///
    /// # Errors
    ///
    /// If the library refuses the bytes. [`bake`](super::bake) has checked that it accepts them.
    pub fn segments(&self) -> Result<Option<SegmentMap<'_>>> {
        let Some((_, bytes, _)) = &self.objects else { return Ok(None) };
        SegmentMap::from_bytes(bytes).map(Some).map_err(|e| Fail::new(format!("the objects: {e}")))
    }
}
