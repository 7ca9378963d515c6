//! Rays against a convex shape: the closed counterpart of its casts.
//!
//! Relative to the shape, a ray is a point that moves. Motions are below 2^30 a component, and so
//! are differences: products of a side with either stay below 2^62, as in a cast.

use super::cast::{ConvexGate, inward, is_earlier, straight};
use super::short_place::place_of;
use super::walk::{Core, PolygonSide, SideWalk};
use crate::error::RangeError;
use crate::num::{Axis, Raw, Toi, Vec2, less128, mul64, sqr64};
use crate::query::cast::kernel::{CastHit, Inside, Moment};
use crate::query::cast::moment::{Disc, is_below, meets_beyond, reach, touch_disc};
use crate::query::cast::ray::{at_start, checked, meet_point, meet_segment, reached};
use crate::query::cast::segments::{EdgeMoment, Slope};

/// The hit of a ray on a shape.
pub(super) fn cast_ray(
    shape: Core<'_>,
    origin: Vec2,
    motion: Vec2,
    inside: Inside,
) -> Result<Option<CastHit>, RangeError> {
    let (o, d) = checked(origin, motion)?;
    let eye = Core { corners: &[origin], radius: 0 };
    let gate = if shape.radius == 0 {
        match shape.corners {
            [p] => return Ok(meet_point(o.sub(Raw::of(*p)), d)),
            [a, b] => return Ok(meet_segment(o, d, Raw::of(*a), Raw::of(*b))),
            _ => sharp(eye, shape, d),
        }
    } else if place_of(eye, shape).within::<false>(shape.radius) {
        Err(Within)
    } else {
        Ok(rounded(eye, shape, d))
    };
    Ok(match gate {
        Err(Within) => at_start(motion, inside),
        Ok(gate) => gate.map(|gate| reached(&gate, d)),
    })
}

/// The exact floor of the time of a hit from outside, if the hit has only a bound.
pub(super) fn exact_toi(shape: Core<'_>, o: Vec2, d: Raw) -> Option<Toi> {
    let gate = || rounded(Core { corners: &[o], radius: 0 }, shape, d);
    if shape.radius == 0 { None } else { gate().map(|gate| gate.exact_toi(d)) }
}

/// The ray starts strictly inside.
struct Within;

/// For a polygon: the latest side through which the ray enters, if it has not left another one
/// before.
fn sharp(eye: Core<'_>, shape: Core<'_>, d: Raw) -> Result<Option<ConvexGate>, Within> {
    let (mut entry, mut exit): (Option<EdgeMoment>, Option<(u64, u64)>) = (None, None);
    // The ray starts on a side's line and does not enter by it. From the border, such a ray does
    // not lead inside.
    let mut grazes = false;
    for side in SideWalk::new(eye, shape) {
        let height = side.height();
        let (axis, speed) = inward(&side, d);
        if height <= 0 && speed > 0 {
            let gap = height.unsigned_abs();
            if gap > speed as u64 {
                return Ok(None);
            }
            let edge = EdgeMoment { gap, speed: speed as u64, axis };
            entry = Some(entry.map_or(edge, |kept| last(kept, edge)));
        } else if height < 0 {
            return Ok(None);
        } else {
            grazes |= height == 0;
            let left = (height as u64, speed.unsigned_abs());
            if speed < 0 && exit.is_none_or(|kept| less128(mul64(left.0, kept.1), mul64(kept.0, left.1))) {
                exit = Some(left);
            }
        }
    }
    let Some(entry) = entry else { return if grazes { Ok(None) } else { Err(Within) } };
    let passes = exit.is_some_and(|(gap, speed)| less128(mul64(gap, entry.speed), mul64(entry.gap, speed)));
    let leaves = passes || (grazes && entry.gap == 0);
    Ok((!leaves).then_some(ConvexGate::Edge(entry)))
}

/// The later one; at a corner, the side whose normal is more along x, as of a box.
fn last(a: EdgeMoment, b: EdgeMoment) -> EdgeMoment {
    let flat = |e: Axis, f: Axis| mul64(u64::from(e.x.unsigned_abs()), u64::from(f.y.unsigned_abs()));
    if mul64(a.gap, b.speed) == mul64(b.gap, a.speed) {
        match flat(a.axis, b.axis).cmp(&flat(b.axis, a.axis)) {
            core::cmp::Ordering::Greater => return a,
            core::cmp::Ordering::Less => return b,
            core::cmp::Ordering::Equal => {}
        }
    }
    a.later(b)
}

/// For a rounded shape outside which the ray starts: a side moved out, or the first disc around a
/// corner.
fn rounded(eye: Core<'_>, shape: Core<'_>, d: Raw) -> Option<ConvexGate> {
    let walk = SideWalk::new(eye, shape);
    let mut first: Option<(Toi, Disc)> = None;
    let mut around = |m: Raw| {
        if let Some((toi, disc)) = touch_disc(m, shape.radius, d) {
            if first.is_none_or(|kept| is_earlier((toi, disc), kept, d)) {
                first = Some((toi, disc));
            }
        }
    };
    around(walk.corner().at);
    for side in walk {
        if let Some(gate) = through(&side, shape.radius, d) {
            return Some(gate);
        }
        around(side.from);
    }
    first.map(|(_, disc)| ConvexGate::Disc(disc))
}

/// The side moved out by the radius, if the ray enters by it between its ends, also at the very end
/// of its motion.
fn through(side: &PolygonSide, radius: i32, d: Raw) -> Option<ConvexGate> {
    let height = side.height();
    let (axis, speed) = inward(side, d);
    if height > 0 || speed <= 0 {
        return None;
    }
    let (gap, into, reach) = (height.unsigned_abs(), speed as u64, reach(radius, axis));
    let falls_short = gap > into && less128(reach, sqr64(gap.wrapping_sub(into)));
    if is_below(gap, reach) || falls_short {
        return None;
    }
    let dir = Axis::new(side.edge.x.wrapping_neg(), side.edge.y.wrapping_neg());
    let between =
        meets_beyond(side.from, d, dir, false, radius) && meets_beyond(side.from.add(side.edge), d, dir, true, radius);
    between.then(|| {
        if axis.x != 0 && axis.y != 0 {
            ConvexGate::Slope(Slope::new(gap, into, reach, axis))
        } else {
            straight(side, radius, d)
        }
    })
}
