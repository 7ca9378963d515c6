//! Levels in a build script: a folder of them becomes Rust source, with a module for each.
//!
//! The build script is three lines, with this package among the `[build-dependencies]`:
//!
//! ```no_run
//! fn main() -> Result<(), tilesat_tools::build::Failed> {
//!     tilesat_tools::build::levels("levels")
//! }
//! ```
//!
//! And the program names the modules:
//!
//! ```ignore
//! mod levels {
//!     include!(concat!(env!("OUT_DIR"), "/levels.rs"));
//! }
//! let world = &levels::cave::MAP; // of levels/cave.tmx
//! ```

use std::ffi::OsStr;
use std::fmt::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::bake::{self, Settings};
use crate::fail::Fail;
use crate::read;

/// What is wrong with a folder of levels: a line for each that is refused.
///
/// Where `main` returns it, the program exits with 1 and Cargo shows the lines.
#[derive(Clone, PartialEq, Eq)]
pub struct Failed(pub Vec<Fail>);

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.0.iter().map(Fail::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

/// As `main` shows it, after `Error: `.
impl fmt::Debug for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no levels\n{self}")
    }
}

impl std::error::Error for Failed {}

impl From<Fail> for Failed {
    fn from(fail: Fail) -> Self {
        Self(vec![fail])
    }
}

/// Bakes all levels of a folder of the package into a file of the folder's name with `.rs` in Cargo's `OUT_DIR`, and has Cargo ask again
/// when one of them changes.
///
/// # Errors
///
/// As [`folder`], or this is no build script.
pub fn levels(from: impl AsRef<Path>) -> Result<(), Failed> {
    let from = from.as_ref();
    println!("cargo:rerun-if-changed={}", from.display());
    let out = env::var_os("OUT_DIR").ok_or_else(|| Fail::new("there is no OUT_DIR: this is for build scripts"))?;
    let name = from.file_name().ok_or_else(|| Fail::new(format!("{} names no folder", from.display())))?;
    folder(from, &Path::new(&out).join(name).with_extension("rs"))
}

/// Bakes all levels of a folder, `.tmx` and `.ldtk`, into a file of Rust source: a module for each, by the name of its file.
///
/// # Errors
///
/// A line for each level that cannot be read or is refused. Nothing is written then.
pub fn folder(from: &Path, out: &Path) -> Result<(), Failed> {
    let files = files(from)?;
    let (mut text, mut failed) = (String::new(), Vec::new());
    for file in &files {
        match source(file) {
            Ok(source) => {
                // Writing to a string cannot fail.
                let _ = write!(text, "pub mod {} {{\n{UNUSED}\n{source}}}\n", module(file));
            }
            Err(fail) => failed.push(fail),
        }
    }
    if !failed.is_empty() {
        return Err(Failed(failed));
    }
    fs::write(out, text).map_err(|e| Fail::new(format!("cannot write {}: {e}", out.display())).into())
}

/// A program needs not all that is known of a level.
const UNUSED: &str = "#![allow(dead_code, reason = \"there may be more than is needed\")]";

/// The level files of a folder, in the order of their names.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Failed> {
    let of_folder = |e: std::io::Error| Fail::new(format!("cannot read the folder {}: {e}", folder.display()));
    let entries: Result<Vec<_>, _> = fs::read_dir(folder).map_err(of_folder)?.collect();
    let paths = entries.map_err(of_folder)?.into_iter().map(|entry| entry.path());
    let known =
        |path: &PathBuf| path.extension().and_then(OsStr::to_str).is_some_and(|end| ["tmx", "ldtk"].contains(&end));
    let mut files: Vec<PathBuf> = paths.filter(known).collect();
    files.sort();
    if files.is_empty() {
        return Err(Fail::new(format!("{} has no level: no .tmx, no .ldtk", folder.display())).into());
    }
    Ok(files)
}

fn source(file: &Path) -> crate::fail::Result<String> {
    let drawing = read::load(file, None)?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", file.display()));
    Ok(bake::bake(&drawing, &Settings::default()).map_err(of_file)?.source())
}

fn module(file: &Path) -> String {
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect()
}
