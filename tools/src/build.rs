//! Bakes levels in a build script: a folder of them becomes Rust source, with a module for each.
//!
//! Add this package to the `[build-dependencies]`, with `default-features = false`: a build script
//! needs no pictures and no games. The build script has three lines:
//!
//! ```no_run
//! fn main() -> Result<(), tilesat_tools::build::Failed> {
//!     tilesat_tools::build::levels("levels")
//! }
//! ```
//!
//! The program includes them with one line. Here `levels::cave::MAP` comes from `levels/cave.tmx`:
//!
//! ```ignore
//! include!(concat!(env!("OUT_DIR"), "/levels.rs"));
//! ```

use std::collections::{HashMap, HashSet};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::{env, fmt, fs};

use crate::advice::in_file;
use crate::bake::{self, Baked, Bundle, Outputs, Settings, names, source};
use crate::fail::{Fail, one_line};
use crate::model::map::Map;
use crate::project;
use crate::rules::options::{Options, listed};

/// The errors of a folder of levels, one line per refused level.
///
/// If `main` returns it, the program exits with 1 and Cargo shows the lines.
#[derive(Clone, PartialEq, Eq)]
pub struct Failed(pub Vec<Fail>);

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.0.iter().map(Fail::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

/// As `main` prints it, after `Error: `: the reasons come first.
impl fmt::Debug for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}\nno level is written")
    }
}

impl std::error::Error for Failed {}

impl From<Fail> for Failed {
    fn from(fail: Fail) -> Self {
        Self(vec![fail])
    }
}

/// A baked folder.
///
/// Its text has the lines that Cargo reads from a build script: the input files, and the warnings.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Folder {
    /// The levels, and the files that they name.
    pub files: Vec<PathBuf>,
    /// What the authors probably did not intend, and what is in no output. Each line names its
    /// level and the reason.
    pub warnings: Vec<String>,
}

/// The most warnings that Cargo shows.
const MOST: usize = 50;

impl fmt::Display for Folder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for file in &self.files {
            writeln!(f, "cargo::rerun-if-changed={}", file.display())?;
        }
        for warning in self.warnings.iter().take(MOST) {
            writeln!(f, "cargo::warning={}", one_line(warning))?;
        }
        match self.warnings.len().checked_sub(MOST) {
            None | Some(0) => Ok(()),
            Some(more) => writeln!(f, "cargo::warning=and {more} more: `tilesat bake` and `tilesat lint` list them"),
        }
    }
}

/// Bakes all levels of a folder of the package into a file in Cargo's `OUT_DIR`. The file has the
/// folder's name with `.rs`. Cargo runs the build script again if a level changes, or a file that
/// it names. Cargo shows what was left out of a level, and why, as warnings.
///
/// # Errors
///
/// As [`folder`], or if this is not a build script.
pub fn levels(from: impl AsRef<Path>) -> Result<(), Failed> {
    let from = from.as_ref();
    println!("cargo::rerun-if-changed={}", from.display());
    let out = env::var_os("OUT_DIR").ok_or_else(|| Fail::new("there is no OUT_DIR: this is for build scripts"))?;
    let name = from.file_name().ok_or_else(|| Fail::new(format!("{} is not the name of a folder", from.display())))?;
    print!("{}", folder(from, &Path::new(&out).join(name).with_extension("rs"))?);
    Ok(())
}

