//! Shared code of the tests of the level tools: maps as text, files, and runs of a program.

use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use tilesat_tools::bake::level::Level;
use tilesat_tools::bake::{self, Settings};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::{cli, read};

/// The result of a run of a program.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) status: u8,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Ran {
    pub(crate) fn last(&self) -> &str {
        self.out.lines().last().unwrap_or_default()
    }
}

/// A run of a program.
pub(crate) fn ran<A: Into<OsString>>(
    program: impl FnOnce(Vec<OsString>, &mut dyn Write, &mut dyn Write) -> u8,
    args: impl IntoIterator<Item = A>,
) -> Ran {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = program(args.into_iter().map(Into::into).collect(), &mut out, &mut err);
    Ran { status, out: String::from_utf8(out).unwrap(), err: String::from_utf8(err).unwrap() }
}

/// A run of `tilesat`.
pub(crate) fn tilesat<A: Into<OsString>>(args: impl IntoIterator<Item = A>) -> Ran {
    ran(|args, out, err| cli::run(args, out, err), args)
}

/// A run of a subcommand with a file and options, separated by spaces.
pub(crate) fn run(command: &str, file: impl Into<OsString>, options: &str) -> Ran {
    tilesat([command.into(), file.into()].into_iter().chain(options.split_whitespace().map(OsString::from)))
}

/// A file of the examples.
pub(crate) fn own(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(path)
}

/// The tiles of a level file.
pub(crate) fn level(path: &Path) -> Result<Level> {
    let levels = read::load(path, None)?;
    let bundle = bake::bake(&levels.maps, &Settings::default())?;
    let first = bundle.levels.into_iter().next().and_then(|level| level.tiles);
    first.ok_or_else(|| Fail::new("no tiles"))
}

/// A folder for this test. Tests run in parallel, each in a thread of its name.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let thread = std::thread::current();
    let folder = folder.join(thread.name().unwrap_or("main").replace("::", "-"));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// A file there.
pub(crate) fn scratch(folder: &str, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
    let path = self::folder(folder).join(name);
    fs::write(&path, content).unwrap();
    path
}

/// A map of these objects in the layer `L`, whose class makes them solid, without tiles.
pub(crate) fn objects(list: &str) -> String {
    map(1, 1, "0", list)
}

/// A map of these rows of tiles, `#` solid and `=` one-way, 16 pixels each, in the layer `World`.
pub(crate) fn rows(rows: &[&str]) -> String {
    let cell = |c: char| match c {
        '#' => "1",
        '=' => "2",
        _ => "0",
    };
    let cells: Vec<&str> = rows.iter().flat_map(|row| row.chars().map(cell)).collect();
    map(rows.first().map_or(0, |row| row.len()), rows.len(), &cells.join(","), "")
}

pub(crate) fn map(width: usize, height: usize, csv: &str, list: &str) -> String {
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" orientation="orthogonal" renderorder="right-down" width="{width}" height="{height}" tilewidth="16" tileheight="16" infinite="0">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="4" columns="4">
  <tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>
 </tileset>
 <layer id="1" name="World" width="{width}" height="{height}"><data encoding="csv">{csv}</data></layer>
 <objectgroup id="2" name="L" class="Solid">{list}</objectgroup>
</map>"#
    )
}

/// A map of 4x3 cells with these layers, tiles and objects.
pub(crate) fn layered(layers: &[(&str, &str)], tiles: &str, objects: &str) -> String {
    let text = map(4, 3, "", "");
    let old = r#"<tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>"#;
    let from = text.find("<layer").unwrap();
    let layer = |(name, cells): &(&str, &str)| {
        format!(r#"<layer name="{name}" width="4" height="3"><data encoding="csv">{cells}</data></layer>"#)
    };
    let all: String = layers.iter().map(layer).collect();
    format!("{}{all}{objects}</map>", text[..from].replace(old, tiles))
}

/// An `LDtk` project of one level `One` with one layer `Solid` of these values, numbered from 1.
pub(crate) fn ldtk(values: &[&str], width: usize, height: usize, csv: &str) -> String {
    let values: Vec<String> =
        values.iter().zip(1..).map(|(name, value)| format!(r#"{{"value":{value},"identifier":"{name}"}}"#)).collect();
    format!(
        r#"{{"defs":{{"layers":[{{"uid":2,"intGridValues":[{}]}}]}},"levels":[{{"identifier":"One","layerInstances":[{{"__type":"IntGrid","__identifier":"Solid","__cWid":{width},"__cHei":{height},"__gridSize":16,"__pxTotalOffsetX":0,"__pxTotalOffsetY":0,"layerDefUid":2,"intGridCsv":[{csv}]}}]}}]}}"#,
        values.join(",")
    )
}
