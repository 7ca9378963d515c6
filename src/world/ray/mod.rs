//! Rays through any level: questions, answers, and how a ray meets one piece of a surface.
//!
//! Whether a piece is hit is decided exactly, without root or division. The time is an exact
//! fraction, or a lower bound within an arc. This module also has the walk over the cells, and the
//! engine that finds the hits in order. The trait of the levels that a ray can meet is here too.

pub(in crate::world) mod scan;
#[cfg(test)]
mod tests;
pub(in crate::world) mod walk;
pub(in crate::world) mod world;

pub use crate::query::Inside;

use super::cell::Cell;
use super::level::{Feature, Geometry, normal};
use crate::error::{Quantity, RangeError};
use crate::num::{
    Axis, DOMAIN, Raw, Toi, Vec2, imul, less128, mul_div, mul64, root128_down, root128_up, sqr64, sub128, umul, usqr,
};

/// The rules of a ray.
///
/// A ray with only an [`Inside`] passes one-way edges.
///
/// ```
/// use tilesat::{Inside, world::RayRules};
/// assert_eq!(RayRules::from(Inside::Hit), RayRules { inside: Inside::Hit, one_way: false });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RayRules {
    /// The answer to a start inside the solid.
    pub inside: Inside,
    /// Whether a one-way edge stops a ray that moves against its normal, ends included, also if the
    /// ray starts on the edge. From behind, a ray always passes.
    pub one_way: bool,
}

impl From<Inside> for RayRules {
    fn from(inside: Inside) -> Self {
        Self { inside, one_way: false }
    }
}

/// The hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias = "RaycastHit")]
pub struct RayHit {
    /// The fraction of the motion at the hit, 0 to 1. On straight faces and at the ends of arcs it
    /// is the exact one, rounded down to a multiple of 2^-30.
    ///
    /// Within an arc it is a lower bound. It is early by less than one raw unit of travel for
    /// motions up to 4096 units, and by less than four for any.
    pub toi: Toi,
    /// The point of the hit, rounded to the free side of the piece that was hit.
    ///
    /// On a straight face, each coordinate is less than one raw off. It is rounded toward the
    /// start, or away from it if the normal is on that side. So along a face's axis it is exact. On
    /// an arc it is the point of `toi`, rounded away from the solid.
    pub point: Vec2,
    /// The outward normal of the piece that was hit, reduced; for the face of a block it is a unit
    /// axis. Within an arc it is the vector from the centre to `point`, reversed if the arc is
    /// concave. See [`TileMap::cast_ray`](crate::world::TileMap::cast_ray) for corners and starts
    /// inside.
    pub axis: Axis,
    /// The cell to which the piece belongs. If the border of a map of blocks is repeated
    /// ([`Outside::Edge`](crate::world::Outside::Edge)), it is the border cell. For a
    /// [solid](crate::world::Solids) it holds the key: see [`solid`](Self::solid).
    pub cell: Cell,
    /// The piece of that cell, as [`Feature::index`](crate::world::Feature::index); 0 for a start
    /// inside.
    pub index: u16,
    /// The user flags of the tile or segment.
    pub flags: u8,
    /// Whether it is a one-way face.
    pub one_way: bool,
    /// The level of a pair, as [`Feature::source`](crate::world::Feature::source).
    pub source: u8,
    /// Whether the ray started inside the solid; only with [`Inside::Hit`].
    pub inside: bool,
    /// The work of the ray: the number of cells entered, the first and the last one included. For
    /// [`Solids`](crate::world::Solids) and [`ConvexSolids`](crate::world::ConvexSolids), the
    /// number of solids examined.
    pub cells: u32,
}

impl RayHit {
    /// The key of the moving solid that was hit: a [`Solid`](crate::Solid) or a
    /// [`ConvexSolid`](crate::world::ConvexSolid); `None` for a tile or a segment.
    ///
    /// In a [joined](crate::Joined) level, [`source`](Self::source) distinguishes two lists.
    ///
    /// ```
    /// use tilesat::{Aabb, Inside, Joined, Solid, Solids, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("   \n###", &KINDS)?;
    /// let lift = [Solid::new(Aabb::new(Vec2::from_ints(16, 8), Vec2::from_ints(32, 12))?, 7)?];
    /// let solids = Solids::new(&lift);
    /// let level = Joined::new(&level, &solids);
    /// let below = |x| level.cast_ray(Vec2::from_ints(x, 0), Vec2::from_ints(0, 20), Inside::Hit);
    /// assert_eq!(below(20)?.map(|hit| hit.solid()), Some(Some(7)));
    /// assert_eq!(below(8)?.map(|hit| hit.solid()), Some(None)); // the floor
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn solid(&self) -> Option<u16> {
        self.cell.solid()
    }
}

