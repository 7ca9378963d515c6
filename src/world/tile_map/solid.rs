//! One tile's solid against one body: the inequality of its [`Form`], in the frame of its solid corner.

use super::form::{Form, FormKind};
use crate::num::{Raw, usqr};
use crate::query::meet::{circle_aabb, circle_gaps, gap, in_disc};
use crate::world::Set;

/// The solid of a cell that is not empty, where it lies.
///
/// Cells beyond the map reach to the end of the domain: they are whole or halved along the map's border, so nothing else here sees a cell that
/// is not square. Sides are at most 2^24, coordinates relative to a square cell in reach of a body below 2^29 + 2^24.
#[derive(Clone, Copy)]
pub(in crate::world) struct Solid {
    form: Form,
    lo: Raw,
    hi: Raw,
    /// Half the side of a cell.
    half: i32,
}

const ZERO: Raw = Raw { x: 0, y: 0 };

impl Solid {
    pub(in crate::world) const fn new(form: Form, (lo, hi): (Raw, Raw), half: i32) -> Self {
        Self { form, lo, hi, half }
    }

    const fn side(&self) -> i32 {
        self.half << 1
    }

    /// A box in the frame of the solid corner, by its corner nearest to that.
    const fn near(&self, lo: Raw, hi: Raw) -> Raw {
        Raw {
            x: if self.form.right { self.hi.x.wrapping_sub(hi.x) } else { lo.x.wrapping_sub(self.lo.x) },
            y: if self.form.bottom { self.hi.y.wrapping_sub(hi.y) } else { lo.y.wrapping_sub(self.lo.y) },
        }
    }

    /// Whether a box has a point in the solid, for a box that has one in the closed cell: open sets and a box with area in the
    /// open cell, or closed ones.
    ///
    /// The form is monotone: if any point of the common box is solid, the one nearest to the corner is. Where that one holds strictly, so do the
    /// points of the common box near it, and these have an inside if the box has.
    pub(in crate::world) const fn meets_box<S: Set, const CLOSED: bool>(&self, lo: Raw, hi: Raw) -> bool {
        let near = self.near(lo, hi);
        let (u, v) = (if near.x > 0 { near.x } else { 0 }, if near.y > 0 { near.y } else { 0 });
        match self.form.kind {
            FormKind::Empty => false,
            FormKind::Line { p, q, k } => {
                let (value, limit) = (plus(p as i32 * u, q as i32 * v), k as i32 * self.half);
                value < limit || (CLOSED && value == limit)
            }
            FormKind::Convex if S::ARCS => in_disc::<CLOSED>(u as u32, v as u32, self.side() as u32),
            FormKind::Concave if S::ARCS => {
                let side = self.side();
                beyond::<CLOSED>(Raw { x: side.wrapping_sub(u), y: side.wrapping_sub(v) }, side)
            }
            _ => true,
        }
    }

    /// Whether a circle overlaps the solid (its radius is not 0 then), or touches it.
    ///
    /// Each test is the comparison of a radius with the distance to the solid: an open disc meets the inside of a solid, whose closure
    /// the solid is, where the centre is nearer than the radius.
    pub(in crate::world) const fn meets_circle<S: Set, const CLOSED: bool>(&self, c: Raw, r: i32) -> bool {
        let (m, side) = (self.near(c, c), self.side());
        match self.form.kind {
            FormKind::Empty => false,
            FormKind::Line { p: 0, .. } => {
                circle_aabb::<CLOSED>(m, r, ZERO, Raw { x: self.hi.x.wrapping_sub(self.lo.x), y: self.half })
            }
            FormKind::Line { q: 0, .. } => {
                circle_aabb::<CLOSED>(m, r, ZERO, Raw { x: self.half, y: self.hi.y.wrapping_sub(self.lo.y) })
            }
            FormKind::Line { p, q, k: 4 } => {
                // The half of the cell on the side where it is whole, and the smaller slope on top of it.
                let (size, at) = if p < q {
                    (Raw { x: side, y: self.half }, Raw { x: 0, y: self.half })
                } else {
                    (Raw { x: self.half, y: side }, Raw { x: self.half, y: 0 })
                };
                circle_aabb::<CLOSED>(m, r, ZERO, size) || triangle::<CLOSED>(m.sub(at), r, p, q, side)
            }
            FormKind::Line { p, q, .. } => triangle::<CLOSED>(m, r, p, q, side),
            FormKind::Convex if S::ARCS => convex::<CLOSED>(m, r, side),
            FormKind::Concave if S::ARCS => concave::<CLOSED>(m, r, side),
            _ => circle_aabb::<CLOSED>(c, r, self.lo, self.hi),
        }
    }
}

