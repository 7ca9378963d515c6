//! Finds the ground of levels that are seen from above: it is nearly everywhere, and walls stand on
//! it. The name of its layer then does not make it solid, because bodies would have no room.

use std::fmt::Write;

use tilesat::TileShape;

use super::cells::{Cells, Lattice, Sheet};
use super::form;
use super::layers::Layers;
use super::objects::{self, Says};
use super::outline::Outline;
use super::place::Unit;
use super::report::Rule;
use super::{marked, nothing, words};
use crate::geometry::{Point, winding};
use crate::model::decimal::Decimal;
use crate::model::map::{Content, Layer, Map};
use crate::model::object::{Object, Spot};

/// In the names of layers that bodies walk on, or stand on.
const UNDER: &[&str] = &["ground", "terrain", "floor"];
/// In the names of layers that are solid from either point of view.
const OVER: &[&str] = &["wall", "obstacle", "block", "boundary", "boundaries", "barrier"];

/// The most layers of each of them. Games have fewer, and each pair takes time.
const MOST: usize = 32;

/// Each layer of ground below a layer of walls, and the words for it.
///
/// Seen from the side, ground leaves room for the air, and walls stand beside it. So the ground has
/// to cover three quarters of the cells, and to be under three quarters of the walls.
pub(super) fn layers<'a>(map: &Map, sheets: &[Sheet<'a>], all: &[&'a Layer]) -> Vec<(&'a Layer, String)> {
    // Values of LDtk have names.
    if map.values {
        return Vec::new();
    }
    let ground = sheets.iter().filter(|sheet| {
        let cells = u64::from(sheet.tiles.width) * u64::from(sheet.tiles.height);
        is(sheet, UNDER) && !words::has(&sheet.layer.name, OVER) && mostly(drawn(sheet), cells)
    });
    let over = |ground: &Sheet<'a>| {
        let walls = sheets.iter().filter(|sheet| is(sheet, OVER)).take(MOST);
        let tiles = walls.filter(|sheet| stands(sheet, ground));
        let objects = all.iter().filter(|layer| layer.tiles().is_none() && named(layer, OVER)).take(MOST);
        let objects = objects.filter(|layer| match &layer.content {
            Content::Objects(objects) => stand(objects, layer, ground),
            Content::Tiles(_) | Content::Image => false,
        });
        let found = tiles.map(|sheet| sheet.layer).chain(objects.copied()).next();
        found.map(|layer| (ground.layer, format!("layer '{}' stands on it", layer.name)))
    };
    ground.take(MOST).filter_map(over).collect()
}

