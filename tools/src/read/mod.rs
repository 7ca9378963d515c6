//! Reads level files. Each format has a reader, and all readers make the same [`Map`].

mod file;
mod json;
mod lax;
mod ldtk;
mod text;
mod tiled;
mod xml;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use crate::fail::{Fail, Result};
use crate::model::map::Map;
use crate::rules::options::listed;
use file::Files;

/// The levels of a file.
#[derive(Debug, Clone)]
pub struct Levels {
    pub maps: Vec<Map>,
    /// The file, and the files that it names: tilesets, templates, separate levels and maps.
    pub files: Vec<PathBuf>,
    /// All levels of the file, also those that are not read.
    pub names: Vec<String>,
}

/// The levels of a file to read.
#[derive(Debug, Clone, Copy)]
struct Pick<'a> {
    /// The only one.
    level: Option<&'a str>,
    skipped: &'a [String],
}

impl Pick<'_> {
    /// Whether to read the level of this name.
    fn has(&self, name: &str) -> bool {
        self.level.map_or_else(|| !listed(self.skipped, name), |wanted| wanted == name)
    }
}

/// What a user has to give instead of a file that is no level.
const GIVE: &str = "give a .tmx, .tmj or .world that Tiled has saved, or a .ldtk of LDtk";

/// Reads a map of Tiled (XML or JSON), a world of its maps, or a project of `LDtk`. Of several
/// levels it reads the named one, or all.
///
/// # Errors
///
/// One line that names the file and the reason that it cannot be read.
pub fn load(path: &Path, level: Option<&str>) -> Result<Levels> {
    except(path, level, &[])
}

/// The same without the levels of these names, which need not be readable.
///
/// # Errors
///
/// The same as [`load`].
pub(crate) fn except(path: &Path, level: Option<&str>, skipped: &[String]) -> Result<Levels> {
    let mut files = Files::default();
    let mut maps = maps(path, Pick { level, skipped }, &mut files)
        .map_err(|why| Fail::new(format!("{}: {why}", path.display())))?;
    for map in &mut maps {
        path.clone_into(&mut map.project);
    }
    Ok(Levels { maps, files: files.read, names: files.levels })
}

/// A file of the user that is not a level.
///
/// # Errors
///
/// One line that names the file and the reason that it cannot be read.
pub fn text(path: &Path) -> Result<String> {
    let of_file = |why: String| Fail::new(format!("{}: {why}", path.display()));
    let bytes = Files::default().utf8(path).map_err(of_file)?;
    String::from_utf8(bytes).map_err(|_| of_file("not UTF-8 text".to_owned()))
}

/// The same as bytes.
///
/// # Errors
///
/// The same as [`text`].
pub fn bytes(path: &Path) -> Result<Vec<u8>> {
    Files::default().bytes(path).map_err(|why| Fail::new(format!("{}: {why}", path.display())))
}

fn maps(path: &Path, pick: Pick<'_>, files: &mut Files) -> std::result::Result<Vec<Map>, String> {
    let bytes = files.utf8(path)?;
    if bytes.trim_ascii().is_empty() {
        return Err("the file is empty".to_owned());
    }
    let end = path.extension().and_then(OsStr::to_str).unwrap_or_default().to_ascii_lowercase();
    match &*end {
        "world" => return tiled::world(&bytes, pick, path, files),
        "ldtkl" => return Err("one level of an LDtk project: give the project, which ends in .ldtk".to_owned()),
        _ => {}
    }
    let first = text::unmarked(&bytes).trim_ascii_start().first();
    // The reader of XML would speak of elements.
    if first == Some(&b'[') || !matches!(first, Some(b'{' | b'<')) && matches!(&*end, "tmj" | "json" | "ldtk") {
        let other = || format!("not JSON of a level, which begins with {{: {GIVE}");
        return Err(tiled::foreign(&bytes).unwrap_or_else(other));
    }
    if json::is_json(&bytes) && end != "tmj" {
        match ldtk::looks(&bytes) {
            ldtk::Looks::Map => {}
            looks if end == "ldtk" || looks == ldtk::Looks::Project => {
                return ldtk::read(&bytes, pick, path, files).map_err(|why| tiled::mark(&bytes).unwrap_or(why));
            }
            _ => {
                let neither = "neither a map of Tiled (it has no orientation) nor a project of LDtk (it has no defs)";
                return Err(tiled::foreign(&bytes).unwrap_or_else(|| format!("{neither}: {GIVE}")));
            }
        }
    }
    let map = tiled::read(bytes, path, files)?;
    files.levels.push(map.name.clone());
    match pick.level {
        Some(name) if name != map.name => Err(format!("no level '{name}': a Tiled map is one level, '{}'", map.name)),
        _ => Ok(vec![map]),
    }
}
