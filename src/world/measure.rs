//! A body against one feature: how far, how deep, and in which direction it leaves.
//!
//! Distances are exact, for comparison: roots, heights over lines, and the gap between a point and
//! a circle.

use super::level::{Feature, Geometry, World, ends, in_quadrant, normal, raw};
use crate::num::{Axis, Raw, add128, cmp_squares, less128, mul64, sqr64, sub128, usqr};
use crate::query::Contact;
use crate::query::meet::{in_disc, middle, segment_aabb};
use core::cmp::Ordering;

/// A distance, not negative.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) enum Measure {
    /// `sqrt(square)`, `square` below 2^61.
    Point { square: u64 },
    /// `front / sqrt(den)`, the height over a line whose direction has the square `den`: both below
    /// 2^61, `den` above 1. For the slopes of tiles `den` is 2 or 5, and `front` at most 3 * 2^30.
    Line { front: u64, den: u64 },
    /// `|sqrt(square) - radius|`, `square` below 2^61, the radius at most 2^24.
    Ring { square: u64, radius: u32 },
}

impl Measure {
    /// The distance between points, by its square.
    pub(in crate::world) const fn root(square: u64) -> Self {
        Self::Point { square }
    }

    /// The distance from a line, by its product with the length of the line's direction, which has
    /// the square `den`.
    pub(in crate::world) const fn height(front: u64, den: u64) -> Self {
        if den == 1 { Self::Point { square: usqr(front as u32) } } else { Self::Line { front, den } }
    }

    /// Exact. It takes two or three products of double words to compare slopes or arcs, and ten to
    /// compare an arc with a free segment. A level links only the code for its kinds of features.
    #[inline(never)]
    pub(in crate::world) fn order<W: World>(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Point { square: n }, Self::Point { square: m }) => n.cmp(m),
            _ if W::BLOCKS => Ordering::Equal,
            (Self::Line { front: f, den: d }, Self::Line { front: g, den: e }) if d == e => f.cmp(g),
            (Self::Line { front: f, den: d }, Self::Line { front: g, den: e }) => lines::<W>(*f, *d, *g, *e),
            (Self::Line { front, den }, Self::Point { square }) => line_and_point(*front, *den, *square),
            (Self::Point { square }, Self::Line { front, den }) => line_and_point(*front, *den, *square).reverse(),
            _ if !W::ROUND => Ordering::Equal,
            (Self::Ring { square: a, radius: r }, Self::Ring { square: b, radius: s }) => rings(*a, *r, *b, *s),
            (Self::Ring { square, radius }, line) => ring_and_line::<W>(*square, *radius, line),
            (line, Self::Ring { square, radius }) => ring_and_line::<W>(*square, *radius, line).reverse(),
        }
    }
}

/// Compares `f / sqrt(d)` with `g / sqrt(e)`: by 183 bits, for the slopes of tiles by 67.
#[inline(never)]
fn lines<W: World>(f: u64, d: u64, g: u64, e: u64) -> Ordering {
    if W::WIDE {
        return cmp_squares((f, e), (g, d));
    }
    mul64(usqr(f as u32), e).cmp(&mul64(usqr(g as u32), d))
}

/// Compares `f / sqrt(d)` with `sqrt(n)`, by 122 bits.
#[inline(never)]
fn line_and_point(f: u64, d: u64, n: u64) -> Ordering {
    sqr64(f).cmp(&mul64(n, d))
}

/// Compares `|sqrt(a) - r|` with `t`, which is a root or a height.
///
/// Outside, `sqrt(a) < r + t` is `a - r^2 - t^2 < 2 r t`. Inside, `r < sqrt(a) + t` is
/// `r^2 - a - t^2 < 2 sqrt(a) t`. Both are `w - t^2 < 2 sqrt(k) t`, with `w = |a - r^2|` and `k`
/// the lesser of the squares. For `t = f / sqrt(d)` that is `w d - f^2 < 2 f sqrt(k d)`. It is true
/// if the left side is negative; else its square decides. `k` is at most 2^48. A root and a tile's
/// slope have `w d` and `f^2` below 2^64, and `4 k d` below 2^53.
#[inline(never)]
fn ring_and_line<W: World>(a: u64, r: u32, line: &Measure) -> Ordering {
    let rr = usqr(r);
    let (w, k) = if a < rr { (rr.wrapping_sub(a), a) } else { (a.wrapping_sub(rr), rr) };
    let (square, den) = match *line {
        Measure::Line { front, den } if W::WIDE && den > 5 => return free_line(w, k << 2, front, den),
        Measure::Line { front, den } => (usqr(front as u32), den),
        Measure::Point { square } | Measure::Ring { square, .. } => (square, 1),
    };
    // Below 8.
    let times = |n: u64| n.wrapping_mul(den);
    let wd = times(w);
    if wd < square {
        return Ordering::Less;
    }
    sqr64(wd.wrapping_sub(square)).cmp(&mul64(square, times(k << 2)))
}

/// Compares `w d - f^2` with `f sqrt(c d)`, by 244 bits.
#[inline(never)]
fn free_line(w: u64, c: u64, f: u64, d: u64) -> Ordering {
    let (wd, ff) = (mul64(w, d), sqr64(f));
    if less128(wd, ff) {
        return Ordering::Less;
    }
    let x = sub128(wd, ff);
    product(x, x).cmp(&product(ff, mul64(c, d)))
}

/// The product of two numbers below 2^124, high words first, which compares as a number.
#[inline(never)]
pub(in crate::world) fn product(a: (u64, u64), b: (u64, u64)) -> ((u64, u64), (u64, u64)) {
    let (low, high) = (mul64(a.1, b.1), mul64(a.0, b.0));
    // Below 2^125.
    let mid = add128(mul64(a.0, b.1), mul64(a.1, b.0));
    let (word, carry) = low.0.overflowing_add(mid.1);
    (add128(high, (0, mid.0.wrapping_add(u64::from(carry)))), (word, low.1))
}

