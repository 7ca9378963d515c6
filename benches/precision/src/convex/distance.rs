//! The truth about a distance. An answer is wrong if it is off by a raw unit or more.

use crate::job::Format;
use crate::pairs::truth::root;
use crate::record::Row;
use tilesat_judge::oracle::measure::Measure;

/// The gap between two shapes in raw units, as a whole number and a rest.
#[derive(Clone, Copy, Debug)]
pub struct Gap(i64, f64);

impl Gap {
    pub fn of(exact: &Measure) -> Self {
        if exact.touches() {
            return Self(0, 0.0);
        }
        let (whole, rest) = root(exact.square);
        Self(whole - exact.radius, rest)
    }
}

/// Compares distances in pixels with the truth.
pub fn judge(row: &mut Row, truths: &[Gap], answers: &[f64], format: Format) {
    let (mut wrong, mut max, mut sum) = (0u32, (0.0f64, 0.0f64), (0.0, 0.0));
    for (gap, told) in truths.iter().zip(answers) {
        let raw = ((told * 65536.0 - gap.0 as f64) - gap.1).abs();
        // Also if it is no number.
        wrong += u32::from(raw.is_nan() || raw >= 1.0);
        let (px, ulps) = (raw / 65536.0, raw / 65536.0 / format.ulp((gap.0 as f64 + gap.1) / 65536.0));
        max = (max.0.max(px), max.1.max(ulps));
        sum = (sum.0 + px, sum.1 + ulps);
    }
    let n = truths.len() as f64;
    row.set("queries", n).set("wrong", wrong.into());
    row.set("max_px", max.0).set("mean_px", sum.0 / n).set("max_ulp", max.1).set("mean_ulp", sum.1 / n);
}

#[cfg(test)]
mod tests {
    use super::*;
    use tilesat_judge::convex::shape::{Shape, sum};

    #[test]
    fn a_distance_that_is_a_raw_unit_off_is_wrong() {
        let circle = |x: i64| Shape::Circle { centre: (x, 4 * x / 3), radius: 65_536 };
        // The centres are 5 px apart.
        let gap = Gap::of(&Measure::of(&sum(&circle(0), &circle(3 * 65_536))));
        let wrong = |told: f64| {
            let mut row = Row::default();
            judge(&mut row, &[gap], &[told], Format::RAW);
            row.get("wrong")
        };
        assert_eq!([3.0, 3.0 + 0.99 / 65536.0, 3.0 - 1.0 / 65536.0, 4.0].map(wrong), [0.0, 0.0, 1.0, 1.0].map(Some));
        let near = Gap::of(&Measure::of(&sum(&circle(0), &circle(3))));
        assert_eq!((near.0, near.1), (0, 0.0));
    }
}
