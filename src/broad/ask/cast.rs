//! Which bodies a ray or a moving box comes to.

use super::sorted::First;
use crate::broad::spatial::Spatial;
use crate::broad::{Handle, QueryError};
use crate::error::{Quantity, RangeError};
use crate::num::{DOMAIN, Raw, Toi, Vec2, fraction, umul};
use crate::query::cast::Span;
use crate::shape::Aabb;
use heapless::VecView;

/// A body whose box a ray or a moving box touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BroadHit {
    /// The body.
    pub handle: Handle,
    /// When it touches the box first, rounded down: whatever is in the box is not hit earlier.
    pub toi: Toi,
}

/// The closed counterparts of what casts ask of their spans.
impl Span {
    const fn meets(self) -> bool {
        self.gap <= self.speed && self.leave >= 0
    }

    /// Whether this is left when the other one is entered or after that: `leave / speed >= gap / speed` of the other. Products below 2^60; none where
    /// the motion ends first.
    const fn lasts_until(self, other: Self) -> bool {
        other.gap <= 0
            || self.leave >= self.speed
            || umul(self.leave as u32, other.speed as u32) >= umul(other.gap as u32, self.speed as u32)
    }

    /// The moment of entry: `gap <= speed`.
    fn entry(self) -> Toi {
        if self.gap <= 0 { Toi::ZERO } else { Toi::exact(fraction(self.gap as u32, self.speed as u32)) }
    }
}

/// When the box `a` that moves by `d` first has a point in common with the box `b`: the closed counterpart of a cast, which is a hit only where the motion
/// starts to overlap.
fn touched(a: &Aabb, d: Raw, b: &Aabb) -> Option<Toi> {
    let (alo, ahi, blo, bhi) = (a.lo(), a.hi(), b.lo(), b.hi());
    let x = Span::new(alo.x, ahi.x, blo.x, bhi.x, d.x);
    let y = Span::new(alo.y, ahi.y, blo.y, bhi.y, d.y);
    // Both intervals of time meet, each is closed, and rounding down keeps the order of the entries.
    (x.meets() && y.meets() && x.lasts_until(y) && y.lasts_until(x)).then(|| x.entry().max(y.entry()))
}

/// A sum that wraps is outside of the domain, too: it is at least 2^30 from zero.
fn checked(start: &Aabb, motion: Vec2) -> Result<Raw, RangeError> {
    let d = Raw::of(motion);
    let (lo, hi) = (start.lo().add(d), start.hi().add(d));
    for (what, low, high) in [(Quantity::MotionX, lo.x, hi.x), (Quantity::MotionY, lo.y, hi.y)] {
        for value in [low, high] {
            if value <= -DOMAIN || value >= DOMAIN {
                return Err(RangeError { what, value });
            }
        }
    }
    Ok(d)
}

/// Every body that is touched not later than the last answer of `each`.
pub(in crate::broad) fn along<S: Spatial>(
    phase: &S,
    start: &Aabb,
    motion: Vec2,
    each: impl FnMut(Handle, &S::Tag, Toi) -> Toi,
) -> Result<(), RangeError> {
    walk(phase, start, checked(start, motion)?, each);
    Ok(())
}

fn walk<S: Spatial>(phase: &S, start: &Aabb, d: Raw, mut each: impl FnMut(Handle, &S::Tag, Toi) -> Toi) {
    let bodies = phase.table();
    let mut limit = Toi::ONE;
    phase.visit_path(start, d, |slot| {
        let (Some(bounds), Some(tag)) = (bodies.bounds.get(slot), bodies.tags.get(slot)) else { return limit };
        if let Some(toi) = touched(start, d, bounds).filter(|toi| *toi <= limit) {
            limit = limit.min(each(bodies.handle(slot), tag, toi));
        }
        limit
    });
}

pub(in crate::broad) fn cast<S: Spatial>(
    phase: &S,
    start: &Aabb,
    motion: Vec2,
    mut wanted: impl FnMut(Handle, &S::Tag) -> bool,
    out: &mut VecView<BroadHit>,
) -> Result<(), QueryError> {
    out.clear();
    let d = checked(start, motion)?;
    let bodies = phase.table();
    let order = |hit: &BroadHit| (hit.toi, bodies.rank(hit.handle));
    let mut first = First::new(out, |a: &BroadHit, b: &BroadHit| order(a) < order(b));
    walk(phase, start, d, |handle, tag, toi| {
        if wanted(handle, tag) {
            first.add(BroadHit { handle, toi });
        }
        Toi::ONE
    });
    Ok(first.sort()?)
}
