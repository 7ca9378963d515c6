//! The shapes that queries about flags take.

use crate::num::{Raw, Vec2};
use crate::query::meet;
use crate::shape::{Aabb, Circle};

/// A shape that [`TileMap::flags_touched`](crate::TileMap::flags_touched) takes: a box, a circle or
/// a point.
///
/// The trait is sealed. For another shape pass its bounding box, such as
/// [`Capsule::aabb`](crate::Capsule::aabb).
pub trait Probe: probe::Probe {}

impl Probe for Aabb {}
impl Probe for Circle {}
impl Probe for Vec2 {}

pub(crate) mod probe {
    //! The part of [`Probe`](crate::world::Probe) that only this crate calls.

    use super::{Aabb, Circle, Raw, Vec2, meet};
    use crate::query::{Core, meets};
    use crate::shape::Convex;

    pub trait Probe {
        /// The corners of the bounding box.
        fn bounds(&self) -> (Raw, Raw);
        /// Whether the shape touches a cell that its bounding box touches.
        fn reaches(&self, cell: (Raw, Raw)) -> bool;
        /// Whether the shape touches a cell on a motion whose bounding box touches it.
        fn passes(&self, d: Raw, cell: (Raw, Raw)) -> bool;
        /// [`passes`](Self::passes) for a part of a trail: relative to its start, the cell has
        /// moved in the opposite direction.
        fn passes_on(&self, (from, by): (Vec2, Vec2), (lo, hi): (Raw, Raw)) -> bool {
            let from = Raw::of(from);
            self.passes(Raw::of(by), (lo.sub(from), hi.sub(from)))
        }
        /// Whether the shape touches a segment.
        fn meets(&self, a: Raw, b: Raw) -> bool;
        /// Whether the shape touches a convex one, given as a core.
        fn touches_core(&self, corners: &[Vec2], radius: i32) -> bool;
        /// The shape, relative to an offset.
        #[must_use]
        fn less(&self, offset: Raw) -> Self;
    }

    /// Whether a shape touches a core.
    fn touch(shape: &impl Convex, corners: &[Vec2], radius: i32) -> bool {
        meets::<true>(Core { corners: &shape.outline(), radius: shape.rounding() }, Core { corners, radius })
    }

    impl Probe for Aabb {
        fn bounds(&self) -> (Raw, Raw) {
            (self.lo(), self.hi())
        }
        fn reaches(&self, _: (Raw, Raw)) -> bool {
            true
        }
        fn passes(&self, d: Raw, (lo, hi): (Raw, Raw)) -> bool {
            // The path of one corner against the cell, which is larger by the box.
            let a = self.lo();
            meet::segment_aabb::<true>(a, a.add(d), lo.sub(self.hi().sub(a)), hi)
        }
        fn meets(&self, a: Raw, b: Raw) -> bool {
            meet::segment_aabb::<true>(a, b, self.lo(), self.hi())
        }
        fn touches_core(&self, corners: &[Vec2], radius: i32) -> bool {
            touch(self, corners, radius)
        }
        fn less(&self, offset: Raw) -> Self {
            self.shifted(offset.reversed())
        }
    }

    impl Probe for Circle {
        fn bounds(&self) -> (Raw, Raw) {
            self.aabb().bounds()
        }
        fn reaches(&self, cell: (Raw, Raw)) -> bool {
            meet::circle_aabb::<true>(self.c(), self.r(), cell.0, cell.1)
        }
        fn passes(&self, d: Raw, (lo, hi): (Raw, Raw)) -> bool {
            // The nearest points to a path across a cell are the path's ends, or the cell's
            // corners.
            let (a, r) = (self.c(), self.r());
            let b = a.add(d);
            meet::circle_aabb::<true>(a, r, lo, hi)
                || meet::circle_aabb::<true>(b, r, lo, hi)
                || meet::segment_aabb::<true>(a, b, lo, hi)
                || [(lo.x, lo.y), (lo.x, hi.y), (hi.x, lo.y), (hi.x, hi.y)]
                    .iter()
                    .any(|&(x, y)| meet::circle_segment::<true>(Raw { x, y }, r, a, b))
        }
        fn meets(&self, a: Raw, b: Raw) -> bool {
            meet::circle_segment::<true>(self.c(), self.r(), a, b)
        }
        fn touches_core(&self, corners: &[Vec2], radius: i32) -> bool {
            touch(self, corners, radius)
        }
        fn less(&self, offset: Raw) -> Self {
            self.shifted(offset.reversed())
        }
    }

    impl Probe for Vec2 {
        fn bounds(&self) -> (Raw, Raw) {
            (Raw::of(*self), Raw::of(*self))
        }
        fn reaches(&self, _: (Raw, Raw)) -> bool {
            true
        }
        fn passes(&self, d: Raw, (lo, hi): (Raw, Raw)) -> bool {
            let p = Raw::of(*self);
            meet::segment_aabb::<true>(p, p.add(d), lo, hi)
        }
        fn meets(&self, a: Raw, b: Raw) -> bool {
            let p = Raw::of(*self);
            meet::segment_aabb::<true>(a, b, p, p)
        }
        fn touches_core(&self, corners: &[Vec2], radius: i32) -> bool {
            meets::<true>(Core { corners: &[*self], radius: 0 }, Core { corners, radius })
        }
        fn less(&self, offset: Raw) -> Self {
            Raw::of(*self).sub(offset).vec2()
        }
    }
}