/// Bakes all levels of a folder into a file of Rust source: maps and worlds of Tiled, and projects
/// of `LDtk`. It bakes a map that a world of the folder lists once.
///
/// The file has one module of the folder's name, with a module for each level and one table of tile
/// kinds for all. It uses the settings of a `tilesat.toml` in the folder.
///
/// # Errors
///
/// A line for each level that cannot be read or is refused. Then it writes nothing.
pub fn folder(from: &Path, out: &Path) -> Result<Folder, Failed> {
    let (mut drawn, mut options, mut read, mut failed) = (Vec::new(), Options::default(), Vec::new(), Vec::new());
    let mut placed: HashSet<PathBuf> = HashSet::new();
    let mut known: HashSet<String> = HashSet::new();
    for file in files(from)? {
        if file.canonicalize().is_ok_and(|real| placed.contains(&real)) {
            continue;
        }
        match project::load(&file, None, Options::default()) {
            Ok((levels, said)) => {
                let named = said.ignored_levels.iter().filter(|name| project::has_level(&levels, name));
                known.extend(named.cloned());
                options = said;
                if is_world(&file) {
                    placed.extend(levels.files.iter().filter_map(|file| file.canonicalize().ok()));
                }
                drawn.extend(levels.maps.into_iter().map(|map| (file.clone(), map)));
                read.extend(levels.files);
            }
            Err(fail) => failed.push(fail),
        }
    }
    // The levels of a file that is not read are not known.
    if let Some(name) = options.ignored_levels.iter().find(|name| failed.is_empty() && !known.contains(*name)) {
        let file = from.join(project::NAME);
        failed.push(Fail::new(format!("{}: ignore-level: no level is called '{name}'", file.display())));
    }
    let settings = Settings { options, cell: None };
    let maps: Vec<Map> = drawn.iter().map(|(_, map)| map.clone()).collect();
    let bundle = match bake::bake(&maps, &settings) {
        Ok(bundle) if failed.is_empty() => bundle,
        result => {
            failed.extend(refused(&drawn, &settings));
            // Together they can have too many kinds of tiles, even if each alone has not.
            failed.extend(result.err().filter(|_| failed.is_empty()));
            // Grouped by file: each line begins with its path.
            failed.sort_by_key(Fail::to_string);
            return Err(Failed(failed.iter().map(|fail| Fail::new(in_file(&fail.to_string()))).collect()));
        }
    };
    if let Some(fail) = hollow(&drawn, &bundle, &settings) {
        return Err(Fail::new(in_file(&fail.to_string())).into());
    }
    let baked: Vec<&(PathBuf, Map)> =
        drawn.iter().filter(|(_, map)| !listed(&settings.options.ignored_levels, &map.name)).collect();
    if let Some(both) = collision(&baked) {
        return Err(both.into());
    }
    let name = names::modules([from.file_name().unwrap_or_default().to_string_lossy().as_ref()].into_iter()).concat();
    let text = format!(
        "/// Baked levels.\npub mod {name} {{\n\
         #![allow(dead_code, reason = \"there may be more than is needed\")]\n\
         #![allow(unreachable_pub, reason = \"a level is a module of a program\")]\n\
         #![allow(clippy::unreadable_literal, reason = \"raw coordinates\")]\n\n{}}}\n",
        source::several(&bundle)
    );
    let mut outputs = Outputs::default();
    outputs.add(out.to_owned(), text.into_bytes());
    outputs.write(&read)?;
    let mut warnings = renamed(&baked, &source::modules(&bundle), &name);
    warnings.extend(self::warnings(&bundle, &drawn, &settings.options));
    Ok(Folder { files: read, warnings })
}

/// Two files whose levels would be one module: a new file would take over the name of an old one.
fn collision(baked: &[&(PathBuf, Map)]) -> Option<Fail> {
    let mut seen: HashMap<String, &Path> = HashMap::new();
    for (file, map) in baked {
        let module = names::module(&map.name);
        let known = seen.get(&module).copied().filter(|known| known != file);
        if let Some(known) = known {
            return Some(Fail::new(format!(
                "{} and {}: both would be the module {module}; rename one of them",
                known.display(),
                file.display()
            )));
        }
        seen.insert(module, file);
    }
    None
}

/// A warning about each level whose module has another name than the level.
fn renamed(baked: &[&(PathBuf, Map)], modules: &[String], folder: &str) -> Vec<String> {
    let line = |((file, map), module): (&&(PathBuf, Map), &String)| {
        (names::plain(&map.name) != *module).then(|| {
            format!(
                "{}: its module is {folder}::{module}, because '{}' is no free name of a module; rename the level",
                file.display(),
                map.name
            )
        })
    };
    baked.iter().zip(modules).filter_map(line).collect()
}

