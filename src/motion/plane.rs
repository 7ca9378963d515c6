//! What becomes of a velocity at the planes that a body touches.

use super::body::kernel::Kernel;
use crate::num::{Axis, Raw, div_sqrt, mul_div_wide, umul};

/// The planes that a body touches at one place, at most one for each iteration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Planes {
    normals: [Axis; Self::MAX],
    len: usize,
}

impl Planes {
    pub(super) const MAX: usize = 4;

    pub(super) const NONE: Self = Self { normals: [Axis::X; Self::MAX], len: 0 };

    /// Keeps the first [`Planes::MAX`]; the mover makes no more hits than that.
    pub(super) fn push(&mut self, normal: Axis) {
        if let Some(slot) = self.normals.get_mut(self.len) {
            *slot = normal;
            self.len += 1;
        }
    }

    fn iter(&self) -> impl Iterator<Item = Axis> {
        self.normals.iter().take(self.len).copied()
    }

    fn allow(&self, v: Raw) -> bool {
        self.iter().all(|n| into(v, n) >= 0)
    }

    /// The longest velocity that enters none of the planes, out of `v`, its projections on each plane, and rest.
    ///
    /// Projecting the velocity from before the first plane on the cone of all of them, instead of clipping it at one plane after the
    /// other, leaves no cycle between two slopes.
    pub(super) fn slide<B: Kernel>(&self, v: Raw) -> Raw {
        if self.allow(v) {
            return v;
        }
        let mut best = Raw { x: 0, y: 0 };
        for n in self.iter() {
            let along = project::<B>(v, n);
            if along.len2() > best.len2() && self.allow(along) {
                best = along;
            }
        }
        best
    }
}

/// The component of `v` along the normal, scaled: negative means into the plane. |v| < 2^29, |n| < 2^30: below 2^60.
fn into(v: Raw, n: Axis) -> i64 {
    n.dot(Axis::new(v.x, v.y))
}

/// `v` without its part along the normal: never into the plane, never longer than `v` (both exactly), zero where `v` has no part along it.
fn project<B: Kernel>(v: Raw, n: Axis) -> Raw {
    if n.x == 0 || n.y == 0 || !B::MEETS_CORNERS {
        return Raw { x: if n.x == 0 { v.x } else { 0 }, y: if n.x == 0 { 0 } else { v.y } };
    }
    project_askew(v, n)
}

#[inline(never)]
fn project_askew(v: Raw, n: Axis) -> Raw {
    let along = n.perp_dot(Axis::new(v.x, v.y));
    // The tangential speed, less two raw for the roundings below, less what the unit vector's error can add: 2 parts in 2^30 of it.
    let speed = div_sqrt(along.unsigned_abs(), n.length_squared());
    let speed = speed.saturating_sub(2 + (speed >> 26));
    // The tangent is (-n.y, n.x), reversed where `along` is negative; each component is rounded toward the normal's side.
    let (ux, uy) = n.unit().raw();
    let (tx, ty) = if along < 0 { (uy, -ux) } else { (-uy, ux) };
    let out = Raw { x: toward(speed, tx, n.x), y: toward(speed, ty, n.y) };
    if into(out, n) >= 0 && out.len2() <= v.len2() { out } else { Raw { x: 0, y: 0 } }
}

/// `speed * unit` (Q30), rounded up or down as `side` is positive or negative, beyond the error of `unit` (below 2 units).
fn toward(speed: u32, unit: i32, side: i32) -> i32 {
    const BELOW_ONE: u64 = (1 << 30) - 1;
    let (product, error) = (umul(speed, unit.unsigned_abs()), 2 * u64::from(speed));
    if (unit < 0) == (side < 0) {
        // Away from zero.
        let size = (product.wrapping_add(error).wrapping_add(BELOW_ONE) >> 30) as i32;
        if unit < 0 { size.wrapping_neg() } else { size }
    } else {
        // Toward zero; it may pass it by the error.
        let size = (product as i64).wrapping_sub(error as i64) >> 30;
        if unit < 0 { (size as i32).wrapping_neg() } else { size as i32 }
    }
}

/// `v` mirrored at the plane, rounded to nearest, never longer than `v`; unchanged where it does not move in.
pub(super) fn reflect<B: Kernel>(v: Raw, n: Axis) -> Raw {
    let speed = into(v, n);
    if speed >= 0 {
        return v;
    }
    if n.x == 0 || n.y == 0 || !B::MEETS_CORNERS {
        let along_x = n.x == 0;
        return Raw {
            x: if along_x { v.x } else { v.x.wrapping_neg() },
            y: if along_x { v.y.wrapping_neg() } else { v.y },
        };
    }
    reflect_askew(v, n, speed)
}

#[inline(never)]
fn reflect_askew(v: Raw, n: Axis, speed: i64) -> Raw {
    // v - 2 (v.n) n / n.n. With k = 2 |v.n| < 2^61 the component k |n_i| / n.n is below 2^31.
    let (k, nn) = (2 * speed.unsigned_abs(), n.length_squared());
    let part = |component: i32| {
        let part = mul_div_wide(k.wrapping_mul(2), component.unsigned_abs(), nn).wrapping_add(1) >> 1;
        if component < 0 { (part as i32).wrapping_neg() } else { part as i32 }
    };
    let mut out = Raw { x: v.x.wrapping_add(part(n.x)), y: v.y.wrapping_add(part(n.y)) };
    // Rounding may lengthen it by a raw unit or two; take them from the larger component. A reflection that gains nothing keeps it.
    while out.len2() > v.len2() {
        if out.x.unsigned_abs() >= out.y.unsigned_abs() {
            out.x = out.x.wrapping_sub(out.x.signum());
        } else {
            out.y = out.y.wrapping_sub(out.y.signum());
        }
    }
    if into(out, n) >= 0 { out } else { project_askew(v, n) }
}
