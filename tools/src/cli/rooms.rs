//! `tilesat rooms`: converts a world to rooms that a firmware includes.

use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::path::PathBuf;

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;
use tilesat::Fx;

use super::args::{length, next, once, path, text, unknown, value};
use super::input::{self, Input};
use super::tell::{list, status, tell, usage};
use crate::bake::Outputs;
use crate::fail::{Fail, Result};
use crate::rooms::{self, Cut};

const USAGE: &str = "\
usage: tilesat rooms LEVEL -o OUT.rs [options]

Bakes a world of any size as rooms. No body feels their borders. A map is cut into
equal rooms; each level of an LDtk project or map of a Tiled world is a room at its
position in the world.
";

const OPTIONS: &str = "
  -o OUT.rs      write Rust source: the static ROOMS and its parts. OBJECTS has those of
                 each room that are not solid, in coordinates of the room
  --room WxH     columns and rows of a room, for a map
  --body PX      the longer side of the largest body (default: a cell)
  --motion PX    the longest motion per frame, with a walker's step and snap
                 (default: a cell)
  --help         print this

Body and motion give the apron around each room: apron * cell > body + motion + 1.
Exit status: 0 written, 2 bad arguments or a refused world.
";

struct Options {
    file: PathBuf,
    out: PathBuf,
    input: Input,
    room: Option<(u16, u16)>,
    body: Option<Fx>,
    motion: Option<Fx>,
}

/// Runs the subcommand. Returns the exit status.
pub(crate) fn run(args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = parse(args).and_then(|options| match options {
        None => {
            usage(out, &[USAGE, input::LEVEL, OPTIONS, input::OPTIONS].concat());
            Ok(0)
        }
        Some(options) => job(options, out),
    });
    status("tilesat rooms", result, err)
}

/// `None` if the user asks for help.
fn parse(args: impl Iterator<Item = OsString>) -> Result<Option<Options>> {
    let (mut file, mut out, mut room, mut body, mut motion) = (None, None, None, None, None);
    let mut input = Input::default();
    let mut parser = Parser::from_args(args);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Short('o') => once(&mut out, "-o", PathBuf::from(value(&mut parser, "-o")?))?,
            Long("room") => once(&mut room, "--room", cells(&text(&mut parser, "--room")?)?)?,
            Long("body") => once(&mut body, "--body", Fx::from_bits(length(&mut parser, "--body")?))?,
            Long("motion") => once(&mut motion, "--motion", Fx::from_bits(length(&mut parser, "--motion")?))?,
            Value(given) => once(&mut file, "LEVEL", path(given)?)?,
            Long(name) => {
                let name = name.to_owned();
                if !input.take(&name, &mut parser)? {
                    return Err(unknown(&Long(&name)));
                }
            }
            other @ Short(_) => return Err(unknown(&other)),
        }
    }
    let file = input::given(file)?;
    let out: PathBuf = out.ok_or_else(|| Fail::new("no -o OUT.rs given (see --help)"))?;
    if out.extension().and_then(OsStr::to_str) != Some("rs") {
        return Err(Fail::new(format!("{} does not end in .rs: give the output this end", out.display())));
    }
    Ok(Some(Options { file, out, input, room, body, motion }))
}

/// Reads `20x15`.
fn cells(text: &str) -> Result<(u16, u16)> {
    let count = |text: &str| text.parse().ok().filter(|&count: &u16| count > 0);
    let pair = text.split_once('x').and_then(|(width, height)| Some((count(width)?, count(height)?)));
    pair.ok_or_else(|| Fail::new(format!("--room needs columns and rows, such as 20x15, got {text}")))
}

fn job(job: Options, out: &mut dyn Write) -> Result<u8> {
    let (levels, options) = job.input.load(&job.file)?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", job.file.display()));
    let cut = Cut { room: job.room, body: job.body, motion: job.motion };
    let world = rooms::bake(&levels.maps, &options, &cut).map_err(of_file)?;
    let mut outputs = Outputs::default();
    outputs.add(job.out, world.source().into_bytes());
    let written = outputs.write(&levels.files)?;
    for line in world.report() {
        tell(out, &line);
    }
    list(out, "warning", &world.warnings);
    list(out, "note", &world.notes);
    for file in written {
        tell(out, &format!("wrote   {}", file.display()));
    }
    Ok(0)
}
