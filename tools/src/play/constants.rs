//! A level as a firmware of this game includes it: the tile bytes, and their constants.

use std::path::Path;

use super::flags;
use crate::bake::level::Level;
use crate::bake::{Outputs, items};

/// `STEM.bin` and `STEM.rs`.
pub fn files(level: &Level, stem: &Path) -> Outputs {
    let files = [stem.with_extension("bin"), stem.with_extension("rs")];
    let name = files[0].file_name().unwrap_or_default().to_string_lossy().into_owned();
    let constants = constants(level, &name);
    let mut outputs = Outputs::default();
    let [bin, source] = files;
    outputs.add(bin, level.tiles.clone());
    outputs.add(source, constants.into_bytes());
    outputs
}

/// The Rust source beside the bytes in the file `bin`.
pub fn constants(level: &Level, bin: &str) -> String {
    let head = "//! Written by `cargo run --example platformer -- LEVEL.tmx --bake STEM`. Do not edit it.\n\
                #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\n";
    let rules = flags::rules(level);
    let flags = [("COIN", rules.coin), ("KILL", rules.kill), ("WIN", rules.win), ("LADDER", rules.ladder)];
    let flags = flags.map(|(name, mask)| (name.to_owned(), mask));
    let (imports, size, flags) = (items::imports(&level.ids), items::size(level), items::flags(&flags));
    let (tiles, kinds) = (items::tiles(level, &format!("include_bytes!({bin:?})")), items::kinds(&level.ids));
    format!("{head}use tilesat::{imports};\n\n{size}{flags}{tiles}{kinds}")
}
