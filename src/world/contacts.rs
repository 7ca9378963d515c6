//! Which features of a level a body overlaps, how deep, and in which direction it leaves.

use super::joined::Joined;
use super::level::{Feature, Geometry, World, ends, precedes};
use super::measure::Measure;
use super::placed::Placed;
use super::segment_map::SegmentMap;
use super::solids::Solids;
use super::solids::convex::ConvexSolids;
use super::solids::convex_solid::SolidShape;
use super::tile_map::{ShapeSet, Store, TileMap};
use crate::error::Truncated;
use crate::num::{Axis, Fx, Raw, Vec2, div_sqrt, mul_div_wide, toward, umul, usqr};
use crate::query::Contact;
use crate::query::closest::on_segment;
use crate::shape::Aabb;
use crate::world::closest::OneWay;
use core::cmp::Ordering;
use heapless::VecView;
use kernel::PushOne;

/// How a body overlaps one feature of a level; see [`TileMap::contacts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorldContact {
    /// From the body to the feature.
    contact: Contact,
    feature: Feature,
}

impl WorldContact {
    /// The piece of the surface.
    #[must_use]
    pub const fn feature(&self) -> Feature {
        self.feature
    }

    /// The normal as exact integers, out of the solid; never zero, and of length one if parallel to
    /// x or y.
    #[must_use]
    pub const fn axis(&self) -> Axis {
        self.contact.axis.reversed()
    }

    /// How far the body is behind the feature, along the normal: rounded up, at least one raw unit.
    ///
    /// Cost: as [`Contact::depth`].
    #[must_use]
    pub const fn depth(&self) -> Fx {
        self.contact.depth()
    }

    /// Whether another way out of this feature is equally short, or the body's middle is the centre
    /// of an arc.
    ///
    /// The normal is then a convention: x before y, + before -. Features that are equally deep are
    /// separate contacts, in the order that `contacts` documents.
    #[must_use]
    pub const fn is_degenerate(&self) -> bool {
        self.contact.is_degenerate()
    }

    /// A displacement after which the body does not overlap this feature.
    ///
    /// It is at most 4 raw units longer than the least one along the normal. Each component is
    /// rounded away from the surface. One case has no such displacement: a circle that is larger
    /// than a quarter pipe cannot leave it. The push then leads toward the centre of the arc. The
    /// corners and faces at its ends have separate contacts. The result may lead out of the
    /// [domain](crate::num::DOMAIN); `translated` then returns an error.
    #[must_use]
    pub const fn push_out(&self) -> Vec2 {
        let Axis { x, y } = self.contact.axis;
        if x == 0 || y == 0 {
            return self.contact.push_out();
        }
        match self.feature.geometry {
            // Toward the centre of a hollow disc: to the last point whose components do not exceed
            // the exact ones.
            Geometry::Arc { radius, convex: false, .. } if self.contact.radius_a <= radius => {
                let (room, d) = (radius.wrapping_sub(self.contact.radius_a) as u32, self.contact.axis.length_squared());
                Vec2::from_raw(inward(x, room, d), inward(y, room, d))
            }
            // A box before a slope: the exact way, rounded up.
            Geometry::Face { .. } if self.contact.radius_a == 0 => {
                let (s, d) = (self.contact.overlap as u64, self.contact.axis.length_squared());
                Vec2::from_raw(outward(x, s, d), outward(y, s, d))
            }
            _ => self.contact.push_out(),
        }
    }

    /// The point of the feature that is nearest to a circle's centre or a box's deepest point, each
    /// component rounded to nearest.
    ///
    /// If a side of a box is equally deep along a face, it is the middle of their common part.
    #[must_use]
    pub const fn point(&self) -> Vec2 {
        match self.feature.geometry {
            Geometry::Face { a, dir, len, .. } => {
                let (a, b) = ends(Raw::of(a), dir, len);
                on_segment(self.contact.core, a, b).vec2()
            }
            Geometry::Vertex { p, .. } => p,
            Geometry::Arc { centre, radius, convex, .. } => {
                let Axis { x, y } = if convex { self.axis() } else { self.contact.axis };
                Raw::of(centre).add(toward(Raw { x, y }, radius)).vec2()
            }
        }
    }

    pub(super) const fn new(contact: Contact, feature: Feature) -> Self {
        Self { contact, feature }
    }

