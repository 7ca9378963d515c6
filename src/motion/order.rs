//! Chooses the first of the hits of one motion. The order of visits does not matter. The first of
//! these rules that distinguishes two hits decides:
//!
//! 1. The earlier one. A vertex or an arc, whose time is a bound, precedes a face only if that is
//!    exactly true.
//! 2. A face before a vertex or an arc.
//! 3. Between two faces, or two others: a hit that is not only at the feature's end, then the one
//!    that opposes the motion more. Then the normal decides: by the longer part along x, the longer
//!    part along y, and +x and +y before -x and -y.
//! 4. On the same surface: solid before one-way, then the smaller level, row, column and index. The
//!    flags of both count.

use super::body::{Body, Entry, may_be_round};
use crate::num::{Raw, add128, less128, mul_div, mul64, sqr64, umul};
use crate::world::{Feature, Geometry, World};

/// The first hit so far, kept separately for faces, which have exact times, and for vertices and
/// arcs, which have lower bounds.
///
/// Each is the first in its own order. Once all are known, the two are compared by exact values of
/// both. Bounds and exact times in one order could form a cycle: of three hits, each could precede
/// the next. The order of visits would then matter.
pub(super) struct First {
    flat: Candidate,
    round: Candidate,
}

/// The first hit of an order, entry and feature, or neither. A separate type, which is written in
/// place.
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

    /// Takes a hit that precedes all others.
    pub(super) fn only(&mut self, entry: &Entry, feature: &Feature) {
        self.flat = Candidate::empty();
        self.round.put(entry, feature);
    }

    /// Takes a hit of a face, the only one.
    #[inline]
    pub(super) fn only_flat(&mut self, entry: Entry, feature: Feature) {
        self.flat = Candidate { entry: Some(entry), feature: Some(feature) };
    }

    #[inline(never)]
    pub(super) fn add<B: Body, W: World>(&mut self, entry: &Entry, feature: &Feature, d: Raw) {
        debug_assert!(may_be_round::<W, B>() || entry.step.is_none(), "a round hit without its code");
        let slot = if !may_be_round::<W, B>() || entry.step.is_none() { &mut self.flat } else { &mut self.round };
        // A corner is of the cell of one of its edges. A body whose own corner meets it exactly,
        // and whose inside does not come to that cell, meets the other edge alone: it goes first.
        let sharp = B::ANGULAR && entry.step.is_none();
        let is_corner = |of: &Feature| sharp && matches!(of.geometry, Geometry::Vertex { .. });
        let before = |first: &Entry, of: &Feature| {
            if is_corner(feature) != is_corner(of) {
                entry.precedes(first).unwrap_or_else(|| is_corner(of))
            } else if W::BLOCKS && !B::ANGULAR {
                entry.before(first, d)
            } else {
                entry.before_askew(first, d)
            }
        };
        match (&slot.entry, &mut slot.feature) {
            (Some(first), Some(of)) if entry.same_as(first) && is_corner(feature) == is_corner(of) => {
                merge(of, feature);
            }
            (Some(first), Some(of)) if !before(first, of) => {}
            _ => slot.put(entry, feature),
        }
    }

    /// When a hit is, if there is one: a fraction. It may not be the first one.
    pub(super) fn time(&self) -> Option<(u32, u32)> {
        let found = self.flat.entry.as_ref().or(self.round.entry.as_ref());
        found.map(|entry| (entry.num, entry.den))
    }

    /// Whether there is a hit in the first `piece` of `pieces` pieces of the motion.
    pub(super) fn is_within(&self, piece: u32, pieces: u32) -> bool {
        let within = |slot: &Candidate| slot.entry.as_ref().is_some_and(|e| umul(e.num, pieces) <= umul(e.den, piece));
        within(&self.flat) || within(&self.round)
    }

    /// The first of all hits; of the same moment, the face.
    pub(super) fn hit<B: Body, W: World>(&self, body: &B, d: Raw) -> Option<(&Entry, &Feature)> {
        if !may_be_round::<W, B>() || self.round.entry.is_none() {
            return self.flat.hit();
        }
        let round = self.round.hit();
        match (self.flat.hit(), round) {
            (Some(flat), Some(after)) if !is_earlier::<B, W>(body, d, after, flat.0) => Some(flat),
            _ => round,
        }
    }
}

/// Whether a body meets a vertex or an arc before the moment at which it meets a face.
///
/// If the bound is early by less than a raw unit of way, the position at the moment of the face
/// decides. The vertex or arc is earlier if the body is then inside of the disc that it enters, or
/// already leaves it. It is earlier, too, if the body is outside of the disc that it leaves.
#[inline(never)]
fn is_earlier<B: Body, W: World>(body: &B, d: Raw, (round, feature): (&Entry, &Feature), flat: &Entry) -> bool {
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
            let p = Raw::of(p);
            let (c, r) = body.met_by(p, round);
            is_past(c.sub(p), r, false, d, flat)
        }
        Geometry::Arc { centre, radius, quadrant, convex } if W::ARCS => {
            let way = if convex { quadrant.reversed() } else { quadrant };
            let centre = Raw::of(centre);
            let (at, r) = if B::ANGULAR { body.met_by(centre, round) } else { body.toward(way) };
            let r = if convex { radius.wrapping_add(r) } else { radius.wrapping_sub(r) };
            is_past(at.sub(centre), r, !convex, d, flat)
        }
        Geometry::Face { .. } | Geometry::Arc { .. } => true,
    }
}

/// Whether the point `m` that moves by `d` has, before a moment, entered the disc of radius `r`
/// around the origin, or left it.
///
/// The moment is a fraction, and values are in units of its divisor. |m| and r are below 2^30, |d|
/// below 2^28 and the fraction's terms at most 2^30. So the point is below 2^61 and its square
/// below 2^122.
#[inline(never)]
fn is_past(m: Raw, r: i32, leaves: bool, d: Raw, at: &Entry) -> bool {
    let time = Raw { x: at.den as i32, y: at.num as i32 };
    let coordinate = |m: i32, d: i32| Raw { x: m, y: d }.dot(time).unsigned_abs();
    let square = add128(sqr64(coordinate(m.x, d.x)), sqr64(coordinate(m.y, d.y)));
    let rim = sqr64(umul(r.unsigned_abs(), at.den));
    if leaves {
        return less128(rim, square);
    }
    let toward = m.dot(d).wrapping_neg();
    // It enters: it approaches the centre until the time `toward` / |d|^2.
    less128(square, rim) || toward <= 0 || !less128(mul64(d.len2(), at.num.into()), mul64(toward as u64, at.den.into()))
}

/// Merges two features that are one surface at the moment of the hit. The solid one stands for
/// both, otherwise the first row by row, with the flags of both.
fn merge(into: &mut Feature, other: &Feature) {
    let flags = into.flags | other.flags;
    let key = |f: &Feature| (f.one_way, f.source, f.cell.y, f.cell.x, f.index);
    if key(other) < key(into) {
        *into = *other;
    }
    into.flags = flags;
}
