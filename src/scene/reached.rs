//! The bodies and lifts that a character of a scene may meet in a step.

use super::kernel::BodyShape;
use super::meeting_time::{around, may_meet, senses};
use super::{Scene, SceneBody};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::num::{Fx, MOTION, Vec2};
use crate::query::{Overlaps, Touches};
use crate::shape::Aabb;
use crate::world::Solid;
use heapless::Vec;

/// The most bodies and lifts that count. Of more, the nearest do.
const MOST: usize = 16;

/// The smallest key of a body in the list. A list of its own numbers them by the keys of
/// their bodies, which may be larger than that of a solid.
const KEYS: u16 = u16::MAX - MOST as u16;

/// Which bodies count.
#[derive(Clone, Copy)]
pub(super) enum MetBodies<S> {
    /// Fixed boxes, from all sides.
    FixedBoxes,
    /// Also the floors of a character of this shape, which falls toward larger y, or toward smaller
    /// y. These are boxes that can move, up to `step` above its feet. Bodies of other shapes are
    /// floors if it would land on them.
    AndFloors { of: S, larger_y: bool, step: Fx },
}

/// Where a solid comes from.
#[derive(Clone, Copy)]
struct Origin {
    /// The gap to the character, then the key and the slot. No order of the broad phase counts.
    rank: (u32, u32, usize),
    body: Option<Handle>,
}

/// The nearest bodies and lifts, as solids.
pub(super) struct Reached {
    solids: Vec<Solid, MOST>,
    origins: Vec<Origin, MOST>,
}

impl Reached {
    /// Those that are at most so far from a box, the bounds of `own`.
    pub(super) fn of<P, S, const N: usize, const M: usize>(
        scene: &Scene<P, N, M, S>,
        (own, bounds): (Handle, &Aabb),
        lifts: &[Solid],
        far: u32,
        bodies: MetBodies<S>,
    ) -> Self
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let region = around(bounds, far);
        let mut reached = Self { solids: Vec::new(), origins: Vec::new() };
        for (slot, lift) in lifts.iter().enumerate().filter(|(_, lift)| lift.shape().touches(&region)) {
            let rank = (gap(bounds, &lift.shape()), lift.key().into(), slot);
            reached.add(*lift, Origin { rank, body: None });
        }
        each_met(scene, own, &region, |other, body| {
            if let Some(solid) = solid_of(body, bounds, far, bodies) {
                let rank = (gap(bounds, &solid.shape()), body.key, other.slot());
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

    /// Gives the solids of bodies keys that rank as the keys of the bodies do.
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

    /// Whether the solid with a key is a body that can move.
    pub(super) fn is_loose<P, S, const N: usize, const M: usize>(&self, key: u16, scene: &Scene<P, N, M, S>) -> bool
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        self.body(key).is_some_and(|body| scene.body(body).is_ok_and(|body| body.mass.is_some()))
    }
}

/// Calls `each` with the bodies at a region that meet one.
pub(super) fn each_met<P, S, const N: usize, const M: usize>(
    scene: &Scene<P, N, M, S>,
    own: Handle,
    region: &Aabb,
    mut each: impl FnMut(Handle, &SceneBody<S>),
) where
    P: BroadPhase<Tag = Keyed<Filter>>,
    S: BodyShape,
{
    scene.near.in_region(region, |other| {
        let slot = |at: Handle| scene.slots.get(at.slot());
        let Some((one, two)) = slot(own).zip(slot(other)) else { return };
        if other != own && !senses(one, two) && may_meet(one, two) {
            each(other, &two.body);
        }
    });
}

/// How far two boxes are apart, along the axis on which they are farther apart.
fn gap(a: &Aabb, b: &Aabb) -> u32 {
    let apart = |a: (i32, i32), b: (i32, i32)| (b.0 - a.1).max(a.0 - b.1).max(0);
    let (x, y) = (|it: &Aabb| (it.lo().x, it.hi().x), |it: &Aabb| (it.lo().y, it.hi().y));
    apart(x(a), x(b)).max(apart(y(a), y(b))).unsigned_abs()
}

/// The solid that a body is for a character with these bounds. A box that can move lets it pass
/// from the sides: it is pushed. As a one-way solid, it would let through a character that drops.
fn solid_of<S: BodyShape>(body: &SceneBody<S>, character: &Aabb, far: u32, bodies: MetBodies<S>) -> Option<Solid> {
    let SceneBody { shape, mass, .. } = body;
    let bounds = shape.aabb();
    let solid = match bodies {
        _ if *shape == bounds.into() && mass.is_none() => trimmed(&bounds, character)?,
        MetBodies::FixedBoxes => return None,
        MetBodies::AndFloors { of, larger_y, .. } if *shape != bounds.into() => plate(&of, shape, far, larger_y)?,
        MetBodies::AndFloors { larger_y, step, .. } => {
            let (feet, top) =
                if larger_y { (character.max().y, bounds.min().y) } else { (-character.min().y, -bounds.max().y) };
            if top < feet - step {
                return None;
            }
            trimmed(&bounds, character)?
        }
    };
    Solid::new(solid, 0).ok()
}

/// The floor that a body of another shape is for a character above it. Its top is where the
/// character would meet the body, moved straight down. No floor is steeper than 45 degrees.
///
/// ```text
///     +---+         Each step has a plate of its own. It is lower as the character runs
///     |   |         outward, and a walker snaps to it. As it runs inward, it sinks into
///   --+---+----     the body, and the scene's step parts the two.
///   .'  `.
/// ```
#[inline(never)]
fn plate<S: BodyShape>(character: &S, body: &S, far: u32, larger_y: bool) -> Option<Aabb> {
    let far = far.min(MOTION as u32 - 1) as i32;
    let down = Vec2::from_raw(0, if larger_y { far } else { far.wrapping_neg() });
    let hit = character.run_into(down, body, Vec2::ZERO)?;
    let axis = if hit.inside { character.contact(body)?.axis().reversed() } else { hit.axis };
    let rises = if larger_y { axis.y.wrapping_neg() } else { axis.y };
    if rises < axis.x.wrapping_abs() {
        return None;
    }
    let (own, other, (_, by)) = (character.aabb(), body.aabb(), hit.displacement.raw());
    let (mut lo, mut hi) = (other.lo(), other.hi());
    // A round character stands on its middle, which may be beside the body.
    let sum = own.lo().x.wrapping_add(own.hi().x);
    lo.x = lo.x.min(sum >> 1);
    hi.x = hi.x.max(sum.wrapping_sub(sum >> 1));
    if larger_y {
        lo.y = own.hi().y.wrapping_add(by);
        hi.y = hi.y.max(lo.y.wrapping_add(1));
    } else {
        hi.y = own.lo().y.wrapping_add(by);
        lo.y = lo.y.min(hi.y.wrapping_sub(1));
    }
    Aabb::new(lo.vec2(), hi.vec2()).ok()
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
