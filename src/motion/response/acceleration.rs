//! Gravity and other steady changes of velocity, even slower ones than a raw unit per frame.

use crate::num::{DOMAIN, Raw, Vec2, check_motion, mul_div};

/// A change of velocity by `by` in every `frames` frames, exact: after k frames the velocity has
/// changed by `k by / frames`, rounded toward zero.
///
/// A [`Carry`], one per body, keeps the rest below a raw unit until it adds up to a unit. The carry
/// belongs to the velocity; it never changes a position directly.
///
/// ```
/// use tilesat::{Vec2, motion::{Acceleration, Carry}};
/// // A third of a raw unit per frame, downward: slow motion, or dust.
/// const GRAVITY: Acceleration = Acceleration::new(Vec2::from_raw(0, 100), 300).unwrap();
/// let (mut v, mut carry) = (Vec2::ZERO, Carry::ZERO);
/// for _ in 0..30_000 {
///     (v, carry) = GRAVITY.act(v, carry);
/// }
/// assert_eq!(v, Vec2::from_raw(0, 10_000));
/// ```
///
/// # At rest
///
/// In most frames a weak gravity gives no velocity to a body on a floor. A mover reports only the
/// surfaces that a body runs into, so its `floor` would flicker. Fill the carry of a body that is
/// supported. It then presses on the floor by at least a raw unit in every frame:
///
/// ```
/// # use tilesat::prelude::*;
/// # use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2, motion::{Acceleration, Carry}};
/// # const GRAVITY: Acceleration = Acceleration::new(Vec2::from_raw(0, 100), 300).unwrap();
/// # static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// # let map = TileMap::from_ascii("    \n####\n", &KINDS)?;
/// # let (mut body, mut v, mut carry) = (Aabb::new(Vec2::from_ints(8, 6), Vec2::from_ints(18, 16))?, Vec2::ZERO, Carry::ZERO);
/// # for frame in 0..10 {
/// (v, carry) = GRAVITY.act(v, carry);
/// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, v)?;
/// (body, v) = (moved.body, moved.velocity);
/// if moved.floor {
///     carry = GRAVITY.supported(v, carry);
/// }
/// # assert!(moved.floor || frame < 2);
/// # }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Acceleration {
    /// The change per frame, in raw units.
    pub(super) whole: (i32, i32),
    /// The rest per frame, in parts of `frames`, with the sign of `whole` and smaller than one
    /// unit.
    pub(super) part: (i32, i32),
    pub(super) frames: i32,
}

/// The part of a velocity below a raw unit, as a count per axis. Only its [`Acceleration`] can
/// interpret it.
///
/// Plain data. Keep it beside the velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Carry {
    pub(super) x: i32,
    pub(super) y: i32,
}

impl Carry {
    /// No rest.
    pub const ZERO: Self = Self { x: 0, y: 0 };
}

impl Acceleration {
    /// A change by `by` in every `frames` frames. `None` if `frames` is zero or more than 2^30, or
    /// a component of `by` is outside of the [domain](crate::num::DOMAIN).
    #[must_use]
    pub const fn new(by: Vec2, frames: u32) -> Option<Self> {
        if frames == 0 || frames > 1 << 30 || check_motion(by, DOMAIN).is_err() {
            return None;
        }
        let Raw { x, y } = Raw::of(by);
        let (x, y) = (parts(x, frames), parts(y, frames));
        Some(Self { whole: (x.0, y.0), part: (x.1, y.1), frames: frames as i32 })
    }

    /// The velocity after one more frame, and the rest below a raw unit. Saturates at the ends of
    /// 16.16.
    ///
    /// Mirrored input gives mirrored bits. Cost: additions and compares, 43 instructions on a
    /// Cortex-M0.
    #[must_use]
    pub const fn act(&self, velocity: Vec2, carry: Carry) -> (Vec2, Carry) {
        let (x, left_x) = self.one(self.whole.0, self.part.0, carry.x);
        let (y, left_y) = self.one(self.whole.1, self.part.1, carry.y);
        (velocity.saturating_add(Vec2::from_raw(x, y)), Carry { x: left_x, y: left_y })
    }

    /// The carry of a body that a surface holds. It is full on the axes on which the velocity is
    /// zero, so the next frame gives a whole unit there. The other axes are unchanged.
    ///
    /// This changes the velocity by less than a raw unit when the body leaves the surface.
    #[must_use]
    pub const fn supported(&self, velocity: Vec2, carry: Carry) -> Carry {
        let v = Raw::of(velocity);
        Carry {
            x: if v.x == 0 { self.full(self.part.0) } else { carry.x },
            y: if v.y == 0 { self.full(self.part.1) } else { carry.y },
        }
    }

    /// The raw units of one frame, and the remaining parts. Both summands are below 2^30 in size.
    const fn one(&self, whole: i32, part: i32, carry: i32) -> (i32, i32) {
        let sum = part.wrapping_add(carry);
        if sum >= self.frames {
            (whole.wrapping_add(1), sum.wrapping_sub(self.frames))
        } else if sum <= -self.frames {
            (whole.wrapping_sub(1), sum.wrapping_add(self.frames))
        } else {
            (whole, sum)
        }
    }

    /// Just enough parts for the next frame to make a unit.
    const fn full(&self, part: i32) -> i32 {
        part.signum().wrapping_mul(self.frames).wrapping_sub(part)
    }
}

/// `by / frames` rounded toward zero, and the rest.
const fn parts(by: i32, frames: u32) -> (i32, i32) {
    let size = mul_div(by.unsigned_abs(), 1, frames) as i32;
    let whole = if by < 0 { size.wrapping_neg() } else { size };
    (whole, by.wrapping_sub(whole.wrapping_mul(frames as i32)))
}
