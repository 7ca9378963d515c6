//! The level tools: reading, refusing, baking, linting, playing and drawing.
//!
//! `TILESAT_BLESS` and `TILESAT_FRAMES` are for the corpus. `TILESAT_CASES` scales the number of
//! damaged files. If `TILESAT_LEVELS` names a folder, every `.tmx` in it and in its folders plays
//! too.

mod bake;
mod baked;
mod build;
mod called;
mod command;
mod corpus;
mod damaged;
mod drawn;
mod flags;
mod formats;
mod groups;
mod guesses;
mod hollow;
mod hostile;
mod knots;
mod large;
mod ldtk;
mod lenient;
mod level;
mod limits;
mod lint;
mod lint_bounded;
mod lint_cases;
mod lint_geometry;
mod marks;
mod messages;
mod objects;
mod old_files;
mod one_way;
mod outputs;
mod oversize;
mod play;
mod played;
mod programs;
mod reported;
mod rooms;
mod search;
mod shapes;
mod slips;
mod stamps;
mod support;
mod unused;
mod weld;
mod words;
mod worlds;
