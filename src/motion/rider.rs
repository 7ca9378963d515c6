//! Characters among moving solids.

use super::character::refused;
use super::feel::{Input, Outcome, Step};
use super::{Body, Character, Ride};
use crate::error::RangeError;
use crate::num::{Fx, Vec2};
use crate::world::{Joined, Solid, Solids, World};

/// What [`Character::ride`] answers.
type Ridden = Result<(Outcome, Vec2), RangeError>;

impl<B: Body> Character<B> {
    /// Moves the character for one frame among moving solids. They carry or push it, then all go by
    /// their [motions](Solid::with_motion), and then the character walks.
    ///
    /// When the call returns, all solids have moved, even if it returns an error. So call it once
    /// per frame. For several characters on the same solids there is [`step_all`](Self::step_all).
    ///
    /// A jump off a solid adds the solid's motion. Seen from a solid that keeps its motion, the
    /// flight is that on still ground. In the frame of the jump the character moves by its own
    /// velocity only.
    ///
    /// Cost: [`Mover::ride`](crate::Mover::ride) and [`Walker::walk`](crate::Walker::walk) in a [`Joined`] level.
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
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_on<W: World>(&mut self, level: &W, solids: &mut [Solid], input: Input) -> Result<Step, RangeError> {
        let mut next = *self;
        let ridden = next.ride_on(level, solids, input.drop);
        Solid::move_all(solids);
        let step = next.walk_on(level, solids, input, ridden)?;
        *self = next;
        Ok(step)
    }

    /// Moves several characters for one frame among the same solids, each as
    /// [`step_on`](Self::step_on) moves one. They do not affect each other.
    ///
    /// If their number changes while the game runs, call [`ride`](Self::ride) for each, then
    /// [`Solid::move_all`], then [`step_carried`](Self::step_carried) for each.
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
    pub fn step_all<W: World, const N: usize>(
        characters: &mut [Self; N],
        level: &W,
        solids: &mut [Solid],
        inputs: &[Input; N],
    ) -> Result<[Step; N], RangeError> {
        let mut next = *characters;
        let mut rides = [Ok((Outcome::Moved, Vec2::ZERO)); N];
        for ((one, input), ridden) in next.iter_mut().zip(inputs).zip(&mut rides) {
            *ridden = one.ride_on(level, solids, input.drop);
        }
        Solid::move_all(solids);
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
    /// Returns the outcome and a motion: that of the solid that it stood on, or in the air how far
    /// it was pushed.
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
    ///         hero.step_carried(&Joined::new(&level, &Solids::new(&moved)), Input::default(), carry)?;
    ///     }
    ///     solids = moved;
    /// }
    /// assert_eq!(heroes.map(|hero| hero.body().min()), [Vec2::from_ints(8, 10), Vec2::from_ints(28, 10)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn ride<W: World>(&mut self, level: &W, solids: &[Solid], drop: bool) -> Result<(Outcome, Vec2), RangeError> {
        let follow = if self.floor.is_some() { self.feel.snap } else { self.falls().saturating_add(self.pull()) };
        let ridden = self.mover().with_drop_through(drop).ride(level, solids, &self.body, follow.max(Fx::ZERO));
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
    fn ride_on<W: World>(&mut self, level: &W, solids: &[Solid], drop: bool) -> Ridden {
        self.ride(&Joined::new(level, &Solids::new(&[])), solids, drop)
    }

    /// Walks where the solids are now, unless they squashed it.
    fn walk_on<W: World>(
        &mut self,
        level: &W,
        solids: &[Solid],
        input: Input,
        ridden: Ridden,
    ) -> Result<Step, RangeError> {
        match ridden? {
            (Outcome::Moved, carry) => self.step_carried(&Joined::new(level, &Solids::new(solids)), input, carry),
            (outcome, _) => Ok(Step::nothing(outcome)),
        }
    }
}
