//! The part of two parallel sides that face each other.

use super::walk::{Core, PolygonSide};
use crate::num::Raw;
use crate::query::closest::on_segment;

/// A side of a shape, counter-clockwise.
pub(super) fn face(core: Core<'_>, index: usize) -> (Raw, Raw) {
    (core.corner(index), core.corner(core.after(index)))
}

pub(super) const fn precedes(p: Raw, q: Raw) -> bool {
    p.x < q.x || (p.x == q.x && p.y < q.y)
}

/// The lexicographically first one.
const fn first(p: Raw, q: Raw) -> Raw {
    if precedes(q, p) { q } else { p }
}

/// A corner of A or of B.
#[derive(Clone, Copy)]
pub(super) struct End {
    pub(super) at: Raw,
    pub(super) on_a: bool,
    /// Whether the other shape has a corner opposite to it.
    pub(super) paired: bool,
}

/// The facing parts of a side of A and one of B that make up a side of the sum.
pub(super) struct Facing {
    pub(super) a: (Raw, Raw),
    pub(super) b: (Raw, Raw),
    /// Its start and its end.
    pub(super) ends: (End, End),
}

impl Facing {
    pub(super) fn of(side: &PolygonSide, a: Core<'_>, b: Core<'_>) -> Self {
        // Along the side of the sum, A's side runs forward and B's back.
        let (a, b) = (face(a, side.a), face(b, side.b));
        let inner = |p: Raw, q: Raw, way: Raw| match way.dot(p.sub(q)) {
            // If they are opposite, the first one wins, whichever shape is A.
            0 => End { at: first(p, q), on_a: !precedes(q, p), paired: true },
            ahead => End { at: if ahead < 0 { q } else { p }, on_a: ahead > 0, paired: false },
        };
        Self { a, b, ends: (inner(a.0, b.1, side.edge), inner(a.1, b.0, side.edge.reversed())) }
    }

    /// The middle on one of the two sides, and whether that is A's: exact along x and y, else
    /// within a raw unit.
    ///
    /// Which side it is on and half a unit are settled by geometry, so that exchanging the shapes
    /// changes nothing.
    pub(super) fn middle(&self) -> (Raw, bool) {
        let on_a = !precedes(first(self.b.0, self.b.1), first(self.a.0, self.a.1));
        let (p, q) = if on_a { self.a } else { self.b };
        let (from, to) = (on_segment(self.ends.0.at, p, q), on_segment(self.ends.1.at, p, q));
        // Sums of coordinates are below 2^30.
        (Raw { x: from.x.wrapping_add(to.x) >> 1, y: from.y.wrapping_add(to.y) >> 1 }, on_a)
    }

    /// The end that comes first lexicographically, a corner of either shape.
    pub(super) const fn first_end(&self) -> Raw {
        first(self.ends.0.at, self.ends.1.at)
    }
}
