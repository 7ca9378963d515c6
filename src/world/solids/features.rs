//! The faces and corners of solids. In a list of boxes, these are the ones that no other box of the
//! list covers. A convex solid has those of its border.

use super::solid::{Side, Solid};
use crate::num::{Axis, Raw};
use crate::query::{Core, meet};
use crate::shape::Aabb;
use crate::world::cell::Cell;
use crate::world::level::{Feature, Geometry};

/// A set of quadrants, or of the pieces of a box: bits 0..=3 its faces, 4..=7 the corners that they
/// end in.
pub(super) type PieceSet = u8;

/// The cursor of [`Solids::features`](super::Solids::features).
#[derive(Clone, Debug)]
#[must_use = "cursors do nothing unless advanced"]
pub struct SolidFeatures<'w> {
    pub(crate) all: &'w [Solid],
    /// Those that were not looked at yet.
    next: &'w [Solid],
    region: (Raw, Raw),
    /// The one whose pieces are handed out, and which are left.
    of: Option<&'w Solid>,
    left: PieceSet,
    /// The requested pieces.
    asked: PieceSet,
}

impl<'w> SolidFeatures<'w> {
    pub(super) const fn new(all: &'w [Solid], region: &Aabb) -> Self {
        Self { all, next: all, region: (region.lo(), region.hi()), of: None, left: 0, asked: 0xff }
    }

    /// Limits the pieces to those that a motion can hit: faces that it opposes, and their corners.
    pub(super) const fn against(self, d: Raw) -> Self {
        let faces = faces_against(d);
        // Corner 4 + k is between the faces k and k + 1.
        let corners = (faces | faces >> 1 | faces << 3) & 0xf;
        Self { asked: faces | corners << 4, ..self }
    }
}

impl Iterator for SolidFeatures<'_> {
    type Item = Feature;

    fn next(&mut self) -> Option<Feature> {
        loop {
            while self.left != 0 {
                let index = self.left.trailing_zeros() as u8;
                self.left &= self.left.wrapping_sub(1);
                if let Some(feature) = self.of.and_then(|solid| piece(self.all, solid, index)) {
                    return Some(feature);
                }
            }
            let (solid, rest) = self.next.split_first()?;
            (self.of, self.next) = (Some(solid), rest);
            self.left = reached(solid, self.region) & self.asked;
        }
    }
}

/// The faces that a motion opposes.
pub(super) const fn faces_against(d: Raw) -> PieceSet {
    (d.y > 0) as PieceSet | ((d.x < 0) as PieceSet) << 1 | ((d.y < 0) as PieceSet) << 2 | ((d.x > 0) as PieceSet) << 3
}

/// The pieces of a box that have a point in the closed region.
fn reached(solid: &Solid, (lo, hi): (Raw, Raw)) -> PieceSet {
    let (a, b) = (solid.lo(), solid.hi());
    if !meet::aabb_aabb::<true>(a, b, lo, hi) {
        return 0;
    }
    let mut out: PieceSet = 0xff;
    for (outside, pieces) in
        [(a.y < lo.y, 0b1001_0001), (b.x > hi.x, 0b0011_0010), (b.y > hi.y, 0b0110_0100), (a.x < lo.x, 0b1100_1000)]
    {
        if outside {
            out &= !pieces;
        }
    }
    out & solid.pieces()
}

/// The face of a side, counted as a tile's are.
const fn number(side: Side) -> u8 {
    match side {
        Side::Up => 0,
        Side::Right => 1,
        Side::Down => 2,
        Side::Left => 3,
    }
}

/// The direction of face k.
const fn direction(k: u8) -> Axis {
    match k & 3 {
        0 => Axis::X,
        1 => Axis::Y,
        2 => Axis::NEG_X,
        _ => Axis::NEG_Y,
    }
}

/// The start of face k.
const fn corner(solid: &Solid, k: u8) -> Raw {
    let (lo, hi) = (solid.lo(), solid.hi());
    Raw { x: if matches!(k & 3, 1 | 2) { hi.x } else { lo.x }, y: if k & 2 == 0 { lo.y } else { hi.y } }
}

