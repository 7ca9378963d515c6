//! Objects that are not solid, as Rust source: spawns, enemies, lifts.

use std::fmt::Write;

use super::names;
use crate::rules::outline::LeftOut;

/// Contract C1 of the library: every coordinate stays below 2^29 raw.
const DOMAIN: i64 = 1 << 29;

/// Whether an object has a place in the level.
pub(crate) fn is_listed(object: &LeftOut) -> bool {
    !object.suspicious
        && object
            .area
            .is_some_and(|area| area.iter().flat_map(|p| [p.0, p.1]).all(|v| (-DOMAIN + 1..DOMAIN).contains(&v)))
}

/// The type of an entry, and what makes its area.
pub(crate) const TYPE: &str = "/// An object of the level that is not solid. A point has an area without size.\n\
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]\n\
    pub struct Object {\n    \
        pub class: &'static str,\n    \
        pub name: &'static str,\n    \
        pub area: tilesat::Aabb,\n\
    }\n\
    const fn area(x: i32, y: i32, right: i32, bottom: i32) -> tilesat::Aabb {\n    \
        match tilesat::Aabb::new(tilesat::Vec2::from_raw(x, y), tilesat::Vec2::from_raw(right, bottom)) {\n        \
            Ok(area) => area,\n        \
            Err(_) => panic!(\"an object is outside of the domain\"),\n    \
        }\n\
    }\n";

/// The objects of a level, and a constant for each one that has a name.
pub(crate) fn list(objects: &[LeftOut]) -> String {
    let listed: Vec<&LeftOut> = objects.iter().filter(|object| is_listed(object)).collect();
    let mut text = "/// The objects that are not solid, in the order of the file.\n#[rustfmt::skip]\n\
                    pub static OBJECTS: &[Object] = &[\n"
        .to_owned();
    let area = |object: &LeftOut| {
        let [(x, y), (right, bottom)] = object.area.unwrap_or_default();
        format!("area({x}, {y}, {right}, {bottom})")
    };
    // Writing to a string cannot fail.
    for object in &listed {
        let (class, name) = (&object.class, &object.title.name);
        let _ = writeln!(text, "    Object {{ class: {class:?}, name: {name:?}, area: {} }},", area(object));
    }
    text += "];\n";
    let named: Vec<&LeftOut> = listed.into_iter().filter(|object| !object.title.name.trim().is_empty()).collect();
    for (constant, object) in names::objects(named.iter().map(|object| object.title.name.trim())).iter().zip(&named) {
        let _ = writeln!(text, "pub const {constant}: tilesat::Aabb = {};", area(object));
    }
    text
}
