//! Rays against two levels at once.

use super::Joined;
use super::hidden::{Beside, PartPath, end_met, hides};
use super::start::{StartSurface, is_covered};
use crate::error::RangeError;
use crate::num::{Raw, Vec2, less128, mul64};
use crate::world::level::Geometry;
use crate::world::ray::scan::{RayScan, RayWorld, ScanHit, hit_at, start_inside};
use crate::world::ray::{Inside, Met, RayHit, RayPieces, RayRules, Time, checked, meet, rays};
use core::cmp::Ordering;

impl<A: RayWorld, B: RayWorld> RayPieces for Joined<'_, A, B> {
    const WIDE: bool = true;
    const ROUND: bool = A::ARCS || B::ARCS;
}

impl<A: RayWorld, B: RayWorld> RayWorld for Joined<'_, A, B> {
    type Scan<'w>
        = JoinedRayHits<'w, A, B>
    where
        Self: 'w;

    fn scan(&self, origin: Vec2, motion: Vec2, rules: RayRules) -> Result<Self::Scan<'_>, RangeError> {
        self.cast_ray_all(origin, motion, rules)
    }

    fn parts(&self, path: PartPath, visit: &mut dyn FnMut(PartPath, &dyn Beside)) {
        self.first().parts(path.of_part(0), visit);
        self.second().parts(path.of_part(1), visit);
    }
}

impl<A: RayWorld, B: RayWorld> Joined<'_, A, B> {
    /// All hits of a ray in order, as if it continued through what it hits. Hits at the same moment
    /// count as one.
    ///
    /// Cost: as [`cast_ray`](Self::cast_ray).
    ///
    /// # Errors
    /// As [`cast_ray`](Self::cast_ray).
    pub fn cast_ray_all(
        &self,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<JoinedRayHits<'_, A, B>, RangeError> {
        let rules = rules.into();
        let (o, d) = checked(origin, motion)?;
        let (a, b) = (self.first().scan(origin, motion, rules)?, self.second().scan(origin, motion, rules)?);
        let (a, b) = (OneAhead::new(a), OneAhead::new(b));
        Ok(JoinedRayHits { pair: *self, o, d, rules, started: false, a, b })
    }
}

rays! {
    [A: RayWorld, B: RayWorld] Joined<'_, A, B> {
        /// The first point of either level's solid that a ray meets, or `None` if it ends
        /// before.
        ///
        /// It follows the rules of the levels' own `cast_ray`, as one level of both solids would. A
        /// ray along a floor that continues from level to level meets nothing. A ray that starts on
        /// the line between two solids that meet flush starts inside. A ray that comes to the end
        /// of that line from outside stops there.
        ///
        /// Arcs stay whole, and so do faces that end where an arc of the other level ends. A ray
        /// that starts there may meet them although they are covered. A ray passes a gap that
        /// closes to nothing between an arc of one level and a face of the other, exactly along the
        /// line of that face.
        ///
        /// Cost: that of both levels, and a look at the other level along the face for each hit.
        /// [`RayHit::cells`] counts the cells of the level that was hit.
        ///
        /// ```
        /// use tilesat::{Fx, Grid, Inside, Joined, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let floor = TileMap::from_ascii("  \n##", &KINDS)?;
        /// // Another floor continues from there, and ends in a wall.
        /// let other = floor.with_origin(Vec2::from_ints(32, 0))?;
        /// let wall = TileMap::from_ascii(" #\n##", &KINDS)?.with_origin(Vec2::from_ints(64, 0))?;
        /// let floors = Joined::new(&floor, &other);
        /// let level = Joined::new(&floors, &wall);
        /// let hit = level.cast_ray(Vec2::from_ints(4, 16), Vec2::from_ints(200, 0), Inside::Hit).unwrap().unwrap();
        /// assert_eq!((hit.point, hit.source), (Vec2::from_ints(80, 16), 1));
        /// # Ok::<(), tilesat::TileMapError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of both levels, and does not start
        /// inside. A ray from `a` decides it.
        ///
        /// If no line runs along a border, `a.line_of_sight(..)? && b.line_of_sight(..)?` gives the
        /// same answer for much less time, code and stack. Along a floor that continues from level
        /// to level, it sees the end of the next floor as a wall.
        ///
        /// # Errors
        /// [`RangeError`] if a point is outside the [domain](crate::num::DOMAIN).
        line_of_sight,
    }
}

