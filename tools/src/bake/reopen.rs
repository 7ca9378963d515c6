//! Reads levels from the baker's output: Rust source, or bytes with the source beside them.

use std::path::{Path, PathBuf};

use tilesat::{Fx, PathKind, TileKind, TileShape, Vec2};

use super::level::Level;
use super::segments::Shapes;
use crate::fail::{Fail, Result};
use crate::read;

/// A level as in a firmware.
#[derive(Debug, Clone)]
pub struct Reopened {
    /// Its module, if there are several.
    pub name: String,
    pub tiles: Option<Level>,
    /// The bytes of a segment map.
    pub segments: Option<Vec<u8>>,
    /// Those that are not solid.
    pub objects: Vec<Entry>,
}

/// An object in the source.
#[derive(Debug, Clone)]
pub struct Entry {
    pub id: u32,
    pub class: String,
    pub name: String,
    /// Its smallest and its largest corner, raw.
    pub area: [(i64, i64); 2],
}

type Made<T> = std::result::Result<T, String>;

/// Whether a file may come from the baker.
pub fn is_baked(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == "rs" || end == "bin")
}

/// The levels of a file.
///
/// # Errors
///
/// If the baker does not write such a file.
pub fn reopen(path: &Path) -> Result<Vec<Reopened>> {
    let (source, text) = if path.extension().is_some_and(|end| end == "bin") {
        beside(path)?
    } else {
        (path.to_owned(), read::text(path)?)
    };
    let of_file = |why: String| Fail::new(format!("{}: {why}", source.display()));
    let mut parts: Vec<(String, Vec<&str>)> = vec![(String::new(), Vec::new())];
    for line in text.lines().map(str::trim) {
        let module = line.strip_prefix("pub mod ").and_then(|rest| rest.strip_suffix(" {"));
        if let Some(name) = module {
            parts.push((name.to_owned(), Vec::new()));
        } else if let Some((_, lines)) = parts.last_mut() {
            lines.push(line);
        }
    }
    // The text before the modules belongs to all of them.
    let shared = if parts.len() > 1 { parts.remove(0).1 } else { Vec::new() };
    let folder = source.parent().unwrap_or(Path::new(""));
    let read = parts.iter().map(|(name, lines)| level(name, &shared, lines, folder).map_err(of_file));
    let levels = read.collect::<Result<Vec<_>>>()?;
    if levels.iter().all(|level| level.tiles.is_none() && level.segments.is_none()) {
        return Err(of_file("it is not a level from tilesat bake: give the file that bake wrote".to_owned()));
    }
    Ok(levels)
}

/// The source beside `OUT.bin`, `OUT.tiles.bin` or `OUT.segments.bin`, and its text. A source of
/// another name counts if it includes the file.
fn beside(path: &Path) -> Result<(PathBuf, String)> {
    let stem = path.with_extension("");
    let whole =
        stem.extension().filter(|part| *part == "tiles" || *part == "segments").map(|_| stem.with_extension(""));
    let include = format!("include_bytes!({:?})", path.file_name().unwrap_or_default().to_string_lossy());
    for stem in [Some(stem), whole].into_iter().flatten() {
        let name = stem.file_name().unwrap_or_default().to_string_lossy().into_owned();
        for (end, is_own) in [("bin.rs", true), ("rs", false)] {
            let place = stem.with_file_name(format!("{name}.{end}"));
            if !place.is_file() {
                continue;
            }
            let text = read::text(&place)?;
            if is_own || text.contains(&include) {
                return Ok((place, text));
            }
        }
    }
    Err(Fail::new(format!(
        "{}: the file of the same name in .bin.rs, which describes the bytes, is missing: keep both in one folder",
        path.display()
    )))
}

fn level(name: &str, shared: &[&str], lines: &[&str], folder: &Path) -> Made<Reopened> {
    let both = || shared.iter().chain(lines).copied();
    let number = |name: &str| constant(lines, name);
    let mut tiles = None;
    if let (Some(width), Some(height), Some(tile)) = (number("WIDTH: u16"), number("HEIGHT: u16"), number("TILE: u16"))
    {
        let bytes = bytes(lines, "pub static TILES: ", folder)?.ok_or("its TILES are missing: bake the level again")?;
        let mut ids = vec![TileKind::EMPTY];
        for (id, kind) in both().filter_map(kind) {
            if id != ids.len() {
                return Err("its table of kinds was changed: bake the level again".to_owned());
            }
            ids.push(kind);
        }
        let known = bytes.iter().all(|id| usize::from(*id) < ids.len());
        if !known || bytes.len() != usize::from(width) * usize::from(height) {
            return Err(format!("its {} tiles do not fit {width}x{height} cells: bake the level again", bytes.len()));
        }
        let flags = both()
            .filter_map(|line| line.strip_prefix("pub const ")?.split_once(": u8 = "))
            .map(|(name, _)| name.trim_start_matches("FLAG_").to_owned());
        let origin = lines
            .iter()
            .filter(|line| line.contains("Grid::new("))
            .find_map(|line| pair(line.split_once("Vec2::from_raw(")?.1));
        tiles = Some(Level {
            layer: if name.is_empty() { "tiles".to_owned() } else { name.to_owned() },
            width,
            height,
            tile,
            origin: origin.unwrap_or((0, 0)),
            tiles: bytes,
            ids,
            flags: flags.collect(),
        });
    }
    let segments = match bytes(lines, "pub static SEGMENTS: ", folder)? {
        Some(bytes) => Some(bytes),
        None => paths(lines)?,
    };
    let objects = lines.iter().filter_map(|line| entry(line)).collect();
    Ok(Reopened { name: name.to_owned(), tiles, segments, objects })
}

