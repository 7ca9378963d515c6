//! One tile's solid against one body: the inequality of its [`Form`], in the frame of its solid corner.

use super::form::{Form, FormKind};
use crate::num::{Raw, usqr};
use crate::query::meet::{gap, in_disc};
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
            FormKind::Convex if S::ARCS => reaches(u as u32, v as u32, self.side(), CLOSED),
            FormKind::Concave if S::ARCS => {
                let side = self.side();
                !reaches(side.wrapping_sub(u).unsigned_abs(), side.wrapping_sub(v).unsigned_abs(), side, !CLOSED)
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
        // The box around the solid, which is all of it where nothing else is said.
        let mut size = self.hi.sub(self.lo);
        match self.form.kind {
            FormKind::Empty => return false,
            FormKind::Line { p: 0, .. } => size.y = self.half,
            FormKind::Line { q: 0, .. } => size.x = self.half,
            FormKind::Line { p, q, k } => {
                let mut at = ZERO;
                if k == 4 {
                    // The half of the cell on the side where it is whole, and the smaller slope on top of it.
                    if p < q {
                        (size.y, at.y) = (self.half, self.half);
                    } else {
                        (size.x, at.x) = (self.half, self.half);
                    }
                }
                if triangle(m.sub(at), r, p, q, side, CLOSED) {
                    return true;
                } else if k != 4 {
                    return false;
                }
            }
            // Beside the quadrant the nearest point of the cell is on its two straight sides, which are the solid's.
            FormKind::Convex if S::ARCS && m.x >= 0 && m.y >= 0 => {
                return reaches(m.x as u32, m.y as u32, side.wrapping_add(r), CLOSED);
            }
            FormKind::Concave if S::ARCS => {
                if let Some(answer) = concave(m, r, side, CLOSED) {
                    return answer;
                }
            }
            _ => {}
        }
        reaches(beyond(m.x, size.x), beyond(m.y, size.y), r, CLOSED)
    }
}

/// Whether a point is in a disc around the origin, its rim included where `closed`.
#[inline(never)]
const fn reaches(x: u32, y: u32, r: i32, closed: bool) -> bool {
    if closed { in_disc::<true>(x, y, r as u32) } else { in_disc::<false>(x, y, r as u32) }
}

/// How far a coordinate is beyond the interval from 0 on.
const fn beyond(c: i32, size: i32) -> u32 {
    let gap = gap(c, 0, size);
    if gap < 0 { 0 } else { gap as u32 }
}

/// For operands of which one is 0 or both are below 2^30.
const fn plus(a: i32, b: i32) -> i32 {
    a.wrapping_add(b)
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
#[inline(never)]
const fn triangle(m: Raw, r: i32, p: u8, q: u8, side: i32, closed: bool) -> bool {
    let (a, b) = (side >> (p >> 1), side >> (q >> 1));
    let (gu, gv) = (beyond(m.x, a), beyond(m.y, b));
    if gu > r as u32 || gv > r as u32 {
        return false;
    }
    let (p, q) = (p as i32, q as i32);
    let front = plus(p * m.x, q * m.y).wrapping_sub(side);
    // The foot's place along the direction (q, -p), from the end (0, b) to the end (a, 0).
    let along = (q * m.x).wrapping_sub(p * m.y.wrapping_sub(b));
    let (x, y) = if front <= 0 {
        (gu, gv)
    } else if along <= 0 {
        (m.x.unsigned_abs(), m.y.abs_diff(b))
    } else if along >= plus(q * a, p * b) {
        (m.x.abs_diff(a), m.y.unsigned_abs())
    } else {
        // p^2 + q^2 is 2 or 5.
        let (square, r) = (usqr(front as u32), r as u32);
        let limit = usqr(r << (p != q) as u32).wrapping_add(usqr(r));
        return square < limit || (closed && square == limit);
    };
    reaches(x, y, r, closed)
}

/// A circle against the cell without the open quarter disc around its far corner; none where it is as one against the whole cell.
///
/// With `n` the centre seen from that corner, toward the solid: beyond the cell the nearest point of it is on one of the two whole sides; in
/// the cell the arc is nearest, `side - |n|` away; before a side of the quarter disc an end of the arc is, the cusp on the side that `n`
/// leans to.
const fn concave(m: Raw, r: i32, side: i32, closed: bool) -> Option<bool> {
    let n = Raw { x: side, y: side }.sub(m);
    if n.x > 0 && n.y > 0 {
        if m.x < 0 || m.y < 0 {
            return None;
        }
        return Some(r >= side || !reaches(n.x as u32, n.y as u32, side.wrapping_sub(r), !closed));
    }
    let (x, y) = if n.x > n.y { (m.x, n.y) } else { (n.x, m.y) };
    Some(reaches(x.unsigned_abs(), y.unsigned_abs(), r, closed))
}
