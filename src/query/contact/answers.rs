//! The answers of a contact, rounded on request.

use super::Contact;
use crate::num::{
    Axis, Fx, InverseRoot, LONG, Raw, UnitVec2, Vec2, div_sqrt, isqrt64, less128, mul64, scaled, sqr64, umul, unit_by,
    unit_ceil, usqr,
};

impl Contact {
    /// How far A must be moved against the axis to end the overlap: the exact depth rounded up, at
    /// least one raw unit.
    ///
    /// Cost on a Cortex-M0: a few instructions for boxes, a square root for circles (300), a
    /// quotient by one beside sloped segments (700).
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Circle, Fx, Vec2};
    /// let a = Circle::new(Vec2::from_ints(0, 0), Fx::from_bits(3))?;
    /// let b = Circle::new(Vec2::from_raw(2, 2), Fx::from_bits(1))?;
    /// assert_eq!(a.contact(&b).unwrap().depth().to_bits(), 2); // 4 - sqrt(8) = 1.17 raw
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[cfg_attr(target_pointer_width = "64", inline)]
    #[must_use]
    #[doc(alias = "penetration")]
    pub const fn depth(&self) -> Fx {
        Fx::from_bits(self.depth_raw())
    }

    /// The [depth](Self::depth) and the [normal](Self::normal) in one call.
    ///
    /// The bits are those of the two methods. On 64-bit processors both come from one reciprocal
    /// root, which is faster.
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Circle, Vec2, fx};
    /// let a = Circle::new(Vec2::from_ints(0, 0), fx!(5))?;
    /// let contact = a.contact(&Circle::new(Vec2::from_ints(3, 4), fx!(2))?).unwrap();
    /// let (depth, normal) = contact.depth_and_normal();
    /// assert_eq!((depth, normal.scaled(depth)), (fx!(2), contact.normal().scaled(fx!(2))));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[must_use]
    pub const fn depth_and_normal(&self) -> (Fx, UnitVec2) {
        if !LONG {
            return (self.depth(), self.normal());
        }
        // A radial axis is never parallel to x or y: the test that distinguishes them is made once.
        let (unit, depth) = if self.radial {
            radial_exit(self.axis, self.axis.length_squared(), self.radii())
        } else if self.is_parallel() {
            return (Fx::from_bits(self.depth_along()), UnitVec2::along(self.axis));
        } else {
            sloped_exit(self.axis, self.axis.length_squared(), self.overlap, self.radii())
        };
        (Fx::from_bits(depth), UnitVec2::unpacked(unit))
    }

    /// A displacement of A after which the two do not overlap: against the axis, each component
    /// rounded away from zero.
    ///
    /// Exact if the axis is parallel to x or y. Otherwise a component is at most 4 raw units longer
    /// than the exact least exit needs. It is 5 if the depth or the sum of radii is above 8192
    /// units. The result may lead out of the [domain](crate::num::DOMAIN); `translated` then
    /// returns an error.
    ///
    /// Cost on a Cortex-M0: 30 instructions along x and y, 310 for circles, 1050 beside sloped
    /// segments, where the depth is computed first.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2, fx, prelude::*};
    /// let unit = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 10, 10));
    /// let (a, b) = (unit(0)?, unit(7)?);
    /// let contact = a.contact(&b).expect("they overlap by 3");
    /// assert_eq!((contact.depth(), contact.push_out()), (fx!(3), Vec2::from_ints(-3, 0)));
    /// assert!(!a.translated(contact.push_out())?.overlaps(&b));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    #[doc(alias("MTV", "minimum translation vector", "separation"))]
    pub const fn push_out(&self) -> Vec2 {
        let Axis { x, y } = self.axis;
        if self.is_parallel() {
            let d = self.depth_raw();
            return Vec2::from_raw(x.wrapping_neg().wrapping_mul(d), y.wrapping_neg().wrapping_mul(d));
        }
        // Each component below is at least the exact one in size and has its sign. So with n the
        // axis, n.push is at least |n| times the depth. Afterwards a line across n has A on one
        // side and B on the other. Convex shapes that a line separates do not overlap.
        let (ux, uy) = unit_ceil(self.axis);
        // Radial: the cores are `axis` apart and have to be radii / |axis| times as far. The
        // difference of the two has the right sign.
        let (length, from) =
            if self.radial { (self.radii(), Raw { x, y }) } else { (self.depth_raw(), Raw { x: 0, y: 0 }) };
        let (px, py) = (times_unit_up(ux, length), times_unit_up(uy, length));
        Vec2::from_raw(
            from.x.wrapping_add(if x > 0 { px.wrapping_neg() } else { px }),
            from.y.wrapping_add(if y > 0 { py.wrapping_neg() } else { py }),
        )
    }

    /// The point of A that lies deepest in B, within 2 raw units per component.
    ///
    /// If a whole side of a box is equally deep, it is the middle of the part that faces B. Cost:
    /// at most a unit vector and two long divisions, some thousand instructions on a Cortex-M0. For
    /// boxes it is exact and takes a few instructions.
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2, prelude::*};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// let contact = at(0)?.contact(&at(6)?).unwrap();
    /// assert_eq!(contact.point_on_a(), Vec2::from_ints(8, 4));
    /// assert_eq!(contact.point_on_b(), Vec2::from_ints(6, 4));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn point_on_a(&self) -> Vec2 {
        let core = if self.core_on_b { self.core.add(self.between_cores()) } else { self.core };
        core.add(self.along(self.radius_a)).vec2()
    }

    /// The point of B that lies deepest in A; as [`point_on_a`](Self::point_on_a).
    #[must_use]
    pub const fn point_on_b(&self) -> Vec2 {
        let core = if self.core_on_b { self.core } else { self.core.sub(self.between_cores()) };
        core.sub(self.along(self.radius_b)).vec2()
    }

    /// Parallel to x or y; such an axis has length one.
    const fn is_parallel(&self) -> bool {
        self.axis.x == 0 || self.axis.y == 0
    }

    const fn radii(&self) -> i32 {
        self.radius_a.wrapping_add(self.radius_b)
    }

    /// `ceil(radii + overlap / |axis|)`.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    const fn depth_raw(&self) -> i32 {
        if self.is_parallel() {
            self.depth_along()
        } else {
            sloped_depth(self.axis, self.overlap, self.radii(), self.radial)
        }
    }

    /// Along x or y.
    #[inline(always)]
    const fn depth_along(&self) -> i32 {
        self.radii().wrapping_add(self.overlap as i32)
    }

    /// The deepest point of A's core minus that of B's: `axis * overlap / axis^2`, to nearest.
    const fn between_cores(&self) -> Raw {
        let Axis { x, y } = self.axis;
        if self.is_parallel() {
            let s = self.overlap as i32;
            return Raw { x: x.wrapping_mul(s), y: y.wrapping_mul(s) };
        }
        if self.radial {
            return Raw { x: x.wrapping_neg(), y: y.wrapping_neg() };
        }
        let n = self.axis.length_squared();
        Raw { x: scaled(x, self.overlap, n), y: scaled(y, self.overlap, n) }
    }

    /// The unit vector times a radius, to nearest.
    const fn along(&self, radius: i32) -> Raw {
        if radius == 0 {
            return Raw { x: 0, y: 0 };
        }
        let (x, y) = self.normal().raw();
        Raw { x: times_unit(x, radius), y: times_unit(y, radius) }
    }
}

