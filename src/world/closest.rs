//! The point of a level's surface that is nearest to a point.

use super::joined::Joined;
use super::level::{Feature, Geometry, World, ends, in_quadrant, normal, precedes, raw};
use super::measure::Measure;
use super::placed::Placed;
use super::segment_map::SegmentMap;
use super::solids::Solids;
use super::solids::convex::ConvexSolids;
use super::solids::convex_solid::SolidShape;
use super::tile_map::{ShapeSet, Store, TileMap};
use crate::error::RangeError;
use crate::num::{
    Axis, DOMAIN, Fx, Raw, Vec2, check_coordinate, check_radius, div_sqrt, isqrt64, isqrt64_ceil, toward, usqr,
};
use crate::query::closest::on_segment;
use crate::query::meet::{clamp, corners};
use crate::shape::Aabb;
use core::cmp::Ordering;

/// Whether one-way faces count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum OneWay {
    /// One-way faces are ignored.
    #[default]
    Ignore,
    /// One-way faces are surface only for points in front of them.
    Include,
}

/// The point of a level's surface that is nearest to a point; see [`TileMap::closest_point`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Near {
    /// The point, each component rounded to nearest.
    pub point: Vec2,
    /// How far away it is, rounded down.
    pub distance: Fx,
    /// Out of the solid at that point: a face's normal, or along the line between the two points.
    /// Not zero.
    pub axis: Axis,
    /// Whether the given point is in the inside of the solid; on the surface it is not.
    pub inside: bool,
    /// The piece of the surface. It is a face or an arc if the point is on it, or a corner if the
    /// given point is in its cone.
    pub feature: Feature,
    /// How many features were examined.
    pub features: u32,
}