/// For operands of which one is 0 or both are below 2^30.
const fn plus(a: i32, b: i32) -> i32 {
    a.wrapping_add(b)
}

/// Whether a point lies outside of the open disc, or of the closed one for a strict test.
const fn beyond<const CLOSED: bool>(m: Raw, r: i32) -> bool {
    let (x, y, r) = (m.x.unsigned_abs(), m.y.unsigned_abs(), r as u32);
    if CLOSED { !in_disc::<false>(x, y, r) } else { !in_disc::<true>(x, y, r) }
}

/// A circle against the triangle `p u + q v <= side`, for p and q of 1 and 2.
///
/// ```text
///     +---a----     From on or behind the hypotenuse's line the nearest point of the
///     |######/ '    bounding box is in the triangle: it lies not beyond the line either.
///     b###/   '     From before the line the nearest point is on the hypotenuse.
///     |/
/// ```
///
/// Beside the box only centres within `r` are left: |u|, |v| < 2^29 + 2^24, so the sums are below 3 (2^29 + 2^24) < 2^31.
const fn triangle<const CLOSED: bool>(m: Raw, r: i32, p: u8, q: u8, side: i32) -> bool {
    let (a, b) = (side >> (p >> 1), side >> (q >> 1));
    let (gu, gv) = (gap(m.x, 0, a), gap(m.y, 0, b));
    if gu > r || gv > r {
        return false;
    }
    let (p, q) = (p as i32, q as i32);
    let front = plus(p * m.x, q * m.y).wrapping_sub(side);
    if front <= 0 {
        return circle_gaps::<CLOSED>(gu, gv, r);
    }
    // The foot's place along the direction (q, -p), from the end (0, b) to the end (a, 0).
    let along = (q * m.x).wrapping_sub(p * m.y.wrapping_sub(b));
    if along <= 0 {
        in_disc::<CLOSED>(m.x.unsigned_abs(), m.y.abs_diff(b), r as u32)
    } else if along >= plus(q * a, p * b) {
        in_disc::<CLOSED>(m.x.abs_diff(a), m.y.unsigned_abs(), r as u32)
    } else {
        // p^2 + q^2 is 2 or 5.
        let (square, rr) = (usqr(front as u32), usqr(r as u32));
        let limit = if p == q { rr << 1 } else { (rr << 2).wrapping_add(rr) };
        square < limit || (CLOSED && square == limit)
    }
}

/// A circle against the quarter disc around the origin, toward +, +. Beside the quadrant the nearest point of the cell is on its two straight
/// sides, which are the solid's.
const fn convex<const CLOSED: bool>(m: Raw, r: i32, side: i32) -> bool {
    if m.x >= 0 && m.y >= 0 {
        in_disc::<CLOSED>(m.x as u32, m.y as u32, side.wrapping_add(r) as u32)
    } else {
        circle_aabb::<CLOSED>(m, r, ZERO, Raw { x: side, y: side })
    }
}

/// A circle against the cell without the open quarter disc around its far corner.
///
/// With `n` the centre seen from that corner, toward the solid: beyond the cell the nearest point of it is on one of the two whole sides; in
/// the cell the arc is nearest, `side - |n|` away; before a side of the quarter disc an end of the arc is, the cusp on the side that `n`
/// leans to.
const fn concave<const CLOSED: bool>(m: Raw, r: i32, side: i32) -> bool {
    let n = Raw { x: side, y: side }.sub(m);
    if n.x > 0 && n.y > 0 {
        if m.x < 0 || m.y < 0 {
            return circle_aabb::<CLOSED>(m, r, ZERO, Raw { x: side, y: side });
        }
        return r >= side || beyond::<CLOSED>(n, side.wrapping_sub(r));
    }
    let (x, y) = if n.x > n.y { (m.x, n.y) } else { (n.x, m.y) };
    in_disc::<CLOSED>(x.unsigned_abs(), y.unsigned_abs(), r as u32)
}
