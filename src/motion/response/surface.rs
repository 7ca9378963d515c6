//! How surfaces change the velocity of a body that runs into them, and the speed that a bouncing
//! body keeps.

use super::reply::{Rule, reply};
use crate::error::RangeError;
use crate::num::{
    Axis, DOMAIN, Fx, Ratio, Raw, Vec2, check_motion, isqrt64_ceil, less128, mul_div, mul64, sqr64, usqr,
};

/// Friction and restitution, for [`Mover::with_surface`](crate::motion::Mover::with_surface) or for
/// a single velocity.
///
/// ```text
///   v \    ^ n      the part of v along n comes back, times the restitution;
///      \   |  /     the part along the surface loses the friction times what
///       \  | / '    the part along n changed by, and never turns round
///   _____\_|/______
/// ```
///
/// - **Restitution** acts in [`Response::Bounce`](crate::motion::Response::Bounce): 0 is a slide,
///   and 1 loses nothing.
/// - **Friction** (Coulomb's) acts in `Bounce`, `Slide` and `DropThrough`. A body rests on a slope
///   with a tangent of at most the friction, exactly and for ever, and slides down a steeper one.
/// - **Rest**: a bounce slower than [`resting_below`](Self::resting_below) is a slide. Without it
///   gravity would keep a body jittering. Zero by default.
/// - **Speed**: with a [`Speed`], bounces at restitution 1 do not lose speed to rounding, and do
///   not gain.
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
    pub(super) restitution: Ratio,
    pub(super) friction: Ratio,
    pub(super) speed: Option<Speed>,
    pub(super) rest: u32,
}

impl Surface {
    /// A surface without bounce and friction: it stops bodies that run into it, and lets them slide
    /// along it.
    pub const SLICK: Self = Self::new(Ratio::ZERO, Ratio::ZERO);
    /// A surface that returns the whole speed.
    pub const ELASTIC: Self = Self::new(Ratio::ONE, Ratio::ZERO);

    /// A surface with this restitution and friction.
    #[must_use]
    pub const fn new(restitution: Ratio, friction: Ratio) -> Self {
        Self { restitution, friction, speed: None, rest: 0 }
    }

    /// Sets the slowest bounce. A body that hits with at most this speed along the normal slides
    /// instead (in units per call; a negative speed counts as zero).
    ///
    /// A call that bounces applies its whole gravity `g`, whenever in the call the bounce is. A
    /// bounce faster than `g / (1 - restitution)` still loses energy. A slower bounce may regain as
    /// much as it loses, and the body then bounces for ever. If at least that speed is set here, a
    /// ball that bounces lower and lower stops. At restitution one half, that is twice the gravity.
    #[must_use]
    pub const fn resting_below(self, normal_speed: Fx) -> Self {
        let raw = normal_speed.to_bits();
        Self { rest: if raw < 0 { 0 } else { raw as u32 }, ..self }
    }

    /// This surface, resting below at least twice a gravity if it bounces. A ball that bounces in
    /// every call meets the floor with `g / (1 + restitution)` and ends each call above it, though
    /// it no longer moves. Up to a restitution of one half, no other motion lasts for ever.
    pub(crate) fn resting_under(self, gravity: Vec2) -> Self {
        let (x, y) = gravity.raw();
        let most = if self.restitution == Ratio::ZERO {
            0
        } else {
            x.unsigned_abs().saturating_add(y.unsigned_abs()).saturating_mul(2)
        };
        Self { rest: self.rest.max(most), ..self }
    }

    /// Sets the speed that a body should have. Bounces at restitution 1 without friction restore
    /// it, up or down.
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

    /// A velocity after a contact with this surface. `v` itself if it does not move in, or the
    /// normal is zero.
    ///
    /// At normals along x or y only the products with the ratios are rounded, toward rest. They are
    /// exact at restitution 0 and 1 without friction. Elsewhere each component is within 2 raw of
    /// the exact one. The result is never into the surface and never faster than `v` (or than the
    /// [`Speed`]), both exactly. Mirrored input gives mirrored bits. The normal may have any
    /// length.
    ///
    /// Cost: about 300 instructions on a Cortex-M0 along x and y, 550 with friction. Elsewhere two
    /// to four long divisions: 3000 and 3400.
    ///
    /// # Errors
    /// [`RangeError`] if a component of `v` is outside of the [domain](crate::num::DOMAIN).
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

