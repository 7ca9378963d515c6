//! The arguments of a program that plays levels.

use std::ffi::OsString;
use std::path::PathBuf;

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;
use tilesat_games::platformer::sim::SEED;

use super::args::{next, number, once, path, text, unknown, value};
use super::input::{self, Input};
use crate::fail::{Fail, Result};

/// A program that plays levels.
#[derive(Debug, Clone)]
pub struct Program {
    /// The start of its usage and of its errors.
    pub name: &'static str,
    /// Levels that `--level` finds by name. The first one is the default level.
    pub levels: Vec<(&'static str, PathBuf)>,
    /// The default path of the picture.
    pub picture: Option<PathBuf>,
}

impl Default for Program {
    /// `tilesat play`, which has no built-in level.
    fn default() -> Self {
        Self { name: "tilesat play", levels: Vec::new(), picture: None }
    }
}

const ABOUT: &str = "
Plays a level with one scripted player and 32 boxes and balls, and checks every
body in every frame against an independent exact overlap test. The player starts
at an object whose name or class is spawn, player or PlayerStart, if there is one.
";

const BAKED: &str = "LEVEL may also be a file that tilesat bake has written (.rs, .bin). Of several levels,
the first is played, or the one that --level names.
";

const OPTIONS: &str = "  --frames N     frames to play (default: 3600)
  --seed N       where the bodies start and how they move (default: 11)
  --svg FILE     write the picture as SVG
  --bake STEM    write STEM.bin and STEM.rs, the level as this game includes it, and stop
  --help         print this

The last line is  frames=N bodies=N contacts=N overlaps=N escaped=N hash=XXXXXXXX
Exit status: 0 no error, 1 an overlap or an escape, 2 bad arguments or a bad file.
";

/// The task.
pub(super) struct Options {
    pub(super) file: PathBuf,
    pub(super) input: Input,
    pub(super) frames: u32,
    pub(super) seed: u32,
    pub(super) png: Option<PathBuf>,
    pub(super) svg: Option<PathBuf>,
    pub(super) bake: Option<PathBuf>,
}

impl Program {
    pub(super) fn usage(&self) -> String {
        let mut own = String::new();
        let mut level = "LEVEL";
        if let [(first, _), ..] = &self.levels[..] {
            own = format!("  --level NAME   a level of the example: {} (default: {first})\n", self.names());
            level = "[LEVEL]";
        }
        let default = self.picture.as_ref().map(|file| format!(" (default: {})", file.display())).unwrap_or_default();
        let png = format!("  --picture PNG  write the picture to this file{default}; also --png\n");
        let (about, options) = (input::LEVEL, input::OPTIONS);
        format!("usage: {} {level} [options]\n{ABOUT}{about}{BAKED}\n{own}{png}{OPTIONS}{options}", self.name)
    }

    fn names(&self) -> String {
        self.levels.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
    }

    fn own(&self, name: &str) -> Result<PathBuf> {
        let unknown = || format!("no level of the example is called {name}; there are: {}", self.names());
        let own = self.levels.iter().find(|(own, _)| *own == name);
        own.map(|(_, path)| path.clone()).ok_or_else(|| Fail::new(unknown()))
    }

    /// `None` if the user asks for help.
    pub(super) fn parse(&self, args: impl IntoIterator<Item = OsString>) -> Result<Option<Options>> {
        let place = if self.levels.is_empty() { "LEVEL" } else { "LEVEL or --level" };
        let (mut level, mut frames, mut seed) = (None, None, None);
        let mut input = Input::default();
        let (mut png, mut svg, mut bake) = (None, None, None);
        let mut parser = Parser::from_args(args);
        while let Some(arg) = next(&mut parser)? {
            match arg {
                Short('h') | Long("help") => return Ok(None),
                Long("level") if !self.levels.is_empty() => {
                    let path = self.own(&text(&mut parser, "--level")?)?;
                    once(&mut level, place, path)?;
                }
                Long("frames") => once(&mut frames, "--frames", number(&mut parser, "--frames")?)?,
                Long("seed") => once(&mut seed, "--seed", number(&mut parser, "--seed")?)?,
                // As `bake` calls it.
                Long("png" | "picture") => once(&mut png, "--png", PathBuf::from(value(&mut parser, "--png")?))?,
                Long("svg") => once(&mut svg, "--svg", PathBuf::from(value(&mut parser, "--svg")?))?,
                Long("bake") => once(&mut bake, "--bake", PathBuf::from(value(&mut parser, "--bake")?))?,
                Value(given) => once(&mut level, place, path(given)?)?,
                Long(name) => {
                    let name = name.to_owned();
                    if !input.take(&name, &mut parser)? {
                        return Err(unknown(&Long(&name)));
                    }
                }
                other @ Short(_) => return Err(unknown(&other)),
            }
        }
        let first = || self.levels.first().map(|(_, path)| path.clone());
        let level = level.or_else(first).ok_or_else(|| Fail::new("no level given (see --help)"))?;
        if png.is_none() && svg.is_none() {
            png.clone_from(&self.picture);
        }
        let (frames, seed) = (frames.unwrap_or(3600), seed.unwrap_or(SEED));
        Ok(Some(Options { file: level, input, frames, seed, png, svg, bake }))
    }
}
