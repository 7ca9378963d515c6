//! What a character of a scene asks: where its floor ends, whether there is room to stand up, and
//! what presses it.

use super::kernel::BodyShape;
use super::reached::each_met;
use super::{Scene, SceneCharacter, SceneError};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::Body;
use crate::num::Fx;
use crate::world::{Joined, Solid, Solids, World};
use core::cmp::Reverse;

impl<B: Body> SceneCharacter<B> {
    /// Returns whether the floor ends ahead, as [`Character::ledge_ahead`], where the bodies of the
    /// scene are floors as in [`lead`](Self::lead). Call it after [`follow`](Self::follow), with
    /// the same lifts.
    ///
    /// Balls and other shapes are floors only where the character is above them: one ahead is a
    /// ledge.
    ///
    /// Cost: a region query, and that of [`Character::ledge_ahead`] in a joined level.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SceneCharacter, SortSweepScene};
    /// use tilesat::{Aabb, Character, Feel, Input, TileKinds, TileMap, Vec2, fx};
    /// let level = TileMap::from_ascii("........", &TileKinds::EMPTY)?;
    /// let boxed = |x, y, w, h| Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(w, h));
    /// let mut scene = SortSweepScene::<8>::empty();
    /// scene.insert(&SceneBody::fixed(boxed(20, 40, 80, 10)?, 1))?;
    /// let enemy = Character::new(boxed(30, 26, 8, 14)?, boxed(0, 0, 128, 128)?, Feel::DEFAULT);
    /// let mut enemy = SceneCharacter::new(enemy, scene.insert(&SceneBody::led(*enemy.body(), 2))?);
    /// let (mut run, mut turns) = (fx!(1), 0);
    /// for _ in 0..400 {
    ///     let _ = enemy.lead(&mut scene, &level, &[], Input::running(run))?;
    ///     scene.step(&level, Vec2::ZERO, |_| {})?;
    ///     enemy.follow(&scene, &level, &[])?;
    ///     if enemy.ledge_ahead(&scene, &level, &[], enemy.character.stopping_distance(run))? {
    ///         (run, turns) = (-run, turns + 1);
    ///     }
    ///     let body = enemy.character.body();
    ///     assert!(body.min().x >= 20 && body.max().x <= 100); // it stays on the box
    /// }
    /// assert!(turns > 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Character::ledge_ahead`], and [`Stale`](crate::broad::BroadError::Stale) if its
    /// body was removed.
    ///
    /// [`Character::ledge_ahead`]: crate::Character::ledge_ahead
    #[doc(alias("patrol", "cliff"))]
    pub fn ledge_ahead<W, P, S, const N: usize, const M: usize>(
        &self,
        scene: &Scene<P, N, M, S>,
        level: &W,
        lifts: &[Solid],
        far: Fx,
    ) -> Result<bool, SceneError>
    where
        W: World,
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
        B: Into<S>,
    {
        scene.body(self.body)?;
        let (bounds, feel) = (self.character.body().bounds(), self.character.feel);
        // A walk rises and sinks by at most its length, and then by a step or the snap.
        let width = bounds.max().x.saturating_sub(bounds.min().x);
        let way = far.saturating_abs().saturating_add(width).saturating_add(feel.snap).saturating_add(feel.step);
        let reached = self.floors(scene, lifts, way.to_bits().unsigned_abs(), self.climb());
        let world = Solids::new(reached.solids());
        self.character.ledge_ahead(&Joined::new(level, &world), far).map_err(|e| SceneError::of(self.body, e))
    }

