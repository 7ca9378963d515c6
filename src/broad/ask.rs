//! The queries of a broad phase other than all its pairs. They find bodies near a point or on a
//! path, in order, and the pairs of a few bodies.
//!
//! Answers are in canonical order. If room is short, they are the first ones.

use super::table::Bodies;
use super::table::{Spatial, Unlimited};
use super::{BroadError, Handle, Pair, PairCursor, QueryError, Tag};
use crate::error::{Quantity, RangeError, Truncated};
use crate::num::{DOMAIN, Fx, Raw, Toi, Vec2, check_coordinate, fraction, isqrt64, norm, umul, usqr};
use crate::query::cast::Span;
use crate::shape::Aabb;
use heapless::{Vec, VecView};

/// Keeps the first of many items, in an order.
///
/// While there is room, items are only stored. After that they become a heap with the last one on
/// top, which each earlier item replaces. For n items, of which k are kept, that takes at most 2 n
/// log2 k comparisons, and sorting takes as many for the k. Both are bounded, and in place.
pub(in crate::broad) struct FirstFew<'a, T, F> {
    out: &'a mut VecView<T>,
    /// A strict total order.
    before: F,
    seen: u32,
}

impl<'a, T: Copy, F: Fn(&T, &T) -> bool> FirstFew<'a, T, F> {
    /// A list in an empty buffer.
    pub(in crate::broad) fn new(out: &'a mut VecView<T>, before: F) -> Self {
        Self { out, before, seen: 0 }
    }

    pub(in crate::broad) fn add(&mut self, item: T) {
        self.seen = self.seen.saturating_add(1);
        if self.out.push(item).is_ok() {
            if self.out.is_full() {
                heap(self.out, &self.before);
            }
        } else if let Some(last) = self.out.first_mut().filter(|last| (self.before)(&item, last)) {
            *last = item;
            sink(self.out, 0, &self.before);
        }
    }

    pub(in crate::broad) fn sort(self) -> Result<(), Truncated> {
        if !self.out.is_full() {
            heap(self.out, &self.before);
        }
        for end in (1..self.out.len()).rev() {
            if let Ok([last, place]) = self.out.get_disjoint_mut([0, end]) {
                core::mem::swap(last, place);
            }
            sink(self.out.get_mut(..end).unwrap_or_default(), 0, &self.before);
        }
        let kept = self.out.len() as u32;
        if kept == self.seen { Ok(()) } else { Err(Truncated { seen: self.seen, kept }) }
    }
}

fn heap<T: Copy>(items: &mut [T], before: &impl Fn(&T, &T) -> bool) {
    for place in (0..items.len() >> 1).rev() {
        sink(items, place, before);
    }
}

/// Moves an item to a place in the heap below which no item comes after it.
///
/// First it goes down to the bottom, while the later one of two moves up. Then it goes up to its
/// place, which is mostly near the bottom. That takes half the comparisons of a search from the
/// top.
#[inline(never)]
fn sink<T: Copy>(items: &mut [T], top: usize, before: &impl Fn(&T, &T) -> bool) {
    let Some(&item) = items.get(top) else { return };
    let mut place = top;
    loop {
        let left = 2 * place + 1;
        let (child, value) = match (items.get(left), items.get(left + 1)) {
            (Some(a), Some(b)) if before(a, b) => (left + 1, *b),
            (Some(a), _) => (left, *a),
            (None, _) => break,
        };
        set(items, place, value);
        place = child;
    }
    while place > top {
        let parent = (place - 1) >> 1;
        let Some(&above) = items.get(parent).filter(|above| before(above, &item)) else { break };
        set(items, place, above);
        place = parent;
    }
    set(items, place, item);
}

fn set<T: Copy>(items: &mut [T], place: usize, item: T) {
    if let Some(of) = items.get_mut(place) {
        *of = item;
    }
}

impl<T: Tag> Bodies<'_, T> {
    /// A body's position in canonical order.
    pub(in crate::broad) fn rank(&self, handle: Handle) -> (u32, usize) {
        let slot = handle.slot();
        (self.tags.get(slot).map_or(0, Tag::key), slot)
    }
}

