//! `tilesat bake`: converts levels to files that a firmware includes.

use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::path::{Path, PathBuf};

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;
use tilesat::Fx;

use super::args::{length, next, once, path, sides, unknown, value};
use super::input::{self, Input};
use super::tell::{list, status, tell, usage};
use crate::bake::{self, Baked, Bundle, Outputs, Settings};
use crate::fail::{Fail, Result};
use crate::picture::marks::Scene;
use crate::picture::{backdrop, png};

const USAGE: &str = "\
usage: tilesat bake LEVEL -o OUT.bin|OUT.rs [options]

Turns a level into files that a firmware includes, and reports what it costs there.
All levels of an LDtk project are baked together, with one table of tile kinds.
";

const OPTIONS: &str = "
  -o OUT.rs      write Rust source: constants from which the compiler builds the
                 level; several levels are a module each. Objects that are not solid
                 are in OBJECTS; one with a name has a constant, as OBJECT_SPAWN
  -o OUT.bin     write bytes: for polygons those of SegmentMap::from_bytes, for tiles
                 one per tile (with both: OUT.segments.bin and OUT.tiles.bin), and
                 OUT.bin.rs, which describes them; for several levels OUT.LEVEL.bin and
                 OUT.LEVEL.bin.rs of each
  --json         print a line of JSON for each level instead of the report, with the
                 report's lines in the lists ignored, unused, warnings and notes; you
                 can omit -o then, and with --picture
  --picture PNG  draw the solid over the level as you drew it; for several levels
                 NAME.png becomes NAME.LEVEL.png
  --cell PX      the side of the cells that index polygons (default: a tile)
  --body WxH     the body for which the report counts (default: a cell)
  --help         print this

If anything fails, nothing is written. A file of the level is never overwritten.
Exit status: 0 written, 2 bad arguments or a refused level.
";

struct Options {
    file: PathBuf,
    input: Input,
    out: Option<(PathBuf, Format)>,
    cell: Option<Fx>,
    /// In raw units.
    body: Option<(i32, i32)>,
    picture: Option<PathBuf>,
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Bytes,
    Source,
}

/// Runs the subcommand. Returns the exit status.
pub(crate) fn run(args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = parse(args).and_then(|options| match options {
        None => {
            usage(out, &[USAGE, input::LEVEL, OPTIONS, input::OPTIONS].concat());
            Ok(0)
        }
        Some(options) => job(options, out, err),
    });
    status("tilesat bake", result, err)
}

/// `None` if the user asks for help.
fn parse(args: impl Iterator<Item = OsString>) -> Result<Option<Options>> {
    let (mut file, mut out, mut cell, mut body, mut picture, mut json) = (None, None, None, None, None, None);
    let mut input = Input::default();
    let mut parser = Parser::from_args(args);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Short('o') => once(&mut out, "-o", PathBuf::from(value(&mut parser, "-o")?))?,
            Long("cell") => once(&mut cell, "--cell", length(&mut parser, "--cell")?)?,
            Long("body") => once(&mut body, "--body", sides(&mut parser, "--body")?)?,
            Long("picture") => once(&mut picture, "--picture", PathBuf::from(value(&mut parser, "--picture")?))?,
            Long("json") => once(&mut json, "--json", true)?,
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
    let json = json.unwrap_or(false);
    if out.is_none() && picture.is_none() && !json {
        return Err(Fail::new("no -o OUT.bin or -o OUT.rs given (see --help)"));
    }
    let out = out.map(|out: PathBuf| Ok((out.clone(), format(&out)?))).transpose()?;
    Ok(Some(Options { file, input, out, cell: cell.map(Fx::from_bits), body, picture, json }))
}

fn format(out: &Path) -> Result<Format> {
    match out.extension().and_then(OsStr::to_str) {
        Some("bin") => Ok(Format::Bytes),
        Some("rs") => Ok(Format::Source),
        _ => Err(Fail::new(format!(
            "{} ends neither in .bin nor in .rs: give the output one of these ends",
            out.display()
        ))),
    }
}

fn job(job: Options, out: &mut dyn Write, err: &mut dyn Write) -> Result<u8> {
    let (levels, options) = job.input.load(&job.file)?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", job.file.display()));
    let settings = Settings { options, cell: job.cell };
    let bundle = bake::bake(&levels.maps, &settings).map_err(of_file)?;
    let mut outputs = Outputs::default();
    if let Some((file, format)) = &job.out {
        for (file, bytes) in bundle.files(file, *format == Format::Source) {
            outputs.add(file, bytes);
        }
    }
    let mut lines = Vec::new();
    for baked in &bundle.levels {
        lines.push(if job.json { vec![baked.json()?] } else { baked.report(job.body).map_err(of_file)? });
    }
    if let Some(picture) = &job.picture {
        let places = bundle.places(picture, "png");
        let drawn = levels
            .maps
            .iter()
            .filter(|map| !crate::rules::options::listed(&settings.options.ignored_levels, &map.name));
        for (((baked, map), place), lines) in bundle.levels.iter().zip(drawn).zip(places).zip(&lines) {
            let shown = if job.json { &[][..] } else { lines };
            let scale = settings.options.scale;
            let drawn = |scene: &Scene, corner| backdrop::image(scene, corner, map, &baked.ground, scale);
            let scene = baked.picture(shown, &drawn)?;
            outputs.add(place, png::bytes(&scene)?);
        }
    }
    let written = outputs.write(&levels.files)?;
    for (baked, lines) in bundle.levels.iter().zip(lines) {
        if job.json {
            list(err, "note", &baked.ground.notes);
            tell_whole(out, &lines[0]);
        } else {
            told(baked, &bundle, &lines, out);
        }
    }
    let dropped = bundle.dropped.iter().map(|name| format!("flag {name}")).collect();
    for (word, lines) in [("warning", bundle.warnings), ("dropped", dropped)] {
        list(if job.json { err } else { out }, word, &lines);
    }
    for file in written {
        let word = if file.extension().is_some_and(|end| end == "png") { "picture" } else { "wrote  " };
        // Only programs read JSON. Of several pictures, none has the given name.
        if !job.json {
            tell(out, &format!("{word} {}", file.display()));
        } else if bundle.levels.len() > 1 && word == "picture" {
            tell(err, &format!("{word} {}", file.display()));
        }
    }
    Ok(0)
}

/// A line for programs is not shortened. JSON escapes control characters.
fn tell_whole(out: &mut dyn Write, line: &str) {
    let _ = writeln!(out, "{line}");
}

/// The report about a level.
fn told(baked: &Baked, bundle: &Bundle, lines: &[String], out: &mut dyn Write) {
    if bundle.levels.len() > 1 {
        tell(out, &format!("level   {}", baked.ground.name));
    }
    for line in lines {
        tell(out, line);
    }
    let rules: Vec<String> =
        baked.ground.applied.iter().map(|used| format!("{}  {}: {}", used.rule, used.what, used.tiles)).collect();
    list(out, "rule", &rules);
    list(out, "object", &baked.listed());
    list(out, "ignored", &baked.unused());
    list(out, "warning", &baked.warnings());
    list(out, "note", &baked.ground.notes);
}
