//! Capsules, oriented boxes, convex polygons and compounds in every kind of level: whether they
//! meet it, and the contacts with one feature that they overlap.
//!
//! A contact has the depth and the direction of the way out. Boxes and circles have separate
//! kernels. A convex body has the same contacts as a box. At a face, that is the deepest part of
//! the body. At a corner or an arc, it is the least exit in the feature's cone of normals. That is
//! across one of the body's sides, or past one of its rounded corners.

use super::closest::OneWay;
use super::contacts::kernel::{PushKernel, PushOne};
use super::contacts::{Pushable, WorldContact, is_listed, is_same};
use super::convex::ConvexBody;
use super::joined::Joined;
use super::level::{Feature, Geometry, World, ends, in_quadrant, normal, raw};
use super::measure::{boxed, circle, into_disc};
use super::placed::Placed;
use super::segment_map::SegmentMap;
use super::solids::Solids;
use super::solids::convex::ConvexSolids;
use super::solids::convex_solid::SolidShape;
use super::tile_map::{ShapeSet, Store, TileMap};
use crate::error::Truncated;
use crate::num::{Axis, Raw, less128, mul64, sqr64, usqr};
use crate::query::closest::on_segment;
use crate::query::{ArcCell, Contact, Core, Overlaps, Touches, meets};
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Compound, Convex, ConvexPolygon, OrientedBox, Single};
use heapless::VecView;

/// Asks a level about a shape.
fn ask<W: World, B: Convex>(world: &W, shape: &B, bounds: Aabb, closed: bool) -> bool {
    let corners = shape.outline();
    let core = Core { corners: &corners, radius: shape.rounding() };
    world.meets_convex(&ConvexBody { core, bounds, offset: Raw::ZERO }, closed)
}

impl<const N: usize> AnyShape<N> {
    /// Whether this shape overlaps a level: strict and exact, as `overlaps` of the level.
    ///
    /// ```
    /// use tilesat::shape::AnyShape;
    /// use tilesat::{Axis, OrientedBox, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
    /// let kite = |y| OrientedBox::new(Vec2::from_ints(8, y), Vec2::from_ints(5, 5), Axis::new(3, 4));
    /// let (high, low): (AnyShape<4>, AnyShape<4>) = (kite(9)?.into(), kite(10)?.into());
    /// assert!(low.overlaps_level(&level) && !high.overlaps_level(&level)); // touching is not overlapping
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn overlaps_level(&self, level: &impl World) -> bool {
        ask(level, self, self.aabb(), false)
    }
}

macro_rules! convex_meets {
    ([$($parameters:tt)*] $level:ty, [$($n:tt)*] $body:ty) => {
        impl<$($parameters)* $($n)*> Overlaps<$body> for $level {
            fn overlaps(&self, b: &$body) -> bool {
                ask(self, b, b.aabb(), false)
            }
        }

        impl<$($parameters)* $($n)*> Touches<$body> for $level {
            fn touches(&self, b: &$body) -> bool {
                ask(self, b, b.aabb(), true)
            }
        }
    };
}

macro_rules! all_convex {
    ($([$($parameters:tt)*] $level:ty;)*) => {
        $(
            convex_meets! { [$($parameters)*] $level, [] Capsule }
            convex_meets! { [$($parameters)*] $level, [] OrientedBox }
            convex_meets! { [$($parameters)*] $level, [const N: usize] ConvexPolygon<N> }
            convex_meets! { [$($parameters)*] $level, [const N: usize] AnyShape<N> }

            impl<$($parameters)* P: Single, const M: usize> Overlaps<Compound<P, M>> for $level
            where
                Self: Overlaps<P>,
            {
                fn overlaps(&self, b: &Compound<P, M>) -> bool {
                    World::overlaps_aabb(self, &b.aabb()) && b.parts().iter().any(|part| Overlaps::overlaps(self, part))
                }
            }

            impl<$($parameters)* P: Single, const M: usize> Touches<Compound<P, M>> for $level
            where
                Self: Touches<P>,
            {
                fn touches(&self, b: &Compound<P, M>) -> bool {
                    World::touches_aabb(self, &b.aabb()) && b.parts().iter().any(|part| Touches::touches(self, part))
                }
            }
        )*
    };
}

