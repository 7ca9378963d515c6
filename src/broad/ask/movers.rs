//! The pairs of a few among many.

use crate::broad::spatial::Spatial;
use crate::broad::{BroadError, Handle, Pair};
use crate::num::DOMAIN;
use crate::shape::Aabb;

/// How far a body steps aside along y while the others are asked: out of the domain, so that nothing in it touches the box, and back without
/// a rounding. Coordinates below 2^29 become ones in 2^29..2^31; x, and with it an order by x, stays.
const ASIDE: i32 = DOMAIN << 1;

/// Every pair with one of the movers, once: whom a mover met it is not met by, because it stands aside from then on. That takes no memory and asks for no
/// order, and a mover that is named twice is aside the second time.
pub(in crate::broad) fn pairs_of<S: Spatial>(
    phase: &mut S,
    movers: &[Handle],
    mut each: impl FnMut(Pair),
) -> Result<(), BroadError> {
    let bodies = phase.table();
    for &mover in movers {
        bodies.slot(mover)?;
    }
    let stage = Stage { phase, movers };
    for mover in movers {
        let slot = mover.slot();
        let Some(bounds) = stage.phase.table().bounds.get(slot).copied().filter(|b| !is_aside(b)) else { continue };
        put(stage.phase, slot, &bounds, ASIDE);
        let bodies = stage.phase.table();
        stage.phase.visit(&bounds, |other| {
            if let Some(pair) = bodies.pair(slot, other) {
                each(pair);
            }
        });
    }
    Ok(())
}

/// Brings all movers back at the end, even where `each` panics.
struct Stage<'a, S: Spatial> {
    phase: &'a mut S,
    movers: &'a [Handle],
}

impl<S: Spatial> Drop for Stage<'_, S> {
    fn drop(&mut self) {
        for mover in self.movers {
            let slot = mover.slot();
            if let Some(bounds) = self.phase.table().bounds.get(slot).copied().filter(is_aside) {
                put(self.phase, slot, &bounds, -ASIDE);
            }
        }
    }
}

fn is_aside(bounds: &Aabb) -> bool {
    bounds.lo().y >= DOMAIN
}

/// In the table alone: no structure hears of it, and no enumeration that is under way is disturbed.
fn put<S: Spatial>(phase: &mut S, slot: usize, bounds: &Aabb, by: i32) {
    let (mut lo, mut hi) = (bounds.lo(), bounds.hi());
    (lo.y, hi.y) = (lo.y.wrapping_add(by), hi.y.wrapping_add(by));
    if let Some(place) = phase.slots().bounds.get_mut(slot) {
        *place = Aabb::from_raw_unchecked(lo, hi);
    }
}
