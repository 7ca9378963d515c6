//! Convex shapes against a quarter of a disc, and against a square without one.
//!
//! Both are relative to the arc's centre, with the quarter in the positive quadrant. Points are
//! below 2^31 there, as levels may be shifted: products are below 2^62.

use super::meets::meets;
use super::place::sharp;
use super::walk::Core;
use crate::num::{Raw, Vec2, imul, less128, mul64, sqr64, usqr};
use crate::query::meet::in_disc;

/// A square with an arc around one of its corners, through the two next to it.
#[derive(Clone, Copy)]
pub(crate) struct ArcCell {
    /// The arc's centre.
    pub(crate) centre: Raw,
    /// Whether the square is on its left, and below it in the sense of smaller coordinates.
    pub(crate) left: bool,
    pub(crate) above: bool,
    /// The square's side, and the arc's radius.
    pub(crate) side: i32,
}

impl ArcCell {
    const fn seen(&self, p: Raw) -> Raw {
        let m = p.sub(self.centre);
        Raw {
            x: if self.left { m.x.wrapping_neg() } else { m.x },
            y: if self.above { m.y.wrapping_neg() } else { m.y },
        }
    }

    const fn placed(&self, x: i32, y: i32) -> Vec2 {
        let (x, y) = (if self.left { x.wrapping_neg() } else { x }, if self.above { y.wrapping_neg() } else { y });
        self.centre.add(Raw { x, y }).vec2()
    }

    fn square(&self) -> [Vec2; 4] {
        let s = self.side;
        let mut points = [self.placed(0, 0), self.placed(s, 0), self.placed(s, s), self.placed(0, s)];
        if self.left != self.above {
            points.reverse();
        }
        points
    }

    fn ends(&self, core: Core<'_>) -> impl Iterator<Item = (Raw, Raw)> {
        (0..core.corners.len()).map(move |i| (self.seen(core.corner(i)), self.seen(core.corner(core.after(i)))))
    }

    /// Whether a shape overlaps, or touches, the quarter of the disc.
    ///
    /// Grown by the shape's radius, the quarter is that of a larger disc, and everything within
    /// that radius of its two straight sides. For a shape without radius that overlaps the square,
    /// its part in the quadrant is the limit of the part inside. So this tests the quarter's closed
    /// side.
    pub(crate) fn convex_meets<const CLOSED: bool>(&self, core: Core<'_>) -> bool {
        if core.radius == 0 && !CLOSED && !self.overlaps_square(core) {
            return false;
        }
        let s = self.side;
        self.reaches_sector::<CLOSED>(core, s.wrapping_add(core.radius))
            || (core.radius > 0
                && (self.meets_line::<CLOSED>(core, (0, 0), (s, 0)) || self.meets_line::<CLOSED>(core, (0, 0), (0, s))))
    }

    /// Whether a shape overlaps, or touches, the rest of the square.
    ///
    /// In a convex part of the square, the point farthest from the centre is one of its corners.
    /// That is a corner of the shape, or is on the square's border. On the sides through the centre
    /// only the ends are solid, and these are also ends of the far sides.
    pub(crate) fn concave_meets<const CLOSED: bool>(&self, core: Core<'_>) -> bool {
        let s = self.side;
        let rest = s.wrapping_sub(core.radius);
        let is_out = |m: Raw| {
            m.x >= 0 && m.y >= 0 && m.x <= s && m.y <= s && {
                let near = if CLOSED { in_disc::<false> } else { in_disc::<true> };
                rest < 0 || !near(m.x.unsigned_abs(), m.y.unsigned_abs(), rest.unsigned_abs())
            }
        };
        if core.radius == 0 && !CLOSED {
            // The far sides without the arc's ends.
            let far = |m: Raw| Raw { x: s.wrapping_sub(m.x), y: s.wrapping_sub(m.y) };
            return self.overlaps_square(core)
                && (self.ends(core).any(|(a, b)| {
                    let (p, q) = (far(a), far(b));
                    is_out(a) || crosses(p, q, s) || crosses(swapped(p), swapped(q), s)
                }) || holds_origin(core, self.ends(core).map(|(a, b)| (far(a), far(b)))));
        }
        self.ends(core).any(|(a, _)| is_out(a))
            || self.meets_line::<CLOSED>(core, (s, s), (0, s))
            || self.meets_line::<CLOSED>(core, (s, s), (s, 0))
    }

