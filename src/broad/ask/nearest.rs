//! Which bodies are nearest to a point.

use super::sorted::First;
use crate::broad::spatial::Spatial;
use crate::broad::table::Bodies;
use crate::broad::{Handle, QueryError, Tag};
use crate::error::{Quantity, RangeError};
use crate::num::{Fx, Raw, Vec2, check_coordinate, isqrt64, norm, usqr};
use crate::shape::Aabb;
use heapless::VecView;

/// A body near a point, and how far away its box is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Nearest {
    /// The body.
    pub handle: Handle,
    /// From the point to the nearest point of the body's box, rounded down; 0 where the box holds it.
    pub distance: Fx,
}

/// How far a box is from a point along x and along y: below 2^30.
fn apart(p: Raw, bounds: &Aabb) -> (i32, i32) {
    let gap = |p: i32, lo: i32, hi: i32| lo.wrapping_sub(p).max(p.wrapping_sub(hi)).max(0);
    let (lo, hi) = (bounds.lo(), bounds.hi());
    (gap(p.x, lo.x, hi.x), gap(p.y, lo.y, hi.y))
}

/// Where there is no such body, beyond all.
fn square<T: Tag>(bodies: Bodies<'_, T>, p: Raw, slot: usize) -> u64 {
    let Some(bounds) = bodies.bounds.get(slot) else { return u64::MAX };
    let (x, y) = apart(p, bounds);
    norm(x, y)
}

fn distance(square: u64) -> Fx {
    Fx::from_bits(isqrt64(square) as i32)
}

/// No two points of the domain are as far apart as the largest length, 2^30.5 < 2^31 raw: every length is taken, and none wraps.
fn checked(point: Vec2, within: Fx) -> Result<(Raw, i32), RangeError> {
    check_coordinate(point)?;
    let reach = within.to_bits();
    if reach < 0 { Err(RangeError { what: Quantity::Radius, value: reach }) } else { Ok((Raw::of(point), reach)) }
}

/// By exact squares; at equal ones by canonical order.
pub(in crate::broad) fn nearest<S: Spatial>(
    phase: &S,
    point: Vec2,
    within: Fx,
    mut wanted: impl FnMut(Handle, &S::Tag) -> bool,
) -> Result<Option<Nearest>, RangeError> {
    let (p, mut reach) = checked(point, within)?;
    let bodies = phase.table();
    let (mut best, mut limit) = (None, usqr(reach as u32));
    phase.visit_near(p, reach, |slot| {
        let handle = bodies.handle(slot);
        let (Some(bounds), Some(tag)) = (bodies.bounds.get(slot), bodies.tags.get(slot)) else { return reach };
        let (x, y) = apart(p, bounds);
        let square = norm(x, y);
        let first = square < limit || best.is_none_or(|best| bodies.rank(handle) < bodies.rank(best));
        if square <= limit && first && wanted(handle, tag) {
            (best, limit) = (Some(handle), square);
            // Not below the length, whose square is a^2 + b^2 <= (a + b / 2)^2 for a >= b: no root.
            reach = reach.min(x.max(y).wrapping_add(x.min(y).wrapping_add(1) >> 1));
        }
        reach
    });
    Ok(best.map(|handle| Nearest { handle, distance: distance(limit) }))
}

/// The same for all within reach.
pub(in crate::broad) fn neighbours<S: Spatial>(
    phase: &S,
    point: Vec2,
    within: Fx,
    mut wanted: impl FnMut(Handle, &S::Tag) -> bool,
    out: &mut VecView<Nearest>,
) -> Result<(), QueryError> {
    out.clear();
    let (p, reach) = checked(point, within)?;
    let bodies = phase.table();
    let limit = usqr(reach as u32);
    let order = |near: &Nearest| (square(bodies, p, near.handle.slot()), bodies.rank(near.handle));
    let mut first = First::new(out, |a: &Nearest, b: &Nearest| order(a) < order(b));
    phase.visit_near(p, reach, |slot| {
        let handle = bodies.handle(slot);
        if square(bodies, p, slot) <= limit && bodies.tags.get(slot).is_some_and(|tag| wanted(handle, tag)) {
            first.add(Nearest { handle, distance: Fx::ZERO });
        }
        reach
    });
    let told = first.sort();
    // Roots only of those that were kept.
    for near in out.iter_mut() {
        near.distance = distance(square(bodies, p, near.handle.slot()));
    }
    Ok(told?)
}
