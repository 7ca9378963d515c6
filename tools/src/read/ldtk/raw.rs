//! The content of an `LDtk` file, as far as it is used.

use serde::{Deserialize, Deserializer};

use crate::read::lax;

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Project {
    #[serde(rename = "jsonVersion")]
    pub(super) version: Option<String>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) defs: Definitions,
    #[serde(rename = "worldLayout")]
    pub(super) layout: Option<String>,
    pub(super) levels: Option<Vec<Level>>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) worlds: Vec<World>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct World {
    #[serde(deserialize_with = "lax::given")]
    pub(super) identifier: String,
    #[serde(rename = "worldLayout")]
    pub(super) layout: Option<String>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) levels: Vec<Level>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Definitions {
    #[serde(deserialize_with = "lax::given")]
    pub(super) layers: Vec<LayerDefinition>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) tilesets: Vec<Tileset>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct LayerDefinition {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) uid: i64,
    #[serde(rename = "parallaxFactorX")]
    pub(super) parallax_x: f64,
    #[serde(rename = "parallaxFactorY")]
    pub(super) parallax_y: f64,
    #[serde(rename = "tilePivotX")]
    pub(super) pivot_x: f64,
    #[serde(rename = "tilePivotY")]
    pub(super) pivot_y: f64,
    #[serde(rename = "intGridValues", deserialize_with = "lax::given")]
    pub(super) values: Vec<Named>,
    #[serde(rename = "intGridValuesGroups", deserialize_with = "lax::given")]
    pub(super) groups: Vec<Group>,
}

/// A group of values.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Group {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) uid: i64,
    pub(super) identifier: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Named {
    /// 0 before 0.8: values have the numbers of their positions.
    #[serde(deserialize_with = "lax::whole")]
    pub(super) value: i64,
    pub(super) identifier: Option<String>,
    /// 0 for none.
    #[serde(rename = "groupUid", deserialize_with = "lax::whole")]
    pub(super) group: i64,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Tileset {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) uid: i64,
    #[serde(deserialize_with = "lax::given")]
    pub(super) identifier: String,
    pub(super) rel_path: Option<String>,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) px_wid: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) px_hei: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) tile_grid_size: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) spacing: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) padding: u32,
    #[serde(deserialize_with = "lax::given")]
    pub(super) enum_tags: Vec<EnumTag>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) custom_data: Vec<CustomData>,
}

/// A text of a tile.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct CustomData {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) tile_id: u32,
    #[serde(deserialize_with = "lax::given")]
    pub(super) data: String,
}

/// Tiles with a value of an enumeration.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct EnumTag {
    #[serde(deserialize_with = "lax::given")]
    pub(super) enum_value_id: String,
    #[serde(deserialize_with = "lax::wholes")]
    pub(super) tile_ids: Vec<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Level {
    #[serde(deserialize_with = "lax::given")]
    pub(super) identifier: String,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) world_x: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) world_y: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) world_depth: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) px_wid: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) px_hei: u32,
    /// The file of the layers, if they are not here.
    pub(super) external_rel_path: Option<String>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) field_instances: Vec<Field>,
    pub(super) layer_instances: Option<Vec<Layer>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Layer {
    #[serde(rename = "__type", deserialize_with = "lax::given")]
    pub(super) form: String,
    pub(super) visible: Option<bool>,
    #[serde(rename = "__opacity")]
    pub(super) opacity: Option<f64>,
    #[serde(rename = "__identifier", deserialize_with = "lax::given")]
    pub(super) name: String,
    #[serde(rename = "__cWid")]
    pub(super) width: Count,
    #[serde(rename = "__cHei")]
    pub(super) height: Count,
    #[serde(rename = "__gridSize")]
    pub(super) tile: Count,
    #[serde(rename = "__pxTotalOffsetX", deserialize_with = "lax::whole")]
    pub(super) x: i32,
    #[serde(rename = "__pxTotalOffsetY", deserialize_with = "lax::whole")]
    pub(super) y: i32,
    #[serde(rename = "__tilesetDefUid", deserialize_with = "lax::count")]
    pub(super) tileset: Option<i64>,
    #[serde(rename = "layerDefUid", deserialize_with = "lax::whole")]
    pub(super) definition: i64,
    #[serde(rename = "intGridCsv", deserialize_with = "lax::wholes")]
    pub(super) values: Vec<i32>,
    /// Before 0.8, only the cells with a value.
    #[serde(rename = "intGrid")]
    pub(super) sparse: Option<Vec<Cell>>,
    #[serde(rename = "gridTiles", deserialize_with = "lax::given")]
    pub(super) tiles: Vec<Tile>,
    #[serde(rename = "autoLayerTiles", deserialize_with = "lax::given")]
    pub(super) auto: Vec<Tile>,
    #[serde(rename = "entityInstances", deserialize_with = "lax::given")]
    pub(super) entities: Vec<Entity>,
}

/// A cell by its number, and its value: the first one is 0.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Cell {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) coord_id: usize,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) v: i32,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Tile {
    /// Within the layer.
    #[serde(deserialize_with = "lax::pair")]
    pub(super) px: (i32, i32),
    /// Bit 0 flips left and right, bit 1 flips top and bottom.
    #[serde(deserialize_with = "lax::whole")]
    pub(super) f: u8,
    /// Its id. Before 0.6 it was in another member.
    #[serde(deserialize_with = "lax::count")]
    pub(super) t: Option<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Entity {
    #[serde(deserialize_with = "lax::given")]
    pub(super) iid: String,
    #[serde(rename = "__identifier", deserialize_with = "lax::given")]
    pub(super) name: String,
    #[serde(rename = "__tags", deserialize_with = "lax::given")]
    pub(super) tags: Vec<String>,
    #[serde(rename = "__pivot")]
    pub(super) pivot: (f64, f64),
    #[serde(deserialize_with = "lax::pair")]
    pub(super) px: (i32, i32),
    #[serde(deserialize_with = "lax::whole")]
    pub(super) width: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) height: u32,
    #[serde(rename = "fieldInstances", deserialize_with = "lax::given")]
    pub(super) fields: Vec<Field>,
}

/// A field of an entity.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Field {
    #[serde(rename = "__identifier", deserialize_with = "lax::given")]
    pub(super) name: String,
    #[serde(rename = "__type", deserialize_with = "lax::given")]
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
        // Some programs write whole numbers as decimals.
        let whole = value.as_f64().filter(|number| number.fract() == 0.0 && (0.0..1e9).contains(number));
        let count = value.as_u64().or(whole.map(|number| number as u64));
        Ok(count.map_or_else(|| Self(0, Some(value.to_string())), |count| Self(count, None)))
    }
}
