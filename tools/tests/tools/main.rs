//! The level tools: what they read, refuse, bake, lint, play and draw.
//!
//! `TILESAT_BLESS` and `TILESAT_FRAMES` are for the corpus. `TILESAT_CASES` scales the number of
//! damaged files. Set `TILESAT_LEVELS` to a folder to have every `.tmx` in it and in its folders
//! played too.

mod bake;
mod baked;
mod build;
mod command;
mod corpus;
mod damaged;
mod hostile;
mod level;
mod limits;
mod lint;
mod lint_bounded;
mod lint_cases;
mod lint_geometry;
mod objects;
mod outputs;
mod play;
mod rooms;
mod shapes;
mod support;