/// [`Contact::depth`] where the axis is parallel to neither x nor y, by values, so a contact that
/// is only read stays in registers. It is a call on 64-bit processors.
#[cfg_attr(target_pointer_width = "64", inline(never))]
#[cfg_attr(not(target_pointer_width = "64"), inline(always))]
const fn sloped_depth(axis: Axis, overlap: i64, radii: i32, radial: bool) -> i32 {
    let n = axis.length_squared();
    // R - floor(x) = ceil(R - x).
    if radial {
        return radii.wrapping_sub(isqrt64(n) as i32);
    }
    ceil(radii, overlap, n, div_sqrt(overlap.unsigned_abs(), n))
}

/// The unit vector and the depth of a radial contact, by its axis and the square of that. A call,
/// with its answer in two registers: shapes that do not overlap then have no registers to save.
#[inline(never)]
const fn radial_exit(axis: Axis, n: u64, radii: i32) -> (u64, i32) {
    let inverse = InverseRoot::of(n);
    (unit_by(axis, inverse).packed(), radii.wrapping_sub(inverse.root(n) as i32))
}

/// The unit vector and the depth of a contact that is not radial.
#[inline(never)]
const fn sloped_exit(axis: Axis, n: u64, overlap: i64, radii: i32) -> (u64, i32) {
    let inverse = InverseRoot::called(n);
    (unit_by(axis, inverse).packed(), ceil(radii, overlap, n, inverse.times(overlap.unsigned_abs(), n)))
}

/// `ceil(radii + overlap / sqrt(n))`, by the floor of the size of that quotient.
#[inline(always)]
const fn ceil(radii: i32, overlap: i64, n: u64, floor: u32) -> i32 {
    if overlap < 0 {
        return radii.wrapping_sub(floor as i32);
    }
    let exact = !less128(mul64(usqr(floor), n), sqr64(overlap as u64));
    radii.wrapping_add(floor as i32).wrapping_add(!exact as i32)
}

/// A magnitude in Q30 times a length below 2^30, rounded up, one unit more if it is whole.
///
/// Depths are below 2^30 as well: the normal of a segment is the axis only where it gives less
/// than x and y do.
const fn times_unit_up(unit: u32, length: i32) -> i32 {
    ((umul(unit, (length as u32) << 2) >> 32) as i32).wrapping_add(1)
}

/// A component in Q30 times a length that is not negative, to nearest, halves away from zero.
const fn times_unit(unit: i32, length: i32) -> i32 {
    let product = (umul(unit.unsigned_abs(), length as u32).wrapping_add(1 << 29) >> 30) as i32;
    if unit < 0 { product.wrapping_neg() } else { product }
}
