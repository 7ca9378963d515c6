//! `tilesat lint`: reports the mistakes of a level.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;

use lexopt::Arg::{Long, Short, Value};
use lexopt::Parser;

use super::args::{length, next, once, path, sides, unknown};
use super::input::{self, Input};
use super::tell::{list, status, tell, usage};
use crate::fail::{Fail, Result};
use crate::lint::{self, Body, Rules, Severity};
use crate::model::map::Map;
use crate::rules::flags::Flags;
use crate::rules::ground::{Drawn, Ground};
use crate::rules::options::{Options as Solid, listed, together};

const USAGE: &str = "\
usage: tilesat lint LEVEL [options]

Looks for mistakes in a level, or in all levels of an LDtk project, before you bake it.
";

const OPTIONS: &str = "
  --body WxH     a box of this size moves through it: report gaps that are too narrow
  --circle R     a circle of this radius does
  --small PX     edges shorter and polygons thinner than this are slivers (default: 1)
  --strict       warnings count as errors
  --help         print this

Each finding is a line: severity, code, position in pixels, objects, what, why.
Exit status: 0 no error, 1 errors, 2 bad arguments or a bad file.
";

struct Options {
    file: PathBuf,
    input: Input,
    rules: Rules,
    strict: bool,
}

const BODY: &str = "a body (--body, --circle)";

/// Runs the subcommand. Returns the exit status.
pub(crate) fn run(args: impl Iterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> u8 {
    let result = parse(args).and_then(|options| match options {
        None => {
            usage(out, &[USAGE, input::LEVEL, OPTIONS, input::OPTIONS].concat());
            Ok(0)
        }
        Some(options) => job(options, out),
    });
    status("tilesat lint", result, err)
}

/// `None` if the user asks for help.
fn parse(args: impl Iterator<Item = OsString>) -> Result<Option<Options>> {
    let (mut file, mut body, mut small, mut strict) = (None, None, None, None);
    let mut input = Input::default();
    let mut parser = Parser::from_args(args);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Long("body") => {
                let (width, height) = sides(&mut parser, "--body")?;
                once(&mut body, BODY, Body::Box { width: width.into(), height: height.into() })?;
            }
            Long("circle") => {
                let radius = length(&mut parser, "--circle")?;
                once(&mut body, BODY, Body::Circle { radius: radius.into() })?;
            }
            Long("small") => once(&mut small, "--small", length(&mut parser, "--small")?)?,
            Long("strict") => once(&mut strict, "--strict", true)?,
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
    let rules = Rules { body, small: small.map_or(1 << 16, i64::from) };
    Ok(Some(Options { file, input, rules, strict: strict.unwrap_or(false) }))
}

fn job(job: Options, out: &mut dyn Write) -> Result<u8> {
    let (levels, options) = job.input.load(&job.file)?;
    let of_file = |fail: Fail| Fail::new(format!("{}: {fail}", job.file.display()));
    let maps: Vec<&Map> = levels.maps.iter().filter(|map| !listed(&options.ignored_levels, &map.name)).collect();
    let made = |options: &Solid| {
        let mut flags = Flags::new(&options.flags).map_err(Fail::new)?;
        let of_level = |map: &Map, fail: Fail| fail.of_level(&map.name, maps.len() > 1);
        let drawn = maps.iter().zip(Drawn::all(&maps, options, of_level)?);
        let ground = |(map, drawn): (&&Map, Drawn<'_>)| drawn.ground(&mut flags).map_err(|fail| of_level(map, fail));
        let grounds = drawn.map(ground).collect::<Result<Vec<_>>>()?;
        Ok((grounds, flags))
    };
    let is_solid = |(grounds, _): &(Vec<Ground>, Flags)| grounds.iter().any(Ground::is_solid);
    let (grounds, flags) = together(maps.len(), &options, made, is_solid).map_err(of_file)?;
    let (mut layers, mut outlines, mut found) = (0, 0, [0; 3]);
    for (map, ground) in maps.iter().zip(grounds) {
        let findings = lint::check(&ground, &job.rules).map_err(of_file)?;
        if levels.maps.len() > 1 {
            tell(out, &format!("level {}", map.name));
        }
        list(out, "note", &ground.notes);
        for line in findings.lines() {
            tell(out, &line);
        }
        for (all, severity) in found.iter_mut().zip([Severity::Error, Severity::Warning, Severity::Note]) {
            *all += findings.count(severity);
        }
        layers += ground.layers;
        outlines += ground.outlines.len();
    }
    list(out, "note", &flags.warning().into_iter().collect::<Vec<_>>());
    let [errors, warnings, notes] = found;
    tell(out, &format!("layers={layers} outlines={outlines} errors={errors} warnings={warnings} notes={notes}"));
    Ok(u8::from(errors > 0 || job.strict && warnings > 0))
}
