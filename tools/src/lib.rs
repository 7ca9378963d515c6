//! Reads, checks and bakes levels of Tiled and `LDtk` for [`tilesat`], and draws the results.
//!
//! A level passes through these modules. Each knows only those before it:
//!
//! 1. [`model`] is a level as drawn, in one form for all formats.
//! 2. [`read`] converts a file of any format to it: maps of Tiled in XML and JSON, and projects of
//!    `LDtk`.
//! 3. [`rules`] decide what is solid, by the names of tiles, layers and objects. The result is a
//!    [`Ground`](rules::ground::Ground).
//! 4. [`bake`] converts that to files that a firmware includes: bytes, a table, Rust source.
//! 5. `lint` finds mistakes in a level. `play` runs bodies through a baked level and checks
//!    every frame.
//!
//! `picture` draws, and `sheet` draws the library's answers about each shape. The program
//! `tilesat` is `cli` on top of them. The feature `program`, on by default, has what a build script
//! does not need: `cli`, `lint`, `picture`, `play`, `sheet`, and the reports of [`bake`]. A build
//! script can call the rest directly:
//!
//! ```no_run
//! use std::path::Path;
//! use tilesat_tools::bake::{self, Outputs, Settings};
//! use tilesat_tools::read;
//!
//! # fn main() -> tilesat_tools::fail::Result<()> {
//! let levels = read::load(Path::new("levels/quarry.tmx"), None)?;
//! let source = bake::bake(&levels.maps, &Settings::default())?.source();
//! let mut outputs = Outputs::default();
//! outputs.add("src/quarry.rs".into(), source.into_bytes());
//! outputs.write(&levels.files)?;
//! # Ok(())
//! # }
//! ```
#![allow(clippy::must_use_candidate, reason = "every function here is called for its answer")]

mod advice;
pub mod bake;
pub mod build;
#[cfg(feature = "program")]
pub mod cli;
pub mod fail;
pub mod geometry;
#[cfg(feature = "program")]
pub mod lint;
pub mod model;
#[cfg(feature = "program")]
pub mod picture;
#[cfg(feature = "program")]
pub mod play;
mod project;
pub mod read;
pub mod rooms;
pub mod rules;
#[cfg(feature = "program")]
pub mod sheet;
