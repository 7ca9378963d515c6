//! Objects that are not solid, as Rust source and as JSON: spawns, enemies, lifts.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Serialize;
use tilesat::Fx;

use super::names;
use crate::model::decimal::Decimal;
use crate::model::property::Value;
use crate::rules::outline::LeftOut;

/// The properties of listed objects that no output holds.
pub(crate) fn lost(objects: &[LeftOut]) -> Vec<String> {
    let listed = objects.iter().filter(|object| object.is_listed());
    let lost = listed.flat_map(|object| {
        object.properties.0.iter().filter_map(|(name, value)| match value {
            Value::Lost(why) => Some(format!("property '{name}' of {}: {why}", object.title)),
            _ => None,
        })
    });
    let mut lost: Vec<String> = lost.collect();
    lost.dedup();
    lost
}

/// The type of an entry, and what makes its area.
pub(crate) const TYPE: &str = "/// An object of the level that is not solid. A point has an area without size.\n\
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]\n\
    pub struct Object {\n    \
        /// Unique in the map or the project.\n    \
        pub id: u32,\n    \
        pub class: &'static str,\n    \
        pub name: &'static str,\n    \
        pub area: ::tilesat::Aabb,\n    \
        /// Those of a polygon or a polyline, such as the way of a lift.\n    \
        pub points: &'static [::tilesat::Vec2],\n    \
        /// As drawn. A list is several entries with one name.\n    \
        pub properties: &'static [(&'static str, Value)],\n\
    }\n\
    /// The value of a property.\n\
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]\n\
    pub enum Value {\n    \
        Bool(bool),\n    \
        /// Rounded to nearest. One that 16.16 cannot hold is a text.\n    \
        Number(::tilesat::Fx),\n    \
        Text(&'static str),\n    \
        /// A reference to the object with this id.\n    \
        Object(u32),\n    \
        Point(::tilesat::Vec2),\n\
    }\n\
    impl Object {\n    \
        /// The value of a property.\n    \
        pub fn property(&self, name: &str) -> Option<Value> {\n        \
            self.properties.iter().find(|property| property.0 == name).map(|property| property.1)\n    \
        }\n    \
        /// The number of a property.\n    \
        pub fn number(&self, name: &str) -> Option<::tilesat::Fx> {\n        \
            match self.property(name) {\n            \
                Some(Value::Number(number)) => Some(number),\n            \
                _ => None,\n        \
            }\n    \
        }\n\
    }\n\
    const fn area(x: i32, y: i32, right: i32, bottom: i32) -> ::tilesat::Aabb {\n    \
        match ::tilesat::Aabb::new(::tilesat::Vec2::from_raw(x, y), ::tilesat::Vec2::from_raw(right, bottom)) {\n        \
            Ok(area) => area,\n        \
            Err(_) => panic!(\"an object is outside of the domain\"),\n    \
        }\n\
    }\n";

/// The imports of a module whose parent has the types.
pub(crate) const IMPORT: &str =
    "#[allow(unused_imports, reason = \"a level may have no object\")]\nuse super::{Object, Value, area};\n";

/// The objects of a level, and a constant for each one that has a name.
pub(crate) fn list(objects: &[LeftOut]) -> String {
    let mut text = "/// The objects that are not solid, in the order of the file.\n#[rustfmt::skip]\n\
                    pub static OBJECTS: &[Object] = &[\n"
        .to_owned();
    text += &entries(objects);
    text += "];\n";
    let listed = objects.iter().filter(|object| object.is_listed());
    let named: Vec<&LeftOut> = listed.filter(|object| !object.title.name.trim().is_empty()).collect();
    for (constant, object) in names::objects(named.iter().map(|object| object.title.name.trim())).iter().zip(&named) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "pub const {constant}: ::tilesat::Aabb = {};", area(object));
    }
    text
}

