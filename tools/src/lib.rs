//! Reads, checks and bakes levels of Tiled and `LDtk` for [`tilesat`], and draws the results.
//!
//! A level goes through these rooms, and each knows only those before it:
//!
//! 1. [`model`] is a level as it was drawn, in one form for all formats.
//! 2. [`read`] turns a file of any format into it: maps of Tiled in XML and JSON, projects of
//!    `LDtk`.
//! 3. [`rules`] say what of it is solid, by the names that people give to tiles, layers and
//!    objects: a [`Ground`](rules::ground::Ground).
//! 4. [`bake`] turns that into what a firmware includes: bytes, a table, Rust source.
//! 5. [`lint`] looks for mistakes in a level, and [`play`] runs bodies through a baked one and
//!    checks every frame.
//!
//! [`picture`] draws, and [`sheet`] draws what the library says about each shape. The program
//! `tilesat` is [`cli`] on top of them. A build script does the same by calling the library:
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
#![allow(clippy::must_use_candidate, reason = "nothing here is called but for its answer")]

pub mod bake;
pub mod build;
pub mod cli;
pub mod fail;
pub mod lint;
pub mod model;
pub mod picture;
pub mod play;
pub mod read;
pub mod rooms;
pub mod rules;
pub mod sheet;
