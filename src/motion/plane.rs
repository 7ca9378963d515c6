//! Which way a surface faces, and what becomes of a velocity at the planes that a body touches.

use super::body::kernel::Kernel;
use super::response::{Law, Reply, Smooth};
use crate::num::{Axis, Raw, div_sqrt, mul_div, umul};
use crate::world::World;

/// What a surface is to a body that stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Floor,
    Wall,
    Ceiling,
}

/// The steepest floor, and ceiling: as high as `rise` where it is as wide as `run`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct SlopeLimit {
    pub(super) rise: u16,
    pub(super) run: u16,
}

impl SlopeLimit {
    /// 45 degrees.
    pub(super) const DEFAULT: Self = Self { rise: 1, run: 1 };

    /// What a surface with this normal is: floor where `|n x up| run <= (n . up) rise`, exact.
    ///
    /// Blocks need neither product: one of the two is zero.
    pub(super) fn side(self, up: Axis, normal: Axis) -> Side {
        let (along, across) = (normal.dot(up), normal.perp_dot(up));
        let (a, c) = (along.unsigned_abs(), across.unsigned_abs());
        // At 45 degrees, as at first, no product is needed.
        let is_steep = |a, c| {
            if self.rise == self.run { a < c && self.run != 0 } else { times(a, self.rise) < times(c, self.run) }
        };
        if a == 0 || (c != 0 && is_steep(a, c)) {
            Side::Wall
        } else if along > 0 {
            Side::Floor
        } else {
            Side::Ceiling
        }
    }
}

/// A product of 80 bits, high and low part.
#[inline(never)]
fn times(a: u64, by: u16) -> (u64, u32) {
    let low = umul(a as u32, by.into());
    (umul((a >> 32) as u32, by.into()).wrapping_add(low >> 32), low as u32)
}

impl Default for SlopeLimit {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The planes that a body touches, at most one for each iteration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Planes {
    normals: [Axis; Self::MAX],
    bends: [Bend; Self::MAX],
    len: u8,
    /// Whether the body came flying to the first of them.
    pub(super) landed: bool,
}

/// What a plane is the tangent of: how its normal turns where the body goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    /// A face.
    Flat,
    /// A corner, or an arc from outside: the normal is the body as seen from the centre.
    Convex,
    /// A quarter pipe: the normal is the centre as seen from the body.
    Concave,
}

/// A body that is pushed off by the rounding at one of two slopes still touches the other: within this many raw units of way, on each axis.
pub(super) const NEAR: u32 = 4;

impl Planes {
    pub(super) const MAX: usize = 4;

    pub(super) const NONE: Self =
        Self { normals: [Axis::X; Self::MAX], bends: [Bend::Flat; Self::MAX], len: 0, landed: false };

    /// None yet, of a body that comes flying (`landed`) or that has hardly moved.
    pub(super) fn ahead(landed: bool) -> Self {
        Self { landed, ..Self::NONE }
    }

    /// Keeps the first [`Planes::MAX`]; the mover makes no more hits than that.
    pub(super) fn push(&mut self, normal: Axis, bend: Bend) {
        let place = usize::from(self.len);
        if let (Some(n), Some(b)) = (self.normals.get_mut(place), self.bends.get_mut(place)) {
            (*n, *b) = (normal, bend);
            self.len += 1;
        }
    }

    /// Whether there are several.
    pub(super) fn are_wedge(&self) -> bool {
        self.len > 1
    }

    /// Whether one is of what rounding does not find exactly: not along x or y.
    pub(super) fn are_askew(&self) -> bool {
        self.iter().any(|n| n.x != 0 && n.y != 0)
    }

    /// Whether a body has come back to a quarter pipe without a way, thrown back by another plane: that stands where the pipe bends to. To a
    /// velocity along both it is nothing, by their normals alone; so falls a body that is as wide as a shaft whose end is a pipe.
    pub(super) fn close_pipe(&self, normal: Axis, bend: Bend) -> bool {
        bend == Bend::Concave && self.are_wedge() && self.all().any(|seen| seen == (normal, bend))
    }

    /// Whether a displacement leads neither to nor from any of them, and one is of what rounding does not find exactly. The faces and corners of
    /// blocks are what they are in a level of blocks.
    pub(super) fn are_near(&self, made: Raw) -> bool {
        self.are_askew() && self.iter().all(|n| is_near(made, n, NEAR))
    }

