//! Cuts a simple polygon into convex parts.
//!
//! One part after the other is cut off along a diagonal between two corners. A part starts with an
//! ear, and grows by the triangles beside it as long as it stays convex. No new corner is made, so
//! nothing is rounded. Differences are below 2^30 and turns below 2^61.

use super::ConvexPolygon;
use crate::error::RangeError;
use crate::num::{Raw, Vec2, check_coordinate};
use core::fmt;

/// The most corners of a polygon that is cut: the size of the working list, 1 KB of stack.
const MOST: usize = 128;

/// Masks an index of the list, which shows the compiler that it is in bounds.
const INDEX: usize = MOST - 1;

/// Why a polygon could not be cut into convex parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PartsError {
    /// There are fewer than three corners.
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// There are more corners than [`ConvexParts::MOST`].
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// A corner is outside the domain.
    Range {
        /// Which one, counted from zero.
        at: usize,
        /// The fault of the corner.
        error: RangeError,
    },
    /// Two sides have a point in common that is not the corner between them.
    Crosses {
        /// The first side, counted from zero by the corner where it begins.
        at: usize,
        /// The second side.
        other: usize,
    },
    /// The polygon needs more parts than the result can hold, or a part cannot hold three corners.
    NoRoom {
        /// How many parts the result can hold.
        capacity: usize,
    },
}

impl fmt::Display for PartsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { count } => write!(f, "the polygon has {count} corners, but needs at least three"),
            Self::TooMany { count } => {
                write!(f, "the polygon has {count} corners, but at most {MOST} can be cut: simplify it")
            }
            Self::Range { at, error } => write!(f, "corner {at}: {error}"),
            Self::Crosses { at, other } => {
                write!(f, "side {at} meets side {other}: draw sides that meet only at corners")
            }
            Self::NoRoom { capacity } => {
                write!(f, "the polygon needs more than {capacity} convex parts: raise the capacity")
            }
        }
    }
}

impl core::error::Error for PartsError {}

/// A simple polygon, cut into at most `M` convex parts of at most `N` corners each.
///
/// The parts cover the polygon exactly and share only borders. Their corners are corners of the
/// polygon, so nothing is rounded. There may be more parts than necessary.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Circle, Vec2, fx, shape::ConvexParts};
/// // An L of two arms, cut by the compiler.
/// const CORNERS: [Vec2; 6] = [
///     Vec2::from_ints(0, 0),
///     Vec2::from_ints(30, 0),
///     Vec2::from_ints(30, 10),
///     Vec2::from_ints(10, 10),
///     Vec2::from_ints(10, 30),
///     Vec2::from_ints(0, 30),
/// ];
/// const L: ConvexParts<4, 4> = match ConvexParts::of(&CORNERS) {
///     Ok(parts) => parts,
///     Err(_) => panic!("no two sides cross"),
/// };
/// let hits = |x, y| L.parts().iter().any(|part| part.contains(&Vec2::from_ints(x, y)));
/// assert!(hits(25, 5) && hits(5, 25) && !hits(20, 20));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("triangulate", "decomposition"))]
pub struct ConvexParts<const N: usize, const M: usize> {
    parts: [ConvexPolygon<N>; M],
    count: usize,
}

impl<const N: usize, const M: usize> ConvexParts<N, M> {
    /// The most corners of a polygon that is cut.
    pub const MOST: usize = MOST;

    /// Cuts a polygon, given by its corners in order, clockwise or counter-clockwise.
    ///
    /// Corners on one line with their neighbours are left out. Cost: up to `n^2 N` tests of a point
    /// and a triangle per part, for `n` corners. Use it in constants or while you load a level.
    ///
    /// # Errors
    /// [`PartsError`]: fewer than three corners or more than [`MOST`](Self::MOST), one outside of
    /// the [domain](crate::num::DOMAIN), sides that meet, or more parts than the result can hold.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loops, and by the comparison with M")]
    pub const fn of(corners: &[Vec2]) -> Result<Self, PartsError> {
        let mut rest = match RestOfPolygon::of(corners) {
            Ok(rest) => rest,
            Err(e) => return Err(e),
        };
        let mut all = Self { parts: [ConvexPolygon::EMPTY; M], count: 0 };
        while rest.count > 2 {
            let (mut from, mut most, mut ends, mut i) = (0, 0, 0, 0);
            while i < rest.count {
                let length = rest.chain(i, N);
                // On a tie, the one that cuts the most inward corners open.
                let inward = rest.is_inward(i) as u8 + rest.is_inward(i + length - 1) as u8;
                if length > most || (length == most && inward > ends) {
                    (from, most, ends) = (i, length, inward);
                }
                i += 1;
            }
            // Every simple polygon has an ear: only `N` can be too small.
            if most < 3 || all.count >= M {
                return Err(PartsError::NoRoom { capacity: M });
            }
            let (mut points, mut k) = ([Vec2::ZERO; N], 0);
            while k < most && k < N {
                points[k] = rest.at(from + k).vec2();
                k += 1;
            }
            all.parts[all.count] = match ConvexPolygon::new(points.split_at(if most < N { most } else { N }).0) {
                Ok(part) => part,
                Err(_) => return Err(PartsError::NoRoom { capacity: M }),
            };
            all.count += 1;
            rest.cut(from, most);
        }
        Ok(all)
    }

    /// The parts.
    #[must_use]
    pub const fn parts(&self) -> &[ConvexPolygon<N>] {
        self.parts.split_at(if self.count < M { self.count } else { M }).0
    }
}

