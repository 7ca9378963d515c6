//! The hits of a ray in order: one engine for every kind of level.

use super::walk::{Axes, Beyond, RayWalk, along};
use super::{Met, RayHit, RayPieces, RayRules, Time, Touch, arc_contact, meet};
use crate::num::{Axis, Raw, Toi, mul_div, mul_div_wide, umul};
use crate::query::Inside;
use crate::world::cell::Cell;
use crate::world::grid::Grid;
use crate::world::level::{Feature, Geometry, face_against};

/// A level whose surface is found cell by cell, bands included as [`beyond`](Self::beyond) says.
pub(in crate::world) trait RayLevel: RayPieces {
    /// The pieces of a cell.
    type Pieces<'w>: Iterator<Item = Feature>
    where
        Self: 'w;

    fn grid(&self) -> &Grid;

    fn beyond(&self) -> Beyond;

    /// The start of a ray.
    fn walk(&self, o: Raw, d: Raw) -> RayWalk {
        let grid = self.grid();
        RayWalk::new(grid.ray_lane(&grid.x, o.x, d.x), grid.ray_lane(&grid.y, o.y, d.y), grid.cell as u32)
    }

    /// Continues from an examined step over cells without pieces, as far as that is faster than
    /// single steps.
    fn skip(&self, _: &mut RayWalk) {}

    /// All pieces that have a point in the closed cell. Where each piece has one cell, those of
    /// this one. Those that the motion `d` does not oppose may be missing. `None` if there are
    /// none, as early as possible, and for cells beyond the bands.
    fn pieces(&self, x: i32, y: i32, d: Raw) -> Option<Self::Pieces<'_>>;

    /// Whether the start of a walk is strictly inside the solid.
    fn holds_start(&self, o: Raw, walk: &RayWalk) -> bool;

    /// Whether a ray that starts on the border of the solid is strictly inside just after.
    fn enters(&self, o: Raw, d: Raw, walk: &RayWalk) -> bool;

    /// The user's flags of the solid in a cell.
    fn flags(&self, x: i32, y: i32) -> u8;
}

/// A ray whose hits were found up to a moment.
#[derive(Debug)]
pub(in crate::world) struct Scan<'w, L> {
    pub(in crate::world) level: &'w L,
    o: Raw,
    d: Raw,
    rules: RayRules,
    walk: RayWalk,
    /// The best hit so far, later than `after`.
    best: Option<Met>,
    /// Whether the scan has already reported it.
    is_told: bool,
    /// The moment of the last hit.
    after: Option<Time>,
    stage: Stage,
}

/// A hit, and the piece that was met; none for a start inside.
#[derive(Clone, Copy, Debug)]
pub struct ScanHit {
    pub(in crate::world) hit: RayHit,
    pub(in crate::world) met: Option<Met>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Nothing was looked at.
    Start,
    /// The cells of the step are to be looked at.
    Look,
    /// They have been.
    Go,
}

/// A derived implementation would require a level that can be cloned.
impl<L> Clone for Scan<'_, L> {
    fn clone(&self) -> Self {
        Self { ..*self }
    }
}

impl<'w, L: RayLevel> Scan<'w, L> {
    /// For a ray that starts and ends in the domain.
    #[inline]
    pub(in crate::world) fn of(level: &'w L, o: Raw, d: Raw, rules: RayRules) -> Self {
        Self {
            level,
            o,
            d,
            rules,
            walk: level.walk(o, d),
            best: None,
            is_told: false,
            after: None,
            stage: Stage::Start,
        }
    }

    /// Whether the ray is inside the solid just after its start.
    pub(in crate::world) fn goes_in(&self) -> bool {
        self.level.enters(self.o, self.d, &self.level.walk(self.o, self.d))
    }

    /// The next hit, with the feature that it met.
    pub(in crate::world) fn find(&mut self) -> Option<ScanHit> {
        self.advance().map(|hit| ScanHit { hit, met: self.best })
    }