    /// Whether some are left after the body has moved: faces that it has not risen from, and what is within [`NEAR`]; of a body that lay on
    /// them also what it has slid along otherwise, with the normal that it has there now.
    ///
    /// A face counts as long as it could be, so that it does not matter what it is made of.
    pub(super) fn keep_touching(&mut self, made: Raw) -> bool {
        let near = way(made) <= NEAR;
        let old = *self;
        *self = Self { landed: self.landed, ..Self::NONE };
        for (n, bend) in old.all() {
            if near || (bend == Bend::Flat && into(made, n) <= margin(n, NEAR)) {
                self.push(n, bend);
            } else if !self.landed && matches!(bend, Bend::Convex | Bend::Concave) {
                let n = bend.turned(n, made);
                if into(made, n).unsigned_abs() * 4 <= umul(way(made), n.x.unsigned_abs().max(n.y.unsigned_abs())) {
                    self.push(n, bend);
                }
            }
        }
        self.len > 0
    }

    fn iter(&self) -> impl Iterator<Item = Axis> {
        self.normals.iter().copied().take(self.len.into())
    }

    fn all(&self) -> impl Iterator<Item = (Axis, Bend)> {
        self.iter().zip(self.bends)
    }

    pub(super) fn allow(&self, v: Raw) -> bool {
        self.iter().all(|n| into(v, n) >= 0)
    }

    /// The longest velocity that enters none of the planes, out of `v`, its projections on each plane, and rest.
    ///
    /// Projecting the velocity from before the first plane on the cone of all of them, instead of clipping it at one plane after the
    /// other, leaves no cycle between two slopes.
    pub(super) fn slide<B: Kernel, W: World>(&self, v: Raw) -> Raw {
        self.slide_on::<B, W, _>(v, &Smooth)
    }

    /// The same on a surface that may have friction; that acts last, so that it has no say in which plane it is.
    pub(super) fn slide_on<B: Kernel, W: World, S: Law>(&self, v: Raw, surface: &S) -> Raw {
        if self.allow(v) {
            return v;
        }
        let (mut best, mut on) = (Raw { x: 0, y: 0 }, None);
        for n in self.iter() {
            let along = project::<B, W, _>(v, n, &Smooth);
            if along.len2() > best.len2() && self.allow(along) {
                (best, on) = (along, Some(n));
            }
        }
        match on {
            Some(n) if !S::SMOOTH => {
                let rubbed = project::<B, W, _>(v, n, surface);
                if self.allow(rubbed) { rubbed } else { Raw { x: 0, y: 0 } }
            }
            _ => best,
        }
    }

    /// The rest of a motion whose velocity `v` is allowed: along a slope where that is, to the last bit, and into no plane.
    ///
    /// What enters a plane does so because it was rounded toward zero, by less than a raw unit on each axis: so far it is put back. Where that enters
    /// another one, it is projected as velocities are, which loses some units of way.
    pub(super) fn keep<B: Kernel, W: World>(&self, v: Raw, rest: Raw) -> Raw {
        let slope = self.iter().find(|&n| into(v, n) == 0 && into(rest, n) != 0);
        let rest = slope.map_or(rest, |n| project::<B, W, _>(rest, n, &Smooth));
        let entered = self.iter().find(|&n| into(rest, n) < 0);
        let out = entered.map_or(rest, |n| rest.add(Raw { x: n.x.signum(), y: n.y.signum() }));
        if self.allow(out) { out } else { self.slide::<B, W>(rest) }
    }
}

impl Bend {
    /// The normal after a displacement. One along x or y has length one: it stays.
    fn turned(self, n: Axis, made: Raw) -> Axis {
        if n.x == 0 || n.y == 0 {
            return n;
        }
        match self {
            Self::Flat => n,
            Self::Convex => Axis::new(n.x.wrapping_add(made.x), n.y.wrapping_add(made.y)),
            Self::Concave => Axis::new(n.x.wrapping_sub(made.x), n.y.wrapping_sub(made.y)),
        }
    }
}

/// Whether a displacement leads neither to nor from a plane, by less than `limit` or up to half more.
pub(super) fn is_near(made: Raw, n: Axis, limit: u32) -> bool {
    into(made, n).abs() <= margin(n, limit)
}

/// A length, or up to half more, in the length of a normal.
fn margin(n: Axis, length: u32) -> i64 {
    umul(n.x.unsigned_abs(), length).wrapping_add(umul(n.y.unsigned_abs(), length)) as i64
}

/// The longer component of a displacement.
pub(super) fn way(made: Raw) -> u32 {
    made.x.unsigned_abs().max(made.y.unsigned_abs())
}