all_convex! {
    [S: ShapeSet, T: Store,] TileMap<'_, S, T>;
    [] SegmentMap<'_>;
    [] Solids<'_>;
    [C: SolidShape,] ConvexSolids<'_, C>;
    [A: World, B: World,] Joined<'_, A, B>;
    [W: World,] Placed<'_, W>;
}

macro_rules! pushed {
    ([$($n:tt)*] $body:ty) => {
        impl<$($n)*> Pushable for $body {}

        impl<$($n)*> PushOne for $body {
            const ROUND: bool = false;
            const BY_DEPTH: bool = true;

            fn bounds(&self) -> Aabb {
                self.aabb()
            }

            fn middle(&self) -> Aabb {
                middle(&self.outline())
            }

            fn meet<W: World>(&self, feature: &Feature, behind: bool) -> Option<(Contact, bool)> {
                let corners = self.outline();
                let core = Core { corners: &corners, radius: self.rounding() };
                let body = Pushed { core, middle: middle(&corners).lo() };
                match feature.geometry {
                    Geometry::Arc { .. } if !W::ROUND => None,
                    _ => body.meet(feature, behind),
                }
            }
        }
    };
}

pushed!([] Capsule);
pushed!([] OrientedBox);
pushed!([const N: usize] ConvexPolygon<N>);
pushed!([const N: usize] AnyShape<N>);

/// The raw units around the mean of the corners, which is inside of the body.
fn middle(corners: &[crate::num::Vec2]) -> Aabb {
    let count = corners.len().max(1) as i64;
    let sum = corners.iter().fold((0i64, 0i64), |sum, p| {
        let p = Raw::of(*p);
        (sum.0.wrapping_add(p.x.into()), sum.1.wrapping_add(p.y.into()))
    });
    // By repeated halving: a chip has no 64-bit division.
    let floor = |sum: i64| {
        let (mut part, mut rest) = (0i64, sum.wrapping_add(count << 30));
        for bit in (0..31).rev() {
            if rest >= count << bit {
                (part, rest) = (part.wrapping_add(1 << bit), rest.wrapping_sub(count << bit));
            }
        }
        (part.wrapping_sub(1 << 30) as i32, i32::from(rest != 0))
    };
    let ((x, a), (y, b)) = (floor(sum.0), floor(sum.1));
    Aabb::from_raw_unchecked(Raw { x, y }, Raw { x: x.wrapping_add(a), y: y.wrapping_add(b) })
}

impl Pushable for Aabb {}
impl Pushable for Circle {}

impl PushOne for Aabb {
    const ROUND: bool = false;
    fn bounds(&self) -> Aabb {
        *self
    }
    fn meet<W: World>(&self, feature: &Feature, behind: bool) -> Option<(Contact, bool)> {
        boxed::<W>(self.lo(), self.hi(), Raw::of(self.centre()), feature, behind)
    }
}

impl PushOne for Circle {
    const ROUND: bool = true;
    fn bounds(&self) -> Aabb {
        self.aabb()
    }
    fn meet<W: World>(&self, feature: &Feature, behind: bool) -> Option<(Contact, bool)> {
        circle::<W>(self.c(), self.r(), feature, behind)
    }
}

struct Pushed<'a> {
    core: Core<'a>,
    middle: Raw,
}

