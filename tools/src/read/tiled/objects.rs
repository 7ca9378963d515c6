//! Objects of a file, with the values of their templates and their forms.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::{raw, tags};
use crate::model::decimal::Decimal;
use crate::model::object::{Form, Object};
use crate::model::property::Properties;
use crate::read::file::Files;
use crate::read::json;

type Result<T> = std::result::Result<T, String>;

/// The templates of a map, each read once.
#[derive(Debug, Default)]
pub(super) struct Templates(HashMap<PathBuf, raw::Object>);

impl Templates {
    /// An object of a map in this folder.
    pub(super) fn object(&mut self, object: raw::Object, folder: &Path, files: &mut Files) -> Result<Object> {
        let Some(name) = &object.template else { return shape(object) };
        let path = folder.join(name);
        if !self.0.contains_key(&path) {
            let of_file = |why: String| format!("object {}: template {}: {why}", object.id, path.display());
            // People often take levels out of their project without the files that only the game
            // needs.
            let Ok(bytes) = files.bytes(&path) else {
                let why = format!("made from a template that cannot be read: {name}");
                return Ok(Object { form: Form::Missing(why), ..shape(object)? });
            };
            let read = if json::is_json(&bytes) { json::parse(&bytes) } else { tags::template(&bytes) };
            let template: raw::Template = read.map_err(|why| of_file(format!("not a template of Tiled: {why}")))?;
            let inner = template.object.ok_or_else(|| of_file("it has no object".to_owned()))?;
            self.0.insert(path.clone(), inner);
        }
        shape(filled(object, &self.0[&path]))
    }
}

/// The properties of the object, and its template's for the rest.
fn filled(own: raw::Object, template: &raw::Object) -> raw::Object {
    let drawn = |object: &raw::Object| {
        object.point
            || object.ellipse
            || object.capsule
            || object.text
            || object.polygon.is_some()
            || object.polyline.is_some()
    };
    let form = if drawn(&own) { &own } else { template }.clone();
    let mut properties = own.properties.0;
    for (name, value) in &template.properties.0.0 {
        if !properties.0.iter().any(|(known, _)| known == name) {
            properties.0.push((name.clone(), value.clone()));
        }
    }
    raw::Object {
        id: own.id,
        name: own.name.or(template.name.clone()),
        class: own.class.or(template.class.clone()),
        x: own.x,
        y: own.y,
        width: own.width.or(template.width),
        height: own.height.or(template.height),
        rotation: own.rotation.or(template.rotation),
        gid: own.gid.or(template.gid),
        properties: raw::Listed(properties),
        ..form
    }
}

/// An object without a template.
fn shape(object: raw::Object) -> Result<Object> {
    let points = |points: Vec<raw::Point>| points.into_iter().map(Into::into).collect();
    let form = match object {
        raw::Object { polygon: Some(list), .. } => Form::Polygon(points(list)),
        raw::Object { polyline: Some(list), .. } => Form::Polyline(points(list)),
        raw::Object { point: true, .. } => Form::Point,
        raw::Object { ellipse: true, .. } => Form::Ellipse,
        raw::Object { capsule: true, .. } => Form::Capsule,
        raw::Object { text: true, .. } => Form::Text,
        raw::Object { gid: Some(_), .. } => Form::Tile,
        _ => Form::Rectangle,
    };
    let number = |number: Option<raw::Number>| number.map_or(Decimal::ZERO, |number| number.0);
    let size = (number(object.width), number(object.height));
    if size.0 < Decimal::ZERO || size.1 < Decimal::ZERO {
        return Err(format!("object {} has a negative size", object.id));
    }
    Ok(Object {
        id: object.id,
        name: object.name.unwrap_or_default(),
        class: object.class.unwrap_or_default(),
        properties: Properties(object.properties.0.0),
        fields: Properties::default(),
        path: Vec::new(),
        at: (object.x.0, object.y.0),
        size,
        rotation: number(object.rotation),
        form,
    })
}
