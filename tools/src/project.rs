//! The levels of a file, with the settings of `tilesat.toml` beside it. A project gives them once
//! for all of its levels.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use tilesat::TileShape;

use crate::fail::{Fail, Result};
use crate::model::decimal::Decimal;
use crate::model::map::{Content, Placed};
use crate::read::{self, Levels};
use crate::rules::names;
use crate::rules::options::Options;

pub(crate) const NAME: &str = "tilesat.toml";

#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
struct File {
    solid: Vec<String>,
    #[serde(alias = "one_way")]
    one_way: Vec<String>,
    empty: Vec<String>,
    flag: Vec<String>,
    #[serde(alias = "solid_layer")]
    solid_layer: Vec<String>,
    #[serde(alias = "one_way_layer")]
    one_way_layer: Vec<String>,
    #[serde(alias = "ignore_layer")]
    ignore_layer: Vec<String>,
    #[serde(alias = "no_guess")]
    no_guess: Vec<String>,
    objects: Vec<String>,
    #[serde(alias = "ignore_level")]
    ignore_level: Vec<String>,
    layer: Option<String>,
    scale: Option<String>,
    weld: Option<String>,
}

/// The levels of a file. The user's options take precedence over those of the project file.
///
/// # Errors
///
/// One line that names the file, and the layer or name of the user's options that no level has.
pub(crate) fn load(path: &Path, level: Option<&str>, own: Options) -> Result<(Levels, Options)> {
    let (options, file) = beside(path)?;
    // A skipped level may be one that the tools cannot read.
    let skipped: Vec<String> = options.ignored_levels.iter().chain(&own.ignored_levels).cloned().collect();
    let mut levels = read::except(path, level, &skipped)?;
    levels.files.extend(file);
    // The project file may name things that a level does not contain.
    unknown(&levels, &own).map_err(|why| Fail::new(format!("{}: {why}", path.display())))?;
    Ok((levels, options.then(own)))
}

/// The options in the file beside a level, and the file if it exists.
///
/// # Errors
///
/// One line that names the file and the unknown entry.
fn beside(level: &Path) -> Result<(Options, Option<PathBuf>)> {
    let path = level.with_file_name(NAME);
    if !path.exists() {
        return Ok((Options::default(), None));
    }
    let text = read::text(&path)?;
    let options = options(&text).map_err(|why| Fail::new(format!("{}: {why}", path.display())))?;
    Ok((options, Some(path)))
}

fn options(text: &str) -> std::result::Result<Options, String> {
    let file: File = toml::from_str(text).map_err(|e| e.to_string())?;
    let mut shapes = Vec::new();
    for name in &file.solid {
        shapes.push(solid(name).map_err(|why| format!("solid: {why}"))?);
    }
    shapes.extend(file.one_way.into_iter().map(|name| (name, TileShape::OneWayUp)));
    shapes.extend(file.empty.into_iter().map(|name| (name, TileShape::Empty)));
    Ok(Options {
        shapes,
        flags: file.flag,
        solid_layers: file.solid_layer,
        one_way_layers: file.one_way_layer,
        ignored_layers: file.ignore_layer,
        unguessed_layers: file.no_guess,
        objects: file.objects,
        ignored_levels: file.ignore_level,
        layer: file.layer,
        scale: file.scale.map(|text| scale(&text).map_err(|why| format!("scale: {why}"))).transpose()?,
        weld: file.weld.map(|text| weld(&text).map_err(|why| format!("weld: {why}"))).transpose()?,
        rooms: false,
        bare: false,
    })
}

/// Whether a file has a level of this name, read or skipped.
pub(crate) fn has_level(levels: &Levels, name: &str) -> bool {
    levels.names.iter().any(|known| crate::rules::same(known, name))
}

