//! What the tests of the level tools share: maps as text, files, and runs of a program.
#![allow(dead_code, reason = "each test uses its part")]

use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What a run of a program leaves behind.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) status: u8,
    pub(crate) out: String,
    pub(crate) err: String,
}

type Program = fn(Vec<OsString>, &mut dyn Write, &mut dyn Write) -> u8;

/// A run with a file and options that have spaces between them.
pub(crate) fn run(program: Program, file: impl Into<OsString>, options: &str) -> Ran {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let args = [file.into()].into_iter().chain(options.split_whitespace().map(Into::into)).collect();
    let status = program(args, &mut out, &mut err);
    Ran { status, out: String::from_utf8(out).unwrap(), err: String::from_utf8(err).unwrap() }
}

/// A file of the examples.
pub(crate) fn own(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(path)
}

/// A file of this test alone: tests run side by side, and each in a thread of its name.
pub(crate) fn scratch(folder: &str, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    let thread = std::thread::current();
    let folder = folder.join(thread.name().unwrap_or("main").replace("::", "-"));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    fs::write(&path, content).unwrap();
    path
}

/// A map of these objects in the layer `L`, and no tiles.
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
 <objectgroup id="2" name="L">{list}</objectgroup>
</map>"#
    )
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
