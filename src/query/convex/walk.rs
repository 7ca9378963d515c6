//! The border of A + (-B), side by side: the basis of every query about two convex shapes.
//!
//! A and B overlap if the origin is inside that sum. Its sides are those of A and the reversed
//! sides of B, in the order of their directions. They are merged one at a time, without a list, and
//! parallel sides become one. Per side, one pair of products finds its turn, and one finds on which
//! side the origin is.

use crate::num::{Axis, Raw, SPLIT, Vec2, imul};
use crate::query::cast::moment::along;

/// A shape's corners and radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Core<'a> {
    pub(crate) corners: &'a [Vec2],
    pub(crate) radius: i32,
}

impl Core<'_> {
    pub(crate) fn corner(&self, index: usize) -> Raw {
        self.corners.get(index).map_or(Raw::ZERO, |p| Raw::of(*p))
    }

    /// The index of the next corner, counter-clockwise.
    pub(crate) const fn after(&self, index: usize) -> usize {
        let next = index.wrapping_add(1);
        if next < self.corners.len() { next } else { 0 }
    }

    /// An index below twice the number of corners, as one of a corner.
    pub(crate) const fn wrapped(&self, index: usize) -> usize {
        let count = self.corners.len();
        if index < count { index } else { index.wrapping_sub(count) }
    }

    /// The ends of the part that is nearest to a face with the direction `dir`, in that direction.
    /// They differ if a side is parallel to the face. The shape is where the normal (dir.y, -dir.x)
    /// points.
    ///
    /// Corners are below 2^29 and directions below 2^30: products are below 2^60.
    pub(crate) fn facing(&self, dir: Axis) -> (usize, usize) {
        let out = Axis::new(dir.y, dir.x.wrapping_neg());
        let depth = |i: usize| along(out, self.corner(i));
        let (mut first, mut last, mut least) = (0, 0, depth(0));
        for i in 1..self.corners.len() {
            let here = depth(i);
            if here < least {
                (first, last, least) = (i, i, here);
            } else if here == least {
                let ahead = along(dir, self.corner(i).sub(self.corner(last))) > 0;
                if ahead { last = i } else { first = i }
            }
        }
        (first, last)
    }

    /// The foremost one of the lowest corners, and how far the border is ahead of it, rounded up.
    /// The two directions are across each other.
    pub(crate) fn foot(&self, up: Axis, forward: Axis) -> (Raw, i32) {
        let farthest = |way: Axis| self.facing(way.perp().reversed());
        let (first, last) = farthest(up.reversed());
        let (first, last) = (self.corner(first), self.corner(last));
        let foot = if along(forward, first.sub(last)) > 0 { first } else { last };
        let ahead = self.corner(farthest(forward).0).sub(foot);
        let (x, y) = forward.unit().raw();
        let length = imul(x, ahead.x).wrapping_add(imul(y, ahead.y)) >> 30;
        (foot, (length as i32).wrapping_add(self.radius).wrapping_add(1))
    }

    /// The normal of the side that begins at a corner, into the shape; of length one along x and y.
    pub(crate) fn facing_normal(&self, corner: usize) -> Axis {
        let e = self.corner(self.after(corner)).sub(self.corner(corner));
        if e.x == 0 || e.y == 0 {
            Axis::new(e.y.signum().wrapping_neg(), e.x.signum())
        } else {
            Axis::new(e.y.wrapping_neg(), e.x)
        }
    }

    /// The index of the one before it.
    pub(crate) const fn before(&self, index: usize) -> usize {
        if index == 0 { self.corners.len().saturating_sub(1) } else { index.wrapping_sub(1) }
    }
}

/// A side of the sum, with the sum's inside on its left (y up).
#[derive(Clone, Copy, Debug)]
pub(super) struct PolygonSide {
    /// Its start: a corner of A minus one of B, below 2^30 per component.
    pub(super) from: Raw,
    /// Below 2^30 per component, or 2^31 if both shapes have a part in it.
    pub(super) edge: Raw,
    /// The corners whose difference is `from`. Sides of A or B begin there.
    pub(super) a: usize,
    pub(super) b: usize,
    pub(super) of_a: bool,
    pub(super) of_b: bool,
}

