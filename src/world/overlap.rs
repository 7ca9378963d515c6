//! Overlap with the solid of a map (strict) and touch (closed), straight from the cells.

use super::range::Range;
use super::{Set, Store, TileMap};
use crate::num::Raw;
use crate::query::{Overlaps, Touches, meet};
use crate::shape::{Aabb, Circle};

impl<S: Set, T: Store> TileMap<'_, S, T> {
    /// Whether a box or circle overlaps the solid: whether it reaches the inside of the union of all full cells.
    ///
    /// Strict and exact: a body that touches a wall or fills a gap exactly does not overlap. A body without area (a circle of radius 0, a
    /// box of no width or height) overlaps where it meets the inside of the union, so also on the line between two full cells.
    /// One-way tiles are never overlapped. What is [`Outside`](super::Outside) counts.
    ///
    /// Cost: the cells that the body's bounding box overlaps, one look-up each, until the first hit; a circle adds its test against
    /// each full one. It cannot fail.
    ///
    /// ```
    /// use tilesat::{Aabb, Circle, Fx, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("#..\n...", &KINDS)?;
    /// let ball = |x, y| Circle::new(Vec2::from_ints(x, y), Fx::from_num(5)).unwrap();
    /// assert!(!map.overlaps(&ball(19, 20))); // 3-4-5: touches the corner at (16, 16)
    /// assert!(map.touches(&ball(19, 20)));
    /// assert!(map.overlaps(&ball(19, 19)));
    /// let gap = Aabb::new(Vec2::from_ints(16, 0), Vec2::from_ints(48, 16)).unwrap();
    /// assert!(!map.overlaps(&gap) && map.touches(&gap));
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn overlaps<B>(&self, body: &B) -> bool
    where
        Self: Overlaps<B>,
    {
        Overlaps::overlaps(self, body)
    }

    /// Whether a box or circle has a point in common with the solid, borders included.
    ///
    /// Exact. One-way tiles are not solid; what is [`Outside`](super::Outside) counts. Cost: as [`overlaps`](Self::overlaps), one more cell on each side that
    /// lies on a cell's border.
    #[inline]
    #[must_use]
    pub fn touches<B>(&self, body: &B) -> bool
    where
        Self: Touches<B>,
    {
        Touches::touches(self, body)
    }

    const fn box_overlaps(&self, lo: Raw, hi: Raw) -> bool {
        let mut range = self.open_range(lo, hi);
        // A side of no length on a cell's border is inside the solid only where the cells on both sides are full: then the open range is
        // reversed, and starts at the first of the two.
        let (mut pair_x, mut pair_y) = (0, 0);
        if lo.x == hi.x {
            pair_x = range.x0.wrapping_sub(range.x1);
            range.x0 = range.x1;
        }
        if lo.y == hi.y {
            pair_y = range.y0.wrapping_sub(range.y1);
            range.y0 = range.y1;
        }
        if pair_x == 0 && pair_y == 0 {
            return self.any_full(self.solid_range(range));
        }
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                if self.full(x, y)
                    && self.full(x.wrapping_add(pair_x), y)
                    && self.full(x, y.wrapping_add(pair_y))
                    && self.full(x.wrapping_add(pair_x), y.wrapping_add(pair_y))
                {
                    return true;
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        false
    }

    const fn any_full(&self, range: Range) -> bool {
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                if self.full(x, y) {
                    return true;
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        false
    }

    const fn circle_meets<const CLOSED: bool>(&self, c: Raw, r: i32, range: Range) -> bool {
        let range = self.solid_range(range);
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                if self.full(x, y) {
                    let (lo, hi) = self.extent(x, y);
                    if meet::circle_aabb::<CLOSED>(c, r, lo, hi) {
                        return true;
                    }
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        false
    }
}

impl<S: Set, T: Store> Overlaps<Aabb> for TileMap<'_, S, T> {
    fn overlaps(&self, b: &Aabb) -> bool {
        self.box_overlaps(b.lo(), b.hi())
    }
}

impl<S: Set, T: Store> Overlaps<Circle> for TileMap<'_, S, T> {
    fn overlaps(&self, b: &Circle) -> bool {
        let (c, r) = (b.c(), b.r());
        if r == 0 {
            return self.box_overlaps(c, c);
        }
        let bounds = b.aabb();
        self.circle_meets::<false>(c, r, self.open_range(bounds.lo(), bounds.hi()))
    }
}

impl<S: Set, T: Store> Touches<Aabb> for TileMap<'_, S, T> {
    fn touches(&self, b: &Aabb) -> bool {
        self.any_full(self.solid_range(self.closed_range(b.lo(), b.hi())))
    }
}

impl<S: Set, T: Store> Touches<Circle> for TileMap<'_, S, T> {
    fn touches(&self, b: &Circle) -> bool {
        let bounds = b.aabb();
        self.circle_meets::<true>(b.c(), b.r(), self.closed_range(bounds.lo(), bounds.hi()))
    }
}
