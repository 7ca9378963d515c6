//! The maps of a world: those that it lists, and those of its folder whose names hold their
//! position.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use regex_lite::Regex;
use serde::Deserialize;

use crate::read::file::Files;
use crate::read::lax;

type Result<T> = std::result::Result<T, String>;

/// How names of maps end. Of several files with one name, the first of these is the map.
const ENDS: [&str; 4] = ["tmx", "tmj", "json", "xml"];

/// A map of a world.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Entry {
    pub(super) file_name: String,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) x: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) y: i32,
    /// In pixels. Only infinite maps need them.
    #[serde(deserialize_with = "lax::count")]
    pub(super) width: Option<u32>,
    #[serde(deserialize_with = "lax::count")]
    pub(super) height: Option<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Pattern {
    #[serde(deserialize_with = "lax::given")]
    regexp: String,
    #[serde(deserialize_with = "lax::count")]
    multiplier_x: Option<i32>,
    #[serde(deserialize_with = "lax::count")]
    multiplier_y: Option<i32>,
    #[serde(deserialize_with = "lax::whole")]
    offset_x: i32,
    #[serde(deserialize_with = "lax::whole")]
    offset_y: i32,
    #[serde(deserialize_with = "lax::count")]
    map_width: Option<u32>,
    #[serde(deserialize_with = "lax::count")]
    map_height: Option<u32>,
}

/// Adds the maps of a folder that fit a pattern to those that the world lists. A listed map keeps
/// its position, and so does one of an earlier pattern.
pub(super) fn add(maps: &mut Vec<Entry>, patterns: &[Pattern], folder: &Path, files: &mut Files) -> Result<()> {
    if patterns.is_empty() {
        return Ok(());
    }
    let names = names(folder)?;
    let mut known: HashSet<String> = maps.iter().map(|map| stem(&map.file_name).to_owned()).collect();
    for pattern in patterns {
        let of_pattern = |why: &str| format!("the pattern '{}' of the world: {why}", pattern.regexp);
        let regex = Regex::new(&pattern.regexp).map_err(|why| {
            of_pattern(&format!(
                "the tools do not read it ({why}); list each map in \"maps\" with fileName, x and y, as Tiled's World \
                 Tool does"
            ))
        })?;
        if regex.captures_len() != 3 {
            return Err(of_pattern("it needs two groups in brackets, the first for x and the second for y"));
        }
        let (across, down) = (pattern.multiplier_x.unwrap_or(1), pattern.multiplier_y.unwrap_or(1));
        if across == 0 || down == 0 {
            return Err(of_pattern("its multiplierX or multiplierY is 0: give the distance between maps in pixels"));
        }
        let mut others: Vec<&str> = Vec::new();
        for name in &names {
            let Some(found) = regex.captures(name) else { continue };
            if !is_map(name) {
                others.push(name);
                continue;
            }
            if !known.insert(stem(name).to_owned()) {
                continue;
            }
            let along = |group: usize, multiplier: i32, offset: i32| {
                let text = found.get(group).map_or("", |group| group.as_str());
                let index = if text.is_empty() { Some(0) } else { text.parse::<i32>().ok() };
                let at = index.and_then(|index| index.checked_mul(multiplier)?.checked_add(offset));
                at.ok_or_else(|| of_pattern(&format!("in '{name}' it finds '{text}', which gives no position")))
            };
            let (x, y) = (along(1, across, pattern.offset_x)?, along(2, down, pattern.offset_y)?);
            let size = |given: Option<u32>, multiplier: i32| given.or(Some(multiplier.unsigned_abs()));
            let (width, height) = (size(pattern.map_width, across), size(pattern.map_height, down));
            maps.push(Entry { file_name: name.clone(), x, y, width, height });
        }
        if let [first, rest @ ..] = &others[..] {
            let more = if rest.is_empty() { String::new() } else { format!(" and {} more", rest.len()) };
            files.notes.push(of_pattern(&format!("'{first}'{more} fits it, and is no map")));
        }
    }
    if maps.is_empty() {
        let first = patterns.first().map_or("", |pattern| &pattern.regexp);
        return Err(format!("a world of Tiled without maps: no map beside it fits the pattern '{first}'"));
    }
    Ok(())
}

/// The files of a folder, in an order that does not depend on the system.
fn names(folder: &Path) -> Result<Vec<String>> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = fs::read_dir(folder).map_err(|e| format!("cannot read the folder of the world: {e}"))?;
    let files = entries.filter_map(std::result::Result::ok).filter(|entry| entry.path().is_file());
    let mut names: Vec<String> = files.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    let rank = |name: &String| ENDS.iter().position(|known| end(name).eq_ignore_ascii_case(known));
    names.sort_by_cached_key(|name| (stem(name).to_owned(), rank(name), name.clone()));
    Ok(names)
}

fn is_map(name: &str) -> bool {
    ENDS.iter().any(|known| end(name).eq_ignore_ascii_case(known))
}

fn end(name: &str) -> &str {
    name.rsplit_once('.').map_or("", |(_, end)| end)
}

fn stem(name: &str) -> &str {
    let name = name.strip_prefix("./").unwrap_or(name);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}