    /// Whether a hit is a slide: nothing comes back, or `v` is too slow along the normal to bounce:
    /// |v.n| <= rest |n|, exactly. So is a hit along the surface, where a curve begins: a bounce
    /// would leave the velocity as it is, and meet the curve again.
    ///
    /// A slide considers all surfaces that the body touches. With one reply per hit, a body in a V
    /// would move up one side and down the other for ever.
    pub(crate) fn stops(&self, v: Raw, n: Axis) -> bool {
        if self.restitution == Ratio::ZERO {
            return true;
        }
        let along = n.dot(Axis::new(v.x, v.y)).unsigned_abs();
        along == 0 || self.rest != 0 && !less128(mul64(usqr(self.rest), n.length_squared()), sqr64(along))
    }

    /// A speed along a bend of a radius, less the friction of turning the velocity over the path
    /// `way`: a part of `speed * way / radius`.
    pub(in crate::motion) fn turned(&self, speed: u32, way: Raw, radius: i32) -> u32 {
        let turn = mul_div(speed, isqrt64_ceil(way.len2()), radius.unsigned_abs());
        speed.saturating_sub(self.friction.of_wide_up(turn.into()) as u32)
    }

    /// A part along a surface, less the friction of a part `into` it, both in one scale.
    pub(in crate::motion) fn rub(&self, along: i64, into: i64) -> i64 {
        let taken = self.friction.of_wide_up(into.min(0).unsigned_abs());
        let left = along.unsigned_abs().saturating_sub(taken) as i64;
        if along < 0 { left.wrapping_neg() } else { left }
    }
}

impl crate::world::sealed::Sealed for Surface {}

/// The square of the speed that a body should have, exact. It keeps a thousand bounces as fast as
/// the first.
///
/// A lattice holds no vector of exactly the right length in a new direction. Each askew bounce is
/// therefore slower by up to a raw unit, and repeated bounces add up. If this reference renews its
/// length, it is never slower than by the last bounce's rounding. Plain data: keep one beside the
/// velocity.
///
/// - Free flight and bounces at restitution one do not change the reference.
/// - A change of the velocity by the game (a jump, a brake, a frame's gravity) changes the
///   reference by the same amount: [`changed`](Self::changed).
/// - After friction, or a bounce that should lose speed, use the speed of the new velocity:
///   [`of`](Self::of).
/// - Under gravity, [`Energy::speed`](super::Energy::speed) returns it for each position.
///
/// ```
/// use tilesat::{Axis, Vec2, motion::Speed};
/// let mut v = Vec2::from_raw(70_001, 12_345);
/// let speed = Speed::of(v);
/// for k in 1..1000 {
///     let wall = Axis::new(-k, 3 * k + 1);
///     let wall = if wall.dot_vec(v) < 0 { wall } else { -wall };
///     v = speed.bounce(v, wall)?;
///     assert!(v.length_squared() <= speed.squared());
/// }
/// assert!(v.length() >= tilesat::Fx::from_bits(71_079)); // from 71 081.2
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Speed(u64);

impl Speed {
    /// The speed of a velocity.
    #[must_use]
    pub const fn of(v: Vec2) -> Self {
        Self(v.length_squared())
    }

    /// The square, in square raw units.
    #[must_use]
    pub const fn squared(self) -> u64 {
        self.0
    }

    pub(super) const fn from_square(square: u64) -> Self {
        Self(square)
    }

    /// The reference after the game has changed the velocity: it changes by the difference of the
    /// squares, and stays at least zero.
    ///
    /// The next bounce can still restore what the last bounce lost to rounding.
    #[must_use]
    pub const fn changed(self, from: Vec2, to: Vec2) -> Self {
        Self(self.0.saturating_add(to.length_squared()).saturating_sub(from.length_squared()))
    }

    /// `v` mirrored at a surface, as fast as this reference. `v` itself if it does not move in or
    /// the normal is zero.
    ///
    /// Exact at normals along x or y, if the reference is within 2 raw of the speed of `v`.
    /// Elsewhere the mirror image is rounded to nearest and scaled to the length of the reference
    /// (rounded to nearest). If that is too long or into the surface, the result is the nearest
    /// vector that is neither. Each component is within 2 raw of the exact one. The result is
    /// slower than the reference by less than 2 raw, and never faster. Mirrored input gives
    /// mirrored bits. Cost: two long divisions and three roots, about 4460 instructions on a
    /// Cortex-M0; only a few along x and y.
    ///
    /// # Errors
    /// [`RangeError`] if a component of `v` is outside of the [domain](crate::num::DOMAIN).
    pub fn bounce(self, v: Vec2, normal: Axis) -> Result<Vec2, RangeError> {
        Surface::ELASTIC.with_speed(self).respond(v, normal)
    }

