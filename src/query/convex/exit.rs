//! The contact of two shapes: their least exit.

use super::face::Facing;
use super::place::Place;
use super::walk::{Core, Side, Walk};
use crate::num::{Axis, Raw, sqr64};
use crate::query::closest::Square;
use crate::query::contact::Contact;

pub(super) fn contact(a: Core<'_>, b: Core<'_>) -> Option<Contact> {
    let place = Place::of(a, b);
    if !place.within::<false>(a.radius.wrapping_add(b.radius)) {
        return None;
    }
    let contact = match place {
        // From A's corner to B's, in any direction where they are one point.
        Place::Corner(corner) => {
            Contact::radial(a.corner(corner.a), corner.at.reversed()).with_degenerate(corner.at.is_zero())
        }
        // Only the radii overlap.
        Place::Side(side, height) if height > 0 => across(&side, a, b),
        _ => least_exit(a, b),
    };
    Some(contact.with_radii(a.radius, b.radius))
}

/// The side of the sum that is nearest to an origin inside or on the border. Of several the one whose normal is first in the
/// documented order, whatever corner the walk began at.
fn least_exit(a: Core<'_>, b: Core<'_>) -> Contact {
    let mut best: Option<(Square, Side)> = None;
    let mut tie = false;
    for side in Walk::new(a, b) {
        // A height's square is below 2^124: fractions are compared in 187 bits.
        let square = Square { num: sqr64(side.height().unsigned_abs()), den: side.len2() };
        let (nearer, as_near) = match &best {
            None => (true, false),
            Some((least, _)) if square.less(*least) => (true, false),
            Some((least, kept)) => {
                let as_near = !least.less(square);
                tie |= as_near;
                (as_near && before(normal(side.edge), normal(kept.edge)), as_near)
            }
        };
        if nearer {
            tie &= as_near;
            best = Some((square, side));
        }
    }
    match best {
        Some((_, side)) => across(&side, a, b).with_degenerate(tie),
        None => Contact::radial(a.corner(0), Raw::ZERO).with_degenerate(true),
    }
}

/// The contact across a side of the sum, from A to B.
fn across(side: &Side, a: Core<'_>, b: Core<'_>) -> Contact {
    let (e, v) = (side.edge, side.from);
    // Along x and y the axis has length one, and the height divides by the side's length.
    let (axis, overlap) = if e.y == 0 {
        let sign = e.x.signum();
        (Axis::new(0, sign.wrapping_neg()), i64::from(sign.wrapping_mul(v.y)).wrapping_neg())
    } else if e.x == 0 {
        let sign = e.y.signum();
        (Axis::new(sign, 0), i64::from(sign.wrapping_mul(v.x)))
    } else {
        let n = normal(e);
        (Axis::new(n.x, n.y), side.height())
    };
    // The deepest point is the corner that the side is moved along, or the middle of what two sides share.
    let (core, on_a) = match (side.of_a, side.of_b) {
        (true, false) => (b.corner(side.b), false),
        (false, _) => (a.corner(side.a), true),
        (true, true) => Facing::of(side, a, b).middle(),
    };
    let contact = Contact::new(axis, overlap, core);
    if on_a { contact } else { contact.on_b() }
}

/// Out of the sum.
const fn normal(edge: Raw) -> Raw {
    Raw { x: edge.y, y: edge.x.wrapping_neg() }
}

/// The order of normals in a tie: along x, along y, others; positive x, then positive y; then counter-clockwise from +x.
///
/// Components are below 2^31: products of two and their sum are below 2^63.
fn before(n: Raw, m: Raw) -> bool {
    let class = |n: Raw| (n.y != 0, n.x != 0, if n.y == 0 { n.x < 0 } else { n.y < 0 });
    let (p, q) = (class(n), class(m));
    p < q || (p == q && n.cross(m) > 0)
}