/// Compares `|sqrt(a) - r|` with `|sqrt(b) - s|`.
#[inline(never)]
fn rings(a: u64, r: u32, b: u64, s: u32) -> Ordering {
    match (a < usqr(r), b < usqr(s)) {
        (false, false) => roots_apart(a, b, i64::from(r) - i64::from(s)),
        (true, true) => roots_apart(b, a, i64::from(s) - i64::from(r)),
        (false, true) => roots_together(a, b, r.wrapping_add(s)),
        (true, false) => roots_together(a, b, r.wrapping_add(s)).reverse(),
    }
}

/// Compares `sqrt(a) - sqrt(b)` with `delta`, which is a difference of radii.
fn roots_apart(a: u64, b: u64, delta: i64) -> Ordering {
    let (a, b, square) =
        (if delta < 0 { b } else { a }, if delta < 0 { a } else { b }, usqr(delta.unsigned_abs() as u32));
    // sqrt(a) against sqrt(b) + |delta|: a - b - delta^2 against 2 |delta| sqrt(b).
    let order = if a < b.wrapping_add(square) {
        Ordering::Less
    } else {
        sqr64(a.wrapping_sub(b).wrapping_sub(square)).cmp(&mul64(square << 2, b))
    };
    if delta < 0 { order.reverse() } else { order }
}

/// Compares `sqrt(a) + sqrt(b)` with a sum of radii, below 2^31.
fn roots_together(a: u64, b: u64, sum: u32) -> Ordering {
    // 2 sqrt(a b) against sum^2 - a - b.
    let (square, both) = (usqr(sum), a.wrapping_add(b));
    if square < both {
        return Ordering::Greater;
    }
    mul64(a << 2, b).cmp(&sqr64(square.wrapping_sub(both)))
}

/// The contact of a box with a feature that it overlaps. At a slope or an arc it is that of a
/// corner of the box. At a corner, or at a face along x or y, it is that of a side.
///
/// `c` is its middle. `behind` says whether the back of the feature counts, because the middle is
/// in the solid. Also returns whether the box is in the feature's region.
///
/// The line from a middle outside the solid to a point of the box inside enters through a face or
/// arc. That one has a contact, in its region or not.
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
            // Beyond an end a vertex takes over, if there is one.
            let along = raw(dir).dot(m);
            let beside = (along < 0 && !joined[0]) || (along > raw(dir).dot(b.sub(a)) && !joined[1]);
            Some((Contact::new(n.reversed(), raw(n).dot(m).wrapping_neg(), deepest), !beside))
        }
        Geometry::Vertex { p, e_in, e_out } => {
            corner(lo, hi, c, Raw::of(p), e_in, e_out, behind).map(|contact| (contact, true))
        }
        Geometry::Arc { centre, radius, quadrant, convex } if W::ROUND => {
            let frame = ArcFrame { centre: Raw::of(centre), quadrant };
            let (near, far) = (frame.enter(lo, hi), frame.enter(hi, lo));
            // The part of the box in the quadrant must lie on both sides of the arc.
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

/// The coordinate of a box that is deepest behind a face with the normal's component `n`; the
/// middle of their common part if all are.
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
struct ArcFrame {
    centre: Raw,
    quadrant: Axis,
}

impl ArcFrame {
    /// The corner of a box that has the coordinates of `plus` on axes that are not turned, else
    /// those of `minus`.
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

    /// The exit from a solid disc, along the line from its centre to the box's corner `near`. If a
    /// side of the box is before the centre, that side leaves the arc's end.
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

/// The contact of a circle with a feature that it overlaps, and whether the feature's normal passes
/// its centre.
///
/// `behind` says whether the back of the feature counts, because the centre is in the solid. Only
/// then does a face count whose normal does not pass the centre: directly behind a concave corner
/// there is no other.
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

/// The contact of a circle with a corner or an arc.
fn round<W: World>(c: Raw, r: i32, feature: &Feature, behind: bool) -> Option<Contact> {
    match feature.geometry {
        Geometry::Vertex { p, e_in, e_out } => {
            let m = c.sub(Raw::of(p));
            // On the border of the cone the faces take over.
            let in_cone = raw(e_in).dot(m) > 0 && raw(e_out).dot(m) < 0;
            let near = in_disc::<false>(m.x.unsigned_abs(), m.y.unsigned_abs(), r as u32);
            (in_cone && near).then(|| Contact::radial(c, Raw::of(p).sub(c)).with_radii(r, 0))
        }
        Geometry::Arc { centre, radius, quadrant, convex } if W::ROUND => {
            let m = c.sub(Raw::of(centre));
            let (x, y) = (m.x.unsigned_abs(), m.y.unsigned_abs());
            let reaches = in_disc::<false>(x, y, radius.wrapping_add(r) as u32)
                && (r > radius || !in_disc::<true>(x, y, radius.wrapping_sub(r) as u32));
            // Behind: inside a solid disc, outside a hollow one.
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

/// A contact with the solid around a hollow disc. The core is `m` from the centre, as deep as the
/// sum of its length and the other radii.
pub(in crate::world) fn into_disc(core: Raw, m: Raw, quadrant: Axis) -> Contact {
    if m.is_zero() {
        return Contact::new(Axis::new(quadrant.x, 0), 0, core).with_degenerate(true);
    }
    // The corner of the opposite side, reversed.
    let mut contact = Contact::radial(core, m);
    contact.overlap = if contact.radial { m.len2() as i64 } else { contact.overlap.wrapping_neg() };
    contact.radial = false;
    contact
}
