//! The shapes that a mover can move.

use crate::num::{Axis, Raw, Vec2, cmp_squares, mul_div, umul};
use crate::shape::{Aabb, AnyShape, Capsule, Circle, ConvexPolygon, OrientedBox};
use crate::world::World;
use core::cmp::Ordering;

/// A shape that can move.
///
/// - [`Aabb`] and [`Circle`].
/// - A [`Capsule`] that stands or lies.
/// - [`OrientedBox`] and [`ConvexPolygon`].
/// - An [`AnyShape`] of any of them.
/// - A [`Compound`](crate::shape::Compound) of parts that are bodies.
///
/// [`Mover::move_and_slide`](super::Mover::move_and_slide) moves it through a level.
///
/// None of them turns during a call. A slanted capsule moves only as an [`AnyShape`]. As a
/// `Capsule` it is refused with a [`RangeError`](crate::RangeError) of
/// [`Quantity::Capsule`](crate::Quantity::Capsule), and so is a capsule without a radius. Oriented
/// boxes and `AnyShape`s without area are refused with [`Quantity::Area`](crate::Quantity::Area).
///
/// Boxes, circles and upright capsules cost least. In the same level an oriented box takes 1.4 to
/// 1.7 times the instructions of a capsule on a Cortex-M0. Only a game that moves one links its
/// code.
///
/// Sealed: its kernels are part of the exactness argument.
pub trait Body: kernel::Kernel {
    /// The reference position. It is the minimum corner of a box, and the centre of a circle or an
    /// oriented box. For a capsule it is the first end of its core, and for a polygon its first
    /// vertex.
    fn position(&self) -> Vec2;
}

impl Body for Aabb {
    fn position(&self) -> Vec2 {
        self.min()
    }
}

impl Body for Circle {
    fn position(&self) -> Vec2 {
        self.centre()
    }
}

impl Body for OrientedBox {
    fn position(&self) -> Vec2 {
        self.centre()
    }
}

impl<const N: usize> Body for ConvexPolygon<N> {
    fn position(&self) -> Vec2 {
        self.vertices().first().copied().unwrap_or(Vec2::ZERO)
    }
}

impl<const N: usize> Body for AnyShape<N> {
    fn position(&self) -> Vec2 {
        match self {
            Self::Aabb(it) => it.position(),
            Self::Circle(it) => it.position(),
            Self::Segment(it) => it.a(),
            Self::Capsule(it) => it.position(),
            Self::OrientedBox(it) => it.position(),
            Self::Polygon(it) => it.position(),
        }
    }
}

impl Body for Capsule {
    fn position(&self) -> Vec2 {
        self.a()
    }
}

/// A hit of one feature by one motion: entry time `num / den` in `[0, 1]`, with `0 < den <= 2^30`.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    pub(super) num: u32,
    pub(super) den: u32,
    /// Out of the solid, toward the body.
    pub(super) normal: Axis,
    /// Whether other hits at the same moment win. A box may meet a face only at its free end,
    /// corner to corner, and another face over a length. The motion along that one passes this end.
    /// A body may meet the end of a quarter pipe: the surface beyond it goes first.
    pub(super) at_end: bool,
    /// The displacement up to a vertex or an arc, rounded out of the solid. `None` for faces: see
    /// [`displacement`](Self::displacement).
    pub(super) step: Option<Raw>,
}

impl Entry {
    /// Whether this hit comes before `other`: earlier, else face before its end, else more opposed
    /// to the motion, else by the normal, x first. Only geometry decides, never the order of
    /// visits. Compares faces, or vertices and arcs, with normals of equal length.
    pub(super) fn before(&self, other: &Self, d: Raw) -> bool {
        let opposition = || self.against(d).cmp(&other.against(d));
        self.precedes(other).unwrap_or_else(|| opposition().then_with(|| by_size(self.normal, other.normal)).is_gt())
    }

    /// [`before`](Self::before) for normals of any length, whose parts along the motion are
    /// compared as exact squares.
    pub(super) fn before_askew(&self, other: &Self, d: Raw) -> bool {
        self.precedes(other).unwrap_or_else(|| self.is_more_opposed(other, d))
    }

    #[inline(never)]
    fn is_more_opposed(&self, other: &Self, d: Raw) -> bool {
        let (a, b) = (self.against(d), other.against(d));
        let opposition = match a.signum().cmp(&b.signum()) {
            Ordering::Equal => {
                let (to, from) = (other.normal.length_squared(), self.normal.length_squared());
                let sizes = cmp_squares((a.unsigned_abs(), to), (b.unsigned_abs(), from));
                if a < 0 { sizes.reverse() } else { sizes }
            }
            unequal => unequal,
        };
        // If two lengths have the same direction, the longer one wins, mirrored or not.
        opposition.then_with(|| by_size(self.normal, other.normal)).is_gt()
    }

