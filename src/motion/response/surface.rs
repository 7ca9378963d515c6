//! What surfaces do to the velocity of a body that runs into them.

use super::Speed;
use super::reply::{Rule, reply};
use crate::error::RangeError;
use crate::num::{
    Axis, DOMAIN, Fx, Ratio, Raw, Vec2, check_motion, isqrt64_ceil, less128, mul_div, mul64, sqr64, usqr,
};

/// Friction and restitution, for [`Mover::with_surface`](crate::motion::Mover::with_surface) or for a velocity in hand.
///
/// ```text
///   v \    ^ n      the part of v along n comes back, times the restitution;
///      \   |  /     the part along the surface loses the friction times what
///       \  | / '    the part along n changed by, and never turns round
///   _____\_|/______
/// ```
///
/// - **Restitution** acts in [`Response::Bounce`](crate::motion::Response::Bounce): 0 stops at the surface, 1 loses nothing.
/// - **Friction** (Coulomb's) acts in `Bounce`, `Slide` and `Cross`: a body rests on a slope whose tangent is at most the friction, exactly and for
///   ever, and slides down a steeper one.
/// - **Rest**: a bounce slower than [`resting_below`](Self::resting_below) is a slide, or gravity would keep a body humming. Zero by default.
/// - **Speed**: with a [`Speed`], bounces at restitution 1 do not lose what rounding takes, and do not gain.
///
/// ```
/// use tilesat::{Axis, Fx, Ratio, Surface, Vec2};
/// let rubber = Surface::new(Ratio::HALF, Ratio::percent(25).unwrap());
/// // Falls on a floor (y grows downward): 8 come back as 4, and friction takes a quarter of those 12.
/// assert_eq!(rubber.respond(Vec2::from_ints(10, 8), Axis::NEG_Y)?, Vec2::from_ints(7, -4));
/// // What moves away is left alone.
/// assert_eq!(rubber.respond(Vec2::from_ints(10, -8), Axis::NEG_Y)?, Vec2::from_ints(10, -8));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Surface {
    restitution: Ratio,
    friction: Ratio,
    speed: Option<Speed>,
    rest: u32,
}

impl Surface {
    /// A surface that stops what runs into it and lets slide what runs along it.
    pub const SLICK: Self = Self::new(Ratio::ZERO, Ratio::ZERO);
    /// A surface that gives back all.
    pub const ELASTIC: Self = Self::new(Ratio::ONE, Ratio::ZERO);

    /// A surface.
    #[must_use]
    pub const fn new(restitution: Ratio, friction: Ratio) -> Self {
        Self { restitution, friction, speed: None, rest: 0 }
    }

    /// The same surface, on which bodies slide that run into it with at most this speed along the normal (units per call; a negative one is zero).
    ///
    /// A call's gravity `g` is whole in a call that bounces, whenever in it: a bounce faster than `g / (1 - restitution)` loses energy all the same, a
    /// slower one may get back as much as it loses, and go on for ever. So that much, or more, lets a ball that bounces lower and lower come
    /// to rest: twice the gravity at restitution one half.
    #[must_use]
    pub const fn resting_below(self, normal_speed: Fx) -> Self {
        let raw = normal_speed.to_bits();
        Self { rest: if raw < 0 { 0 } else { raw as u32 }, ..self }
    }

    /// The same surface, resting below twice a gravity at least where it bounces. A ball that bounces in every call meets the floor with
    /// `g / (1 + restitution)` and ends each call above it, though it does not move any more; up to a half, none goes on for ever in another way.
    pub(crate) fn resting_under(self, gravity: Vec2) -> Self {
        let (x, y) = gravity.raw();
        let most = if self.restitution == Ratio::ZERO {
            0
        } else {
            x.unsigned_abs().saturating_add(y.unsigned_abs()).saturating_mul(2)
        };
        Self { rest: self.rest.max(most), ..self }
    }

