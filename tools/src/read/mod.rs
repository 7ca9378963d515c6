//! Levels as they were drawn: each format has a reader, and all readers make the same [`Drawing`].

pub mod decimal;
pub mod drawing;
mod file;
mod ldtk;
pub mod outline;
pub mod tmx;

use std::path::Path;

use crate::fail::{Fail, Result};
use drawing::Drawing;

/// Reads a TMX or an `LDtk` file; of several `LDtk` levels the named one, or the first.
///
/// # Errors
///
/// One line that names the file and says why it cannot be read, or what in it is no level.
pub fn load(path: &Path, level: Option<&str>) -> Result<Drawing> {
    let of_file = |why: String| Fail::new(format!("{}: {why}", path.display()));
    let bytes = file::bytes(path).map_err(|e| of_file(file::why(&e)))?;
    if bytes.trim_ascii_start().starts_with(b"{") {
        let folder = path.parent().unwrap_or(Path::new(""));
        let tiles = ldtk::read(&bytes, level, folder).map_err(of_file)?;
        return Ok(Drawing { tiles, outlines: Vec::new(), left_out: Vec::new() });
    }
    if level.is_some() {
        return Err(of_file("a Tiled map is one level; --level is for LDtk".to_owned()));
    }
    let tiles = tmx::load(path)?;
    let (outlines, left_out) = tmx::objects(&bytes).map_err(of_file)?;
    Ok(Drawing { tiles, outlines, left_out })
}
