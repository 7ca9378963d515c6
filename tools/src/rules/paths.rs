//! Outlines beside the grid, for tiles that are not a shape of the library.

use std::collections::BTreeMap;

use tilesat::TileShape;

use super::cells::{Cells, Placed};
use super::flags::Flags;
use super::kind::Kind;
use super::knots::{self, Knot};
use super::likeness;
use super::outline::{Outline, Title};
use super::place::Unit;
use super::union;
use super::weld::{self, Form};
use super::{flat, words};
use crate::model::decimal::Decimal;
use crate::model::object::{self, Spot};

/// Raw corners.
type Polygon = Vec<(i64, i64)>;

/// The outlines of these cells' paths. Welds their corners by up to `weld` raw units, and joins
/// polygons of the same flags.
///
/// # Errors
///
/// If a polygon crosses itself, and its inside is not clear.
pub(super) fn outlines(
    cells: &Cells,
    unit: Unit,
    weld: i64,
    flags: &Flags,
    notes: &mut Vec<String>,
) -> Result<Vec<Outline>, String> {
    let mut outlines = Vec::new();
    let mut polygons: Vec<(u8, Vec<Polygon>)> = Vec::new();
    let (mut error, mut layers): (u32, Vec<&str>) = (0, Vec::new());
    // Slips in the collision editor: their layer and what is wrong, how many, and where.
    let mut empty: BTreeMap<(&str, String), (usize, Spot)> = BTreeMap::new();
    let shown: Vec<&Placed> = cells.paths.iter().filter(|placed| !cells.hides(&placed.path)).collect();
    let (drawn, welded) = welded(cells, &shown, weld);
    if let Some(torn) = shown.iter().find(|placed| placed.path.torn) {
        let count = shown.iter().filter(|placed| placed.path.torn).count();
        notes.push(format!(
            "{count} polygons are parts of collision polygons that cross themselves, the first in layer '{}' at {}: \
             each part counts; put their corners in order",
            torn.layer,
            pixels(torn.path.points[0])
        ));
    }
    for (placed, points) in shown.into_iter().zip(drawn) {
        let raw: Polygon = points.iter().map(|&(x, y)| (unit.raw(x).0, unit.raw(y).0)).collect();
        if let Some(why) = flat::why(placed.path.kind, placed.path.closed, &raw) {
            empty.entry((&placed.layer, why)).or_insert((0, points[0])).0 += 1;
            continue;
        }
        error = error.max(placed.path.error);
        let has_inside = placed.path.closed && placed.path.kind.has_area();
        if has_inside && matches!(knots::of(&object::raw(&points)), Knot::Unclear(_)) {
            return Err(format!(
                "layer '{}': a collision polygon of its tile at {} crosses itself, and its inside is not clear: draw \
                 two polygons, or put its corners in order",
                placed.layer,
                pixels(points[0])
            ));
        }
        if placed.path.closed && placed.path.kind == Kind::Solid {
            if !layers.contains(&placed.layer.as_str()) {
                layers.push(&placed.layer);
            }
            match polygons.iter_mut().find(|(mask, _)| *mask == placed.flags) {
                Some((_, all)) => all.push(raw),
                None => polygons.push((placed.flags, vec![raw])),
            }
        } else {
            let (kind, closed) = (placed.path.kind, placed.path.closed);
            outlines.push(outline((kind, closed), raw, flags.of(placed.flags), &placed.layer));
        }
    }
    for (mask, all) in polygons {
        for path in union::union(&all) {
            let kind = if path.hole { Kind::Hole } else { Kind::Solid };
            outlines.push(outline((kind, true), path.points, flags.of(mask), &layers.join(" + ")));
        }
    }
    notes.extend(empty.into_iter().map(|((layer, why), (count, at))| {
        let shapes = words::several(count, "collision shape");
        format!("{shapes} of tiles in layer '{layer}', the first at {}: {why}", pixels(at))
    }));
    if error > 0 {
        notes.push(format!("ellipses of tiles are polygons within them, off by at most 0.{error:03} px"));
    }
    if welded > 0 {
        let most = Decimal::whole(weld).scaled(1, 1 << 16).to_f64();
        notes.push(format!(
            "{welded} corners of tiles' shapes are welded: each was within {most} px of its tile's border or of another \
             corner (--weld 0 leaves them as drawn)"
        ));
    }
    Ok(outlines)
}

/// The corners of each path after welding, and how many moved.
fn welded(cells: &Cells, shown: &[&Placed], weld: i64) -> (Vec<Vec<Spot>>, u32) {
    let mut all: Vec<Vec<Spot>> = shown.iter().map(|placed| placed.path.points.clone()).collect();
    let mut forms: Vec<Form<'_>> = all
        .iter_mut()
        .zip(shown)
        .map(|(points, placed)| Form { points, closed: placed.path.closed, drawn: placed.path.error == 0 })
        .collect();
    let shapes: Vec<Polygon> = TileShape::ALL.iter().map(|shape| on_border(*shape, cells.tile)).collect();
    let near = |point| {
        cells
            .shapes_near(point, weld)
            .flat_map(|(at, shape)| shapes[shape as usize].iter().map(move |p| (at.0 + p.0, at.1 + p.1)))
            .collect()
    };
    let moved = weld::onto_neighbours(&mut forms, near, weld);
    (all, moved + shown.iter().map(|placed| placed.path.welded).sum::<u32>())
}

/// The corners of a shape on the border of its cell. Those within are no other tile's neighbours.
fn on_border(shape: TileShape, tile: u16) -> Polygon {
    let raw = |v: f64| (v * 65536.0).round() as i64;
    let ends = likeness::outline(shape, tile).into_iter().flat_map(|(a, b)| [a, b]);
    let edge = |v: i64| v == 0 || v == i64::from(tile) << 16;
    let mut corners: Polygon = ends.map(|(x, y)| (raw(x), raw(y))).filter(|p| edge(p.0) || edge(p.1)).collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

fn pixels((x, y): Spot) -> String {
    format!("({}, {})", x.to_f64(), y.to_f64())
}

fn outline((kind, closed): (Kind, bool), points: Polygon, flags: Vec<String>, layer: &str) -> Outline {
    let rounding = vec![0; points.len()];
    Outline { title: Title::tiles(layer), kind, closed, points, rounding, flags }
}
