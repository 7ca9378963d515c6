//! Which pairs begin, stay and end from frame to frame.

mod exceptions;
mod ordered;

pub use exceptions::{Exceptions, Ignore};

use crate::broad::Pair;
use crate::error::Truncated;
use ordered::Entry;

/// What became of a pair in one frame.
///
/// Of every pair comes `Begin`, then `Stay` in each later frame, then `End`, once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PairEvent<P = Pair> {
    /// It was not there in the frame before.
    Begin(P),
    /// It was, and is.
    Stay(P),
    /// It is not there any more: the bodies parted, or one was removed; its handle is the old one then.
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
enum Mark {
    /// It came this frame and was not there before.
    New,
    /// It was there before and did not come: not yet, or, where the frame is over, not at all.
    Old,
    /// It was there before, and is.
    Both,
}

/// The pairs of the last frame, at most M of them, and what has changed since: begin, stay and end of contacts and of visits to sensors.
///
/// In each frame [`feed`](Self::feed) takes the pairs that count, in any order, each once or more often; those are what the game's own test of the shapes
/// leaves of what the broad phase found. [`finish`](Self::finish) ends the frame, and [`iter`](Self::iter) then tells what became of each pair, in ascending order of
/// pairs, as often as it is asked, until the next frame is fed.
///
/// Any `P` that is `Copy + Ord` is a pair: `(Handle, Cell)`-like tuples for tiles that trigger, or the keys of two bodies, where the order of events shall not
/// depend on the order of insertion as that of handles does. `(a, b)` and `(b, a)` are two pairs; a broad phase gives only one of them.
///
/// - **Bodies at rest**: two [still](crate::Filter::still) bodies are no pair of a broad phase, and what fell asleep in a trigger is in it all the same: `finish` asks `held` about
///   each pair that did not come. Let bodies fall asleep after `finish`, so that the frame in which they moved is judged by where they are.
/// - **More than M pairs**: those of the last frame stay until they end, and of the new ones the smallest fit; `finish` says
///   [`Truncated`]. What did not fit was not begun, has no end, and begins as soon as there is room. There is none too few where M is the number of pairs of two successive frames together.
///
/// Plain data, a copy is a snapshot; for [`Pair`]s 12 bytes each. Cost: of a pair known since the last frame a binary search, of a new one also the moves of all
/// greater ones, so M new pairs at once are M^2 / 2 moves at worst; a frame is two passes over the pairs. With 64 pairs on a
/// Cortex-M0: 310 instructions a pair that is known, 590 a new one where they come the greatest first.
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
///     near.set_tag(hero, all)?; // who moves is awake
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
pub struct PairEvents<const M: usize, P = Pair> {
    entries: [Entry<P, Mark>; M],
    frame: Frame,
}

/// Of the present frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Frame {
    fed: u32,
    lost: bool,
    /// Nothing was fed since it ended.
    over: bool,
}

impl<const M: usize, P: Copy + Ord> Default for PairEvents<M, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const M: usize, P: Copy + Ord> PairEvents<M, P> {
    /// Without any pair; may be a `static`.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: [Entry(None); M], frame: Frame { fed: 0, lost: false, over: true } }
    }

    /// This pair is there in the frame under way.
    #[inline]
    pub fn feed(&mut self, pair: P) {
        feed(&mut self.entries, &mut self.frame, &pair);
    }

    /// Ends the frame.
    ///
    /// `held` is asked about every pair of the last frame that did not come, whether it is there all the same, because its bodies rest; it must say no where one
    /// was removed. `|_| false` where nothing rests.
    ///
    /// # Errors
    /// [`Truncated`] where there were more than M pairs: the events are those of the M that were kept. A pair that was fed twice is seen twice.
    pub fn finish(&mut self, held: impl FnMut(&P) -> bool) -> Result<(), Truncated> {
        finish(&mut self.entries, &mut self.frame, held)
    }

    /// What became of each pair in the frame that ended last, in ascending order of pairs; nothing where the next one is being fed already.
    pub fn iter(&self) -> impl Iterator<Item = PairEvent<P>> {
        let told: &[Entry<P, Mark>] = if self.frame.over { &self.entries } else { &[] };
        told.iter().filter_map(|entry| entry.0).map(|(pair, mark)| match mark {
            Mark::New => PairEvent::Begin(pair),
            Mark::Old => PairEvent::End(pair),
            Mark::Both => PairEvent::Stay(pair),
        })
    }

    /// Takes back what was fed since the last `finish`, for an enumeration that has to begin anew ([`Changed`](crate::broad::PairsError::Changed)).
    pub fn cancel(&mut self) {
        if !self.frame.over {
            ordered::retain(&mut self.entries, |_, mark| core::mem::replace(mark, Mark::Old) != Mark::New);
            self.frame = Frame { fed: 0, lost: false, over: false };
        }
    }

    /// The pairs that have begun and not ended as of the last `finish`, in ascending order.
    pub fn pairs(&self) -> impl Iterator<Item = P> {
        self.entries.iter().filter_map(|entry| entry.0).filter(|(_, mark)| self.was_there(*mark)).map(|(pair, _)| pair)
    }

    /// Whether a pair has begun and not ended as of the last `finish`.
    #[must_use]
    pub fn contains(&self, pair: P) -> bool {
        let at = self.entries.get(ordered::place(&self.entries, &pair));
        matches!(at, Some(Entry(Some((known, mark)))) if *known == pair && self.was_there(*mark))
    }

    fn was_there(&self, mark: Mark) -> bool {
        mark != if self.frame.over { Mark::Old } else { Mark::New }
    }
}

/// Begins the next frame, if the last one is over: drops what ended.
fn begin<P: Copy>(entries: &mut [Entry<P, Mark>], frame: &mut Frame) {
    if frame.over {
        ordered::retain(entries, |_, mark| core::mem::replace(mark, Mark::Old) != Mark::Old);
        *frame = Frame { fed: 0, lost: false, over: false };
    }
}

// Not in line: the capacity is no constant here, one copy serves all.
#[inline(never)]
fn feed<P: Copy + Ord>(entries: &mut [Entry<P, Mark>], frame: &mut Frame, pair: &P) {
    begin(entries, frame);
    frame.fed = frame.fed.saturating_add(1);
    let at = ordered::place(entries, pair);
    if let Some(mark) = ordered::known(entries, at, pair) {
        if *mark == Mark::Old {
            *mark = Mark::Both;
        }
        return;
    }
    let mut end = ordered::count(entries);
    if end == entries.len() {
        // The greatest new pair makes way, or this one is it; pairs that were told never do. So those of the new ones that stay are the smallest of all
        // that came, in whichever order.
        frame.lost = true;
        let Some(last) = entries.iter().rposition(|entry| matches!(entry, Entry(Some((_, Mark::New))))) else { return };
        end = last;
    }
    if let Some(part) = entries.get_mut(at..=end) {
        ordered::insert(part, *pair, Mark::New);
    }
}

fn finish<P: Copy>(
    entries: &mut [Entry<P, Mark>],
    frame: &mut Frame,
    mut held: impl FnMut(&P) -> bool,
) -> Result<(), Truncated> {
    begin(entries, frame);
    frame.over = true;
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
