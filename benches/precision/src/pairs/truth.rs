//! The truth about a pair, and the faults of an answer.

use super::classes::Pair;
use crate::job::Format;
use crate::record::Row;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::measure::{Fraction, Measure};
use tilesat_judge::oracle::sum::Place;

/// An answer about a pair.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    pub hit: bool,
    /// In pixels, if the query gives it.
    pub depth: Option<f64>,
}

/// The exact answer.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    pub overlaps: bool,
    pub touches: bool,
    /// The depth of an overlap in raw units, as a whole number and a rest, so that no digit is
    /// lost.
    depth: (i64, f64),
}

impl Truth {
    pub fn new((a, b): &Pair) -> Self {
        Self::of(&Measure::new(a, b))
    }

    pub fn of(exact: &Measure) -> Self {
        let overlaps = exact.overlaps();
        let depth = if overlaps { depth(exact) } else { (0, 0.0) };
        Self { overlaps, touches: exact.touches(), depth }
    }

    /// The error of a depth, in pixels.
    fn error(&self, depth: f64) -> f64 {
        // Both steps are exact: a multiplication by a power of two, and a difference of neighbours.
        ((depth * 65536.0 - self.depth.0 as f64) - self.depth.1).abs() / 65536.0
    }

    fn depth_px(&self) -> f64 {
        (self.depth.0 as f64 + self.depth.1) / 65536.0
    }
}

fn depth(exact: &Measure) -> (i64, f64) {
    let (whole, rest) = root(exact.square);
    match exact.place {
        Place::Inside => (exact.radius + whole, rest),
        _ => (exact.radius - whole, -rest),
    }
}

/// The square root of a fraction: a whole number and a rest, good to 16 digits of the rest.
pub fn root(square: Fraction) -> (i64, f64) {
    let near = (float(square.num) / float(square.den)).sqrt();
    let whole = near as i64;
    // s - w = (s^2 - w^2) / (s + w), and s^2 - w^2 is exact.
    let over = float(square.num - Int256::product(whole, whole) * square.den) / float(square.den);
    (whole, if over == 0.0 { 0.0 } else { over / (near + whole as f64) })
}

fn float(n: Int256) -> f64 {
    let size = n.abs().limbs().iter().rev().fold(0.0, |sum, &limb| sum * 18_446_744_073_709_551_616.0 + limb as f64);
    if n.signum() < 0 { -size } else { size }
}

/// Compares answers with the truth.
pub fn judge(row: &mut Row, truths: &[Truth], answers: &[Answer], format: Format) {
    let (mut wrong, mut closed, mut hits) = (0u32, 0u32, 0u32);
    let (mut max, mut sum, mut n) = ((0.0f64, 0.0f64), (0.0, 0.0), 0u32);
    for (truth, answer) in truths.iter().zip(answers) {
        wrong += u32::from(answer.hit != truth.overlaps);
        closed += u32::from(answer.hit != truth.touches);
        hits += u32::from(truth.overlaps);
        let Some(depth) = answer.depth.filter(|_| answer.hit && truth.overlaps) else { continue };
        let off = truth.error(depth);
        let ulps = off / format.ulp(truth.depth_px());
        max = (max.0.max(off), max.1.max(ulps));
        sum = (sum.0 + off, sum.1 + ulps);
        n += 1;
    }
    row.set("queries", truths.len() as f64).set("hits", hits.into());
    row.set("wrong", wrong.into()).set("wrong_closed", closed.into());
    if n > 0 {
        let n = f64::from(n);
        row.set("max_px", max.0).set("mean_px", sum.0 / n).set("max_ulp", max.1).set("mean_ulp", sum.1 / n);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pairs::classes::CLASSES;
    use tilesat_judge::num_bigint::BigInt;
    use tilesat_judge::num_rational::BigRational;
    use tilesat_judge::oracle::figure::{Figure, PAIRS};
    use tilesat_judge::oracle::rational;

    /// In parts of 2^-80 of a raw unit, rounded down.
    fn scaled(v: f64) -> BigInt {
        let r = BigRational::from_float(v).expect("finite");
        (r * BigRational::from_integer(BigInt::from(1u128 << 80))).floor().to_integer()
    }

    #[test]
    fn truths_equal_big_rationals() {
        for kinds in PAIRS {
            for class in CLASSES {
                for pair in class.pairs(kinds, 300) {
                    let (truth, (a, b)) = (Truth::new(&pair), &pair);
                    assert_eq!(truth.overlaps, rational::overlaps(a, b), "{pair:?}");
                    assert_eq!(truth.touches, rational::touches(a, b), "{pair:?}");
                    if truth.overlaps {
                        depth_is(&truth, a, b);
                    }
                }
            }
        }
    }

    /// To 2^-45 of a raw unit.
    fn depth_is(truth: &Truth, a: &Figure, b: &Figure) {
        let radius = BigInt::from(a.radius() + b.radius()) << 80;
        let root = |square: BigRational| {
            (square * BigRational::from_integer(BigInt::from(1) << 160)).floor().to_integer().sqrt()
        };
        let exact: BigInt = match rational::square_exit(a, b) {
            Some(exit) => radius + root(exit),
            None => radius - root(rational::square_distance(a, b)),
        };
        let told: BigInt = (BigInt::from(truth.depth.0) << 80) + scaled(truth.depth.1);
        let off = BigInt::from((exact - told).magnitude().clone());
        assert!(off < BigInt::from(1u64 << 35), "{truth:?} {a:?} {b:?}: off by {off}");
    }

    #[test]
    fn an_answer_is_judged_by_both_conventions() {
        let truth = |overlaps, touches| Truth { overlaps, touches, depth: (65_536, 0.5) };
        let hit = |depth| Answer { hit: true, depth };
        let mut row = Row::default();
        let truths = [truth(true, true), truth(false, true), truth(false, false)];
        judge(&mut row, &truths, &[hit(Some(1.0)), hit(None), hit(None)], Format::RAW);
        assert_eq!((row.get("wrong"), row.get("wrong_closed"), row.get("hits")), (Some(2.0), Some(1.0), Some(1.0)));
        assert_eq!((row.get("max_px"), row.get("max_ulp")), (Some(0.5 / 65536.0), Some(0.5)));
    }
}
