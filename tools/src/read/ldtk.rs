//! The `IntGrid` layers of an `LDtk` level. What a value means stands in its identifier; 0 is nothing.

use std::collections::HashMap;
use std::path::Path;

use serde_json::Value;

use super::drawing::{DOMAIN, TileLayer, TileLayers};
use super::file;
use crate::rules::identifier::meaning;
use crate::rules::traits::Traits;

type Result<T> = std::result::Result<T, String>;

/// A value of a list takes 2 bytes in the file and 32 in memory.
const MAX_BYTES: usize = 16 << 20;

/// Reads the level of this name, or the first; `folder` is where levels in files of their own are.
pub(crate) fn read(bytes: &[u8], level: Option<&str>, folder: &Path) -> Result<TileLayers> {
    let project = parse(bytes)?;
    let mut levels: Vec<&Value> = list(&project, "levels").iter().collect();
    levels.extend(list(&project, "worlds").iter().flat_map(|world| list(world, "levels")));
    let title = |level: &Value| text(level, "identifier").unwrap_or("?").to_owned();
    let chosen = match level {
        None => levels.first().ok_or("not an LDtk project: it has no levels")?,
        Some(name) => levels.iter().find(|level| title(level) == name).ok_or_else(|| {
            let names: Vec<String> = levels.iter().map(|level| title(level)).collect();
            format!("no level '{name}'; there are: {}", names.join(", "))
        })?,
    };
    let file = text(chosen, "externalRelPath").filter(|_| chosen["layerInstances"].is_null());
    let apart = file.map(|file| outside(&folder.join(file))).transpose()?;
    let within = |why: String| format!("level '{}': {why}", title(chosen));
    layers(&project, apart.as_ref().unwrap_or(chosen)).map_err(within)
}

fn outside(file: &Path) -> Result<Value> {
    file::bytes(file)
        .map_err(|e| file::why(&e))
        .and_then(|bytes| parse(&bytes))
        .map_err(|why| format!("{}: {why}", file.display()))
}

fn parse(bytes: &[u8]) -> Result<Value> {
    if bytes.len() > MAX_BYTES {
        return Err(format!("larger than {} MiB", MAX_BYTES >> 20));
    }
    serde_json::from_slice(bytes).map_err(|e| format!("not JSON: {e}"))
}

fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value[name].as_array().map(Vec::as_slice).unwrap_or_default()
}

fn text<'a>(value: &'a Value, name: &str) -> Option<&'a str> {
    value[name].as_str()
}

fn number(value: &Value, name: &str) -> Result<u64> {
    value[name].as_u64().ok_or_else(|| format!("{name} is {}, not a count", value[name]))
}

fn layers(project: &Value, level: &Value) -> Result<TileLayers> {
    let mut drawn = TileLayers { tile: 0, layers: Vec::new(), palette: vec![Traits::default()] };
    // LDtk lists the uppermost layer first.
    for layer in list(level, "layerInstances").iter().rev() {
        if text(layer, "__type") == Some("IntGrid") {
            let name = text(layer, "__identifier").unwrap_or("?");
            let read = read_layer(project, layer, name, &mut drawn).map_err(|why| format!("layer '{name}': {why}"))?;
            drawn.layers.push(read);
        }
    }
    if drawn.layers.is_empty() {
        return Err("it has no IntGrid layer".to_owned());
    }
    Ok(drawn)
}

fn read_layer(project: &Value, layer: &Value, name: &str, drawn: &mut TileLayers) -> Result<TileLayer> {
    let (width, height) = (number(layer, "__cWid")?, number(layer, "__cHei")?);
    let tile = number(layer, "__gridSize")?;
    if !(1..=256).contains(&tile) {
        return Err(format!("cells of {tile} pixels; the library takes 1 to 256"));
    }
    if drawn.tile != 0 && u64::from(drawn.tile) != tile {
        return Err(format!("cells of {tile} pixels, and those of another layer are {}", drawn.tile));
    }
    if width.max(height) >= DOMAIN.div_ceil(tile) {
        return Err(format!(
            "{width}x{height} cells are beyond the domain: a side must be shorter than {DOMAIN} pixels"
        ));
    }
    if layer["__pxTotalOffsetX"].as_i64().unwrap_or(0) != 0 || layer["__pxTotalOffsetY"].as_i64().unwrap_or(0) != 0 {
        return Err("it is drawn with an offset".to_owned());
    }
    let values = list(layer, "intGridCsv");
    if values.len() as u64 != width * height {
        return Err(format!("{} values for {width}x{height} cells", values.len()));
    }
    let names = identifiers(project, layer)?;
    let mut seen = HashMap::from([(0, 0)]);
    let mut cells = Vec::with_capacity(values.len());
    for value in values {
        let value = value.as_i64().ok_or_else(|| format!("the value {value} is not whole"))?;
        if let Some(&known) = seen.get(&value) {
            cells.push(known);
            continue;
        }
        let named = names.get(&value).ok_or_else(|| format!("value {value} is not in the layer's list"))?;
        let name = named.as_ref().ok_or_else(|| format!("value {value} has no identifier"))?;
        let entry = drawn.palette.len() as u32;
        drawn.palette.push(meaning(name).map_err(|why| format!("value {value}: {why}"))?);
        seen.insert(value, entry);
        cells.push(entry);
    }
    drawn.tile = tile as u16;
    Ok(TileLayer { name: name.to_owned(), width: width as u16, height: height as u16, cells })
}

/// What the project calls each value of a layer.
fn identifiers(project: &Value, layer: &Value) -> Result<HashMap<i64, Option<String>>> {
    let uid = number(layer, "layerDefUid")?;
    let mut definitions = list(&project["defs"], "layers").iter();
    let definition = definitions
        .find(|definition| definition["uid"].as_u64() == Some(uid))
        .ok_or_else(|| format!("defs.layers has no uid {uid}"))?;
    let mut names = HashMap::new();
    for value in list(definition, "intGridValues") {
        let number = value["value"].as_i64().ok_or_else(|| format!("intGridValues has {}", value["value"]))?;
        names.insert(number, text(value, "identifier").filter(|name| !name.is_empty()).map(str::to_owned));
    }
    Ok(names)
}
