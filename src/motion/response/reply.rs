//! The velocity after a contact: the exact reply, and the lattice vector nearest to it.

use crate::num::{Axis, Ratio, Raw, imul, isqrt64, scaled, toward, umul};

/// How a surface changes a velocity that moves into it.
#[derive(Clone, Copy)]
pub(in crate::motion) struct Rule {
    pub(in crate::motion) restitution: Ratio,
    pub(in crate::motion) friction: Ratio,
    /// The square of the speed after a bounce without loss.
    pub(in crate::motion) reference: u64,
}

/// The velocity after a contact with a plane of normal `n`. `v` itself if it does not move in, or
/// `n` is zero.
///
/// Let s = v.n < 0, and c = v.t along the tangent t = (-n.y, n.x), both scaled by |n|. The contact
/// gives `j = (1 + restitution) |s|` along the normal and takes `min(|c|, friction j)` along the
/// tangent. j is rounded down, the friction up. For |v| < 2^29.5 and any normal, |s| and |c| are
/// below 2^61.
pub(in crate::motion) fn reply(v: Raw, n: Axis, rule: &Rule) -> Raw {
    let s = n.dot(Axis::new(v.x, v.y));
    if s >= 0 {
        v
    } else if n.x == 0 {
        let (y, x) = straight(v.y, v.x, rule);
        rule.drawn(Raw { x, y }, v, n)
    } else if n.y == 0 {
        let (x, y) = straight(v.x, v.y, rule);
        rule.drawn(Raw { x, y }, v, n)
    } else {
        askew(v, n, s.unsigned_abs(), rule)
    }
}

/// At a face along x or y only the products with the ratios are rounded, both toward zero.
fn straight(into: i32, along: i32, rule: &Rule) -> (i32, i32) {
    let back = rule.restitution.of_raw(into);
    if rule.friction == Ratio::ZERO {
        return (back.wrapping_neg(), along);
    }
    // Rounded up once: ceil(ceil(a / b) / b) = ceil(a / b^2). Below 2^60, and the part taken is
    // below 2^30.
    let change = umul(into.unsigned_abs(), Ratio::ONE.raw() + rule.restitution.raw());
    let taken = rule.friction.of_wide_up(change).wrapping_add(u64::from(Ratio::ONE.raw()) - 1) >> 30;
    let left = along.unsigned_abs().saturating_sub(taken as u32) as i32;
    (back.wrapping_neg(), if along < 0 { left.wrapping_neg() } else { left })
}

#[inline(never)]
fn askew(v: Raw, n: Axis, s: u64, rule: &Rule) -> Raw {
    let nn = n.length_squared();
    let back = rule.restitution.of_wide(s);
    let j = s.wrapping_add(back);
    let c = n.perp_dot(Axis::new(v.x, v.y));
    let taken = rule.friction.of_wide_up(j);
    let mut out = if taken >= c.unsigned_abs() {
        // Nothing is left along the surface.
        along(n, back as i64, nn)
    } else {
        v.add(along(n, j as i64, nn))
    };
    if taken != 0 && taken < c.unsigned_abs() {
        // Along the tangent (-n.y, n.x). The number is negated, not the component: of `i32::MIN`
        // there is no opposite.
        let taken = if c < 0 { taken as i64 } else { (taken as i64).wrapping_neg() };
        out = out.add(Raw { x: scaled(n.y, taken.wrapping_neg(), nn), y: scaled(n.x, taken, nn) });
    }
    if rule.loses_nothing() {
        return rule.at_speed(out, v, n);
    }
    // There always is one: see `settle`.
    settle(out, n, v.len2(), 1).unwrap_or(Raw { x: 0, y: 0 })
}

impl Rule {
    fn loses_nothing(&self) -> bool {
        self.restitution == Ratio::ONE && self.friction == Ratio::ZERO
    }

    /// A mirror image, scaled to the reference. Not scaled if that magnifies its rounding into the
    /// surface.
    #[inline(never)]
    fn at_speed(&self, out: Raw, v: Raw, n: Axis) -> Raw {
        let square = v.len2();
        if square != self.reference && !out.is_zero() {
            let drawn = toward(out, isqrt64(self.reference) as i32);
            if let Some(drawn) = settle(drawn, n, self.reference, 1) {
                return drawn;
            }
        }
        settle(out, n, square.min(self.reference), 1).unwrap_or(Raw { x: 0, y: 0 })
    }

