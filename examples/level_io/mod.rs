//! Reads levels of Tiled and `LDtk` for the tools that check and bake them.
//!
//! Tile layers come as [`tmx::Tmx`] from either editor; objects come as [`outline::Outline`].

#[path = "../platformer/bake.rs"]
pub mod bake;
#[path = "../platformer/fail.rs"]
pub mod fail;
#[path = "../platformer/guard.rs"]
pub mod guard;
#[path = "../platformer/level.rs"]
pub mod level;
#[path = "../platformer/names.rs"]
pub mod names;
#[allow(unused_imports, reason = "the baker of levels knows the game's rules, and that is all")]
#[path = "../platformer/sim/mod.rs"]
pub mod sim;
#[path = "../platformer/tmx.rs"]
pub mod tmx;
#[path = "../platformer/traits.rs"]
pub mod traits;
#[path = "../platformer/unpack.rs"]
pub mod unpack;
#[path = "../platformer/xml.rs"]
pub mod xml;

pub mod arguments;
pub mod decimal;
pub mod ldtk;
pub mod object;
pub mod objects;
pub mod outline;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use fail::{Fail, Result};
use level::Level;
use outline::{LeftOut, Outline};
use tmx::Tmx;

/// A level as it was drawn.
#[derive(Debug, Clone)]
pub struct Drawing {
    pub tiles: Tmx,
    pub outlines: Vec<Outline>,
    pub left_out: Vec<LeftOut>,
}

impl Drawing {
    /// The tile layer that is solid, as [`level::choose`] has it; `None` where no tile of it means anything: solids may be objects.
    pub fn level(&self, layer: Option<&str>) -> Result<Option<Level>> {
        if self.tiles.layers.is_empty() && layer.is_none() {
            return Ok(None);
        }
        let level = Level::of(&self.tiles, level::choose(&self.tiles, layer)?)?;
        Ok(Some(level).filter(|level| level.ids.len() > 1))
    }
}

const MAX_BYTES: u64 = 64 << 20;

/// Reads a TMX or an `LDtk` file; of several `LDtk` levels the named one, or the first.
pub fn load(path: &Path, level: Option<&str>) -> Result<Drawing> {
    let of_file = |why: String| Fail::new(format!("{}: {why}", path.display()));
    let bytes = read(path).map_err(of_file)?;
    if bytes.trim_ascii_start().starts_with(b"{") {
        let folder = path.parent().unwrap_or(Path::new(""));
        let tiles = ldtk::read(&bytes, level, folder).map_err(of_file)?;
        return Ok(Drawing { tiles, outlines: Vec::new(), left_out: Vec::new() });
    }
    if level.is_some() {
        return Err(of_file("a Tiled map is one level; --level is for LDtk".to_owned()));
    }
    let tiles = tmx::load(path)?;
    let (outlines, left_out) = objects::read(&bytes).map_err(of_file)?;
    Ok(Drawing { tiles, outlines, left_out })
}

/// The bytes of a file of a bearable size.
pub fn read(path: &Path) -> std::result::Result<Vec<u8>, String> {
    let cannot = |e: std::io::Error| format!("cannot read: {e}");
    let mut bytes = Vec::new();
    File::open(path).map_err(cannot)?.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(format!("larger than {} MiB", MAX_BYTES >> 20));
    }
    Ok(bytes)
}
