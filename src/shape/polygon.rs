//! A convex polygon of a few corners.

use super::Aabb;
use crate::error::{PolygonError, RangeError};
use crate::num::{Fx, Raw, Vec2, check_coordinate, check_radius};

/// A convex polygon with room for `N` corners, square or rounded.
///
/// Corners are exact, and are kept in one canonical order. It is counter-clockwise (y up, that is
/// positive [`perp_dot`](Vec2::perp_dot) from side to side), from the lowest y and there the lowest
/// x. So polygons with equal points are equal, whatever order the points were given in.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Circle, ConvexPolygon, Vec2, fx};
/// const ROCK: ConvexPolygon<5> = match ConvexPolygon::new(&[
///     Vec2::from_ints(0, 0),
///     Vec2::from_ints(20, 0),
///     Vec2::from_ints(26, 10),
///     Vec2::from_ints(10, 18),
/// ]) {
///     Ok(rock) => rock,
///     Err(_) => panic!("it is convex"),
/// };
/// let ball = Circle::new(Vec2::from_ints(-3, 9), fx!(5))?;
/// assert!(!ROCK.overlaps(&ball));
/// assert!(ROCK.with_radius(fx!(4))?.overlaps(&ball));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("PolygonShape", "Polygon"))]
pub struct ConvexPolygon<const N: usize> {
    /// Those beyond `count` are zero.
    points: [Vec2; N],
    count: usize,
    radius: Fx,
}

impl<const N: usize> ConvexPolygon<N> {
    /// A polygon without corners, which fills a list before it is written.
    pub(super) const EMPTY: Self = Self { points: [Vec2::ZERO; N], count: 0, radius: Fx::ZERO };

    /// A polygon from its corners in order, clockwise or counter-clockwise.
    ///
    /// ```
    /// use tilesat::{ConvexPolygon, Vec2, error::PolygonError};
    /// let p = [(0, 0), (8, 0), (8, 8), (4, 3)].map(Vec2::from);
    /// assert_eq!(ConvexPolygon::<4>::new(&p), Err(PolygonError::Reflex { at: 3 }));
    /// assert_eq!(ConvexPolygon::<3>::hull(&p)?.vertices(), &p[..3]);
    /// # Ok::<(), PolygonError>(())
    /// ```
    ///
    /// # Errors
    /// [`PolygonError`]: fewer than three or more than `N` corners, or a path that winds around
    /// twice. Also if a corner is outside of the [domain](crate::num::DOMAIN), repeated, or on a
    /// line with its neighbours. Also if a corner turns in the other direction than the first.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loops")]
    pub const fn new(corners: &[Vec2]) -> Result<Self, PolygonError> {
        let n = corners.len();
        if n < 3 {
            return Err(PolygonError::TooFew { count: n });
        }
        if n > N {
            return Err(PolygonError::TooMany { capacity: N });
        }
        if let Err(e) = check_all(corners) {
            return Err(e);
        }
        let (mut i, mut lowest, mut low, mut first_turn, mut rises) = (0, 0, Raw::of(corners[0]), 0, 0);
        while i < n {
            let (p, q, r) = (Raw::of(corners[i]), Raw::of(corners[(i + 1) % n]), Raw::of(corners[(i + 2) % n]));
            let (e, f) = (q.sub(p), r.sub(q));
            if e.is_zero() {
                return Err(PolygonError::Repeated { at: (i + 1) % n });
            }
            let turn = e.cross(f).signum();
            if turn == 0 {
                let back = f.is_zero();
                return Err(if back {
                    PolygonError::Repeated { at: (i + 2) % n }
                } else {
                    PolygonError::Collinear { at: (i + 1) % n }
                });
            }
            if first_turn == 0 {
                first_turn = turn;
            } else if turn != first_turn {
                return Err(PolygonError::Reflex { at: (i + 1) % n });
            }
            // A path that always turns one way winds as often as its sides come from the lower half
            // of directions to the upper.
            rises += (is_lower(e) && !is_lower(f)) as usize;
            if is_lower_point(p, low) {
                (lowest, low) = (i, p);
            }
            i += 1;
        }
        if rises != 1 {
            return Err(PolygonError::Winds { times: rises });
        }
        let (mut points, mut k) = ([Vec2::ZERO; N], 0);
        while k < n {
            points[k] = corners[if first_turn > 0 { lowest + k } else { lowest + n - k } % n];
            k += 1;
        }
        Ok(Self { points, count: n, radius: Fx::ZERO })
    }

