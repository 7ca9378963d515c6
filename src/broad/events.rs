//! Which pairs begin, stay and end from frame to frame, and which are ignored for some time. Both
//! are in ascending order, in fixed arrays.

use super::{BroadError, Handle, Pair};
use crate::error::Truncated;

/// Aligned to words, so a small core moves entries in a few registers. With a smaller alignment it
/// would call a memory routine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(align(4))]
pub(in crate::broad) struct Listed<K, V>(pub(in crate::broad) Option<(K, V)>);

/// The index of a key, or of the first entry that is not below it.
#[inline]
pub(in crate::broad) fn place<K: Ord, V>(entries: &[Listed<K, V>], key: &K) -> usize {
    entries.partition_point(|entry| matches!(entry, Listed(Some((k, _))) if k < key))
}

/// The value under a key that was searched for.
#[inline]
pub(in crate::broad) fn known<'a, K: Eq, V>(entries: &'a mut [Listed<K, V>], at: usize, key: &K) -> Option<&'a mut V> {
    match entries.get_mut(at) {
        Some(Listed(Some((k, value)))) if k == key => Some(value),
        _ => None,
    }
}

/// How many entries there are.
#[inline]
pub(in crate::broad) fn count<K, V>(entries: &[Listed<K, V>]) -> usize {
    entries.partition_point(|entry| entry.0.is_some())
}

/// Inserts an entry before those of a part of the array and moves them up by one. The last of the
/// part is dropped.
pub(in crate::broad) fn insert<K: Copy, V: Copy>(part: &mut [Listed<K, V>], key: K, value: V) {
    let mut places = part.iter_mut().rev();
    let Some(mut to) = places.next() else { return };
    for from in places {
        *to = *from;
        to = from;
    }
    *to = Listed(Some((key, value)));
}

/// Keeps the entries for which `keep` returns true, in one pass. `keep` may change the values.
pub(in crate::broad) fn retain<K: Copy, V: Copy>(
    entries: &mut [Listed<K, V>],
    mut keep: impl FnMut(&K, &mut V) -> bool,
) {
    let mut kept = 0;
    for i in 0..entries.len() {
        let Some((key, mut value)) = entries.get_mut(i).and_then(|entry| entry.0.take()) else { break };
        if keep(&key, &mut value) {
            if let Some(slot) = entries.get_mut(kept) {
                *slot = Listed(Some((key, value)));
            }
            kept += 1;
        }
    }
}

/// The state of a pair in one frame: `Begin`, then `Stay` in each later frame, then `End` once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PairEvent<P = Pair> {
    /// The pair is new: it was not there in the last frame.
    Begin(P),
    /// The pair was there, and still is.
    Stay(P),
    /// The pair is not there any more: the bodies parted, or one was removed. Its handle is then
    /// the old one.
    End(P),
}

