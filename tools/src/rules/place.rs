//! The position of a point of the map in the level.

use crate::model::decimal::Decimal;

/// The library's domain in pixels: every coordinate stays below 2^29 raw (contract C1).
const DOMAIN: i64 = 8192;

/// The largest cell of the library, in pixels.
pub(super) const LARGEST: u32 = 256;

/// The length of a pixel of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Unit {
    numerator: u32,
    denominator: u32,
}

impl Unit {
    pub(super) fn new(scale: Option<(u32, u32)>) -> Self {
        let (numerator, denominator) = scale.unwrap_or((1, 1));
        Self { numerator, denominator }
    }

    /// In raw units, and the error in thousandths of one.
    pub(super) fn raw(self, value: Decimal) -> (i64, i64) {
        let scaled = value.scaled(self.numerator, self.denominator);
        (scaled.raw(), scaled.off_lattice())
    }

    pub(super) fn zoom(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }

    /// A whole number of raw units, scaled.
    pub(super) fn raw_of_raw(self, raw: i64) -> i64 {
        let (n, d) = (i128::from(self.numerator), i128::from(self.denominator));
        ((i128::from(raw) * n * 2 + d).div_euclid(2 * d)) as i64
    }

    /// The side of a scaled cell, a whole number of pixels.
    pub(super) fn side(self, tile: u16) -> Result<u16, String> {
        let (n, d) = (u32::from(tile) * self.numerator, self.denominator);
        if n % d == 0 && (1..=LARGEST).contains(&(n / d)) {
            return Ok((n / d) as u16);
        }
        if self.numerator == d {
            let by = (2..=n).find(|by| n % by == 0 && n / by <= LARGEST).unwrap_or(n);
            return Err(format!(
                "cells of {tile} pixels, and the library has cells of at most {LARGEST}; add --scale 1/{by}"
            ));
        }
        Err(format!(
            "--scale {}/{d} makes cells of {tile} pixels {} pixels; choose a scale that gives whole pixels from 1 to {LARGEST}",
            self.numerator,
            f64::from(n) / f64::from(d)
        ))
    }
}

/// How far to move a level from `lo` to `hi` pixels, in cells of `side`, along an axis, so that it
/// is in the domain. Zero if it is there already. Otherwise its middle moves to the origin.
pub(super) fn shift(lo: i64, hi: i64, side: u16) -> Result<i64, String> {
    if lo > -DOMAIN && hi < DOMAIN {
        return Ok(0);
    }
    let length = hi - lo;
    let side = i64::from(side.max(1));
    // By whole cells, and both ends inside.
    let half = (length / side / 2) * side;
    if half < DOMAIN && length - half < DOMAIN {
        return Ok(-half - lo);
    }
    let fits = |d: &i64| side % d == 0 && length / d < 2 * DOMAIN - 2 * side;
    let hint = (2..=side).find(fits).map_or_else(String::new, |d| format!("--scale 1/{d} makes it fit, or "));
    Err(format!(
        "{length} pixels are beyond the domain: a side must be shorter than {} pixels; {hint}cut it into rooms",
        2 * DOMAIN
    ))
}
