//! The content of a Tiled file, XML or JSON, before any lookup or check. JSON is read into it by
//! name.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

pub(super) use super::number::Number;
use super::number::one;
use crate::model::decimal::Decimal;
use crate::model::object::{Own, Spot};
use crate::model::property::{CLASS, LIST, Properties, Value};
use crate::model::tileset::Part;
use crate::read::lax;

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Map {
    #[serde(deserialize_with = "lax::given")]
    pub(super) orientation: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) class: String,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) width: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) height: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) tilewidth: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) tileheight: u32,
    #[serde(deserialize_with = "lax::flag")]
    pub(super) infinite: bool,
    #[serde(deserialize_with = "lax::given")]
    pub(super) tilesets: Vec<Tileset>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) layers: Vec<Layer>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) properties: Listed,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Tileset {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) firstgid: u32,
    pub(super) source: Option<String>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) name: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) class: String,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) tilewidth: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) tileheight: u32,
    #[serde(deserialize_with = "lax::count")]
    pub(super) tilecount: Option<u32>,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) columns: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) margin: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) spacing: u32,
    pub(super) image: Option<String>,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) imagewidth: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) imageheight: u32,
    #[serde(deserialize_with = "lax::given")]
    pub(super) tileoffset: Offset,
    #[serde(deserialize_with = "lax::given")]
    pub(super) tilerendersize: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) fillmode: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) objectalignment: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) tiles: Tiles,
    #[serde(deserialize_with = "lax::given")]
    pub(super) properties: Listed,
    /// Before Tiled 1.2, properties and classes were separate from the tiles.
    #[serde(deserialize_with = "lax::given")]
    pub(super) tileproperties: BTreeMap<u32, Listed>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Offset {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) x: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) y: i32,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Tile {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) id: u32,
    #[serde(deserialize_with = "lax::given")]
    pub(super) class: String,
    /// Its class in the other versions of Tiled. Some programs write both.
    #[serde(rename = "type", deserialize_with = "lax::given")]
    pub(super) kind: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) properties: Listed,
    pub(super) objectgroup: Option<Box<Layer>>,
    pub(super) image: Option<String>,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) imagewidth: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) imageheight: u32,
    /// Since Tiled 1.9 a tile can be a part of its image, at this place and of this size.
    #[serde(deserialize_with = "lax::whole")]
    pub(super) x: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) y: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) width: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) height: u32,
}

impl Tile {
    /// The part of the image: its corner and its size. All of it, if the file does not say.
    pub(super) fn part(&self) -> Part {
        let along = |own: u32, image: u32| if own > 0 { own } else { image };
        Part { at: (self.x, self.y), size: (along(self.width, self.imagewidth), along(self.height, self.imageheight)) }
    }
}

#[derive(Debug, Deserialize)]
#[serde(default)]
pub(super) struct Layer {
    #[serde(rename = "type", deserialize_with = "lax::given")]
    pub(super) form: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) name: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) class: String,
    #[serde(deserialize_with = "lax::shown")]
    pub(super) visible: bool,
    pub(super) offsetx: Number,
    pub(super) offsety: Number,
    #[serde(deserialize_with = "one")]
    pub(super) parallaxx: Number,
    #[serde(deserialize_with = "one")]
    pub(super) parallaxy: Number,
    #[serde(deserialize_with = "one")]
    pub(super) opacity: Number,
    /// In cells. Tiled reads them, and has written 0 for years.
    #[serde(deserialize_with = "lax::whole")]
    pub(super) x: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) y: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) width: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) height: u32,
    pub(super) encoding: Option<String>,
    pub(super) compression: Option<String>,
    pub(super) data: Option<Data>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) chunks: Vec<Chunk>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) objects: Vec<Object>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) layers: Vec<Layer>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) properties: Listed,
}

impl Default for Layer {
    fn default() -> Self {
        let one = Number(Decimal::whole(1));
        Self {
            form: String::new(),
            name: String::new(),
            class: String::new(),
            visible: true,
            offsetx: Number::default(),
            offsety: Number::default(),
            parallaxx: one,
            parallaxy: one,
            opacity: one,
            x: 0,
            y: 0,
            width: 0,
            height: 0,
            encoding: None,
            compression: None,
            data: None,
            chunks: Vec::new(),
            objects: Vec::new(),
            layers: Vec::new(),
            properties: Listed::default(),
        }
    }
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Chunk {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) x: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) y: i32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) width: u32,
    #[serde(deserialize_with = "lax::whole")]
    pub(super) height: u32,
    pub(super) data: Option<Data>,
}

/// Everything that an object of a map sets overrides its template.
#[allow(clippy::struct_excessive_bools, reason = "they stand side by side in the file")]
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub(super) struct Object {
    #[serde(deserialize_with = "lax::whole")]
    pub(super) id: u32,
    pub(super) name: Option<String>,
    pub(super) class: Option<String>,
    /// Its class in the other versions of Tiled. Some programs write both.
    #[serde(rename = "type")]
    pub(super) kind: Option<String>,
    pub(super) x: Number,
    pub(super) y: Number,
    pub(super) width: Option<Number>,
    pub(super) height: Option<Number>,
    pub(super) rotation: Option<Number>,
    #[serde(deserialize_with = "lax::count")]
    pub(super) gid: Option<u32>,
    #[serde(deserialize_with = "lax::perhaps")]
    pub(super) visible: Option<bool>,
    #[serde(deserialize_with = "lax::flag")]
    pub(super) point: bool,
    #[serde(deserialize_with = "lax::flag")]
    pub(super) ellipse: bool,
    #[serde(deserialize_with = "lax::flag")]
    pub(super) capsule: bool,
    pub(super) polygon: Option<Vec<Point>>,
    pub(super) polyline: Option<Vec<Point>>,
    #[serde(deserialize_with = "whether")]
    pub(super) text: bool,
    pub(super) template: Option<String>,
    #[serde(deserialize_with = "lax::given")]
    pub(super) properties: Listed,
    #[serde(skip)]
    pub(super) own: Own,
}