impl Pushed<'_> {
    fn meet(&self, feature: &Feature, behind: bool) -> Option<(Contact, bool)> {
        match feature.geometry {
            Geometry::Face { a, dir, len, joined } => {
                let (a, b) = ends(Raw::of(a), dir, len);
                self.face((a, b), dir, joined, behind)
            }
            Geometry::Vertex { p, e_in, e_out } => {
                let p = Raw::of(p);
                if !meets::<false>(self.core, Core { corners: &[p.vec2()], radius: 0 }) {
                    return None;
                }
                let in_cone = |n: Axis| n.dot(e_in) > 0 && n.dot(e_out) < 0;
                self.exit(p, 0, &in_cone, behind, false).map(|contact| (contact, true))
            }
            Geometry::Arc { centre, radius, quadrant, convex } => {
                let centre = Raw::of(centre);
                let cell = ArcCell { centre, left: quadrant.x < 0, above: quadrant.y < 0, side: radius };
                let contact = if convex {
                    if !cell.convex_meets::<false>(self.core) {
                        return None;
                    }
                    let in_cone = |n: Axis| in_quadrant(Raw { x: n.x, y: n.y }, quadrant);
                    self.exit(centre, radius, &in_cone, behind, true)
                } else {
                    if !cell.concave_meets::<false>(self.core) {
                        return None;
                    }
                    self.pipe(centre, radius, quadrant, behind)
                };
                contact.map(|contact| (contact, true))
            }
        }
    }

    fn face(&self, (a, b): (Raw, Raw), dir: Axis, joined: [bool; 2], behind: bool) -> Option<(Contact, bool)> {
        let n = normal(dir);
        let line = [a.vec2(), b.vec2()];
        let corners = if a == b { &line[..1] } else { &line };
        let crosses = meets::<false>(self.core, Core { corners, radius: 0 });
        if !crosses || (!behind && raw(n).dot(self.middle.sub(a)) < 0) {
            return None;
        }
        let (first, last) = self.core.facing(dir);
        let (first, last) = (self.core.corner(first), self.core.corner(last));
        let (before, after) = (raw(dir).dot(last.sub(a)) < 0, raw(dir).dot(first.sub(b)) > 0);
        // The middle of what a parallel side and the face share.
        let from = if raw(dir).dot(first.sub(a)) < 0 && !before { on_segment(a, first, last) } else { first };
        let to = if raw(dir).dot(last.sub(b)) > 0 && !after { on_segment(b, first, last) } else { last };
        let at = Raw { x: from.x.wrapping_add(to.x) >> 1, y: from.y.wrapping_add(to.y) >> 1 };
        let overlap = raw(n).dot(first.sub(a)).wrapping_neg();
        let contact = Contact::new(n.reversed(), overlap, at).with_radii(self.core.radius, 0);
        Some((contact, (joined[0] || !before) && (joined[1] || !after)))
    }

    /// The least exit from a point with a radius, by normals in its cone. Normals that the middle
    /// is not in front of count only from behind or, for an arc, if there are no others.
    fn exit(&self, p: Raw, radius: i32, in_cone: &dyn Fn(Axis) -> bool, behind: bool, any: bool) -> Option<Contact> {
        let (core, mut best, mut hidden) = (self.core, None, None);
        let mut consider = |contact: Contact| {
            let n = contact.axis.reversed();
            let slot = if behind || self.is_in_front(p, radius, n) { &mut best } else { &mut hidden };
            let key = |c: &Contact| {
                let Axis { x, y } = c.axis.reversed();
                (c.depth(), y != 0, x != 0, x < 0, y < 0, (y, x))
            };
            if slot.as_ref().is_none_or(|kept| key(&contact) < key(kept)) {
                *slot = Some(contact);
            }
        };
        for i in 0..core.corners.len() {
            let (here, next, last) = (core.corner(i), core.corner(core.after(i)), core.corner(core.before(i)));
            let n = core.facing_normal(i);
            if !n.is_zero() && in_cone(n) {
                let overlap = raw(n).dot(p.sub(here));
                let at = on_segment(p, here, next);
                consider(Contact::new(n.reversed(), overlap, at).with_radii(core.radius, radius));
            }
            let m = here.sub(p);
            let own = next.sub(here).dot(m) >= 0 && last.sub(here).dot(m) >= 0 && !m.is_zero();
            if core.radius.wrapping_add(radius) > 0 && own && in_cone(Axis::new(m.x, m.y)) {
                consider(Contact::radial(here, m.reversed()).with_radii(core.radius, radius));
            }
        }
        best.or(if any { hidden } else { None })
    }

    /// Whether the middle is in front of the tangent with this normal.
    fn is_in_front(&self, p: Raw, radius: i32, n: Axis) -> bool {
        let height = raw(n).dot(self.middle.sub(p));
        let reach = mul64(usqr(radius.unsigned_abs()), n.length_squared());
        height >= 0 && !less128(sqr64(height.unsigned_abs()), reach)
    }

    /// The exit of the corner that is farthest out of a quarter pipe.
    fn pipe(&self, centre: Raw, radius: i32, quadrant: Axis, behind: bool) -> Option<Contact> {
        let middle = self.middle.sub(centre);
        if !behind && in_quadrant(middle, quadrant) && middle.len2() > usqr(radius.unsigned_abs()) {
            return None;
        }
        let corners = (0..self.core.corners.len()).map(|i| self.core.corner(i));
        let farthest = corners.filter(|w| in_quadrant(w.sub(centre), quadrant)).max_by_key(|w| {
            let m = w.sub(centre);
            (m.len2(), m.x.unsigned_abs())
        })?;
        let contact = into_disc(farthest, farthest.sub(centre), quadrant);
        Some(contact.with_radii(self.core.radius, radius.wrapping_neg()))
    }
}

