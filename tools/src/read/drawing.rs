//! A level as it was drawn, in the one form that all formats are read into.

use super::outline::{LeftOut, Outline};
use crate::rules::traits::Traits;

/// The library's domain in pixels: every coordinate stays below 2^29 raw (contract C1).
pub(crate) const DOMAIN: u64 = 8192;

/// All that is read of a level file.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// The tiles.
    pub tiles: TileLayers,
    /// Polygons and chains out of object layers, in drawing order.
    pub outlines: Vec<Outline>,
    /// Objects that are none.
    pub left_out: Vec<LeftOut>,
}

/// The tile layers of a level.
#[derive(Debug, Clone)]
pub struct TileLayers {
    /// Side of a tile in pixels.
    pub tile: u16,
    /// In drawing order, the lowest first; groups are flattened.
    pub layers: Vec<TileLayer>,
    /// What the numbers in the layers mean; 0 is no tile.
    pub palette: Vec<Traits>,
}

/// One of them.
#[derive(Debug, Clone)]
pub struct TileLayer {
    pub name: String,
    pub width: u16,
    pub height: u16,
    /// Row by row, as places in the palette: each tile and each way it is flipped has its own.
    pub cells: Vec<u32>,
}

impl TileLayers {
    /// What a cell's number means.
    pub fn traits(&self, cell: u32) -> &Traits {
        &self.palette[cell as usize]
    }
}
