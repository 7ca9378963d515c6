//! What becomes of a velocity at the planes that a body touches.

use super::body::kernel::Kernel;
use crate::num::{Axis, Raw, div_sqrt, mul_div, mul_div_wide, umul};
use crate::world::World;

/// The planes that a body touches, at most one for each iteration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Planes {
    list: [Plane; Self::MAX],
    len: usize,
    /// Whether the body came flying to the first of them.
    pub(super) landed: bool,
}

#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: Axis,
    /// Whether it is a face, not one place of a corner or an arc.
    flat: bool,
}

/// A body that is pushed off by the rounding at one of two slopes still touches the other: within this many raw units of way, on each axis.
pub(super) const NEAR: u32 = 4;

impl Planes {
    pub(super) const MAX: usize = 4;

    pub(super) const NONE: Self =
        Self { list: [Plane { normal: Axis::X, flat: true }; Self::MAX], len: 0, landed: false };

    /// None yet, of a body that comes flying (`landed`) or that has hardly moved.
    pub(super) fn ahead(landed: bool) -> Self {
        Self { landed, ..Self::NONE }
    }

    /// Keeps the first [`Planes::MAX`]; the mover makes no more hits than that.
    pub(super) fn push(&mut self, normal: Axis, flat: bool) {
        if let Some(slot) = self.list.get_mut(self.len) {
            *slot = Plane { normal, flat };
            self.len += 1;
        }
    }

    /// Whether some are left after the body has moved: faces that it has not risen from, and what is within [`NEAR`].
    ///
    /// A face counts as long as it could be, so that it does not matter what it is made of.
    pub(super) fn keep_touching(&mut self, made: Raw) -> bool {
        let near = way(made) <= NEAR;
        let old = *self;
        *self = Self { landed: self.landed, ..Self::NONE };
        for plane in old.list.iter().take(old.len) {
            let n = plane.normal;
            let size = u64::from(n.x.unsigned_abs()) + u64::from(n.y.unsigned_abs());
            if near || (plane.flat && into(made, n) <= (size * u64::from(NEAR)) as i64) {
                self.push(n, plane.flat);
            }
        }
        self.len > 0
    }

    fn iter(&self) -> impl Iterator<Item = Axis> {
        self.list.iter().take(self.len).map(|plane| plane.normal)
    }

    pub(super) fn allow(&self, v: Raw) -> bool {
        self.iter().all(|n| into(v, n) >= 0)
    }

    /// The longest velocity that enters none of the planes, out of `v`, its projections on each plane, and rest.
    ///
    /// Projecting the velocity from before the first plane on the cone of all of them, instead of clipping it at one plane after the
    /// other, leaves no cycle between two slopes.
    pub(super) fn slide<B: Kernel, W: World>(&self, v: Raw) -> Raw {
        if self.allow(v) {
            return v;
        }
        let mut best = Raw { x: 0, y: 0 };
        for n in self.iter() {
            let along = project::<B, W>(v, n);
            if along.len2() > best.len2() && self.allow(along) {
                best = along;
            }
        }
        best
    }

    /// The rest of a motion whose velocity `v` is allowed: along a slope where that is, to the last bit, and into no plane.
    pub(super) fn keep<B: Kernel, W: World>(&self, v: Raw, rest: Raw) -> Raw {
        let slope = self.iter().find(|&n| into(v, n) == 0 && into(rest, n) != 0);
        let rest = slope.map_or(rest, |n| project::<B, W>(rest, n));
        self.slide::<B, W>(rest)
    }
}

/// The longer component of a displacement.
pub(super) fn way(made: Raw) -> u32 {
    made.x.unsigned_abs().max(made.y.unsigned_abs())
}

/// The component of `v` along the normal, scaled: negative means into the plane. |v| < 2^29, |n| < 2^30: below 2^60.
fn into(v: Raw, n: Axis) -> i64 {
    n.dot(Axis::new(v.x, v.y))
}