    /// How far the motion goes against the normal, scaled by the normal's length.
    fn against(&self, d: Raw) -> i64 {
        self.normal.dot(Axis::new(d.x, d.y)).wrapping_neg()
    }

    /// The answer of [`before`](Self::before), if the times and ends decide it.
    pub(super) fn precedes(&self, other: &Self) -> Option<bool> {
        match self.time(other) {
            Ordering::Equal if self.at_end == other.at_end => None,
            Ordering::Equal => Some(other.at_end),
            earlier => Some(earlier == Ordering::Less),
        }
    }

    /// Whether both are the same moment and the same surface.
    pub(super) fn same_as(&self, other: &Self) -> bool {
        self.normal == other.normal && self.at_end == other.at_end && self.time(other) == Ordering::Equal
    }

    /// Exact comparison of the times. Faces in one plane have equal fractions, which needs no
    /// product.
    fn time(&self, other: &Self) -> Ordering {
        if (self.num, self.den) == (other.num, other.den) {
            return Ordering::Equal;
        }
        umul(self.num, other.den).cmp(&umul(other.num, self.den))
    }

    /// The displacement up to the hit. On the axis of a face along x or y it is exact. On the other
    /// axis it is the exact part, rounded toward the start. If the exact point keeps to an integer
    /// half-plane, so does the rounded point. At a slope each component is rounded to the side that
    /// the normal points to, and the sum only gains height.
    pub(super) fn displacement(&self, d: Raw) -> Raw {
        self.displacement_at(d, None)
    }

    /// [`displacement`](Self::displacement) with a known `time`: `num / den` in parts of 2^30,
    /// rounded down.
    pub(super) fn displacement_at(&self, d: Raw, time: Option<u32>) -> Raw {
        self.step.unwrap_or_else(|| {
            let slope = self.normal.x != 0 && self.normal.y != 0;
            let out = if slope { self.normal } else { Axis::new(0, 0) };
            Raw { x: self.part(d.x, out.x, time), y: self.part(d.y, out.y, time) }
        })
    }

    /// The component `d` up to the hit: rounded up if that leads to the side of `out`, otherwise
    /// toward the start.
    fn part(&self, d: i32, out: i32, time: Option<u32>) -> i32 {
        let size = d.unsigned_abs();
        if size == self.den {
            // Across a face along x or y the component equals `den`, so its part is `num`.
            return if d < 0 { (self.num as i32).wrapping_neg() } else { self.num as i32 };
        }
        let part = match time {
            // Short by less than size / 2^30, which is below one. Three products cost less than a
            // quotient.
            Some(time) if self.num != 0 => {
                let low = (umul(size, time) >> 30) as u32;
                low.wrapping_add(u32::from(umul(low.wrapping_add(1), self.den) <= umul(size, self.num)))
            }
            _ => mul_div(size, self.num, self.den),
        };
        let up = out != 0 && (out < 0) == (d < 0) && umul(part, self.den) != umul(size, self.num);
        let part = part.wrapping_add(u32::from(up)) as i32;
        if d < 0 { part.wrapping_neg() } else { part }
    }
}

/// By the longer part along x, then along y, then + before -. One copy: three took 280 bytes.
#[inline(never)]
pub(super) fn by_size(a: Axis, b: Axis) -> Ordering {
    let key = |v: Axis| (v.x.unsigned_abs(), v.y.unsigned_abs(), v.x, v.y);
    key(a).cmp(&key(b))
}

/// Whether a body can hit only sides of cells in a level. A box among blocks does: it goes by the
/// lines of the grid.
pub(super) const fn is_by_lines<W: World, B: Body>() -> bool {
    W::GRID && W::BLOCKS && !B::MEETS_CORNERS
}

/// Whether hits may have a [step](Entry::step), and touched planes may be
/// [convex](super::contact::Bend::Convex). If not, as for a box in a level without arcs, the code
/// for them is not linked: 2 KB.
pub(super) const fn may_be_round<W: World, B: Body>() -> bool {
    B::MEETS_CORNERS || W::ARCS || W::ROUND
}

pub(super) mod kernel {
    //! The part of [`Body`](super::Body) that only this crate calls.

    use super::Entry;
    use crate::error::RangeError;
    use crate::motion::touched_plane::Plane;
    use crate::num::{Axis, Raw, Vec2};
    use crate::query::{Core, between};
    use crate::shape::{Aabb, Convex};
    use crate::world::{Feature, Geometry, World};