impl Object {
    /// The object with one class: as in XML, the type counts.
    pub(super) fn settled(mut self) -> Self {
        let kind = self.kind.take();
        self.class = match kind {
            Some(kind) if !kind.is_empty() => Some(kind),
            kind => self.class.or(kind),
        };
        self
    }
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Template {
    pub(super) tileset: Option<Tileset>,
    pub(super) object: Option<Object>,
}

/// What a project gives the tiles and objects of a type.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct ObjectType {
    #[serde(deserialize_with = "lax::given")]
    pub(super) name: String,
    #[serde(deserialize_with = "lax::given")]
    pub(super) properties: Listed,
}

#[derive(Debug, Clone, Copy, Default, Deserialize)]
#[serde(default)]
pub(super) struct Point {
    x: Number,
    y: Number,
}

impl Point {
    pub(super) fn is_far(&self) -> bool {
        self.x.is_far() || self.y.is_far()
    }
}

impl From<Point> for Spot {
    fn from(point: Point) -> Self {
        (point.x.0, point.y.0)
    }
}

impl From<Spot> for Point {
    fn from((x, y): Spot) -> Self {
        Self { x: Number(x), y: Number(y) }
    }
}

/// The numbers of a layer, or the text that packs them.
#[derive(Debug)]
pub(super) enum Data {
    List(Vec<u32>),
    Text(String),
}

impl Data {
    /// Whether it has nothing at all.
    pub(super) fn is_empty(&self) -> bool {
        match self {
            Self::List(gids) => gids.is_empty(),
            Self::Text(text) => text.trim().is_empty(),
        }
    }
}

impl<'de> Deserialize<'de> for Data {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = Data;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of tiles or a text")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Data, E> {
                Ok(Data::Text(text.to_owned()))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Data, A::Error> {
                let mut gids = Vec::new();
                while let Some(gid) = list.next_element::<lax::Whole<u32>>()? {
                    gids.push(gid.0);
                }
                Ok(Data::List(gids))
            }
        }
        from.deserialize_any(Any)
    }
}

/// Properties: a list of names, types and values, or before Tiled 1.2 names with values.
#[derive(Debug, Clone, Default)]
pub(super) struct Listed(pub(super) Properties);

#[derive(Deserialize)]
struct Property {
    name: String,
    #[serde(rename = "type")]
    form: Option<String>,
    #[serde(default)]
    value: serde_json::Value,
}

/// A value of a type that only Tiled has. `None` for a reference to no object, and for other types.
pub(super) fn special(form: &str, text: &str) -> Option<Value> {
    Some(match form {
        "object" => match text.trim().parse() {
            Ok(0) => return None,
            Ok(id) => Value::Object(id),
            Err(_) => Value::Lost(format!("it refers to an object '{text}', which is no id")),
        },
        "class" => Value::Lost(CLASS.to_owned()),
        "list" => Value::Lost(LIST.to_owned()),
        _ => Value::Lost(format!("its type '{form}' is unknown")),
    })
}

impl<'de> Deserialize<'de> for Listed {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = Listed;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("properties")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Listed, A::Error> {
                let mut all = Vec::new();
                while let Some(property) = list.next_element::<Property>()? {
                    let value = match property.form.as_deref() {
                        Some("object") => special("object", &property.value.to_string()),
                        _ => Some(Value::from(&property.value)),
                    };
                    all.extend(value.map(|value| (property.name, value)));
                }
                Ok(Listed(Properties(all)))
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Listed, A::Error> {
                let mut all = Vec::new();
                while let Some((name, given)) = map.next_entry::<String, serde_json::Value>()? {
                    all.push((name, Value::from(&given)));
                }
                Ok(Listed(Properties(all)))
            }
        }
        from.deserialize_any(Either)
    }
}

/// The tiles of a tileset: a list, or before Tiled 1.2 by their ids.
#[derive(Debug, Default)]
pub(super) struct Tiles(pub(super) Vec<Tile>);

impl<'de> Deserialize<'de> for Tiles {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = Tiles;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("tiles")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Tiles, A::Error> {
                let mut all = Vec::new();
                while let Some(tile) = list.next_element()? {
                    all.push(tile);
                }
                Ok(Tiles(all))
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Tiles, A::Error> {
                let mut all = Vec::new();
                while let Some((id, tile)) = map.next_entry::<u32, Tile>()? {
                    all.push(Tile { id, ..tile });
                }
                Ok(Tiles(all))
            }
        }
        from.deserialize_any(Either)
    }
}

/// Whether there is anything at all.
fn whether<'de, D: Deserializer<'de>>(from: D) -> Result<bool, D::Error> {
    Option::<IgnoredAny>::deserialize(from).map(|it| it.is_some())
}