impl<'a> Layers<'a> {
    /// The layer of objects that says that they are solid, if they are.
    pub(super) fn of_solids(&self, outlines: &[Outline]) -> Option<&'a str> {
        let has = |name: &str| outlines.iter().any(|outline| outline.kind.is_solid() && outline.title.layer == name);
        let says = |layer: &Layer| objects::layer_says(layer, self.options) == Says::Solid;
        let mut all = self.all.iter().filter(|layer| layer.tiles().is_none() && says(layer));
        all.find(|layer| has(&layer.name)).map(|layer| layer.name.as_str())
    }

    /// Adds the layers on which the solid objects lie. They trace what is drawn, or bodies walk on
    /// it. Of a project with a layer of solid objects, adds all ground: seen from above, bodies
    /// walk on it.
    pub(super) fn lain_on(&mut self, sheets: &[Sheet<'a>], outlines: &[Outline], of_solids: Option<&str>) {
        let first = outlines.first().map_or("", |outline| &outline.title.layer);
        let points = points(outlines);
        for sheet in sheets {
            let is_ground = is(sheet, UNDER) && !words::has(&sheet.layer.name, OVER);
            let why = match of_solids {
                Some(layer) if is_ground => format!("layer '{layer}' has the solid objects"),
                _ if lies(&points, sheet, self.unit) => format!("the solid objects of layer '{first}' lie on it"),
                _ => continue,
            };
            self.stood_on.push((sheet.layer, why));
        }
    }

    /// Notes that bodies have no room, if only names of layers make the level solid. Writing to a
    /// string cannot fail.
    pub(super) fn crowded(&mut self, sheets: &[Sheet<'_>], cells: &Cells) {
        let guessed = !self.map.values && self.ledger.0.iter().all(|applied| applied.rule == Rule::D);
        if !guessed || cells.kinds.is_empty() || cells.kinds.iter().any(|kind| kind.shape != TileShape::Full) {
            return;
        }
        let solid = sheets.iter().filter(|sheet| !sheet.pieces.is_empty());
        // On a tie, the lowest layer.
        if let Some(sheet) = solid.rev().max_by_key(|sheet| drawn(sheet)) {
            let name = &sheet.layer.name;
            let mut note = format!(
                "GUESS: every cell is solid because of the name of layer '{name}'; if bodies walk on it, add --ignore-layer '{name}'"
            );
            if let Some((names, option)) = nothing::names_of_tiles(sheets) {
                let _ = write!(note, "; if only the tiles {names} are solid, add --solid {option}");
            }
            for hint in nothing::hints(self.map) {
                let _ = write!(note, "; {hint}");
            }
            self.note(note);
        }
    }
}

/// Whether a layer has such a name, and does not deny it.
fn named(layer: &Layer, list: &[&str]) -> bool {
    words::has(&layer.name, list) && marked::denial(layer).is_none()
}

/// Whether only the name of a layer can decide about its tiles, and the name has such a word.
fn is(sheet: &Sheet<'_>, list: &[&str]) -> bool {
    let decided = sheet.used.iter().any(|(entry, _)| sheet.pieces.contains_key(entry));
    !sheet.used.is_empty() && !decided && !sheet.tiles.derived && named(sheet.layer, list)
}

/// The most outlines that are compared with a layer, and the most corners of one.
const MOST_OUTLINES: usize = 256;
const MOST_CORNERS: usize = 256;
/// Points in the box around an outline, along each side.
const PLACES: i64 = 8;

/// Points in and on the solid outlines.
pub(super) fn points(outlines: &[Outline]) -> Vec<Point> {
    let solid = outlines.iter().filter(|outline| outline.kind.is_solid() && outline.points.len() <= MOST_CORNERS);
    solid.take(MOST_OUTLINES).flat_map(places).collect()
}

/// Whether most of these points lie on tiles of a layer.
pub(super) fn lies(points: &[Point], sheet: &Sheet<'_>, unit: Unit) -> bool {
    let side = unit.raw(Decimal::whole(sheet.tiles.tile.into())).0.max(1);
    let (x, y) = (unit.raw(sheet.layer.offset.0).0, unit.raw(sheet.layer.offset.1).0);
    let on = |p: &&Point| sheet.tiles.entry(((p.0 - x).div_euclid(side), (p.1 - y).div_euclid(side))).is_some();
    !points.is_empty() && points.iter().filter(on).count() * 2 >= points.len()
}

/// Points within a polygon, or the middles of the edges of a chain.
pub(super) fn places(outline: &Outline) -> Vec<Point> {
    let middle = |(a, b): (Point, Point)| (a.0.midpoint(b.0), a.1.midpoint(b.1));
    if !outline.closed {
        return outline.edges().map(middle).collect();
    }
    let ends = |of: fn(&Point) -> i64| {
        let all = || outline.points.iter().map(of);
        (all().min().unwrap_or(0), all().max().unwrap_or(0))
    };
    let (wide, high) = (ends(|p| p.0), ends(|p| p.1));
    let along = |(from, to): (i64, i64), at: i64| from + (to - from) / (2 * PLACES) * (2 * at + 1);
    let all = (0..PLACES * PLACES).map(|at| (along(wide, at % PLACES), along(high, at / PLACES)));
    all.filter(|point| is_within(*point, outline)).collect()
}

/// Whether a point is in a polygon.
pub(super) fn is_within((x, y): Point, outline: &Outline) -> bool {
    winding(&outline.points, (2 * x, 2 * y)) != 0
}

fn drawn(sheet: &Sheet<'_>) -> u64 {
    sheet.used.iter().map(|(_, count)| count).sum()
}

fn mostly(part: u64, all: u64) -> bool {
    part > 0 && part.saturating_mul(4) >= all.saturating_mul(3)
}

/// Whether most tiles of a layer are over tiles of the ground.
fn stands(walls: &Sheet<'_>, ground: &Sheet<'_>) -> bool {
    if Lattice::of(walls) != Lattice::of(ground) || walls.layer.offset != ground.layer.offset {
        return false;
    }
    let over = walls.tiles.drawn().filter(|(x, y, _)| ground.tiles.entry((i64::from(*x), i64::from(*y))).is_some());
    mostly(over.count() as u64, drawn(walls))
}

/// Whether the middles of most objects are over tiles of the ground.
fn stand(objects: &[Object], layer: &Layer, ground: &Sheet<'_>) -> bool {
    let side = i64::from(ground.tiles.tile.max(1)) << 16;
    let raw = |value| Unit::new(None).raw(value).0;
    let over = |points: &[Spot]| {
        let middle = |along: fn(&Spot) -> Decimal, offset: i64| {
            let all = || points.iter().map(|point| raw(along(point)));
            let (lo, hi) = (all().min().unwrap_or(0), all().max().unwrap_or(0));
            (lo + (hi - lo) / 2 + offset).div_euclid(side)
        };
        let (of, on) = (layer.offset, ground.layer.offset);
        ground.tiles.entry((middle(|p| p.0, raw(of.0) - raw(on.0)), middle(|p| p.1, raw(of.1) - raw(on.1)))).is_some()
    };
    let forms = objects.iter().filter(|object| form::has_extent(object)).filter_map(form::corners);
    let found: Vec<bool> = forms.map(|corners| over(&corners.points)).collect();
    mostly(found.iter().filter(|over| **over).count() as u64, found.len() as u64)
}
