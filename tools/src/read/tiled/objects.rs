//! Objects of a file, with the values of their templates and their forms.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::{foreign, raw, tags};
use crate::model::decimal::Decimal;
use crate::model::flip::Flip;
use crate::model::object::{Form, Object, Own, Stamp};
use crate::model::property::Properties;
use crate::model::tileset::Tileset;
use crate::read::file::Files;
use crate::read::json;

type Result<T> = std::result::Result<T, String>;

/// What to do about a file that a map names and nobody finds.
pub(super) const LOCATE: &str = "put it there, or open the map in Tiled, which asks where it is";

/// The templates of a map, each read once.
#[derive(Debug, Default)]
pub(super) struct Templates {
    objects: HashMap<PathBuf, raw::Object>,
    sets: HashMap<PathBuf, raw::Tileset>,
}

impl Templates {
    /// The tileset of a template, once.
    pub(super) fn take_set(&mut self, path: &Path) -> Option<raw::Tileset> {
        self.sets.remove(path)
    }

    /// An object of a file in this folder, with the values of its template. If the template is
    /// missing: the object alone, and the reason.
    ///
    /// # Errors
    ///
    /// If the template is there, and cannot be read.
    pub(super) fn filled(
        &mut self,
        object: raw::Object,
        folder: &Path,
        files: &mut Files,
    ) -> Result<(raw::Object, Option<String>)> {
        let mut object = object.settled();
        let given = |text: &Option<String>| text.as_ref().is_some_and(|text| !text.is_empty());
        let properties = object.properties.0.0.len();
        object.own = Own { name: given(&object.name), class: given(&object.class), properties };
        let Some(name) = &object.template else { return Ok((object, None)) };
        let path = files.named(folder, name);
        if !self.objects.contains_key(&path) {
            let of_file = |why: String| format!("object {}: template {}: {why}", object.id, path.display());
            let bytes = match files.utf8_or(&path, LOCATE) {
                Err(why) if !path.exists() => {
                    let why = of_file(why);
                    return Ok((object, Some(why)));
                }
                read => read.map_err(of_file)?,
            };
            let read = if json::is_json(&bytes) { json::parse(&bytes) } else { tags::template(&bytes) };
            let template: raw::Template = read.map_err(|why| {
                of_file(foreign::mark(&bytes).unwrap_or_else(|| format!("not a template of Tiled: {why}")))
            })?;
            let inner = template.object.ok_or_else(|| of_file("it has no object".to_owned()))?;
            self.objects.insert(path.clone(), inner.settled());
            self.sets.extend(template.tileset.map(|set| (path.clone(), set)));
        }
        Ok((filled(object, &self.objects[&path]), None))
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
    let properties = with_rest(own.properties.0, &template.properties.0);
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
        visible: own.visible.or(template.visible),
        properties: raw::Listed(properties),
        own: own.own,
        ..form
    }
}

/// All of the first, and of the others those with other names.
pub(super) fn with_rest(mut own: Properties, others: &Properties) -> Properties {
    for (name, value) in &others.0 {
        if !own.0.iter().any(|(known, _)| known == name) {
            own.0.push((name.clone(), value.clone()));
        }
    }
    own
}

/// An object with the size, the class and the properties of its tile, as far as it has none.
pub(super) fn of_tile(object: raw::Object, set: &Tileset, (tileset, id, flip): (usize, u32, Flip)) -> Result<Object> {
    let (width, height) = set.size_of(id);
    let along = |own: Option<raw::Number>, side: u32| {
        own.filter(|own| own.0 != Decimal::ZERO).or(Some(raw::Number(Decimal::whole(side.into()))))
    };
    let object = raw::Object { width: along(object.width, width), height: along(object.height, height), ..object };
    let mut object = mirrored(object, set.align);
    if let Some(tile) = set.tiles.get(&id) {
        object.class = object.class.filter(|class| !class.is_empty()).or(Some(tile.class.clone()));
        object.properties.0 = with_rest(object.properties.0, &tile.properties);
    }
    let mut object = shape(object)?;
    // Polygons and points stay what they are.
    if object.form == Form::Rectangle {
        let scaled = |by: i32, side: Decimal, own: u32| match own {
            0 => Decimal::whole(by.into()),
            _ if by < 0 => -side.scaled(by.unsigned_abs(), own),
            _ => side.scaled(by.unsigned_abs(), own),
        };
        let (across, down) = ((object.size.0, width), (object.size.1, height));
        // A picture that keeps its aspect has one scale, the smaller one.
        let (x, y) = if !set.keeps_aspect {
            (across, down)
        } else if across.0.scaled(height, width) <= down.0 {
            (across, across)
        } else {
            (down, down)
        };
        let offset = (scaled(set.offset.0, x.0, x.1), scaled(set.offset.1, y.0, y.1));
        object.form = Form::Tile(Stamp { align: set.align, offset, tileset, id, flip });
    }
    Ok(object)
}

