//! How an impact changes velocities: of one body at a surface, and of two bodies that meet and
//! share a push.

use super::Surface;
use super::reply::{Rule, reply, settle};
use crate::error::RangeError;
use crate::num::{Axis, DOMAIN, MOTION, Ratio, Raw, Vec2, check_motion, mul_div, scaled};
use crate::query::Contact;

/// A vector as the sum of a part along a normal and a part along the surface. The sum is exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Split {
    /// Along the normal, or against it.
    pub normal: Vec2,
    /// Along the surface.
    pub tangent: Vec2,
}

/// Splits a velocity at a normal of any length.
///
/// The normal part is rounded to nearest (halves toward zero), and the tangent is the rest. Both
/// are within half a raw unit of the exact parts, and their sum is `v`. Exact at normals along x
/// and y. A zero normal puts everything into the tangent. The [`length`](Vec2::length) of the
/// normal part is the speed of the impact. Mirrored input gives mirrored bits. Cost: two long
/// divisions, about 1730 instructions on a Cortex-M0.
///
/// ```
/// use tilesat::{Axis, Vec2, motion::response::split};
/// let parts = split(Vec2::from_ints(7, 1), Axis::new(3, -4))?;
/// assert_eq!(parts.normal, Vec2::from_raw(133_693, -178_258)); // 17/25 of (3, -4)
/// assert_eq!(parts.normal + parts.tangent, Vec2::from_ints(7, 1));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] if a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn split(v: Vec2, normal: Axis) -> Result<Split, RangeError> {
    check_motion(v, DOMAIN)?;
    let along = if normal.x == 0 {
        Vec2::from_raw(0, if normal.y == 0 { 0 } else { v.y.to_bits() })
    } else if normal.y == 0 {
        Vec2::from_raw(v.x.to_bits(), 0)
    } else {
        let (s, nn) = (normal.dot_vec(v), normal.length_squared());
        Raw { x: scaled(normal.x, s, nn), y: scaled(normal.y, s, nn) }.vec2()
    };
    Ok(Split { normal: along, tangent: v - along })
}

/// A velocity without its part into a surface: [`Surface::respond`] of [`Surface::SLICK`].
///
/// ```
/// use tilesat::{Axis, Vec2, motion::response::slide};
/// let (falls, floor) = (Vec2::from_ints(3, 4), Axis::NEG_Y); // y grows downward
/// assert_eq!(slide(falls, floor)?, Vec2::from_ints(3, 0));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] if a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn slide(v: Vec2, normal: Axis) -> Result<Vec2, RangeError> {
    Surface::SLICK.respond(v, normal)
}

/// A velocity with its part into a surface reversed, times `restitution`: [`Surface::respond`]
/// without friction.
///
/// ```
/// use tilesat::{Axis, Ratio, Vec2, motion::response::bounce};
/// let (falls, floor) = (Vec2::from_ints(3, 4), Axis::NEG_Y); // y grows downward
/// assert_eq!(bounce(falls, floor, Ratio::HALF)?, Vec2::from_ints(3, -2));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] if a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn bounce(v: Vec2, normal: Axis, restitution: Ratio) -> Result<Vec2, RangeError> {
    Surface::new(restitution, Ratio::ZERO).respond(v, normal)
}

/// A velocity after a contact with restitution and friction: [`Surface::respond`].
///
/// ```
/// use tilesat::{Axis, Ratio, Vec2, fx, motion::response::respond};
/// let (falls, floor) = (Vec2::from_ints(3, 4), Axis::NEG_Y); // y grows downward
/// let after = respond(falls, floor, Ratio::HALF, Ratio::percent(25).unwrap())?;
/// assert_eq!(after, Vec2::new(fx!(1.5), fx!(-2))); // the normal part changed by 6, friction takes a quarter of that
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] if a component of `v` is outside of the [domain](crate::num::DOMAIN).
pub fn respond(v: Vec2, normal: Axis, restitution: Ratio, friction: Ratio) -> Result<Vec2, RangeError> {
    Surface::new(restitution, friction).respond(v, normal)
}

