//! The methods that all broad phases have in common.

use super::ask::{along, cast, nearest, neighbours, pairs_of, sorted_pairs, sorted_region};
use super::table::{Budget, Spatial, Unlimited};
use super::{BroadError, BroadHit, Handle, Nearest, Pair, PairCursor, PairsError, QueryError};
use crate::error::{RangeError, Truncated};
use crate::num::{Fx, Raw, Toi, Vec2};
use crate::shape::Aabb;
use heapless::VecView;

/// Finds which bodies are near each other, by their boxes.
///
/// Four implementations give the same answers. Boxes that only touch count ("near" is closed). So a
/// query misses nothing that `overlaps`, `touches` or `contact` of the shapes would find. Insert a
/// circle by its [`aabb`](crate::Circle::aabb), and a fast body by the box of its whole motion.
///
/// | question | closure, no order | in order, into a buffer |
/// |---|---|---|
/// | which bodies are near each other? | [`pairs`](Self::pairs), in parts [`pairs_from`](Self::pairs_from) | [`pairs_sorted`](Self::pairs_sorted) |
/// | which bodies are near one of these? | [`pairs_of`](Self::pairs_of) | |
/// | which bodies are here? | [`in_region`](Self::in_region), [`at_point`](Self::at_point) | [`collect_region`](Self::collect_region) |
/// | which body is nearest? | | [`nearest`](Self::nearest), [`neighbours`](Self::neighbours) |
/// | which bodies does this motion touch? | [`along`](Self::along) | [`cast_ray`](Self::cast_ray), [`cast_shape`](Self::cast_shape) |
///
/// Code that is generic over broad phases names the tag of the bodies:
///
/// ```
/// use tilesat::broad::{BroadError, BroadPhase, LooseGrid, SortSweep};
/// use tilesat::{Aabb, Filter, Fx, Vec2};
/// fn opens<B: BroadPhase<Tag = Filter>>(near: &mut B) -> Result<(bool, usize), BroadError> {
///     let at = |x| Aabb::from_size(Vec2::from_ints(x, 0), Vec2::from_ints(8, 8)).unwrap();
///     let (hero, _) = (near.insert(&at(0), Filter::default())?, near.insert(&at(90), Filter::default())?);
///     near.move_to(hero, &at(30))?; // it walked
///     let (mut door, mut clicked) = (false, 0);
///     near.in_region(&at(36), |body| door |= body == hero); // who is at the door?
///     near.at_point(Vec2::from_ints(94, 8), |_| clicked += 1); // on the border of the other one
///     Ok((door, clicked))
/// }
/// assert_eq!(opens(&mut SortSweep::<64, Filter>::new())?, (true, 1));
/// assert_eq!(opens(&mut LooseGrid::<4, 64, Filter>::new(Vec2::ZERO, Fx::from_num(32), 16)?)?, (true, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A call with a list `out` empties it first, even if it then fails. Only
/// [`pairs_from`](Self::pairs_from) appends. Only the types of this module implement the trait.
#[doc(alias("AABB tree", "BVH", "quadtree", "DynamicTree", "MoveProxy", "raycast", "World"))]
pub trait BroadPhase: Spatial {
    /// Inserts a body.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full); grids also return [`TooLarge`](BroadError::TooLarge) or
    /// [`OutOfWorld`](BroadError::OutOfWorld). Nothing is changed then.
    fn insert(&mut self, bounds: &Aabb, tag: Self::Tag) -> Result<Handle, BroadError> {
        let place = self.admit(bounds)?;
        let handle = self.slots().insert(bounds, tag)?;
        self.link(handle.slot(), place);
        Ok(handle)
    }

