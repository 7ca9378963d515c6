//! Outlines beside the grid, for tiles that are not a shape of the library.

use super::cells::Cells;
use super::flags::Flags;
use super::kind::Kind;
use super::outline::{Outline, Title};
use super::place::Unit;
use super::union;

/// Raw corners.
type Polygon = Vec<(i64, i64)>;

/// The outlines of these cells' paths. Joins polygons of the same flags.
pub(super) fn outlines(cells: &Cells, unit: Unit, flags: &Flags, notes: &mut Vec<String>) -> Vec<Outline> {
    let mut outlines = Vec::new();
    let mut polygons: Vec<(u8, Vec<Polygon>)> = Vec::new();
    let (mut error, mut layers): (u32, Vec<&str>) = (0, Vec::new());
    for placed in cells.paths.iter().filter(|placed| !cells.hides(&placed.path)) {
        let raw = placed.path.points.iter().map(|&(x, y)| (unit.raw(x).0, unit.raw(y).0)).collect();
        error = error.max(placed.path.error);
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
    if error > 0 {
        notes.push(format!("ellipses of tiles are polygons within them, off by at most 0.{error:03} px"));
    }
    outlines
}

fn outline((kind, closed): (Kind, bool), points: Polygon, flags: Vec<String>, layer: &str) -> Outline {
    let rounding = vec![0; points.len()];
    Outline { title: Title::tiles(layer), kind, closed, points, rounding, flags }
}
