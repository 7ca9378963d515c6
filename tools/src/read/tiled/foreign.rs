//! Files that are no maps, and what their user has to give instead.

use super::super::{json, text::unmarked};

/// What a file is, if it is no map, and what to do.
pub(in crate::read) fn map(bytes: &[u8]) -> Option<String> {
    let text = unmarked(bytes).trim_ascii_start();
    let begins = |start: &str| text.starts_with(start.as_bytes());
    let element = |name: &str| has(&text[..text.len().min(MOST)], &format!("<{name}"));
    let is = |what: &str, do_this: &str| Some(format!("{what}: {do_this}"));
    if let Some(why) = mark(bytes) {
        return Some(why);
    }
    if json::is_json(bytes) {
        let keys = json::keys(bytes);
        let key = |name: &str| keys.contains(&name.as_bytes());
        return if key("propertyTypes") || key("automappingRulesFile") {
            is("a project of Tiled", "give a map or a .world")
        } else if key("object") && !key("layers") {
            is("a template of Tiled", "give a map that uses it")
        } else if key("tilecount") || key("tilewidth") && key("image") {
            is("a tileset of Tiled", "give a map that uses it")
        } else if key("neighbourLevels") || key("uniqueIdentifer") {
            is("a simplified export of LDtk", "give the .ldtk")
        } else {
            None
        };
    }
    if bytes.starts_with(b"\x1f\x8b") || begins("PK\x03\x04") {
        is("a packed file", "unpack it first")
    } else if is_program(text) {
        is("an export of Tiled for programs", "give the map itself, which ends in .tmx or .tmj")
    } else if begins("//") || begins("/*") {
        is("it begins with a comment, which neither XML nor JSON has", "remove it")
    } else if element("tileset") && !element("map") {
        is("a tileset of Tiled", "give a map that uses it")
    } else if element("template") && !element("map") {
        is("a template of Tiled", "give a map that uses it")
    } else if is_table(text) {
        is("a table of numbers, without the size and the classes of tiles", "give the map, which ends in .tmx or .tmj")
    } else {
        None
    }
}

/// Whether layers of these names are those of a rule of automapping: all of them, and some of its
/// inputs and outputs.
pub(super) fn is_rule<'a>(names: impl Iterator<Item = &'a str>) -> bool {
    let (mut input, mut output) = (false, false);
    for name in names {
        let name = name.to_ascii_lowercase();
        match ["input", "output", "regions", "rule_options", "//"].iter().position(|start| name.starts_with(start)) {
            Some(0) => input = true,
            Some(1) => output = true,
            Some(_) => {}
            None => return false,
        }
    }
    input && output
}

/// How programs begin that hold a map: Tiled exports Lua and JavaScript.
const PROGRAM: [&str; 10] = [
    "return {",
    "return{",
    "(function",
    "local ",
    "var ",
    "let ",
    "const ",
    "module.exports",
    "export default",
    "define(",
];

fn is_program(text: &[u8]) -> bool {
    PROGRAM.iter().any(|begin| text.starts_with(begin.as_bytes()))
        || has(text, "onTileMapLoaded")
        || has(text, "TileMaps[")
}

/// A layer that Tiled exports as CSV.
fn is_table(text: &[u8]) -> bool {
    text.contains(&b',') && text.iter().all(|byte| byte.is_ascii_digit() || b",-; \t\r\n".contains(byte))
}

/// The first element of a file begins before this byte.
const MOST: usize = 1000;

/// The line of a mark that git has left in a file.
pub(in crate::read) fn mark(bytes: &[u8]) -> Option<String> {
    let marks: [&[u8]; 2] = [b"<<<<<<< ", b">>>>>>> "];
    let line = bytes.split(|&byte| byte == b'\n').position(|line| marks.iter().any(|mark| line.starts_with(mark)))?;
    Some(format!("line {}: a mark of an unsolved git merge", line + 1))
}

fn has(text: &[u8], part: &str) -> bool {
    text.windows(part.len()).any(|window| window == part.as_bytes())
}
