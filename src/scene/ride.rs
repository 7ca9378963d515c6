//! Moving solids carry and push the bodies of a scene.

use super::body::ALOFT;
use super::kernel::{BodyShape, Visit};
use super::level_of_body::{Sliding, sliding};
use super::meeting_time::{around, may_meet, senses};
use super::memory::Remembered;
use super::reply::Unasked;
use super::velocities::toward;
use super::{Scene, SceneError, SceneFault};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::error::{Quantity, RangeError};
use crate::filter::Filter;
use crate::motion::{Body, Mover, MovingSolid, Ride};
use crate::num::{Fx, MOTION, Vec2};
use crate::query::Touches;
use crate::world::{Joined, World};
use core::cmp::Reverse;
use core::mem::take;

/// How far from a solid a body may be that still stands on it, in raw units.
const NEAR: u32 = 8;

/// How far above another body a body may be that lies on it, in raw units. Steps round by 2. If the
/// lower one slid down a slope in the step before, gaps of 14 occurred.
const GAP: i32 = 32;

/// The effect of a ride on a body. It is stored where the next step counts hits, with the motion of
/// its carrier (`kick`) and the push of a solid (`low`).
const STAYS: u16 = 0;
const CARRIED: u16 = 1;
/// Lies on a body that is carried.
const TAKEN: u16 = 2;
/// It was in a solid's way.
const PUSHED: u16 = 3;
/// It has no room, or it cannot be moved.
const HELD: u16 = 4;

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Moves solids, which carry the bodies that stand on them, with whole piles, and push those in
    /// front of them.
    ///
    /// All solids make their motions or [turns](crate::world::ConvexSolid::with_turn) at once. Call
    /// this once per frame, *before* the [step](Self::step), with all solids in one list: a
    /// `ConvexSolid<AnyShape<N>>` can be a box, too. Pass the plain level here, and step in the
    /// level [joined](crate::Joined) with the solids. There bodies stand on the solids, bounce off
    /// them, and bullets hit them. [`Solids::key_of`](crate::Solids::key_of) returns the key of the
    /// solid of a hit.
    ///
    /// ```text
    ///   1 ride: the solids move, and what        2 step: gravity, velocities, and bodies
    ///     stands on them or is in the way          against bodies
    ///         [b]      [b]                              [b] ->
    ///       _.-'|    _.-'|                            _.-'|
    ///    .-'----' -> ----'                         .-'----'
    /// ```
    ///
    /// - The rules are those of [`Mover::ride`](crate::Mover::ride) and
    ///   [`Mover::ride_convex`](crate::Mover::ride_convex). "Up" is against `gravity`; without
    ///   gravity, nothing is carried. `follow` is how far a body moves down with a floor that sinks
    ///   in this frame. Pass at least the motion of your fastest lift, or bodies hop on it. A slope
    ///   that moves sideways sinks, too.
    /// - **Velocities** are relative to the solid: a body that is carried keeps its velocity. If a
    ///   body shall leave a lift with the lift's speed, [push](Self::push) it by the motion that
    ///   the ride gave it. To find that motion, also on a solid that turns, compare the body's
    ///   position before and after this call: [`Shape::position`](super::Shape::position).
    /// - **Piles**: a body on a carried body makes the same motion, as far as the level and the
    ///   solids allow. A body on several moves with the one that rises most, then with the smaller
    ///   key. If a solid pushes it as well, the push comes first. Other bodies do not stop a ride;
    ///   if they overlap then, the step parts them. So a pile that is pressed against a ceiling
    ///   overlaps, and no body of it is squashed. The last step decides which bodies lie on others:
    ///   a body inserted since then lies on nothing.
    /// - **Squashed** bodies are reported and stay. Each step [holds](super::SceneEvent::Held) them
    ///   until the solid has passed.
    /// - Solids that move wake the bodies near them, and those that they carry or push wake their
    ///   whole piles. Bodies on a lift that stands may sleep. If you remove a solid or put it
    ///   elsewhere, [wake](super::Scene::wake_region) its old region.
    ///
    /// `each` receives every body that is carried, pushed or squashed by a solid, and the faults of
    /// bodies that cannot be moved. They come in no particular order. If keys are unique, no result
    /// depends on the order of bodies or solids.
    ///
    /// If no solid moves, the call does nothing. Otherwise it costs a region query for each moving
    /// solid, and a few comparisons for each body and solid. Each body near a solid takes a ride.
    /// If a body is carried or pushed, each awake body takes a region query. If one is carried,
    /// each body that lies on others takes another.
    ///
    /// ```
    /// use tilesat::motion::Ride;
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::world::{ConvexSolid, ConvexSolids};
    /// use tilesat::{Aabb, ConvexPolygon, Joined, Ratio, Surface, TileKinds, TileMap, Vec2, fx};
    /// let level = TileMap::from_ascii("........\n........\n", &TileKinds::EMPTY)?;
    /// // A lift with a slope, and two crates on it, one on the other.
    /// let corners = [(0, 60), (60, 40), (60, 70), (0, 70)].map(|(x, y)| Vec2::from_ints(x, y));
    /// let mut lift = [ConvexSolid::new(ConvexPolygon::<4>::new(&corners)?, 7)?];
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let rough = Surface::new(Ratio::ZERO, Ratio::ONE);
    /// let at = |x, y| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + 8, y + 8));
    /// let crates = [(20, 30, 1), (20, 20, 2)].map(|(x, y, key)| (at(x, y).unwrap(), key));
    /// let crates = crates.map(|(shape, key)| {
    ///     scene.insert(&SceneBody { surface: rough, ..SceneBody::new(shape, key) }).unwrap()
    /// });
    /// let gravity = Vec2::new(fx!(0), fx!(0.25));
    /// for _ in 0..60 {
    ///     scene.step(&Joined::new(&level, &ConvexSolids::new(&lift)), gravity, |_| {})?; // they land
    /// }
    /// let before = crates.map(|at| scene.body(at).unwrap().shape.position());
    /// for _ in 0..20 {
    ///     lift[0].set_motion(Vec2::from_ints(2, -1))?;
    ///     scene.ride(&level, &mut lift, gravity, fx!(4), |body, ride| {
    ///         assert_eq!((body, ride), (crates[0], Ok(Ride::Carried)));
    ///     })?;
    ///     scene.step(&Joined::new(&level, &ConvexSolids::new(&lift)), gravity, |_| {})?;
    /// }
    /// let after = crates.map(|at| scene.body(at).unwrap().shape.position());
    /// assert_eq!(after, before.map(|p| p + Vec2::from_ints(40, -20))); // exactly
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError`](super::SceneError) if `follow` is negative or not below 2^28 raw. Nothing is
    /// changed then.
    #[doc(alias("moving platform", "kinematic body", "AnimatableBody2D"))]
    pub fn ride<W: World, T: MovingSolid>(
        &mut self,
        level: &W,
        solids: &mut [T],
        gravity: Vec2,
        follow: Fx,
        mut each: impl FnMut(Handle, Result<Ride, SceneFault>),
    ) -> Result<(), SceneError> {
        let value = follow.to_bits();
        if !(0..MOTION).contains(&value) {
            return Err(SceneError::call(RangeError { what: Quantity::Follow, value }));
        }
        if !self.wake_beside(solids, gravity) {
            return Ok(());
        }
        let mover = if gravity == Vec2::ZERO { Mover::new() } else { Mover::platformer(toward(gravity).reversed()) };
        let (mut acts, mut carries) = (false, false);
        let none = T::level(&[]);
        let here = Joined::new(level, &none);
        for &handle in self.awake.iter().take(self.count) {
            let Some(slot) = self.slots.get_mut(handle.slot()) else { continue };
            let bounds = slot.body.shape.aabb();
            let near = |solid: &T| solid.reach().is_some_and(|reach| around(&reach, NEAR).touches(&bounds));
            let asked = if solids.iter().any(near) {
                slot.body.shape.visit(Ask(&mover, &here, &*solids, follow))
            } else {
                Ok((Ride::Free, Vec2::ZERO))
            };
            let (does, carry, push) = match asked {
                Ok((Ride::Free, _)) => (STAYS, Vec2::ZERO, Vec2::ZERO),
                Ok((Ride::Carried, by)) => (CARRIED, by, Vec2::ZERO),
                Ok((Ride::Pushed { .. }, by)) => (PUSHED, Vec2::ZERO, by),
                Ok((Ride::Squashed { .. }, by)) => (HELD, Vec2::ZERO, by),
                Err(_) => (HELD, Vec2::ZERO, Vec2::ZERO),
            };
            if does != STAYS {
                each(handle, asked.map(|(ride, _)| ride));
            }
            acts |= does != STAYS;
            carries |= does == CARRIED;
            (slot.tally.hits, slot.tally.kick, slot.tally.pushes.low) = (does, carry, push);
        }
        if acts {
            // Otherwise a body on one that was awake before would stay asleep in the air.
            self.wake_on(0, gravity);
        }
        if carries {
            let lying = self.awake.iter().take(self.count).filter_map(|handle| self.slots.get(handle.slot()));
            let most = lying.map(|slot| slot.support).filter(|support| *support != ALOFT).max();
            (1..=most.unwrap_or(0)).for_each(|support| self.take_along(support, gravity));
        }
        T::move_each(solids);
        let moved = T::level(solids);
        self.go_along(&sliding(mover), &Joined::new(level, &moved), &mut each);
        Ok(())
    }

    /// Wakes the bodies near solids that move, with their piles. Returns whether a solid moves.
    fn wake_beside<T: MovingSolid>(&mut self, solids: &[T], gravity: Vec2) -> bool {
        let (from, mut moves) = (self.count, false);
        for reach in solids.iter().filter_map(T::reach) {
            moves = true;
            self.wake_region(&around(&reach, NEAR));
        }
        if moves {
            self.wake_on(from, gravity);
            self.memory.fill(Remembered::Empty);
        }
        moves
    }

    /// Wakes the piles of the awake bodies, from an entry of the list on.
    fn wake_on(&mut self, from: usize, gravity: Vec2) {
        let awake = self.count;
        self.wake_along(from, gravity, &mut Unasked);
        self.mark_woken(awake);
    }

    /// The bodies with this many others below them move with one that is carried, if they lie on
    /// one.
    fn take_along(&mut self, support: u8, gravity: Vec2) {
        let (x, y) = gravity.raw();
        let down = Vec2::from_raw(x.signum() * GAP, y.signum() * GAP);
        for k in 0..self.count {
            let Some(&handle) = self.awake.get(k) else { continue };
            let Some(slot) = self.slots.get(handle.slot()) else { continue };
            if slot.support != support || !matches!(slot.tally.hits, STAYS | PUSHED) {
                continue;
            }
            let shape = slot.body.shape;
            let lower = shape.translated(down).unwrap_or(shape);
            let mut best = None;
            let bounds = shape.aabb().union(&lower.aabb());
            self.near.in_region(&bounds, |other| {
                let Some(below) = self.slots.get(other.slot()) else { return };
                let is_carried = matches!(below.tally.hits, CARRIED | TAKEN) && below.support < support;
                let touches = || lower.touches(&below.body.shape) || shape.touches(&below.body.shape);
                if !below.is_awake() || !is_carried || senses(slot, below) || !may_meet(slot, below) || !touches() {
                    return;
                }
                let by = below.tally.kick;
                best = best.max(Some((gravity.dot(by).wrapping_neg(), Reverse(below.body.key), by.raw())));
            });
            if let (Some((_, _, (x, y))), Some(slot)) = (best, self.slots.get_mut(handle.slot())) {
                (slot.tally.hits, slot.tally.kick) = (TAKEN, Vec2::from_raw(x, y));
            }
        }
    }

    /// Moves the bodies, after the solids.
    fn go_along<W: World>(
        &mut self,
        mover: &Sliding,
        world: &W,
        each: &mut dyn FnMut(Handle, Result<Ride, SceneFault>),
    ) {
        for &handle in self.awake.iter().take(self.count) {
            let Some(slot) = self.slots.get_mut(handle.slot()) else { continue };
            let does = take(&mut slot.tally.hits);
            let (carry, push) = (take(&mut slot.tally.kick), take(&mut slot.tally.pushes.low));
            if (carry, push) == (Vec2::ZERO, Vec2::ZERO) {
                continue;
            }
            let to = slot.body.shape.shifted(if does == CARRIED { carry } else { push });
            // At the position to which the solids have pushed it, it is in none of them.
            let along = if does == TAKEN { to.visit(MoveInLevel(mover, world, carry - push)) } else { Ok(to) };
            let (to, fault) = along.map_or_else(|fault| (to, Some(fault)), |to| (to, None));
            let put = self.near.move_to(handle, &to.aabb()).map(|()| slot.body.shape = to);
            if let Some(fault) = fault.or(put.err().map(SceneFault::from)) {
                each(handle, Err(fault));
            }
        }
    }
}

/// How the solids move one body.
struct Ask<'a, W, T>(&'a Mover, &'a W, &'a [T], Fx);

impl<S, W: World, T: MovingSolid> Visit<S> for Ask<'_, W, T> {
    type Out = Result<(Ride, Vec2), SceneFault>;
    fn of<B: Body + Into<S>>(self, body: &B) -> Self::Out {
        let Self(mover, level, solids, follow) = self;
        let ridden = T::ride(mover, level, solids, body, follow)?;
        Ok((ridden.ride, ridden.motion))
    }
}

/// A motion as far as the level and the solids allow.
struct MoveInLevel<'a, W>(&'a Sliding, &'a W, Vec2);

impl<S, W: World> Visit<S> for MoveInLevel<'_, W> {
    type Out = Result<S, SceneFault>;
    fn of<B: Body + Into<S>>(self, body: &B) -> Self::Out {
        let Self(mover, world, by) = self;
        Ok(mover.move_and_slide(world, body, by)?.body.into())
    }
}
