//! The boxes and lifts that a character of a scene may meet in a step.

use super::body::Slot;
use super::kernel::BodyShape;
use super::meeting_time::{around, may_meet, senses};
use super::{Scene, SceneBody};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::query::{Overlaps, Touches};
use crate::shape::Aabb;
use crate::world::Solid;
use heapless::Vec;

/// The most boxes and lifts that count. Of more, the nearest do.
const MOST: usize = 16;

/// The smallest key of a box of a body in the list. A list of its own numbers them by the keys of
/// their bodies, which may be larger than that of a solid.
const KEYS: u16 = u16::MAX - MOST as u16;

/// Which bodies count.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Boxes {
    /// Fixed ones, from all sides.
    Fixed,
    /// Also those that can move and are entirely below a character that falls toward larger y, or
    /// toward smaller y.
    AndBelow { larger_y: bool },
}

/// Where a solid comes from.
#[derive(Clone, Copy)]
struct Origin {
    /// The gap to the character, then the key and the slot. No order of the broad phase counts.
    rank: (u32, u32, usize),
    body: Option<Handle>,
}

/// The nearest boxes of bodies and lifts, as solids.
pub(super) struct Reached {
    solids: Vec<Solid, MOST>,
    origins: Vec<Origin, MOST>,
}

impl Reached {
    /// Those that are at most so far from a box, the bounds of `own`.
    pub(super) fn of<P, S, const N: usize, const M: usize>(
        scene: &Scene<P, N, M, S>,
        own: (Handle, &Aabb),
        lifts: &[Solid],
        far: u32,
        boxes: Boxes,
    ) -> Self
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let (own, bounds) = own;
        let region = around(bounds, far);
        let mut reached = Self { solids: Vec::new(), origins: Vec::new() };
        for (slot, lift) in lifts.iter().enumerate().filter(|(_, lift)| lift.shape().touches(&region)) {
            let rank = (gap(bounds, &lift.shape()), lift.key().into(), slot);
            reached.add(*lift, Origin { rank, body: None });
        }
        scene.near.in_region(&region, |other| {
            let slot = |at: Handle| scene.slots.get(at.slot());
            let Some((one, two)) = slot(own).zip(slot(other)) else { return };
            if other == own || senses(one, two) || !may_meet(one, two) {
                return;
            }
            if let Some(solid) = solid_of(two, bounds, boxes) {
                let rank = (gap(bounds, &solid.shape()), two.body.key, other.slot());
                reached.add(solid, Origin { rank, body: Some(other) });
            }
        });
        reached.number();
        reached
    }

    fn add(&mut self, solid: Solid, origin: Origin) {
        if self.solids.push(solid).is_ok() {
            let pushed = self.origins.push(origin);
            debug_assert!(pushed.is_ok(), "both lists have as many places");
            return;
        }
        let all = self.origins.iter_mut().zip(&mut self.solids);
        if let Some(last) = all.max_by_key(|(known, _)| known.rank).filter(|(known, _)| origin.rank < known.rank) {
            (*last.0, *last.1) = (origin, solid);
        }
    }

    /// Gives the boxes of bodies keys that rank as the keys of the bodies do.
    fn number(&mut self) {
        let by_key = |one: &Origin| (one.rank.1, one.rank.2);
        for (one, solid) in self.origins.iter().zip(&mut self.solids).filter(|(one, _)| one.body.is_some()) {
            let before = |other: &&Origin| other.body.is_some() && by_key(other) < by_key(one);
            let key = KEYS + self.origins.iter().filter(before).count() as u16;
            *solid = Solid::new(solid.shape(), key).unwrap_or(*solid);
        }
    }

    /// The solids.
    pub(super) fn solids(&self) -> &[Solid] {
        &self.solids
    }

    /// The body whose solid has a key.
    pub(super) fn body(&self, key: u16) -> Option<Handle> {
        let known = self.origins.iter().zip(&self.solids);
        known.filter(|(_, solid)| solid.key() == key).find_map(|(one, _)| one.body)
    }
}

/// How far two boxes are apart, along the axis on which they are farther apart.
fn gap(a: &Aabb, b: &Aabb) -> u32 {
    let apart = |a: (i32, i32), b: (i32, i32)| (b.0 - a.1).max(a.0 - b.1).max(0);
    let (x, y) = (|it: &Aabb| (it.lo().x, it.hi().x), |it: &Aabb| (it.lo().y, it.hi().y));
    apart(x(a), x(b)).max(apart(y(a), y(b))).unsigned_abs()
}

/// The solid that a body is for a character with these bounds. A box that can move lets it pass
/// from the sides: it is pushed. As a one-way solid, it would let through a character that drops.
fn solid_of<S: BodyShape>(slot: &Slot<S>, character: &Aabb, boxes: Boxes) -> Option<Solid> {
    let SceneBody { shape, mass, .. } = &slot.body;
    let bounds = shape.aabb();
    if *shape != bounds.into() {
        return None;
    }
    let blocks = match boxes {
        _ if mass.is_none() => return Solid::new(trimmed(&bounds, character)?, 0).ok(),
        Boxes::Fixed => false,
        Boxes::AndBelow { larger_y: true } => character.hi().y <= bounds.lo().y,
        Boxes::AndBelow { larger_y: false } => character.lo().y >= bounds.hi().y,
    };
    Solid::new(bounds, 0).ok().filter(|_| blocks)
}

/// A fixed box without the part that a character overlaps, cut at the nearest side. So the
/// character goes no deeper, until the scene has parted the two.
fn trimmed(bounds: &Aabb, character: &Aabb) -> Option<Aabb> {
    if !bounds.overlaps(character) {
        return Some(*bounds);
    }
    let (lo, hi) = (bounds.min(), bounds.max());
    let (near, far) = (character.min(), character.max());
    let (mut from, mut to) = (lo, hi);
    let [above, below, left, right] = [far.y - lo.y, hi.y - near.y, far.x - lo.x, hi.x - near.x];
    let least = above.min(below).min(left).min(right);
    if least == above {
        from.y = far.y;
    } else if least == below {
        to.y = near.y;
    } else if least == left {
        from.x = far.x;
    } else {
        to.x = near.x;
    }
    Aabb::new(from, to).ok()
}
