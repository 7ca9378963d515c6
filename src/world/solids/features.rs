//! What of the faces and corners of a list of boxes no other box of the list covers.

use super::solid::{Side, Solid};
use crate::num::{Axis, Raw};
use crate::query::meet;
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

    /// Of those, only the pieces that a motion can hit: faces that it goes against, and their
    /// corners.
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

/// The faces that a motion goes against.
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

/// Whether the points just in front of a face are in other boxes from end to end: from one end on,
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

/// A piece of a box, where it is part of the surface.
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

    /// The cell that stands for the box: its key in a row that no grid has, as theirs begin at -1.
    pub(super) const fn cell(&self) -> Cell {
        Cell::new(self.key() as i16, Self::ROW)
    }

    pub(super) const ROW: i16 = i16::MIN;

    /// The pieces of the box alone, as bits: of a one-way platform one face, as a one-way tile is.
    pub(crate) const fn pieces(&self) -> u8 {
        match self.one_way() {
            Some(side) => 1 << number(side),
            None => 0xff,
        }
    }
}
