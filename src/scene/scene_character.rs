//! A character among the bodies of a scene: it stands on them, and pushes them.

use super::farthest_pushes::FarthestPushes;
use super::kernel::BodyShape;
use super::level_of_body::sliding;
use super::reached::{MetBodies, Reached};
use super::{Scene, SceneBody, SceneError};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::{Body, Character, Hit, Input, Mover, Step};
use crate::num::{Fx, Vec2};
use crate::shape::Aabb;
use crate::world::{Joined, Solid, Solids, World};

/// A [`Character`] and its body in a [`Scene`]. The character moves by its own rules, stands on the
/// bodies of the scene, and pushes them.
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
/// 1. [`lead`](Self::lead) moves the character, and puts its body there. It stands on bodies that
///    are below it, and passes the sides of those that can move.
/// 2. [`Scene::step`] parts the body and the others: the character pushes.
/// 3. [`follow`](Self::follow) moves the character to its body. If it stands on a body, that one
///    carries it.
///
/// A body counts if it meets the character's body by its [filter](SceneBody::filter), and neither
/// is a sensor. Of more than 16 bodies and lifts in its reach, the nearest count.
///
/// - **Fixed boxes** block from all sides. A character climbs them as it climbs tiles, up to its
///   [step](crate::Feel::step).
/// - **Boxes that can move** are floors from above. A character on a floor climbs one that is no
///   higher than its step. If there is no room above it, the character pushes it, like all others.
/// - **Other shapes** are floors where the character is above them, up to 45 degrees. They are not
///   in its way: as it runs up a flank, the step pushes it up. A steeper flank pushes it aside.
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
    /// The positions of the character and of its body after the last call.
    pub(super) seen: Vec2,
    pub(super) at: Vec2,
    /// The body that it stands on.
    pub(super) on: Option<Under>,
    /// The body that it stood on at the start of its step, which takes it along in the scene's
    /// step. So a jump off a body that moves is the jump off one at rest, seen from that body.
    pub(super) rides: Option<Under>,
    /// How far the body that it stands on has moved since its last step.
    pub(super) carry: Vec2,
}

/// A body under a character, and the position at which it was last seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Under {
    body: Handle,
    at: Vec2,
}

impl Under {
    /// `None` if the body was removed.
    fn of<P, S, const N: usize, const M: usize>(body: Handle, scene: &Scene<P, N, M, S>) -> Option<Self>
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        Some(Self { body, at: scene.body(body).ok()?.shape.position() })
    }

    /// How far the body has moved since it was last seen. Zero if it was removed.
    fn update<P, S, const N: usize, const M: usize>(under: &mut Option<Self>, scene: &Scene<P, N, M, S>) -> Vec2
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let now = under.and_then(|was| Self::of(was.body, scene));
        let moved = under.zip(now).map_or(Vec2::ZERO, |(was, is)| is.at - was.at);
        *under = now;
        moved
    }
}

impl<B: Body> SceneCharacter<B> {
    /// A character, and the [`led`](SceneBody::led) body that was inserted at its position.
    #[must_use]
    pub fn new(character: Character<B>, body: Handle) -> Self {
        let at = character.position();
        Self { character, body, seen: at, at, on: None, rides: None, carry: Vec2::ZERO }
    }

    /// Its body in the scene, for events and [`Scene::remove`].
    #[must_use]
    pub const fn handle(&self) -> Handle {
        self.body
    }