    /// The same surface for a body whose speed should be this: bounces at restitution 1 without friction bring it to that, up or down.
    #[must_use]
    pub const fn with_speed(self, speed: Speed) -> Self {
        Self { speed: Some(speed), ..self }
    }

    /// The restitution.
    #[must_use]
    pub const fn restitution(&self) -> Ratio {
        self.restitution
    }

    /// The friction.
    #[must_use]
    pub const fn friction(&self) -> Ratio {
        self.friction
    }

    /// A velocity after a contact with this surface; `v` itself where it does not move in, or the normal is zero.
    ///
    /// At normals along x or y only the products with the ratios are rounded, toward rest: whole at restitution 0 and 1 without friction. Elsewhere
    /// each component is within 2 raw of the exact one. Never into the surface, never faster than `v` (or than the [`Speed`]), both exactly.
    /// Mirrored input gives mirrored bits. The normal may have any length.
    ///
    /// Cost: some 300 instructions on a Cortex-M0 along x and y, 550 with friction; elsewhere two to four long divisions, 3000 and 3400.
    ///
    /// # Errors
    /// [`RangeError`] where a component of `v` is outside of the [domain](crate::num::DOMAIN).
    pub fn respond(&self, v: Vec2, normal: Axis) -> Result<Vec2, RangeError> {
        check_motion(v, DOMAIN)?;
        let v = Raw::of(v);
        let rule =
            if self.stops(v, normal) { Self { restitution: Ratio::ZERO, ..*self }.rule(v) } else { self.rule(v) };
        Ok(reply(v, normal, &rule).vec2())
    }

    pub(in crate::motion) fn rule(&self, v: Raw) -> Rule {
        let reference = self.speed.map_or(v.len2(), Speed::bound);
        Rule { restitution: self.restitution, friction: self.friction, reference }
    }

    /// Whether `v` is too slow along the normal to bounce: |v.n| <= rest |n|, exactly.
    pub(in crate::motion) fn stops(&self, v: Raw, n: Axis) -> bool {
        let along = n.dot(Axis::new(v.x, v.y)).unsigned_abs();
        self.rest != 0 && !less128(mul64(usqr(self.rest), n.length_squared()), sqr64(along))
    }

    /// A speed along a bend of a radius, less what friction takes for turning the velocity on the `way`: some speed times way by radius.
    pub(in crate::motion) fn turned(&self, speed: u32, way: Raw, radius: i32) -> u32 {
        let turn = mul_div(speed, isqrt64_ceil(way.len2()), radius.unsigned_abs());
        speed.saturating_sub(self.friction.of_wide_up(turn.into()) as u32)
    }

    /// A part along a surface, less what friction takes for a part `into` it, both in one scale.
    pub(in crate::motion) fn rub(&self, along: i64, into: i64) -> i64 {
        let taken = self.friction.of_wide_up(into.min(0).unsigned_abs());
        let left = along.unsigned_abs().saturating_sub(taken) as i64;
        if along < 0 { left.wrapping_neg() } else { left }
    }
}

pub(in crate::motion) mod law {
    //! The part of surfaces that only this crate calls.

    use super::Surface;
    use crate::world::sealed::Sealed;

    /// What a mover's bodies run into: [`Smooth`](super::Smooth), which links no code for friction and restitution, or a [`Surface`].
    pub trait Law: Sealed + Copy {
        /// Whether there is neither friction nor a loss.
        const SMOOTH: bool;
        /// The surface.
        fn surface(&self) -> Surface;
    }
}

/// No friction, and bounces that lose nothing but roundings: what a [`Mover`](crate::motion::Mover) has without being told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Smooth;

impl crate::world::sealed::Sealed for Smooth {}
impl crate::world::sealed::Sealed for Surface {}

impl law::Law for Smooth {
    const SMOOTH: bool = true;
    fn surface(&self) -> Surface {
        Surface::ELASTIC
    }
}

impl law::Law for Surface {
    const SMOOTH: bool = false;
    fn surface(&self) -> Surface {
        *self
    }
}
