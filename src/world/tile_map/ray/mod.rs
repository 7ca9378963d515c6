//! Rays through tiles: questions and answers.

mod blocks;
mod open;
mod packed;
mod shapes;

use super::{Outside, ShapeSet, Store, TileMap};
use crate::error::RangeError;
use crate::num::{Axis, Raw, Toi, Vec2, fraction, umul};
use crate::world::cell::Cell;
use crate::world::level::face_against;
use crate::world::ray::scan::{Scan, ScanHit};
use crate::world::ray::walk::{X, Y};
use crate::world::ray::world::{RayScan, RayWorld, rays};
use crate::world::ray::{Inside, RayHit, RayRules, checked, in_domain, refusal};
use crate::world::tile_map::kind::TileKind;
use blocks::{Detour, END, INSIDE};

impl<S: ShapeSet, T: Store> TileMap<'_, S, T> {
    /// The first point of the closed solid that a ray from `origin` along `motion` meets, or `None`
    /// if it ends before.
    ///
    /// Every decision is exact, for any direction and length inside the domain:
    ///
    /// - A straight face is hit by a ray that moves against its normal, ends included. Touching a
    ///   corner is a hit, and no ray passes between two diagonal solids. A ray along a grid line
    ///   stops at the first face that it meets on either side of the line.
    /// - A convex arc is hit by a ray that enters its disc on it, ends included. A concave one is
    ///   hit by a ray that leaves the disc on it, ends included. A ray that slides along a face or
    ///   is a tangent hits nothing. It hits only if it continues into the solid beside the end of a
    ///   concave arc.
    /// - A face is hit even at the very end of the motion; one raw unit short is a miss.
    /// - If faces are hit at the same moment, the one whose normal is more along x wins (among
    ///   blocks: toward x). Then the one that opposes the motion more, then +x, then +y, then a
    ///   straight one before an arc.
    /// - A start on the border is not inside: moving in hits at 0. Leaving, passing a corner or
    ///   sliding along does not hit there.
    /// - [`RayRules::inside`] decides the result of a start inside. [`Inside::Hit`] reports a hit
    ///   at 0 whose axis opposes the larger component of the motion (x on a tie, +x for no motion).
    /// - A motion of zero hits nothing, except from inside with [`Inside::Hit`].
    /// - A ray passes one-way edges, unless [`RayRules::one_way`] is true.
    ///   [`Outside`](crate::world::Outside) counts.
    ///
    /// ```text
    ///   +---+---+---+---+       o      start
    ///   |  o|   |   |###|       x      hit: the face toward the start,
    ///   +---+`-.+---+###+              axis (-1, 0)
    ///   |   |   |`-.x###|
    ///   +---+---+---+---+
    /// ```
    ///
    /// Cost: one look-up per cell, at most width + height + 4 cells, the area beyond the map
    /// included ([`RayHit::cells`] counts them). In [`Blocks`](crate::world::Blocks) a hit in the
    /// 17th cell takes about 850 instructions on a Cortex-M0, 560 on a Cortex-M3, time and point
    /// included. There is no division and no root. Rays that start in the solid or beyond the map,
    /// or continue in a band beyond it, examine the four cells around each crossing. That takes
    /// about 150 instructions per cell. Other shapes add two sides and one inner piece for each
    /// tile that is not empty, and one root for a hit within an arc.
    ///
    /// ```
    /// use tilesat::{Axis, Cell, Inside, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("...#\n...#", &KINDS)?;
    /// let hit = map.cast_ray(Vec2::from_ints(8, 8), Vec2::from_ints(80, 20), Inside::Ignore).unwrap().unwrap();
    /// assert_eq!((hit.point, hit.axis, hit.cell), (Vec2::from_ints(48, 18), Axis::NEG_X, Cell::new(3, 1)));
    /// assert_eq!(hit.toi.to_fx(), fx!(0.5));
    ///
    /// // A ray exactly up to the wall hits; one raw unit less does not.
    /// let reach = Vec2::from_ints(40, 0);
    /// assert!(map.cast_ray(Vec2::from_ints(8, 8), reach, Inside::Ignore).unwrap().is_some());
    /// assert!(map.cast_ray(Vec2::from_ints(8, 8), reach - Vec2::from_raw(1, 0), Inside::Ignore).unwrap().is_none());
    /// # Ok::<(), tilesat::TileMapError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
    #[inline]
    #[doc(alias("raycast", "linecast", "RayCast2D", "DDA"))]
    pub fn cast_ray(
        &self,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<Option<RayHit>, RangeError> {
        let rules = rules.into();
        if S::SHAPED || rules.one_way {
            self.cast_shaped(origin, motion, rules)
        } else {
            self.cast_blocks(origin, motion, rules.inside)
        }
    }

    fn cast_shaped(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Option<RayHit>, RangeError> {
        let (o, d) = checked(origin, motion)?;
        Ok(Scan::of(self, o, d, rules).advance())
    }

    /// The case in which only full cells stop a ray.
    fn cast_blocks(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<RayHit>, RangeError> {
        let (o, d) = (Raw::of(origin), Raw::of(motion));
        // A sum that wraps is outside too: a start below 2^29 and a motion up to 2^31 leave at
        // least 2^32 - 2^31 - 2^29.
        let end = o.add(d);
        if !(in_domain(o.x) && in_domain(o.y) && in_domain(end.x) && in_domain(end.y)) {
            return Err(refusal(o, d));
        }
        let (mut x, mut y) = (self.lane(&self.grid.x, o.x, d.x), self.lane(&self.grid.y, o.y, d.y));
        let cell = self.grid.cell as u32;
        let (mut met, mut kx, mut ky, mut kind) = (0, 0, 0, TileKind::FULL);
        if self.runs(&x, &y) {
            let run = self.run::<false>(&x, &y);
            (met, kx, ky) = (run.met, run.kx, run.ky);
            kind = self.kinds.get(run.id);
        }
        let mut cells = 1u32.wrapping_add(kx).wrapping_add(ky);
        if met & (X | Y) == 0 {
            if met == END && matches!(self.outside, Outside::Empty) {
                return Ok(None);
            }
            let mut rest = Detour { x: x.crossed(kx, cell), y: y.crossed(ky, cell), cells, kind };
            met = self.detour(&mut rest, matches!(inside, Inside::Hit));
            (x, y, kx, ky, cells, kind) = (rest.x, rest.y, 0, 0, rest.cells, rest.kind);
            if met == END {
                return Ok(None);
            }
        }
        let vertical = met & Y != 0;
        // The last line crossed is one cell before the next. A start on a line has crossed that
        // line.
        let (near, k, den, size) = if vertical { (y.near, ky, y.size, x.size) } else { (x.near, kx, x.size, y.size) };
        let num = near.wrapping_add(k.wrapping_sub(1).wrapping_mul(cell));
        if num > den {
            return Ok(None);
        }
        let (mut toi, mut part) = (0, 0);
        if num != 0 {
            toi = fraction(num, den);
            // floor(size num / den) is the product with the floored time, or one more: the
            // remainder, below 2 den < 2^31, decides.
            part = (umul(size, toi) >> 30) as u32;
            let rest = size.wrapping_mul(num).wrapping_sub(part.wrapping_mul(den));
            part = part.wrapping_add((rest >= den) as u32);
        }
        let (by_x, by_y, axis);
        if vertical {
            (by_x, by_y) = (part, num);
            axis = Axis::new(0, y.step.wrapping_neg());
        } else {
            (by_x, by_y) = (num, part);
            axis = Axis::new(x.step.wrapping_neg(), 0);
        }
        Ok(Some(RayHit {
            toi: Toi::exact(toi),
            point: Vec2::from_raw(x.ahead(o.x, by_x), y.ahead(o.y, by_y)),
            axis,
            cell: Cell::of(x.ahead(x.cell, kx), y.ahead(y.cell, ky)),
            index: if met & INSIDE != 0 { 0 } else { face_against(axis) },
            flags: kind.flags,
            one_way: false,
            source: 0,
            inside: met & INSIDE != 0,
            cells,
        }))
    }
}

/// The hits of a ray in order; see [`TileMap::cast_ray_all`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct RayHits<'w, 'a, S: ShapeSet, T: Store> {
    pub(in crate::world) scan: Scan<'w, TileMap<'a, S, T>>,
}

impl<S: ShapeSet, T: Store> Clone for RayHits<'_, '_, S, T> {
    fn clone(&self) -> Self {
        Self { scan: self.scan.clone() }
    }
}

/// This impl is here, because the parts of the cursor are private to levels.
#[cfg(feature = "defmt")]
impl<S: ShapeSet, T: Store> defmt::Format for RayHits<'_, '_, S, T> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "RayHits of {}", self.scan.level);
    }
}