    /// The bound of a bounce: no velocity is scaled out of the domain.
    pub(super) fn bound(self) -> u64 {
        self.0.min(FASTEST)
    }
}

/// The square of the fastest velocity that a bounce may produce.
const FASTEST: u64 = (DOMAIN as u64 - 1) * (DOMAIN as u64 - 1);

/// Twice the energy of a body of mass one, in square raw units, exact: `|v|^2 + g.v - 2 g.x`.
///
/// Bodies move by `v += g; x += v`. Free flight keeps this number to the last bit. The middle term
/// is there because the velocity is half a frame late.
///
/// A bounce within a frame does not keep it. It turns a velocity that already has the whole frame's
/// gravity, however much of the frame is left. The errors add up to many times the energy (in every
/// engine that we know). So remember the energy, and set the reference speed to the one that the
/// body should have at its position. The next bounce then corrects it, up to the gravity of the
/// part of a frame after it, and that error does not add up.
///
/// So no two bounces are equally high. One may be higher than the start by about one frame of
/// motion at the speed of the bounce. A ball on one flat floor does not need this. Use it for
/// valleys, boxes and tables, where the errors would grow.
///
/// ```
/// use tilesat::{Mover, Response, Surface, Vec2, motion::Energy};
/// # use tilesat::{AllShapes, Circle, Fx, TileKind, TileKinds, TileMap, TileShape};
/// # static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL)
/// #     .with(b'/', TileKind::of(TileShape::SlopeBottomRight)).with(b'L', TileKind::of(TileShape::SlopeBottomLeft));
/// # let map: TileMap<'_, AllShapes> = TileMap::of_ascii("######\n#    #\n#    #\n#L  /#\n##L/##\n######\n", &KINDS)?;
/// # let mut ball = Circle::new(Vec2::from_ints(40, 30), Fx::from_num(5))?;
/// const GRAVITY: Vec2 = Vec2::from_raw(0, 16_384);
/// let mut v = Vec2::from_ints(1, 0);
/// let energy = Energy::of(ball.centre(), v, GRAVITY);
/// for frame in 0..10_000 {
///     let speed = energy.speed(ball.centre(), v, GRAVITY).changed(v, v + GRAVITY);
///     let mover = Mover::new().with_response(Response::Bounce).with_surface(Surface::ELASTIC.with_speed(speed));
///     let moved = mover.move_and_slide(&map, &ball, v + GRAVITY)?;
///     (ball, v) = (moved.body, moved.velocity);
/// }
/// let now = Energy::of(ball.centre(), v, GRAVITY);
/// # let highest = Energy::of(Vec2::from_ints(40, 80), Vec2::ZERO, GRAVITY); // at the bottom of the valley
/// # let (all, off) = (energy.raw() - highest.raw(), (now.raw() - energy.raw()).abs());
/// # assert!(off < all / 5, "{off} of {all}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Energy(i64);

impl Energy {
    /// The energy of a body with this position and velocity, under a gravity in units per frame
    /// squared. All three must be inside the [domain](crate::num::DOMAIN).
    #[must_use]
    pub const fn of(position: Vec2, velocity: Vec2, gravity: Vec2) -> Self {
        Self((velocity.length_squared() as i64).wrapping_add(potential(position, velocity, gravity)))
    }

    /// The energy in square raw units. Only differences mean anything.
    #[must_use]
    pub const fn raw(self) -> i64 {
        self.0
    }

    /// The speed that a body of this energy should have at a position, or zero if it should not be
    /// there at all. `velocity` is its current one.
    #[must_use]
    pub const fn speed(self, position: Vec2, velocity: Vec2, gravity: Vec2) -> Speed {
        let square = self.0.wrapping_sub(potential(position, velocity, gravity));
        Speed::from_square(if square < 0 { 0 } else { square as u64 })
    }
}

/// `g.v - 2 g.x`: below 2^60 in size.
const fn potential(position: Vec2, velocity: Vec2, gravity: Vec2) -> i64 {
    gravity.dot(velocity).wrapping_sub(gravity.dot(position).wrapping_mul(2))
}
