//! Reads, checks and bakes levels of Tiled and `LDtk` for [`tilesat`], and draws what comes of it.
//!
//! A level goes through four rooms, and each knows only those before it:
//!
//! 1. [`rules`] say what the names mean that people give to tiles and objects: shapes, kinds and flags.
//! 2. [`read`] turns a file of any format into one [`Drawing`](read::drawing::Drawing): layers of tiles, and outlines of objects.
//! 3. [`bake`] turns a drawing into what a firmware includes: bytes, a table, Rust source.
//! 4. [`lint`] looks for mistakes in a drawing, and [`play`] runs bodies through a baked level and checks every frame.
//!
//! [`picture`] draws, and [`sheet`] draws what the library says about each shape.
//! The program `tilesat` is [`cli`] on top of them. A build script does the same by calling the library:
//!
//! ```no_run
//! use std::path::Path;
//! use tilesat_tools::{bake, read};
//!
//! # fn main() -> tilesat_tools::fail::Result<()> {
//! let drawing = read::load(Path::new("levels/quarry.tmx"), None)?;
//! let source = bake::bake(&drawing, &bake::Settings::default())?.source();
//! # drop(source);
//! # Ok(())
//! # }
//! ```
#![allow(clippy::must_use_candidate, reason = "nothing here is called but for its answer")]

pub mod bake;
pub mod build;
pub mod cli;
pub mod fail;
pub mod lint;
pub mod picture;
pub mod play;
pub mod read;
pub mod rules;
pub mod sheet;
