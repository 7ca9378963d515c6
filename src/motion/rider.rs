//! Characters among moving solids.

use super::character::{mover, refused};
use super::feel::{Input, Outcome, Step};
use super::{Body, Character, MoveError, Mover, Ridden, Ride};
use crate::error::RangeError;
use crate::num::{Fx, MOTION, Vec2};
use crate::shape::Aabb;
use crate::world::{ConvexSolid, ConvexSolids, Joined, Solid, SolidShape, Solids, World, sealed};

/// A kind of solid that a [`Character`] rides on: a [`Solid`] or a [`ConvexSolid`]. Sealed.
pub trait MovingSolid: Copy + sealed::Sealed {
    /// A list of such solids as a level.
    type Level<'a>: World
    where
        Self: 'a;

    #[doc(hidden)]
    fn level(list: &[Self]) -> Self::Level<'_>;

    #[doc(hidden)]
    fn move_each(list: &mut [Self]);

    /// The region that it passes in this frame. `None` if it moves nothing.
    #[doc(hidden)]
    fn reach(&self) -> Option<Aabb>;

    #[doc(hidden)]
    fn ride<W: World, B: Body>(
        mover: &Mover,
        level: &W,
        list: &[Self],
        body: &B,
        follow: Fx,
    ) -> Result<Ridden<B>, MoveError>;
}

macro_rules! moving_solids {
    ($([$($shape:tt)*] $solid:ty: $list:lifetime $level:ty, $ride:ident);*) => {$(
        impl<$($shape)*> sealed::Sealed for $solid {}

        impl<$($shape)*> MovingSolid for $solid {
            type Level<$list>
                = $level
            where
                Self: $list;

            fn level(list: &[Self]) -> Self::Level<'_> {
                Self::Level::new(list)
            }

            fn move_each(list: &mut [Self]) {
                Self::move_all(list);
            }

            fn reach(&self) -> Option<Aabb> {
                self.passes()
            }

            fn ride<W: World, B: Body>(
                mover: &Mover,
                level: &W,
                list: &[Self],
                body: &B,
                follow: Fx,
            ) -> Result<Ridden<B>, MoveError> {
                mover.$ride(level, list, body, follow)
            }
        }
    )*};
}

moving_solids! {
    [] Solid: 'a Solids<'a>, ride;
    [S: SolidShape] ConvexSolid<S>: 'a ConvexSolids<'a, S>, ride_convex
}

/// The result of [`Character::ride`].
type Carried = Result<(Outcome, Vec2), RangeError>;

impl<B: Body> Character<B> {
    /// Moves the character for one frame among moving solids. First the solids carry or push it.
    /// Then all solids make their [motions](Solid::with_motion) or [turns](ConvexSolid::with_turn),
    /// and then the character walks. Solids are boxes or [`ConvexSolid`]s; a game with boxes links
    /// no code for the others.
    ///
    /// When the call returns, all solids have moved, even if it returns an error. So call it once
    /// per frame. For several characters on the same solids, use [`step_all`](Self::step_all).
    ///
    /// A character that leaves a solid keeps the solid's motion, whether by a jump, a drop, a
    /// launch, or over the edge. If you remove the solid or put it elsewhere, the motion is lost.
    /// Relative to a solid that keeps its motion, the flight is the same as from still ground.
    /// There is one exception. Solids move first, so a solid that sinks may stop the fall of a body
    /// for a frame, if the body ran off its front.
    ///
    /// In the frame of a jump, the ride makes the solid's part of the motion, and the walk makes
    /// that of the jump. The new `velocity` is the sum of both.
    ///
    /// Cost: one [`Mover::ride`] or [`Mover::ride_convex`], and one
    /// [`Walker::walk`](crate::Walker::walk) in a [`Joined`] level.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, Outcome, Solid, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
    /// let limits = Aabb::new(level.origin(), level.grid().end())?;
    /// let boxed = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
    /// let mut lift = [Solid::new(boxed(0, 24, 48, 4)?, 7)?];
    /// let mut hero = Character::new(boxed(20, 10, 10, 14)?, limits, Feel::DEFAULT);
    /// for _ in 0..3 {
    ///     lift[0].set_motion(Vec2::from_ints(1, 0))?; // for one frame
    ///     assert!(hero.step_on(&level, &mut lift, Input::default())?.outcome == Outcome::Moved);
    /// }
    /// assert_eq!((hero.ridden(), hero.body().min()), (Some(7), Vec2::from_ints(23, 10)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// A seesaw, which turns:
    ///
    /// ```
    /// use tilesat::world::ConvexSolid;
    /// use tilesat::{Aabb, Axis, Character, Feel, Input, OrientedBox, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("......\n......", &TileKinds::EMPTY)?;
    /// let plank = |rise| OrientedBox::new(Vec2::from_ints(48, 24), Vec2::from_ints(40, 2), Axis::new(80, rise));
    /// let mut seesaw = [ConvexSolid::new(plank(0)?, 7)?];
    /// let body = Aabb::new(Vec2::from_ints(60, 8), Vec2::from_ints(68, 22))?;
    /// let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
    /// for rise in 1..=10 {
    ///     seesaw[0].set_turn(plank(-2 * rise)?)?; // its right end goes up
    ///     let _ = hero.step_on(&level, &mut seesaw, Input::default())?;
    /// }
    /// assert_eq!(hero.ridden(), Some(7));
    /// assert!(hero.body().min().y < 6); // more than 2 units higher than at first
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_on<W: World, M: MovingSolid>(
        &mut self,
        level: &W,
        solids: &mut [M],
        input: Input,
    ) -> Result<Step, RangeError> {
        let body = self.body;
        let ridden = self.ride_on(level, solids, input.drop);
        M::move_each(solids);
        let step = self.walk_on(level, solids, input, ridden);
        if step.is_err() {
            self.body = body;
        }
        step
    }

