//! Entities and their fields.

use std::collections::{HashMap, HashSet};

use super::raw;
use crate::model::decimal::Decimal;
use crate::model::object::{Form, Object, Own, Spot};
use crate::model::property::{Properties, Value};

/// Numbers for the entities of a project, by their names in the file.
#[derive(Debug, Default)]
pub(super) struct Ids {
    known: HashMap<String, u32>,
    /// Those of entities that were read.
    pub(super) read: HashSet<u32>,
    count: u32,
}

impl Ids {
    /// The number of an entity, which may come later.
    fn of(&mut self, iid: &str) -> u32 {
        *self.known.entry(iid.to_owned()).or_insert_with(|| {
            self.count += 1;
            self.count
        })
    }

    /// The number of an entity that is read now. Old files have no names.
    pub(super) fn of_read(&mut self, iid: &str) -> u32 {
        let mut id = if iid.is_empty() { 0 } else { self.of(iid) };
        // A copy of an entity by hand has its name, too.
        if iid.is_empty() || self.read.contains(&id) {
            self.count += 1;
            id = self.count;
        }
        self.read.insert(id);
        id
    }
}

/// An entity is a rectangle with its name, its tags and its fields.
pub(super) fn object(entity: &raw::Entity, id: u32, side: u16, ids: &mut Ids) -> Object {
    let pixels = |value: u32| Decimal::whole(value.into());
    let corner =
        |at: i32, size: u32, pivot: f64| Decimal::whole(at.into()) - Decimal::from_f64(f64::from(size) * pivot);
    let marks = entity.tags.iter().map(|tag| (tag.clone(), Value::Bool(true)));
    let (paths, fields): (Vec<_>, Vec<_>) =
        entity.fields.iter().partition(|field| matches!(field.form.as_str(), "Point" | "Array<Point>"));
    let values = fields.into_iter().flat_map(|field| values(field, ids)).collect();
    let points = |field: &raw::Field| each(&field.value).filter_map(|point| middle(point, side)).collect::<Vec<Spot>>();
    let paths = paths.into_iter().map(|field| (field.name.clone(), points(field))).filter(|path| !path.1.is_empty());
    Object {
        id,
        name: entity.name.clone(),
        class: entity.name.clone(),
        properties: Properties(marks.collect()),
        own: Own { name: true, class: true, properties: entity.tags.len() },
        fields: Properties(values),
        paths: paths.collect(),
        at: (corner(entity.px.0, entity.width, entity.pivot.0), corner(entity.px.1, entity.height, entity.pivot.1)),
        size: (pixels(entity.width), pixels(entity.height)),
        rotation: Decimal::ZERO,
        hidden: false,
        form: Form::Rectangle,
    }
}

/// The values of all fields, one after another.
pub(super) fn fields(fields: &[raw::Field], ids: &mut Ids) -> Properties {
    Properties(fields.iter().flat_map(|field| values(field, ids)).collect())
}

/// The values of a field: a list has several, and a field without a value none.
fn values(field: &raw::Field, ids: &mut Ids) -> Vec<(String, Value)> {
    let value = |value: &serde_json::Value| match value {
        serde_json::Value::Object(reference) => match reference.get("entityIid").and_then(|iid| iid.as_str()) {
            Some(iid) => Value::Object(ids.of(iid)),
            None => Value::Lost(format!("its type '{}' has no value here", field.form)),
        },
        plain => Value::from(plain),
    };
    let values: Vec<Value> = each(&field.value).map(value).collect();
    values.into_iter().map(|value| (field.name.clone(), value)).collect()
}

fn each(value: &serde_json::Value) -> impl Iterator<Item = &serde_json::Value> {
    let list = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
    list.iter().filter(|value| !value.is_null())
}

/// The middle of the cell that a point of `LDtk` names.
fn middle(point: &serde_json::Value, side: u16) -> Option<Spot> {
    let along = |name: &str| {
        let cell = i32::try_from(point.get(name)?.as_i64()?).ok()?;
        Some(Decimal::whole(i64::from(cell) * i64::from(side)) + Decimal::whole(side.into()).scaled(1, 2))
    };
    Some((along("cx")?, along("cy")?))
}
