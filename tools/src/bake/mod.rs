//! Turns a level as it was drawn into what a firmware includes, and says what it costs there.

mod baked;
pub(crate) mod items;
pub mod level;
mod picture;
mod report;
pub mod segments;
mod source;
mod view;

pub use baked::Baked;

use crate::fail::{Fail, Result};
use crate::read::drawing::Drawing;
use level::Level;
use segments::Shapes;
use tilesat::{Fx, TileKinds};

/// What a drawing does not say.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Settings {
    /// The tile layer that is solid; the one with most solid tiles where none is named.
    pub layer: Option<String>,
    /// Side of the cells that objects are sorted into; that of a tile where it is not said.
    pub cell: Option<Fx>,
}

/// Bakes the tiles and the objects of a drawing.
///
/// # Errors
///
/// There is nothing solid, or one line that names the layer or object that the library does not take, and says why.
pub fn bake(drawing: &Drawing, settings: &Settings) -> Result<Baked> {
    let tiles = Level::of_drawing(drawing, settings.layer.as_deref())?;
    let mut flags = tiles.as_ref().map_or_else(Vec::new, |level| level.flags.clone());
    let mut objects = None;
    if !drawing.outlines.is_empty() {
        let cell = settings.cell.unwrap_or(Fx::from_num(drawing.tiles.tile));
        let shapes = Shapes::of(&drawing.outlines, &mut flags)?;
        let bytes = shapes.build(&drawing.outlines, cell)?;
        objects = Some((shapes, bytes, cell));
    }
    if tiles.is_none() && objects.is_none() {
        return Err(Fail::new("there is nothing solid: no tile, no object"));
    }
    let kinds = tiles.as_ref().map_or(TileKinds::EMPTY, Level::kinds);
    Ok(Baked { tiles, kinds, objects, flags })
}
