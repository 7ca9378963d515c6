//! The content of an `LDtk` file, as far as it is used.

use serde::{Deserialize, Deserializer};

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Project {
    #[serde(rename = "jsonVersion")]
    pub(super) version: Option<String>,
    pub(super) defs: Definitions,
    #[serde(rename = "worldLayout")]
    pub(super) layout: Option<String>,
    pub(super) levels: Option<Vec<Level>>,
    pub(super) worlds: Vec<World>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct World {
    pub(super) identifier: String,
    #[serde(rename = "worldLayout")]
    pub(super) layout: Option<String>,
    pub(super) levels: Vec<Level>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Definitions {
    pub(super) layers: Vec<LayerDefinition>,
    pub(super) tilesets: Vec<Tileset>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct LayerDefinition {
    pub(super) uid: i64,
    #[serde(rename = "parallaxFactorX")]
    pub(super) parallax_x: f64,
    #[serde(rename = "parallaxFactorY")]
    pub(super) parallax_y: f64,
    #[serde(rename = "tilePivotX")]
    pub(super) pivot_x: f64,
    #[serde(rename = "tilePivotY")]
    pub(super) pivot_y: f64,
    #[serde(rename = "intGridValues")]
    pub(super) values: Vec<Named>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Named {
    /// 0 before 0.8: values have the numbers of their positions.
    pub(super) value: i64,
    pub(super) identifier: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Tileset {
    pub(super) uid: i64,
    pub(super) identifier: String,
    pub(super) rel_path: Option<String>,
    pub(super) px_wid: u32,
    pub(super) px_hei: u32,
    pub(super) tile_grid_size: u32,
    pub(super) spacing: u32,
    pub(super) padding: u32,
    pub(super) enum_tags: Vec<EnumTag>,
}

/// Tiles with a value of an enumeration.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct EnumTag {
    pub(super) enum_value_id: String,
    pub(super) tile_ids: Vec<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Level {
    pub(super) identifier: String,
    pub(super) world_x: i32,
    pub(super) world_y: i32,
    pub(super) world_depth: i32,
    pub(super) px_wid: u32,
    pub(super) px_hei: u32,
    /// The file of the layers, if they are not here.
    pub(super) external_rel_path: Option<String>,
    pub(super) field_instances: Vec<Field>,
    pub(super) layer_instances: Option<Vec<Layer>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Layer {
    #[serde(rename = "__type")]
    pub(super) form: String,
    pub(super) visible: Option<bool>,
    #[serde(rename = "__opacity")]
    pub(super) opacity: Option<f64>,
    #[serde(rename = "__identifier")]
    pub(super) name: String,
    #[serde(rename = "__cWid")]
    pub(super) width: Count,
    #[serde(rename = "__cHei")]
    pub(super) height: Count,
    #[serde(rename = "__gridSize")]
    pub(super) tile: Count,
    #[serde(rename = "__pxTotalOffsetX")]
    pub(super) x: i32,
    #[serde(rename = "__pxTotalOffsetY")]
    pub(super) y: i32,
    #[serde(rename = "__tilesetDefUid")]
    pub(super) tileset: Option<i64>,
    #[serde(rename = "layerDefUid")]
    pub(super) definition: i64,
    #[serde(rename = "intGridCsv")]
    pub(super) values: Vec<i32>,
    /// Before 0.8, only the cells with a value.
    #[serde(rename = "intGrid")]
    pub(super) sparse: Option<Vec<Cell>>,
    #[serde(rename = "gridTiles")]
    pub(super) tiles: Vec<Tile>,
    #[serde(rename = "autoLayerTiles")]
    pub(super) auto: Vec<Tile>,
    #[serde(rename = "entityInstances")]
    pub(super) entities: Vec<Entity>,
}

/// A cell by its number, and its value: the first one is 0.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Cell {
    pub(super) coord_id: usize,
    pub(super) v: i32,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Tile {
    /// Within the layer.
    pub(super) px: (i32, i32),
    /// Bit 0 flips left and right, bit 1 flips top and bottom.
    pub(super) f: u8,
    /// Its id. Before 0.6 it was in another member.
    pub(super) t: Option<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Entity {
    pub(super) iid: String,
    #[serde(rename = "__identifier")]
    pub(super) name: String,
    #[serde(rename = "__tags")]
    pub(super) tags: Vec<String>,
    #[serde(rename = "__pivot")]
    pub(super) pivot: (f64, f64),
    pub(super) px: (i32, i32),
    pub(super) width: u32,
    pub(super) height: u32,
    #[serde(rename = "fieldInstances")]
    pub(super) fields: Vec<Field>,
}

/// A field of an entity.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Field {
    #[serde(rename = "__identifier")]
    pub(super) name: String,
    #[serde(rename = "__type")]
    pub(super) form: String,
    #[serde(rename = "__value")]
    pub(super) value: serde_json::Value,
}

/// A number that is not negative, or the text there instead.
#[derive(Debug, Default)]
pub(super) struct Count(pub(super) u64, pub(super) Option<String>);

impl<'de> Deserialize<'de> for Count {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let value = serde_json::Value::deserialize(from)?;
        Ok(value.as_u64().map_or_else(|| Self(0, Some(value.to_string())), |count| Self(count, None)))
    }
}