/// The method of each kind of level, with its own words.
macro_rules! closest_point_of {
    ($(#[$doc:meta])* [$($parameters:tt)*] $level:ty) => {
        impl<$($parameters)*> $level {
            $(#[$doc])*
            pub fn closest_point(&self, p: Vec2, within: Fx, one_way: OneWay) -> Result<Option<Near>, RangeError> {
                closest_point(self, p, within, one_way)
            }
        }
    };
}

closest_point_of! {
    /// The point of the surface that is nearest to `p` and at most `within` units away.
    ///
    /// `p` may be outside or inside of the solid. Distances are compared exactly. In a tie, a face
    /// or arc with the foot of `p` on it comes first. A corner comes next, then the end of a face,
    /// then the piece with the smaller coordinates. The answer depends only on the level and the
    /// point.
    ///
    /// Cost: it searches squares around `p`. The half side starts at one cell and doubles until the
    /// nearest point is found, up to `within`. In total it examines at most twice the features of
    /// the last square, which has at most `(2 within / cell + 3)` squared cells. [`Near::features`]
    /// counts them. Within one cell of 24 units, if a quarter of the cells hold a shape, it takes
    /// some 10 000 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{AllShapes, Axis, Fx, Grid, TileKind, TileKinds, TileMap, TileShape, Vec2, world::OneWay};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'/', TileKind::of(TileShape::SlopeBottomRight));
    /// let grid = Grid::new(1, 1, Fx::from_num(16), Vec2::ZERO)?;
    /// let map = TileMap::<AllShapes>::of(b"/", grid, &KINDS)?;
    /// let near = map.closest_point(Vec2::from_ints(2, 4), Fx::from_num(10), OneWay::Ignore)?.unwrap();
    /// assert_eq!((near.point, near.axis, near.inside), (Vec2::from_ints(7, 9), Axis::new(-1, -1), false));
    /// assert_eq!(near.distance.to_bits(), 463_409); // 5 sqrt(2), rounded down
    /// assert_eq!(map.closest_point(Vec2::from_ints(2, 4), Fx::from_num(7), OneWay::Ignore)?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if `p` or `within` is outside the [domain](crate::num::DOMAIN), or `within`
    /// is negative.
    [S: ShapeSet, T: Store] TileMap<'_, S, T>
}

closest_point_of! {
    /// The point of the surface that is nearest to `p` and at most `within` away; as
    /// [`TileMap::closest_point`].
    ///
    /// From outside, walls are surface. From inside of polygons that overlap, the edges of one that
    /// lie in the other are surface, too.
    ///
    /// ```
    /// use tilesat::{Path, PathKind, Vec2, fx, segment_map, world::OneWay};
    /// const RAIL: [Vec2; 3] = [Vec2::from_ints(0, 40), Vec2::from_ints(60, 40), Vec2::from_ints(60, 90)];
    /// segment_map!(static LEVEL: [Path::new(PathKind::Wall, &RAIL)], fx!(32));
    /// let near = |x, y| LEVEL.closest_point(Vec2::from_ints(x, y), fx!(30), OneWay::Ignore);
    /// assert_eq!(near(50, 56)?.unwrap().point, Vec2::from_ints(60, 56));
    /// assert_eq!(near(63, 36)?.unwrap().distance, fx!(5)); // its corner
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`TileMap::closest_point`].
    [] SegmentMap<'_>
}

closest_point_of! {
    /// The point of the solids' borders at their current positions that is nearest to `p` and at
    /// most `within` units away; as [`TileMap::closest_point`].
    ///
    /// No border is one-way. From inside of solids that overlap, the border of one that lies in the
    /// other is surface, too.
    ///
    /// Cost: each piece of the solids whose box is within reach, once.
    ///
    /// ```
    /// use tilesat::world::{ConvexSolid, ConvexSolids, OneWay};
    /// use tilesat::{Circle, Vec2, fx};
    /// let bumper = [ConvexSolid::new(Circle::new(Vec2::from_ints(40, 8), fx!(5))?, 3)?];
    /// let near = ConvexSolids::new(&bumper).closest_point(Vec2::from_ints(34, 16), fx!(20), OneWay::Ignore)?.unwrap();
    /// assert_eq!((near.point, near.distance), (Vec2::from_ints(37, 12), fx!(5)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`TileMap::closest_point`].
    [S: SolidShape] ConvexSolids<'_, S>
}

closest_point_of! {
    /// The point of the solids' surface at their current positions that is nearest to `p` and at
    /// most `within` units away; as [`TileMap::closest_point`].
    ///
    /// [`Feature::cell`] names the solid: see [`Solids::key_of`].
    ///
    /// Cost: each face and corner of the solids whose box is within reach, and a look at all solids
    /// for each.
    ///
    /// ```
    /// use tilesat::{Aabb, Solid, Solids, Vec2, fx, world::OneWay};
    /// let door = [Solid::new(Aabb::new(Vec2::from_ints(20, 0), Vec2::from_ints(24, 16))?, 3)?];
    /// let near = Solids::new(&door).closest_point(Vec2::from_ints(12, 8), fx!(20), OneWay::Ignore)?.unwrap();
    /// assert_eq!((near.point, near.distance), (Vec2::from_ints(20, 8), fx!(8)));
    /// assert_eq!(Solids::key_of(near.feature.cell), Some(3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`TileMap::closest_point`].
    [] Solids<'_>
}

closest_point_of! {
    /// The point of the shifted level's surface that is nearest to `p` and at most `within` away;
    /// as [`TileMap::closest_point`] of the level itself, shifted.
    ///
    /// # Errors
    /// As [`TileMap::closest_point`].
    [W: World] Placed<'_, W>
}

closest_point_of! {
    /// The point of both surfaces that is nearest to `p` and at most `within` away; as
    /// [`TileMap::closest_point`].
    ///
    /// From inside of the solid, faces and arcs that the other level covers in part are surface as
    /// a whole.
    ///
    /// ```
    /// use tilesat::{Aabb, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2, fx, world::OneWay};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("...\n...\n###", &KINDS)?; // the floor is at y = 32
    /// let lift = [Solid::new(Aabb::from_size(Vec2::from_ints(36, 0), Vec2::from_ints(8, 24))?, 5)?];
    /// let hook = Vec2::from_ints(30, 16);
    /// let near = Joined::new(&level, &Solids::new(&lift)).closest_point(hook, fx!(20), OneWay::Ignore)?.unwrap();
    /// assert_eq!((near.point, near.feature.source), (Vec2::from_ints(36, 16), 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`TileMap::closest_point`].
    [A: World, B: World] Joined<'_, A, B>
}

/// [`TileMap::closest_point`] for any level.
pub(in crate::world) fn closest_point<W: World>(
    world: &W,
    p: Vec2,
    within: Fx,
    one_way: OneWay,
) -> Result<Option<Near>, RangeError> {
    check_coordinate(p)?;
    check_radius(within)?;
    let (p, limit) = (Raw::of(p), within.to_bits());
    let inside = world.overlaps_aabb(&Aabb::from_raw_unchecked(p, p));
    Ok(search(world, p, limit, one_way, inside))
}

/// Searches squares whose half side doubles, up to the limit.
fn search<W: World>(world: &W, p: Raw, limit: i32, one_way: OneWay, inside: bool) -> Option<Near> {
    let (mut reach, mut features) = (limit.min(world.cell_size() as i32), 0u32);
    loop {
        let (mut best, mut of) = (None, None);
        features =
            features.wrapping_add(find_nearest(world, &square(p, reach), p, one_way, inside, &mut best, &mut of));
        if let Some((spot, feature)) = best.as_ref().zip(of.as_ref()) {
            if spot.is_within::<W>(reach) {
                return Some(spot.near::<W>(p, inside, feature, features));
            }
        }
        if reach == limit {
            return None;
        }
        reach = limit.min(reach.saturating_mul(2));
    }
}

/// Finds the nearest feature of a region, or neither of the two. Returns the number of features
/// that it examined.
#[inline(never)]
fn find_nearest<W: World>(
    world: &W,
    region: &Aabb,
    p: Raw,
    one_way: OneWay,
    inside: bool,
    best: &mut Option<Spot>,
    of: &mut Option<Feature>,
) -> u32 {
    let (mut features, mut count) = (world.features(region), 0u32);
    while let Some(feature) = &features.next() {
        count = count.wrapping_add(1);
        if feature.one_way && one_way == OneWay::Ignore {
            continue;
        }
        let Some(spot) = &Spot::of::<W>(p, feature, inside) else { continue };
        let known = best.as_ref().zip(of.as_ref());
        if known.is_none_or(|(first, of)| spot.before::<W>(feature, first, of)) {
            (*best, *of) = (Some(*spot), Some(*feature));
        }
    }
    count
}

/// The part of a square in the domain, because there is no surface beyond it.
fn square(p: Raw, reach: i32) -> Aabb {
    let (last, add) = (DOMAIN - 1, |v: i32, by: i32| v.saturating_add(by));
    Aabb::from_raw_unchecked(
        Raw { x: add(p.x, -reach).max(-last), y: add(p.y, -reach).max(-last) },
        Raw { x: add(p.x, reach).min(last), y: add(p.y, reach).min(last) },
    )
}

/// The nearest point of one feature.
#[derive(Clone, Copy)]
struct Spot {
    measure: Measure,
    place: Preference,
}

/// Its position, in the order of preference.
#[derive(Clone, Copy)]
enum Preference {
    /// Between the ends of a face or arc, or at an end that the normal there leads to.
    Foot,
    Corner,
    /// The end of a face or arc, for a point beyond it.
    End(Raw),
}

impl Spot {
    /// `None` if the feature is not the nearest anyway.
    #[inline(never)]
    fn of<W: World>(p: Raw, feature: &Feature, inside: bool) -> Option<Self> {
        let found = |measure, place| Some(Self { measure, place });
        let end = |end: Raw| found(Measure::root(p.sub(end).len2()), Preference::End(end));
        match feature.geometry {
            Geometry::Face { a, dir, len, .. } => {
                let (a, b) = ends(Raw::of(a), dir, len);
                let m = p.sub(a);
                let (along, front) = (raw(dir).dot(m), raw(dir).cross(m).wrapping_neg());
                if feature.one_way && front < 0 {
                    None
                } else if along < 0 {
                    end(a)
                } else if along > raw(dir).dot(b.sub(a)) {
                    end(b)
                } else if front != 0 && !feature.one_way && (front < 0) != inside {
                    // From its wrong side a face is no nearer than the surface in front of it.
                    None
                } else {
                    found(Measure::height(front.unsigned_abs(), dir.length_squared()), Preference::Foot)
                }
            }
            Geometry::Vertex { p: corner, e_in, e_out } => {
                let m = p.sub(Raw::of(corner));
                let in_cone = raw(e_in).dot(m) >= 0 && raw(e_out).dot(m) <= 0;
                if in_cone && !inside { found(Measure::root(m.len2()), Preference::Corner) } else { None }
            }
            Geometry::Arc { centre, radius, quadrant, convex } if W::ROUND => {
                let centre = Raw::of(centre);
                let m = p.sub(centre);
                let square = m.len2();
                let side = square.cmp(&usqr(radius as u32));
                let wrong = side == if convex == inside { Ordering::Greater } else { Ordering::Less };
                if in_quadrant(m, quadrant) && !wrong {
                    return found(Measure::Ring { square, radius: radius as u32 }, Preference::Foot);
                }
                let (x, y) = (quadrant.x.wrapping_mul(radius), quadrant.y.wrapping_mul(radius));
                let (a, b) = (centre.add(Raw { x, y: 0 }), centre.add(Raw { x: 0, y }));
                end(if p.sub(b).len2() < p.sub(a).len2() { b } else { a })
            }
            Geometry::Arc { .. } => None,
        }
    }

    /// Whether the spot of feature `f` wins over another, of `g`.
    fn before<W: World>(&self, f: &Feature, other: &Self, g: &Feature) -> bool {
        let rank = |spot: &Self| match spot.place {
            Preference::Foot => 0,
            Preference::Corner => 1,
            Preference::End(_) => 2u8,
        };
        match self.measure.order::<W>(&other.measure).then(rank(self).cmp(&rank(other))) {
            Ordering::Equal => precedes(f, g),
            order => order == Ordering::Less,
        }
    }

    /// Whether it is no farther than the sides of a square, within which everything has been
    /// examined.
    #[inline(never)]
    fn is_within<W: World>(&self, reach: i32) -> bool {
        self.measure.order::<W>(&Measure::root(usqr(reach as u32))) != Ordering::Greater
    }

    /// The answer.
    #[inline(never)]
    fn near<W: World>(&self, p: Raw, inside: bool, feature: &Feature, features: u32) -> Near {
        let (point, axis) = self.point::<W>(p, inside, feature);
        let distance = Fx::from_bits(self.distance::<W>() as i32);
        Near { point: point.vec2(), distance, axis, inside, feature: *feature, features }
    }

    /// Its position, and the normal there.
    #[inline(never)]
    fn point<W: World>(&self, p: Raw, inside: bool, feature: &Feature) -> (Raw, Axis) {
        // Out of the solid along the line between the points.
        let outward = |m: Raw| {
            let m = Axis::new(m.x, m.y);
            if inside { m.reversed() } else { m }
        };
        match (feature.geometry, self.place) {
            (_, Preference::End(end)) => (end, outward(p.sub(end))),
            (Geometry::Face { a, dir, len, .. }, _) => {
                let (a, b) = ends(Raw::of(a), dir, len);
                let (lo, hi) = corners(a, b);
                let foot = if W::BLOCKS { clamp(p, lo, hi) } else { on_segment(p, a, b) };
                (foot, normal(dir))
            }
            (Geometry::Vertex { p: corner, e_in, .. }, _) => {
                let m = p.sub(Raw::of(corner));
                (Raw::of(corner), if m.is_zero() { normal(e_in) } else { Axis::new(m.x, m.y) })
            }
            (Geometry::Arc { centre, radius, quadrant, convex }, _) if W::ROUND => {
                let m = p.sub(Raw::of(centre));
                // From the centre all of the arc is equally near: takes its end along x.
                let m = if m.is_zero() { Raw { x: quadrant.x, y: 0 } } else { m };
                let axis = Axis::new(m.x, m.y);
                (Raw::of(centre).add(toward(m, radius)), if convex { axis } else { axis.reversed() })
            }
            // Such a level has none.
            (Geometry::Arc { centre, .. }, _) => (Raw::of(centre), Axis::X),
        }
    }

    /// How far away it is, rounded down.
    #[inline(never)]
    fn distance<W: World>(&self) -> u32 {
        match self.measure {
            Measure::Ring { square, radius } if W::ROUND && square < usqr(radius) => {
                radius.wrapping_sub(isqrt64_ceil(square))
            }
            Measure::Ring { square, radius } if W::ROUND => isqrt64(square).wrapping_sub(radius),
            Measure::Line { front, den } if !W::BLOCKS => div_sqrt(front, den),
            // The distance in a level without other features.
            Measure::Point { square } | Measure::Ring { square, .. } | Measure::Line { front: square, .. } => {
                isqrt64(square)
            }
        }
    }
}