impl<S: Single + PushOne, const M: usize> Pushable for Compound<S, M> {}

impl<S: Single + PushOne, const M: usize> PushKernel for Compound<S, M> {
    /// A feature is listed with its final depth, so a full list keeps the nearest of all. For that,
    /// each part first decides which of its contacts count.
    fn contacts_in<W: World>(
        &self,
        world: &W,
        one_way: OneWay,
        out: &mut VecView<WorldContact>,
    ) -> Result<u32, Truncated> {
        let (bounds, counts) = (self.aabb(), |f: &Feature| !(f.one_way && one_way == OneWay::Ignore));
        let (mut features, mut seen) = (0u32, 0u32);
        if !world.features(&bounds).any(|f| counts(&f)) {
            return Ok(0);
        }
        let sights: [Sight; M] = core::array::from_fn(|i| match self.parts().get(i) {
            Some(part) => Sight::of(part, world, counts, &mut features),
            None => Sight::NONE,
        });
        let mut surface = world.features(&bounds);
        while let Some(feature) = &surface.next() {
            features = features.wrapping_add(1);
            if !counts(feature) || is_listed(out, feature) {
                continue;
            }
            let all = self.parts().iter().zip(&sights);
            let met = all.filter_map(|(part, sight)| sight.meet::<W, S>(part, feature));
            if let Some(deepest) = met.max_by_key(|c| (c.depth(), order(c.axis()), c.point().raw())) {
                seen = seen.wrapping_add(1);
                deepest.insert_in::<W>(out);
            }
        }
        let kept = out.len() as u32;
        if kept == seen { Ok(features) } else { Err(Truncated { seen, kept }) }
    }

    fn centre(&self, part: usize) -> Option<Raw> {
        self.parts().get(part)?.centre(0)
    }
}

const fn order(axis: Axis) -> (u32, u32, i32, i32) {
    (axis.x.unsigned_abs(), axis.y.unsigned_abs(), axis.x, axis.y)
}

/// Which contacts of a part count.
struct Sight {
    /// Whether its middle is in the solid.
    behind: bool,
    /// Whether it is in the region of a feature. Other features do not count then.
    in_region: bool,
    /// Otherwise the one that counts, unless all count.
    spare: Option<WorldContact>,
}

impl Sight {
    const NONE: Self = Self { behind: false, in_region: false, spare: None };

    fn of<W: World, S: PushOne>(part: &S, world: &W, counts: impl Fn(&Feature) -> bool, features: &mut u32) -> Self {
        let mut sight = Self { behind: world.overlaps_aabb(&part.middle()), ..Self::NONE };
        let bounds: Aabb = part.bounds();
        for feature in world.features(&bounds) {
            *features = features.wrapping_add(1);
            if !counts(&feature) {
                continue;
            }
            let Some((contact, in_region)) = part.meet::<W>(&feature, sight.behind && !feature.one_way) else {
                continue;
            };
            if in_region {
                return Self { in_region, spare: None, ..sight };
            }
            let new = WorldContact::new(contact, feature);
            if !S::ROUND && sight.spare.as_ref().is_none_or(|spare| new.goes_before::<W>(spare, S::BY_DEPTH)) {
                sight.spare = Some(new);
            }
        }
        sight
    }

    fn meet<W: World, S: PushOne>(&self, part: &S, feature: &Feature) -> Option<WorldContact> {
        let (contact, in_region) = part.meet::<W>(feature, self.behind && !feature.one_way)?;
        let is_spare = S::ROUND || self.spare.as_ref().is_some_and(|spare| is_same(&spare.feature(), feature));
        (in_region || (!self.in_region && is_spare)).then(|| WorldContact::new(contact, *feature))
    }
}