/// The masses of two bodies in lowest terms, or which of the two is fixed.
///
/// ```
/// use tilesat::{Ratio, motion::response::Masses};
/// let ball_and_crate = Masses::new(2, 6).unwrap();
/// assert_eq!(ball_and_crate.share_of_a(), Ratio::percent(75).unwrap()); // the lighter one takes more of a push
/// assert_eq!(Masses::B_FIXED.share_of_a(), Ratio::ONE);
/// assert_eq!(ball_and_crate.swapped(), Masses::new(3, 1).unwrap());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Masses {
    /// The change of A's velocity in one step of the exchange: the mass of B in lowest terms.
    pub(super) a: u8,
    /// The change of B's: the mass of A.
    pub(super) b: u8,
}

impl Masses {
    /// Two bodies of equal mass.
    pub const EQUAL: Self = Self { a: 1, b: 1 };
    /// Nothing moves A, because it is a wall, a platform or a sleeping body.
    pub const A_FIXED: Self = Self { a: 0, b: 1 };
    /// Nothing moves B.
    pub const B_FIXED: Self = Self { a: 1, b: 0 };

    /// The masses of A and B in any common unit. `None` if one is zero.
    ///
    /// Use small whole numbers: the two velocities change in multiples of them, which keeps
    /// momentum exact.
    #[must_use]
    pub const fn new(a: u8, b: u8) -> Option<Self> {
        if a == 0 || b == 0 {
            return None;
        }
        // Euclid's algorithm by subtraction: at most 254 rounds, and none at run time in a
        // constant.
        let (mut m, mut n) = (a, b);
        while m != n {
            if m > n {
                m -= n;
            } else {
                n -= m;
            }
        }
        Some(Self { a: quotient(b, m), b: quotient(a, m) })
    }

    /// These masses with A and B exchanged.
    #[must_use]
    pub const fn swapped(self) -> Self {
        Self { a: self.b, b: self.a }
    }

    /// The part of a push that A takes: the mass of B divided by the sum of both.
    #[must_use]
    pub const fn share_of_a(self) -> Ratio {
        match Ratio::new(self.a as u32, self.a as u32 + self.b as u32) {
            Some(share) => share,
            None => Ratio::HALF,
        }
    }

    /// How much A and B change in one step.
    pub(super) const fn steps(self) -> (i32, i32) {
        (self.a as i32, self.b as i32)
    }
}

/// A multiple divided by its divisor.
const fn quotient(of: u8, by: u8) -> u8 {
    crate::num::mul_div(of as u32, 1, by as u32) as u8
}

/// The displacements of A and B that end their overlap: A takes `share_of_a` of the push, B the
/// rest.
///
/// ```text
///     before          share 1/2          share 1           share 0
///   +------+        +------+         +------+              +------+
///   | A  +-|--+     | A    +----+    | A    +----+         | A    +----+
///   +----|-+  |     +------+  B |    +------+  B |         +------+  B |
///        +----+            +----+           +----+                +----+
///                   both by half     A alone               B alone
/// ```
///
/// Each component is rounded away from zero. The sum of both is the
/// [`push_out`](Contact::push_out), or a raw unit per component more: after both moves `overlaps`
/// is false. The result does not depend on which of the two is A. Mirrored input gives mirrored
/// bits ([degenerate](Contact::is_degenerate) contacts excepted). [`Masses::share_of_a`] is the
/// share that keeps the centre of mass where it is.
///
/// The moves may lead out of the domain or into a level: `translated` reports the first, and a
/// [`Mover`](crate::Mover) prevents the second.
///
/// Cost: that of `push_out`, plus four products.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Ratio, Vec2, motion::response::separate};
/// let a = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 10))?;
/// let b = Aabb::new(Vec2::from_ints(6, -9), Vec2::from_ints(20, 20))?;
/// let (by_a, by_b) = separate(&a.contact(&b).unwrap(), Ratio::percent(25).unwrap());
/// assert_eq!((by_a, by_b), (Vec2::from_ints(-1, 0), Vec2::from_ints(3, 0)));
/// assert!(!a.translated(by_a)?.overlaps(&b.translated(by_b)?));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
#[must_use]
pub const fn separate(contact: &Contact, share_of_a: Ratio) -> (Vec2, Vec2) {
    let push = Raw::of(contact.push_out());
    let (a, b) = (share_of_a, share_of_a.complement());
    let by_b = Raw { x: b.of_raw_up(push.x).wrapping_neg(), y: b.of_raw_up(push.y).wrapping_neg() };
    (Raw { x: a.of_raw_up(push.x), y: a.of_raw_up(push.y) }.vec2(), by_b.vec2())
}