/// The pairs come in batches, because their keys are not readable during the walk.
pub(in crate::broad) fn sorted_pairs<S: Spatial>(phase: &mut S, out: &mut VecView<Pair>) -> Result<(), Truncated> {
    out.clear();
    let (mut cursor, mut batch) = (PairCursor::new(), Vec::<Pair, 16>::new());
    let mut seen = 0u32;
    loop {
        batch.clear();
        let walked = phase.walk(&mut cursor, &mut Unlimited, |pair| batch.push(pair).is_ok());
        let bodies = phase.table();
        let mut first = FirstFew { out, before: |a: &Pair, b: &Pair| pair_before(bodies, *a, *b), seen };
        for &pair in &batch {
            first.add(pair);
        }
        if walked.is_ok() || batch.is_empty() {
            return first.sort();
        }
        seen = first.seen;
    }
}

fn pair_before<T: Tag>(bodies: Bodies<'_, T>, a: Pair, b: Pair) -> bool {
    let key = |handle: Handle| bodies.rank(handle).0;
    // Most pairs differ in their first body.
    let first = key(a.a).cmp(&key(b.a));
    first.then_with(|| key(a.b).cmp(&key(b.b)).then((a.a.slot(), a.b.slot()).cmp(&(b.a.slot(), b.b.slot())))).is_lt()
}

pub(in crate::broad) fn sorted_region<S: Spatial>(
    phase: &S,
    region: &Aabb,
    out: &mut VecView<Handle>,
) -> Result<(), Truncated> {
    out.clear();
    let bodies = phase.table();
    let mut first = FirstFew::new(out, |a: &Handle, b: &Handle| bodies.rank(*a) < bodies.rank(*b));
    phase.visit(region, |slot| first.add(bodies.handle(slot)));
    first.sort()
}

/// A body near a point, and how far away its box is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Nearest {
    /// The body.
    pub handle: Handle,
    /// The distance of the point from the body's box, rounded down; 0 if the box holds it.
    pub distance: Fx,
}

/// How far a box is from a point along x and along y: below 2^30.
fn apart(p: Raw, bounds: &Aabb) -> (i32, i32) {
    let gap = |p: i32, lo: i32, hi: i32| lo.wrapping_sub(p).max(p.wrapping_sub(hi)).max(0);
    let (lo, hi) = (bounds.lo(), bounds.hi());
    (gap(p.x, lo.x, hi.x), gap(p.y, lo.y, hi.y))
}

/// The square of the distance of a point from the box of a slot; beyond all if there is no slot.
fn square_to<T: Tag>(bodies: Bodies<'_, T>, p: Raw, slot: usize) -> u64 {
    let Some(bounds) = bodies.bounds.get(slot) else { return u64::MAX };
    let (x, y) = apart(p, bounds);
    norm(x, y)
}

fn distance(square: u64) -> Fx {
    Fx::from_bits(isqrt64(square) as i32)
}

/// No two points of the domain are as far apart as the largest length, 2^30.5 < 2^31 raw. So every
/// length is accepted, and none wraps.
fn checked_point(point: Vec2, within: Fx) -> Result<(Raw, i32), RangeError> {
    check_coordinate(point)?;
    let reach = within.to_bits();
    if reach < 0 { Err(RangeError { what: Quantity::Radius, value: reach }) } else { Ok((Raw::of(point), reach)) }
}

/// Compares exact squares; on a tie, the canonical order.
pub(in crate::broad) fn nearest<S: Spatial>(
    phase: &S,
    point: Vec2,
    within: Fx,
    mut wanted: impl FnMut(Handle, &S::Tag) -> bool,
) -> Result<Option<Nearest>, RangeError> {
    let (p, mut reach) = checked_point(point, within)?;
    let bodies = phase.table();
    let (mut best, mut limit) = (None, usqr(reach as u32));
    phase.visit_near(p, reach, |slot| {
        let handle = bodies.handle(slot);
        let (Some(bounds), Some(tag)) = (bodies.bounds.get(slot), bodies.tags.get(slot)) else { return reach };
        let (x, y) = apart(p, bounds);
        let square = norm(x, y);
        let first = square < limit || best.is_none_or(|best| bodies.rank(handle) < bodies.rank(best));
        if square <= limit && first && wanted(handle, tag) {
            (best, limit) = (Some(handle), square);
            // Not below the length, whose square is a^2 + b^2 <= (a + b / 2)^2 for a >= b: no root.
            reach = reach.min(x.max(y).wrapping_add(x.min(y).wrapping_add(1) >> 1));
        }
        reach
    });
    Ok(best.map(|handle| Nearest { handle, distance: distance(limit) }))
}

