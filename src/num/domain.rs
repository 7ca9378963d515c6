//! The range of coordinates that shapes and levels accept. Inside that domain no query can wrap.

use super::{Fx, Vec2};
use crate::error::{Quantity, RangeError};

/// Every coordinate, radius and half extent has a raw absolute value below this, 2^29: 8192 units
/// in 16.16.
///
/// Differences then need 31 bits, products of differences 62, and every predicate fits a signed
/// 64-bit or one unsigned 128-bit comparison.
pub const DOMAIN: i32 = 1 << 29;

/// A motion's components and a moving body's extents stay below this raw value, 2^28: 4096 units in
/// 16.16.
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

/// Refuses values outside the open interval.
const fn check(v: Fx, above: i32, below: i32, what: Quantity) -> Result<(), RangeError> {
    let value = v.to_bits();
    if above < value && value < below { Ok(()) } else { Err(RangeError { what, value }) }
}