    /// The body of the scene that it stands on. `None` in the air, and on the level or a lift.
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
    /// [`Input::drop`] drops through one-way tiles and lifts, not through bodies. [`Step::wall`]
    /// does not show a box that the character pushes; the scene reports the contact.
    ///
    /// Cost: one [`Walker::walk`](crate::Walker::walk) in a joined level, a region query, and up to
    /// two overlap tests. Each body of another shape in reach adds a cast. A second walk follows if
    /// there is no room above a low box.
    ///
    /// # Errors
    /// The errors of [`Character::step`], and of [`Scene::place`]. The character and the scene are
    /// then unchanged.
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
        let made = next.catch_up(scene, level, lifts)?.made;
        let carry = next.carry + if next.goes_along(made) { made } else { Vec2::ZERO };
        let far = next.character.reach(input, carry).map_err(|e| SceneError::of(self.body, e))?;
        let (start, mut climb) = (next.character, next.climb());
        let step = loop {
            let reached = next.floors(scene, lifts, far, climb);
            let world = Solids::new(reached.solids());
            let step = next.character.step_carried(&Joined::new(level, &world), input, carry);
            let step = step.map_err(|e| SceneError::of(self.body, e))?;
            let is_crate = |hit: &Hit| hit.axis.x != 0 && hit.solid().is_some_and(|key| reached.is_loose(key, scene));
            // Without room above a low box, it pushes the box.
            if climb > 0 && step.wall && step.hits.iter().any(is_crate) {
                (next.character, climb) = (start, Fx::ZERO);
                continue;
            }
            let on = next.character.ridden().and_then(|key| reached.body(key));
            next.on = on.and_then(|body| Under::of(body, scene));
            break step;
        };
        next.put(scene)?;
        *self = next;
        Ok(step)
    }

    /// Moves the character to where the scene's step left its body, and with the body that it
    /// stands on. Call it once after the step, with the same lifts.
    ///
    /// Returns how far the other bodies pushed it: against its run while it pushes something. An
    /// enemy turns round if that is nearly all of its run. Along y, a push takes as much of the
    /// character's velocity against it. What a hit adds to the velocity of its *body* is there
    /// until the next `lead`, to knock the character back.
    ///
    /// Cost: an overlap test if others pushed it; a motion in the level if a body carried it.
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
        let Caught { pushed, .. } = self.catch_up(scene, level, lifts)?;
        self.carry = Under::update(&mut self.on, scene);
        self.rides = self.on;
        let fall = &mut self.character.velocity.y;
        if fall.signum() == -pushed.y.signum() {
            *fall = if pushed.y.unsigned_abs() < fall.unsigned_abs() { *fall + pushed.y } else { Fx::ZERO };
        }
        Ok(pushed)
    }

    /// Moves the character by the motions of its body and of the one that it rides since the last
    /// call. The level, the lifts and fixed boxes stop it.
    fn catch_up<W, P, S, const N: usize, const M: usize>(
        &mut self,
        scene: &Scene<P, N, M, S>,
        level: &W,
        lifts: &[Solid],
    ) -> Result<Caught, SceneError>
    where
        W: World,
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let at = scene.body(self.body)?.shape.position();
        let pushed = at - self.at;
        self.at = at;
        if self.character.position() != self.seen {
            // The game has put it elsewhere, or changed its shape.
            (self.on, self.rides, self.carry) = (None, None, Vec2::ZERO);
            self.seen = self.character.position();
            return Ok(Caught { made: Vec2::ZERO, pushed: Vec2::ZERO });
        }
        let carried = Under::update(&mut self.rides, scene);
        let carried = if self.goes_along(carried) { carried } else { Vec2::ZERO };
        if carried == Vec2::ZERO {
            // The scene has moved its body exactly.
            if pushed != Vec2::ZERO {
                self.shift(pushed, |body| !body.overlaps_world(&Joined::new(level, &Solids::new(lifts))));
            }
        } else {
            // A body that rises pushes its own as well: the motions are not added.
            let mut motions = FarthestPushes::NONE;
            motions.add(pushed);
            motions.add(carried);
            let both = motions.sum();
            let far = both.x.unsigned_abs().max(both.y.unsigned_abs()).to_bits();
            let reached = Reached::of(scene, (self.body, &self.bounds()), lifts, far, MetBodies::FixedBoxes);
            let (mover, body) = (sliding(Mover::new()), *self.character.body());
            let world = Solids::new(reached.solids());
            if let Ok(moved) = mover.move_and_slide(&Joined::new(level, &world), &body, both) {
                self.shift(moved.body.position() - body.position(), |_| true);
            }
        }
        let made = self.character.position() - self.seen;
        self.seen = self.character.position();
        Ok(Caught { made, pushed })
    }

    /// Whether a motion of what is below it takes it along. The game has put elsewhere what moves
    /// by more than the character's own size. What sinks by more than the snap leaves it behind.
    fn goes_along(&self, by: Vec2) -> bool {
        let bounds = self.bounds();
        let size = bounds.max() - bounds.min();
        let sinks = if self.character.falls_to_larger_y() { by.y } else { -by.y };
        sinks <= self.character.feel.snap && by.x.abs() <= size.x && by.y.abs() <= size.y
    }

    /// The highest box that it climbs now.
    pub(super) fn climb(&self) -> Fx {
        if self.character.on_floor() { self.character.feel.step } else { Fx::ZERO }
    }

    /// What it may meet in a walk that leads so far.
    pub(super) fn floors<P, S, const N: usize, const M: usize>(
        &self,
        scene: &Scene<P, N, M, S>,
        lifts: &[Solid],
        far: u32,
        step: Fx,
    ) -> Reached
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
        B: Into<S>,
    {
        let of = (*self.character.body()).into();
        let bodies = MetBodies::AndFloors { of, larger_y: self.character.falls_to_larger_y(), step };
        Reached::of(scene, (self.body, &self.bounds()), lifts, far, bodies)
    }

    fn bounds(&self) -> Aabb {
        self.character.body().bounds()
    }

    /// Moves the character, if there is room.
    fn shift(&mut self, by: Vec2, fits: impl Fn(&B) -> bool) {
        let mut next = self.character;
        if next.translate(by, next.limits()).is_ok() && fits(next.body()) {
            self.character = next;
        }
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
        self.seen = self.character.position();
        self.at = self.seen;
        Ok(())
    }
}

/// How a character was moved since the last call.
struct Caught {
    /// By all.
    made: Vec2,
    /// By the bodies that pushed it.
    pushed: Vec2,
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