/// The quadrants at `p` that a box fills.
pub(super) fn quadrants_of(solid: &Solid, p: Raw) -> PieceSet {
    let (lo, hi) = (solid.lo(), solid.hi());
    if !meet::aabb_aabb::<true>(lo, hi, p, p) {
        return 0;
    }
    let x = (PieceSet::from(lo.x < p.x) * 0b1001) | (PieceSet::from(hi.x > p.x) * 0b0110);
    let y = (PieceSet::from(lo.y < p.y) * 0b0011) | (PieceSet::from(hi.y > p.y) * 0b1100);
    x & y
}

/// The part of the line of face k, as coordinates along x or y, that has a box just in front of it.
pub(super) fn in_front(of: &Solid, k: u8, other: &Solid) -> Option<(i32, i32)> {
    let (p, lo, hi) = (corner(of, k), other.lo(), other.hi());
    let (there, from, to) = match k & 3 {
        0 => (lo.y < p.y && hi.y >= p.y, lo.x, hi.x),
        1 => (lo.x <= p.x && hi.x > p.x, lo.y, hi.y),
        2 => (lo.y <= p.y && hi.y > p.y, lo.x, hi.x),
        _ => (lo.x < p.x && hi.x >= p.x, lo.y, hi.y),
    };
    there.then_some((from, to))
}

/// The boxes that are solid from all sides.
pub(super) fn full(list: &[Solid]) -> impl Iterator<Item = &Solid> {
    list.iter().filter(|solid| solid.one_way().is_none())
}

pub(super) fn quadrants(list: &[Solid], p: Raw) -> PieceSet {
    let mut bits = 0;
    for solid in full(list) {
        bits |= quadrants_of(solid, p);
    }
    bits
}

/// Whether the points just in front of a face are in other boxes from end to end. From one end on,
/// the box that reaches farthest leads to the next.
fn covered(list: &[Solid], solid: &Solid, k: u8) -> bool {
    let (lo, hi) = (solid.lo(), solid.hi());
    let (mut at, end) = if k & 1 == 0 { (lo.x, hi.x) } else { (lo.y, hi.y) };
    while at < end {
        let mut reach = at;
        for (from, to) in full(list).filter_map(|other| in_front(solid, k, other)) {
            if from <= at && to > reach {
                reach = to;
            }
        }
        if reach == at {
            return false;
        }
        at = reach;
    }
    true
}

/// A piece of a box, if it is part of the surface.
fn piece(list: &[Solid], solid: &Solid, index: u8) -> Option<Feature> {
    let k = index & 3;
    // Corner k + 1, where the face ends: k + 2 is beyond it and k before it.
    let at_end = quadrants(list, corner(solid, k.wrapping_add(1)));
    let has = |bits: PieceSet, quadrant: u8| bits >> (quadrant & 3) & 1 != 0;
    let (end_goes_on, end_is_behind) = (has(at_end, k + 2), has(at_end, k));
    if index >= 4 {
        return (!end_goes_on && !end_is_behind).then(|| solid.piece(index, [false; 2]));
    }
    if covered(list, solid, k) {
        return None;
    }
    let at_start = quadrants(list, corner(solid, k));
    let joined = [has(at_start, k + 3) && !has(at_start, k + 1), end_goes_on && !end_is_behind];
    Some(solid.piece(index, joined))
}

impl Solid {
    /// A piece of the box alone: 0..=3 its faces, 4..=7 the corners that they end in.
    pub(crate) fn piece(&self, index: u8, joined: [bool; 2]) -> Feature {
        let k = index & 3;
        let end = corner(self, k.wrapping_add(1));
        let geometry = if index < 4 {
            let start = corner(self, k);
            let len = end.sub(start);
            // One of them is zero.
            Geometry::Face { a: start.vec2(), dir: direction(k), len: (len.x | len.y).wrapping_abs(), joined }
        } else {
            Geometry::Vertex { p: end.vec2(), e_in: direction(k), e_out: direction(k.wrapping_add(1)) }
        };
        Feature {
            geometry,
            cell: self.cell(),
            index: u16::from(index),
            flags: self.flags(),
            one_way: self.one_way().is_some(),
            source: 0,
        }
    }

    /// The cell of its features, which holds the key.
    pub(super) const fn cell(&self) -> Cell {
        Cell::of_solid(self.key())
    }

    /// The pieces of the box alone, as bits: a one-way platform has one face, as a one-way tile.
    pub(crate) const fn pieces(&self) -> u8 {
        match self.one_way() {
            Some(side) => 1 << number(side),
            None => 0xff,
        }
    }
}

