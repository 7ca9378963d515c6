//! `tilesat sheet`: draws the library's answers about tiles.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;

use super::args::{next, once, unknown};
use super::tell::{status, tell, usage};
use crate::fail::{Fail, Result};
use crate::picture::png;
use crate::sheet;

const USAGE: &str = "\
usage: tilesat sheet FOLDER

Draws the library's answers about tiles into this folder:

  sheet-shapes.png    every shape with its faces, vertices and arcs
  sheet-mosaic.png    random tiles, their common surface, and rays
  sheet-level.png     the level ninja, rays, and the paths of two balls
  sheet-contacts.png  the contact of every pair of shapes: points, normal, push

Exit status: 0 drawn, 2 bad arguments or a folder that cannot be written.
";

/// Runs the subcommand. Returns the exit status.
pub(crate) fn run(args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = parse(args).and_then(|folder| match folder {
        None => {
            usage(out, USAGE);
            Ok(0)
        }
        Some(folder) => {
            for (name, scene) in sheet::pictures()? {
                let file = folder.join(name);
                png::write(&scene, &file)?;
                tell(out, &format!("picture {}", file.display()));
            }
            Ok(0)
        }
    });
    status("tilesat sheet", result, err)
}

/// `None` if the user asks for help.
fn parse(args: impl Iterator<Item = OsString>) -> Result<Option<PathBuf>> {
    let mut folder = None;
    let mut parser = Parser::from_args(args);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Value(given) => once(&mut folder, "FOLDER", PathBuf::from(given))?,
            other => return Err(unknown(&other)),
        }
    }
    folder.map(Some).ok_or_else(|| Fail::new("no folder given (see --help)"))
}
