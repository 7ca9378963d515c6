//! A segment with a radius.

use super::{Aabb, Circle, Segment};
use crate::error::RangeError;
use crate::num::{Fx, Raw, Vec2};

/// All points within a radius of a segment: a stadium, standing, lying or slanted.
///
/// Equal ends are legal and act as a circle, a radius of zero as a segment. Reversing the ends
/// changes no result.
///
/// A capsule that stands or lies is a [`Body`](crate::Body): movers, walkers and characters take
/// it. A slanted one moves as an [`AnyShape`](super::AnyShape).
///
/// ```text
///   .-------------------.
///  (  a ------------- b  )      the core a-b, and `radius` around it
///   '-------------------'
/// ```
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Capsule, Vec2, fx};
/// let hero = Capsule::new(Vec2::from_ints(10, 10), Vec2::from_ints(10, 24), fx!(6))?;
/// assert_eq!(hero.aabb(), Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(16, 30))?);
/// let corner = Aabb::new(Vec2::from_ints(15, 29), Vec2::from_ints(40, 40))?;
/// assert!(hero.aabb().overlaps(&corner) && !hero.overlaps(&corner)); // its feet are round
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// A capsule that runs into a corner with its feet goes over it; a box stops there:
///
/// ```
/// use tilesat::{Aabb, Axis, Capsule, Mover, TileKind, TileKinds, TileMap, Vec2, fx};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("....\n....\n..##", &KINDS)?; // a block from (32, 32)
/// let mover = Mover::platformer(Axis::NEG_Y);
/// let hero = Capsule::new(Vec2::from_ints(20, 17), Vec2::from_ints(20, 27), fx!(6))?; // feet at y = 33
/// let moved = mover.move_and_slide(&level, &hero, Vec2::from_ints(10, 0))?;
/// assert!(moved.body.b().y < hero.b().y && moved.velocity.x > fx!(5)); // up, and on
/// let boxed = mover.move_and_slide(&level, &hero.aabb(), Vec2::from_ints(10, 0))?;
/// assert!(boxed.wall && boxed.velocity.x == 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("pill", "stadium"))]
pub struct Capsule {
    core: Segment,
    radius: Fx,
}

impl Capsule {
    /// A capsule from the ends of its core and its radius.
    ///
    /// # Errors
    /// [`RangeError`] if the radius is negative, or an end, the radius or a point of the capsule is
    /// outside the [domain](crate::num::DOMAIN).
    pub const fn new(a: Vec2, b: Vec2, radius: Fx) -> Result<Self, RangeError> {
        // Its ends are circles.
        match Circle::new(a, radius) {
            Ok(_) => match Circle::new(b, radius) {
                Ok(_) => match Segment::new(a, b) {
                    Ok(core) => Ok(Self { core, radius }),
                    Err(e) => Err(e),
                },
                Err(e) => Err(e),
            },
            Err(e) => Err(e),
        }
    }

    /// The first end of the core.
    #[must_use]
    pub const fn a(&self) -> Vec2 {
        self.core.a()
    }

    /// The second end of the core.
    #[must_use]
    pub const fn b(&self) -> Vec2 {
        self.core.b()
    }

    /// The segment in the middle.
    #[must_use]
    pub const fn core(&self) -> Segment {
        self.core
    }

    /// The radius, not negative.
    #[must_use]
    pub const fn radius(&self) -> Fx {
        self.radius
    }

    /// This capsule moved by `by`.
    ///
    /// # Errors
    /// [`RangeError`] if it would leave the [domain](crate::num::DOMAIN).
    pub const fn translated(&self, by: Vec2) -> Result<Self, RangeError> {
        Self::new(self.a().saturating_add(by), self.b().saturating_add(by), self.radius)
    }

    /// From ends and a radius that are known to be inside the domain.
    pub(crate) const fn from_raw_unchecked(a: Raw, b: Raw, radius: Fx) -> Self {
        Self { core: Segment { a: a.vec2(), b: b.vec2() }, radius }
    }

    /// The bounding box; exact.
    #[must_use]
    pub const fn aabb(&self) -> Aabb {
        let (core, r) = (self.core.aabb(), self.radius.to_bits());
        let r = Raw { x: r, y: r };
        Aabb::from_raw_unchecked(core.lo().sub(r), core.hi().add(r))
    }
}
