//! Names of bodies in a broad phase.

use core::cmp::Ordering;

/// The name of one body in one broad phase: a slot, and which of its tenants is meant.
///
/// A slot that is freed and given away again has another generation, so an old handle is told ([`BroadError::Stale`](super::BroadError::Stale)) and never
/// means the new body; after 32768 tenants of one slot generations begin anew. It does not say which broad phase it is of: keep the handles of two apart. 4 bytes.
///
/// ```
/// use tilesat::{Aabb, Vec2};
/// use tilesat::broad::{BroadPhase, BruteForce};
///
/// let mut near = BruteForce::<4>::new();
/// let a = near.insert(&Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 8))?, ())?;
/// near.remove(a)?;
/// let b = near.insert(&Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 8))?, ())?;
/// assert!(a.slot() == b.slot() && a != b);
/// assert!(!near.contains(a) && near.contains(b));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Handle {
    slot: u16,
    generation: u16,
}

impl Handle {
    pub(crate) const fn new(slot: usize, generation: u16) -> Self {
        Self { slot: slot as u16, generation }
    }

    /// Whether the slot had a tenant: only then is this a name.
    pub(super) const fn is_taken(self) -> bool {
        self.generation & 1 == 1
    }

    /// The slot, below the capacity: an index into arrays of the game's own, one entry a body.
    #[must_use]
    pub const fn slot(self) -> usize {
        self.slot as usize
    }

    /// Which tenant of the slot; odd.
    #[must_use]
    pub const fn generation(self) -> u16 {
        self.generation
    }

    /// Both as one number: one comparison where two would branch.
    #[inline]
    const fn word(self) -> u32 {
        (self.slot as u32) << 16 | self.generation as u32
    }
}

/// By slot, then by generation.
impl Ord for Handle {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.word().cmp(&other.word())
    }
}

impl PartialOrd for Handle {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Two bodies whose boxes touch: what `overlaps`, `touches` and `contact` of the shapes in them need to be asked about.
///
/// `a` is the one with the smaller [key](super::Tag::key), at equal keys with the smaller slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pair {
    /// The first body.
    pub a: Handle,
    /// The second body.
    pub b: Handle,
}

impl Pair {
    /// Whether a body is one of the two.
    #[inline]
    #[must_use]
    pub const fn has(self, body: Handle) -> bool {
        self.a.word() == body.word() || self.b.word() == body.word()
    }

    /// The one that a body is near; `None` where it is not of this pair.
    ///
    /// ```
    /// use tilesat::broad::{BroadPhase, BruteForce};
    /// use tilesat::{Aabb, Vec2};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let mut near = BruteForce::<16>::new();
    /// let [hero, coin, bat] = [near.insert(&at(0)?, ())?, near.insert(&at(8)?, ())?, near.insert(&at(12)?, ())?];
    /// let mut taken = None;
    /// near.pairs(|pair| taken = taken.or(pair.other(hero)));
    /// assert_eq!(taken, Some(coin));
    /// near.pairs(|pair| assert!(pair.has(coin) && pair.has(bat) != pair.has(hero)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    #[must_use]
    pub const fn other(self, body: Handle) -> Option<Handle> {
        if self.a.word() == body.word() {
            Some(self.b)
        } else if self.b.word() == body.word() {
            Some(self.a)
        } else {
            None
        }
    }

    #[inline]
    const fn words(self) -> u64 {
        (self.a.word() as u64) << 32 | self.b.word() as u64
    }
}

/// By the first body, then by the second.
impl Ord for Pair {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.words().cmp(&other.words())
    }
}

impl PartialOrd for Pair {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_pair_knows_its_two() {
        let [a, b] = [Handle::new(3, 5), Handle::new(5, 3)];
        let pair = Pair { a, b };
        assert_eq!([a, b].map(|body| pair.other(body)), [Some(b), Some(a)]);
        assert!(pair.has(a) && pair.has(b));
        for stranger in [Handle::new(3, 3), Handle::new(5, 5), Handle::new(3, 7), Handle::new(4, 5)] {
            assert!(!pair.has(stranger) && pair.other(stranger).is_none());
        }
    }

    #[test]
    fn words_are_in_the_order_of_the_parts() {
        let ends = [0, 1, 0x7fff, 0x8000, 0xffff];
        let handle = |i: usize| Handle::new(usize::from(ends[i / 5 % 5]), ends[i % 5]);
        let parts = |h: &Handle| (h.slot(), h.generation());
        let pairs: [Pair; 625] = core::array::from_fn(|i| Pair { a: handle(i / 25), b: handle(i) });
        let both = |pair: &Pair| (parts(&pair.a), parts(&pair.b));
        for x in &pairs {
            assert_eq!(x.a.cmp(&x.b), parts(&x.a).cmp(&parts(&x.b)));
            for y in &pairs {
                assert_eq!(x.cmp(y), both(x).cmp(&both(y)));
                assert_eq!(x.partial_cmp(y), Some(x.cmp(y)));
            }
        }
    }
}