impl<S: ShapeSet, T: Store> Iterator for RayHits<'_, '_, S, T> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.scan.advance()
    }
}

rays! {
    ['a, S: ShapeSet, T: Store] TileMap<'a, S, T> {
        /// Whether a ray from `a` reaches `b` without a hit: the line between them is free of the
        /// closed solid.
        ///
        /// Exact, by the rules of [`cast_ray`](Self::cast_ray) with
        /// [`Inside::Hit`](crate::world::Inside::Hit). If `a` is inside the solid, the answer is
        /// false. A corner that the line touches blocks it. A wall along which it slides and
        /// one-way edges do not. A line that ends on a surface is blocked; one that starts there is
        /// not. Where a line only touches the end of an arc, one direction may be blocked and the
        /// other one free. Cost: as [`cast_ray`](Self::cast_ray).
        ///
        /// ```
        /// use tilesat::{TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let map = TileMap::from_ascii("...\n.#.\n...", &KINDS)?;
        /// let (guard, near, far) = (Vec2::from_ints(8, 8), Vec2::from_ints(40, 8), Vec2::from_ints(40, 40));
        /// assert!(map.line_of_sight(guard, near).unwrap());
        /// assert!(!map.line_of_sight(guard, far).unwrap());
        /// # Ok::<(), tilesat::TileMapError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if a point is outside the [domain](crate::num::DOMAIN).
        line_of_sight,
        /// Every hit of a ray, nearest first, as if it continued through what it hits.
        ///
        /// The rules are those of [`cast_ray`](Self::cast_ray), whose hit is the first. A hit is a
        /// point at which the ray enters the solid, or touches it at a corner. Leaving the solid is
        /// no hit. Several faces at the same moment give one hit, so the joint of two tiles is hit
        /// once.
        ///
        /// Cost: the cursor stores no hits, so none can be cut off. It walks only as far as you
        /// read: at most width + height + 4 cells, and the cells of one step once more for each
        /// hit. No cell has more than three hits. [`RayHit::cells`] counts the cells up to that
        /// hit.
        ///
        /// ```
        /// use tilesat::{Inside, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'/', TileKind::of(TileShape::SlopeBottomRight));
        /// let map = TileMap::from_ascii("./..#.#", &TileKinds::EMPTY)?.with_kinds::<Slopes>(&KINDS)?;
        /// let hits = map.cast_ray_all(Vec2::from_ints(0, 12), Vec2::from_ints(112, 0), Inside::Ignore).unwrap();
        /// let found: Vec<_> = hits.map(|hit| (hit.point.x.to_num::<i32>(), hit.cell.x)).collect();
        /// assert_eq!(found, [(20, 1), (64, 4), (96, 6)]);
        /// # Ok::<(), tilesat::TileMapError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
        cast_ray_all -> RayHits<'_, 'a, S, T>,
    }
}

impl<'a, S: ShapeSet, T: Store> RayWorld for TileMap<'a, S, T> {
    type Scan<'w>
        = RayHits<'w, 'a, S, T>
    where
        Self: 'w;

    #[inline]
    fn scan(&self, o: Raw, d: Raw, rules: RayRules) -> Self::Scan<'_> {
        RayHits { scan: Scan::of(self, o, d, rules) }
    }

    /// The map's own way, which is fast through blocks.
    #[inline]
    fn cast_ray(&self, origin: Vec2, motion: Vec2, rules: impl Into<RayRules>) -> Result<Option<RayHit>, RangeError> {
        TileMap::cast_ray(self, origin, motion, rules)
    }
}

impl<S: ShapeSet, T: Store> RayScan for RayHits<'_, '_, S, T> {
    fn next_found(&mut self) -> Option<ScanHit> {
        self.scan.find()
    }

    fn goes_in(&self) -> bool {
        self.scan.goes_in()
    }
}
