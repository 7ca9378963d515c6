//! Which of the hits of one motion is the first. The order of visits plays no part; the first of
//! these that tells two hits apart decides:
//!
//! 1. The earlier one. A vertex or an arc, whose time is a bound, is before a face where that is so
//!    exactly.
//! 2. A face before a vertex or an arc.
//! 3. Of two faces, or of two others, what is not met at its end alone; what opposes the motion
//!    more; then the normal, by the longer part along x, the longer part along y, and +x and +y
//!    before -x and -y.
//! 4. Of one surface what is solid, not one-way; then the level, the row, the column and the index
//!    that are less. The flags of both count.

use super::body::{Body, Entry};
use crate::num::{Raw, add128, imul, less128, mul_div, mul64, sqr64, umul};
use crate::world::{Feature, Geometry, World};

/// The first hit so far: of faces, whose times are exact, and of vertices and arcs, whose times are
/// lower bounds.
///
/// Each is the first by an order of its own, and the two are compared by what is exact of both once
/// all are known. So the order of visits does not matter, as it might if bounds and exact times
/// were in one order: of three, each could be before the next.
pub(super) struct First {
    flat: Candidate,
    round: Candidate,
}

/// The first of an order: both or none. Apart, so that each is written in its place.
struct Candidate {
    entry: Option<Entry>,
    feature: Option<Feature>,
}

impl Candidate {
    #[inline]
    fn empty() -> Self {
        Self { entry: None, feature: None }
    }

    fn put(&mut self, entry: &Entry, feature: &Feature) {
        (self.entry, self.feature) = (Some(*entry), Some(*feature));
    }

    fn hit(&self) -> Option<(&Entry, &Feature)> {
        self.entry.as_ref().zip(self.feature.as_ref())
    }
}

impl First {
    #[inline]
    pub(super) fn none() -> Self {
        Self { flat: Candidate::empty(), round: Candidate::empty() }
    }

    /// Takes a hit that is before all others.
    pub(super) fn only(&mut self, entry: &Entry, feature: &Feature) {
        self.flat = Candidate::empty();
        self.round.put(entry, feature);
    }

    #[inline(never)]
    pub(super) fn add<B: Body, W: World>(&mut self, entry: &Entry, feature: &Feature, d: Raw) {
        let all_flat = W::BLOCKS && !B::MEETS_CORNERS;
        let slot = if all_flat || entry.step.is_none() { &mut self.flat } else { &mut self.round };
        let before = |first: &Entry| if W::BLOCKS { entry.before(first, d) } else { entry.before_askew(first, d) };
        match (&slot.entry, &mut slot.feature) {
            (Some(first), Some(of)) if entry.same_as(first) => merge(of, feature),
            (Some(first), _) if !before(first) => {}
            _ => slot.put(entry, feature),
        }
    }

    /// Whether there is one in the first `piece` of so many pieces of the motion.
    pub(super) fn is_within(&self, piece: u32, pieces: u32) -> bool {
        let within = |slot: &Candidate| slot.entry.as_ref().is_some_and(|e| umul(e.num, pieces) <= umul(e.den, piece));
        within(&self.flat) || within(&self.round)
    }

    /// The first of all; of one moment the face.
    pub(super) fn hit<B: Body, W: World>(&self, body: &B, d: Raw) -> Option<(&Entry, &Feature)> {
        if (W::BLOCKS && !B::MEETS_CORNERS) || self.round.entry.is_none() {
            return self.flat.hit();
        }
        let round = self.round.hit();
        match (self.flat.hit(), round) {
            (Some(flat), Some(after)) if !is_earlier(body, d, after, flat.0) => Some(flat),
            _ => round,
        }
    }
}

/// Whether a body meets a vertex or an arc before the moment at which it meets a face.
///
/// Where it does so by a bound that is early by less than a raw unit of way, the place at the
/// moment of the face decides: inside of the disc that it enters, or already leaving it; outside of
/// the disc that it leaves.
fn is_earlier<B: Body>(body: &B, d: Raw, (round, feature): (&Entry, &Feature), flat: &Entry) -> bool {
    if umul(round.num, flat.den) >= umul(flat.num, round.den) {
        return false;
    }
    let longest = d.x.unsigned_abs().max(d.y.unsigned_abs());
    let way = |e: &Entry| mul_div(longest, e.num, e.den);
    if way(flat) > way(round) + 2 {
        return true;
    }
    match feature.geometry {
        Geometry::Vertex { p, .. } => {
            let (c, r) = body.toward(round.normal.reversed());
            is_past(c.sub(Raw::of(p)), r, false, d, flat)
        }
        Geometry::Arc { centre, radius, quadrant, convex } => {
            let (at, r) = body.toward(if convex { quadrant.reversed() } else { quadrant });
            let r = if convex { radius.wrapping_add(r) } else { radius.wrapping_sub(r) };
            is_past(at.sub(Raw::of(centre)), r, !convex, d, flat)
        }
        Geometry::Face { .. } => true,
    }
}

/// Whether the point `m` that moves by `d` has entered the disc of radius `r` around the origin
/// before a moment, or left it.
///
/// With the moment as a fraction, in units of its divisor: |m| and r are below 2^30, |d| below 2^28
/// and the fraction's terms up to 2^30, so the point is below 2^61 and its square below 2^122.
#[inline(never)]
fn is_past(m: Raw, r: i32, leaves: bool, d: Raw, at: &Entry) -> bool {
    let coordinate = |m: i32, d: i32| imul(m, at.den as i32).wrapping_add(imul(d, at.num as i32)).unsigned_abs();
    let square = add128(sqr64(coordinate(m.x, d.x)), sqr64(coordinate(m.y, d.y)));
    let rim = sqr64(umul(r.unsigned_abs(), at.den));
    if leaves {
        return less128(rim, square);
    }
    let toward = m.dot(d).wrapping_neg();
    // It enters: it comes nearer until `toward` / |d|^2.
    less128(square, rim) || toward <= 0 || !less128(mul64(d.len2(), at.num.into()), mul64(toward as u64, at.den.into()))
}

/// Two features that are one surface at the moment of the hit: the solid one stands for both, else
/// the first row by row, with the flags of both.
fn merge(into: &mut Feature, other: &Feature) {
    let flags = into.flags | other.flags;
    let key = |f: &Feature| (f.one_way, f.source, f.cell.y, f.cell.x, f.index);
    if key(other) < key(into) {
        *into = *other;
    }
    into.flags = flags;
}