/// Finds all wanted bodies within reach, the nearest first.
pub(in crate::broad) fn neighbours<S: Spatial>(
    phase: &S,
    point: Vec2,
    within: Fx,
    mut wanted: impl FnMut(Handle, &S::Tag) -> bool,
    out: &mut VecView<Nearest>,
) -> Result<(), QueryError> {
    out.clear();
    let (p, reach) = checked_point(point, within)?;
    let bodies = phase.table();
    let limit = usqr(reach as u32);
    let order = |near: &Nearest| (square_to(bodies, p, near.handle.slot()), bodies.rank(near.handle));
    let mut first = FirstFew::new(out, |a: &Nearest, b: &Nearest| order(a) < order(b));
    phase.visit_near(p, reach, |slot| {
        let handle = bodies.handle(slot);
        if square_to(bodies, p, slot) <= limit && bodies.tags.get(slot).is_some_and(|tag| wanted(handle, tag)) {
            first.add(Nearest { handle, distance: Fx::ZERO });
        }
        reach
    });
    let sorted = first.sort();
    // Computes roots only of the bodies that stay in the list.
    for near in out.iter_mut() {
        near.distance = distance(square_to(bodies, p, near.handle.slot()));
    }
    Ok(sorted?)
}

/// A body whose box a ray or a moving box touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BroadHit {
    /// The body.
    pub handle: Handle,
    /// The time at which it first touches the box, rounded down. A shape in the box is not hit
    /// earlier.
    pub toi: Toi,
}

/// The closed counterparts of the spans of casts.
impl Span {
    const fn meets(self) -> bool {
        self.gap <= self.speed && self.leave >= 0
    }

    /// Whether this span is left at the entry of the other one, or after that: `leave / speed >=
    /// gap / speed` of the other. Products are below 2^60; there are none if the motion ends first.
    const fn lasts_until(self, other: Self) -> bool {
        other.gap <= 0
            || self.leave >= self.speed
            || umul(self.leave as u32, other.speed as u32) >= umul(other.gap as u32, self.speed as u32)
    }

    /// The moment of entry: `gap <= speed`.
    fn entry(self) -> Toi {
        if self.gap <= 0 { Toi::ZERO } else { Toi::exact(fraction(self.gap as u32, self.speed as u32)) }
    }
}

/// When the box `a` that moves by `d` first has a point in common with the box `b`. This is the
/// closed counterpart of a cast, which hits only if the motion starts to overlap.
fn touched(a: &Aabb, d: Raw, b: &Aabb) -> Option<Toi> {
    let (alo, ahi, blo, bhi) = (a.lo(), a.hi(), b.lo(), b.hi());
    let x = Span::new(alo.x, ahi.x, blo.x, bhi.x, d.x);
    let y = Span::new(alo.y, ahi.y, blo.y, bhi.y, d.y);
    // Both intervals of time meet, each is closed, and rounding down keeps the order of the
    // entries.
    (x.meets() && y.meets() && x.lasts_until(y) && y.lasts_until(x)).then(|| x.entry().max(y.entry()))
}

/// A sum that wraps is outside the domain, too: it is at least 2^30 from zero.
fn checked_way(start: &Aabb, motion: Vec2) -> Result<Raw, RangeError> {
    let d = Raw::of(motion);
    let (lo, hi) = (start.lo().add(d), start.hi().add(d));
    for (what, low, high) in [(Quantity::EndX, lo.x, hi.x), (Quantity::EndY, lo.y, hi.y)] {
        for value in [low, high] {
            if value <= -DOMAIN || value >= DOMAIN {
                return Err(RangeError { what, value });
            }
        }
    }
    Ok(d)
}

/// Every body that is touched not later than the last answer of `each`.
pub(in crate::broad) fn along<S: Spatial>(
    phase: &S,
    start: &Aabb,
    motion: Vec2,
    each: impl FnMut(Handle, &S::Tag, Toi) -> Toi,
) -> Result<(), RangeError> {
    visit_way(phase, start, checked_way(start, motion)?, each);
    Ok(())
}