    fn overlaps_square(&self, core: Core<'_>) -> bool {
        sharp::<false>(core, Core { corners: &self.square(), radius: 0 }).is_ok()
    }

    fn meets_line<const CLOSED: bool>(&self, core: Core<'_>, a: (i32, i32), b: (i32, i32)) -> bool {
        meets::<CLOSED>(core, Core { corners: &[self.placed(a.0, a.1), self.placed(b.0, b.1)], radius: 0 })
    }

    /// Whether the core has a point of the closed quadrant that is nearer to the centre than
    /// `reach`, or as near where `CLOSED`.
    ///
    /// The nearest point is the centre, a corner, a foot on a side, or a point where a side leaves
    /// the quadrant. Other points of the quadrant's border in the shape have nearer ones beside
    /// them.
    fn reaches_sector<const CLOSED: bool>(&self, core: Core<'_>, reach: i32) -> bool {
        // Up to the arc's end, which only closed sets hold.
        let along = |a: Raw, b: Raw| crosses(a, b, reach) || (CLOSED && crosses_at(a, b, reach));
        self.ends(core).any(|(a, b)| {
            (a.x >= 0 && a.y >= 0 && in_disc::<CLOSED>(a.x.unsigned_abs(), a.y.unsigned_abs(), reach as u32))
                || along(a, b)
                || along(swapped(a), swapped(b))
                || has_foot::<CLOSED>(a, b, reach)
        }) || holds_origin(core, self.ends(core))
    }
}

const fn swapped(p: Raw) -> Raw {
    Raw { x: p.y, y: p.x }
}

/// The x at which the line through two points crosses y = 0, if they are on different sides: a
/// fraction with a positive divisor.
fn at_zero(a: Raw, b: Raw) -> Option<(i64, i32)> {
    let den = b.y.wrapping_sub(a.y);
    if (a.y > 0) == (b.y > 0) && (a.y < 0) == (b.y < 0) {
        return None;
    }
    let num = a.cross(b);
    Some(if den < 0 { (num.wrapping_neg(), den.wrapping_neg()) } else { (num, den) })
}

/// Whether a side crosses y = 0 from x = 0 up to, and not at, `end`.
fn crosses(a: Raw, b: Raw, end: i32) -> bool {
    at_zero(a, b).is_some_and(|(num, den)| num >= 0 && num < imul(end, den))
}

fn crosses_at(a: Raw, b: Raw, x: i32) -> bool {
    at_zero(a, b).is_some_and(|(num, den)| num == imul(x, den))
}

/// Whether the foot of the origin is on a side, in the closed quadrant, and nearer than `reach`.
fn has_foot<const CLOSED: bool>(a: Raw, b: Raw, reach: i32) -> bool {
    let e = b.sub(a);
    let (along, height, len2) = (e.dot(a.reversed()), e.cross(a), e.len2());
    if along <= 0 || along as u64 >= len2 {
        return false;
    }
    // The foot is (-e.y, e.x) times the height over the square length.
    let sign = height.signum();
    if i64::from(e.y).wrapping_mul(sign) > 0 || i64::from(e.x).wrapping_mul(sign) < 0 {
        return false;
    }
    let (square, limit) = (sqr64(height.unsigned_abs()), mul64(usqr(reach as u32), len2));
    if CLOSED { !less128(limit, square) } else { less128(square, limit) }
}

/// Whether a polygon contains the origin. A polygon without area contains it on a side, which other
/// code tests.
fn holds_origin(core: Core<'_>, mut ends: impl Iterator<Item = (Raw, Raw)>) -> bool {
    let (mut left, mut right) = (false, false);
    core.corners.len() > 2
        && ends.all(|(a, b)| {
            let turn = a.cross(b);
            left |= turn > 0;
            right |= turn < 0;
            !(left && right)
        })
}
