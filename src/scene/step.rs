//! One step of a scene.

use super::body::{Mode, NOBODY, Slot, Tally, UNSETTLED};
use super::body_path::{BodyPath, Pace};
use super::change::add_to_awake;
use super::idle::{are_idle, idle, is_idle, repeats, stop_idling};
use super::kept_out::{Before, fixed_margin};
use super::kernel::BodyShape;
use super::level_of_body::{Common, EachLevel, EachLevelTraced, View};
use super::meeting_time::{around, may_meet, pair, senses};
use super::memory::{Remembered, keep};
use super::pairs::{both, collect_effects, each_pair, join, note_who_lies, root};
use super::piles::ground_under;
use super::reply::{Answer, ByCall, Replies, Reply, Unasked};
use super::resting::{NEAR, join_leaning, leans};
use super::seams::{SeamLook, clear_before, look_again};
use super::set::Sleep;
use super::through_level::Trip;
use super::{Scene, SceneBody, SceneError, SceneEvent, Stepped};
use crate::broad::{BroadPhase, Handle, Keyed, Pair};
use crate::filter::Filter;
use crate::num::{MOTION, Vec2, check_motion};
use crate::world::{Trail, World};

impl<B: BroadPhase<Tag = Keyed<Filter>>, const N: usize, const M: usize, S: BodyShape> Scene<B, N, M, S> {
    /// Moves all awake bodies by one step. A step adds `gravity` (units per step squared) to
    /// velocities; pass zero for top-down games.
    ///
    /// The [module](super) describes what happens, and in which order. `each` receives the events.
    ///
    /// Cost: sleeping bodies cost nothing. Those awake cost the enumeration of their pairs, twice
    /// if bodies run into each other. Each body takes a
    /// [`move_and_slide`](crate::Mover::move_and_slide), and another one if bodies push it.
    ///
    /// # Errors
    /// [`SceneError`] if the gravity is not a valid motion; nothing is changed then. A body that
    /// cannot be moved is not an error of the step: it is [held](SceneEvent::Held).
    #[doc(alias("simulate", "update"))]
    pub fn step<W: World>(
        &mut self,
        level: &W,
        gravity: Vec2,
        mut each: impl FnMut(SceneEvent<'_>),
    ) -> Result<Stepped, SceneError> {
        // None of the types depends on the caller's closure: a game that steps in two places links
        // one copy.
        self.run(&Common(level), gravity, &mut Unasked, &mut each)
    }

    /// Like [`step`](Self::step), with a closure `replies` that decides about each pair. It returns
    /// a [`Reply`](super::Reply), or a `bool` for whether the pair takes effect. A refused pair
    /// neither pushes nor wakes, and is not reported.
    ///
    /// `replies` is called for each pair that touches, and again if the two run into each other. It
    /// must return the same in the whole step. If a [`Filter`](crate::Filter) is enough, use that:
    /// it costs less.
    ///
    /// ```
    /// use tilesat::scene::{Reply, SceneBody, SceneEvent, SortSweepScene};
    /// use tilesat::{Aabb, Circle, Fx, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY)?;
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 4, 16));
    /// let friends = [scene.insert(&SceneBody::new(at(12)?, 1))?, scene.insert(&SceneBody::new(at(22)?, 2))?];
    /// let wall = scene.insert(&SceneBody::fixed(at(40)?, 3))?;
    /// let bullet = SceneBody::new(Circle::new(Vec2::from_ints(4, 8), Fx::ONE)?, 9);
    /// let bullet = scene.insert(&SceneBody { velocity: Vec2::from_ints(50, 0), floats: true, ..bullet })?;
    ///
    /// let mut met = Vec::new();
    /// let replies = |pair: tilesat::broad::Pair| match pair.a {
    ///     other if other == wall => Reply::Touch,
    ///     _ => Reply::Cross,
    /// };
    /// scene.step_with(&level, Vec2::ZERO, replies, |event| {
    ///     if let SceneEvent::Meet { pair, .. } = event {
    ///         met.push(pair.a);
    ///     }
    /// })?;
    /// assert_eq!((met.contains(&friends[0]), met.contains(&friends[1])), (true, true)); // it crossed both
    /// assert_eq!(scene.body(bullet)?.shape.position(), Vec2::from_ints(39, 8)); // and stopped at the wall
    /// assert_eq!(scene.body(bullet)?.velocity, Vec2::ZERO);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// With a list of pairs that do not meet for a while:
    ///
    /// ```
    /// use tilesat::broad::{Exceptions, Ignore};
    /// use tilesat::scene::{SceneBody, SceneEvent, SortSweepScene};
    /// use tilesat::{Aabb, Circle, Fx, TileKinds, TileMap, Vec2};
    /// let level = TileMap::from_ascii("....\n....\n", &TileKinds::EMPTY)?;
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let ship = scene.insert(&SceneBody::new(Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(16, 8))?, 1))?;
    /// let shot = SceneBody::new(Circle::new(Vec2::from_ints(14, 4), Fx::ONE)?, 2);
    /// let shot = scene.insert(&SceneBody { velocity: Vec2::from_ints(2, 0), ..shot })?;
    /// let mut exceptions = Exceptions::<4>::new();
    /// exceptions.ignore(shot, ship, Ignore::UntilApart)?;
    /// for _ in 0..5 {
    ///     scene.step_with(&level, Vec2::ZERO, |pair| exceptions.passes(pair), |event| {
    ///         assert!(!matches!(event, SceneEvent::Touch { .. }));
    ///     })?;
    ///     exceptions.finish(|handle| scene.body(handle).is_ok(), |pair| scene.rests(pair));
    /// }
    /// assert_eq!(scene.body(shot)?.velocity, Vec2::from_ints(2, 0));
    /// assert_eq!(exceptions.iter().count(), 0); // it has left
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_with<W: World, A: Answer>(
        &mut self,
        level: &W,
        gravity: Vec2,
        replies: impl FnMut(Pair) -> A,
        mut each: impl FnMut(SceneEvent<'_>),
    ) -> Result<Stepped, SceneError> {
        self.run(&Common(level), gravity, &mut ByCall(replies), &mut each)
    }

    /// Like [`step_with`](Self::step_with), with a level for each body: ghosts that pass curtains,
    /// or bullets that pass fences.
    ///
    /// `level_of` must return the same level for a body throughout the step. It costs a call for
    /// each motion.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Circle, TileKind, TileKinds, TileMap, Vec2, fx};
    /// const CURTAIN: u8 = 1;
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'c', TileKind::FULL.with_flags(CURTAIN));
    /// static GHOSTS: TileKinds = KINDS.passing(CURTAIN);
    /// let rows = "...c\n...c\n";
    /// let (level, ghosts) = (TileMap::from_ascii(rows, &KINDS)?, TileMap::from_ascii(rows, &GHOSTS)?);
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let body = |y, key| Circle::new(Vec2::from_ints(40, y), fx!(4)).map(|ball| SceneBody {
    ///     velocity: Vec2::from_ints(20, 0),
    ///     ..SceneBody::new(ball, key)
    /// });
    /// let (ghost, knight) = (scene.insert(&body(8, 1)?)?, scene.insert(&body(24, 2)?)?);
    /// let level_of = |body: &SceneBody| if body.key == 1 { &ghosts } else { &level };
    /// scene.step_in(level_of, Vec2::ZERO, |_| true, |_| ())?;
    /// assert_eq!(scene.body(ghost)?.shape.position(), Vec2::from_ints(60, 8));
    /// assert_eq!(scene.body(knight)?.shape.position(), Vec2::from_ints(44, 24));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_in<'l, W: World + 'l, A: Answer>(
        &mut self,
        level_of: impl Fn(&SceneBody<S>) -> &'l W,
        gravity: Vec2,
        replies: impl FnMut(Pair) -> A,
        mut each: impl FnMut(SceneEvent<'_>),
    ) -> Result<Stepped, SceneError> {
        self.run(&EachLevel::by(level_of), gravity, &mut ByCall(replies), &mut each)
    }

    /// Like [`step_in`](Self::step_in), and reports each path of a body. Use it for everything that
    /// bodies pass, as bump.lua's "cross".
    ///
    /// `passed` receives the body, its shape before the motion, and the [`Trail`] of its path.
    /// [`TileMap::tiles_on`](crate::TileMap::tiles_on) and [`Solids::on`](crate::Solids::on) list
    /// the tiles and solids on it, exactly, whether the body slides, bounces or is fast. A body
    /// makes one or several paths in a step; each begins where the last one ended. A body that
    /// stays makes none. A tile on two paths is reported on both.
    ///
    /// If the broad phase refuses the end of a path, the body is [held](SceneEvent::Held) at its
    /// old position, and the path was already reported. If a fixed body ends a motion, one path
    /// leads on, by up to half of the body, and the next one back. A scene that
    /// [remembers](Self::remembering) looks in these steps like any other.
    ///
    /// Cost: that of `step_in`. A program that calls both links the step twice.
    ///
    /// ```
    /// use tilesat::scene::{SceneBody, SortSweepScene};
    /// use tilesat::{Cell, Circle, TileKind, TileKinds, TileMap, Vec2, fx};
    /// const CURTAIN: u8 = 1;
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'c', TileKind::FULL.with_flags(CURTAIN));
    /// static GHOSTS: TileKinds = KINDS.passing(CURTAIN);
    /// let level = TileMap::from_ascii("..c.c.#\n.......", &GHOSTS)?;
    /// let mut scene = SortSweepScene::<8>::empty();
    /// let ghost = SceneBody::new(Circle::new(Vec2::from_ints(8, 8), fx!(4))?, 1);
    /// let ghost = scene.insert(&SceneBody { velocity: Vec2::from_ints(100, 20), ..ghost })?;
    /// let mut cells = Vec::new();
    /// scene.step_along(|_| &level, Vec2::ZERO, |_| true, |_| (), |body, shape, trail| {
    ///     assert_eq!((body, shape.position()), (ghost, Vec2::from_ints(8, 8)));
    ///     let passed = level.tiles_on(shape, trail).expect("it was inside of the domain");
    ///     cells.extend(passed.filter(|tile| tile.kind.flag(CURTAIN)).map(|tile| tile.cell));
    /// })?;
    /// assert_eq!(cells, [Cell::new(2, 0), Cell::new(4, 0)]); // both, and not the wall
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step).
    #[doc(alias = "cross")]
    pub fn step_along<'l, W: World + 'l, A: Answer>(
        &mut self,
        level_of: impl Fn(&SceneBody<S>) -> &'l W,
        gravity: Vec2,
        replies: impl FnMut(Pair) -> A,
        mut each: impl FnMut(SceneEvent<'_>),
        passed: impl FnMut(Handle, &S, &Trail),
    ) -> Result<Stepped, SceneError> {
        // Repeated motions are not reported.
        self.memory.fill(Remembered::Empty);
        self.run(&EachLevelTraced::by(level_of, passed), gravity, &mut ByCall(replies), &mut each)
    }

    fn run(
        &mut self,
        view: &impl View<S>,
        gravity: Vec2,
        replies: &mut impl Replies,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> Result<Stepped, SceneError> {
        check_motion(gravity, MOTION).map_err(SceneError::call)?;
        let mut stepped = Stepped::default();
        if self.count == 0 {
            return Ok(stepped);
        }
        let awake = self.count;
        if M > 0 {
            self.stop_idling_in_reach(gravity);
        }
        let first = begin(&mut self.slots, &self.memory, self.awake.get(..awake).unwrap_or_default(), gravity);
        self.meet(gravity, &mut stepped, replies, each);
        // The woken bodies have woken those that they touch. Here they also wake those that rest on
        // them.
        if self.count > first {
            self.wake_along(first, gravity, replies);
            stepped.woken = (self.count - awake) as u16;
            self.mark_woken(awake);
        }
        // Asleep and fixed bodies are not in the list.
        let fixed = if self.near.len() > self.count { fixed_margin(&self.slots, gravity) } else { None };
        let trip = Trip::new(view, gravity, fixed, self.sleep(), N);
        if self.travel(&trip, &mut stepped, replies, each) {
            self.fall_asleep(&trip, &mut stepped, replies);
        }
        Ok(stepped)
    }

    /// Bodies against bodies, at the positions of the step's start.
    fn meet(
        &mut self,
        gravity: Vec2,
        stepped: &mut Stepped,
        replies: &mut impl Replies,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) {
        let Some((movers, room)) = self.awake.split_at_mut_checked(self.count) else { return };
        let (slots, memory, mut woken, mut hits) = (&mut self.slots, &self.memory, 0, false);
        each_pair(&mut self.near, movers, |pair| {
            stepped.pairs += 1;
            let Some((a, b)) = both(slots, pair).filter(|(a, b)| a.body.shape.touches(&b.body.shape)) else { return };
            let reply = replies.to(pair);
            if reply == Reply::Ignore {
                return;
            }
            let contact = a.body.shape.contact(&b.body.shape);
            let senses = senses(a, b) || reply == Reply::Cross;
            stepped.touching += 1;
            stepped.overlapping += u32::from(contact.is_some() && !senses);
            each(SceneEvent::Touch { pair, contact: contact.as_ref() });
            if senses || are_idle(memory, slots, pair) {
                return;
            }
            for at in [pair.a, pair.b] {
                add_to_awake(slots, room, &mut woken, at);
            }
            join(slots, pair);
            let carried = note_who_lies(slots, pair, contact.as_ref(), gravity);
            if let Some(contact) = contact {
                hits |= collect_effects(slots, pair, &contact, gravity, (carried, reply));
            }
        });
        let awake = (&*movers, room.get(..woken).unwrap_or_default());
        let mut again = stepped.overlapping > 0;
        for look in SeamLook::ALL {
            again = again && clear_before(look, slots, memory, awake);
            let wanted = if look == SeamLook::Kicks { hits } else { again };
            if !wanted {
                continue;
            }
            each_pair(&mut self.near, movers, |pair| {
                stepped.pairs += 1;
                if !are_idle(memory, slots, pair) {
                    look_again(look, slots, pair, gravity, replies);
                }
            });
        }
        self.count += woken;
    }

    /// Wakes the bodies that touch, or rest on, one of those woken since the list had `from`
    /// entries: a pile wakes as a whole.
    #[inline(never)]
    pub(super) fn wake_along(&mut self, from: usize, gravity: Vec2, replies: &mut impl Replies) {
        let Self { near, slots, awake, count, .. } = self;
        let mut at = from;
        while let Some(&handle) = awake.get(..*count).and_then(|awake| awake.get(at)) {
            at += 1;
            let Some(bounds) = slots.get(handle.slot()).map(|slot| slot.body.shape.aabb()) else { continue };
            near.in_region(&around(&bounds, NEAR.to_bits() as u32), |other| {
                let (Some(one), Some(two)) = (slots.get(handle.slot()), slots.get(other.slot())) else { return };
                // Two that others woke have not met in this step: they join one pile, too.
                if other == handle
                    || !matches!(two.mode, Mode::Asleep | Mode::Woken)
                    || senses(one, two)
                    || !may_meet(one, two)
                    || !(one.body.shape.touches(&two.body.shape) || leans(one, two, gravity))
                {
                    return;
                }
                let pair = pair((handle, one), (other, two));
                if replies.to(pair).acts() {
                    add_to_awake(slots, awake, count, other);
                    join(slots, pair);
                }
            });
        }
    }

    /// Each body against the level, and fast bodies against the others, too. Returns whether one
    /// has been quiet for long enough.
    fn travel<V: View<S>>(
        &mut self,
        trip: &Trip<'_, V>,
        stepped: &mut Stepped,
        replies: &mut impl Replies,
        each: &mut dyn FnMut(SceneEvent<'_>),
    ) -> bool {
        let Sleep { steps, .. } = self.sleep();
        let (mut calm, mut fast, mut piled) = (false, false, false);
        for handle in self.awake.iter().take(self.count) {
            let Some(slot) = self.slots.get_mut(handle.slot()) else { continue };
            if let Some(rest) = idle(&self.memory, handle.slot()) {
                // It keeps its turn: the order of the bodies does not depend on the memory.
                slot.path.pace = if rest.start.lies { Pace::Lies } else { Pace::Slow };
            } else if slot.is_fast() {
                (slot.path.pace, fast) = (Pace::Swept, true);
                keep(&mut self.memory, handle.slot(), None);
            }
            piled |= slot.path.pace == Pace::Lies;
        }
        if fast {
            self.release_unreachable(trip, replies);
            self.cut_paths(replies);
        }
        for &handle in self.awake.iter().take(self.count) {
            if self.slots.get(handle.slot()).is_none_or(|slot| slot.path.pace != Pace::Slow) {
                continue;
            }
            if !repeats(&mut self.slots, &self.memory, handle, stepped, each) {
                let ground = ground_under(&self.slots, handle);
                let Some(slot) = self.slots.get_mut(handle.slot()) else { continue };
                let before = trip.fixed.map(|_| Before::of(slot));
                trip.make(slot, (handle, ground), &mut self.memory, &mut self.near, stepped, each);
                if let Some(before) = before {
                    trip.keep_out((&mut self.slots, &mut self.near, &mut self.memory), handle, &before, replies);
                }
            }
            calm |= self.slots.get(handle.slot()).is_some_and(|slot| slot.quiet >= steps);
        }
        if piled {
            calm |= self.settle(trip, stepped, replies, each);
        }
        if M > 0 {
            self.find_idle(trip.gravity);
        }
        if fast {
            calm |= self.sweep(trip, stepped, replies, each);
        }
        calm && steps != 0
    }

    /// Bodies that touch, directly or not, sleep together or not at all. None sleeps if nothing
    /// holds it: one that rolls off a corner ends each step in the air.
    fn fall_asleep<V: View<S>>(&mut self, trip: &Trip<'_, V>, stepped: &mut Stepped, replies: &mut impl Replies) {
        let Sleep { steps, .. } = self.sleep();
        let slots = &mut self.slots;
        let awake = self.awake.get_mut(..self.count).unwrap_or_default();
        for handle in &*awake {
            join_leaning(slots, &self.near, *handle, (trip.gravity, steps), replies);
            if let Some(slot) = slots.get_mut(handle.slot()) {
                slot.tally.hits = u16::MAX;
            }
        }
        for handle in &*awake {
            let quiet = |slot: &Slot<S>| if slot.tally.under == UNSETTLED { 0 } else { slot.quiet };
            let Some(quiet) = slots.get(handle.slot()).map(quiet) else { continue };
            let root = root(slots, handle.slot() as u16);
            if let Some(slot) = slots.get_mut(usize::from(root)) {
                slot.tally.hits = slot.tally.hits.min(quiet.into());
            }
        }
        for handle in &*awake {
            let root = usize::from(root(slots, handle.slot() as u16));
            let sleeps = slots.get(root).is_some_and(|slot| slot.tally.hits >= u16::from(steps));
            if sleeps && !trip.is_held_up(slots, &self.near, *handle) {
                if let Some(slot) = slots.get_mut(root) {
                    slot.tally.hits = 0;
                }
            }
        }
        let mut left = 0;
        for k in 0..awake.len() {
            let Some(&handle) = awake.get(k) else { continue };
            let root = root(slots, handle.slot() as u16);
            let calm = slots.get(usize::from(root)).map_or(0, |slot| slot.tally.hits);
            if calm < u16::from(steps) {
                if let Some(place) = awake.get_mut(left) {
                    *place = handle;
                }
                left += 1;
            } else if let Some(slot) = slots.get_mut(handle.slot()) {
                (slot.mode, slot.body.velocity, slot.path) = (Mode::Asleep, Vec2::ZERO, BodyPath::REST);
                slot.ground = NOBODY;
                stop_idling(&mut self.memory, handle.slot());
                let marked = self.near.set_tag(handle, slot.body.tag(true));
                debug_assert!(marked.is_ok(), "a body of the scene is in its broad phase");
            }
        }
        stepped.slept = (self.count - left) as u16;
        self.count = left;
    }
}

/// Begins a step of all bodies that make one. Returns the entry of the list from which on bodies
/// were woken since the last step began.
fn begin<S: BodyShape>(slots: &mut [Slot<S>], memory: &[Remembered], awake: &[Handle], gravity: Vec2) -> usize {
    let mut first = awake.len();
    for (at, handle) in awake.iter().enumerate().filter(|(_, handle)| !is_idle(memory, handle.slot())) {
        let Some(slot) = slots.get_mut(handle.slot()) else { continue };
        if slot.mode == Mode::Woken {
            first = first.min(at);
        }
        slot.tally = Tally { drift: slot.tally.drift, ..Tally::of(handle.slot() as u16) };
        slot.mode = Mode::Awake;
        // A body that lay on others may be a raw unit above them. It then touches nobody.
        let lay = slot.lies(gravity);
        (slot.path.pace, slot.path.turns) = (if lay { Pace::Lies } else { Pace::Slow }, 0);
        slot.body.velocity += slot.body.weight(gravity);
    }
    first
}