    /// The order of the contacts of one shape.
    pub(super) fn goes_before<W: World>(&self, other: &Self, by_depth: bool) -> bool {
        self.found().before::<W>(other.found(), by_depth)
    }

    /// Adds it to a list in the order of depths. If the list is full, its last contact is dropped.
    pub(super) fn insert_in<W: World>(&self, out: &mut VecView<Self>) {
        insert::<W>(out, self.found(), true);
    }

    const fn found(&self) -> ContactRef<'_> {
        ContactRef { contact: &self.contact, feature: &self.feature }
    }
}

/// References to the parts of a [`WorldContact`].
#[derive(Clone, Copy)]
struct ContactRef<'a> {
    contact: &'a Contact,
    feature: &'a Feature,
}

impl ContactRef<'_> {
    const fn kept(self) -> WorldContact {
        WorldContact { contact: *self.contact, feature: *self.feature }
    }

    /// The exact distance for the order: for a circle, that of its centre from the feature; for a
    /// box, the depth.
    #[inline(never)]
    const fn measure(self) -> Measure {
        let Contact { axis, overlap, radius_b, .. } = *self.contact;
        if axis.x == 0 || axis.y == 0 {
            // The axis has length one; the feature's radius is negative for a hollow disc.
            return Measure::root(usqr((overlap as i32).wrapping_add(radius_b).unsigned_abs()));
        }
        match self.feature.geometry {
            Geometry::Arc { radius, .. } => Measure::Ring { square: axis.length_squared(), radius: radius as u32 },
            _ if self.contact.radial => Measure::root(axis.length_squared()),
            _ => Measure::height(overlap.unsigned_abs(), axis.length_squared()),
        }
    }

    fn before<W: World>(self, other: ContactRef<'_>, by_depth: bool) -> bool {
        let corner = |c: ContactRef<'_>| matches!(c.feature.geometry, Geometry::Vertex { .. });
        let order = if by_depth {
            self.contact.depth().cmp(&other.contact.depth())
        } else {
            self.measure().order::<W>(&other.measure())
        };
        match order.then(corner(self).cmp(&corner(other))) {
            Ordering::Equal => precedes(self.feature, other.feature),
            order => order == Ordering::Less,
        }
    }
}

/// By how much the component `v` of a vector with the square `d` misses a circle of radius `room`,
/// rounded down in size.
const fn inward(v: i32, room: u32, d: u64) -> i32 {
    let at = div_sqrt(umul(v.unsigned_abs(), room), d) as i32;
    (if v < 0 { at.wrapping_neg() } else { at }).wrapping_sub(v)
}

/// `-n s / d`, rounded away from zero or a unit more.
const fn outward(n: i32, s: u64, d: u64) -> i32 {
    let size = mul_div_wide(s, n.unsigned_abs(), d).wrapping_add(1) as i32;
    if n < 0 { size } else { size.wrapping_neg() }
}