/// Levels, layers and names of options that no level has. They are probably mistakes.
fn unknown(levels: &Levels, options: &Options) -> std::result::Result<(), String> {
    if let Some(name) = options.ignored_levels.iter().find(|name| !has_level(levels, name)) {
        let all: Vec<&str> = levels.names.iter().map(String::as_str).collect();
        return Err(format!("--ignore-level {name}: there is no such level; there are: {}", shown(&all)));
    }
    let all = || levels.maps.iter().flat_map(|map| &map.layers);
    let layers: Vec<&str> = all().map(|layer| layer.name.as_str()).collect();
    let of_layers = [
        ("--solid-layer", &options.solid_layers),
        ("--one-way-layer", &options.one_way_layers),
        ("--ignore-layer", &options.ignored_layers),
        ("--no-guess", &options.unguessed_layers),
        ("--objects", &options.objects),
    ];
    for (option, name) in of_layers.iter().flat_map(|(option, names)| names.iter().map(move |name| (option, name))) {
        if !layers.iter().any(|layer| crate::rules::same(layer, name)) {
            return Err(format!("{option} {name}: there is no such layer; there are: {}", shown(&layers)));
        }
    }
    let mut names: Vec<&str> = Vec::new();
    for tile in levels.maps.iter().flat_map(|map| &map.tilesets).flat_map(|set| set.tiles.values()) {
        names.extend([tile.class.as_str()].into_iter().chain(tile.properties.marks()).chain(tile.properties.ones()));
    }
    for placed in levels.maps.iter().flat_map(|map| &map.palette) {
        if let Placed::Value { name, group, .. } = placed {
            names.extend([name, group].into_iter().flatten().map(String::as_str));
        }
    }
    for layer in all() {
        if let Content::Objects(objects) = &layer.content {
            names.extend(
                objects.iter().flat_map(|object| [object.class.as_str()].into_iter().chain(object.properties.marks())),
            );
        }
    }
    names.retain(|name| !name.trim().is_empty());
    names.sort_unstable();
    // `TILESET:ID`, `LAYER:VALUE` and a value's number may name an unused tile.
    let is_place = |name: &str| name.contains(':') || name.bytes().all(|b| b.is_ascii_digit());
    let given = options.shapes.iter().map(|(name, _)| name).chain(&options.flags);
    match given.into_iter().find(|name| !is_place(name) && !names.iter().any(|known| crate::rules::same(known, name))) {
        Some(name) if layers.iter().any(|layer| crate::rules::same(layer, name)) => Err(format!(
            "no tile, object or value is called '{name}', but a layer is: add --solid-layer '{name}' or \
             --one-way-layer '{name}'"
        )),
        Some(name) => Err(format!("no tile, object or value is called '{name}'; there are: {}", shown(&names))),
        None => Ok(()),
    }
}

/// Unique names, up to a limit.
fn shown(names: &[&str]) -> String {
    let mut seen: Vec<&str> = Vec::new();
    for name in names {
        if !seen.contains(name) && seen.len() < 20 {
            seen.push(name);
        }
    }
    if seen.is_empty() { "none".to_owned() } else { seen.join(", ") }
}

/// `NAME` or `NAME=SHAPE`.
pub(crate) fn solid(text: &str) -> std::result::Result<(String, TileShape), String> {
    let Some((name, shape)) = text.rsplit_once('=') else { return Ok((text.to_owned(), TileShape::Full)) };
    let known = names::shape(shape.trim()).ok_or_else(|| {
        format!("'{shape}' is not a shape; name one such as slope-bottom-left (see tilesat help rules)")
    })?;
    Ok((name.trim().to_owned(), known))
}

/// Pixels, in raw units.
pub(crate) fn weld(text: &str) -> std::result::Result<i64, String> {
    let raw = Decimal::parse(text.as_bytes()).map(Decimal::raw).filter(|raw| (0..=1 << 16).contains(raw));
    raw.ok_or_else(|| format!("needs pixels from 0 to 1, got {text}"))
}

/// `1/2`, `2` or `0.5`.
pub(crate) fn scale(text: &str) -> std::result::Result<(u32, u32), String> {
    let wrong = || format!("needs a fraction such as 1/2, got {text}");
    let number = |text: &str| text.trim().parse::<u32>().ok().filter(|n| (1..=10_000).contains(n)).ok_or_else(wrong);
    if let Some((n, d)) = text.split_once('/') {
        return Ok((number(n)?, number(d)?));
    }
    match text.trim().split_once('.') {
        None => Ok((number(text)?, 1)),
        Some((whole, digits)) if digits.len() <= 4 => {
            let unit = 10u32.pow(digits.len() as u32);
            let whole = if whole.is_empty() || whole == "0" { 0 } else { number(whole)? };
            let rest: u32 = if digits.is_empty() { 0 } else { digits.parse().map_err(|_| wrong())? };
            Some((whole * unit + rest, unit)).filter(|(n, _)| *n > 0).ok_or_else(wrong)
        }
        Some(_) => Err(wrong()),
    }
}
