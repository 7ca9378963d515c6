//! The area that a tile as an object fills.
#![allow(clippy::cast_precision_loss, reason = "raw coordinates are below 2^53")]

use super::knots::{self, Knot};
use super::piece::{Frame, Path, drawn};
use super::{flat, form};
use crate::geometry::{Meeting, crossing};
use crate::model::decimal::Decimal;
use crate::model::object::{Spot, Stamp, raw};
use crate::model::tileset::Tileset;

/// The collision shapes of a tile as an object, from the corner of its picture, which is drawn at
/// this size, and in the output this many times larger. Polygons that cross themselves are taken
/// apart.
///
/// # Errors
///
/// If the inside of such a polygon is not clear.
pub(super) fn shapes(set: &Tileset, stamp: &Stamp, size: Spot, zoom: f64) -> Result<Vec<Path>, String> {
    let (w, h) = set.size_of(stamp.id);
    let own = (i64::from(w), i64::from(h));
    let (across, down) = if stamp.flip.diagonal { (own.1, own.0) } else { own };
    let fit = |v: Decimal, from: i64, to: Decimal| match from {
        1.. if Decimal::whole(from) != to => Decimal::from_f64(v.to_f64() * to.to_f64() / from as f64),
        _ => v,
    };
    let shapes = set.tiles.get(&stamp.id).map(|tile| tile.shapes.as_slice()).unwrap_or_default();
    if shapes.iter().any(form::is_far) {
        return Err(format!("a collision shape of its tile {} is a million pixels away or wide", stamp.id));
    }
    let (from, to) = picture(set, stamp, size);
    let size = (to.0 - from.0, to.1 - from.1);
    let along = |from: i64, to: Decimal| if from > 0 { to.to_f64() / from as f64 } else { 1.0 };
    let zoom = zoom * along(across, size.0).max(along(down, size.1));
    let mut paths: Vec<Path> =
        shapes.iter().flat_map(|shape| drawn(shape, own, stamp.flip, Frame::new(across, down), zoom)).collect();
    for point in paths.iter_mut().flat_map(|path| &mut path.points) {
        *point = (from.0 + fit(point.0, across, size.0), from.1 + fit(point.1, down, size.1));
    }
    // A click in the collision editor leaves a rectangle without a size.
    paths.retain(|path| flat::why(path.kind, path.closed, &raw(&path.points)).is_none());
    let parts: Vec<Vec<Path>> = paths.into_iter().map(|path| untied(path, stamp.id)).collect::<Result<_, _>>()?;
    Ok(parts.concat())
}

/// The parts of a polygon that crosses itself. The union of those that have one direction.
fn untied(path: Path, tile: u32) -> Result<Vec<Path>, String> {
    let points = raw(&path.points);
    if !(path.closed && path.kind.has_area()) {
        return Ok(vec![path]);
    }
    match knots::of(&points) {
        Knot::Parts(parts) => return Ok(path.parts(parts)),
        Knot::Plain if crossing(&points, |meeting| matches!(meeting, Meeting::Cross(_))).is_none() => {
            return Ok(vec![path]);
        }
        Knot::Plain | Knot::Unclear(_) => {}
    }
    let parts = knots::parts(&points).ok_or_else(|| {
        format!(
            "the collision polygon of its tile {tile} crosses itself, and its inside is not clear: draw two polygons, or \
             put its corners in order"
        )
    })?;
    Ok(path.parts(parts))
}

/// The corners of the picture in an object of this size.
pub(super) fn picture(set: &Tileset, stamp: &Stamp, size: Spot) -> (Spot, Spot) {
    let (w, h) = set.size_of(stamp.id);
    let (across, down) = if stamp.flip.diagonal { (h, w) } else { (w, h) };
    if !set.keeps_aspect || w == 0 || h == 0 {
        return ((Decimal::ZERO, Decimal::ZERO), size);
    }
    let (wide, high) = (size.1.scaled(across, down), size.0.scaled(down, across));
    let drawn = if wide <= size.0 { (wide, size.1) } else { (size.0, high) };
    let from = ((size.0 - drawn.0).scaled(1, 2), (size.1 - drawn.1).scaled(1, 2));
    (from, (from.0 + drawn.0, from.1 + drawn.1))
}
