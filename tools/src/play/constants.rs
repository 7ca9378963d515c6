//! A level as a firmware of this game includes it: the tile bytes, and the constants that go with them.

use std::fs;
use std::path::{Path, PathBuf};

use super::flags;
use crate::bake::items::items;
use crate::bake::level::Level;
use crate::fail::{Fail, Result};

/// Writes `STEM.bin` and `STEM.rs`.
///
/// # Errors
///
/// A file cannot be written.
pub fn write(level: &Level, stem: &Path) -> Result<[PathBuf; 2]> {
    let files = [stem.with_extension("bin"), stem.with_extension("rs")];
    let name = files[0].file_name().unwrap_or_default().to_string_lossy();
    let constants = constants(level, &name);
    for (file, bytes) in files.iter().zip([&level.tiles[..], constants.as_bytes()]) {
        fs::write(file, bytes).map_err(|e| Fail::new(format!("cannot write {}: {e}", file.display())))?;
    }
    Ok(files)
}

/// The Rust source that stands beside the bytes in the file `bin`.
pub fn constants(level: &Level, bin: &str) -> String {
    let head = "//! Written by `cargo run --example platformer -- LEVEL.tmx --bake STEM`; not edited by hand.\n\
                #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\n";
    let rules = flags::rules(level);
    let flags = [("COIN", rules.coin), ("KILL", rules.kill), ("WIN", rules.win), ("LADDER", rules.ladder)];
    let flags = flags.map(|(name, mask)| (name.to_owned(), mask));
    head.to_owned() + &items(level, &flags, &format!("include_bytes!({bin:?})"))
}
