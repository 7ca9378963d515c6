//! How two shapes overlap: how deep, where, and in which direction is the way out.

mod answers;
mod kernels;

use crate::num::{Axis, Raw, UnitVec2};

/// How two shapes overlap.
///
/// The contact keeps exact values, and computes rounded results only when you ask for them. It
/// describes the *least exit*: the shortest way to move A until the two do not overlap any more.
///
/// ```text
///        A                      axis() points from A to B
///    +--------+                 push_out() moves A against it, by depth() or a little more
///    |     +--|-----+
///    |     |<>|     |  B        <> depth()
///    +-----|--+     |
///          +--------+
/// ```
///
/// `contact(a, b)` and `contact(b, a)` mirror each other bit for bit: axis and push-out are
/// negated, the points are exchanged, the depth is the same. The only exception is a
/// [degenerate](Self::is_degenerate) contact, whose axis is the documented one in both orders.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Axis, Circle, Fx, Vec2};
/// let a = Circle::new(Vec2::from_ints(0, 0), Fx::from_num(5))?;
/// let b = Circle::new(Vec2::from_ints(6, 0), Fx::from_num(3))?;
/// let contact = a.contact(&b).unwrap();
/// assert_eq!(contact.axis(), Axis::X);
/// assert_eq!(contact.depth(), 2);
/// assert_eq!(contact.push_out(), Vec2::from_ints(-2, 0));
/// assert_eq!(contact.point_on_a(), Vec2::from_ints(5, 0));
/// assert_eq!(contact.point_on_b(), Vec2::from_ints(3, 0));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(alias("Manifold", "collision"))]
pub struct Contact {
    /// From A to B, not zero; of length one if it is parallel to x or y.
    pub(crate) axis: Axis,
    /// How far the cores overlap along the axis, times the length of the axis. Negative if they are
    /// apart and only the radii overlap. Not used if `radial` is set.
    pub(crate) overlap: i64,
    /// The deepest point of one core; the deepest of the other is `axis * overlap / axis^2` away.
    pub(crate) core: Raw,
    /// Whether `core` belongs to B.
    pub(crate) core_on_b: bool,
    pub(crate) radius_a: i32,
    pub(crate) radius_b: i32,
    /// Whether the axis is the vector from A's core to B's, not parallel to x or y: `overlap` would
    /// be `-axis^2`.
    pub(crate) radial: bool,
    degenerate: bool,
}

impl Contact {
    /// The contact normal as exact integers, from A to B; never zero.
    ///
    /// Its length has no meaning: it is chosen so that the components are exact. Parallels to x and
    /// y have length one.
    #[must_use]
    pub const fn axis(&self) -> Axis {
        self.axis
    }

    /// The contact normal as a unit vector, from A to B, within 1.5 units of 2^-30 per component.
    ///
    /// Parallels to x and y are exact. Cost: about 250 instructions on a Cortex-M0, a few for a
    /// box.
    #[must_use]
    pub const fn normal(&self) -> UnitVec2 {
        self.axis.unit()
    }

    /// Whether there was more than one least exit.
    ///
    /// The axis then follows a convention: x before y before the normal of a segment, and the
    /// positive direction of x and y. For a segment it is the normal `(-e.y, e.x)` of its edge `e`
    /// from the lexicographically smaller end. See the table of [degenerate
    /// cases](crate::query#degenerate-cases).
    ///
    /// ```
    /// use tilesat::{Aabb, Vec2, prelude::*};
    /// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
    /// assert!(at(0)?.contact(&at(0)?).unwrap().is_degenerate()); // no side is nearer than another
    /// assert!(!at(0)?.contact(&at(6)?).unwrap().is_degenerate());
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn is_degenerate(&self) -> bool {
        self.degenerate
    }

    /// A contact with its core on A and without radii.
    pub(crate) const fn new(axis: Axis, overlap: i64, core: Raw) -> Self {
        Self { axis, overlap, core, core_on_b: false, radius_a: 0, radius_b: 0, radial: false, degenerate: false }
    }

    /// The contact of two points `v` apart, from the core of A. Zero gives +x.
    #[inline]
    pub(crate) const fn radial(core: Raw, v: Raw) -> Self {
        let axis = parallel_to_unit(v);
        if v.x == 0 || v.y == 0 {
            // A parallel has only one component that is not zero.
            let apart = v.x.wrapping_add(v.y).unsigned_abs() as i64;
            Self::new(axis, apart.wrapping_neg(), core)
        } else {
            Self { radial: true, ..Self::new(axis, 0, core) }
        }
    }

    pub(crate) const fn with_radii(self, a: i32, b: i32) -> Self {
        Self { radius_a: a, radius_b: b, ..self }
    }

    pub(crate) const fn on_b(self) -> Self {
        Self { core_on_b: true, ..self }
    }

    pub(crate) const fn with_degenerate(self, degenerate: bool) -> Self {
        Self { degenerate, ..self }
    }

    /// The contact in the order (B, A).
    const fn flipped(self) -> Self {
        Self {
            axis: self.axis.reversed(),
            core_on_b: !self.core_on_b,
            radius_a: self.radius_b,
            radius_b: self.radius_a,
            ..self
        }
    }
}

/// A direction as an axis. Parallels to x and y have length one, which makes everything about them
/// exact. Zero gives +x.
const fn parallel_to_unit(v: Raw) -> Axis {
    if v.y == 0 {
        Axis::new(if v.x < 0 { -1 } else { 1 }, 0)
    } else if v.x == 0 {
        Axis::new(0, if v.y < 0 { -1 } else { 1 })
    } else {
        Axis::new(v.x, v.y)
    }
}

/// How two shapes overlap, if they do.
///
/// `Some` exactly if [`overlaps`](super::Overlaps::overlaps) is true. The contact is exact; the
/// methods of [`Contact`] round. Cost on a Cortex-M0: about 130 instructions for boxes and circles,
/// and 550 for a circle and a segment. A segment against a box or a segment takes some hundred
/// more. There is no root and no division. It cannot fail.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Axis, Vec2};
/// let mut player = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 10))?;
/// let wall = Aabb::new(Vec2::from_ints(8, -20), Vec2::from_ints(16, 20))?;
/// if let Some(contact) = player.contact(&wall) {
///     assert_eq!(contact.axis(), Axis::X);
///     assert_eq!(contact.depth(), 2);
///     player = player.translated(contact.push_out())?;
/// }
/// assert!(player.touches(&wall) && !player.overlaps(&wall));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Contacts<B: ?Sized> {
    /// How this shape (A) overlaps `b` (B); `None` if it does not.
    #[must_use]
    #[doc(alias("collide", "manifold"))]
    fn contact(&self, b: &B) -> Option<Contact>;
}