/// The rest of a polygon: simple, counter-clockwise (y up), without corners on a line with their
/// neighbours.
struct RestOfPolygon {
    points: [Raw; MOST],
    count: usize,
}

#[expect(clippy::indexing_slicing, reason = "indices are remainders of the count, which is at most MOST")]
impl RestOfPolygon {
    const fn of(corners: &[Vec2]) -> Result<Self, PartsError> {
        let n = corners.len();
        if n < 3 {
            return Err(PartsError::TooFew { count: n });
        }
        if n > MOST {
            return Err(PartsError::TooMany { count: n });
        }
        let (mut rest, mut at, mut lowest) = (Self { points: [Raw::ZERO; MOST], count: n }, 0, 0);
        let mut low = Raw::of(corners[0]);
        while at < n {
            if let Err(error) = check_coordinate(corners[at]) {
                return Err(PartsError::Range { at, error });
            }
            let p = Raw::of(corners[at]);
            if p.y < low.y || (p.y == low.y && p.x < low.x) {
                (lowest, low) = (at, p);
            }
            rest.points[at & INDEX] = p;
            at += 1;
        }
        if let Err(e) = rest.check_simple() {
            return Err(e);
        }
        // At the lowest corner (on a tie the left one), the inside is between the sides.
        if rest.turn(lowest + n - 1, lowest, lowest + 1) < 0 {
            let mut i = 0;
            while i < n {
                rest.points[(n - 1 - i) & INDEX] = Raw::of(corners[i]);
                i += 1;
            }
        }
        rest.straighten();
        Ok(rest)
    }

    const fn at(&self, index: usize) -> Raw {
        let count = if self.count == 0 { 1 } else { self.count };
        self.points[(index % count) & INDEX]
    }

    /// The sign of the turn at `j`.
    const fn turn(&self, i: usize, j: usize, k: usize) -> i64 {
        turn(self.at(i), self.at(j), self.at(k))
    }

    const fn is_inward(&self, j: usize) -> bool {
        self.turn(j + self.count - 1, j, j + 1) < 0
    }

    const fn check_simple(&self) -> Result<(), PartsError> {
        let (n, mut at) = (self.count, 0);
        while at < n {
            let mut other = at + 1;
            while other < n {
                let (a, b, c, d) = (self.at(at), self.at(at + 1), self.at(other), self.at(other + 1));
                let crosses = if other == at + 1 {
                    returns(a, b, d)
                } else if at == 0 && other == n - 1 {
                    returns(c, a, b)
                } else {
                    meet(a, b, c, d)
                };
                // A side of length zero is a point of the next side.
                if crosses || a.sub(b).is_zero() || c.sub(d).is_zero() {
                    return Err(PartsError::Crosses { at, other });
                }
                other += 1;
            }
            at += 1;
        }
        Ok(())
    }

    /// Leaves out corners without a turn.
    const fn straighten(&mut self) {
        let (mut kept, mut i, n) = (0, 0, self.count);
        let before = self.points;
        while i < n {
            let (i0, i1, i2) = ((i + n - 1) % n, i, (i + 1) % n);
            let (p, q, r) = (before[i0 & INDEX], before[i1 & INDEX], before[i2 & INDEX]);
            if turn(p, q, r) != 0 {
                self.points[kept & INDEX] = q;
                kept += 1;
            }
            i += 1;
        }
        self.count = kept;
    }

    /// How many corners from `first` on are a convex part that can be cut off; below 3 none are.
    ///
    /// A further corner adds a triangle on the diagonal: an ear of what would be left, where none
    /// of its other corners is in it.
    const fn chain(&self, first: usize, most: usize) -> usize {
        let mut length = 2;
        while length < self.count && length < most {
            let (last, next) = (first + length - 1, first + length);
            if self.turn(last - 1, last, next) <= 0
                || self.turn(last, next, first) <= 0
                || self.turn(next, first, first + 1) <= 0
            {
                break;
            }
            let (a, b, c, mut k) = (self.at(first), self.at(last), self.at(next), length + 1);
            while k < self.count {
                let p = self.at(first + k);
                if turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 {
                    return length;
                }
                k += 1;
            }
            length += 1;
        }
        length
    }

    /// Removes what a part has of the border: all its corners but the first and the last.
    const fn cut(&mut self, first: usize, length: usize) {
        let (left, mut points, mut k) = (self.count + 2 - length, [Raw::ZERO; MOST], 0);
        while k < left {
            points[k & INDEX] = self.at(first + length - 1 + k);
            k += 1;
        }
        (self.points, self.count) = (points, left);
        if left > 2 {
            self.straighten();
        }
    }
}

const fn turn(p: Raw, q: Raw, r: Raw) -> i64 {
    q.sub(p).cross(r.sub(q)).signum()
}

/// Whether the way from `b` to `c` leads back over that from `a` to `b`.
const fn returns(a: Raw, b: Raw, c: Raw) -> bool {
    turn(a, b, c) == 0 && b.sub(a).dot(c.sub(b)) < 0
}

/// Whether two segments have a point in common.
const fn meet(a: Raw, b: Raw, c: Raw, d: Raw) -> bool {
    let (s, t, u, v) = (turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b));
    (s != t && u != v && s * t <= 0 && u * v <= 0)
        || (s == 0 && holds(a, b, c))
        || (t == 0 && holds(a, b, d))
        || (u == 0 && holds(c, d, a))
        || (v == 0 && holds(c, d, b))
}

/// Whether the bounding box of two points holds a third one, which is on their line.
const fn holds(a: Raw, b: Raw, p: Raw) -> bool {
    p.sub(a).dot(p.sub(b)) <= 0
}
