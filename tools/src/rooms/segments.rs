//! The polygons that a room needs: all that reach it or its apron, whole.

use tilesat::Fx;

use super::Baked;
use super::part::Part;
use crate::bake::segments::Shapes;
use crate::fail::Result;
use crate::rules::flags::Flags;
use crate::rules::outline::Outline;

/// The bytes of a room's segment map, by the coordinates of the room; `None` where nothing reaches it.
pub(super) fn of(parts: &[Part], room: &Baked, cell: u16, apron: u16, flags: &mut Flags) -> Result<Option<Vec<u8>>> {
    let side = i64::from(cell) << 16;
    let first = (i64::from(room.first.0) * side, i64::from(room.first.1) * side);
    let margin = i64::from(apron) * side;
    let (right, bottom) = (i64::from(room.size.0) * side + margin, i64::from(room.size.1) * side + margin);
    let outlines = parts.iter().flat_map(|part| &part.outlines);
    let outlines = outlines.map(|outline| moved(outline, first));
    let reaches = |outline: &Outline| {
        let along = |range: (i64, i64), end: i64| range.0 <= end && range.1 >= -margin;
        let x = span(outline.points.iter().map(|p| p.0));
        let y = span(outline.points.iter().map(|p| p.1));
        along(x, right) && along(y, bottom)
    };
    let outlines: Vec<Outline> = outlines.filter(reaches).collect();
    if outlines.is_empty() {
        return Ok(None);
    }
    Shapes::of(&outlines, flags)?.build(&outlines, Fx::from_num(cell)).map(Some)
}

fn moved(outline: &Outline, by: (i64, i64)) -> Outline {
    let points = outline.points.iter().map(|p| (p.0 - by.0, p.1 - by.1)).collect();
    Outline { points, ..outline.clone() }
}

/// The least and the most.
fn span(values: impl Iterator<Item = i64>) -> (i64, i64) {
    values.fold((i64::MAX, i64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)))
}
