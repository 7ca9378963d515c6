//! A box against one feature of a level.

use super::closest::{ends, normal, raw};
use super::contact_circle::into_disc;
use crate::num::{Axis, Raw};
use crate::query::Contact;
use crate::query::meet::{in_disc, middle, segment_aabb};
use crate::world::{Feature, Geometry, World};

/// The contact of a box with a feature that it overlaps: its corner with a slope or arc, its side with a corner or with a face along x or y.
///
/// `c` is its middle. `behind` says whether the back of the feature counts: where the middle is in the solid. With it, whether the box is in the
/// feature's region.
///
/// The way from a middle outside of the solid to a point of the box in it leads in through a face or arc: that one has a contact, in its region or not.
#[inline(never)]
pub(in crate::world) fn boxed<W: World>(
    lo: Raw,
    hi: Raw,
    c: Raw,
    feature: &Feature,
    behind: bool,
) -> Option<(Contact, bool)> {
    match feature.geometry {
        Geometry::Face { a, dir, len, joined } => {
            let (a, b) = ends(Raw::of(a), dir, len);
            let n = normal(dir);
            if !segment_aabb::<false>(a, b, lo, hi) || (!behind && raw(n).dot(c.sub(a)) < 0) {
                return None;
            }
            let deepest = Raw { x: deepest(n.x, lo.x, hi.x, a.x, b.x), y: deepest(n.y, lo.y, hi.y, a.y, b.y) };
            let m = deepest.sub(a);
            // Beyond an end a vertex is in charge, if there is one.
            let along = raw(dir).dot(m);
            let beside = (along < 0 && !joined[0]) || (along > raw(dir).dot(b.sub(a)) && !joined[1]);
            Some((Contact::new(n.reversed(), raw(n).dot(m).wrapping_neg(), deepest), !beside))
        }
        Geometry::Vertex { p, e_in, e_out } => {
            corner(lo, hi, c, Raw::of(p), e_in, e_out, behind).map(|contact| (contact, true))
        }
        Geometry::Arc { centre, radius, quadrant, convex } if W::ROUND => {
            let frame = Frame { centre: Raw::of(centre), quadrant };
            let (near, far) = (frame.enter(lo, hi), frame.enter(hi, lo));
            // What of the box is in the quadrant must lie on both sides of the arc.
            let first = Raw { x: near.x.max(0), y: near.y.max(0) };
            if far.x <= 0 || far.y <= 0 || !inside(first, radius) || !beyond(far, radius) {
                return None;
            }
            let middle = frame.enter(c, c);
            let beside = middle.x < 0 || middle.y < 0;
            let contact = if !convex {
                if !beside && !behind && beyond(middle, radius) {
                    return None;
                }
                let m = frame.turn(far);
                into_disc(frame.centre.add(m), m, quadrant).with_radii(0, radius.wrapping_neg())
            } else if beside && !behind {
                // Only beyond an end of the arc is its front in sight.
                if middle.x < radius && middle.y < radius {
                    return None;
                }
                frame.end(near, radius, middle.y >= radius)
            } else if !behind && inside(middle, radius) {
                return None;
            } else {
                frame.convex(near, radius)
            };
            Some((contact, true))
        }
        Geometry::Arc { .. } => None,
    }
}

/// The coordinate of a box that is deepest behind a face with the normal's component `n`; the middle of what they share where all are.
const fn deepest(n: i32, lo: i32, hi: i32, a: i32, b: i32) -> i32 {
    if n > 0 {
        lo
    } else if n < 0 {
        hi
    } else if a < b {
        middle(lo, hi, a, b)
    } else {
        middle(lo, hi, b, a)
    }
}

/// A corner of the solid in the box: the least exit among the directions in its open cone.
fn corner(lo: Raw, hi: Raw, c: Raw, p: Raw, e_in: Axis, e_out: Axis, behind: bool) -> Option<Contact> {
    if p.x <= lo.x || p.x >= hi.x || p.y <= lo.y || p.y >= hi.y {
        return None;
    }
    let exits = [
        (Axis::X, p.x.wrapping_sub(lo.x), Raw { x: lo.x, y: p.y }),
        (Axis::NEG_X, hi.x.wrapping_sub(p.x), Raw { x: hi.x, y: p.y }),
        (Axis::Y, p.y.wrapping_sub(lo.y), Raw { x: p.x, y: lo.y }),
        (Axis::NEG_Y, hi.y.wrapping_sub(p.y), Raw { x: p.x, y: hi.y }),
    ];
    let mut best: Option<(Axis, i32, Raw, bool)> = None;
    for (n, depth, core) in exits {
        let allowed = n.dot(e_in) > 0 && n.dot(e_out) < 0 && (behind || n.dot_vec(c.sub(p).vec2()) >= 0);
        match &mut best {
            _ if !allowed => {}
            Some((_, least, _, tie)) if *least <= depth => *tie |= *least == depth,
            _ => best = Some((n, depth, core, false)),
        }
    }
    best.map(|(n, depth, core, tie)| Contact::new(n.reversed(), i64::from(depth), core).with_degenerate(tie))
}

const fn inside(m: Raw, radius: i32) -> bool {
    in_disc::<false>(m.x.unsigned_abs(), m.y.unsigned_abs(), radius as u32)
}

const fn beyond(m: Raw, radius: i32) -> bool {
    !in_disc::<true>(m.x.unsigned_abs(), m.y.unsigned_abs(), radius as u32)
}

/// The frame of an arc: from its centre, both axes toward the arc.
struct Frame {
    centre: Raw,
    quadrant: Axis,
}

impl Frame {
    /// The corner of a box that has the coordinates of `plus` on axes that are not turned, else those of `minus`.
    const fn enter(&self, plus: Raw, minus: Raw) -> Raw {
        let (p, m) = (plus.sub(self.centre), minus.sub(self.centre));
        Raw {
            x: if self.quadrant.x > 0 { p.x } else { m.x.wrapping_neg() },
            y: if self.quadrant.y > 0 { p.y } else { m.y.wrapping_neg() },
        }
    }

    /// A vector of the frame in the level.
    const fn turn(&self, v: Raw) -> Raw {
        Raw { x: v.x.wrapping_mul(self.quadrant.x), y: v.y.wrapping_mul(self.quadrant.y) }
    }

    /// The exit from a solid disc: along the line from its centre to the box's corner `near`; where a side of the box is before the centre, that
    /// side leaves the arc's end.
    fn convex(&self, near: Raw, radius: i32) -> Contact {
        if near.x > 0 && near.y > 0 {
            let core = self.centre.add(self.turn(near));
            return Contact::radial(core, self.centre.sub(core)).with_radii(0, radius);
        }
        let tie = near.x == near.y;
        self.end(near, radius, near.x < near.y).with_degenerate(tie)
    }

    /// The exit of a box's side over the arc's end along y, or along x.
    const fn end(&self, near: Raw, radius: i32, along_y: bool) -> Contact {
        let core = self.centre.add(self.turn(near));
        let contact = if along_y {
            let side = Raw { x: self.centre.x, y: core.y };
            Contact::new(Axis::new(0, self.quadrant.y.wrapping_neg()), (near.y as i64).wrapping_neg(), side)
        } else {
            let side = Raw { x: core.x, y: self.centre.y };
            Contact::new(Axis::new(self.quadrant.x.wrapping_neg(), 0), (near.x as i64).wrapping_neg(), side)
        };
        contact.with_radii(0, radius)
    }
}
