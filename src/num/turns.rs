//! Directions from angles, and vectors that turn by a direction.

use super::{Axis, Fx, UnitVec2, Vec2, imul, umul, usqr};

impl Axis {
    /// The direction at an angle in turns, from +x toward +y: a quarter is +y.
    ///
    /// The direction is about 2^30 long. The angle is counter-clockwise with y up, and clockwise on
    /// a screen.
    ///
    /// Quarter turns are exact. Mirrored and turned angles give mirrored and turned directions bit
    /// for bit. Other angles are within 2^-23 of the exact direction. Whole turns change nothing:
    /// an [`Fx`] has 65 536 steps per turn. Cost: 14 products, some 400 instructions on a
    /// Cortex-M0; none in a constant.
    ///
    /// ```
    /// use tilesat::{Axis, fx};
    /// assert_eq!(Axis::from_turns(fx!(0.25)), Axis::new(0, 1 << 30));
    /// assert_eq!(Axis::from_turns(fx!(-1.5)), Axis::new(-1 << 30, 0));
    /// let eighth = Axis::from_turns(fx!(0.125));
    /// assert_eq!(eighth.x, eighth.y);
    /// ```
    #[must_use]
    pub const fn from_turns(turns: Fx) -> Self {
        at_phase((turns.to_bits() as u32) << 16)
    }

    /// The direction at an angle in radians, from +x toward +y.
    ///
    /// It is about 2^30 long. It is `None` if the angle is not a number, or is not below 2^20 in
    /// size: an `f32` cannot distinguish directions there. An angle that rounds a quarter turn is
    /// that quarter: `FRAC_PI_2` is exactly +y. Other angles are within 2^-23 of the exact
    /// direction, so a body that turns by less than a [step](Self::from_turns) of turns still
    /// turns. Mirrored angles give mirrored directions bit for bit. It reads the bits of the `f32`:
    /// no chip needs a floating-point unit, and all chips agree. Cost: as
    /// [`from_turns`](Self::from_turns), and two products.
    ///
    /// ```
    /// use core::f32::consts::{FRAC_PI_2, PI};
    /// use tilesat::Axis;
    /// assert_eq!(Axis::from_radians(FRAC_PI_2), Some(Axis::new(0, 1 << 30)));
    /// assert_eq!(Axis::from_radians(-3.0 * PI), Some(Axis::new(-1 << 30, 0)));
    /// assert_eq!(Axis::from_radians(f32::INFINITY), None);
    /// ```
    #[must_use]
    #[doc(alias("from_angle", "sin_cos"))]
    pub const fn from_radians(angle: f32) -> Option<Self> {
        let bits = angle.to_bits();
        let exponent = (bits >> 23) & 0xff;
        if exponent >= 127 + 20 {
            return None;
        }
        // The size of the angle is significand * 2^(exponent - 150). Subnormal numbers are far
        // below half a step of the phase.
        let significand = bits & 0x7f_ffff | 1 << 23;
        let parts = umul(significand, PARTS[0]) + (umul(significand, PARTS[1]) >> 32);
        // At least 6. Beyond 63, the phase rounds to zero.
        let shift = 152 - exponent;
        if shift > 63 {
            return Some(at_phase(0));
        }
        let phase = (parts + (1 << (shift - 1))) >> shift;
        // The nearest quarter, and how far the angle is from it. The angle stands for a quarter
        // within half a unit of its significand.
        let quarter = (phase + (1 << 29)) >> 30;
        let is_quarter = shift <= 33 && (quarter << (30 + shift)).abs_diff(parts) <= PARTS[0] as u64 / 2 + 1;
        let phase = if is_quarter { (quarter << 30) as u32 } else { phase as u32 };
        Some(at_phase(if bits >> 31 == 0 { phase } else { phase.wrapping_neg() }))
    }
}

impl UnitVec2 {
    /// `v` turned by the angle from +x to this direction, each component rounded to nearest, halves
    /// away from zero.
    ///
    /// It saturates. Turned and mirrored vectors give turned and mirrored bits. Turn the corners of
    /// a shape from where you defined them, not from the last frame: roundings would add up. Cost:
    /// four products.
    ///
    /// ```
    /// use tilesat::{Axis, ConvexPolygon, Vec2, fx};
    /// const SHIP: [Vec2; 3] = [Vec2::from_ints(10, 0), Vec2::from_ints(-6, 5), Vec2::from_ints(-6, -5)];
    /// let heading = Axis::from_turns(fx!(0.25)).unit();
    /// let ship = ConvexPolygon::<3>::new(&SHIP.map(|corner| Vec2::from_ints(50, 20) + heading.rotate(corner)))?;
    /// assert!(ship.vertices().contains(&Vec2::from_ints(50, 30)));
    /// # Ok::<(), tilesat::error::PolygonError>(())
    /// ```
    #[must_use]
    #[doc(alias("turn", "transform"))]
    pub const fn rotate(self, v: Vec2) -> Vec2 {
        let ((c, s), (x, y)) = (self.raw(), v.raw());
        Vec2::from_raw(near(imul(c, x), imul(s, y).wrapping_neg()), near(imul(s, x), imul(c, y)))
    }
}

/// `(a + b) / 2^30`, rounded to nearest, halves away from zero; it saturates. Both parts are
/// products with a component of a unit vector, so at most 2^61 in size.
const fn near(a: i64, b: i64) -> i32 {
    let sum = a.wrapping_add(b);
    let size = (sum.unsigned_abs() + (1 << 29)) >> 30;
    let limit = i32::MAX as u64;
    let size = if size > limit { i32::MAX } else { size as i32 };
    if sum < 0 { size.wrapping_neg() } else { size }
}

/// `2^34 / (2 pi)`, parts of a turn per radian, and 32 bits of its fraction. Its product with a
/// significand is off by one part at most.
const PARTS: [u32; 2] = [2_734_261_102, 1_313_084_713];

/// The direction at an angle in parts of 2^32 of a turn.
const fn at_phase(phase: u32) -> Axis {
    let part = phase & 0x3fff_ffff;
    let (cos, sin) = (quarter_sine((1 << 30) - part), quarter_sine(part));
    match phase >> 30 {
        0 => Axis::new(cos, sin),
        1 => Axis::new(-sin, cos),
        2 => Axis::new(-cos, -sin),
        _ => Axis::new(sin, -cos),
    }
}

/// `(pi/2)^k / k!` in parts of 2^30, for k = 1, 3, ... 11: signs alternate, and each partial sum
/// stays positive.
const SERIES: [u32; 6] = [1_686_629_713, 693_598_668, 85_569_306, 5_026_995, 172_272, 3_864];

/// `sin(pi/2 x)`, both in parts of 2^30, for x up to 1: the sine's series to x^11, whose rest is
/// below 6e-8.
const fn quarter_sine(x: u32) -> i32 {
    if x == 1 << 30 {
        return 1 << 30;
    }
    let square = (usqr(x) >> 30) as u32;
    let [a1, a3, a5, a7, a9, a11] = SERIES;
    let sum = less(a1, less(a3, less(a5, less(a7, less(a9, a11, square), square), square), square), square);
    (umul(sum, x) >> 30) as i32
}

/// `a - b y`, for y in parts of 2^30.
const fn less(a: u32, b: u32, y: u32) -> u32 {
    a.wrapping_sub((umul(b, y) >> 30) as u32)
}