    /// An exact mirror image, scaled to a reference that is more than 2 raw away. A smaller
    /// difference is only rounding at other surfaces.
    fn drawn(&self, out: Raw, v: Raw, n: Axis) -> Raw {
        let square = v.len2();
        if square == self.reference || !self.loses_nothing() {
            return out;
        }
        if isqrt64(square).abs_diff(isqrt64(self.reference)) <= 2 { out } else { self.at_speed(out, v, n) }
    }
}

/// `n k / nn`, each component rounded to nearest.
fn along(n: Axis, k: i64, nn: u64) -> Raw {
    Raw { x: scaled(n.x, k, nn), y: scaled(n.y, k, nn) }
}

/// The vector nearest to `q`, in steps of `step` from it, that is not into the plane and has a
/// square of at most `bound`. None if there is none within two steps. At a normal along x or y,
/// steps of more than one do not change the other component.
///
/// Around a velocity rounded to nearest there always is one in steps of 1. At worst (a grazing
/// reply) the allowed set looks like a quarter plane there. That holds a disc of half a diagonal
/// within a diagonal and a half. Of equally near vectors it takes the longest, then the one with
/// the longer x, then the one farther out of the plane. The only ties left are the two ways along
/// the plane. It takes neither, so mirrored input gives mirrored bits.
pub(super) fn settle(q: Raw, n: Axis, bound: u64, step: i32) -> Option<Raw> {
    let (square, out) = (q.len2() as i64, n.dot(Axis::new(q.x, q.y)));
    if square as u64 <= bound && out >= 0 {
        return Some(q);
    }
    // The change of the dot product and, except for the square of the step, of the square by one
    // step in x or y: no product per candidate.
    let (nx, ny) = (imul(n.x, step), imul(n.y, step));
    let (sx, sy) = (imul(q.x, step.wrapping_mul(2)), imul(q.y, step.wrapping_mul(2)));
    let (unit, pinned) = (step.wrapping_mul(step), step != 1);
    for reach in 1..=2_i32 {
        let (wide, high) = (if pinned && n.x == 0 { 0 } else { reach }, if pinned && n.y == 0 { 0 } else { reach });
        let corner = |at: i64, x: i64, y: i64| {
            at.wrapping_sub(x.wrapping_mul(wide.into())).wrapping_sub(y.wrapping_mul(high.into()))
        };
        let mut best = None;
        let mut first = (i32::MAX, 0, 0, 0);
        let (mut square_x, mut out_x) = (corner(square, sx, sy), corner(out, nx, ny));
        for dx in -wide..=wide {
            let (mut square, mut out) = (square_x, out_x);
            for dy in -high..=high {
                let ring = dx * dx + dy * dy;
                let long = square.wrapping_add(ring.wrapping_mul(unit).into()) as u64;
                if long <= bound && out >= 0 && ring <= first.0 {
                    let at = q.add(Raw { x: dx.wrapping_mul(step), y: dy.wrapping_mul(step) });
                    let key = (ring, !long, !at.x.unsigned_abs(), out.wrapping_neg());
                    let either_way = out == 0 && long != 0 && at.dot(q) == 0;
                    if !either_way && key < first {
                        (best, first) = (Some(at), key);
                    }
                }
                (square, out) = (square.wrapping_add(sy), out.wrapping_add(ny));
            }
            (square_x, out_x) = (square_x.wrapping_add(sx), out_x.wrapping_add(nx));
        }
        if best.is_some() {
            return best;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{Axis, Raw, settle};

    /// Two neighbours of the velocity are on the plane, and equally near. The shorter one counts
    /// only if the longer one is faster than the bound.
    #[test]
    fn of_equally_near_velocities_the_longest() {
        let (q, n) = (Raw { x: 2, y: -3 }, Axis::new(1, 1));
        assert_eq!(settle(q, n, 18, 1), Some(Raw { x: 3, y: -3 }));
        assert_eq!(settle(q, n, 17, 1), Some(Raw { x: 2, y: -2 }));
    }
}