/// The velocities of A and B after they have met with the `normal` from A to B ([`Contact::axis`]).
/// They are unchanged if the bodies do not approach.
///
/// The velocity of A relative to B changes as in [`Surface::respond`]. The masses share that change
/// in whole steps. One step changes A by the mass of B and B by the mass of A, in raw units and
/// lowest terms. So, exactly:
///
/// - **momentum** along x and along y stays the same (of bodies that are not fixed);
/// - **energy**, mass times speed squared, never grows (relative to the fixed body, if one is
///   fixed);
/// - they no longer approach.
///
/// The price is a rounding of the relative velocity. It is up to twice the sum of the masses, in
/// raw units and lowest terms (the sum is 2 for equal masses). A contact slower than that may have
/// no such answer and is then left unchanged. The result does not depend on which of the two is A,
/// and mirrored input gives mirrored bits.
///
/// Cost: about 1140 instructions on a Cortex-M0 along x and y, 4500 for other normals.
///
/// ```
/// use tilesat::{Axis, Ratio, Surface, Vec2, motion::response::{Masses, exchange}};
/// let (a, b) = (Vec2::from_ints(6, 1), Vec2::from_ints(-2, 0));
/// // Equal masses without loss exchange what they have along the normal.
/// assert_eq!(exchange(a, b, Axis::X, Masses::EQUAL, &Surface::ELASTIC)?, (Vec2::from_ints(-2, 1), Vec2::from_ints(6, 0)));
/// // A weighs three times as much, and both continue as one.
/// let clay = Masses::new(3, 1).unwrap();
/// assert_eq!(exchange(a, b, Axis::X, clay, &Surface::SLICK)?, (Vec2::from_ints(4, 1), Vec2::from_ints(4, 0)));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] if a component of a velocity is not below [2^28 raw](crate::num::MOTION).
pub fn exchange(a: Vec2, b: Vec2, normal: Axis, masses: Masses, surface: &Surface) -> Result<(Vec2, Vec2), RangeError> {
    check_motion(a, MOTION)?;
    check_motion(b, MOTION)?;
    let (a, b) = (Raw::of(a), Raw::of(b));
    let (step_a, step_b) = masses.steps();
    let step = step_a.wrapping_add(step_b);
    // B relative to A, which moves against the normal. A relative to B would need the reversed
    // normal, and `i32::MIN` has no opposite. Each is below 2^29.
    let before = b.sub(a);
    let restitution = if surface.stops(before, normal) { Ratio::ZERO } else { surface.restitution() };
    let ideal = reply(before, normal, &Rule { restitution, friction: surface.friction(), reference: before.len2() });
    let change = before.sub(ideal);
    if change.is_zero() {
        return Ok((a.vec2(), b.vec2()));
    }
    let rounded = Raw { x: steps(change.x, step), y: steps(change.y, step) };
    let after = before.sub(rounded.times(step));
    let change = settle(after, normal, before.len2(), step).map_or(Raw { x: 0, y: 0 }, |after| before.sub(after));
    let k = Raw { x: steps(change.x, step), y: steps(change.y, step) };
    Ok((a.add(k.times(step_a)).vec2(), b.sub(k.times(step_b)).vec2()))
}

impl Raw {
    const fn times(self, k: i32) -> Self {
        Self { x: self.x.wrapping_mul(k), y: self.y.wrapping_mul(k) }
    }
}

/// How many steps come nearest to `d`, halves toward zero, for |d| < 2^31 - 2^9.
const fn steps(d: i32, step: i32) -> i32 {
    if d == 0 {
        return 0;
    }
    let size = d.unsigned_abs().wrapping_mul(2).wrapping_add(step as u32).wrapping_sub(1);
    let k = mul_div(size, 1, step.wrapping_mul(2) as u32) as i32;
    if d < 0 { k.wrapping_neg() } else { k }
}
