//! Overlap with the solid of a map (strict) and touch (closed), straight from the cells.
//!
//! One tile's solid meets a body by the inequality of its [`Form`], in the frame of its solid
//! corner.

use super::outline::{Form, FormKind};
use super::{ShapeSet, Store, TileMap};
use crate::num::{LONG, Raw, usqr};
use crate::query::meet::{gap, in_disc};
use crate::query::{Overlaps, Touches, meet};
use crate::shape::{Aabb, Circle};
use crate::world::cell::{Cells, Range};
use crate::world::level::{World, levels};

levels! {
    [S: ShapeSet, T: Store] TileMap<'_, S, T> {
        /// Whether a shape overlaps the solid, that is, reaches the inside of the union of all
        /// tiles' solids.
        ///
        /// It takes boxes, circles, [`Capsule`](crate::Capsule),
        /// [`OrientedBox`](crate::OrientedBox) and [`ConvexPolygon`](crate::ConvexPolygon).
        ///
        /// The test is strict and exact, also for slopes and arcs, and needs no root. A body that
        /// touches a wall or fills a gap exactly does not overlap. A body without area is a circle
        /// of radius 0, or a box without width or height. It overlaps if it meets the inside of the
        /// union, also on the line between two full cells. One-way tiles never overlap anything.
        /// [`Outside`](crate::world::Outside) counts.
        ///
        /// Cost: one look-up for each cell that the body's bounding box overlaps, until the first
        /// hit. A circle adds a test against each solid cell, and a box against each partly solid
        /// one. A ball of 10 units over cells of 24, of which a quarter hold a shape, takes some
        /// 570 instructions on a Cortex-M0. It cannot fail.
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
        /// Whether a shape has a point in common with the solid, borders included.
        ///
        /// The test is exact. One-way tiles are not solid; [`Outside`](crate::world::Outside)
        /// counts. Cost: as [`overlaps`](Self::overlaps), and one more cell on each side that lies
        /// on a cell's border.
        touches,
    }
}

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    fn box_overlaps(&self, lo: Raw, hi: Raw) -> bool {
        if S::SHAPED {
            if lo.x == hi.x || lo.y == hi.y {
                return self.thin_overlaps(lo, hi);
            }
            return self.any_solid(self.solid_range_of(lo, hi), |solid| solid.meets_box::<S, false>(lo, hi));
        }
        self.box_overlaps_blocks(lo, hi)
    }

    fn box_overlaps_blocks(&self, lo: Raw, hi: Raw) -> bool {
        if lo.x == hi.x || lo.y == hi.y {
            return self.thin_overlaps_blocks(lo, hi);
        }
        self.has_full(self.solid_range_of(lo, hi))
    }

    fn circle_meets<const CLOSED: bool>(&self, c: Raw, r: i32, range: Range) -> bool {
        if S::SHAPED {
            return self.any_solid(range, |solid| solid.meets_circle::<S, CLOSED>(c, r));
        }
        self.any_full(range, |(lo, hi)| meet::circle_aabb::<CLOSED>(c, r, lo, hi))
    }

    /// Whether the solid of any cell of a range passes a test.
    #[inline]
    pub(super) fn any_solid(&self, range: Range, test: impl Fn(&TileSolid) -> bool) -> bool {
        let mut cells = Cells::of(range);
        while let Some(block) = self.next_cell(&mut cells) {
            if test(&TileSolid::new(block.kind.shape.form(), World::corners(self, &block), self.grid.cell >> 1)) {
                return true;
            }
        }
        false
    }

    /// Whether a box without area meets the inside of the union, among all shapes.
    ///
    /// A point is inside of the union where the forms of all closed cells that hold it do so
    /// strictly. Then each form covers its part of the surroundings. Where one does not, a part of
    /// its cell near the point is in no solid. What a form covers of a side of its cell ends at the
    /// side's ends or its middle. So of a half side that is cut off where a segment ends, two cells
    /// cover a common part if each covers any.
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
            // Beyond the map no form ends along the border, so the middle can be anywhere.
            let middle = self.grid.line(i).wrapping_add(half);
            let (before, after, end) = if along_x {
                let x = self.grid.x.origin.wrapping_add(middle);
                (lo.x < x, x < hi.x, Raw { x, y: lo.y })
            } else {
                let y = self.grid.y.origin.wrapping_add(middle);
                (lo.y < y, y < hi.y, Raw { x: lo.x, y })
            };
            // Cells take only the part of a half that lies in them. Without such a part, the half
            // is not tested.
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
                let form = self.kind_at(x, y).shape.form();
                if !TileSolid::new(form, self.extent(x, y), self.grid.cell >> 1).meets_box::<S, false>(lo, hi) {
                    return false;
                }
                x = x.wrapping_add(1);
            }
            y = y.wrapping_add(1);
        }
        true
    }
}