/// The start and the motion of a ray, if both ends are in the domain.
pub(in crate::world) const fn checked(origin: Vec2, motion: Vec2) -> Result<(Raw, Raw), RangeError> {
    let (o, d) = (Raw::of(origin), Raw::of(motion));
    let end = o.add(d);
    if in_domain(o.x) && in_domain(o.y) && in_domain(end.x) && in_domain(end.y) {
        Ok((o, d))
    } else {
        Err(refusal(o, d))
    }
}

#[inline]
pub(in crate::world) const fn in_domain(v: i32) -> bool {
    v > -DOMAIN && v < DOMAIN
}

/// Which of the four numbers is outside.
#[cold]
#[inline(never)]
pub(in crate::world) const fn refusal(o: Raw, d: Raw) -> RangeError {
    if !in_domain(o.x) {
        RangeError { what: Quantity::X, value: o.x }
    } else if !in_domain(o.y) {
        RangeError { what: Quantity::Y, value: o.y }
    } else if !in_domain(o.x.wrapping_add(d.x)) {
        RangeError { what: Quantity::EndX, value: o.x.saturating_add(d.x) }
    } else {
        RangeError { what: Quantity::EndY, value: o.y.saturating_add(d.y) }
    }
}

/// The kinds of pieces that a level can have.
pub(in crate::world) trait RayPieces {
    /// Whether times of faces can be fractions of more than words; see [`Time`].
    const WIDE: bool;
    /// Whether there can be arcs. Every other piece of a cell with an arc is on the cell's border.
    const ROUND: bool;
}

/// A fraction of a motion, `num / den` with `num <= den` and `den > 0`.
///
/// On tiles both are words: slopes are (1, 1), (1, 2) and (2, 1), so they are below 3 * 2^30. On
/// free segments they are below 2^61.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Time {
    pub(in crate::world) num: u64,
    pub(in crate::world) den: u64,
}

impl Time {
    /// Whether this is less than `rhs`, exactly.
    #[inline]
    pub(in crate::world) fn before<L: RayPieces>(self, rhs: Self) -> bool {
        if L::WIDE {
            less128(mul64(self.num, rhs.den), mul64(rhs.num, self.den))
        } else {
            umul(self.num as u32, rhs.den as u32) < umul(rhs.num as u32, self.den as u32)
        }
    }
}

/// How a piece is met.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Touch {
    /// `None` for a point within an arc, which is no fraction in general.
    pub(in crate::world) time: Option<Time>,
    /// The outward normal, reduced; of a point within an arc the zero axis.
    pub(in crate::world) normal: Axis,
}

/// A piece that is met, and how.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Met {
    pub(in crate::world) feature: Feature,
    pub(in crate::world) touch: Touch,
}

impl Touch {
    /// Whether a ray meets a piece at its start; not for a point within an arc.
    #[inline]
    pub(in crate::world) fn is_at_start(&self) -> bool {
        self.time.is_some_and(|time| time.num == 0)
    }

    /// Whether a ray by `d` meets the piece `of` before another one, or at the same moment and wins
    /// over it.
    ///
    /// A point within an arc is later than any fraction that a ray meets in the same step. The
    /// tile's other pieces are on the border of its cell, and the ray meets them where it comes in.
    /// (A face on the border opposes rays that enter across it. One that is met where the ray
    /// leaves is met by a ray that has a single point in the cell.)
    pub(in crate::world) fn precedes<L: RayPieces>(&self, of: &Feature, other: &Met, d: Raw) -> bool {
        let (Some(a), Some(b)) = (self.time, other.touch.time) else { return self.time.is_some() };
        if a.before::<L>(b) {
            return true;
        }
        !b.before::<L>(a) && self.ranks_above(of, other, d)
    }

    /// Whether this hit wins over another one at the same moment. The normal that is more along x
    /// wins, then the one that opposes the motion more, then +x, then +y. Then a straight piece
    /// wins over a round one.
    #[inline(never)]
    pub(in crate::world) fn ranks_above(&self, of: &Feature, other: &Met, d: Raw) -> bool {
        let (n, m) = (self.normal, other.touch.normal);
        // n.x^2 / |n|^2 is decreasing in |n.y| / |n.x|; the products are below 2^60.
        let (a, b) = (cross_size(n.y, m.x), cross_size(m.y, n.x));
        if a != b {
            return a < b;
        }
        // If the shares of reduced axes are equal, so are their components except for signs, and
        // their lengths.
        if n != m {
            // The motion against a normal is below 2^61.
            let (by_n, by_m) = (d.dot(Raw { x: n.x, y: n.y }), d.dot(Raw { x: m.x, y: m.y }));
            return by_n < by_m || (by_n == by_m && (n.x > m.x || (n.x == m.x && n.y > m.y)));
        }
        matches!(other.feature.geometry, Geometry::Arc { .. }) && matches!(of.geometry, Geometry::Face { .. })
    }
}