/// The border of a convex solid. For corner number i, 5 i is the face that begins there, and 5 i +
/// 1 is its vertex. If the corner is rounded, the pieces from 5 i + 1 on are arcs.
pub(crate) struct SolidBorder<'a> {
    pub(super) core: Core<'a>,
    pub(super) cell: Cell,
    pub(super) flags: u8,
}

impl SolidBorder<'_> {
    /// As many corners as an index of their pieces can name.
    const CORNERS: usize = u16::MAX as usize / 5;

    /// A piece, if it has a point in the closed region.
    pub(crate) fn piece(&self, index: u16, region: &Aabb) -> Option<Feature> {
        let geometry = piece_of(self.core, usize::from(index / 5), index % 5, region)?;
        Some(Feature { geometry, cell: self.cell, index, flags: self.flags, one_way: false, source: 0 })
    }

    /// How many pieces there may be.
    pub(crate) fn pieces(&self) -> u16 {
        (self.core.corners.len().min(Self::CORNERS) as u16).wrapping_mul(5)
    }

    /// The first of those from `next` on, which becomes the index after it.
    pub(crate) fn next_in(&self, next: &mut u16, region: &Aabb) -> Option<Feature> {
        while *next < self.pieces() {
            let index = *next;
            let is_last = self.core.radius == 0 && index % 5 == 1;
            *next = index.wrapping_add(if is_last { 4 } else { 1 });
            let piece = self.piece(index, region);
            if piece.is_some() {
                return piece;
            }
        }
        None
    }
}

/// At a corner: its face, its vertex, or one of its four arcs.
fn piece_of(core: Core<'_>, corner: usize, which: u16, region: &Aabb) -> Option<Geometry> {
    let (here, next, last) = (core.corner(corner), core.corner(core.after(corner)), core.corner(core.before(corner)));
    let (r, e) = (core.radius, next.sub(here));
    // Before a side is reduced, which takes most of the time.
    let is_near = |a: Raw, b: Raw| {
        let (lo, hi) = meet::corners(a, b);
        meet::aabb_aabb::<true>(lo, hi, region.lo(), region.hi())
    };
    if which == 0 {
        // Rounded sides are along x or y.
        let out = Raw { x: e.y.signum().wrapping_mul(r), y: e.x.signum().wrapping_mul(r).wrapping_neg() };
        let a = here.add(if r == 0 { Raw::ZERO } else { out });
        let (dir, len) = if is_near(a, a.add(e)) { reduced(e)? } else { return None };
        return Some(Geometry::Face { a: a.vec2(), dir, len, joined: [false; 2] });
    }
    if r == 0 {
        if which > 1 || !is_near(here, here) {
            return None;
        }
        let (e_in, e_out) = (reduced(here.sub(last))?.0, reduced(e)?.0);
        return Some(Geometry::Vertex { p: here.vec2(), e_in, e_out });
    }
    let quadrant = Axis::new(if which & 1 == 0 { -1 } else { 1 }, if which < 3 { -1 } else { 1 });
    let out = Raw { x: quadrant.x, y: quadrant.y };
    let is_outside = |other: Raw| out.dot(other.sub(here)) <= 0;
    let end = here.add(Raw { x: out.x.wrapping_mul(r), y: out.y.wrapping_mul(r) });
    let is_piece = is_near(here, end) && is_outside(next) && is_outside(last);
    is_piece.then_some(Geometry::Arc { centre: here.vec2(), radius: r, quadrant, convex: true })
}

/// A side as a reduced direction and its multiple; none of a point.
fn reduced(e: Raw) -> Option<(Axis, i32)> {
    let (x, y) = (e.x.unsigned_abs(), e.y.unsigned_abs());
    let len = gcd(x, y) as i32;
    Some((Axis::new(e.x.checked_div(len)?, e.y.checked_div(len)?), len))
}

/// By halving and differences: a Cortex-M0 has no division.
fn gcd(mut a: u32, mut b: u32) -> u32 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let twos = (a | b).trailing_zeros();
    a >>= a.trailing_zeros() & 31;
    while b != 0 {
        b >>= b.trailing_zeros() & 31;
        (a, b) = (a.min(b), a.abs_diff(b));
    }
    a << (twos & 31)
}
