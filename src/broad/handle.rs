//! The handle of a body, its tag (nothing, a filter, a key), and the errors.

use crate::error::{RangeError, Truncated};
use crate::filter::{Filter, LayerMask};
use crate::num::Fx;
use core::cmp::Ordering;
use core::fmt;

/// Identifies one body in one broad phase: a slot, and the generation of its tenant.
///
/// A slot that is freed and used again has another generation. An old handle is then refused
/// ([`BroadError::Stale`](super::BroadError::Stale)) and never means the new body. After 32 768
/// tenants of one slot, generations repeat. A handle does not say which broad phase it belongs to,
/// so keep the handles of two broad phases apart. It takes 4 bytes.
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
#[doc(alias("ProxyId", "entity id"))]
pub struct Handle {
    slot: u16,
    generation: u16,
}

impl Handle {
    pub(crate) const fn new(slot: usize, generation: u16) -> Self {
        Self { slot: slot as u16, generation }
    }

    /// Whether the slot had a tenant. Only then it identifies a body.
    pub(super) const fn is_taken(self) -> bool {
        self.generation & 1 == 1
    }

    /// The slot, below the capacity: an index into your own arrays, with one entry per body.
    #[must_use]
    pub const fn slot(self) -> usize {
        self.slot as usize
    }

    /// The generation of the slot's tenant; odd.
    #[must_use]
    pub const fn generation(self) -> u16 {
        self.generation
    }

    /// Both as one number, which takes one comparison instead of a branch.
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

/// Two bodies whose boxes touch.
///
/// Test their shapes with `overlaps`, `touches` or `contact`. `a` is the one with the smaller
/// [key](super::Tag::key); if keys are equal, with the smaller slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

    /// The other body; `None` if `body` is not of this pair.
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

/// The value of a body in a broad phase.
///
/// It decides with which bodies it pairs, and its position in canonical order. It is used only for
/// two bodies whose boxes touch. `()` pairs with all and costs nothing, [`Filter`](crate::Filter)
/// has layers, and [`Keyed`] adds a key. For another rule, write your own type:
///
/// ```
/// use tilesat::broad::Tag;
/// #[derive(Clone, Copy)]
/// struct Team(u8);
/// impl Tag for Team {
///     const BLANK: Self = Self(0);
///     fn pairs_with(&self, other: &Self) -> bool {
///         self.0 != other.0
///     }
/// }
/// assert!(Team(1).pairs_with(&Team(2)) && !Team(1).pairs_with(&Team(1)));
/// ```
pub trait Tag: Copy {
    /// The tag of free slots.
    const BLANK: Self;

    /// Whether two bodies may pair.
    ///
    /// It must be symmetric.
    #[inline]
    #[must_use]
    fn pairs_with(&self, other: &Self) -> bool {
        let _ = other;
        true
    }

    /// The body's position in canonical order.
    ///
    /// Choose unique keys if the order must not depend on that of insertion.
    #[inline]
    #[must_use]
    fn key(&self) -> u32 {
        0
    }
}

impl Tag for () {
    const BLANK: Self = ();
}

impl Tag for Filter {
    const BLANK: Self = Self::new(LayerMask::NONE, LayerMask::NONE);

    #[inline]
    fn pairs_with(&self, other: &Self) -> bool {
        self.lets_pair(*other)
    }
}

/// A tag with a key that you choose.
///
/// Pairs sorted by it do not depend on the order of insertion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Keyed<T = ()> {
    /// Unique among the bodies.
    pub key: u32,
    /// The tag that decides with which bodies it pairs.
    pub tag: T,
}

impl<T: Tag> Tag for Keyed<T> {
    const BLANK: Self = Self { key: 0, tag: T::BLANK };

    #[inline]
    fn pairs_with(&self, other: &Self) -> bool {
        self.tag.pairs_with(&other.tag)
    }

    #[inline]
    fn key(&self) -> u32 {
        self.key
    }
}

