//! A character among the bodies of a scene: it stands on boxes, and pushes them.

use super::body::Slot;
use super::error::REACHED;
use super::kernel::BodyShape;
use super::meeting_time::{around, may_meet, senses};
use super::{Scene, SceneBody, SceneError, SceneFault};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::{Body, Character, Input, Step};
use crate::num::{Fx, Vec2};
use crate::query::{Overlaps, Touches};
use crate::shape::Aabb;
use crate::world::{Joined, Solid, Solids, World};
use heapless::Vec;

/// A [`Character`] and its body in a [`Scene`]. The character moves by its own rules, stands on the
/// boxes of the scene, and pushes them.
///
/// Insert a [`led`](SceneBody::led) body at the position of the character. Then each frame has
/// three calls:
///
/// ```text
///    1 lead          o          2 step         o       3 follow
///      the character |  runs      bodies       |  o|     the character goes to where
///      and its body  +->|crate    part       +-| |->|    the others left its body
/// ```
///
/// 1. [`lead`](Self::lead) moves the character, and puts its body there. It stands on boxes that
///    are below it, and passes the sides of boxes that can move.
/// 2. [`Scene::step`] parts the body and the boxes: the character pushes.
/// 3. [`follow`](Self::follow) moves the character to its body. If it stands on a box, the box
///    carries it.
///
/// What counts as a floor is a body that is an [`Aabb`], meets the character's body by its
/// [filter](SceneBody::filter), and is no sensor. Fixed boxes block from all sides. A body of
/// another shape only pushes the character.
///
/// `B` is the shape of the character. Plain data: a copy, with one of the scene, is a snapshot.
///
/// ```
/// use core::num::NonZeroU8;
/// use tilesat::scene::{SceneBody, SceneCharacter, SortSweepScene};
/// use tilesat::{Aabb, Character, Feel, Input, TileKind, TileKinds, TileMap, Vec2, fx};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("........\n........\n########", &KINDS)?; // the floor is at y = 32
/// let boxed = |x, y, w, h| Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(w, h));
/// let mut scene = SortSweepScene::<8>::empty();
/// let chest = scene.insert(&SceneBody::new(boxed(40, 22, 10, 10)?, 1))?;
///
/// let hero = Character::new(boxed(20, 18, 8, 14)?, level.bounds(), Feel::DEFAULT);
/// let body = SceneBody { mass: NonZeroU8::new(3), ..SceneBody::led(*hero.body(), 2) };
/// let mut hero = SceneCharacter::new(hero, scene.insert(&body)?);
/// for frame in 0..90 {
///     // It pushes the chest, steps back, and jumps onto it.
///     let run = if (32..40).contains(&frame) { fx!(-1) } else { fx!(1) };
///     let input = Input { run: if frame < 62 { run } else { fx!(0) }, jump: frame > 40, drop: false };
///     let step = hero.lead(&mut scene, &level, &[], input)?;
///     scene.step(&level, Vec2::new(fx!(0), fx!(0.25)), |_| {})?;
///     hero.follow(&scene, &level, &[])?;
/// }
/// assert!(scene.body(chest)?.shape.position().x > 50); // from 40
/// assert_eq!(hero.stands_on(), Some(chest));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("player", "hero", "KinematicCharacterController", "CharacterBody2D"))]
pub struct SceneCharacter<B = Aabb> {
    /// The character. You may change it between two frames: its velocity, its feel, its position
    /// or its body.
    pub character: Character<B>,
    pub(super) body: Handle,
    /// Where the scene's body was when the character was last moved to it.
    pub(super) at: Vec2,
    /// The box that it stands on.
    pub(super) on: Option<Under>,
    /// The box that it stood on at the start of its step, which takes it along in the scene's step.
    /// So a jump off a box that moves is the jump off one at rest, seen from the box.
    pub(super) rides: Option<Under>,
    /// How far the box that it stands on has moved since its last step.
    pub(super) carry: Vec2,
}

/// A box under a character, and the position at which it was last seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Under {
    body: Handle,
    at: Vec2,
}

impl Under {
    /// The position of the box. `None` if it was removed.
    fn now<P, S, const N: usize, const M: usize>(self, scene: &Scene<P, N, M, S>) -> Option<Self>
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let at = scene.body(self.body).ok()?.shape.position();
        Some(Self { at, ..self })
    }
}

impl<B: Body> SceneCharacter<B> {
    /// A character, and the [`led`](SceneBody::led) body that was inserted at its position.
    #[must_use]
    pub fn new(character: Character<B>, body: Handle) -> Self {
        Self { at: character.position(), character, body, on: None, rides: None, carry: Vec2::ZERO }
    }

