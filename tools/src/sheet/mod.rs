//! Pictures of what the library says about tiles.
//!
//! Everything is drawn from what the library answers: the solid from `overlaps` point by point,
//! lines and arrows from `features`, rays from `cast_ray`, the way from `move_and_slide`. What
//! looks wrong here is wrong there.
#![allow(clippy::cast_precision_loss, reason = "drawing")]

mod glyphs;
mod scenes;
mod shapes;

use crate::fail::Result;
use crate::picture::marks::Scene;

/// The pictures, and the names of their files.
///
/// # Errors
///
/// The library refuses a shape, a level, a ray or a motion; none is expected.
pub fn pictures() -> Result<[(&'static str, Scene); 3]> {
    Ok([
        ("sheet-shapes.png", shapes::sheet()?),
        ("sheet-mosaic.png", scenes::mosaic()?),
        ("sheet-level.png", scenes::level()?),
    ])
}
