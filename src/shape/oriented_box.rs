//! A box in any direction.

use super::Aabb;
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, Fx, Raw, Vec2, check_coordinate, check_radius, toward};

/// A box in any direction, with square or rounded corners.
///
/// It keeps its centre and two half sides, each rounded **once**, at construction, to the nearest
/// raw vector. From then on it is exactly the parallelogram of its four [corners](Self::corners),
/// and every query is exact about that shape. A box along x and y is not rounded, and gives the
/// answers of an [`Aabb`]. A box without width or height is legal and acts as a segment or a point.
///
/// ```text
///            +
///         v / \           centre c, half sides u (along) and v (across)
///          /   \
///         + . c +         corners c - u - v, c + u - v, c + u + v, c - u + v
///          \   / u
///           \ /
///            +
/// ```
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Axis, OrientedBox, Vec2};
/// let half = Vec2::from_ints(10, 5);
/// let door = OrientedBox::new(Vec2::from_ints(20, 20), half, Axis::new(3, 4))?;
/// assert_eq!(door.along(), Vec2::from_ints(6, 8)); // 10 long in the direction (3, 4)
/// assert_eq!(door.across(), Vec2::from_ints(-4, 3));
/// let player = Aabb::new(Vec2::from_ints(26, 8), Vec2::from_ints(32, 16))?;
/// assert!(door.aabb().overlaps(&player) && !door.overlaps(&player));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("OBB", "rotated rectangle"))]
pub struct OrientedBox {
    centre: Vec2,
    along: Vec2,
    across: Vec2,
    radius: Fx,
}

impl OrientedBox {
    /// A box from its centre, half its size, and the direction of its first side.
    ///
    /// The length of the direction does not matter. `Axis::X` gives an upright box.
    /// [`Axis::from_turns`] and [`Axis::from_radians`] make a direction from an angle. Each
    /// component of a half side is rounded to nearest. So quarter turns and mirror images of the
    /// direction give turned and mirrored boxes bit for bit.
    ///
    /// # Errors
    /// [`RangeError`] if the direction is zero or has a component `i32::MIN`, a half extent is
    /// negative, or a corner is outside the [domain](crate::num::DOMAIN).
    pub const fn new(centre: Vec2, half: Vec2, direction: Axis) -> Result<Self, RangeError> {
        let h = Raw::of(half);
        if h.x < 0 || h.x >= DOMAIN {
            return Err(RangeError { what: Quantity::HalfExtent, value: h.x });
        }
        if h.y < 0 || h.y >= DOMAIN {
            return Err(RangeError { what: Quantity::HalfExtent, value: h.y });
        }
        if direction.is_zero() {
            return Err(RangeError { what: Quantity::Direction, value: 0 });
        }
        if !direction.has_opposite() {
            return Err(RangeError { what: Quantity::Direction, value: i32::MIN });
        }
        let d = Raw { x: direction.x, y: direction.y };
        let left = direction.perp();
        // Two sides that are not zero are never parallel after rounding: the larger component of
        // the direction is at least 0.7 of its length, so that of each side is at least 1 raw, and
        // u x v = |ux vy| + |uy vx| > 0.
        let (along, across) = (toward(d, h.x), toward(Raw { x: left.x, y: left.y }, h.y));
        Self { centre, along: along.vec2(), across: across.vec2(), radius: Fx::ZERO }.checked()
    }