fn visit_way<S: Spatial>(phase: &S, start: &Aabb, d: Raw, mut each: impl FnMut(Handle, &S::Tag, Toi) -> Toi) {
    let bodies = phase.table();
    let mut limit = Toi::ONE;
    phase.visit_path(start, d, |slot| {
        let (Some(bounds), Some(tag)) = (bodies.bounds.get(slot), bodies.tags.get(slot)) else { return limit };
        if let Some(toi) = touched(start, d, bounds).filter(|toi| *toi <= limit) {
            limit = limit.min(each(bodies.handle(slot), tag, toi));
        }
        limit
    });
}

/// Separate from the choice of bodies: all casts of a broad phase sort by the same code.
fn earlier<T: Tag>(bodies: Bodies<'_, T>) -> impl Fn(&BroadHit, &BroadHit) -> bool {
    let order = move |hit: &BroadHit| (hit.toi, bodies.rank(hit.handle));
    move |a, b| order(a) < order(b)
}

pub(in crate::broad) fn cast<S: Spatial>(
    phase: &S,
    start: &Aabb,
    motion: Vec2,
    mut wanted: impl FnMut(Handle, &S::Tag) -> bool,
    out: &mut VecView<BroadHit>,
) -> Result<(), QueryError> {
    out.clear();
    let d = checked_way(start, motion)?;
    let mut first = FirstFew::new(out, earlier(phase.table()));
    visit_way(phase, start, d, |handle, tag, toi| {
        if wanted(handle, tag) {
            first.add(BroadHit { handle, toi });
        }
        Toi::ONE
    });
    Ok(first.sort()?)
}

/// How far a body is moved along y while the others are tested: out of the domain. Nothing in the
/// domain then touches the box, and moving it back needs no rounding. Coordinates below 2^29 become
/// ones in 2^29..2^31. The x coordinate does not change, and so an order by x does not, either.
const ASIDE: i32 = DOMAIN << 1;

/// Every pair with one of the movers, once. A mover is moved aside after its query, so later movers
/// do not meet it. That needs no memory and no order. A mover that is named twice is already aside
/// the second time.
pub(in crate::broad) fn pairs_of<S: Spatial>(
    phase: &mut S,
    movers: &[Handle],
    mut each: impl FnMut(Pair),
) -> Result<(), BroadError> {
    let bodies = phase.table();
    for &mover in movers {
        bodies.slot(mover)?;
    }
    let stage = Restore { phase, movers };
    for mover in movers {
        let slot = mover.slot();
        let Some(bounds) = stage.phase.table().bounds.get(slot).copied().filter(|b| !is_aside(b)) else { continue };
        put(stage.phase, slot, &bounds, ASIDE);
        let bodies = stage.phase.table();
        stage.phase.visit(&bounds, |other| {
            if let Some(pair) = bodies.pair(slot, other) {
                each(pair);
            }
        });
    }
    Ok(())
}

/// Moves all movers back at the end, even if `each` panics.
struct Restore<'a, S: Spatial> {
    phase: &'a mut S,
    movers: &'a [Handle],
}

impl<S: Spatial> Drop for Restore<'_, S> {
    fn drop(&mut self) {
        for mover in self.movers {
            let slot = mover.slot();
            if let Some(bounds) = self.phase.table().bounds.get(slot).copied().filter(is_aside) {
                put(self.phase, slot, &bounds, -ASIDE);
            }
        }
    }
}

fn is_aside(bounds: &Aabb) -> bool {
    bounds.lo().y >= DOMAIN
}

/// Only the table is changed, so no structure and no running enumeration is disturbed.
fn put<S: Spatial>(phase: &mut S, slot: usize, bounds: &Aabb, by: i32) {
    let (mut lo, mut hi) = (bounds.lo(), bounds.hi());
    (lo.y, hi.y) = (lo.y.wrapping_add(by), hi.y.wrapping_add(by));
    if let Some(place) = phase.slots().bounds.get_mut(slot) {
        *place = Aabb::from_raw_unchecked(lo, hi);
    }
}