/// The alignment of a tileset's objects, in halves of their size.
pub(super) fn alignment(name: &str) -> Result<(u32, u32)> {
    Ok(match name {
        "topleft" => (0, 0),
        "top" => (1, 0),
        "topright" => (2, 0),
        "left" => (0, 1),
        "center" => (1, 1),
        "right" => (2, 1),
        "" | "unspecified" | "bottomleft" => (0, 2),
        "bottom" => (1, 2),
        "bottomright" => (2, 2),
        other => return Err(format!("objectalignment '{other}' is unknown")),
    })
}

/// Whether the size of an object is negative. Programs other than Tiled write such boxes.
pub(super) fn is_mirrored(object: &raw::Object) -> bool {
    [object.width, object.height].into_iter().flatten().any(|side| side.0 < Decimal::ZERO)
}

/// Whether it is a box that is a line.
pub(super) fn is_flat(object: &raw::Object) -> bool {
    let sides = [object.width, object.height].map(|side| side.is_none_or(|side| side.0 == Decimal::ZERO));
    let is_box = !object.point && !object.text && object.polygon.is_none() && object.polyline.is_none();
    is_box && sides[0] != sides[1]
}

/// An object whose size is not negative. Its own point is this many halves of its size right of its
/// left side and below its top.
fn mirrored(object: raw::Object, align: (u32, u32)) -> raw::Object {
    let side = |side: Option<raw::Number>, halves: u32| match side {
        Some(side) if side.0 < Decimal::ZERO => (-side.0).scaled(halves, 1) + side.0,
        _ => Decimal::ZERO,
    };
    let (x, y) = (side(object.width, align.0), side(object.height, align.1));
    let (sin, cos) = object.rotation.map_or((0.0, 1.0), |by| by.0.to_f64().to_radians().sin_cos());
    let (x, y) = match object.rotation {
        Some(by) if by.0 != Decimal::ZERO => {
            let (x, y) = (x.to_f64(), y.to_f64());
            (Decimal::from_f64(x * cos - y * sin), Decimal::from_f64(x * sin + y * cos))
        }
        _ => (x, y),
    };
    let positive =
        |side: Option<raw::Number>| side.map(|side| if side.0 < Decimal::ZERO { raw::Number(-side.0) } else { side });
    let (at, size) = ((object.x.0 + x, object.y.0 + y), (positive(object.width), positive(object.height)));
    raw::Object { x: raw::Number(at.0), y: raw::Number(at.1), width: size.0, height: size.1, ..object }
}

/// A box around an object a million pixels away: it is outside of every level, whatever its form.
fn far(object: raw::Object) -> raw::Object {
    let is_far = |number: &raw::Number| number.is_far();
    let own = [Some(object.x), Some(object.y), object.width, object.height];
    let points = object.polygon.iter().chain(&object.polyline).flatten();
    let points_far = points.clone().any(raw::Point::is_far);
    if !own.iter().flatten().any(is_far) && !points_far {
        return object;
    }
    let has_points = object.polygon.is_some() || object.polyline.is_some();
    let side = |side: Option<raw::Number>| if has_points { Some(raw::Number(Decimal::whole(1_000_000))) } else { side };
    let (width, height) = (side(object.width), side(object.height));
    raw::Object { polygon: None, polyline: None, rotation: None, width, height, ..object }
}

/// An object without a template and a tile.
pub(super) fn shape(object: raw::Object) -> Result<Object> {
    if let Some(by) = object.rotation.filter(raw::Number::is_far) {
        return Err(format!("object {}: its rotation is {by}, not a number below a million", object.id));
    }
    let object = mirrored(far(object), (0, 0));
    let points = |points: Vec<raw::Point>| points.into_iter().map(Into::into).collect();
    let form = match object {
        raw::Object { polygon: Some(list), .. } => Form::Polygon(points(list)),
        raw::Object { polyline: Some(list), .. } => Form::Polyline(points(list)),
        raw::Object { point: true, .. } => Form::Point,
        raw::Object { ellipse: true, .. } => Form::Ellipse,
        raw::Object { capsule: true, .. } => Form::Capsule,
        raw::Object { text: true, .. } => Form::Text,
        _ => Form::Rectangle,
    };
    let number = |number: Option<raw::Number>| number.map_or(Decimal::ZERO, |number| number.0);
    let size = (number(object.width), number(object.height));
    Ok(Object {
        id: object.id,
        name: object.name.unwrap_or_default(),
        class: object.class.unwrap_or_default(),
        properties: Properties(object.properties.0.0),
        own: object.own,
        fields: Properties::default(),
        paths: Vec::new(),
        at: (object.x.0, object.y.0),
        size,
        rotation: number(object.rotation),
        hidden: object.visible == Some(false),
        form,
    })
}