impl<S: ShapeSet, T: Store> Overlaps<Aabb> for TileMap<'_, S, T> {
    fn overlaps(&self, b: &Aabb) -> bool {
        self.box_overlaps(b.lo(), b.hi())
    }
}

impl<S: ShapeSet, T: Store> Overlaps<Circle> for TileMap<'_, S, T> {
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
        let (lo, hi) = (bounds.lo(), bounds.hi());
        // Without a second look whether the range is in the map: a tenth fewer instructions.
        if LONG && !S::SHAPED {
            if let Some(range) = self.range_inside(lo, hi) {
                return self.any_full_square(range, |(lo, hi)| meet::circle_aabb::<false>(c, r, lo, hi));
            }
        }
        self.circle_meets::<false>(c, r, self.solid_range_of(lo, hi))
    }
}

impl<S: ShapeSet, T: Store> Touches<Aabb> for TileMap<'_, S, T> {
    fn touches(&self, b: &Aabb) -> bool {
        let (lo, hi) = (b.lo(), b.hi());
        let range = self.solid_range(self.closed_range(lo, hi));
        if S::SHAPED {
            return self.any_solid(range, |solid| solid.meets_box::<S, true>(lo, hi));
        }
        self.has_full(range)
    }
}

impl<S: ShapeSet, T: Store> Touches<Circle> for TileMap<'_, S, T> {
    fn touches(&self, b: &Circle) -> bool {
        let bounds = b.aabb();
        self.circle_meets::<true>(b.c(), b.r(), self.solid_range(self.closed_range(bounds.lo(), bounds.hi())))
    }
}

/// The solid of a cell that is not empty, where it lies.
///
/// Cells beyond the map reach to the end of the domain. They are whole, or halved along the map's
/// border, so nothing else here sees a cell that is not square. Sides are at most 2^24, coordinates
/// relative to a square cell in reach of a body below 2^29 + 2^24.
#[derive(Clone, Copy)]
pub(in crate::world) struct TileSolid {
    form: Form,
    lo: Raw,
    hi: Raw,
    /// Half the side of a cell.
    half: i32,
}

const ZERO: Raw = Raw { x: 0, y: 0 };

impl TileSolid {
    pub(in crate::world) const fn new(form: Form, (lo, hi): (Raw, Raw), half: i32) -> Self {
        Self { form, lo, hi, half }
    }

    /// The form, the extent and half a cell.
    pub(super) const fn parts(&self) -> (Form, (Raw, Raw), i32) {
        (self.form, (self.lo, self.hi), self.half)
    }

    const fn side(&self) -> i32 {
        self.half << 1
    }

    /// A box in the frame of the solid corner, by its corner nearest to that.
    const fn near(&self, lo: Raw, hi: Raw) -> Raw {
        Raw {
            x: if self.form.right { self.hi.x.wrapping_sub(hi.x) } else { lo.x.wrapping_sub(self.lo.x) },
            y: if self.form.bottom { self.hi.y.wrapping_sub(hi.y) } else { lo.y.wrapping_sub(self.lo.y) },
        }
    }

    /// Whether a box that has a point in the closed cell has one in the solid. The sets are closed,
    /// or they are open and a part of the box with area is in the open cell.
    ///
    /// The form is monotone: if any point of the common box is solid, the one nearest to the corner
    /// is. Where that one holds strictly, so do the points of the common box near it, and these
    /// have an inside if the box has.
    pub(in crate::world) const fn meets_box<S: ShapeSet, const CLOSED: bool>(&self, lo: Raw, hi: Raw) -> bool {
        let near = self.near(lo, hi);
        let (u, v) = (if near.x > 0 { near.x } else { 0 }, if near.y > 0 { near.y } else { 0 });
        match self.form.kind {
            FormKind::Empty => false,
            FormKind::Line { p, q, k } => {
                let (value, limit) = (plus(p as i32 * u, q as i32 * v), k as i32 * self.half);
                value < limit || (CLOSED && value == limit)
            }
            FormKind::Convex if S::ARCS => reaches(u as u32, v as u32, self.side(), CLOSED),
            FormKind::Concave if S::ARCS => {
                let side = self.side();
                !reaches(side.wrapping_sub(u).unsigned_abs(), side.wrapping_sub(v).unsigned_abs(), side, !CLOSED)
            }
            _ => true,
        }
    }

