//! Rays against a list of boxes.
//!
//! Each hit is a search of all boxes for the earliest face after the last hit. A face is visible
//! where the points just in front of it are in no other box, ends included. So a ray meets the
//! surface of the union. The crossing is a fraction, compared by products.

use super::Solids;
use super::features::{PieceSet, faces_against, full, in_front, quadrants, quadrants_of};
use super::solid::Solid;
use crate::error::RangeError;
use crate::num::{Raw, Vec2, imul};
use crate::world::joined::hidden::{Beside, PartPath};
use crate::world::ray::scan::{ScanHit, hit_of, start_inside, straight};
use crate::world::ray::world::{RayScan, RayWorld, rays};
use crate::world::ray::{Inside, Met, RayHit, RayPieces, RayRules, Time, checked, meet};

impl RayPieces for Solids<'_> {
    const WIDE: bool = false;
    const ROUND: bool = false;
}

impl<'a> Solids<'a> {
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
    ) -> Result<SolidRayHits<'a>, RangeError> {
        let (o, d) = checked(origin, motion)?;
        Ok(self.hits(o, d, rules.into()))
    }

    const fn hits(&self, o: Raw, d: Raw, rules: RayRules) -> SolidRayHits<'a> {
        SolidRayHits { all: *self, o, d, rules, after: None, started: false, cells: 0 }
    }
}

rays! {
    [] Solids<'_> {
        /// The first point of the closed solids at their current positions that a ray from `origin`
        /// along `motion` meets, or `None` if it ends before.
        ///
        /// Every decision is exact, by the rules of [`TileMap::cast_ray`](crate::TileMap::cast_ray)
        /// for the union of the boxes. A ray along a seam of two flush boxes is inside them. The
        /// [`cell`](RayHit::cell) of the hit names the solid: see [`Solids::key_of`]. If several
        /// have the same face there, it is the one with the smallest key, solid ones before
        /// [one-way](Solid::with_one_way) ones.
        ///
        /// Cost: two comparisons of fractions for each box, and a look at all boxes for each face
        /// that may be the first.
        ///
        /// ```
        /// use tilesat::{Aabb, Axis, Inside, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
        /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        /// let level = TileMap::from_ascii("   #", &KINDS)?;
        /// let door = [Solid::new(Aabb::new(Vec2::from_ints(20, 0), Vec2::from_ints(24, 16))?, 3)?];
        /// let (solids, ray) = (Solids::new(&door), (Vec2::from_ints(4, 8), Vec2::from_ints(90, 0)));
        /// let hit = Joined::new(&level, &solids).cast_ray(ray.0, ray.1, Inside::Hit)?.unwrap(); // a shot at the door
        /// assert_eq!((hit.point, hit.axis, hit.source), (Vec2::from_ints(20, 8), Axis::NEG_X, 1));
        /// assert_eq!(Solids::key_of(hit.cell), Some(3));
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if the start or the end is outside the [domain](crate::num::DOMAIN).
        cast_ray,
        /// Whether the straight line from `a` to `b` is free of the solids and does not start
        /// inside.
        ///
        /// A line that ends on a surface is blocked; one that starts there is not. One-way solids
        /// do not block it.
        ///
        /// ```
        /// use tilesat::{Aabb, Solid, Solids, Vec2};
        /// let door = [Solid::new(Aabb::new(Vec2::from_ints(20, 0), Vec2::from_ints(24, 16))?, 3)?];
        /// let sees = |x, y| Solids::new(&door).line_of_sight(Vec2::from_ints(4, 8), Vec2::from_ints(x, y));
        /// assert!(sees(18, 8)? && !sees(40, 8)? && sees(40, 40)?); // before, behind, and past it
        /// # Ok::<(), tilesat::RangeError>(())
        /// ```
        ///
        /// # Errors
        /// [`RangeError`] if a point is outside the [domain](crate::num::DOMAIN).
        line_of_sight,
    }
}

/// The hits of a ray in order; see [`Solids::cast_ray_all`].
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct SolidRayHits<'w> {
    pub(crate) all: Solids<'w>,
    o: Raw,
    d: Raw,
    rules: RayRules,
    /// The moment of the last hit.
    after: Option<Time>,
    started: bool,
    cells: u32,
}

impl Iterator for SolidRayHits<'_> {
    type Item = RayHit;

    fn next(&mut self) -> Option<RayHit> {
        self.find().map(|found| found.hit)
    }
}

