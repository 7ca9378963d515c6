//! The ways on from a position: a velocity and its projections on all surfaces that the body
//! touches there, and which of them are free.
//!
//! A hit projects the velocity on the cone of the directions that are free at the body's *present*
//! position. That cone need not be convex. Its boundary consists of tangents of the touched
//! surfaces. So the answer is the longest projection that no touched surface blocks. Surfaces that
//! the body has left behind do not count.

use super::body::{Body, may_be_round};
use super::contact::{Bend, Plane, may_reach, reaches, surroundings, touched};
use super::free_way::{FreeWay, room_to};
use super::moved::Hits;
use super::order::First;
use super::plane::{FAR, NEAR, into, long, project, way};
use super::response::Smooth;
use crate::num::{Axis, Raw, Toi};
use crate::world::{Feature, Geometry, World, normal};
use core::ops::Range;
use core::slice::from_ref;
use heapless::Vec;

/// The ways on from a place, the longest first. An empty list writes none of its 520 bytes.
pub(super) struct Ways {
    list: Vec<FreeWay, { Ways::MAX }, u8>,
    near: NearFeatures,
}

/// The features within [`FAR`] of a body, read once for all ways.
///
/// Nine in ten bodies that choose a way are near three or four. With more than six, the level is
/// read again. The last two places take 80 bytes of stack, and a fifth from one frame in a thousand
/// of boxes. Ten more take nothing.
struct NearFeatures {
    features: Vec<Feature, 6, u8>,
    all: bool,
}

impl NearFeatures {
    fn push(&mut self, feature: &Feature) {
        self.all &= self.features.extend_from_slice(from_ref(feature)).is_ok();
    }

    /// Visits all of them; one-way faces only if they are solid to the body.
    #[inline(never)]
    fn each<W: World, B: Body>(&self, world: &W, body: &B, passes: bool, visit: &mut dyn FnMut(&Feature)) {
        if self.all {
            self.features.iter().for_each(visit);
        } else {
            each_near(world, body, passes, visit);
        }
    }
}

/// Reads the features within [`FAR`] of a body's bounds. It calls the visitor through a pointer:
/// three copies of the walk over a level took 2 KB of flash.
#[inline(never)]
fn each_near<W: World, B: Body>(world: &W, body: &B, passes: bool, visit: &mut dyn FnMut(&Feature)) {
    let region = surroundings(&body.bounds(), FAR);
    let mut features = world.features_near(&region, body.meets_joints());
    while let Some(feature) = &world.next_near(&mut features) {
        let is_exact = W::GRID && W::BLOCKS;
        debug_assert!(!is_exact || reaches(feature, &region), "a block gave a feature beyond the region");
        // Blocks give only what is in the region: 100 bytes less.
        if !(feature.one_way && passes) && (is_exact || reaches(feature, &region)) {
            visit(feature);
        }
    }
}

/// Whether a feature is a face with this normal. No way along another such face leads into it.
fn is_parallel(feature: &Feature, n: Axis) -> bool {
    matches!(feature.geometry, Geometry::Face { dir, .. } if normal(dir) == n)
}

impl Ways {
    /// The velocity itself; at most six along x and y, which faces and their ends give on both
    /// sides; three slopes or corners. With eight, 24 bodies in gaps as wide as themselves stopped
    /// dead in ten million random frames. If there are more, the shortest are left out.
    const MAX: usize = 10;

    #[inline]
    pub(super) const fn none() -> Self {
        Self { list: Vec::new(), near: NearFeatures { features: Vec::new(), all: true } }
    }

    /// Reads the ways of a velocity from the body's position, and along the surface that was hit,
    /// in the remaining time. It does not find out yet which are free. Returns whether there is
    /// nothing within [`FAR`] but the face that was hit. The way along that face is then free, and
    /// the velocity leads into it.
    #[inline(never)]
    pub(super) fn read<W: World, B: Body>(
        &mut self,
        world: &W,
        body: &B,
        (v, time): (Raw, Toi),
        hit: Option<Plane>,
        passes: bool,
    ) -> bool {
        self.list.clear();
        self.near.features.clear();
        self.near.all = true;
        self.add(&mut FreeWay::of(None, v, long(v), false), v);
        let mut alone = true;
        each_near(world, body, passes, &mut |feature| {
            let touches = touched::<W, B>(body, feature, &mut |plane| {
                if hit == Some(plane) {
                    return;
                }
                alone = false;
                self.consider::<W, B>(plane, v, time);
            });
            if touches || may_reach::<W, B>(body, feature, FAR + 1) {
                self.near.push(feature);
                alone &= touches || (!W::BLOCKS && hit.is_some_and(|hit| is_parallel(feature, hit.normal)));
            }
        });
        if let Some(plane) = hit {
            self.consider::<W, B>(plane, v, time);
        }
        if !alone && may_be_round::<W, B>() {
            self.consider_gaps::<W, B>(v, time);
        }
        alone && hit.is_some_and(|plane| plane.bend == Bend::Flat && into(v, plane.normal) < 0)
    }

    /// Between two corners or arcs the way leads across the line through their centres, as through
    /// a gap exactly as wide as the body.
    fn consider_gaps<W: World, B: Body>(&mut self, v: Raw, time: Toi) {
        // An added way moves others back by one: some pairs come twice, and none is left out.
        for k in 0..Self::MAX {
            let Some(a) = self.corner(k) else { continue };
            for j in k + 1..Self::MAX {
                let Some(b) = self.corner(j).filter(|b| a.dot(*b) < 0) else { continue };
                let normal = Axis::new(a.x.wrapping_sub(b.x), a.y.wrapping_sub(b.y));
                self.consider::<W, B>(Plane { normal, bend: Bend::End }, v, time);
            }
        }
    }