    /// Whether a circle overlaps the solid (its radius is not 0 then), or touches it.
    ///
    /// Each test compares a radius with the distance to the solid. A solid is the closure of its
    /// inside. So an open disc meets the inside where its centre is nearer than the radius.
    pub(in crate::world) const fn meets_circle<S: ShapeSet, const CLOSED: bool>(&self, c: Raw, r: i32) -> bool {
        let (m, side) = (self.near(c, c), self.side());
        // The box around the solid. It is the whole solid unless the code below adds to it.
        let mut size = self.hi.sub(self.lo);
        match self.form.kind {
            FormKind::Empty => return false,
            FormKind::Line { p: 0, .. } => size.y = self.half,
            FormKind::Line { q: 0, .. } => size.x = self.half,
            FormKind::Line { p, q, k } => {
                let mut at = ZERO;
                if k == 4 {
                    // The half of the cell on the side where it is whole, and the smaller slope on
                    // top of it.
                    if p < q {
                        (size.y, at.y) = (self.half, self.half);
                    } else {
                        (size.x, at.x) = (self.half, self.half);
                    }
                }
                if triangle(m.sub(at), r, p, q, side, CLOSED) {
                    return true;
                } else if k != 4 {
                    return false;
                }
            }
            // Beside the quadrant the nearest point of the cell is on its two straight sides, which
            // are the solid's.
            FormKind::Convex if S::ARCS && m.x >= 0 && m.y >= 0 => {
                return reaches(m.x as u32, m.y as u32, side.wrapping_add(r), CLOSED);
            }
            FormKind::Concave if S::ARCS => {
                if let Some(answer) = concave(m, r, side, CLOSED) {
                    return answer;
                }
            }
            _ => {}
        }
        reaches(beyond(m.x, size.x), beyond(m.y, size.y), r, CLOSED)
    }
}

/// Whether a point is in a disc around the origin, its rim included where `closed`.
#[inline(never)]
const fn reaches(x: u32, y: u32, r: i32, closed: bool) -> bool {
    if closed { in_disc::<true>(x, y, r as u32) } else { in_disc::<false>(x, y, r as u32) }
}

/// How far a coordinate is beyond the interval from 0 on.
const fn beyond(c: i32, size: i32) -> u32 {
    let gap = gap(c, 0, size);
    if gap < 0 { 0 } else { gap as u32 }
}

/// For operands of which one is 0 or both are below 2^30.
const fn plus(a: i32, b: i32) -> i32 {
    a.wrapping_add(b)
}

/// A circle against the triangle `p u + q v <= side`, for p and q of 1 and 2.
///
/// ```text
///     +---a----     From on or behind the hypotenuse's line the nearest point of the
///     |######/ '    bounding box is in the triangle: it lies not beyond the line either.
///     b###/   '     From before the line the nearest point is on the hypotenuse.
///     |/
/// ```
///
/// Beside the box only centres within `r` are left: |u|, |v| < 2^29 + 2^24, so the sums are below 3
/// (2^29 + 2^24) < 2^31.
#[inline(never)]
const fn triangle(m: Raw, r: i32, p: u8, q: u8, side: i32, closed: bool) -> bool {
    let (a, b) = (side >> (p >> 1), side >> (q >> 1));
    let (gu, gv) = (beyond(m.x, a), beyond(m.y, b));
    if gu > r as u32 || gv > r as u32 {
        return false;
    }
    let (p, q) = (p as i32, q as i32);
    let front = plus(p * m.x, q * m.y).wrapping_sub(side);
    // The foot's place along the direction (q, -p), from the end (0, b) to the end (a, 0).
    let along = (q * m.x).wrapping_sub(p * m.y.wrapping_sub(b));
    let (x, y) = if front <= 0 {
        (gu, gv)
    } else if along <= 0 {
        (m.x.unsigned_abs(), m.y.abs_diff(b))
    } else if along >= plus(q * a, p * b) {
        (m.x.abs_diff(a), m.y.unsigned_abs())
    } else {
        // p^2 + q^2 is 2 or 5.
        let (square, r) = (usqr(front as u32), r as u32);
        let limit = usqr(r << (p != q) as u32).wrapping_add(usqr(r));
        return square < limit || (closed && square == limit);
    };
    reaches(x, y, r, closed)
}

/// A circle against the cell without the open quarter disc around its far corner; none if it is
/// as one against the whole cell.
///
/// `n` is the centre relative to that corner, toward the solid. The nearest point of the solid is:
///
/// - beyond the cell, on one of the two whole sides;
/// - in the cell, on the arc, `side - |n|` away;
/// - before a side of the quarter disc, an end of the arc: the cusp on the side that `n` leans to.
const fn concave(m: Raw, r: i32, side: i32, closed: bool) -> Option<bool> {
    let n = Raw { x: side, y: side }.sub(m);
    if n.x > 0 && n.y > 0 {
        if m.x < 0 || m.y < 0 {
            return None;
        }
        return Some(r >= side || !reaches(n.x as u32, n.y as u32, side.wrapping_sub(r), !closed));
    }
    let (x, y) = if n.x > n.y { (m.x, n.y) } else { (n.x, m.y) };
    Some(reaches(x.unsigned_abs(), y.unsigned_abs(), r, closed))
}