impl<P: Copy> PairEvent<P> {
    /// The pair.
    #[must_use]
    pub fn pair(&self) -> P {
        match *self {
            Self::Begin(pair) | Self::Stay(pair) | Self::End(pair) => pair,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Mark {
    /// It came in this frame and was not there before. Marks start at 1, and no entry is zero, so a
    /// static list without entries takes no flash.
    New = 1,
    /// It was there before and did not come: not yet, or, if the frame is over, not at all.
    Old,
    /// It was there before, and is.
    Both,
}

/// The pairs of the last frame, at most M of them, and the changes since: contacts and visits to
/// sensors that begin, stay and end.
///
/// In each frame, [`feed`](Self::feed) it the pairs that count, in any order, each at least once.
/// These are the pairs of the broad phase that pass your test of the shapes.
/// [`finish`](Self::finish) ends the frame. [`iter`](Self::iter) then lists the state of each pair,
/// in ascending order of pairs. You can call it several times, until you feed the next frame.
///
/// A pair is any `P` that is `Copy + Ord`: the keys of two bodies, or `(Handle, Cell)` for tiles
/// that trigger and for [landings](crate::scene#games-in-a-scene). The order of handles depends on
/// the order of insertion. Use keys if the order of events must not. `(a, b)` and `(b, a)` are two
/// pairs; a broad phase gives only one of them.
///
/// - **Bodies at rest**: two [still](crate::Filter::still) bodies do not pair in a broad phase. But
///   a body that fell asleep in a trigger is still in it. So `finish` calls `held` for each pair
///   that did not come. Let bodies fall asleep after `finish`, so the frame in which they last
///   moved uses their final positions.
/// - **More than M pairs**: those of the last frame stay until they end, and the smallest of the
///   new ones fit; `finish` returns [`Truncated`]. A pair that did not fit has not begun, and does
///   not end. It begins as soon as there is room. An M as large as the pairs of two successive
///   frames together is always enough.
///
/// Plain data: a copy is a snapshot. Each [`Pair`] takes 12 bytes. Cost: a binary search for each
/// pair. A new pair also moves all greater ones, so M new pairs at once take up to M^2 / 2 moves.
/// Each frame takes two passes over the pairs. With 64 pairs on a Cortex-M0: 310 instructions per
/// known pair, and 590 per new one if the greatest come first.
///
/// ```
/// use tilesat::broad::{BroadPhase, BruteForce, PairEvent, PairEvents};
/// use tilesat::{Aabb, Filter, LayerMask, Vec2};
/// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
/// let all = Filter::default();
/// let (mut near, mut events) = (BruteForce::<8, Filter>::new(), PairEvents::<16>::new());
/// let trap = near.insert(&at(0)?, all.with_still(true).with_sensor(true))?;
/// let hero = near.insert(&at(20)?, all)?;
///
/// let mut log = Vec::new();
/// for x in [9, 8, 4, 4, 9] {
///     near.move_to(hero, &at(x)?)?;
///     near.set_tag(hero, all)?; // a moving body is awake
///     near.pairs(|pair| events.feed(pair));
///     let rests = |handle| near.tag(handle).is_ok_and(|filter| filter.still());
///     events.finish(|pair| rests(pair.a) && rests(pair.b))?;
///     log.extend(events.iter().map(|event| (x, event)));
///     near.set_tag(hero, all.with_still(x == 4))?;
/// }
/// let pair = log[0].1.pair();
/// assert_eq!((pair.a, pair.b), (trap, hero));
/// use PairEvent::{Begin, End, Stay};
/// assert_eq!(log, [(8, Begin(pair)), (4, Stay(pair)), (4, Stay(pair)), (9, End(pair))]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("on_collision_enter", "body_entered", "beginContact"))]
pub struct PairEvents<const M: usize, P = Pair> {
    pub(super) entries: [Listed<P, Mark>; M],
    pub(super) frame: FrameState,
}

/// The state of the current frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct FrameState {
    fed: u32,
    lost: bool,
    /// Whether a pair was fed since the last frame ended.
    begun: bool,
}

impl<const M: usize, P: Copy + Ord> Default for PairEvents<M, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const M: usize, P: Copy + Ord> PairEvents<M, P> {
    /// An empty list, which may be a `static`.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: [Listed(None); M], frame: FrameState { fed: 0, lost: false, begun: false } }
    }

    /// Reports that a pair is there in the current frame.
    #[inline]
    pub fn feed(&mut self, pair: P) {
        feed(&mut self.entries, &mut self.frame, &pair);
    }

    /// Ends the frame.
    ///
    /// `held` is called for each pair of the last frame that did not come. It returns whether the
    /// pair is still there because its bodies rest, and must be false for a pair with a removed
    /// body. Pass `|_| false` if no body rests.
    ///
    /// # Errors
    /// [`Truncated`] if there were more than M pairs. The events are those of the M that were kept.
    /// A pair that you fed twice counts twice in `seen`.
    pub fn finish(&mut self, held: impl FnMut(&P) -> bool) -> Result<(), Truncated> {
        finish(&mut self.entries, &mut self.frame, held)
    }

    /// The state of each pair in the frame that ended last, in ascending order of pairs; empty once
    /// you have fed the next frame.
    pub fn iter(&self) -> impl Iterator<Item = PairEvent<P>> {
        let listed: &[Listed<P, Mark>] = if self.frame.begun { &[] } else { &self.entries };
        listed.iter().filter_map(|entry| entry.0).map(|(pair, mark)| match mark {
            Mark::New => PairEvent::Begin(pair),
            Mark::Old => PairEvent::End(pair),
            Mark::Both => PairEvent::Stay(pair),
        })
    }

    /// Discards everything fed since the last `finish`, if an enumeration has to begin again
    /// ([`Changed`](crate::broad::PairsError::Changed)).
    pub fn cancel(&mut self) {
        if self.frame.begun {
            retain(&mut self.entries, |_, mark| core::mem::replace(mark, Mark::Old) != Mark::New);
            self.frame = FrameState { fed: 0, lost: false, begun: true };
        }
    }

    /// The pairs that have begun and not ended as of the last `finish`, in ascending order.
    pub fn pairs(&self) -> impl Iterator<Item = P> {
        self.entries.iter().filter_map(|entry| entry.0).filter(|(_, mark)| self.was_there(*mark)).map(|(pair, _)| pair)
    }

    /// Whether a pair has begun and not ended as of the last `finish`.
    #[must_use]
    pub fn contains(&self, pair: P) -> bool {
        let at = self.entries.get(place(&self.entries, &pair));
        matches!(at, Some(Listed(Some((known, mark)))) if *known == pair && self.was_there(*mark))
    }

    fn was_there(&self, mark: Mark) -> bool {
        mark != if self.frame.begun { Mark::New } else { Mark::Old }
    }
}

/// Begins the next frame, unless it has begun, and drops the pairs that ended.
fn begin<P: Copy>(entries: &mut [Listed<P, Mark>], frame: &mut FrameState) {
    if !frame.begun {
        retain(entries, |_, mark| core::mem::replace(mark, Mark::Old) != Mark::Old);
        *frame = FrameState { fed: 0, lost: false, begun: true };
    }
}

// Not inlined, because one copy without the capacity as a constant serves all lists.
#[inline(never)]
fn feed<P: Copy + Ord>(entries: &mut [Listed<P, Mark>], frame: &mut FrameState, pair: &P) {
    begin(entries, frame);
    frame.fed = frame.fed.saturating_add(1);
    let at = place(entries, pair);
    if let Some(mark) = known(entries, at, pair) {
        if *mark == Mark::Old {
            *mark = Mark::Both;
        }
        return;
    }
    let mut end = count(entries);
    if end == entries.len() {
        // The greatest new pair is dropped, or this pair is. Reported pairs never are. So the new
        // pairs that stay are the smallest of all, whatever their order.
        frame.lost = true;
        let Some(last) = entries.iter().rposition(|entry| matches!(entry, Listed(Some((_, Mark::New))))) else {
            return;
        };
        end = last;
    }
    if let Some(part) = entries.get_mut(at..=end) {
        insert(part, *pair, Mark::New);
    }
}

fn finish<P: Copy>(
    entries: &mut [Listed<P, Mark>],
    frame: &mut FrameState,
    mut held: impl FnMut(&P) -> bool,
) -> Result<(), Truncated> {
    begin(entries, frame);
    frame.begun = false;
    let mut kept = 0;
    for (pair, mark) in entries.iter_mut().filter_map(|entry| entry.0.as_mut()) {
        if *mark != Mark::Old {
            kept += 1;
        } else if held(pair) {
            *mark = Mark::Both;
        }
    }
    if frame.lost { Err(Truncated { seen: frame.fed, kept }) } else { Ok(()) }
}

/// How long a pair is ignored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Ignore {
    /// In the next frame in which the pair comes, and not after that.
    Once = 1, // as in `Mark`
    /// Until the first frame in which the pair did not come. The frame in which you set it does not
    /// count. Use it for a bullet that starts inside its shooter.
    UntilApart,
    /// Until one of the bodies is removed. Use it for a shield and its bearer.
    UntilRemoved,
}