    /// Its body in the scene, for events and [`Scene::remove`].
    #[must_use]
    pub const fn handle(&self) -> Handle {
        self.body
    }

    /// The box of the scene that it stands on. `None` in the air, and on the level or a lift.
    #[must_use]
    pub const fn stands_on(&self) -> Option<Handle> {
        match self.on {
            Some(on) => Some(on.body),
            None => None,
        }
    }

    /// Moves the character for one frame, as [`Character::step`], and puts its body there. Call it
    /// before the scene's step.
    ///
    /// `lifts` are the moving solids of the game, or `&[]`. Move them first, by [`Scene::ride`]:
    /// that carries and pushes the body of the character like all others. Then pass them to `lead`
    /// and `follow`, and step the scene in the level [`Joined`] with them.
    ///
    /// [`Input::drop`] drops through one-way tiles and lifts, not through boxes. [`Step::wall`]
    /// does not show a box that the character pushes; the scene reports the contact.
    ///
    /// Cost: one [`Walker::walk`](crate::Walker::walk) in a joined level, a region query, and up to
    /// two overlap tests.
    ///
    /// # Errors
    /// - The errors of [`Character::step`], and of [`Scene::place`].
    /// - [`Crowded`](SceneFault::Crowded) if more than 16 boxes and lifts are in reach.
    ///
    /// The character and the scene are then unchanged.
    pub fn lead<W, P, S, const N: usize, const M: usize>(
        &mut self,
        scene: &mut Scene<P, N, M, S>,
        level: &W,
        lifts: &[Solid],
        input: Input,
    ) -> Result<Step, SceneError>
    where
        W: World,
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
        B: Into<S>,
    {
        let mut next = *self;
        if !next.character.on_floor() {
            next.rides = None;
        }
        let made = next.catch_up(scene, &Joined::new(level, &Solids::new(lifts)))?;
        let carry = next.carry + made;
        let reached = next.reached(scene, lifts, input, carry)?;
        let solids = Solids::new(&reached.solids);
        let step = next.character.step_carried(&Joined::new(level, &solids), input, carry);
        let step = step.map_err(|e| SceneError::of(self.body, e))?;
        let on = next.character.ridden().and_then(|key| reached.below(key, &(*next.character.body()).into()));
        next.on = on.and_then(|body| Under { body, at: Vec2::ZERO }.now(scene));
        next.put(scene)?;
        *self = next;
        Ok(step)
    }

