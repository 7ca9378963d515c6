//! Rays against a list of convex solids.
//!
//! A ray enters a convex solid once at most. So each hit is a search of all solids for the earliest
//! one after the last hit. Moments are compared exactly, also within arcs.

use super::Solids;
use super::convex::ConvexSolids;
use super::convex_solid::{ConvexSolid, SolidShape};
use crate::error::RangeError;
use crate::num::{Raw, Vec2, less128, mul64, sqr64, sub128, usqr};
use crate::query::cast::moment::along;
use crate::query::{Core, meet as boxes, meets};
use crate::shape::Aabb;
use crate::world::level::{Geometry, precedes};
use crate::world::measure::product;
use crate::world::ray::scan::{ScanHit, hit_at, start_inside};
use crate::world::ray::world::{RayScan, RayWorld, rays};
use crate::world::ray::{Inside, Met, RayHit, RayPieces, RayRules, Time, checked, meet};
use core::cmp::Ordering;

impl<S: SolidShape> RayPieces for ConvexSolids<'_, S> {
    const WIDE: bool = true;
    const ROUND: bool = S::ROUND;
}

impl<'a, S: SolidShape> ConvexSolids<'a, S> {
    /// All hits of a ray in order, as if it continued through what it hits.
    ///
    /// Hits at the same moment count as one.
    ///
    /// Cost: as [`cast_ray`](Self::cast_ray) for each hit.
    ///
    /// # Errors
    /// As [`cast_ray`](Self::cast_ray).
    pub fn cast_ray_all(
        &self,
        origin: Vec2,
        motion: Vec2,
        rules: impl Into<RayRules>,
    ) -> Result<ConvexRayHits<'a, S>, RangeError> {
        let (o, d) = checked(origin, motion)?;
        Ok(self.hits(o, d, rules.into().inside))
    }

    const fn hits(&self, o: Raw, d: Raw, inside: Inside) -> ConvexRayHits<'a, S> {
        ConvexRayHits { all: *self, o, d, inside, after: None, started: false, looks: 0 }
    }
}

rays! {
    [S: SolidShape] ConvexSolids<'_, S> {
        /// The first point of the closed solids at their current positions that a ray from `origin`
        /// along `motion` meets, or `None` if it ends before.
        ///
        /// Every decision is exact, also which of several solids comes first. Each solid is tested
        /// separately, by the rules of its shape's own `cast_ray`. A ray that touches a sharp
        /// corner hits it, and a tangent of a round part is not a hit. A ray that starts inside of
        /// one solid meets the border of another one there, and so does
        /// [`cast_ray_all`](Self::cast_ray_all). A ray along the line between two flush solids is
        /// in neither.
        ///
        /// The [`cell`](RayHit::cell) of the hit names the solid: see
        /// [`Solids::key_of`](crate::Solids::key_of). If several are hit at the same moment, the
        /// one whose normal is more along x wins. Then a straight side wins over a round one, then
        /// the smaller coordinates, then the smaller key.
        ///
        /// Cost: a comparison of boxes for each solid. Each side or arc of a near solid takes a few
        /// products of double words, and two more if it may be the first.
        ///
        /// ```
        /// use tilesat::world::{ConvexSolid, ConvexSolids};
        /// use tilesat::{Axis, Circle, Inside, Joined, Solids, TileKind, TileKinds, TileMap, Vec2, fx};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let level = TileMap::from_ascii("    #", &KINDS)?;
        /// let bumper = [ConvexSolid::new(Circle::new(Vec2::from_ints(40, 8), fx!(6))?, 3)?];
        /// let solids = ConvexSolids::new(&bumper);
        /// let ray = |y| (Vec2::from_ints(4, y), Vec2::from_ints(90, 0));
        /// let hit = Joined::new(&level, &solids).cast_ray(ray(8).0, ray(8).1, Inside::Hit)?.unwrap();
        /// assert_eq!((hit.point, hit.axis, hit.source), (Vec2::from_ints(34, 8), Axis::NEG_X, 1));
        /// assert_eq!(Solids::key_of(hit.cell), Some(3));
        /// assert_eq!(solids.cast_ray(ray(14).0, ray(14).1, Inside::Hit)?, None); // a tangent
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of the solids and does not start
        /// inside.
        ///
        /// A line that ends on a surface is blocked; one that starts there is not.
        ///
        /// # Errors
        /// [`RangeError`] if a point is outside the [domain](crate::num::DOMAIN).
        line_of_sight,
    }
}