/// The component of `v` along the normal, scaled: negative means into the plane. |v| < 2^29, |n| < 2^30: below 2^60.
pub(super) fn into(v: Raw, n: Axis) -> i64 {
    n.dot(Axis::new(v.x, v.y))
}

/// Whether normals may be askew: where not, the code for them is not linked.
pub(super) const fn may_be_askew<B: Kernel, W: World>() -> bool {
    B::MEETS_CORNERS || !W::BLOCKS
}

/// `v` without its part along the normal, less what friction takes: never into the plane, never longer than `v` (both exactly), zero where `v` has
/// no part along it.
pub(super) fn project<B: Kernel, W: World, S: Law>(v: Raw, n: Axis, surface: &S) -> Raw {
    let rub = |along: i64, into: i64| if S::SMOOTH { along } else { surface.surface().rub(along, into) };
    if n.x == 0 || n.y == 0 || !may_be_askew::<B, W>() {
        let x = if n.x == 0 { rub(v.x.into(), into(v, Axis::new(0, n.y.signum()))) as i32 } else { 0 };
        let y = if n.x == 0 { 0 } else { rub(v.y.into(), into(v, Axis::new(n.x.signum(), 0))) as i32 };
        return Raw { x, y };
    }
    let along = rub(across(v, n), into(v, n));
    if !W::BLOCKS && n.x.unsigned_abs() <= 2 && n.y.unsigned_abs() <= 2 {
        return project_slope(along, n);
    }
    let out = tangent(tangential(along, n), n, along < 0);
    if into(out, n) >= 0 && out.len2() <= v.len2() { out } else { Raw { x: 0, y: 0 } }
}

/// Exactly along a slope of tiles: the largest multiple of its direction that is not longer than the exact projection.
#[inline(never)]
fn project_slope(along: i64, n: Axis) -> Raw {
    // |v| < 2^29 and |n|^2 <= 8: the dot product is below 2^31.
    let k = mul_div(along.unsigned_abs() as u32, 1, n.length_squared() as u32) as i32;
    let k = if along < 0 { k.wrapping_neg() } else { k };
    Raw { x: n.y.wrapping_neg().wrapping_mul(k), y: n.x.wrapping_mul(k) }
}

/// A velocity of at most `speed` along the tangent (-n.y, n.x), or against it: the largest multiple of the direction of a slope of tiles, elsewhere
/// as [`tangent`].
pub(super) fn lies_along<B: Kernel, W: World>(speed: u32, n: Axis, against: bool) -> Raw {
    let small = n.x.unsigned_abs() <= 2 && n.y.unsigned_abs() <= 2;
    if W::BLOCKS || !small || n.x == 0 || n.y == 0 {
        return tangent(speed, n, against);
    }
    let k = div_sqrt(speed.into(), n.length_squared()) as i32;
    let k = if against { k.wrapping_neg() } else { k };
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

/// `v` after a bounce: never longer than it (or its reference speed), never into the plane; unchanged where it does not move in.
pub(super) fn reflect<B: Kernel, W: World, S: Law>(v: Raw, n: Axis, surface: &S, reply: Reply) -> Raw {
    if S::SMOOTH && !may_be_askew::<B, W>() {
        if into(v, n) >= 0 {
            return v;
        }
        let along_x = n.x == 0;
        return Raw {
            x: if along_x { v.x } else { v.x.wrapping_neg() },
            y: if along_x { v.y.wrapping_neg() } else { v.y },
        };
    }
    reply(v, n, &surface.surface().rule(v))
}

#[cfg(test)]
mod tests {
    use super::{Axis, Bend, Raw};

    /// Outside of a disc the normal is the body as seen from its centre, inside of one the centre as seen from the body; sides do not turn.
    #[test]
    fn normals_turn_with_the_body() {
        let made = Raw { x: 30, y: -7 };
        for n in [Axis::new(300, 400), Axis::new(-300, 400), Axis::new(5, -12)] {
            assert_eq!(Bend::Convex.turned(n, made), Axis::new(n.x + 30, n.y - 7));
            assert_eq!(Bend::Concave.turned(n, made), Axis::new(n.x - 30, n.y + 7));
            assert_eq!(Bend::Flat.turned(n, made), n);
        }
        for n in [Axis::X, Axis::Y, Axis::NEG_X, Axis::NEG_Y] {
            assert_eq!((Bend::Convex.turned(n, made), Bend::Concave.turned(n, made)), (n, n));
        }
    }
}