    /// A box from half sides that were read from a saved state.
    ///
    /// The half sides of [`new`](Self::new) are a right angle apart, with each component rounded by
    /// half a raw unit. Their dot product is off by at most half the sum of the components, and
    /// half a unit. Two half sides that are not zero are never parallel.
    ///
    /// # Errors
    /// [`RangeError`]: `Direction` if no direction gives them, or a corner is outside of the
    /// [domain](crate::num::DOMAIN).
    #[cfg(feature = "serde")]
    pub(super) fn from_sides(centre: Vec2, along: Vec2, across: Vec2) -> Result<Self, RangeError> {
        let (u, v) = (Raw::of(along), Raw::of(across));
        for Raw { x, y } in [u, v] {
            for component in [x, y] {
                if component.unsigned_abs() >= DOMAIN.unsigned_abs() {
                    return Err(RangeError { what: Quantity::HalfExtent, value: component });
                }
            }
        }
        // Below 2^31 + 1, and below 2^61.
        let most = [u.x, u.y, v.x, v.y].iter().map(|c| u64::from(c.unsigned_abs())).sum::<u64>() + 1;
        let flat = u.is_zero() || v.is_zero();
        if u.dot(v).unsigned_abs() * 2 > most || !(flat || u.cross(v) > 0) {
            return Err(RangeError { what: Quantity::Direction, value: 0 });
        }
        Self { centre, along, across, radius: Fx::ZERO }.checked()
    }

    /// This box with a radius around it.
    ///
    /// Corners become round, and every side moves out by `radius`.
    ///
    /// ```
    /// use tilesat::{Axis, Circle, OrientedBox, Vec2, fx, prelude::*};
    /// let table = OrientedBox::new(Vec2::ZERO, Vec2::from_ints(4, 2), Axis::X)?.with_radius(fx!(1))?;
    /// let ball = Circle::new(Vec2::from_ints(6, 0), fx!(1))?;
    /// assert!(table.touches(&ball) && !table.overlaps(&ball));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the radius is negative or leads out of the [domain](crate::num::DOMAIN).
    #[doc(alias("dilate", "expand", "rounded"))]
    pub const fn with_radius(self, radius: Fx) -> Result<Self, RangeError> {
        if let Err(e) = check_radius(radius) {
            return Err(e);
        }
        Self { radius, ..self }.checked()
    }

    /// The outermost points in every direction: sums of three parts below 2^29 and one below 2^29,
    /// so below 2^31.
    const fn checked(self) -> Result<Self, RangeError> {
        if let Err(e) = check_coordinate(self.centre) {
            return Err(e);
        }
        let (c, reach) = (Raw::of(self.centre), self.reach());
        let far = Vec2::from_raw(
            if c.x < 0 { c.x - reach.x } else { c.x + reach.x },
            if c.y < 0 { c.y - reach.y } else { c.y + reach.y },
        );
        match check_coordinate(far) {
            Ok(()) => Ok(self),
            Err(e) => Err(e),
        }
    }

    /// Half the size of the bounding box; below 2^30 + 2^29.
    const fn reach(&self) -> Raw {
        let (u, v, r) = (Raw::of(self.along), Raw::of(self.across), self.radius.to_bits());
        Raw { x: u.x.abs() + v.x.abs() + r, y: u.y.abs() + v.y.abs() + r }
    }

    /// The middle.
    #[must_use]
    #[doc(alias = "center")]
    pub const fn centre(&self) -> Vec2 {
        self.centre
    }

    /// Half of the first side, as a vector in the box's direction.
    #[must_use]
    pub const fn along(&self) -> Vec2 {
        self.along
    }

    /// Half of the second side, a right angle counter-clockwise (y up) of the first one, within
    /// rounding.
    #[must_use]
    pub const fn across(&self) -> Vec2 {
        self.across
    }

    /// The radius around the corners, not negative.
    #[must_use]
    pub const fn radius(&self) -> Fx {
        self.radius
    }

    /// The four corners, counter-clockwise (y up), without the radius; exact.
    #[must_use]
    pub const fn corners(&self) -> [Vec2; 4] {
        let (c, u, v) = (Raw::of(self.centre), Raw::of(self.along), Raw::of(self.across));
        [c.sub(u).sub(v).vec2(), c.add(u).sub(v).vec2(), c.add(u).add(v).vec2(), c.sub(u).add(v).vec2()]
    }

    /// This box moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] if it would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self { centre: self.centre.saturating_add(by), ..*self }.checked()
    }

    pub(super) const fn moved_to(&self, centre: Vec2) -> Self {
        Self { centre, ..*self }
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        let (c, reach) = (Raw::of(self.centre), self.reach());
        Aabb::from_raw_unchecked(c.sub(reach), c.add(reach))
    }
}