fn cross_size(a: i32, b: i32) -> u64 {
    umul(a.unsigned_abs(), b.unsigned_abs())
}

/// How a ray from `o` by `d` meets a piece, if it does.
///
/// Vertices are ends of other pieces, which are closed.
#[inline]
pub(in crate::world) fn meet<L: RayPieces>(o: Raw, d: Raw, feature: &Feature) -> Option<Touch> {
    match &feature.geometry {
        Geometry::Face { a, dir, len, .. } => meet_face(o.sub(Raw::of(*a)), d, *dir, *len),
        Geometry::Arc { centre, radius, quadrant, convex } if L::ROUND => {
            meet_arc(o.sub(Raw::of(*centre)), d, *radius, *quadrant, *convex)
        }
        _ => None,
    }
}

/// When a ray from `w` (relative to the start of the face) crosses the closed face against its
/// normal `(dir.y, -dir.x)`.
///
/// At the moment T = (w x dir) / (dir x d) it is at the place s = (w x d) / (dir x d) along dir.
/// The face is `e = dir len` long, so s <= len is w x d <= e x d. Differences and motions are below
/// 2^30 and `e` is a difference: all products are below 2^61.
#[inline(never)]
fn meet_face(w: Raw, d: Raw, dir: Axis, len: i32) -> Option<Touch> {
    let t = Raw { x: dir.x, y: dir.y };
    let den = t.cross(d);
    if den <= 0 {
        return None;
    }
    let num = w.cross(t);
    if num < 0 || num > den {
        return None;
    }
    let place = w.cross(d);
    let end = Raw { x: dir.x.wrapping_mul(len), y: dir.y.wrapping_mul(len) };
    if place < 0 || place > end.cross(d) {
        return None;
    }
    let time = Time { num: num as u64, den: den as u64 };
    Some(Touch { time: Some(time), normal: normal(dir) })
}

/// How a ray from `m` (relative to the centre) by `d` meets the closed quarter in the quadrant of
/// `q` from its free side. That is the entry into the disc if it is `convex`, else the exit from
/// it.
///
/// Tangents do not meet a convex arc. They leave a concave one where they start on it. They also
/// leave it where they come along the line on which it ends and continue into its cell.
///
/// Radii are at most 2^24, components below 2^30: squares of cross products, and r^2 |d|^2, are
/// below 2^122.
#[inline(never)]
fn meet_arc(m: Raw, d: Raw, radius: i32, q: Axis, convex: bool) -> Option<Touch> {
    let (m, d) = (turned(m, q), turned(d, q));
    let r = radius as u32;
    let rr = usqr(r);
    let outside = m.len2() >= rr;
    let on_rim = m.len2() == rr;
    let end_square = m.add(d).len2();
    let (b, a) = (m.dot(d).wrapping_neg(), d.len2());
    // The moment of the closest approach is b / a.
    let approaches = b > 0;
    let passes = approaches && b as u64 <= a;
    let happens = if convex {
        outside && approaches && (passes || end_square <= rr)
    } else {
        end_square >= rr && a != 0 && (!outside || on_rim || passes)
    };
    if !happens {
        return None;
    }
    if !convex && on_rim && !approaches {
        return (m.x >= 0 && m.y >= 0).then(|| touch_at(0, 1, inward(m, q)));
    }
    let cross = m.cross(d);
    if !less128(sqr64(cross.unsigned_abs()), mul64(rr, a)) {
        return if convex { None } else { along_the_end(m, d, radius, q) };
    }
    let at_x = sign_at(m.x, d.x, d.y, cross, radius, convex);
    let at_y = sign_at(m.y, d.y, d.x, cross.wrapping_neg(), radius, convex);
    if at_x < 0 || at_y < 0 {
        return None;
    }
    if at_x != 0 && at_y != 0 {
        return Some(Touch { time: None, normal: Axis::new(0, 0) });
    }
    let end = if at_x == 0 { Raw { x: 0, y: radius } } else { Raw { x: radius, y: 0 } };
    Some(at_end(m, d, end, q, convex))
}

/// The contact at an end of the arc, which the ray passes.
fn at_end(m: Raw, d: Raw, end: Raw, q: Axis, convex: bool) -> Touch {
    let way = end.sub(m);
    let (num, den) = if d.x == 0 { (way.y, d.y) } else { (way.x, d.x) };
    let inward = inward(end, q);
    let normal = if convex { inward.reversed() } else { inward };
    touch_at(num.unsigned_abs(), den.unsigned_abs(), normal)
}