    /// The normal of a way along a corner or an arc from outside.
    fn corner(&self, k: usize) -> Option<Axis> {
        let plane = self.way(k)?.along?;
        (plane.bend == Bend::Convex).then_some(plane.normal)
    }

    /// Takes the projection of a velocity on a plane, if it is a way.
    #[inline(never)]
    fn consider<W: World, B: Body>(&mut self, plane: Plane, v: Raw, time: Toi) {
        debug_assert!(may_be_round::<W, B>() || plane.bend != Bend::Convex, "a round plane without its code");
        let plane = plane.against(v);
        if self.iter().any(|way| way.along == Some(plane)) {
            return;
        }
        let along = project::<B, W, _>(v, plane.normal, &Smooth);
        let (mut plane, mut probe) = (plane, long(along));
        if let Some(pipe) = if W::ROUND { plane.pipe() } else { None } {
            let Some(chord) = pipe.chord(v, time, &Smooth) else { return };
            if chord.way.is_zero() {
                // Already at the end of the pipe, where its tangent leads on.
                plane.bend = Bend::Flat;
            } else {
                // A tangent leads into the surface beyond the pipe's end. So no probe is longer
                // than a chord.
                let longer = if way(chord.way) < 2 * FAR { pipe.chord(long(v), Toi::ONE, &Smooth) } else { None };
                probe = longer.unwrap_or(chord).way;
            }
        }
        // A way slower than its rounding leads nowhere. A body that gravity presses into a shallow
        // wedge therefore stops.
        let is_exact = plane.normal.x == 0 || plane.normal.y == 0;
        if !along.is_zero() && (is_exact || way(along) > NEAR) {
            let n = plane.normal;
            let presses = into(v, n) < 0;
            self.add(&mut FreeWay::of(Some(plane), along, probe, presses), v);
        }
    }

    fn add(&mut self, way: &mut FreeWay, of: Raw) {
        for other in &mut self.list {
            if way.goes_before(other, of) {
                (*other, *way) = (*way, *other);
            }
        }
        // If the list is full, the shortest stays out.
        let _ = self.list.extend_from_slice(from_ref(way));
    }

    /// Frees all ways: nothing else is near, so nothing binds them.
    pub(super) fn free(&mut self) {
        self.list.iter_mut().for_each(FreeWay::free);
    }

    /// Finds out how far each way leads.
    pub(super) fn settle_all<W: World, B: Body>(&mut self, world: &W, body: &B, passes: bool) {
        self.settle::<W, B>(world, body, passes, 0..self.list.len());
    }

    /// Finds out how far some of the ways lead, unless that is already known.
    #[inline(never)]
    fn settle<W: World, B: Body>(&mut self, world: &W, body: &B, passes: bool, which: Range<usize>) {
        let Some(ways) = self.list.get_mut(which) else { return };
        let mut any = false;
        for way in ways.iter_mut().filter(|way| !way.is_settled()) {
            way.free();
            any = true;
        }
        if any {
            self.near.each(world, body, passes, &mut |feature| {
                for way in ways.iter_mut() {
                    way.bind_by::<W, B>(body, feature);
                }
            });
        }
    }

    /// Which is the longest free way of those that `asked` accepts.
    ///
    /// It settles them one by one, because the first is usually free. If each would read the level
    /// again, it settles all at once.
    #[inline(never)]
    pub(super) fn first_free<W: World, B: Body>(
        &mut self,
        world: &W,
        body: &B,
        passes: bool,
        asked: &dyn Fn(&FreeWay) -> bool,
    ) -> Option<usize> {
        if !self.near.all {
            self.settle_all(world, body, passes);
        }
        (0..self.list.len()).find(|&k| {
            if !self.way(k).is_some_and(asked) {
                return false;
            }
            self.settle::<W, B>(world, body, passes, k..k + 1);
            self.way(k).is_some_and(FreeWay::is_free)
        })
    }

    pub(super) fn way(&self, k: usize) -> Option<&FreeWay> {
        self.list.get(k)
    }

    /// The other surface that binds a way: the first touched one that its probe meets and that the
    /// hits do not report yet.
    #[inline(never)]
    pub(super) fn binding<W: World, B: Body>(&self, world: &W, body: &B, probe: Raw, hits: &Hits, first: &mut First) {
        self.near.each(world, body, true, &mut |feature| {
            // One-way faces are reported when a motion runs into them. Beside them, their front
            // counts.
            if feature.one_way {
                return;
            }
            let Some(entry) = &body.sweep_in::<W>(probe, feature) else { return };
            if !hits.already_lists(entry.normal, feature) && room_to(probe, entry).is_some() {
                first.add::<B, W>(entry, feature, probe);
            }
        });
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &FreeWay> {
        self.list.iter()
    }

    /// Whether the body still touches a plane that it has run along, if that is a face. A box also
    /// runs along a corner that touches its side.
    pub(super) fn keep<B: Body>(&self, plane: &Plane) -> bool {
        let side = !B::MEETS_CORNERS && !B::ANGULAR;
        let is = |p: &Plane| if side { p.normal == plane.normal } else { p == plane };
        !matches!(plane.bend, Bend::Flat | Bend::End) || self.iter().any(|way| way.along.as_ref().is_some_and(is))
    }
}