/// A line for each object.
pub(crate) fn entries(objects: &[LeftOut]) -> String {
    let mut text = String::new();
    for object in objects.iter().filter(|object| object.is_listed()) {
        let (id, class, name) = (object.title.id, &object.class, &object.title.name);
        let spot = |(x, y): &(i64, i64)| format!("::tilesat::Vec2::from_raw({x}, {y})");
        let points = object.points.iter().map(spot);
        let values =
            object.properties.0.iter().filter_map(|(name, value)| Some(format!("({name:?}, {})", spelt(value)?)));
        let named = object.named.iter().flat_map(|(name, points)| points.iter().map(move |point| (name, point)));
        let values = values.chain(named.map(|(name, point)| format!("({name:?}, Value::Point({}))", spot(point))));
        let list = |items: Vec<String>| items.join(", ");
        let _ = writeln!(
            text,
            "    Object {{ id: {id}, class: {class:?}, name: {name:?}, area: {}, points: &[{}], properties: &[{}] }},",
            area(object),
            list(points.collect()),
            list(values.collect())
        );
    }
    text
}

fn area(object: &LeftOut) -> String {
    let [(x, y), (right, bottom)] = object.area.unwrap_or_default();
    format!("area({x}, {y}, {right}, {bottom})")
}

/// A number that 16.16 holds.
fn number(digits: &str) -> Option<Fx> {
    let raw = Decimal::parse(digits.as_bytes())?.raw();
    i32::try_from(raw).ok().map(Fx::from_bits)
}

fn spelt(value: &Value) -> Option<String> {
    Some(match value {
        Value::Bool(is) => format!("Value::Bool({is})"),
        Value::Number(digits) => match number(digits) {
            Some(number) => format!("Value::Number(::tilesat::Fx::lit(\"{number}\"))"),
            None => format!("Value::Text({digits:?})"),
        },
        Value::Text(text) => format!("Value::Text({text:?})"),
        Value::Object(id) => format!("Value::Object({id})"),
        Value::Lost(_) => return None,
    })
}

/// An object in JSON.
#[derive(Serialize)]
pub(crate) struct Thing<'a> {
    id: u32,
    class: &'a str,
    name: &'a str,
    layer: &'a str,
    /// In pixels: the least x and y, then the greatest.
    area: [f64; 4],
    points: Vec<[f64; 2]>,
    properties: BTreeMap<&'a str, Vec<serde_json::Value>>,
}

/// The same objects for JSON.
pub(crate) fn things(objects: &[LeftOut]) -> Vec<Thing<'_>> {
    objects.iter().filter(|object| object.is_listed()).map(thing).collect()
}

fn thing(object: &LeftOut) -> Thing<'_> {
    #[allow(clippy::cast_precision_loss, reason = "inside the domain, every raw unit is a float")]
    let pixels = |raw: i64| raw as f64 / 65536.0;
    let [(x, y), (right, bottom)] = object.area.unwrap_or_default();
    let mut properties: BTreeMap<&str, Vec<serde_json::Value>> = BTreeMap::new();
    for (name, value) in &object.properties.0 {
        let value = match value {
            Value::Bool(is) => (*is).into(),
            Value::Number(digits) => serde_json::from_str(digits).unwrap_or_else(|_| digits.as_str().into()),
            Value::Text(text) => text.as_str().into(),
            Value::Object(id) => (*id).into(),
            Value::Lost(_) => continue,
        };
        properties.entry(name).or_default().push(value);
    }
    for (name, points) in &object.named {
        let points = points.iter().map(|&(x, y)| vec![pixels(x), pixels(y)].into());
        properties.entry(name).or_default().extend(points);
    }
    Thing {
        id: object.title.id,
        class: &object.class,
        name: &object.title.name,
        layer: &object.title.layer,
        area: [x, y, right, bottom].map(pixels),
        points: object.points.iter().map(|&(x, y)| [pixels(x), pixels(y)]).collect(),
        properties,
    }
}
