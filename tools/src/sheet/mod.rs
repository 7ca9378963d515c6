//! Pictures of the library's answers about tiles and pairs of shapes.
//!
//! Everything comes from the library's answers. The solid comes from `overlaps` point by point,
//! lines and arrows from `features`, rays from `cast_ray`, and the way from `move_and_slide`. A
//! fault in the picture is a fault there.
#![allow(clippy::cast_precision_loss, reason = "drawing")]

mod contacts;
mod glyphs;
mod scenes;
mod shapes;

use crate::fail::Result;
use crate::picture::marks::Scene;

/// Draws the pictures. Returns the names of their files.
///
/// # Errors
///
/// If the library refuses a shape, a level, a ray or a motion. None is expected.
pub fn pictures() -> Result<[(&'static str, Scene); 4]> {
    Ok([
        ("sheet-shapes.png", shapes::sheet()?),
        ("sheet-mosaic.png", scenes::mosaic()?),
        ("sheet-level.png", scenes::level()?),
        ("sheet-contacts.png", contacts::sheet()?),
    ])
}
