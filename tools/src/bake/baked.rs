//! A level in the forms that the library reads.

use tilesat::{AllShapes, Fx, Grid, SegmentMap, TileKinds, TileMap};

use super::level::Level;
use super::report::{Owner, Report};
use super::segments::Shapes;
use super::view;
use crate::fail::{Fail, Result};
use crate::picture::marks::{Image, Scene, Spot};
use crate::rules::ground::Ground;

/// The report looks at no more cells than this: it would take too long.
const MOST_COUNTED: usize = 1 << 20;

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

    /// The cost of the level, line by line. Uses a body of these sides in raw units, or of one
    /// cell.
    ///
    /// # Errors
    ///
    /// As [`map`](Self::map).
    pub fn report(&self, body: Option<(i32, i32)>) -> Result<Vec<String>> {
        let mut lines = Vec::new();
        let body = |grid: &Grid| body.unwrap_or((grid.cell().to_bits(), grid.cell().to_bits()));
        if let (Some((map, grid)), Some(level)) = (self.map()?, &self.tiles) {
            let (width, height, side) = (level.width, level.height, level.tile);
            lines.push(format!("tiles   layer '{}': {width}x{height} of {side} px", level.layer));
            lines.push(format!("flash   {} bytes of tiles, {} of kinds", level.tiles.len(), size_of::<TileKinds>()));
            if level.tiles.len() > MOST_COUNTED {
                lines.push(format!("cells   not counted: more than {MOST_COUNTED}"));
            } else {
                let report = Report::of(&map, grid, Owner::Tile, body(&grid));
                lines.extend(report.lines(body(&grid)));
            }
        }
        if let (Some(map), Some((shapes, bytes, cell))) = (self.segments()?, &self.objects) {
            let (count, paths) = (map.count(), shapes.kinds.len());
            let (width, height) = (map.width(), map.height());
            lines.push(format!("objects {paths} in {count} segments, {width}x{height} cells of {cell} px"));
            lines.push(format!("flash   {} bytes", bytes.len()));
            let grid = map.grid();
            if usize::from(width) * usize::from(height) > MOST_COUNTED {
                lines.push(format!("cells   not counted: more than {MOST_COUNTED}"));
            } else {
                let report = Report::of(&map, grid, Owner::Square, body(&grid));
                lines.extend(report.lines(body(&grid)));
            }
        }
        let flags: Vec<String> =
            self.flags.iter().enumerate().map(|(bit, name)| format!("{name} = bit {bit}")).collect();
        if !flags.is_empty() {
            lines.push(format!("flags   {}", flags.join(", ")));
        }
        Ok(lines)
    }

    /// Draws cells, segments with their normals, and vertices over an image of the drawn level.
    /// Without an image it draws rays as well. Lines of text are below.
    ///
    /// # Errors
    ///
    /// As [`map`](Self::map).
    pub fn picture(&self, lines: &[String], drawn: &dyn Fn(&Scene, Spot) -> Option<Image>) -> Result<Scene> {
        Ok(view::scene(self.map()?, self.segments()?, lines, drawn))
    }
}