/// `Object { id: 1, class: "", name: "spawn", area: area(0, 0, 0, 0), points: ..`. Texts with
/// escapes stay as they are.
fn entry(line: &str) -> Option<Entry> {
    let (id, rest) = line.strip_prefix("Object { id: ")?.split_once(", class: \"")?;
    let (class, rest) = rest.split_once("\", name: \"")?;
    let (name, rest) = rest.split_once("\", area: area(")?;
    let sides: Vec<i64> = rest.split(')').next()?.split(", ").filter_map(|side| side.parse().ok()).collect();
    let [x, y, right, bottom] = sides[..] else { return None };
    let (class, name) = (class.to_owned(), name.to_owned());
    Some(Entry { id: id.parse().ok()?, class, name, area: [(x, y), (right, bottom)] })
}

fn constant(lines: &[&str], name: &str) -> Option<u16> {
    let start = format!("pub const {name} = ");
    lines.iter().find_map(|line| line.strip_prefix(&start)?.strip_suffix(';')?.parse().ok())
}

/// `.with(3, TileKind::of(TileShape::HalfTop).with_flags(2))`
fn kind(line: &str) -> Option<(usize, TileKind)> {
    let (id, rest) = line.strip_prefix(".with(")?.split_once(", TileKind::")?;
    let named = |shape: &TileShape| rest.starts_with(&format!("of(TileShape::{shape:?})"));
    let shape = match rest {
        _ if rest.starts_with("EMPTY") => TileShape::Empty,
        _ if rest.starts_with("FULL") => TileShape::Full,
        _ if rest.starts_with("ONE_WAY_UP") => TileShape::OneWayUp,
        _ => TileShape::ALL.into_iter().find(named)?,
    };
    let flags = rest.split_once(".with_flags(").and_then(|(_, flags)| flags.split(')').next()?.parse().ok());
    Some((id.parse().ok()?, TileKind::of(shape).with_flags(flags.unwrap_or(0))))
}

/// `1, 2)` and the text after it.
fn pair(text: &str) -> Option<(i32, i32)> {
    let (x, y) = text.split(')').next()?.split_once(", ")?;
    Some((x.parse().ok()?, y.parse().ok()?))
}

/// The bytes of an item, in the source or in a file beside it.
fn bytes(lines: &[&str], item: &str, folder: &Path) -> Made<Option<Vec<u8>>> {
    let Some(start) = lines.iter().position(|line| line.starts_with(item)) else { return Ok(None) };
    let first = lines[start];
    if let Some((_, rest)) = first.split_once("include_bytes!(\"") {
        let path = folder.join(rest.split('"').next().unwrap_or_default());
        return read::bytes(&path).map(Some).map_err(|fail| fail.to_string());
    }
    if !first.ends_with("b\"\\") {
        return Ok(None);
    }
    let mut bytes = Vec::new();
    for line in lines[start + 1..].iter().take_while(|line| !line.starts_with('"')) {
        for byte in line.trim_end_matches('\\').split("\\x").skip(1) {
            bytes.push(u8::from_str_radix(byte, 16).map_err(|_| format!("'{byte}' is no byte"))?);
        }
    }
    Ok(Some(bytes))
}

/// The points and paths of a map that the compiler builds.
fn paths(lines: &[&str]) -> Made<Option<Vec<u8>>> {
    let mut shapes = Shapes { points: Vec::new(), kinds: Vec::new() };
    let mut cell = None;
    for line in lines {
        if line.starts_with("const POINTS_") {
            shapes.points.push(Vec::new());
        } else if let (Some((x, y)), Some(points)) =
            (line.strip_prefix("Vec2::from_ints(").and_then(pair), shapes.points.last_mut())
        {
            let whole =
                |v: i32| i16::try_from(v).map_err(|_| format!("{v} is beyond the domain: bake the level again"));
            points.push(Vec2::from_ints(whole(x)?, whole(y)?));
        } else if let (Some((x, y)), Some(points)) =
            (line.strip_prefix("Vec2::from_raw(").and_then(pair), shapes.points.last_mut())
        {
            points.push(Vec2::from_raw(x, y));
        } else if let Some(rest) = line.strip_prefix("Path::new(PathKind::") {
            let kinds = [
                ("Solid", PathKind::Solid),
                ("Hole", PathKind::Hole),
                ("Wall", PathKind::Wall),
                ("OneWay", PathKind::OneWay),
            ];
            let kind = kinds
                .iter()
                .find(|(name, _)| rest.starts_with(name))
                .ok_or("it has a path of an unknown kind: bake the level again")?;
            let flags = rest.split_once(".with_flags(").and_then(|(_, flags)| flags.split(')').next()?.parse().ok());
            shapes.kinds.push((kind.1, flags.unwrap_or(0)));
        } else if let Some(rest) = line.strip_prefix("Fx::lit(\"") {
            cell = rest.split('"').next().and_then(|text| text.parse::<Fx>().ok());
        }
    }
    if shapes.kinds.is_empty() {
        return Ok(None);
    }
    if shapes.kinds.len() != shapes.points.len() {
        return Err("it has points without a path: bake the level again".to_owned());
    }
    let cell = cell.ok_or("it has segments without a side of cells: bake the level again")?;
    shapes.build(&[], cell).map(Some).map_err(|fail| fail.to_string())
}
