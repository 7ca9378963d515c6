//! Motions that meet one face, or one corner, and then nothing, as most that meet anything. The
//! result is that of [`follow`](Mover::follow), which takes two rounds and more work.

use super::body::{Body, Entry, is_by_lines};
use super::mover::Mover;
use super::plane::{FAR, NEAR, into, project, way};
use super::response::{Law, Response, Smooth};
use super::run::{straightened, turned};
use super::search::{Around, holds_one, hull, piece_of};
use crate::num::{Raw, Toi, mul_div, umul};
use crate::world::{Feature, Fill, World};

/// A motion up to its only hit, the motion after it, and the velocity after it.
pub(super) struct OnlyHit {
    pub(super) toi: Toi,
    pub(super) made: Raw,
    pub(super) rest: Raw,
    pub(super) v: Raw,
}

impl<S: Law> Mover<S> {
    /// The motion of a body whose first hit this is, if it is known to meet nothing afterwards. A
    /// body that needs tests on its way (`known` is `None`) may only stay where it is.
    #[inline]
    pub(super) fn only_hit<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        (entry, feature): (&Entry, &Feature),
        known: Option<&Around>,
    ) -> Option<OnlyHit> {
        let normal = entry.normal;
        if feature.one_way && self.passes_one_way() {
            return None;
        }
        let toi = if entry.num == 0 { Toi::ZERO } else { Toi::clamped(mul_div(Toi::ONE.raw(), entry.num, entry.den)) };
        match self.response_to(normal, feature, toi) {
            Response::Touch => return None,
            Response::Bounce if !self.surface.surface().stops(d, normal) => return None,
            Response::Slide | Response::DropThrough | Response::Bounce => {}
        }
        let hit = if let Some(step) = entry.step {
            if !W::GRID || !B::MEETS_CORNERS || B::ANGULAR || known.is_none() {
                return None;
            }
            self.around_corner(world, body, d, (entry, feature), (step, toi))?
        } else {
            self.along_face(world, body, d, (entry, toi), known)?
        };
        for part in [hit.made, hit.rest] {
            if !part.is_zero() {
                world.made(part);
            }
        }
        Some(hit)
    }

    /// A face along x or y takes one component of the motion and leaves the other as it is, unless
    /// there is friction. If the rest leads through a region that is known to be empty, no surface
    /// nearby matters.
    #[inline]
    fn along_face<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        (entry, toi): (&Entry, Toi),
        known: Option<&Around>,
    ) -> Option<OnlyHit> {
        let normal = entry.normal;
        if entry.at_end || (normal.x != 0 && normal.y != 0) {
            return None;
        }
        let v = if S::SMOOTH {
            if normal.x == 0 { Raw { x: d.x, y: 0 } } else { Raw { x: 0, y: d.y } }
        } else {
            project::<B, W, S>(d, normal, &self.surface)
        };
        let made = if entry.num == 0 { Raw::ZERO } else { entry.displacement_at(d, Some(toi.raw())) };
        let left = d.sub(made);
        let rest = if S::SMOOTH {
            Raw { x: if v.x == 0 { 0 } else { left.x }, y: if v.y == 0 { 0 } else { left.y } }
        } else {
            turned(left, d, v, after(toi, entry))
        };
        if !made.is_zero() || !rest.is_zero() {
            let (around, way) = (known?, piece_of(&body.shifted(made).bounds(), Raw::ZERO, rest, 1));
            let free =
                if is_by_lines::<W, B>() { rest.is_zero() || world.is_known_empty(&way) } else { around.is_free(&way) };
            if !free {
                return None;
            }
        }
        Some(OnlyHit { toi, made, rest, v })
    }

    /// If a full cell is all that is near a body that meets its corner, it goes on along the
    /// tangent there.
    ///
    /// With `n` from the corner to the centre, the block is behind the line across `n` through the
    /// corner. A way along the tangent does not cross that line, and enters nothing. Of all ways
    /// that do not cross it, the tangent is the nearest to the velocity, so the projection on it is
    /// the longest. The sides of the block, which the body touches at their ends, add only shorter
    /// ones.
    #[inline(never)]
    fn around_corner<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        d: Raw,
        (entry, feature): (&Entry, &Feature),
        (step, toi): (Raw, Toi),
    ) -> Option<OnlyHit> {
        let n = entry.normal;
        let is_full = W::BLOCKS || world.fill(feature.cell.x.into(), feature.cell.y.into()) == Fill::Full;
        if n.x == 0 || n.y == 0 || !is_full || into(d, n) >= 0 {
            return None;
        }
        let smooth = project::<B, W, _>(d, n, &Smooth);
        if way(smooth) <= NEAR {
            return None;
        }
        let v = if S::SMOOTH { smooth } else { project::<B, W, S>(d, n, &self.surface) };
        let rest = straightened::<B, W>(turned(d.sub(step), d, v, after(toi, entry)), n);
        let region = hull(&body.shifted(step).bounds(), Raw::ZERO, rest, FAR as i32 + 2);
        // Longer ways are looked at in pieces, which costs less.
        let alone = way(rest) >> 1 <= world.cell_size() && holds_one(world, &region);
        alone.then_some(OnlyHit { toi, made: step, rest, v })
    }
}

/// The time after a hit: `toi` is the time before it, rounded down. The result is rounded down,
/// too.
fn after(toi: Toi, entry: &Entry) -> Toi {
    let part = u32::from(umul(toi.raw(), entry.den) != umul(Toi::ONE.raw(), entry.num));
    Toi::clamped(Toi::ONE.raw().wrapping_sub(toi.raw()).wrapping_sub(part))
}