impl PolygonSide {
    /// Twice the area of the side and the origin, positive on the left: below 2^62.
    pub(super) const fn height(&self) -> i64 {
        self.edge.cross(self.from.reversed())
    }

    /// How far along the side the origin's foot is, times its length: below 2^62.
    pub(super) const fn along(&self) -> i64 {
        self.edge.dot(self.from.reversed())
    }

    /// Its square length, below 2^63.
    pub(super) const fn len2(&self) -> u64 {
        self.edge.len2()
    }
}

/// The sides of one shape, reversed for B: `REVERSED` negates all corners.
struct Ring<'a, const REVERSED: bool> {
    core: Core<'a>,
    at: usize,
    left: usize,
    here: Raw,
    edge: Raw,
}

impl<'a, const REVERSED: bool> Ring<'a, REVERSED> {
    /// From the lowest corner, of two the left one: there the first side leads upward or to the
    /// right.
    fn new(core: Core<'a>) -> Self {
        let (mut at, mut here) = (0, Self::place(core, 0));
        for (i, p) in core.corners.iter().enumerate() {
            let p = Self::turned(Raw::of(*p));
            if p.y < here.y || (p.y == here.y && p.x < here.x) {
                (at, here) = (i, p);
            }
        }
        let sides = core.corners.len();
        let mut ring = Self { core, at, left: if sides < 2 { 0 } else { sides }, here, edge: Raw::ZERO };
        ring.edge = ring.next_corner().sub(here);
        ring
    }

    const fn turned(p: Raw) -> Raw {
        if REVERSED { p.reversed() } else { p }
    }

    fn place(core: Core<'_>, index: usize) -> Raw {
        Self::turned(core.corner(index))
    }

    fn next_corner(&self) -> Raw {
        Self::place(self.core, self.core.after(self.at))
    }

    fn step(&mut self) {
        self.at = self.core.after(self.at);
        self.here = self.here.add(self.edge);
        self.edge = self.next_corner().sub(self.here);
        self.left = self.left.wrapping_sub(1);
    }
}

/// All sides of the sum, in order of direction from +x on. A flat sum has two, a point none.
pub(super) struct SideWalk<'a> {
    a: Ring<'a, false>,
    b: Ring<'a, true>,
}

impl<'a> SideWalk<'a> {
    pub(super) fn new(a: Core<'a>, b: Core<'a>) -> Self {
        Self { a: Ring::new(a), b: Ring::new(b) }
    }

    /// The corner of the sum where the walk stands, and the corners of A and B that make it up.
    pub(super) const fn corner(&self) -> Corner {
        Corner { at: self.a.here.add(self.b.here), a: self.a.at, b: self.b.at }
    }
}

impl Iterator for SideWalk<'_> {
    type Item = PolygonSide;

    fn next(&mut self) -> Option<PolygonSide> {
        // Both stand in the same half turn. A ring's next side is less than a half turn beyond its
        // last one, and the other ring's next side is not before that. Only a segment turns by
        // exactly a half, and parallel sides advance together.
        let order = match (self.a.left, self.b.left) {
            (0, 0) => return None,
            (_, 0) => 1,
            (0, _) => -1,
            _ => turn(self.a.edge, self.b.edge),
        };
        let (of_a, of_b) = (order >= 0, order <= 0);
        let Corner { at: from, a, b } = self.corner();
        let mut edge = Raw::ZERO;
        if of_a {
            edge = self.a.edge;
            self.a.step();
        }
        if of_b {
            edge = edge.add(self.b.edge);
            self.b.step();
        }
        Some(PolygonSide { from, edge, a, b, of_a, of_b })
    }
}

/// A corner of the sum: one of A less one of B.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) at: Raw,
    pub(super) a: usize,
    pub(super) b: usize,
}

/// The sign of `e x f`. The components of one vector are below 2^31, those of the other below 2^30.
///
/// For cores on which a product is a call: if two products have different signs, the larger one is
/// known without computing them.
#[inline]
pub(super) const fn turn(e: Raw, f: Raw) -> i64 {
    if SPLIT {
        let (p, q) = (e.x.signum() * f.y.signum(), e.y.signum() * f.x.signum());
        if p != q || p == 0 {
            return (p - q) as i64;
        }
    }
    e.cross(f)
}
