//! The command line.

use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

use super::fail::{Fail, Result};
use super::sim::SEED;

pub const USAGE: &str = "\
usage: platformer [LEVEL.tmx] [options]

Plays a level with one scripted player and 32 boxes and balls, and checks every
body in every frame against an independent exact overlap test.

  LEVEL.tmx      a finite orthogonal Tiled map
  --level NAME   a level of the example: meadow (the default), of blocks, or
                 ninja, of all shapes
  --layer NAME   the tile layer that is solid (default: the one with most solid tiles)
  --frames N     how long to play (default: 3600)
  --seed N       where the bodies start and how they move (default: 11)
  --png FILE     write the picture there (default: platformer.png in the target folder)
  --svg FILE     write the picture as SVG
  --bake STEM    write STEM.bin and STEM.rs, the level as a firmware includes it, and stop
  --help         print this

What a tile is, in Tiled:
  class          Collision or Solid: full; OneWay: one-way-up; every other class
                 is a flag. A true boolean property counts as a class.
  shape          a string property: empty, full,
                 half-top, half-right, half-bottom, half-left,
                 slope-*, convex-*, concave-*, mild-low-*, mild-high-*,
                 steep-low-*, steep-high-*  where * is the solid corner, one of
                 top-left, top-right, bottom-right, bottom-left;
                 one-way-up, one-way-right, one-way-down, one-way-left
  npp            an integer property: the shape's number in N++, 0 to 33
shape and npp win over the class. Flipped and turned tiles have flipped and
turned shapes.
The last line is  frames=N bodies=N contacts=N overlaps=N escaped=N hash=XXXXXXXX
Exit status: 0 all is well, 1 an overlap or an escape, 2 bad arguments or a bad file.
";

/// The levels of the example.
const OWN: [&str; 2] = ["meadow", "ninja"];

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    pub level: Option<PathBuf>,
    pub layer: Option<String>,
    pub frames: u32,
    pub seed: u32,
    pub png: Option<PathBuf>,
    pub svg: Option<PathBuf>,
    pub bake: Option<PathBuf>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Command {
    Help,
    Run(Options),
}

pub fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Command> {
    let (mut level, mut layer, mut frames, mut seed) = (None, None, None, None);
    let (mut png, mut svg, mut bake) = (None, None, None);
    let mut args = args.into_iter();
    while let Some(arg) = args.next() {
        let mut value = |name: &str| match args.next() {
            Some(v) if !v.as_encoded_bytes().starts_with(b"--") && !v.is_empty() => Ok(v),
            _ => Err(Fail::new(format!("{name} needs a value"))),
        };
        match arg.to_str() {
            Some("--help" | "-h") => return Ok(Command::Help),
            Some(name @ "--level") => {
                let path = own(&text(&value(name)?, name)?)?;
                once(&mut level, "LEVEL.tmx or --level", path)?;
            }
            Some(name @ "--layer") => once(&mut layer, name, text(&value(name)?, name)?)?,
            Some(name @ "--frames") => once(&mut frames, name, number(&value(name)?, name)?)?,
            Some(name @ "--seed") => once(&mut seed, name, number(&value(name)?, name)?)?,
            Some(name @ "--png") => once(&mut png, name, PathBuf::from(value(name)?))?,
            Some(name @ "--svg") => once(&mut svg, name, PathBuf::from(value(name)?))?,
            Some(name @ "--bake") => once(&mut bake, name, PathBuf::from(value(name)?))?,
            Some(name) if name.starts_with('-') => {
                return Err(Fail::new(format!("unknown argument {name} (see --help)")));
            }
            Some("") => return Err(Fail::new("an empty argument where a level was expected")),
            _ => once(&mut level, "LEVEL.tmx or --level", PathBuf::from(arg))?,
        }
    }
    Ok(Command::Run(Options {
        level,
        layer,
        frames: frames.unwrap_or(3600),
        seed: seed.unwrap_or(SEED),
        png,
        svg,
        bake,
    }))
}

fn own(name: &str) -> Result<PathBuf> {
    match OWN.iter().find(|own| **own == name) {
        Some(own) => Ok(super::own(own)),
        None => Err(Fail::new(format!("no level of the example is called {name}; there are: {}", OWN.join(", ")))),
    }
}

fn once<T>(slot: &mut Option<T>, name: &str, value: T) -> Result<()> {
    match slot.replace(value) {
        None => Ok(()),
        Some(_) => Err(Fail::new(format!("{name} is given twice"))),
    }
}

fn text(value: &OsStr, name: &str) -> Result<String> {
    let text = value.to_str().ok_or_else(|| Fail::new(format!("{name} needs UTF-8 text")))?;
    Ok(text.to_owned())
}

fn number(value: &OsStr, name: &str) -> Result<u32> {
    let shown = value.to_string_lossy();
    shown.parse().map_err(|_| Fail::new(format!("{name} needs a whole number from 0 to {}, got {shown}", u32::MAX)))
}
