//! The exact hit of a ray: where it first touches the solid, and where it first enters its inside.
//!
//! Between two crossings of lines, a ray is in one cell or on the line between two. At a crossing
//! it touches up to four. Crossings are fractions below 2^30, so products of two fit 64 bits. No
//! cell is skipped, and nothing walks.

use super::classes::Ray;
use super::level::{CELL, Level};
use crate::job::Format;
use crate::record::Row;
use std::cmp::Ordering;

/// A fraction of a motion.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    pub num: i64,
    pub den: i64,
}

impl Time {
    fn cmp(&self, other: &Self) -> Ordering {
        (i128::from(self.num) * i128::from(other.den)).cmp(&(i128::from(other.num) * i128::from(self.den)))
    }

    pub fn value(self) -> f64 {
        self.num as f64 / self.den as f64
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// Touching counts.
    pub closed: Option<Time>,
    /// Only the inside counts, which includes the line between two solid cells.
    pub open: Option<Time>,
    /// The ray's length in pixels.
    length: f64,
}

/// The cells whose closed sides hold a coordinate at `t`, or next to `t` on the way.
fn cells_at(o: i64, d: i64, t: Time) -> (i64, i64) {
    // The coordinate is at / den.
    let (at, den) = (i128::from(o) * i128::from(t.den) + i128::from(d) * i128::from(t.num), i128::from(t.den));
    let side = den * i128::from(CELL);
    let high = at.div_euclid(side) as i64;
    if at.rem_euclid(side) == 0 { (high - 1, high) } else { (high, high) }
}

/// The times at which it crosses each line, with the start and the end.
fn crossings(ray: &Ray) -> Vec<Time> {
    let mut times = vec![Time { num: 0, den: 1 }, Time { num: 1, den: 1 }];
    for (o, d) in [(ray.o.0, ray.d.0), (ray.o.1, ray.d.1)] {
        let (lo, hi) = (o.min(o + d), o.max(o + d));
        for line in lo.div_euclid(CELL)..=hi.div_euclid(CELL) {
            let way = line * CELL - o;
            if d != 0 && way.signum() == d.signum() && way.abs() < d.abs() {
                times.push(Time { num: way.abs(), den: d.abs() });
            }
        }
    }
    times.sort_by(Time::cmp);
    times.dedup_by(|a, b| a.cmp(b) == Ordering::Equal);
    times
}

impl Truth {
    pub fn new(level: &Level, ray: &Ray) -> Self {
        let times = crossings(ray);
        let (mut closed, mut open) = (None, None);
        for (i, &t) in times.iter().enumerate() {
            let (x, y) = (cells_at(ray.o.0, ray.d.0, t), cells_at(ray.o.1, ray.d.1, t));
            let touched = [(x.0, y.0), (x.1, y.0), (x.0, y.1), (x.1, y.1)];
            if closed.is_none() && touched.iter().any(|&(x, y)| level.solid(x, y)) {
                closed = Some(t);
            }
            let Some(next) = times.get(i + 1) else { break };
            // Half-way to the next crossing, where it is in one cell, or on the line of two.
            let middle = Time { num: t.num * next.den + next.num * t.den, den: 2 * t.den * next.den };
            let (x, y) = (cells_at(ray.o.0, ray.d.0, middle), cells_at(ray.o.1, ray.d.1, middle));
            let along = [(x.0, y.0), (x.1, y.0), (x.0, y.1), (x.1, y.1)];
            if closed.is_none() && along.iter().any(|&(x, y)| level.solid(x, y)) {
                closed = Some(t);
            }
            if open.is_none() && along.iter().all(|&(x, y)| level.solid(x, y)) {
                open = Some(t);
            }
            if open.is_some() {
                break;
            }
        }
        let length = (ray.d.0 as f64).hypot(ray.d.1 as f64) / 65536.0;
        Self { closed, open, length }
    }
}

/// An answer: the fraction of the motion.
pub type Answer = Option<f64>;

/// An answer this far from the true position still means the same cell.
const NEAR: f64 = 1.0 / 64.0;

/// Compares answers with the truth. An answer is right if it fits one of the conventions. In
/// libraries that walk cells, one side of a cell is closed, and they do not say which.
pub fn judge(row: &mut Row, truths: &[Truth], answers: &[Answer], format: Format) {
    let (mut wrong, mut closed, mut hits, mut late) = (0u32, 0u32, 0u32, 0u32);
    let (mut max, mut sum, mut n) = ((0.0f64, 0.0f64), (0.0, 0.0), 0u32);
    for (truth, answer) in truths.iter().zip(answers) {
        let off = |t: Option<Time>| match (t, answer) {
            (None, None) => Some(0.0),
            (Some(t), Some(a)) => Some((a - t.value()) * truth.length),
            _ => None,
        };
        let fits = |t: Option<Time>| off(t).filter(|px| px.abs() < NEAR);
        closed += u32::from(fits(truth.closed).is_none());
        let best =
            [fits(truth.closed), fits(truth.open)].into_iter().flatten().min_by(|a, b| a.abs().total_cmp(&b.abs()));
        let Some(px) = best else {
            wrong += 1;
            continue;
        };
        let Some(a) = answer else { continue };
        hits += 1;
        late += u32::from(px > 1e-11);
        let ulps = px.abs() / truth.length / format.ulp(*a);
        max = (max.0.max(px.abs()), max.1.max(ulps));
        sum = (sum.0 + px.abs(), sum.1 + ulps);
        n += 1;
    }
    // An answer is wrong if it fits neither. Answers that only the closed convention allows are
    // listed beside it, and are never fewer.
    row.set("queries", truths.len() as f64).set("hits", hits.into()).set("late", late.into());
    row.set("wrong", wrong.into()).set("wrong_closed", closed.into());
    if n > 0 {
        let n = f64::from(n);
        row.set("max_px", max.0).set("mean_px", sum.0 / n).set("max_ulp", max.1).set("mean_ulp", sum.1 / n);
    }
}
