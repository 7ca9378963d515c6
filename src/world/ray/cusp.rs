//! Where a ray that slides along a surface runs into a gap that closes to nothing.

use super::cast::side_against;
use super::dda::along;
use super::level::RayLevel;
use super::piece::{Met, Time, Touch};
use super::walk::Walk;
use crate::num::{Axis, Raw};
use crate::world::{Cell, Feature, Geometry};

/// What a ray along a grid line meets at the last line that it has crossed, or at its start on one, where it comes out of the open and goes into the
/// solid and no piece opposes it.
///
/// That is between a convex arc and the surface that it touches: both are tangent to the ray, and what is behind the point has no face there.
///
/// ```text
///       ....                  The arc ends at P with the ray's direction; the floor below goes on behind P, and so does the solid
///   .solid..`.                above it. The hit has the point for a face, across the ray.
///   ..........P<-------- ray
///   .......solid.........
/// ```
#[inline(never)]
pub(in crate::world) fn cusp<L: RayLevel>(level: &L, o: Raw, d: Raw, walk: &Walk) -> Option<Met> {
    let cell = level.grid().cell as u32;
    if along(&walk.x, &walk.y, cell) == 0 {
        return None;
    }
    let side = if d.x != 0 { &walk.x } else { &walk.y };
    // The line before the next one; none is crossed yet where that is behind the start.
    let way = side.near.checked_sub(cell)?;
    if side.size == 0 || way > side.size {
        return None;
    }
    let by = side.step.wrapping_mul(way as i32);
    let p = o.add(if d.x != 0 { Raw { x: by, y: 0 } } else { Raw { x: 0, y: by } });
    let back = Raw { x: d.x.wrapping_neg(), y: d.y.wrapping_neg() };
    let solid = |d: Raw| level.enters(p, d, &level.walk(p, d));
    if !solid(d) || solid(back) {
        return None;
    }
    let normal = Axis::new(back.x.signum(), back.y.signum());
    let (x, y) = (walk.x.cell, walk.y.cell);
    let dir = normal.perp();
    let feature = Feature {
        geometry: Geometry::Face { a: p.vec2(), dir, len: 0, joined: [true; 2] },
        cell: Cell::of(x, y),
        index: side_against(normal),
        flags: level.flags(x, y),
        one_way: false,
        source: 0,
    };
    let time = Some(Time { num: u64::from(way), den: u64::from(side.size) });
    Some(Met { feature, touch: Touch { time, normal } })
}