    /// The exact convex hull of any points, in any order: the smallest convex polygon that holds
    /// them all.
    ///
    /// Points inside and on the sides are left out. Cost: a pair of products for each point and
    /// corner of the hull.
    ///
    /// # Errors
    /// [`PolygonError`]: a point outside of the [domain](crate::num::DOMAIN), no three points that
    /// are not on one line, or a hull of more than `N` corners.
    #[expect(clippy::indexing_slicing, reason = "bounded by the loops, and by the comparison with N")]
    #[doc(alias("convex hull", "gift wrapping"))]
    pub const fn hull(points: &[Vec2]) -> Result<Self, PolygonError> {
        let n = points.len();
        if let Err(e) = check_all(points) {
            return Err(e);
        }
        if n == 0 {
            return Err(PolygonError::TooFew { count: 0 });
        }
        let (mut i, mut lowest) = (0, Raw::of(points[0]));
        while i < n {
            let p = Raw::of(points[i]);
            if is_lower_point(p, lowest) {
                lowest = p;
            }
            i += 1;
        }
        // Gift wrapping: from each corner on to the point that has all others on its left. On a
        // tie, the farthest.
        let (mut out, mut count, mut here) = ([Vec2::ZERO; N], 0, lowest);
        loop {
            if count >= N {
                return Err(PolygonError::TooMany { capacity: N });
            }
            out[count] = here.vec2();
            count += 1;
            let (mut next, mut best, mut i) = (here, Raw::ZERO, 0);
            while i < n {
                let p = Raw::of(points[i]);
                let v = p.sub(here);
                let turn = best.cross(v);
                if turn < 0 || (turn == 0 && v.len2() > best.len2()) {
                    (next, best) = (p, v);
                }
                i += 1;
            }
            here = next;
            if here.sub(lowest).is_zero() {
                break;
            }
        }
        if count < 3 { Err(PolygonError::TooFew { count }) } else { Ok(Self { points: out, count, radius: Fx::ZERO }) }
    }

    /// This polygon with a radius around it.
    ///
    /// Corners become round, and every side moves out by `radius`.
    ///
    /// # Errors
    /// [`RangeError`] if the radius is negative or leads out of the [domain](crate::num::DOMAIN).
    #[doc(alias("dilate", "expand", "rounded"))]
    pub const fn with_radius(self, radius: Fx) -> Result<Self, RangeError> {
        if let Err(e) = check_radius(radius) {
            return Err(e);
        }
        let (bounds, r) = (Self { radius: Fx::ZERO, ..self }.aabb(), radius.to_bits());
        // Below 2^30.
        let r = Raw { x: r, y: r };
        match Aabb::new(bounds.lo().sub(r).vec2(), bounds.hi().add(r).vec2()) {
            Ok(_) => Ok(Self { radius, ..self }),
            Err(e) => Err(e),
        }
    }

    /// The corners, counter-clockwise (y up) from the lowest one, without the radius.
    #[must_use]
    pub const fn vertices(&self) -> &[Vec2] {
        self.points.split_at(if self.count < N { self.count } else { N }).0
    }

    /// The radius around the corners, not negative.
    #[must_use]
    pub const fn radius(&self) -> Fx {
        self.radius
    }

    /// This polygon moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] if a point of it would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        match self.aabb().translated(by) {
            Ok(_) => Ok(self.moved_by(Raw::of(by))),
            Err(e) => Err(e),
        }
    }

    #[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
    pub(super) const fn moved_by(&self, by: Raw) -> Self {
        let (mut moved, mut i) = (*self, 0);
        while i < self.count && i < N {
            moved.points[i] = Raw::of(moved.points[i]).add(by).vec2();
            i += 1;
        }
        moved
    }

    /// The bounding box; exact.
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
    pub const fn aabb(&self) -> Aabb {
        let corners = self.vertices();
        let (mut lo, mut hi, mut i) = (Vec2::ZERO, Vec2::ZERO, 0);
        while i < corners.len() {
            lo = if i == 0 { corners[0] } else { lo.min(corners[i]) };
            hi = if i == 0 { corners[0] } else { hi.max(corners[i]) };
            i += 1;
        }
        let r = Raw { x: self.radius.to_bits(), y: self.radius.to_bits() };
        Aabb::from_raw_unchecked(Raw::of(lo).sub(r), Raw::of(hi).add(r))
    }
}

/// Whether all points are inside the domain.
#[expect(clippy::indexing_slicing, reason = "bounded by the loop")]
const fn check_all(points: &[Vec2]) -> Result<(), PolygonError> {
    let mut at = 0;
    while at < points.len() {
        if let Err(error) = check_coordinate(points[at]) {
            return Err(PolygonError::Range { at, error });
        }
        at += 1;
    }
    Ok(())
}

/// Whether a direction is in the lower half of the circle: the angles from a half turn on.
const fn is_lower(e: Raw) -> bool {
    e.y < 0 || (e.y == 0 && e.x < 0)
}

const fn is_lower_point(p: Raw, than: Raw) -> bool {
    p.y < than.y || (p.y == than.y && p.x < than.x)
}