/// The warnings about each level, and about flags that no level can keep.
fn warnings(bundle: &Bundle, drawn: &[(PathBuf, Map)], options: &Options) -> Vec<String> {
    let baked = drawn.iter().filter(|(_, map)| !listed(&options.ignored_levels, &map.name));
    let mut lines = Vec::new();
    for (level, (file, map)) in bundle.levels.iter().zip(baked) {
        let level = level.surprises().into_iter();
        let line = |line: String| format!("{}: {}{}", file.display(), title(drawn, file, map), in_file(&line));
        lines.extend(level.map(line));
    }
    let flag = |name: &String| format!("the flag {name} is dropped: tiles have at most eight, and `flag` names others");
    lines.extend(bundle.dropped.iter().map(flag));
    lines
}

/// Names the level, if its file has several.
fn title(drawn: &[(PathBuf, Map)], file: &Path, map: &Map) -> String {
    let several = drawn.iter().filter(|(other, _)| other == file).count() > 1;
    if several { format!("level '{}': ", map.name) } else { String::new() }
}

/// The message about the first file with levels, and nothing solid in any of them.
fn hollow(drawn: &[(PathBuf, Map)], bundle: &Bundle, settings: &Settings) -> Option<Fail> {
    let baked = drawn.iter().filter(|(_, map)| !listed(&settings.options.ignored_levels, &map.name));
    let levels: Vec<(&PathBuf, &Baked)> = baked.map(|(file, _)| file).zip(&bundle.levels).collect();
    let solid: HashSet<&PathBuf> = levels.iter().filter(|(_, level)| level.is_solid()).map(|(file, _)| *file).collect();
    let (file, _) = levels.iter().find(|(file, level)| level.ground.is_hollow() && !solid.contains(file))?;
    let maps: Vec<Map> = drawn.iter().filter(|(other, _)| other == *file).map(|(_, map)| map.clone()).collect();
    bake::bake(&maps, settings).err().map(|fail| Fail::new(format!("{}: {fail}", file.display())))
}

/// The message about each refused level.
fn refused(drawn: &[(PathBuf, Map)], settings: &Settings) -> Vec<Fail> {
    let alone = |(file, map): &(PathBuf, Map)| {
        let title = title(drawn, file, map);
        // A level of a project can have nothing solid.
        let options = Options { bare: !title.is_empty(), ..settings.options.clone() };
        let fail = bake::bake(std::slice::from_ref(map), &Settings { options, cell: settings.cell }).err()?;
        Some(Fail::new(format!("{}: {title}{fail}", file.display())))
    };
    drawn.iter().filter_map(alone).collect()
}

/// The level files of a folder: worlds, which list others, then the rest, each sorted by name.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Failed> {
    let of_folder = |e: std::io::Error| Fail::new(format!("cannot read the folder {}: {e}", folder.display()));
    let entries: Result<Vec<_>, _> = fs::read_dir(folder).map_err(of_folder)?.collect();
    let paths = entries.map_err(of_folder)?.into_iter().map(|entry| entry.path());
    let known = |path: &PathBuf| path.extension().and_then(OsStr::to_str).is_some_and(|end| ENDS.contains(&end));
    let mut files: Vec<PathBuf> = paths.filter(known).collect();
    files.sort_by_key(|file| (!is_world(file), file.clone()));
    if files.is_empty() {
        return Err(
            Fail::new(format!("{} has no level: no file ends in .{}", folder.display(), ENDS.join(", ."))).into()
        );
    }
    Ok(files)
}

fn is_world(file: &Path) -> bool {
    file.extension().is_some_and(|end| end == "world")
}

/// The extensions of level files.
const ENDS: [&str; 4] = ["tmx", "tmj", "world", "ldtk"];