/// The hits of a ray in order; see [`ConvexSolids::cast_ray_all`].
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct ConvexRayHits<'w, S> {
    all: ConvexSolids<'w, S>,
    o: Raw,
    d: Raw,
    inside: Inside,
    /// The moment of the last hit.
    after: Option<RayMoment>,
    started: bool,
    looks: u32,
}

impl<S: SolidShape> Iterator for ConvexRayHits<'_, S> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.next_found().map(|found| found.hit)
    }
}

impl<S: SolidShape> RayScan for ConvexRayHits<'_, S> {
    fn next_found(&mut self) -> Option<ScanHit> {
        self.looks = self.looks.saturating_add(self.all.list().len() as u32);
        if !self.started {
            self.started = true;
            let inside = if matches!(self.inside, Inside::Hit) { self.holder() } else { None };
            if let Some(solid) = inside {
                let hit = start_inside(self.o, self.d, (solid.cell(), solid.flags()), self.looks);
                return Some(ScanHit { hit, met: None });
            }
        }
        let square = self.d.len2();
        let mut best: Option<(Met, RayMoment)> = None;
        for (met, moment) in self.all.list().iter().filter_map(|solid| self.met(solid)) {
            let passed = self.after.is_some_and(|after| moment.order(&after, square).is_le());
            let is_first = |(kept, then): &(Met, RayMoment)| match moment.order(then, square) {
                Ordering::Equal => goes_before(&met, kept, self.d),
                order => order.is_lt(),
            };
            if !passed && best.as_ref().is_none_or(is_first) {
                best = Some((met, moment));
            }
        }
        let (met, moment) = best?;
        self.after = Some(moment);
        Some(ScanHit { hit: hit_at::<ConvexSolids<'_, S>>(self.o, self.d, &met, self.looks), met: Some(met) })
    }

    fn goes_in(&self) -> bool {
        self.all.list().iter().filter_map(|solid| self.met(solid)).any(|(met, _)| met.touch.is_at_start())
    }
}

impl<'w, S: SolidShape> ConvexRayHits<'w, S> {
    /// The solid that strictly contains the start; if there are several, the one with the smallest
    /// key.
    fn holder(&self) -> Option<&'w ConvexSolid<S>> {
        let eye = [self.o.vec2()];
        let holds = |solid: &&ConvexSolid<S>| {
            let shape = solid.shape();
            let (corners, radius) = (shape.outline(), shape.rounding());
            meets::<false>(Core { corners: &eye, radius: 0 }, Core { corners: &corners, radius })
        };
        self.all.list().iter().filter(holds).min_by_key(|solid| solid.key())
    }

    /// Where and when the ray enters a solid.
    #[inline(never)]
    fn met(&self, solid: &ConvexSolid<S>) -> Option<(Met, RayMoment)> {
        let (o, d) = (self.o, self.d);
        let (lo, hi) = boxes::corners(o, o.add(d));
        if !boxes::aabb_aabb::<true>(lo, hi, solid.whole().lo(), solid.whole().hi()) {
            return None;
        }
        let corners = solid.outline();
        let (border, way) = (solid.border(&corners), Aabb::from_raw_unchecked(lo, hi));
        let (core, radius) = (border.core, border.core.radius);
        // Corners are ends of other pieces, which are closed.
        let step = if radius == 0 { 5 } else { 1 };
        let mut best: Option<Met> = None;
        for feature in (0..border.pieces()).step_by(step).filter_map(|index| border.piece(index, &way)) {
            let Some(touch) = meet::<ConvexSolids<'_, S>>(o, d, &feature) else { continue };
            // At the start, a side is met only if the ray goes into the solid. A round part is met
            // in no other way.
            if touch.is_at_start() && radius == 0 && leaves(core, o, d) {
                return None;
            }
            // A ray meets the border of a convex solid at one moment: at a corner two pieces.
            if best.is_none_or(|kept| touch.ranks_above(&feature, &kept, d)) {
                best = Some(Met { feature, touch });
            }
        }
        best.map(|met| (met, RayMoment::of(&met, o, d)))
    }
}