    /// The next hit.
    ///
    /// A piece is met in a cell that the ray has entered by then: a hit before the next line is
    /// final. A hit on that line is not: the cells behind it may have something better.
    pub(in crate::world) fn advance(&mut self) -> Option<RayHit> {
        if self.stage == Stage::Start {
            self.stage = Stage::Look;
            if matches!(self.rules.inside, Inside::Hit) {
                let hit = self.at_start();
                if hit.is_some() {
                    return hit;
                }
            }
        }
        if core::mem::take(&mut self.is_told) {
            self.best = None;
        }
        loop {
            if self.stage == Stage::Look {
                self.stage = Stage::Go;
                self.look();
                if L::ROUND && (self.d.x == 0 || self.d.y == 0) && self.best.is_none() {
                    self.look_for_cusp();
                }
                if self.best.is_none() {
                    self.level.skip(&mut self.walk);
                }
            }
            let over = self.level.grid().next_lines(&self.walk.x, &self.walk.y, self.level.beyond());
            if let Some(best) = self.best.as_ref().filter(|best| over == 0 || self.is_before(best, over)) {
                (self.is_told, self.after) = (true, best.touch.time);
                // After a point within an arc, nothing more is in the step.
                if best.touch.time.is_some() {
                    self.stage = Stage::Look;
                }
                return Some(self.hit(best));
            }
            if over == 0 {
                return None;
            }
            self.walk.cross(over, self.level.grid().cell as u32);
            self.stage = Stage::Look;
        }
    }

    fn is_before(&self, met: &Met, over: Axes) -> bool {
        let (num, den) = self.walk.time(over);
        let line = Time { num: u64::from(num), den: u64::from(den) };
        met.touch.time.is_none_or(|time| time.before::<L>(line))
    }

    /// Tests the pieces of the step's cells.
    #[inline(never)]
    fn look(&mut self) {
        let mut number = 4u32;
        while number != 0 {
            number = number.wrapping_sub(1);
            let Some((x, y)) = self.walk.cell(number) else { continue };
            let Some(pieces) = self.level.pieces(x, y, self.d) else { continue };
            let mut pieces = pieces;
            while let Some(piece) = &pieces.next() {
                if piece.one_way && !self.rules.one_way {
                    continue;
                }
                let Some(touch) = &meet::<L>(self.o, self.d, piece) else { continue };
                // At the start, solid pieces are met only where the ray goes into the solid: it may
                // also leave, pass or slide along their ends.
                let at_start = touch.is_at_start() && !piece.one_way;
                if !at_start || self.level.enters(self.o, self.d, &self.walk) {
                    self.consider(piece, touch);
                }
            }
        }
    }

    /// Looks for the end of a gap that closes to nothing.
    #[inline(never)]
    fn look_for_cusp(&mut self) {
        if let Some(met) = &cusp(self.level, self.o, self.d, &self.walk) {
            self.consider(&met.feature, &met.touch);
        }
    }

    /// Keeps a hit that is later than the last one and better than the best.
    #[inline(never)]
    fn consider(&mut self, feature: &Feature, touch: &Touch) {
        if let (Some(time), Some(after)) = (touch.time, self.after) {
            if !after.before::<L>(time) {
                return;
            }
        }
        if self.best.as_ref().is_some_and(|best| !touch.precedes::<L>(feature, best, self.d)) {
            return;
        }
        self.best = Some(Met { feature: *feature, touch: *touch });
    }

    fn hit(&self, met: &Met) -> RayHit {
        hit_at::<L>(self.o, self.d, met, self.walk.cells)
    }

    /// The hit of a start inside.
    #[inline(never)]
    fn at_start(&self) -> Option<RayHit> {
        if !self.level.holds_start(self.o, &self.walk) {
            return None;
        }
        let (x, y) = (self.walk.x.cell, self.walk.y.cell);
        Some(start_inside(self.o, self.d, (Cell::of(x, y), self.level.flags(x, y)), self.walk.cells))
    }
}

/// The hit of a start inside of a solid: against the longer component of the motion.
pub(in crate::world) fn start_inside(o: Raw, d: Raw, (cell, flags): (Cell, u8), cells: u32) -> RayHit {
    let axis = if d.y.unsigned_abs() > d.x.unsigned_abs() {
        Axis::new(0, d.y.signum().wrapping_neg())
    } else {
        Axis::new(if d.x > 0 { -1 } else { 1 }, 0)
    };
    RayHit {
        toi: Toi::ZERO,
        point: o.vec2(),
        axis,
        cell,
        index: 0,
        flags,
        one_way: false,
        source: 0,
        inside: true,
        cells,
    }
}

