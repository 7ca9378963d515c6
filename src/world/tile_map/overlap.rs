//! Overlap with the solid of a map (strict) and touch (closed), straight from the cells.

use super::range::Range;
use super::solid::Solid;
use crate::num::Raw;
use crate::query::{Overlaps, Touches, meet};
use crate::shape::{Aabb, Circle};
use crate::world::shells::levels;
use crate::world::{Set, Store, TileMap, TileShape};

levels! {
    [S: Set, T: Store] TileMap<'_, S, T> {
        /// Whether a box or circle overlaps the solid: whether it reaches the inside of the union of all tiles' solids.
        ///
        /// Strict and exact, for slopes and arcs too, and without a root: a body that touches a wall or fills a gap exactly does not overlap. A
        /// body without area (a circle of radius 0, a box of no width or height) overlaps where it meets the inside of the union, so also on
        /// the line between two full cells. One-way tiles are never overlapped. What is [`Outside`](crate::world::Outside) counts.
        ///
        /// Cost: the cells that the body's bounding box overlaps, one look-up each, until the first hit; a circle adds its test against
        /// each that is solid, a box against each that is partly so. A ball of 10 units over cells of 24, of which a quarter hold a shape, takes
        /// some 570 instructions on a Cortex-M0. It cannot fail.
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
        overlaps,
        /// Whether a box or circle has a point in common with the solid, borders included.
        ///
        /// Exact. One-way tiles are not solid; what is [`Outside`](crate::world::Outside) counts. Cost: as [`overlaps`](Self::overlaps), one more cell on each side that
        /// lies on a cell's border.
        touches,
    }
}

impl<S: Set, T: Store> TileMap<'_, S, T> {
    fn box_overlaps(&self, lo: Raw, hi: Raw) -> bool {
        if S::SHAPED {
            if lo.x == hi.x || lo.y == hi.y {
                return self.thin_overlaps(lo, hi);
            }
            return self.any_solid(self.open_range(lo, hi), |solid| solid.meets_box::<S, false>(lo, hi));
        }
        self.box_overlaps_blocks(lo, hi)
    }

    const fn box_overlaps_blocks(&self, lo: Raw, hi: Raw) -> bool {
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

    fn circle_meets<const CLOSED: bool>(&self, c: Raw, r: i32, range: Range) -> bool {
        if S::SHAPED {
            return self.any_solid(range, |solid| solid.meets_circle::<S, CLOSED>(c, r));
        }
        self.circle_meets_blocks::<CLOSED>(c, r, range)
    }

    const fn circle_meets_blocks<const CLOSED: bool>(&self, c: Raw, r: i32, range: Range) -> bool {
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

    /// Whether the solid of any cell of a range passes a test.
    #[inline]
    fn any_solid(&self, range: Range, test: impl Fn(&Solid) -> bool) -> bool {
        let mut walk = self.walk_of(self.solid_range(range), Range::NONE);
        while self.walk(&mut walk) {
            if test(&Solid::new(walk.kind.shape.form(), self.corners(&walk), self.grid.cell >> 1)) {
                return true;
            }
        }
        false
    }

    const fn solid(&self, shape: TileShape, x: i32, y: i32) -> Solid {
        Solid::new(shape.form(), self.extent(x, y), self.grid.cell >> 1)
    }

    /// Whether a box without area meets the inside of the union, among all shapes.
    ///
    /// A point is inside of the union where the forms of all closed cells that hold it do so strictly: then each covers its part of the
    /// surroundings, and where one does not, a part of its cell near the point is in no solid. What a form covers of a side of its cell ends at
    /// the side's ends or its middle: of a half side that is cut off where a segment ends, two cells cover a common part if each
    /// covers any.
    #[inline(never)]
    fn thin_overlaps(&self, lo: Raw, hi: Raw) -> bool {
        let around = self.closed_range(lo, hi);
        if lo == hi {
            return self.all_hold(around, lo, hi);
        }
        let (open, along_x, half) = (self.open_range(lo, hi), lo.y == hi.y, self.grid.cell >> 1);
        let (mut i, last) = if along_x { (open.x0, open.x1) } else { (open.y0, open.y1) };
        while i <= last {
            let cells = if along_x { Range { x0: i, x1: i, ..around } } else { Range { y0: i, y1: i, ..around } };
            // Beyond the map no form ends along the border: the middle may be anywhere.
            let middle = self.grid.line(i).wrapping_add(half);
            let (before, after, end) = if along_x {
                let x = self.grid.x.origin.wrapping_add(middle);
                (lo.x < x, x < hi.x, Raw { x, y: lo.y })
            } else {
                let y = self.grid.y.origin.wrapping_add(middle);
                (lo.y < y, y < hi.y, Raw { x: lo.x, y })
            };
            // Cells take from a half what lies in them. Where nothing of it is left it is not asked for.
            if (before && self.all_hold(cells, lo, if after { end } else { hi }))
                || (after && self.all_hold(cells, if before { end } else { lo }, hi))
            {
                return true;
            }
            i = i.wrapping_add(1);
        }
        false
    }

    /// Whether the forms of all cells of a range hold strictly somewhere in a box.
    fn all_hold(&self, range: Range, lo: Raw, hi: Raw) -> bool {
        let mut y = range.y0;
        while y <= range.y1 {
            let mut x = range.x0;
            while x <= range.x1 {
                if !self.solid(self.kind_at(x, y).shape, x, y).meets_box::<S, false>(lo, hi) {
                    return false;
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        true
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
            return if S::SHAPED {
                self.all_hold(self.closed_range(c, c), c, c)
            } else {
                self.box_overlaps_blocks(c, c)
            };
        }
        let bounds = b.aabb();
        self.circle_meets::<false>(c, r, self.open_range(bounds.lo(), bounds.hi()))
    }
}

impl<S: Set, T: Store> Touches<Aabb> for TileMap<'_, S, T> {
    fn touches(&self, b: &Aabb) -> bool {
        let (lo, hi) = (b.lo(), b.hi());
        let range = self.closed_range(lo, hi);
        if S::SHAPED {
            return self.any_solid(range, |solid| solid.meets_box::<S, true>(lo, hi));
        }
        self.any_full(self.solid_range(range))
    }
}

impl<S: Set, T: Store> Touches<Circle> for TileMap<'_, S, T> {
    fn touches(&self, b: &Circle) -> bool {
        let bounds = b.aabb();
        self.circle_meets::<true>(b.c(), b.r(), self.closed_range(bounds.lo(), bounds.hi()))
    }
}