impl SolidRayHits<'_> {
    pub(in crate::world) fn find(&mut self) -> Option<ScanHit> {
        self.cells = self.cells.saturating_add(self.all.list().len() as u32);
        if !self.started {
            self.started = true;
            let inside = if matches!(self.rules.inside, Inside::Hit) { self.at_start() } else { None };
            if let Some(hit) = inside {
                return Some(ScanHit { hit, met: None });
            }
        }
        let goes_in = self.goes_in();
        let mut best: Option<(Met, Time)> = None;
        for solid in self.all.list() {
            if solid.one_way().is_some() && !self.rules.one_way {
                continue;
            }
            let faces = solid.pieces() & faces_against(self.d);
            for k in (0..4).filter(|k| faces >> k & 1 != 0) {
                let feature = solid.piece(k, [false; 2]);
                let Some(touch) = meet::<Solids<'_>>(self.o, self.d, &feature) else { continue };
                let Some(time) = touch.time else { continue };
                let met = Met { feature, touch };
                // At the start, solid pieces are met only where the ray goes into the solid.
                let passed = self.after.is_some_and(|after| !after.before::<Solids<'_>>(time));
                let leaves = time.num == 0 && !feature.one_way && !goes_in;
                if !passed
                    && !leaves
                    && best.is_none_or(|(b, _)| precedes(&met, &b, self.d))
                    && self.shows(solid, k, time)
                {
                    best = Some((met, time));
                }
            }
        }
        let (met, time) = best?;
        self.after = Some(time);
        let (toi, by, axis) = straight::<Solids<'_>>(self.d, time, met.touch.normal);
        Some(ScanHit { hit: hit_of(&met.feature, (toi, self.o.add(by), axis), self.cells), met: Some(met) })
    }

    /// Whether a face is part of the union's surface where the ray crosses it: its front is free
    /// beside that point, on either side.
    ///
    /// Differences and motions are below 2^30, and so are times: products are below 2^60.
    fn shows(&self, solid: &Solid, k: u8, time: Time) -> bool {
        let (o, d, lo, hi) = if k & 1 == 0 {
            (self.o.x, self.d.x, solid.lo().x, solid.hi().x)
        } else {
            (self.o.y, self.d.y, solid.lo().y, solid.hi().y)
        };
        let way = imul(d, time.num as i32);
        // Position along the face, relative to the crossing.
        let side = |place: i32| imul(place.wrapping_sub(o), time.den as i32).wrapping_sub(way);
        let (mut before, mut behind) = (side(lo) < 0, side(hi) > 0);
        for (from, to) in full(self.all.list()).filter_map(|other| in_front(solid, k, other)) {
            let (from, to) = (side(from), side(to));
            before &= !(from < 0 && to >= 0);
            behind &= !(from <= 0 && to > 0);
        }
        before || behind
    }

    /// The hit of a start inside: that of the box that holds it, or of those that meet there if
    /// none holds it alone.
    fn at_start(&self) -> Option<RayHit> {
        if quadrants(self.all.list(), self.o) != 0xf {
            return None;
        }
        let beside = full(self.all.list()).filter(|solid| quadrants_of(solid, self.o) != 0);
        let solid = beside.min_by_key(|solid| (quadrants_of(solid, self.o) != 0xf, solid.key()))?;
        Some(start_inside(self.o, self.d, (solid.cell(), solid.flags()), self.cells))
    }
}

/// The earlier hit wins, then the order of all rays, then solid before one-way, then the smaller
/// key. So no result depends on the list's order.
fn precedes(a: &Met, b: &Met, d: Raw) -> bool {
    let name = |met: &Met| (met.feature.one_way, Solids::key_of(met.feature.cell));
    let before = |a: &Met, b: &Met| a.touch.precedes::<Solids<'_>>(&a.feature, b, d);
    before(a, b) || (!before(b, a) && name(a) < name(b))
}

impl RayWorld for Solids<'_> {
    type Scan<'w>
        = SolidRayHits<'w>
    where
        Self: 'w;

    fn scan(&self, o: Raw, d: Raw, rules: RayRules) -> Self::Scan<'_> {
        self.hits(o, d, rules)
    }

    /// Each box is a part: another one may cover a part of its face.
    fn parts(&self, path: PartPath, visit: &mut dyn FnMut(PartPath, &dyn Beside)) {
        for (index, solid) in (0..).zip(self.list()) {
            visit(path.of_item(index), &Solids::new(core::slice::from_ref(solid)));
        }
    }
}

impl RayScan for SolidRayHits<'_> {
    fn next_found(&mut self) -> Option<ScanHit> {
        self.find()
    }

    /// Whether the ray is strictly inside just after its start: in all the quadrants that it is
    /// next to.
    fn goes_in(&self) -> bool {
        let next_to = |v: i32, more: PieceSet, less: PieceSet| match v.signum() {
            1 => more,
            -1 => less,
            _ => 0xf,
        };
        let (x, y) = (next_to(self.d.x, 0b0110, 0b1001), next_to(self.d.y, 0b1100, 0b0011));
        x & y & !quadrants(self.all.list(), self.o) == 0
    }
}