    pub trait Kernel: Copy {
        /// Whether normals may be askew. If not, the code for them is not linked.
        const MEETS_CORNERS: bool;
        /// Whether it has sides in any direction. If not, the code for them is not linked.
        const ANGULAR: bool = false;
        /// Whether it has parts behind the front of its bounds that meet faces, as only a body with
        /// notches has. Levels leave out what is behind the front.
        const NOTCHED: bool = false;
        /// Whether the body needs to know how faces are joined: one with corners, or one without
        /// area.
        fn meets_joints(&self) -> bool;
        /// The bounding box.
        fn bounds(&self) -> Aabb;
        /// Its width and height. A compiler does not see that both are the diameter of a circle.
        /// That takes 16 of the 360 instructions of a circle that flies on a Cortex-M0.
        fn extent(&self) -> Raw {
            Raw::of(self.bounds().size())
        }
        /// Refuses bodies with a half extent or radius of 2^28 or more.
        fn check_size(&self) -> Result<(), RangeError>;
        /// The body moved by a displacement that keeps it inside the domain.
        fn shifted(&self, d: Raw) -> Self;
        /// The first moment of the motion at which the body would start to overlap the feature, if
        /// any.
        fn sweep(&self, d: Raw, feature: &Feature) -> Option<Entry>;
        /// [`sweep`](Self::sweep) for features that are not arcs. A level without arcs does not
        /// link their code.
        fn sweep_straight(&self, d: Raw, feature: &Feature) -> Option<Entry> {
            self.sweep(d, feature)
        }
        /// [`sweep`](Self::sweep) for worlds of [`BLOCKS`](World::BLOCKS).
        fn sweep_block(&self, d: Raw, feature: &Feature) -> Option<Entry>;
        /// The box of the points that have the [radius](Self::rounding) around them. They are all
        /// of a box, the centre of a circle, and the segment in the middle of a capsule.
        fn core_box(&self) -> (Raw, Raw);
        /// The radius of its corners.
        fn rounding(&self) -> i32;
        /// The foremost one of its lowest corners, and how far its foremost part is ahead of that,
        /// rounded up. The two directions are across each other.
        fn foot(&self, up: Axis, forward: Axis) -> (Raw, i32) {
            let (lo, hi) = self.core_box();
            let at = |up: i32, forward: i32, lo, hi| if up < 0 || (up == 0 && forward > 0) { hi } else { lo };
            (Raw { x: at(up.x, forward.x, lo.x, hi.x), y: at(up.y, forward.y, lo.y, hi.y) }, self.rounding())
        }
        /// The part that meets an arc: a point, and the radius of the disc around it.
        fn toward(&self, quadrant: Axis) -> (Raw, i32);
        /// The corner, and the radius around it, that an entry with a step is of: through the disc
        /// around `p`, or out of it. Only asked where it has sides in any direction.
        fn met_by(&self, p: Raw, entry: &Entry) -> (Raw, i32) {
            let _ = p;
            self.toward(entry.normal.reversed())
        }
        /// Passes directions from a solid to the body: into each side, and between the points that
        /// are nearest to each other. Unless they overlap, one direction is between them. Asked as
        /// above.
        fn sides_toward(&self, solid: &[Vec2], each: &mut dyn FnMut(Axis)) {
            let (lo, hi) = self.core_box();
            let corners = Aabb::from_raw_unchecked(lo, hi).outline();
            if let Some(n) = between(Core { corners: solid, radius: 0 }, Core { corners: &corners, radius: 0 }) {
                each(n);
            }
        }
        /// Passes the planes of a feature to `plane` if it touches the feature; asked as above.
        fn touched(&self, feature: &Feature, plane: &mut dyn FnMut(Plane)) -> bool {
            let _ = (feature, plane);
            false
        }
        /// Whether it is within a distance of a segment. For a box, which is not rounded, the
        /// distance is along x and y.
        fn is_within(&self, a: Raw, b: Raw, reach: i32) -> bool;
        /// [`is_within`](Self::is_within) for segments along x or y, and for points.
        fn is_within_straight(&self, a: Raw, b: Raw, reach: i32) -> bool {
            self.is_within(a, b, reach)
        }
        /// [`is_within`](Self::is_within) of the corner or end that faces the front of a slope with
        /// this direction.
        fn faces_within(&self, dir: Axis, (a, b): (Raw, Raw), reach: i32) -> bool {
            let _ = dir;
            self.is_within(a, b, reach)
        }
        /// Whether the body overlaps the level: strict and exact.
        fn overlaps_world<W: World>(&self, world: &W) -> bool;
        /// The [sweep](Self::sweep) against a feature of a level, by the code that such levels
        /// link.
        #[inline(never)]
        fn sweep_in<W: World>(&self, d: Raw, feature: &Feature) -> Option<Entry> {
            if W::BLOCKS {
                self.sweep_block(d, feature)
            } else if W::ROUND {
                self.sweep(d, feature)
            } else if matches!(feature.geometry, Geometry::Arc { .. }) {
                None
            } else {
                self.sweep_straight(d, feature)
            }
        }
        /// Whether a point is in the inside of the level's solid, by the tests that such bodies
        /// link.
        fn is_inside<W: World>(world: &W, p: Raw) -> bool;
    }
}
