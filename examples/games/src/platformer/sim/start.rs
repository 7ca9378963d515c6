//! Finds free space in a level without a heap.

use tilesat::world::{ShapeSet, TileMap, TileShape};
use tilesat::{Aabb, Circle, Vec2};

use super::actor::Shape;
use super::rng::Rng;

const TRIES: u32 = 48;

/// A box or ball of these half extents in free space within the map. A ball ignores `half.1`.
/// Avoids tiles with the `avoid` flags if possible.
///
/// If random tries find no position, the body shrinks to fit a cell, and the search visits every
/// cell. `None` means that the map has no free cell.
pub(super) fn place<S: ShapeSet>(
    map: &TileMap<'_, S>,
    half: (i32, i32),
    ball: bool,
    avoid: u8,
    rng: &mut Rng,
) -> Option<Shape> {
    let cell = map.cell().to_bits();
    let (width, height) = (i32::from(map.width()) * cell, i32::from(map.height()) * cell);
    let (hx, hy) = if ball { (half.0, half.0) } else { half };
    if width > 2 * hx && height > 2 * hy {
        for _ in 0..TRIES {
            let x = hx + rng.below((width - 2 * hx) as u32) as i32;
            let y = hy + rng.below((height - 2 * hy) as u32) as i32;
            let shape = shape((x, y), (hx, hy), ball)?;
            if free(map, &shape, avoid) {
                return Some(shape);
            }
        }
    }
    let limit = cell * 7 / 16;
    let half = (hx.min(limit), hy.min(limit));
    scan(map, half, ball, avoid, rng).or_else(|| scan(map, half, ball, 0, rng))
}

/// The first cell with a free middle, from a random one on.
fn scan<S: ShapeSet>(map: &TileMap<'_, S>, half: (i32, i32), ball: bool, avoid: u8, rng: &mut Rng) -> Option<Shape> {
    let cell = map.cell().to_bits();
    let (columns, rows) = (u32::from(map.width()), u32::from(map.height()));
    let (mut x, mut y) = (rng.below(columns), rng.below(rows));
    for _ in 0..columns * rows {
        let middle = (x as i32 * cell + cell / 2, y as i32 * cell + cell / 2);
        let kind = map.kind(map.cell_at(Vec2::from_raw(middle.0, middle.1)));
        if kind.shape != TileShape::Full {
            let shape = shape(middle, half, ball)?;
            if free(map, &shape, avoid) {
                return Some(shape);
            }
        }
        x += 1;
        if x == columns {
            (x, y) = (0, if y + 1 == rows { 0 } else { y + 1 });
        }
    }
    None
}

fn shape(centre: (i32, i32), half: (i32, i32), ball: bool) -> Option<Shape> {
    let centre = Vec2::from_raw(centre.0, centre.1);
    let half = Vec2::from_raw(half.0, half.1);
    if ball {
        Circle::new(centre, half.x).ok().map(Shape::Ball)
    } else {
        Aabb::from_centre(centre, half).ok().map(Shape::Box)
    }
}

fn free<S: ShapeSet>(map: &TileMap<'_, S>, shape: &Shape, avoid: u8) -> bool {
    match shape {
        Shape::Box(aabb) => !map.overlaps(aabb) && map.flags_touched(aabb) & avoid == 0,
        Shape::Ball(circle) => !map.overlaps(circle) && map.flags_touched(circle) & avoid == 0,
    }
}