/// Up to M pairs of bodies to ignore, each for a time that you choose.
///
/// [`passes`](Self::passes) decides for each pair of a frame whether it counts.
/// [`finish`](Self::finish) at the end of the frame forgets pairs whose time is over, and removed
/// bodies. If you call `passes` after your test of the shapes, "apart" refers to the shapes; if
/// before it, to the boxes. Do not feed an ignored pair to
/// [`PairEvents`](crate::broad::PairEvents): if it had begun, it ends.
///
/// You may pass the two handles in either order. Plain data: a copy is a snapshot, 12 bytes per
/// pair. Cost: a binary search per pair, one pass per frame.
///
/// ```
/// use tilesat::broad::{BroadPhase, BruteForce, Exceptions, Ignore};
/// use tilesat::{Aabb, Vec2};
/// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
/// let (mut near, mut exceptions) = (BruteForce::<8>::new(), Exceptions::<4>::new());
/// let (ship, bullet) = (near.insert(&at(0)?, ())?, near.insert(&at(6)?, ())?);
/// exceptions.ignore(bullet, ship, Ignore::UntilApart)?;
///
/// let mut hits = Vec::new();
/// for x in [6, 8, 9, 8] {
///     near.move_to(bullet, &at(x)?)?;
///     near.pairs(|pair| if exceptions.passes(pair) { hits.push(x) });
///     exceptions.finish(|handle| near.contains(handle), |_| false);
/// }
/// assert_eq!(hits, [8]); // when it came back
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("ignoreCollision", "add_collision_exception_with"))]
pub struct Exceptions<const M: usize> {
    /// The entries, by the handles in ascending order.
    pub(super) entries: [Listed<Pair, Term>; M],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Term {
    ignore: Ignore,
    /// `Both` if it came in the current frame, else `Old`.
    pub(super) mark: Mark,
}

/// One form for both orders of a pair, because broad phases order by key, which may change.
#[inline]
pub(super) fn sorted(a: Handle, b: Handle) -> Pair {
    if a <= b { Pair { a, b } } else { Pair { a: b, b: a } }
}

impl<const M: usize> Default for Exceptions<M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const M: usize> Exceptions<M> {
    /// An empty list, which may be a `static`.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: [Listed(None); M] }
    }