/// The hits of a ray in order; see [`Joined::cast_ray_all`].
#[derive(Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct JoinedRayHits<'w, A: RayWorld, B: RayWorld> {
    pub(crate) pair: Joined<'w, A, B>,
    o: Raw,
    d: Raw,
    rules: RayRules,
    started: bool,
    a: OneAhead<A::Scan<'w>>,
    b: OneAhead<B::Scan<'w>>,
}

/// The hits of one level, one ahead.
#[derive(Debug)]
struct OneAhead<S> {
    scan: S,
    next: Option<ScanHit>,
}

impl<S: RayScan> OneAhead<S> {
    const fn new(scan: S) -> Self {
        Self { scan, next: None }
    }

    fn fill(&mut self) {
        if self.next.is_none() {
            self.next = self.scan.next_found();
        }
    }

    /// Drops a hit at the start, but not the end of a gap, which no piece of the surface shows.
    fn leave_start(&mut self) {
        let is_cusp = |met: &Met| matches!(met.feature.geometry, Geometry::Face { len: 0, .. });
        if self.next.and_then(|found| found.met).is_some_and(|met| met.touch.is_at_start() && !is_cusp(&met)) {
            self.next = None;
        }
    }
}

impl<A: RayWorld, B: RayWorld> RayScan for JoinedRayHits<'_, A, B> {
    fn next_found(&mut self) -> Option<ScanHit> {
        if !core::mem::replace(&mut self.started, true) {
            let found = self.at_start();
            if found.is_some() {
                return found;
            }
        }
        loop {
            self.a.fill();
            self.b.fill();
            let order = match (&self.a.next, &self.b.next) {
                (Some(a), Some(b)) => order(a, b),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => return None,
            };
            let from_a = if order.is_le() { self.a.next.take() } else { None };
            let from_b = if order.is_ge() { self.b.next.take() } else { None };
            let found = self.first_shown(from_a, from_b);
            if found.is_some() {
                return found;
            }
        }
    }

    fn goes_in(&self) -> bool {
        self.a.scan.goes_in() || self.b.scan.goes_in()
    }
}