    /// Moves the character to where the scene's step left its body, and with the box that it stands
    /// on. Call it after the step, with the same lifts.
    ///
    /// Returns how far the other bodies moved it. Along its run this is negative while it pushes
    /// something. What a hit adds to the velocity of its body is there until the next `lead`, to
    /// knock the character back.
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale) if its body was removed. The character is then
    /// unchanged.
    pub fn follow<W, P, S, const N: usize, const M: usize>(
        &mut self,
        scene: &Scene<P, N, M, S>,
        level: &W,
        lifts: &[Solid],
    ) -> Result<Vec2, SceneError>
    where
        W: World,
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let made = self.catch_up(scene, &Joined::new(level, &Solids::new(lifts)))?;
        let now = self.on.and_then(|on| on.now(scene));
        self.carry = self.on.zip(now).map_or(Vec2::ZERO, |(was, is)| is.at - was.at);
        (self.on, self.rides) = (now, now);
        Ok(made)
    }

    /// Moves the character by what its body and the box that it rides have moved since it was last
    /// there, if there is room. Returns its motion.
    fn catch_up<W, P, S, const N: usize, const M: usize>(
        &mut self,
        scene: &Scene<P, N, M, S>,
        level: &W,
    ) -> Result<Vec2, SceneError>
    where
        W: World,
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let at = scene.body(self.body)?.shape.position();
        let pushed = at - self.at;
        self.at = at;
        let now = self.rides.and_then(|on| on.now(scene));
        let carried = self.rides.zip(now).map_or(Vec2::ZERO, |(was, is)| is.at - was.at);
        let carried = if self.goes_along(carried) { carried } else { Vec2::ZERO };
        self.rides = now;
        // A box that rises pushes the body as well: the motions are not added.
        let both = Vec2::new(together(pushed.x, carried.x), together(pushed.y, carried.y));
        let made = [both, pushed, carried].into_iter().find(|by| *by == Vec2::ZERO || self.shift(level, *by));
        Ok(made.unwrap_or(Vec2::ZERO))
    }

    /// Whether a box below the character carries it by a motion. The box does not if it sinks by
    /// more than the snap. It does not either if the motion is longer than the character, which
    /// could pass a wall: the game has put the box elsewhere.
    fn goes_along(&self, by: Vec2) -> bool {
        let bounds = self.character.body().bounds();
        let size = bounds.max() - bounds.min();
        let sinks = if self.character.falls_to_larger_y() { by.y } else { Fx::ZERO - by.y };
        sinks <= self.character.feel.snap && by.x.abs() <= size.x && by.y.abs() <= size.y
    }

    /// Moves the character, if there is room.
    fn shift<W: World>(&mut self, level: &W, by: Vec2) -> bool {
        let mut next = self.character;
        let fits = next.translate(by, next.limits()).is_ok() && !next.body().overlaps_world(level);
        if fits {
            self.character = next;
        }
        fits
    }

    /// Puts its body where the character is, at rest. A body that is there already is not touched,
    /// because that would wake the boxes below it.
    fn put<P, S, const N: usize, const M: usize>(&mut self, scene: &mut Scene<P, N, M, S>) -> Result<(), SceneError>
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
        B: Into<S>,
    {
        let (shape, body) = ((*self.character.body()).into(), scene.body(self.body)?);
        if (body.shape, body.velocity) != (shape, Vec2::ZERO) {
            scene.alter(self.body, |body| (body.shape, body.velocity) = (shape, Vec2::ZERO))?;
        }
        self.at = self.character.position();
        Ok(())
    }

    /// The boxes and lifts that the next step of the character may meet.
    fn reached<P, S, const N: usize, const M: usize>(
        &self,
        scene: &Scene<P, N, M, S>,
        lifts: &[Solid],
        input: Input,
        carry: Vec2,
    ) -> Result<Reached, SceneError>
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
        B: Into<S>,
    {
        let far = self.character.reach(input, carry).map_err(|e| SceneError::of(self.body, e))?;
        let shape: S = (*self.character.body()).into();
        let region = around(&shape.aabb(), far);
        let (mut reached, mut fits) = (Reached { solids: Vec::new(), bodies: Vec::new() }, true);
        for lift in lifts.iter().filter(|lift| lift.shape().touches(&region)) {
            fits &= reached.solids.push(*lift).is_ok();
        }
        let own = scene.slots.get(self.body.slot());
        scene.near.in_region(&region, |other| {
            let (Some(own), Some(slot)) = (own, scene.slots.get(other.slot())) else { return };
            if other == self.body || senses(own, slot) || !may_meet(own, slot) {
                return;
            }
            if let Some(solid) = self.floor_of(slot, &shape.aabb()) {
                fits &= reached.solids.push(solid).is_ok() && reached.bodies.push(other).is_ok();
            }
        });
        if fits { Ok(reached) } else { Err(SceneError::of(self.body, SceneFault::Crowded)) }
    }

    /// The solid that a body is for the character. One that can move counts only from above. As a
    /// one-way solid, it would let through a character that drops.
    fn floor_of<S: BodyShape>(&self, slot: &Slot<S>, body: &Aabb) -> Option<Solid> {
        let bounds = slot.body.shape.aabb();
        let above = if self.character.falls_to_larger_y() {
            body.hi().y <= bounds.lo().y
        } else {
            body.lo().y >= bounds.hi().y
        };
        let is_box = slot.body.shape == bounds.into();
        let blocks = is_box && (above || (slot.body.mass.is_none() && !body.overlaps(&bounds)));
        let key = u16::try_from(slot.body.key).unwrap_or(u16::MAX);
        Solid::new(bounds, key).ok().filter(|_| blocks)
    }
}

/// What a step of a character may meet: lifts first, then the boxes of bodies.
struct Reached {
    solids: Vec<Solid, REACHED>,
    bodies: Vec<Handle, REACHED>,
}

impl Reached {
    /// The body whose box has a key and touches a shape.
    fn below<S: BodyShape>(&self, key: u16, shape: &S) -> Option<Handle> {
        let lifts = self.solids.len().saturating_sub(self.bodies.len());
        let holds = |solid: &Solid| solid.key() == key && shape.aabb().touches(&solid.shape());
        let at = self.solids.iter().position(holds)?;
        self.bodies.get(at.checked_sub(lifts)?).copied()
    }
}

/// Two motions of one body along one axis. Of two to the same side, the farther one counts.
fn together(a: Fx, b: Fx) -> Fx {
    if a.signum() == b.signum() { if a.unsigned_abs() < b.unsigned_abs() { b } else { a } } else { a + b }
}

impl<S: BodyShape> SceneBody<S> {
    /// The body of a [`SceneCharacter`], of mass 1. It floats, because the character has its own
    /// gravity. It is [fast](SceneBody::fast), so that it overlaps what it pushes for one step
    /// only.
    #[must_use]
    pub fn led(shape: impl Into<S>, key: u32) -> Self {
        Self { floats: true, fast: true, ..Self::of(shape, key) }
    }
}