    /// Replaces the character's body, as [`Character::set_body`]: to crouch, or to grow. Returns
    /// whether there is room. Without room, nothing changes.
    ///
    /// There is no room if the new body would overlap the level or a lift. Also if it would be
    /// deeper in a body that it meets than the old one: a crate on its head keeps it low. Sensors
    /// do not count. The body in the scene follows in the next [`lead`](Self::lead). What it stands
    /// on carries it as before.
    ///
    /// Cost: an overlap test, a region query, and two contacts for each body near it.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SceneCharacter, SortSweepScene};
    /// use tilesat::{Aabb, Character, Feel, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....", &TileKinds::EMPTY)?;
    /// let boxed = |x, y, w, h| Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(w, h));
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let chest = scene.insert(&SceneBody::new(boxed(28, 10, 12, 8)?, 1))?;
    /// let (low, tall) = (boxed(30, 20, 8, 12)?, boxed(30, 12, 8, 20)?);
    /// let hero = Character::new(low, boxed(0, 0, 128, 128)?, Feel::DEFAULT);
    /// let mut hero = SceneCharacter::new(hero, scene.insert(&SceneBody::led(low, 2))?);
    /// assert!(!hero.set_body(&scene, &level, &[], tall)?); // the chest is above its head
    /// scene.remove(chest)?;
    /// assert!(hero.set_body(&scene, &level, &[], tall)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale) if its body was removed. The character is then
    /// unchanged.
    ///
    /// [`Character::set_body`]: crate::Character::set_body
    #[doc(alias("crouch", "resize"))]
    pub fn set_body<W, P, S, const N: usize, const M: usize>(
        &mut self,
        scene: &Scene<P, N, M, S>,
        level: &W,
        lifts: &[Solid],
        body: B,
    ) -> Result<bool, SceneError>
    where
        W: World,
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
        B: Into<S>,
    {
        scene.body(self.body)?;
        let (old, new): (S, S) = ((*self.character.body()).into(), body.into());
        let mut fits = true;
        each_met(scene, self.body, &new.aabb(), |_, other| {
            fits &= depth(&new, &other.shape) <= depth(&old, &other.shape);
        });
        let from = self.character.position();
        if !fits || !self.character.set_body(&Joined::new(level, &Solids::new(lifts)), body) {
            return Ok(false);
        }
        // Otherwise it would count as put elsewhere, and no longer ride.
        self.seen += self.character.position() - from;
        Ok(true)
    }

    /// The body that its own is deepest in, and how deep. `None` if it overlaps no body.
    ///
    /// Call it after [`follow`](Self::follow). Where the hero has room, the scene's step has parted
    /// the two, and the depth is small. It grows if there is no room: if a press or a door that the
    /// game [places](Scene::place) closes, or if a heavy crate comes down. The game decides which
    /// depth kills. A quarter of the hero's smaller side is a good start.
    ///
    /// Of several at the same depth, it is the one with the smaller key. Sensors do not count.
    ///
    /// Cost: a region query, and a contact for each body near it.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SceneCharacter, SortSweepScene};
    /// use tilesat::{Aabb, Character, Feel, Fx, Input, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("....\n....\n####", &KINDS)?; // the floor is at y = 32
    /// let boxed = |x, y, w, h| Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(w, h));
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let press = scene.insert(&SceneBody::fixed(boxed(20, -30, 40, 40)?, 1))?;
    /// let hero = Character::new(boxed(30, 18, 10, 14)?, level.bounds(), Feel::DEFAULT);
    /// let mut hero = SceneCharacter::new(hero, scene.insert(&SceneBody::led(*hero.body(), 2))?);
    /// let mut y = -30;
    /// let (by, depth) = loop {
    ///     y += 1; // it comes down on the hero's head, which is at y = 18
    ///     scene.place(press, boxed(20, y, 40, 40)?)?;
    ///     let _ = hero.lead(&mut scene, &level, &[], Input::default())?;
    ///     scene.step(&level, Vec2::ZERO, |_| {})?;
    ///     hero.follow(&scene, &level, &[])?;
    ///     match hero.pressed_by(&scene)? {
    ///         Some(deep) if deep.1 > fx!(2.5) => break deep,
    ///         _ => {}
    ///     }
    /// };
    /// assert_eq!((by, depth, y), (press, fx!(3), -19)); // its lower side is at y = 21
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Stale`](crate::broad::BroadError::Stale) if its body was removed.
    #[doc(alias("squash", "crush"))]
    pub fn pressed_by<P, S, const N: usize, const M: usize>(
        &self,
        scene: &Scene<P, N, M, S>,
    ) -> Result<Option<(Handle, Fx)>, SceneError>
    where
        P: BroadPhase<Tag = Keyed<Filter>>,
        S: BodyShape,
    {
        let own = &scene.body(self.body)?.shape;
        let mut deepest: Option<(Handle, Fx)> = None;
        let mut first = (Fx::ZERO, Reverse((0, 0)));
        each_met(scene, self.body, &own.aabb(), |other, body| {
            let rank = (depth(own, &body.shape), Reverse((body.key, other.slot())));
            if rank > first {
                (first, deepest) = (rank, Some((other, rank.0)));
            }
        });
        Ok(deepest)
    }
}

/// How deep two shapes overlap.
fn depth<S: BodyShape>(a: &S, b: &S) -> Fx {
    a.contact(b).map_or(Fx::ZERO, |contact| contact.depth())
}