/// At a fraction of the motion: both below 2^30.
fn touch_at(num: u32, den: u32, normal: Axis) -> Touch {
    Touch { time: Some(Time { num: u64::from(num), den: u64::from(den) }), normal }
}

/// A ray that touches a concave arc at its end along the cell's side hits it if it continues into
/// the cell.
fn along_the_end(m: Raw, d: Raw, r: i32, q: Axis) -> Option<Touch> {
    let reaches = |v: i32, d: i32| d > 0 && v <= 0 && v.wrapping_add(d) >= 0;
    if m.x == r && d.x == 0 && reaches(m.y, d.y) {
        Some(at_end(m, d, Raw { x: r, y: 0 }, q, false))
    } else if m.y == r && d.y == 0 && reaches(m.x, d.x) {
        Some(at_end(m, d, Raw { x: 0, y: r }, q, false))
    } else {
        None
    }
}

/// A vector in the frame where the arc's quadrant is that of positive coordinates, and back.
fn turned(v: Raw, q: Axis) -> Raw {
    Raw { x: v.x.wrapping_mul(q.x), y: v.y.wrapping_mul(q.y) }
}

/// The direction from a point on the arc toward the centre, of one axis where it is an end.
fn inward(m: Raw, q: Axis) -> Axis {
    let v = turned(m, q);
    if v.x == 0 || v.y == 0 { Axis::new(v.x.signum(), v.y.signum()).reversed() } else { Axis::new(v.x, v.y).reversed() }
}

/// The sign of the coordinate u at the moment T at which the ray crosses the circle, inward for
/// `entry`, else outward.
///
/// `u` runs from `u0` by `p`, the other coordinate by `q`. At the moment s with u = 0 the other one
/// is -cross/p. Against the radius that is |cross| ? r |p|, in 64 bits. The ray approaches the
/// centre then iff cross p q > 0.
///
/// Outside of the disc at s: T > s while approaching, else T < s. Inside: the entry is before s,
/// the exit after it. On the rim: s is the entry while approaching, else the exit.
fn sign_at(u0: i32, p: i32, q: i32, cross: i64, r: i32, entry: bool) -> i32 {
    if p == 0 {
        return u0.signum();
    }
    let (distance, rim) = (cross.unsigned_abs(), imul(r, p).unsigned_abs());
    let approaching = (cross > 0) == ((p > 0) == (q > 0)) && cross != 0 && q != 0;
    let after = if distance > rim {
        if approaching { 1 } else { -1 }
    } else if distance < rim {
        if entry { -1 } else { 1 }
    } else if approaching == entry {
        0
    } else if entry {
        -1
    } else {
        1
    };
    if p > 0 { after } else { -after }
}

/// When and where a ray meets an arc within it, if [`meet_arc`] says that it does. The time is a
/// lower bound; the displacement from the start is rounded to the free side.
#[inline(never)]
pub(in crate::world) fn arc_contact(m: Raw, d: Raw, radius: i32, convex: bool) -> (Toi, Raw) {
    let toi = time(m, d, radius as u32, convex);
    (toi, Raw { x: toi.of_raw_beside(m.x, d.x, convex), y: toi.of_raw_beside(m.y, d.y, convex) })
}

/// T = (b -+ root) / a, with root = sqrt(r^2 a - cross^2) and b = -m.d. For the entry that is c /
/// (b + root) with c = |m|^2 - r^2, which has no cancellation. For the exit it is (b + root) / a.
/// If b < 0 (from inside, moving away from the centre), it is -c / (root - b).
///
/// Numerators are rounded down, denominators up, in 31 bits. With the quotient's floor, T is early
/// by less than 3 parts in 2^30 of the motion. If all numbers are smaller, the root is off by less
/// than one. For the entry, T is then off by c / (b + root)^2, and c <= b^2 / |d|^2, so by 1 / |d|
/// of distance. For the exit it is as much. Together that is less than a raw unit of distance for
/// motions up to 4096 units.
fn time(m: Raw, d: Raw, r: u32, convex: bool) -> Toi {
    let (rr, a) = (usqr(r), d.len2());
    let square = sub128(mul64(rr, a), sqr64(m.cross(d).unsigned_abs()));
    let b = m.dot(d).wrapping_neg();
    let (num, den) = if convex || b < 0 {
        (m.len2().abs_diff(rr), b.unsigned_abs().wrapping_add(root128_up(square)))
    } else {
        ((b as u64).wrapping_add(root128_down(square)), a)
    };
    let shift = (64 - den.leading_zeros()).saturating_sub(31);
    // Only a shift drops bits that must be corrected.
    let den = ((den >> shift) as u32).wrapping_add(u32::from(shift != 0));
    let num = ((num >> shift) as u32).min(den);
    Toi::clamped(mul_div(num, Toi::ONE.raw(), den))
}