/// Whether a ray from the border of a polygon does not lead inside: it slides along the side on
/// which it starts, or leaves there.
fn leaves(core: Core<'_>, o: Raw, d: Raw) -> bool {
    (0..core.corners.len()).any(|i| {
        let into = core.facing_normal(i);
        along(into, o.sub(core.corner(i))) == 0 && along(into, d) <= 0
    })
}

/// At one moment: by the order of all rays, then by geometry, then by the key.
fn goes_before(a: &Met, b: &Met, d: Raw) -> bool {
    if a.touch.ranks_above(&a.feature, b, d) || b.touch.ranks_above(&b.feature, a, d) {
        return a.touch.ranks_above(&a.feature, b, d);
    }
    let key = |met: &Met| Solids::key_of(met.feature.cell);
    precedes(&a.feature, &b.feature) || (!precedes(&b.feature, &a.feature) && key(a) < key(b))
}

/// When a ray meets a piece.
#[derive(Clone, Copy, Debug)]
enum RayMoment {
    /// A straight one, or the end of an arc.
    Part(Time),
    /// An arc: at `(ahead - sqrt(square)) / |d|^2`, with `ahead` = -m.d, positive and below 2^61,
    /// and `square` = r^2 |d|^2 - (m x d)^2, positive and below 2^117.
    Root { ahead: u64, square: (u64, u64) },
}

impl RayMoment {
    fn of(met: &Met, o: Raw, d: Raw) -> Self {
        match (met.touch.time, met.feature.geometry) {
            (None, Geometry::Arc { centre, radius, .. }) => {
                let m = o.sub(Raw::of(centre));
                let square = sub128(mul64(usqr(radius as u32), d.len2()), sqr64(m.cross(d).unsigned_abs()));
                Self::Root { ahead: m.dot(d).unsigned_abs(), square }
            }
            (time, _) => Self::Part(time.unwrap_or(Time { num: 0, den: 1 })),
        }
    }

    /// Exact; `dd` is |d|^2, below 2^61.
    fn order(&self, other: &Self, dd: u64) -> Ordering {
        match (self, other) {
            (Self::Part(a), Self::Part(b)) => mul64(a.num, b.den).cmp(&mul64(b.num, a.den)),
            (Self::Root { ahead, square }, Self::Part(time)) => root_and_part(*ahead, *square, *time, dd),
            (Self::Part(time), Self::Root { ahead, square }) => root_and_part(*ahead, *square, *time, dd).reverse(),
            (Self::Root { ahead: a, square: s }, Self::Root { ahead: b, square: t }) => {
                if a < b {
                    roots(*b, *t, *a, *s).reverse()
                } else {
                    roots(*a, *s, *b, *t)
                }
            }
        }
    }
}

/// `(ahead - sqrt(square)) / dd` against `num / den`: `ahead den - dd num` against
/// `den sqrt(square)`, by squares below 2^244.
fn root_and_part(ahead: u64, square: (u64, u64), time: Time, dd: u64) -> Ordering {
    let (a, b) = (mul64(ahead, time.den), mul64(dd, time.num));
    if less128(a, b) {
        return Ordering::Less;
    }
    let x = sub128(a, b);
    product(x, x).cmp(&product(sqr64(time.den), square))
}

/// `a - sqrt(s)` against `b - sqrt(t)`, where `a >= b`.
///
/// With `c = a - b`, which is below 2^61, that is `c + sqrt(t)` against `sqrt(s)`:
/// `2 c sqrt(t)` against `s - t - c^2`.
fn roots(a: u64, s: (u64, u64), b: u64, t: (u64, u64)) -> Ordering {
    let c = a.wrapping_sub(b);
    if less128(s, t) {
        return Ordering::Greater;
    }
    let apart = sub128(s, t);
    if less128(apart, sqr64(c)) {
        return Ordering::Greater;
    }
    let rest = sub128(apart, sqr64(c));
    product(sqr64(c << 1), t).cmp(&product(rest, rest))
}

impl<S: SolidShape> RayWorld for ConvexSolids<'_, S> {
    type Scan<'w>
        = ConvexRayHits<'w, S>
    where
        Self: 'w;

    fn scan(&self, o: Raw, d: Raw, rules: RayRules) -> Self::Scan<'_> {
        self.hits(o, d, rules.inside)
    }
}

#[cfg(feature = "defmt")]
impl<S: SolidShape + defmt::Format> defmt::Format for ConvexRayHits<'_, S> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "ConvexRayHits of {}", self.all);
    }
}
