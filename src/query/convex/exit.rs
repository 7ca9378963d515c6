//! The contact of two shapes: their least exit.

use super::across::{across, normal, over};
use super::boxes::{self, Parallelogram};
use super::each_side;
use super::face::Facing;
use super::nearness::{Nearness, Unsure, order};
use super::place::NearestPart;
use super::short_place::short_place_of;
use super::walk::{Core, Corner, PolygonSide, SideWalk};
use crate::num::Raw;
use crate::query::contact::Contact;

/// The least exit, and the side of the sum that it is across; none if it is from corner to
/// corner.
pub(super) struct Exit {
    pub(super) contact: Contact,
    pub(super) side: Option<PolygonSide>,
    /// The corners between which it leads, if it is not across a side.
    pub(super) corners: (usize, usize),
}

impl Exit {
    #[inline]
    pub(super) fn of(a: Core<'_>, b: Core<'_>) -> Option<Self> {
        let radius = a.radius.wrapping_add(b.radius);
        let place = if radius == 0 { NearestPart::Inside } else { short_place_of(a, b) };
        if !place.within::<false>(radius) {
            return None;
        }
        let side = match place {
            // From A's corner to B's, in any direction where they are one point.
            NearestPart::Corner(Corner { at, a: i, b: j }) => {
                let contact = Contact::radial(a.corner(i), at.reversed()).with_degenerate(at.is_zero());
                return Some(Self { contact: contact.with_radii(a.radius, b.radius), side: None, corners: (i, j) });
            }
            // Only the radii overlap.
            NearestPart::Side(side, height) if height > 0 => (side, false),
            _ => nearest(a, b, radius == 0)?,
        };
        let (side, tie) = side;
        let contact = across_any(&side, a, b).with_degenerate(tie).with_radii(a.radius, b.radius);
        Some(Self { contact, side: Some(side), corners: (side.a, side.b) })
    }
}

/// [`least`], mostly without a walk for boxes and for few sides.
fn nearest(a: Core<'_>, b: Core<'_>, open: bool) -> Option<(PolygonSide, bool)> {
    if open {
        let found = if let (Some(p), Some(q)) = (Parallelogram::of(a), Parallelogram::of(b)) {
            boxes::nearest(&p, &q)
        } else if each_side::are_few(a, b) {
            each_side::nearest(a, b)
        } else {
            Err(Unsure)
        };
        if let Ok(side) = found {
            return side.map(|side| (side, false));
        }
    }
    least(a, b, open)
}

/// The side of the sum that is nearest to an origin inside or on the border, and whether another
/// one is equally near. If there are several, the one whose normal is first in the documented
/// order, whatever the first corner of the walk is. None for an origin outside, and on the border
/// if that is `open`.
fn least(a: Core<'_>, b: Core<'_>, open: bool) -> Option<(PolygonSide, bool)> {
    let mut best: Option<(Nearness, PolygonSide)> = None;
    let mut tie = false;
    for side in SideWalk::new(a, b) {
        let height = side.height();
        if height < 0 || (open && height == 0) {
            return None;
        }
        let next = (Nearness::of(height, side.len2()), side);
        let Some(kept) = &best else {
            best = Some(next);
            continue;
        };
        let order = order(&next, kept);
        let (nearer, as_near) = (order.is_lt(), order.is_eq());
        tie = as_near || (tie && !nearer);
        if nearer || (as_near && before(normal(next.1.edge), normal(kept.1.edge))) {
            best = Some(next);
        }
    }
    best.map(|(_, side)| (side, tie))
}

/// The contact across a side of the sum, from A to B. Across two sides the deepest point is the
/// middle of their common part.
fn across_any(side: &PolygonSide, a: Core<'_>, b: Core<'_>) -> Contact {
    if !(side.of_a && side.of_b) {
        return across(side, a.corner(side.a), b.corner(side.b));
    }
    let (axis, overlap) = over(side.edge, side.from);
    let (core, on_a) = Facing::of(side, a, b).middle();
    let contact = Contact::new(axis, overlap, core);
    if on_a { contact } else { contact.on_b() }
}

/// The order of normals in a tie: along x, along y, others; positive x, then positive y; then
/// counter-clockwise from +x.
///
/// Components are below 2^31: products of two and their sum are below 2^63.
fn before(n: Raw, m: Raw) -> bool {
    let class = |n: Raw| (n.y != 0, n.x != 0, if n.y == 0 { n.x < 0 } else { n.y < 0 });
    let (p, q) = (class(n), class(m));
    p < q || (p == q && n.cross(m) > 0)
}