    /// Sets the box of a body that moved or changed its size, as in the [example](BroadPhase).
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale), and those of [`insert`](Self::insert) except `Full`. Nothing
    /// is changed then.
    #[inline]
    fn move_to(&mut self, handle: Handle, bounds: &Aabb) -> Result<(), BroadError> {
        let slot = self.table().slot(handle)?;
        let place = self.admit(bounds)?;
        self.slots().set_bounds(slot, bounds);
        self.relink(slot, place);
        Ok(())
    }

    /// Moves every body. `to` receives its handle and its box, and returns the new box. One call
    /// per frame is cheaper than one per body.
    ///
    /// # Errors
    /// The first error of [`move_to`](Self::move_to), with the body, which stays. The others move.
    #[inline]
    fn move_each(&mut self, to: impl FnMut(Handle, &Aabb) -> Aabb) -> Result<(), (Handle, BroadError)> {
        self.move_all(to)
    }

    /// Removes a body, and returns its tag.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    fn remove(&mut self, handle: Handle) -> Result<Self::Tag, BroadError> {
        let slot = self.table().slot(handle)?;
        self.unlink(slot);
        Ok(self.slots().remove(slot))
    }

    /// Whether this broad phase has the body.
    #[must_use]
    fn contains(&self, handle: Handle) -> bool {
        self.table().slot(handle).is_ok()
    }

    /// The box of a body.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    fn bounds(&self, handle: Handle) -> Result<Aabb, BroadError> {
        let bodies = self.table();
        let slot = bodies.slot(handle)?;
        bodies.bounds.get(slot).copied().ok_or(BroadError::Stale(handle))
    }

    /// The tag of a body.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    fn tag(&self, handle: Handle) -> Result<Self::Tag, BroadError> {
        let bodies = self.table();
        let slot = bodies.slot(handle)?;
        bodies.tags.get(slot).copied().ok_or(BroadError::Stale(handle))
    }

    /// Sets the tag of a body, from the next enumeration on.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale).
    fn set_tag(&mut self, handle: Handle, tag: Self::Tag) -> Result<(), BroadError> {
        let slot = self.table().slot(handle)?;
        self.slots().set_tag(slot, tag);
        Ok(())
    }

    /// The number of bodies.
    #[must_use]
    fn len(&self) -> usize {
        usize::from(self.table().state.len)
    }

    /// Whether there is no body.
    #[must_use]
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Calls `each` with every body, its box and its tag, in the order of slots.
    ///
    /// Cost: one look at each slot that was ever taken.
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, BruteForce, Keyed};
    /// use tilesat::{Aabb, Vec2};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let mut near = BruteForce::<16, Keyed>::new();
    /// let [a, b, c] = [5, 6, 7].map(|key| near.insert(&at(0).unwrap(), Keyed { key, tag: () }).unwrap());
    /// near.remove(b)?;
    /// assert!(near.bodies().map(|(body, _, tag)| (body, tag.key)).eq([(a, 5), (c, 7)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn bodies(&self) -> impl Iterator<Item = (Handle, Aabb, Self::Tag)> {
        self.table().iter()
    }

    /// Every pair whose boxes touch and whose tags let them pair, once, in no particular order.
    #[inline]
    #[doc(alias = "updatePairs")]
    fn pairs(&mut self, mut each: impl FnMut(Pair)) {
        // Without a budget and a refused pair, nothing stops it before its end.
        let _ = self.walk(&mut PairCursor::new(), &mut Unlimited, |pair| {
            each(pair);
            true
        });
    }

    /// Appends more pairs to `out`, until it is full or `budget` tests of two boxes were made.
    ///
    /// Call it again with the same cursor until it returns `Ok`. You may remove bodies between two
    /// calls. They are in no later pair, but `out` may hold an earlier one.
    ///
    /// # Errors
    /// [`BudgetExceeded`](PairsError::BudgetExceeded) and [`Full`](PairsError::Full) if there are
    /// more pairs, or may be. [`Changed`](PairsError::Changed) if bodies were inserted or moved:
    /// the next call begins from the first pair.
    fn pairs_from(&mut self, cursor: &mut PairCursor, budget: u32, out: &mut VecView<Pair>) -> Result<(), PairsError> {
        cursor.resume(self.slots().epoch())?;
        self.walk(cursor, &mut Budget(budget), |pair| out.push(pair).is_ok())
    }

    /// Replaces the contents of `out` by all pairs in canonical order.
    ///
    /// This is the order of the [key](super::Tag::key) of the first body, then that of the second,
    /// then the slots. With unique keys the result depends neither on the order of insertion nor on
    /// the kind of broad phase.
    ///
    /// Cost: that of [`pairs`](Self::pairs), and at most 4 log2 k comparisons for each pair, if k
    /// pairs are kept. 164 pairs among 512 bodies take some 130 000 instructions on a Cortex-M0.
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the first ones.
    ///
    /// ```
    /// use heapless::Vec;
    /// use tilesat::broad::{BroadPhase, BruteForce, Keyed, Pair};
    /// use tilesat::{Aabb, Vec2};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let mut near = BruteForce::<16, Keyed>::new();
    /// for (x, key) in [(0, 7), (6, 2), (12, 5)] {
    ///     near.insert(&at(x)?, Keyed { key, tag: () })?;
    /// }
    /// let mut pairs = Vec::<Pair, 4>::new();
    /// near.pairs_sorted(&mut pairs)?;
    /// let keys: Vec<_, 4> = pairs.iter().map(|pair| (near.tag(pair.a).unwrap().key, near.tag(pair.b).unwrap().key)).collect();
    /// assert_eq!(keys, [(2, 5), (2, 7)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn pairs_sorted(&mut self, out: &mut VecView<Pair>) -> Result<(), Truncated> {
        sorted_pairs(self, out)
    }

    /// Every pair with at least one of the `movers`, once, in no particular order.
    ///
    /// Use it if few of many bodies move: two that rest do not have to be tested again. Bodies far
    /// from all movers cost nothing. The movers may be in any order, and in the list more than
    /// once. Tags count as in [`pairs`](Self::pairs). With all bodies as movers the pairs are the
    /// same, at a higher cost.
    ///
    /// Cost: one region query per mover, of its box; no memory. On a Cortex-M0, with 512 bodies in
    /// a grid of 1024 x 768 units, a mover takes about 720 instructions. All pairs take 250 per
    /// body. So it pays if less than a third of the bodies move. A broad phase without cells takes
    /// 13 per mover and body, so there it pays only for a few movers.
    ///
    /// # Errors
    /// [`Stale`](BroadError::Stale), before any pair.
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, BruteForce};
    /// use tilesat::{Aabb, Vec2};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let mut near = BruteForce::<16>::new();
    /// let [crate_1, crate_2, ball] = [near.insert(&at(0)?, ())?, near.insert(&at(8)?, ())?, near.insert(&at(12)?, ())?];
    /// let mut met = Vec::new();
    /// near.pairs_of(&[ball], |pair| met.push((pair.a, pair.b)))?; // the crates rest side by side
    /// assert_eq!(met, [(crate_2, ball)]);
    /// assert!(near.contains(crate_1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    fn pairs_of(&mut self, movers: &[Handle], each: impl FnMut(Pair)) -> Result<(), BroadError> {
        pairs_of(self, movers, each)
    }

    /// Every body whose box touches a region, once, in no particular order. If the region is the
    /// box of a body, that body is included. The [trait](BroadPhase) has an example.
    #[inline]
    #[doc(alias("queryRect", "overlapAABB"))]
    fn in_region(&self, region: &Aabb, mut each: impl FnMut(Handle)) {
        let bodies = self.table();
        self.visit(region, |slot| each(bodies.handle(slot)));
    }

    /// Every body whose box holds a point, border included, once, in no particular order.
    ///
    /// The [trait](BroadPhase) has an example. No box holds a point outside the
    /// [domain](crate::num::DOMAIN).
    #[inline]
    fn at_point(&self, point: Vec2, each: impl FnMut(Handle)) {
        let p = Raw::of(point);
        self.in_region(&Aabb::from_raw_unchecked(p, p), each);
    }

    /// Replaces the contents of `out` by every body whose box touches a region, in canonical order:
    /// by key, then by slot.
    ///
    /// Cost: that of [`in_region`](Self::in_region), and at most 4 log2 k comparisons for each body
    /// found, if k bodies are kept.
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the first ones.
    fn collect_region(&self, region: &Aabb, out: &mut VecView<Handle>) -> Result<(), Truncated> {
        sorted_region(self, region, out)
    }

    /// The body for which `wanted` is true whose box is nearest to a point and at most `within`
    /// units away.
    ///
    /// On a tie, the one with the smaller key, then slot. With [`Fx::MAX`] there is no limit.
    /// Distances are compared by their exact squares. `wanted` is called at most once per body, and
    /// only for bodies that would be nearest.
    ///
    /// Cost: without cells, a look at every body. With cells, those in a square that shrinks to the
    /// nearest body found; in the worst case all bodies. One root. Among 512 bodies in 1024 x 768
    /// units it takes 1 850 instructions on a Cortex-M0 in a grid, and 100 per body without cells.
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, BruteForce};
    /// use tilesat::{Aabb, Fx, Vec2};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let mut near = BruteForce::<16>::new();
    /// let (a, b) = (near.insert(&at(0)?, ())?, near.insert(&at(40)?, ())?);
    /// let p = Vec2::from_ints(28, 13);
    /// let found = near.nearest(p, Fx::from_num(100), |_, _| true)?.unwrap();
    /// assert_eq!((found.handle, found.distance), (b, Fx::from_num(13))); // 12 along x, 5 along y
    /// let found = near.nearest(p, Fx::from_num(100), |handle, _| handle != b)?.unwrap();
    /// assert_eq!(found.handle, a);
    /// assert_eq!(near.nearest(p, Fx::from_num(12), |_, _| true)?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the point is outside the [domain](crate::num::DOMAIN), or `within` is
    /// negative.
    fn nearest(
        &self,
        point: Vec2,
        within: Fx,
        wanted: impl FnMut(Handle, &Self::Tag) -> bool,
    ) -> Result<Option<Nearest>, RangeError> {
        nearest(self, point, within, wanted)
    }

    /// Replaces the contents of `out` by all bodies whose boxes are at most `within` units away
    /// from a point, and for which `wanted` is true.
    ///
    /// The nearest comes first. The order is that of [`nearest`](Self::nearest).
    ///
    /// Cost: a region query of the square around the point. Each body found takes at most 4 log2 k
    /// comparisons, if k bodies are kept, and each body kept takes a root.
    ///
    /// # Errors
    /// [`Range`](QueryError::Range) as `nearest`: `out` is empty then;
    /// [`Truncated`](QueryError::Truncated) if they do not fit: `out` then holds the nearest ones.
    fn neighbours(
        &self,
        point: Vec2,
        within: Fx,
        wanted: impl FnMut(Handle, &Self::Tag) -> bool,
        out: &mut VecView<Nearest>,
    ) -> Result<(), QueryError> {
        neighbours(self, point, within, wanted, out)
    }

    /// Every body whose box a box touches as it moves by `motion`, once, in no particular order,
    /// with the [time](BroadHit::toi) of the first touch.
    ///
    /// It is closed and exact, in contrast to casts of shapes: both ends of the motion and the
    /// borders count. It misses nothing that a cast or a ray would hit. `each` returns how much of
    /// the motion still matters. Bodies that are touched later are left out, and a broad phase that
    /// walks along the motion does not look at them. Return [`Toi::ONE`] to see all bodies, or the
    /// time of the earliest exact hit so far to find the first hit.
    ///
    /// Cost: without cells, a look at every body. With cells, those in the cells on the path and
    /// beside it; in the worst case all bodies. A box that is not touched takes no division.
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, BruteForce};
    /// use tilesat::prelude::*;
    /// use tilesat::{Aabb, Circle, Fx, Inside, Toi, Vec2};
    /// let mut near = BruteForce::<16>::new();
    /// let balls = [(30, 5), (60, 0)].map(|(x, y)| Circle::new(Vec2::from_ints(x, y), Fx::from_num(6)).unwrap());
    /// balls.map(|ball| near.insert(&ball.aabb(), ()).unwrap());
    /// let (bullet, motion) = (Aabb::from_centre(Vec2::ZERO, Vec2::from_ints(2, 1))?, Vec2::from_ints(100, 0));
    /// let mut first = None;
    /// near.along(&bullet, motion, |handle, _, _| {
    ///     let ball = &balls[handle.slot()];
    ///     let limit = first.map_or(Toi::ONE, |(_, toi)| toi);
    ///     let Ok(Some(hit)) = bullet.cast_shape(ball, motion, Inside::Hit) else { return limit };
    ///     if hit.toi < limit {
    ///         first = Some((handle, hit.toi));
    ///     }
    ///     limit.min(hit.toi)
    /// })?;
    /// assert_eq!(first.unwrap().0.slot(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the motion would leave the [domain](crate::num::DOMAIN).
    fn along(
        &self,
        start: &Aabb,
        motion: Vec2,
        each: impl FnMut(Handle, &Self::Tag, Toi) -> Toi,
    ) -> Result<(), RangeError> {
        along(self, start, motion, each)
    }

    /// Replaces the contents of `out` by all bodies whose boxes a ray from `origin` along `motion`
    /// touches, and for which `wanted` is true.
    ///
    /// The earliest comes first. At the same time (in parts of 2^30) the one with the smaller key
    /// comes first, then the smaller slot. It is closed and exact. A box that holds the start is
    /// touched at 0, also from its border. A box that is only grazed counts, and so does the very
    /// end.
    ///
    /// Cost: that of [`along`](Self::along), and at most 4 log2 k comparisons for each hit, if k
    /// hits are kept.
    ///
    /// ```
    /// use heapless::Vec;
    /// use tilesat::{Aabb, Vec2, broad::{BroadHit, BroadPhase, BruteForce}};
    /// let at = |x, y| Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(8, 8)).unwrap();
    /// let (mut near, mut hits) = (BruteForce::<16>::new(), Vec::<BroadHit, 4>::new());
    /// let [third, first, second] = [(40, 0), (10, 8), (14, 0)].map(|(x, y)| near.insert(&at(x, y), ()).unwrap());
    /// near.cast_ray(Vec2::from_ints(0, 8), Vec2::from_ints(60, 0), |_, _| true, &mut hits)?; // grazes all three
    /// assert!(hits.iter().map(|hit| hit.handle).eq([first, second, third]));
    /// # Ok::<(), tilesat::broad::QueryError>(())
    /// ```
    ///
    /// # Errors
    /// [`Range`](QueryError::Range) if an end of the ray is outside the
    /// [domain](crate::num::DOMAIN); `out` is then empty. [`Truncated`](QueryError::Truncated) if
    /// the bodies do not fit; `out` then holds the earliest ones.
    fn cast_ray(
        &self,
        origin: Vec2,
        motion: Vec2,
        wanted: impl FnMut(Handle, &Self::Tag) -> bool,
        out: &mut VecView<BroadHit>,
    ) -> Result<(), QueryError> {
        out.clear();
        cast(self, &Aabb::new(origin, origin)?, motion, wanted, out)
    }

    /// Replaces the contents of `out` by the bodies that a moving box could run into, as
    /// [`cast_ray`](Self::cast_ray) for a point.
    ///
    /// ```
    /// use heapless::Vec;
    /// use tilesat::broad::{BroadHit, BroadPhase, BruteForce};
    /// use tilesat::{Aabb, Fx, Vec2, fx};
    /// let at = |x, y| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + 8, y + 8));
    /// let mut near = BruteForce::<16>::new();
    /// let (far, close) = (near.insert(&at(88, 0)?, ())?, near.insert(&at(28, 8)?, ())?);
    /// let mut hits = Vec::<BroadHit, 4>::new();
    /// near.cast_shape(&at(0, 0)?, Vec2::from_ints(80, 0), |_, _| true, &mut hits)?;
    /// // It passes along the side of one, and just reaches the other one.
    /// assert!(hits.iter().map(|hit| (hit.handle, hit.toi.to_fx())).eq([(close, fx!(0.25)), (far, Fx::ONE)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`cast_ray`](Self::cast_ray).
    fn cast_shape(
        &self,
        start: &Aabb,
        motion: Vec2,
        wanted: impl FnMut(Handle, &Self::Tag) -> bool,
        out: &mut VecView<BroadHit>,
    ) -> Result<(), QueryError> {
        cast(self, start, motion, wanted, out)
    }
}

impl<B: Spatial> BroadPhase for B {}