/// Whether normals may be askew: where not, the code for them is not linked.
const fn may_be_askew<B: Kernel, W: World>() -> bool {
    B::MEETS_CORNERS || !W::BLOCKS
}

/// `v` without its part along the normal: never into the plane, never longer than `v` (both exactly), zero where `v` has no part along it.
fn project<B: Kernel, W: World>(v: Raw, n: Axis) -> Raw {
    if n.x == 0 || n.y == 0 || !may_be_askew::<B, W>() {
        return Raw { x: if n.x == 0 { v.x } else { 0 }, y: if n.x == 0 { 0 } else { v.y } };
    }
    if !W::BLOCKS && n.x.unsigned_abs() <= 2 && n.y.unsigned_abs() <= 2 {
        return project_slope(v, n);
    }
    let along = across(v, n);
    let out = tangent(tangential(along, n), n, along < 0);
    if into(out, n) >= 0 && out.len2() <= v.len2() { out } else { Raw { x: 0, y: 0 } }
}

/// Exactly along a slope of tiles: the largest multiple of its direction that is not longer than the exact projection.
#[inline(never)]
fn project_slope(v: Raw, n: Axis) -> Raw {
    // |v| < 2^29 and |n|^2 <= 8: the dot product is below 2^31.
    let along = across(v, n);
    let k = mul_div(along.unsigned_abs() as u32, 1, n.length_squared() as u32) as i32;
    let k = if along < 0 { k.wrapping_neg() } else { k };
    Raw { x: n.y.wrapping_neg().wrapping_mul(k), y: n.x.wrapping_mul(k) }
}

/// `v` along the tangent (-n.y, n.x), in its length.
pub(super) fn across(v: Raw, n: Axis) -> i64 {
    n.perp_dot(Axis::new(v.x, v.y))
}

/// The tangential speed of which `along` is a multiple, rounded down.
#[inline(never)]
pub(super) fn tangential(along: i64, n: Axis) -> u32 {
    div_sqrt(along.unsigned_abs(), n.length_squared())
}

/// A velocity along the tangent (-n.y, n.x), or against it, of at most `speed` and not into the plane.
#[inline(never)]
pub(super) fn tangent(speed: u32, n: Axis, against: bool) -> Raw {
    if n.x == 0 || n.y == 0 {
        let speed = if against { (speed as i32).wrapping_neg() } else { speed as i32 };
        return Raw { x: n.y.signum().wrapping_neg().wrapping_mul(speed), y: n.x.signum().wrapping_mul(speed) };
    }
    // Less two raw for the roundings below, less what the unit vector's error can add: 2 parts in 2^30 of it.
    let safe = speed.saturating_sub(2 + (speed >> 26));
    let (ux, uy) = n.unit().raw();
    let (tx, ty) = if against { (uy, -ux) } else { (-uy, ux) };
    Raw { x: toward(safe, tx, n.x), y: toward(safe, ty, n.y) }
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
pub(super) fn reflect<B: Kernel, W: World>(v: Raw, n: Axis) -> Raw {
    let speed = into(v, n);
    if speed >= 0 {
        return v;
    }
    if n.x == 0 || n.y == 0 || !may_be_askew::<B, W>() {
        let along_x = n.x == 0;
        return Raw {
            x: if along_x { v.x } else { v.x.wrapping_neg() },
            y: if along_x { v.y.wrapping_neg() } else { v.y },
        };
    }
    let out = reflect_askew(v, n, speed);
    if into(out, n) >= 0 { out } else { project::<B, W>(v, n) }
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
    // Rounding may lengthen it by a raw unit or two; take them from the larger component, from both where they are equal. A reflection that
    // gains nothing keeps it.
    while out.len2() > v.len2() {
        let (x, y) = (out.x.unsigned_abs(), out.y.unsigned_abs());
        if x >= y {
            out.x = out.x.wrapping_sub(out.x.signum());
        }
        if y >= x {
            out.y = out.y.wrapping_sub(out.y.signum());
        }
    }
    out
}
