//! Pairs that are ignored for a while.

use super::ordered::{self, Entry};
use crate::broad::{BroadError, Handle, Pair};

/// How long a pair is ignored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Ignore {
    /// In the next frame in which it comes, then no more.
    Once,
    /// Until a frame ends in which it did not come, the frame in which this is said not counted: a bullet that starts within its shooter.
    UntilApart,
    /// Until one of the bodies is removed: a shield and its bearer.
    UntilRemoved,
}

/// Up to M pairs of bodies that are to be ignored, each for a while of its own.
///
/// [`passes`](Self::passes) says of each pair of a frame whether it counts; [`finish`](Self::finish) at the frame's end forgets what is over, and bodies that are gone. Behind
/// the game's own test of the shapes, "apart" is of the shapes; before it, of the boxes. A pair that is not to count is not fed to
/// [`PairEvents`](crate::broad::PairEvents): where it had begun, it ends.
///
/// The two handles may be given in either order. Plain data, a copy is a snapshot; 12 bytes a pair. Cost: a binary search a pair, one pass a frame.
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
pub struct Exceptions<const M: usize> {
    /// By the handles in ascending order.
    entries: [Entry<Pair, Term>; M],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Term {
    ignore: Ignore,
    /// In the frame under way.
    came: bool,
}

/// One name for the two orders of a pair; broad phases order by key, which may change.
#[inline]
fn sorted(a: Handle, b: Handle) -> Pair {
    if a <= b { Pair { a, b } } else { Pair { a: b, b: a } }
}

impl<const M: usize> Default for Exceptions<M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const M: usize> Exceptions<M> {
    /// Without any; may be a `static`.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: [Entry(None); M] }
    }

    /// Ignores a pair from now on; what was said of it before is replaced.
    ///
    /// # Errors
    /// [`Full`](BroadError::Full): there are M others. Nothing was changed then. Those of removed bodies make room in [`finish`](Self::finish).
    pub fn ignore(&mut self, a: Handle, b: Handle, ignore: Ignore) -> Result<(), BroadError> {
        put(&mut self.entries, sorted(a, b), Term { ignore, came: ignore == Ignore::UntilApart })
    }

    /// Ignores a pair no longer; what was said of it, if anything was.
    pub fn allow(&mut self, a: Handle, b: Handle) -> Option<Ignore> {
        let (pair, mut found) = (sorted(a, b), None);
        ordered::retain(&mut self.entries, |known, term| {
            let other = *known != pair;
            if !other {
                found = Some(term.ignore);
            }
            other
        });
        found
    }

    /// Whether a pair that came counts: no exception is made of it.
    #[inline]
    pub fn passes(&mut self, pair: Pair) -> bool {
        // Most frames have none.
        self.entries.first().is_none_or(|entry| entry.0.is_none()) || passes(&mut self.entries, pair)
    }

    /// Ends the frame: forgets what is over.
    ///
    /// `present` says whether a body is still here; `held`, as in [`PairEvents::finish`](crate::broad::PairEvents::finish), whether two that did not come are together because they rest.
    pub fn finish(&mut self, present: impl FnMut(Handle) -> bool, held: impl FnMut(&Pair) -> bool) {
        finish(&mut self.entries, present, held);
    }

    /// The pairs that are ignored, the smaller handle first, in ascending order.
    pub fn iter(&self) -> impl Iterator<Item = (Pair, Ignore)> {
        self.entries.iter().filter_map(|entry| entry.0).map(|(pair, term)| (pair, term.ignore))
    }
}

fn passes(entries: &mut [Entry<Pair, Term>], pair: Pair) -> bool {
    let pair = sorted(pair.a, pair.b);
    match ordered::known(entries, ordered::place(entries, &pair), &pair) {
        Some(term) => {
            term.came = true;
            false
        }
        None => true,
    }
}

fn put(entries: &mut [Entry<Pair, Term>], pair: Pair, term: Term) -> Result<(), BroadError> {
    let at = ordered::place(entries, &pair);
    if let Some(known) = ordered::known(entries, at, &pair) {
        *known = term;
        return Ok(());
    }
    let end = ordered::count(entries);
    if end == entries.len() {
        return Err(BroadError::Full { capacity: entries.len() as u16 });
    }
    ordered::insert(entries.get_mut(at..=end).unwrap_or_default(), pair, term);
    Ok(())
}

fn finish(
    entries: &mut [Entry<Pair, Term>],
    mut present: impl FnMut(Handle) -> bool,
    mut held: impl FnMut(&Pair) -> bool,
) {
    ordered::retain(entries, |pair, term| {
        let came = core::mem::replace(&mut term.came, false);
        let lasts = match term.ignore {
            Ignore::Once => !came,
            Ignore::UntilApart => came || held(pair),
            Ignore::UntilRemoved => true,
        };
        lasts && present(pair.a) && present(pair.b)
    });
}
