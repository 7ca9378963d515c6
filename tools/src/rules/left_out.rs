//! An object that is not solid, as the output lists it for the game.

use super::form;
use super::outline::{LeftOut, Title};
use super::place::Unit;
use crate::model::map::Layer;
use crate::model::object::{Form, Object, Spot};
use crate::model::property::Properties;

/// An object with the reason that it is not solid.
pub(super) fn of(object: &Object, layer: &Layer, unit: Unit, why: String) -> LeftOut {
    let raw = |(x, y): Spot| (unit.raw(x + layer.offset.0).0, unit.raw(y + layer.offset.1).0);
    let around = match form::corners(object) {
        Some(corners) => corners.points,
        None => vec![object.at, (object.at.0 + object.size.0, object.at.1 + object.size.1)],
    };
    let around: Vec<(i64, i64)> = around.into_iter().map(raw).collect();
    let ends = |along: fn(&(i64, i64)) -> i64| {
        let values = || around.iter().map(along);
        values().min().zip(values().max())
    };
    let area = ends(|p| p.0).zip(ends(|p| p.1)).map(|((x, right), (y, bottom))| [(x, y), (right, bottom)]);
    let named = object.paths.iter().map(|(name, path)| (name.clone(), path.iter().copied().map(raw).collect()));
    let named: Vec<(String, Vec<(i64, i64)>)> = named.collect();
    let points = match &object.form {
        Form::Polygon(_) | Form::Polyline(_) => around,
        _ => named.first().map_or_else(Vec::new, |(_, path)| path.clone()),
    };
    let class = if object.class.is_empty() { &layer.class } else { &object.class }.clone();
    let properties = Properties(object.properties.0.iter().chain(&object.fields.0).cloned().collect());
    let title = Title { id: object.id, name: object.name.clone(), layer: layer.name.clone() };
    LeftOut { title, class, at: raw(object.at), area, points, named, properties, why, suspicious: false }
}
