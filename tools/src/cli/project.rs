//! `tilesat.toml` beside the levels: settings that a project gives once for all of them.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use tilesat::TileShape;

use super::input::{scale, solid};
use crate::fail::{Fail, Result};
use crate::read;
use crate::rules::options::Options;

const NAME: &str = "tilesat.toml";

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
    #[serde(alias = "ignore_layer")]
    ignore_layer: Vec<String>,
    objects: Vec<String>,
    #[serde(alias = "ignore_level")]
    ignore_level: Vec<String>,
    layer: Option<String>,
    scale: Option<String>,
}

/// The options in the file beside a level, and the file if it exists.
///
/// # Errors
///
/// One line that names the file and the unknown entry.
pub(super) fn beside(level: &Path) -> Result<(Options, Option<PathBuf>)> {
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
        ignored_layers: file.ignore_layer,
        objects: file.objects,
        ignored_levels: file.ignore_level,
        layer: file.layer,
        scale: file.scale.map(|text| scale(&text).map_err(|why| format!("scale: {why}"))).transpose()?,
        rooms: false,
    })
}