/// The hit of a ray from `o` by `d` that meets a piece.
#[inline(never)]
pub(in crate::world) fn hit_at<L: RayPieces>(o: Raw, d: Raw, met: &Met, cells: u32) -> RayHit {
    let (toi, by, axis) = match (met.touch.time, met.feature.geometry) {
        (Some(time), _) => straight::<L>(d, time, met.touch.normal),
        (None, Geometry::Arc { centre, radius, convex, .. }) if L::ROUND => {
            let m = o.sub(Raw::of(centre));
            let (toi, by) = arc_contact(m, d, radius, convex);
            let at = m.add(by);
            let axis = Axis::new(at.x, at.y);
            (toi, by, if convex { axis } else { axis.reversed() })
        }
        // Only arcs have no time.
        (None, _) => (Toi::ZERO, Raw { x: 0, y: 0 }, met.touch.normal),
    };
    hit_of(&met.feature, (toi, o.add(by), axis), cells)
}

/// The hit of a piece.
pub(in crate::world) fn hit_of(feature: &Feature, (toi, at, axis): (Toi, Raw, Axis), cells: u32) -> RayHit {
    RayHit {
        toi,
        point: at.vec2(),
        axis,
        cell: feature.cell,
        index: feature.index,
        flags: feature.flags,
        one_way: feature.one_way,
        source: feature.source,
        inside: false,
        cells,
    }
}

/// The time and the displacement of a hit at a fraction of the motion, exactly rounded. A
/// coordinate is rounded toward the start, or toward the end if that is the normal's side.
pub(in crate::world) fn straight<L: RayPieces>(d: Raw, time: Time, normal: Axis) -> (Toi, Raw, Axis) {
    let toi = Toi::clamped(part::<L>(Toi::ONE.raw(), time).0);
    let by = Raw { x: signed::<L>(d.x, normal.x, time), y: signed::<L>(d.y, normal.y, time) };
    (toi, by, normal)
}

/// The floor of `size num / den`, and whether something is left over.
fn part<L: RayPieces>(size: u32, time: Time) -> (u32, bool) {
    if L::WIDE {
        // Below 2^62 the low bits alone give the remainder.
        let part = mul_div_wide(time.num, size, time.den);
        let rest = time.num.wrapping_mul(u64::from(size)).wrapping_sub(time.den.wrapping_mul(u64::from(part)));
        (part, rest != 0)
    } else {
        let (num, den) = (time.num as u32, time.den as u32);
        let part = mul_div(num, size, den);
        (part, umul(part, den) != umul(num, size))
    }
}

/// The part of a component of the motion.
fn signed<L: RayPieces>(d: i32, normal: i32, time: Time) -> i32 {
    let (mut part, rest) = part::<L>(d.unsigned_abs(), time);
    if rest && (d > 0) == (normal > 0) && normal != 0 {
        part = part.wrapping_add(1);
    }
    let part = part as i32;
    if d < 0 { part.wrapping_neg() } else { part }
}

/// The hit of a ray along a grid line at the last line that it has crossed, or at its start on one.
/// There it leaves the open and enters the solid, and no piece opposes it.
///
/// That is between a convex arc and the surface that it touches. Both are tangent to the ray, and
/// the solid behind the point has no face there.
///
/// ```text
///       ....                  The arc ends at P with the ray's direction; the floor below goes on behind P, and so does the solid
///   .solid..`.                above it. The hit has the point for a face, across the ray.
///   ..........P<-------- ray
///   .......solid.........
/// ```
#[inline(never)]
fn cusp<L: RayLevel>(level: &L, o: Raw, d: Raw, walk: &RayWalk) -> Option<Met> {
    let cell = level.grid().cell as u32;
    if along(&walk.x, &walk.y, cell) == 0 {
        return None;
    }
    let side = if d.x != 0 { &walk.x } else { &walk.y };
    // The line before the next one. None is crossed yet if that is behind the start.
    let way = side.near.checked_sub(cell)?;
    if side.size == 0 || way > side.size {
        return None;
    }
    let by = side.step.wrapping_mul(way as i32);
    let p = o.add(if d.x != 0 { Raw { x: by, y: 0 } } else { Raw { x: 0, y: by } });
    let back = d.reversed();
    let solid = |d: Raw| level.enters(p, d, &level.walk(p, d));
    if !solid(d) || solid(back) {
        return None;
    }
    let normal = Axis::new(back.x.signum(), back.y.signum());
    let (x, y) = (walk.x.cell, walk.y.cell);
    let dir = normal.perp();
    let feature = Feature {
        geometry: Geometry::Face { a: p.vec2(), dir, len: 0, joined: [true; 2] },
        cell: Cell::of(x, y),
        index: face_against(normal),
        flags: level.flags(x, y),
        one_way: false,
        source: 0,
    };
    let time = Some(Time { num: u64::from(way), den: u64::from(side.size) });
    Some(Met { feature, touch: Touch { time, normal } })
}