/// Why the broad phase did not insert, move or find a body.
///
/// Nothing was changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BroadError {
    /// All slots are taken.
    Full {
        /// The number of slots.
        capacity: u16,
    },
    /// The handle's body was removed.
    ///
    /// A handle of another broad phase is refused only if its slot has no body here, or one of
    /// another generation. A body with the same slot and generation cannot be distinguished.
    Stale(Handle),
    /// The box is wider or higher than a cell of the grid, in raw units.
    TooLarge {
        /// The longer side.
        size: i32,
        /// The longest side that fits.
        limit: i32,
    },
    /// The box's centre is outside the grid, which refuses such bodies; in raw units.
    OutOfWorld {
        /// The raw x of the centre of the box.
        x: i32,
        /// The raw y of the centre of the box.
        y: i32,
    },
}

impl fmt::Display for BroadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Full { capacity } => {
                write!(f, "all {capacity} slots are taken: remove a body, or raise the capacity")
            }
            Self::Stale(handle) => {
                let (slot, generation) = (handle.slot(), handle.generation());
                write!(f, "body {slot} (generation {generation}) was removed: drop its handle")
            }
            Self::TooLarge { size, limit } => {
                write!(
                    f,
                    "a side of {} is longer than {}: enlarge the cells, or set LARGE",
                    Fx::from_bits(size),
                    Fx::from_bits(limit)
                )
            }
            Self::OutOfWorld { x, y } => {
                write!(
                    f,
                    "a centre at ({}, {}) is outside the grid: use another `Border`",
                    Fx::from_bits(x),
                    Fx::from_bits(y)
                )
            }
        }
    }
}

impl core::error::Error for BroadError {}

/// Why an enumeration of pairs stopped before its end.
///
/// No pair is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PairsError {
    /// The budget of tests is spent: the next call continues from here.
    BudgetExceeded,
    /// The list of pairs is full. Take the pairs out, and the next call continues from here.
    Full,
    /// A body was inserted or moved since the enumeration began: the cursor is at the start again.
    Changed,
}

impl fmt::Display for PairsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::BudgetExceeded => {
                "the budget of tests ended before all pairs were found: call again with the same cursor"
            }
            Self::Full => "the list of pairs is full: take the pairs out, and call again with the same cursor",
            Self::Changed => "bodies were inserted or moved during the enumeration: begin again",
        })
    }
}

impl core::error::Error for PairsError {}

/// Why a query has no answer, or an incomplete one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum QueryError {
    /// An argument is out of range. The buffer is empty.
    Range(RangeError),
    /// The buffer is full of the first results; the rest did not fit.
    Truncated(Truncated),
}

impl From<RangeError> for QueryError {
    fn from(error: RangeError) -> Self {
        Self::Range(error)
    }
}

impl From<Truncated> for QueryError {
    fn from(error: Truncated) -> Self {
        Self::Truncated(error)
    }
}

impl fmt::Display for QueryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(error) => error.fmt(f),
            Self::Truncated(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for QueryError {}

/// Why a grid was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum GridError {
    /// The side of a cell is not a power of two of raw units, from 2 to 2^28.
    Cell {
        /// The side, in raw units.
        side: i32,
    },
    /// The number of columns is not a power of two of at least 4 that divides the number of cells.
    Columns {
        /// The requested columns.
        columns: u16,
        /// The number of cells.
        cells: u16,
    },
    /// The origin is outside the domain.
    Origin(RangeError),
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Cell { side } => {
                // The powers of two on both sides of it, from 2 raw to 2^28.
                let log = side.checked_ilog2().unwrap_or(1).clamp(1, 27);
                let (below, above) = (Fx::from_bits(1 << log), Fx::from_bits(2 << log));
                write!(f, "a cell of {} is not a power of two: use {below} or {above}", Fx::from_bits(side))
            }
            Self::Columns { columns, cells } => {
                let most = 1u32 << cells.trailing_zeros();
                write!(f, "{columns} columns do not fit {} blocks: use a power of two from 4 to {most}", cells >> 5)?;
                match columns >> 5 {
                    blocks if blocks > 1 && columns.is_power_of_two() => {
                        write!(f, ", or a multiple of {blocks} blocks")
                    }
                    _ => Ok(()),
                }
            }
            Self::Origin(error) => write!(f, "the grid's origin: {error}"),
        }
    }
}

impl core::error::Error for GridError {}