    /// Moves several characters for one frame among the same solids, each as
    /// [`step_on`](Self::step_on) moves one. They do not affect each other.
    ///
    /// If their number changes while the game runs, call [`ride`](Self::ride) for each, then
    /// [`Solid::move_all`] or [`ConvexSolid::move_all`], then [`step_carried`](Self::step_carried)
    /// for each.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, Outcome, Solid, TileKinds, TileMap, Vec2, fx};
    /// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
    /// let mut lift = [Solid::new(Aabb::new(Vec2::from_ints(0, 20), Vec2::from_ints(60, 24))?, 7)?];
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 10), Vec2::from_ints(x + 8, 20));
    /// let hero = |x| at(x).map(|body| Character::new(body, level.bounds(), Feel::DEFAULT));
    /// let mut heroes = [hero(4)?, hero(24)?];
    /// let inputs = [Input::default(), Input { run: fx!(0.5), ..Input::default() }];
    /// for _ in 0..4 {
    ///     lift[0].set_motion(Vec2::from_ints(1, 0))?;
    ///     let steps = Character::step_all(&mut heroes, &level, &mut lift, &inputs)?;
    ///     assert!(steps.iter().all(|step| step.outcome == Outcome::Moved));
    /// }
    /// assert_eq!(heroes.map(|hero| hero.body().min().x), [fx!(8), fx!(29.5)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step), for the first character that has one. All characters are then
    /// unchanged.
    #[doc(alias("multiplayer", "co-op"))]
    pub fn step_all<W: World, M: MovingSolid, const N: usize>(
        characters: &mut [Self; N],
        level: &W,
        solids: &mut [M],
        inputs: &[Input; N],
    ) -> Result<[Step; N], RangeError> {
        let mut next = *characters;
        let mut rides = [Ok((Outcome::Moved, Vec2::ZERO)); N];
        for ((one, input), ridden) in next.iter_mut().zip(inputs).zip(&mut rides) {
            *ridden = one.ride_on(level, solids, input.drop);
        }
        M::move_each(solids);
        let mut steps = [Step::nothing(Outcome::Moved); N];
        for (((one, input), ridden), step) in next.iter_mut().zip(inputs).zip(rides).zip(&mut steps) {
            *step = one.walk_on(level, solids, *input, ridden)?;
        }
        *characters = next;
        Ok(steps)
    }

    /// The first half of [`step_on`](Self::step_on): moves the character as far as the solids carry
    /// or push it. The solids are still at their old positions.
    ///
    /// Returns the outcome and a motion: that of the solid on which it stood, or, in the air, how
    /// far it was pushed.
    ///
    /// ```
    /// use tilesat::{Aabb, Character, Feel, Input, Joined, Outcome, Solid, Solids, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....\n....", &TileKinds::EMPTY)?;
    /// let limits = Aabb::new(level.origin(), level.grid().end())?;
    /// let lift = Solid::new(Aabb::new(Vec2::from_ints(0, 20), Vec2::from_ints(40, 24))?, 7)?;
    /// let mut solids = [lift.with_motion(Vec2::from_ints(1, 0))?];
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 10), Vec2::from_ints(x + 8, 20));
    /// let mut heroes = [4, 24].map(|x| Character::new(at(x).unwrap(), limits, Feel::DEFAULT));
    /// for _ in 0..4 {
    ///     let mut carries = [Vec2::ZERO; 2];
    ///     for (hero, carry) in heroes.iter_mut().zip(&mut carries) {
    ///         let (outcome, by) = hero.ride(&level, &solids, false)?;
    ///         assert_eq!(outcome, Outcome::Moved);
    ///         *carry = by;
    ///     }
    ///     Solid::move_all(&mut solids);
    ///     let moved = solids.map(|solid| solid.with_motion(Vec2::from_ints(1, 0)).unwrap());
    ///     for (hero, carry) in heroes.iter_mut().zip(carries) {
    ///         let _ = hero.step_carried(&Joined::new(&level, &Solids::new(&moved)), Input::default(), carry)?;
    ///     }
    ///     solids = moved;
    /// }
    /// assert_eq!(heroes.map(|hero| hero.body().min()), [Vec2::from_ints(8, 10), Vec2::from_ints(28, 10)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn ride<W: World, M: MovingSolid>(
        &mut self,
        level: &W,
        solids: &[M],
        drop: bool,
    ) -> Result<(Outcome, Vec2), RangeError> {
        let follow = if self.floor.is_some() { self.feel.snap } else { self.falls().saturating_add(self.pull()) };
        // It drops from a one-way solid after the ride, which carries it.
        let stands = self.floor.is_some_and(|floor| floor.one_way) && self.ridden().is_some();
        // Solids move first: if gravity has turned, the character still stands on its old floor.
        let to_larger_y = self.floor.map_or(self.falls_to_larger_y(), |floor| floor.axis.y < 0);
        let mover = mover(to_larger_y).with_drop_through(self.passes(drop) && !stands);
        // Numbers that no walker or motion may have are errors of the step, under the names that
        // they have there.
        let follow = follow.clamp(Fx::ZERO, Fx::from_bits(MOTION - 1));
        let ride = |mover: &Mover| M::ride(mover, level, solids, &self.body, follow);
        let ridden = match ride(&mover) {
            // One-way solids pass through a body without room.
            Ok(Ridden { ride: Ride::Squashed { .. }, .. }) => ride(&mover.with_drop_through(true)),
            ridden => ridden,
        };
        match ridden {
            Ok(ridden) => {
                self.body = ridden.body;
                let outcome = match ridden.ride {
                    Ride::Squashed { by, normal } => Outcome::Squashed { by, normal },
                    _ => Outcome::Moved,
                };
                Ok((outcome, if self.floor.is_some() { ridden.carry } else { ridden.motion }))
            }
            Err(e) => Ok((refused(e)?, Vec2::ZERO)),
        }
    }

    /// Rides in the type of level that [`walk_on`](Self::walk_on) uses, which links the mover once.
    fn ride_on<W: World, M: MovingSolid>(&mut self, level: &W, solids: &[M], drop: bool) -> Carried {
        self.ride(&Joined::new(level, &M::level(&[])), solids, drop)
    }

    /// Walks among the solids at their new positions, unless they squashed it.
    fn walk_on<W: World, M: MovingSolid>(
        &mut self,
        level: &W,
        solids: &[M],
        input: Input,
        ridden: Carried,
    ) -> Result<Step, RangeError> {
        match ridden? {
            (Outcome::Moved, carry) => self.step_carried(&Joined::new(level, &M::level(solids)), input, carry),
            (outcome, _) => {
                self.heed_gravity();
                Ok(Step::nothing(outcome))
            }
        }
    }
}