/// The method of each kind of level, with its own words.
macro_rules! contacts_of {
    ($(#[$doc:meta])* [$($parameters:tt)*] $level:ty) => {
        impl<$($parameters)*> $level {
            $(#[$doc])*
            pub fn contacts<Body: Pushable>(
                &self,
                body: &Body,
                one_way: OneWay,
                out: &mut VecView<WorldContact>,
            ) -> Result<u32, Truncated> {
                contacts(self, body, one_way, out)
            }
        }
    };
}

contacts_of! {
    /// Writes the features that a body overlaps to `out`, which is cleared first: each once, the
    /// nearest first.
    ///
    /// A feature counts if the body is in its region. For a circle, the centre must be before or
    /// behind a face or an arc, or in the cone of a corner. Directly behind a concave corner none
    /// of these applies. Then those faces count whose ends the circle covers and whose back it is
    /// on. For a box, the deepest corner must be before or behind a slope or arc. A side of the box
    /// counts against a face along x or y, or against the corner that it faces. If none of these
    /// applies to a box, the nearest slope that it meets counts.
    ///
    /// Capsules, oriented boxes and polygons follow the rules of boxes, with their own sides, and
    /// with a disc around each corner if they are rounded. The shortest way out comes first, by the
    /// depth rounded up to raw units; then faces and arcs before corners.
    ///
    /// A [`Compound`](crate::shape::Compound) has the contacts of its parts, in the same order. If
    /// several parts overlap a feature, it lists the deepest. So after its
    /// [`push_out`](WorldContact::push_out) no part overlaps that feature.
    ///
    /// The back of a feature counts only while the body's middle is in the solid. Otherwise the far
    /// side of a thin wall would be a way out. Circles list the feature first whose distance from
    /// the centre is least, boxes the shortest way out. Ties are broken as in
    /// [`closest_point`](Self::closest_point). A body that reaches no surface, such as one deep in
    /// the solid or a point, has no contacts.
    ///
    /// Returns the number of features examined. Cost: the features of the body's bounding box, at
    /// most 10 per cell in `(width / cell + 2) (height / cell + 2)` cells. Each feature takes one
    /// exact test, and each that is kept is compared with those before it. A ball of 10 units that
    /// overlaps shapes of 24 takes some 7000 instructions on a Cortex-M0.
    ///
    /// ```
    /// use tilesat::{Axis, Circle, Fx, TileKind, TileKinds, TileMap, Vec2, world::OneWay};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let map = TileMap::from_ascii("#...\n####", &KINDS)?;
    /// let ball = Circle::new(Vec2::from_ints(22, 9), Fx::from_num(8))?;
    /// let mut out = heapless::Vec::<_, 4>::new();
    /// map.contacts(&ball, OneWay::Ignore, &mut out)?;
    /// let found: Vec<_> = out.iter().map(|c| (c.axis(), c.depth().to_num::<i32>())).collect();
    /// assert_eq!(found, [(Axis::X, 2), (Axis::NEG_Y, 1)]); // the wall at x = 16, then the floor at y = 16
    /// assert_eq!(out[0].push_out(), Vec2::from_ints(2, 0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the nearest.
    [S: ShapeSet, T: Store] TileMap<'_, S, T>
}

contacts_of! {
    /// Writes the features that a body overlaps to `out`, which is cleared first: each once, the
    /// nearest first; as [`TileMap::contacts`].
    ///
    /// A wall that a body crosses pushes to the side on which the body's middle is.
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the nearest.
    [] SegmentMap<'_>
}

contacts_of! {
    /// Writes the features of both levels that a body overlaps to `out`, which is cleared first.
    ///
    /// Each comes once, the nearest first, as in [`TileMap::contacts`].
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the nearest.
    [A: World, B: World] Joined<'_, A, B>
}

contacts_of! {
    /// Writes the features of the level at its current position that a body overlaps to `out`,
    /// which is cleared first; as [`TileMap::contacts`].
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the nearest.
    [W: World] Placed<'_, W>
}

contacts_of! {
    /// Writes the features of the solids at their current positions that a body overlaps to `out`,
    /// which is cleared first; as [`TileMap::contacts`].
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the nearest.
    [] Solids<'_>
}

contacts_of! {
    /// Writes the features of the solids at their current positions that a body overlaps to `out`,
    /// which is cleared first; as [`TileMap::contacts`].
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit: `out` then holds the nearest.
    [C: SolidShape] ConvexSolids<'_, C>
}

/// [`TileMap::contacts`] for any level.
pub(crate) fn contacts<W: World, B: Pushable>(
    world: &W,
    body: &B,
    one_way: OneWay,
    out: &mut VecView<WorldContact>,
) -> Result<u32, Truncated> {
    out.clear();
    body.contacts_in(world, one_way, out)
}

/// The contacts of one shape with these bounds, whose middle is in the solid or not.
#[inline(never)]
fn contacts_in<W: World, B: PushOne>(
    world: &W,
    body: &B,
    bounds: &Aabb,
    behind: bool,
    one_way: OneWay,
    out: &mut VecView<WorldContact>,
) -> Result<u32, Truncated> {
    let (mut features, mut seen, mut any_in_region) = (0u32, 0u32, false);
    let mut spare: Option<WorldContact> = None;
    let mut surface = world.features(bounds);
    while let Some(feature) = &surface.next() {
        features = features.wrapping_add(1);
        if feature.one_way && one_way == OneWay::Ignore {
            continue;
        }
        let Some((contact, in_region)) = &body.meet::<W>(feature, behind && !feature.one_way) else { continue };
        let (new, in_region) = (ContactRef { contact, feature }, *in_region);
        if B::ROUND && in_region != any_in_region {
            if any_in_region {
                continue;
            }
            // The first in its region: earlier ones do not count.
            out.clear();
            (seen, any_in_region) = (0, true);
        }
        if !B::ROUND && !in_region {
            if spare.as_ref().is_none_or(|spare| new.before::<W>(spare.found(), B::BY_DEPTH)) {
                spare = Some(new.kept());
            }
            continue;
        }
        if !is_listed(out, feature) {
            seen = seen.wrapping_add(1);
            insert::<W>(out, new, B::BY_DEPTH);
        }
    }
    if let (0, Some(spare)) = (seen, &spare) {
        seen = 1;
        insert::<W>(out, spare.found(), B::BY_DEPTH);
    }
    let kept = out.len() as u32;
    if kept == seen { Ok(features) } else { Err(Truncated { seen, kept }) }
}

/// Whether both are one piece of the surface.
pub(super) fn is_same(a: &Feature, b: &Feature) -> bool {
    (a.source, a.cell, a.index) == (b.source, b.cell, b.index)
}

/// Whether a list has a feature, which levels that store features by cells may report for each
/// cell.
pub(super) fn is_listed(out: &VecView<WorldContact>, feature: &Feature) -> bool {
    out.iter().any(|c| is_same(&c.feature, feature))
}

/// Inserts in order. If the list is full, the last contact is dropped.
#[inline(never)]
fn insert<W: World>(out: &mut VecView<WorldContact>, new: ContactRef<'_>, by_depth: bool) {
    if out.is_full() || out.push(new.kept()).is_err() {
        match out.last_mut() {
            Some(last) if new.before::<W>(last.found(), by_depth) => *last = new.kept(),
            _ => return,
        }
    }
    let mut i = out.len();
    while let Some([before, after]) = i.checked_sub(2).and_then(|first| out.get_mut(first..i)) {
        if !after.found().before::<W>(before.found(), by_depth) {
            return;
        }
        core::mem::swap(before, after);
        i = i.wrapping_sub(1);
    }
}

/// A shape that [`TileMap::contacts`] takes: any but a segment, and compounds of them.
///
/// The trait is sealed.
pub trait Pushable: kernel::PushKernel {}

pub(in crate::world) mod kernel {
    //! The part of [`Pushable`](crate::world::Pushable) that only this crate calls.

    use super::{Aabb, Contact, Feature, OneWay, Raw, Truncated, VecView, World, WorldContact, contacts_in};

    pub trait PushKernel {
        /// Writes all contacts in order to a list that is empty.
        fn contacts_in<W: World>(
            &self,
            world: &W,
            one_way: OneWay,
            out: &mut VecView<WorldContact>,
        ) -> Result<u32, Truncated>;
        /// The middle of a part; `None` beyond the last one.
        fn centre(&self, part: usize) -> Option<Raw>;
    }

    /// A shape that is no compound.
    pub trait PushOne {
        /// Whether all contacts count if none is in its region, not only the least. They are often
        /// ties, which none wins.
        const ROUND: bool;
        /// The bounding box, with the same middle.
        fn bounds(&self) -> Aabb;
        /// Whether contacts are in the order of their rounded depths, for bodies whose sides and
        /// radii give distances of several kinds.
        const BY_DEPTH: bool = false;
        /// The raw units around the middle: a point, if the sides are even. Rounding must not put
        /// it on the surface, where it would miss the features in front of it.
        fn middle(&self) -> Aabb {
            let bounds = self.bounds();
            let (lo, hi) = (bounds.lo(), bounds.hi());
            let last = Raw { x: (lo.x + hi.x + 1) >> 1, y: (lo.y + hi.y + 1) >> 1 };
            Aabb::from_raw_unchecked(Raw::of(bounds.centre()), last)
        }
        /// The contact with a feature, from behind as well if that is allowed, and whether it is in
        /// the feature's region.
        fn meet<W: World>(&self, feature: &Feature, behind: bool) -> Option<(Contact, bool)>;
    }

    impl<B: PushOne> PushKernel for B {
        fn contacts_in<W: World>(
            &self,
            world: &W,
            one_way: OneWay,
            out: &mut VecView<WorldContact>,
        ) -> Result<u32, Truncated> {
            let behind = world.overlaps_aabb(&self.middle());
            contacts_in(world, self, &self.bounds(), behind, one_way, out)
        }

        fn centre(&self, part: usize) -> Option<Raw> {
            (part == 0).then(|| self.middle().lo())
        }
    }
}
