//! A circle against one feature of a level.

use super::closest::{ends, in_quadrant, normal, raw};
use crate::num::{Axis, Raw, less128, mul64, sqr64, usqr};
use crate::query::Contact;
use crate::query::meet::in_disc;
use crate::world::{Feature, Geometry, World};

/// The contact of a circle with a feature that it overlaps, and whether the feature's normal passes its centre.
///
/// `behind` says whether the back of the feature counts: where the centre is in the solid. Only there does a face count whose normal does not pass
/// the centre: right behind a concave corner there is none whose does.
#[inline(never)]
pub(in crate::world) fn circle<W: World>(c: Raw, r: i32, feature: &Feature, behind: bool) -> Option<(Contact, bool)> {
    if let Geometry::Face { a, dir, len, .. } = feature.geometry {
        let (a, b) = ends(Raw::of(a), dir, len);
        let (m, n) = (c.sub(a), normal(dir));
        let (front, before) = (raw(n).dot(m), raw(dir).dot(m) < 0);
        let beside = before || raw(dir).dot(c.sub(b)) > 0;
        let reaches = if beside {
            let end = if before { m } else { c.sub(b) };
            front <= 0 && in_disc::<false>(end.x.unsigned_abs(), end.y.unsigned_abs(), r as u32)
        } else {
            less128(sqr64(front.unsigned_abs()), mul64(usqr(r as u32), dir.length_squared()))
        };
        if !reaches || ((front < 0 || beside) && !behind) {
            return None;
        }
        return Some((Contact::new(n.reversed(), front.wrapping_neg(), c).with_radii(r, 0), !beside));
    }
    round::<W>(c, r, feature, behind).map(|contact| (contact, true))
}

/// The same for a corner or an arc.
fn round<W: World>(c: Raw, r: i32, feature: &Feature, behind: bool) -> Option<Contact> {
    match feature.geometry {
        Geometry::Vertex { p, e_in, e_out } => {
            let m = c.sub(Raw::of(p));
            // On the border of the cone the faces are in charge.
            let in_cone = raw(e_in).dot(m) > 0 && raw(e_out).dot(m) < 0;
            let near = in_disc::<false>(m.x.unsigned_abs(), m.y.unsigned_abs(), r as u32);
            (in_cone && near).then(|| Contact::radial(c, Raw::of(p).sub(c)).with_radii(r, 0))
        }
        Geometry::Arc { centre, radius, quadrant, convex } if W::ROUND => {
            let m = c.sub(Raw::of(centre));
            let (x, y) = (m.x.unsigned_abs(), m.y.unsigned_abs());
            let reaches = in_disc::<false>(x, y, radius.wrapping_add(r) as u32)
                && (r > radius || !in_disc::<true>(x, y, radius.wrapping_sub(r) as u32));
            // Behind: inside of a solid disc, outside of a hollow one.
            let is_behind =
                if convex { in_disc::<false>(x, y, radius as u32) } else { !in_disc::<true>(x, y, radius as u32) };
            if !in_quadrant(m, quadrant) || !reaches || (is_behind && !behind) {
                return None;
            }
            let contact = if convex { out_of_disc(c, m, quadrant) } else { into_disc(c, m, quadrant) };
            Some(contact.with_radii(r, if convex { radius } else { radius.wrapping_neg() }))
        }
        Geometry::Arc { .. } | Geometry::Face { .. } => None,
    }
}

/// A contact with a solid disc, whose centre is `-m` from the core.
fn out_of_disc(core: Raw, m: Raw, quadrant: Axis) -> Contact {
    if m.is_zero() {
        return Contact::new(Axis::new(quadrant.x.wrapping_neg(), 0), 0, core).with_degenerate(true);
    }
    Contact::radial(core, Raw { x: m.x.wrapping_neg(), y: m.y.wrapping_neg() })
}

/// A contact with what is around a hollow disc: the core is `m` from the centre, as deep as the sum of its length and the other radii.
pub(in crate::world) fn into_disc(core: Raw, m: Raw, quadrant: Axis) -> Contact {
    if m.is_zero() {
        return Contact::new(Axis::new(quadrant.x, 0), 0, core).with_degenerate(true);
    }
    // That to the opposite side, turned round.
    let mut contact = Contact::radial(core, m);
    contact.overlap = if contact.radial { m.len2() as i64 } else { contact.overlap.wrapping_neg() };
    contact.radial = false;
    contact
}
