//! Rounding of exact quotients to the nearest lattice point, the same way on both sides of zero.

use crate::num::{Raw, div_sqrt, mul_div_wide, umul};

/// `n * s / d` to nearest, halves toward zero; for `|s| < 2^63`, `d > 0` below 2^63 and a result below 2^32 in size.
///
/// The result is taken modulo 2^32: it may be added to a coordinate that is farther away than an `i32` says.
pub(crate) const fn scaled(n: i32, s: i64, d: u64) -> i32 {
    let (k, a) = (n.unsigned_abs(), s.unsigned_abs());
    let floor = mul_div_wide(a, k, d);
    // The remainder is below d, so its low 64 bits are all of it.
    let rest = a.wrapping_mul(k as u64).wrapping_sub(d.wrapping_mul(floor as u64));
    let nearest = floor.wrapping_add((rest > d.wrapping_sub(rest)) as u32) as i32;
    if (n < 0) == (s < 0) { nearest } else { nearest.wrapping_neg() }
}

/// `v r / |v|` to nearest, for one magnitude `v` of a vector with the square `d > 0`, and a radius `r` below 2^29.
///
/// There are no halves: 2 v r / |v| is odd for no integers, because a primitive Pythagorean triple has an odd hypotenuse.
pub(super) const fn on_circle(v: u32, r: u32, d: u64) -> u32 {
    // 2x + 1 rounded down and halved is x to nearest; |v| <= 2^32 and r < 2^29 keep the product below 2^63.
    div_sqrt(umul(v, r) << 1, d).wrapping_add(1) >> 1
}

/// [`on_circle`] for both components of a difference inside the domain, not zero.
pub(crate) const fn toward(v: Raw, r: i32) -> Raw {
    let d = v.len2();
    let (x, y) = (on_circle(v.x.unsigned_abs(), r as u32, d) as i32, on_circle(v.y.unsigned_abs(), r as u32, d) as i32);
    Raw { x: if v.x < 0 { x.wrapping_neg() } else { x }, y: if v.y < 0 { y.wrapping_neg() } else { y } }
}