    /// Ignores a pair from now on, and replaces any earlier rule for it.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full) if there are M others. Nothing is changed then.
    /// [`finish`](Self::finish) drops those of removed bodies.
    pub fn ignore(&mut self, a: Handle, b: Handle, ignore: Ignore) -> Result<(), BroadError> {
        let mark = if ignore == Ignore::UntilApart { Mark::Both } else { Mark::Old };
        put(&mut self.entries, sorted(a, b), Term { ignore, mark })
    }

    /// No longer ignores a pair, if it was ignored.
    pub fn allow(&mut self, a: Handle, b: Handle) -> Option<Ignore> {
        let (pair, mut found) = (sorted(a, b), None);
        retain(&mut self.entries, |known, term| {
            let other = *known != pair;
            if !other {
                found = Some(term.ignore);
            }
            other
        });
        found
    }

    /// Whether a pair that came counts, because there is no exception for it.
    #[inline]
    pub fn passes(&mut self, pair: Pair) -> bool {
        // Most frames have none.
        self.entries.first().is_none_or(|entry| entry.0.is_none()) || passes(&mut self.entries, pair)
    }

    /// Ends the frame: forgets the rules whose time is over.
    ///
    /// `present` returns whether a body is still there. `held` returns whether two bodies that did
    /// not come are together because they rest, as in
    /// [`PairEvents::finish`](crate::broad::PairEvents::finish).
    pub fn finish(&mut self, present: impl FnMut(Handle) -> bool, held: impl FnMut(&Pair) -> bool) {
        expire(&mut self.entries, present, held);
    }

    /// The pairs that are ignored, the smaller handle first, in ascending order.
    pub fn iter(&self) -> impl Iterator<Item = (Pair, Ignore)> {
        self.entries.iter().filter_map(|entry| entry.0).map(|(pair, term)| (pair, term.ignore))
    }
}

fn passes(entries: &mut [Listed<Pair, Term>], pair: Pair) -> bool {
    let pair = sorted(pair.a, pair.b);
    match known(entries, place(entries, &pair), &pair) {
        Some(term) => {
            term.mark = Mark::Both;
            false
        }
        None => true,
    }
}

fn put(entries: &mut [Listed<Pair, Term>], pair: Pair, term: Term) -> Result<(), BroadError> {
    let at = place(entries, &pair);
    if let Some(known) = known(entries, at, &pair) {
        *known = term;
        return Ok(());
    }
    let end = count(entries);
    if end == entries.len() {
        return Err(BroadError::Full { capacity: entries.len() as u16 });
    }
    insert(entries.get_mut(at..=end).unwrap_or_default(), pair, term);
    Ok(())
}

fn expire(
    entries: &mut [Listed<Pair, Term>],
    mut present: impl FnMut(Handle) -> bool,
    mut held: impl FnMut(&Pair) -> bool,
) {
    retain(entries, |pair, term| {
        let came = core::mem::replace(&mut term.mark, Mark::Old) == Mark::Both;
        let lasts = match term.ignore {
            Ignore::Once => !came,
            Ignore::UntilApart => came || held(pair),
            Ignore::UntilRemoved => true,
        };
        lasts && present(pair.a) && present(pair.b)
    });
}
