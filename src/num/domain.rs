//! The domain of C1: inside it no kernel can wrap, and constructors let nothing else in.

use super::{Fx, Vec2};
use crate::error::{Quantity, RangeError};

/// Every coordinate, radius and half extent has a raw absolute value below this, 2^29: 8192 units in 16.16.
///
/// Differences then need 31 bits, products of differences 62, and every predicate fits a signed 64-bit or one
/// unsigned 128-bit comparison.
pub const DOMAIN: i32 = 1 << 29;

/// A motion call takes components, and bodies with extents, below this raw value, 2^28: 4096 units in 16.16.
pub const MOTION: i32 = 1 << 28;

pub(crate) const fn check_coordinate(v: Vec2) -> Result<(), RangeError> {
    match check(v.x, -DOMAIN, DOMAIN, Quantity::X) {
        Ok(()) => check(v.y, -DOMAIN, DOMAIN, Quantity::Y),
        bad => bad,
    }
}

pub(crate) const fn check_radius(r: Fx) -> Result<(), RangeError> {
    check(r, -1, DOMAIN, Quantity::Radius)
}

pub(crate) const fn check_length(length: Fx) -> Result<(), RangeError> {
    check(length, -1, DOMAIN, Quantity::Length)
}

pub(crate) const fn check_motion(v: Vec2, limit: i32) -> Result<(), RangeError> {
    match check(v.x, -limit, limit, Quantity::MotionX) {
        Ok(()) => check(v.y, -limit, limit, Quantity::MotionY),
        bad => bad,
    }
}

/// Refuses values outside of the open interval.
const fn check(v: Fx, above: i32, below: i32, what: Quantity) -> Result<(), RangeError> {
    let value = v.to_bits();
    if above < value && value < below { Ok(()) } else { Err(RangeError { what, value }) }
}

#[cfg(test)]
mod tests {
    use super::{DOMAIN, MOTION, check_length, check_motion};
    use crate::error::{Quantity, RangeError};
    use crate::num::{Fx, Vec2};

    #[test]
    fn refuses_from_the_limit_on() {
        let error = |what, value| Err(RangeError { what, value });
        for limit in [MOTION, DOMAIN] {
            for most in [limit - 1, 1 - limit] {
                let over = most + most.signum();
                assert_eq!(check_motion(Vec2::from_raw(most, most), limit), Ok(()));
                assert_eq!(check_motion(Vec2::from_raw(over, over), limit), error(Quantity::MotionX, over));
                assert_eq!(check_motion(Vec2::from_raw(most, over), limit), error(Quantity::MotionY, over));
            }
        }
        for length in [0, 1, DOMAIN - 1] {
            assert_eq!(check_length(Fx::from_bits(length)), Ok(()));
        }
        for length in [-1, i32::MIN, DOMAIN, i32::MAX] {
            assert_eq!(check_length(Fx::from_bits(length)), error(Quantity::Length, length));
        }
    }
}