impl<A: RayWorld, B: RayWorld> JoinedRayHits<'_, A, B> {
    /// One hit per moment, of the two that are met at the same one.
    fn first_shown(&self, from_a: Option<ScanHit>, from_b: Option<ScanHit>) -> Option<ScanHit> {
        let (a, b) = (self.hidden(from_a, self.pair.second()), self.hidden(from_b, self.pair.first()));
        let hidden = from_a.filter(|_| a).or(from_b.filter(|_| b));
        if let Some(found) = hidden.and_then(|hidden| self.shown_at_end(&hidden)) {
            return Some(found);
        }
        let (from_a, from_b) = (from_a.filter(|_| !a), from_b.filter(|_| !b));
        let met = |f: Option<ScanHit>| f.and_then(|f| f.met);
        let second = from_a.is_none()
            || met(from_b).zip(met(from_a)).is_some_and(|(b, a)| b.touch.ranks_above(&b.feature, &a, self.d));
        let (found, source) = if second { (from_b, 1) } else { (from_a, 0) };
        found.map(|f| ScanHit { hit: RayHit { source: f.hit.source << 1 | source, ..f.hit }, ..f })
    }

    /// Whether a hit is on a hidden face, or at the end of a face that is covered just there.
    fn hidden(&self, found: Option<ScanHit>, other: &dyn Beside) -> bool {
        let Some(met) = found.and_then(|found| found.met) else { return false };
        let geometry = &met.feature.geometry;
        hides::<Joined<'_, A, B>>(geometry, other)
            || end_met(geometry, self.o, self.d).is_some_and(|end| is_covered(&self.pair, None, end, met.touch.normal))
    }

    /// The best hit at the end of a hidden face. A scan reports one hit per moment, and so keeps
    /// back a second face that the ray meets there.
    fn shown_at_end(&self, hidden: &ScanHit) -> Option<ScanHit> {
        let met = hidden.met?;
        let (end, _) = end_met(&met.feature.geometry, self.o, self.d)?;
        let [solid, one_way] = StartSurface::of(&self.pair, end, self.d).best;
        let feature = self.best(solid, one_way)?.feature;
        let touch = meet::<Joined<'_, A, B>>(self.o, self.d, &feature)?;
        Some(self.of(Met { feature, touch }, hidden.hit.cells))
    }

    /// The better one of a solid face and a one-way face.
    fn best(&self, solid: Option<Met>, one_way: Option<Met>) -> Option<Met> {
        let one_way = one_way.filter(|_| self.rules.one_way);
        let first =
            |one_way: &Met| solid.is_none_or(|solid| one_way.touch.ranks_above(&one_way.feature, &solid, self.d));
        one_way.filter(first).or(solid)
    }

    fn of(&self, met: Met, cells: u32) -> ScanHit {
        ScanHit { hit: hit_at::<Joined<'_, A, B>>(self.o, self.d, &met, cells), met: Some(met) }
    }

    /// The hit of a start on both levels' borders.
    fn at_start(&mut self) -> Option<ScanHit> {
        let (o, d) = (self.o, self.d);
        let (first, second) = (self.pair.first(), self.pair.second());
        // One-way pieces belong to no solid.
        let (at_first, at_second) = (first.touches_at(o), second.touches_at(o));
        if !(at_first && at_second || self.rules.one_way && (at_first || at_second)) {
            return None;
        }
        self.a.fill();
        self.b.fill();
        let (from_a, from_b) = (self.a.next, self.b.next);
        // The start is inside one of them.
        if [from_a, from_b].into_iter().flatten().any(|found| found.met.is_none()) {
            return None;
        }
        let start = StartSurface::of(&self.pair, o, d);
        let cells = from_a.or(from_b).map_or(0, |found| found.hit.cells);
        if !start.bare {
            self.a.leave_start();
            self.b.leave_start();
            let face = start.face.filter(|_| matches!(self.rules.inside, Inside::Hit))?;
            let inside = start_inside(o, d, (face.cell, face.flags), cells);
            return Some(ScanHit { hit: RayHit { source: face.source, ..inside }, met: None });
        }
        let [solid, one_way] = start.best;
        let solid = solid.filter(|_| start.on_seam || self.goes_in());
        self.a.leave_start();
        self.b.leave_start();
        self.best(solid, one_way).map(|met| self.of(met, cells))
    }
}

impl<A: RayWorld, B: RayWorld> Iterator for JoinedRayHits<'_, A, B> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.next_found().map(|found| found.hit)
    }
}

/// Which hit is first: a start inside, then by the exact moments. A hit within an arc has no exact
/// moment, and is compared by its `toi`, after a straight one.
fn order(a: &ScanHit, b: &ScanHit) -> Ordering {
    let (Some(met_a), Some(met_b)) = (a.met, b.met) else { return a.met.is_some().cmp(&b.met.is_some()) };
    match (met_a.touch.time, met_b.touch.time) {
        (Some(s), Some(t)) if before(s, t) => Ordering::Less,
        (Some(s), Some(t)) if before(t, s) => Ordering::Greater,
        (Some(_), Some(_)) => Ordering::Equal,
        (s, t) => (a.hit.toi.raw(), s.is_none(), false).cmp(&(b.hit.toi.raw(), t.is_none(), true)),
    }
}

fn before(s: Time, t: Time) -> bool {
    less128(mul64(s.num, t.den), mul64(t.num, s.den))
}
