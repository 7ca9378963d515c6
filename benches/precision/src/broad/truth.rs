//! The true pairs of boxes: all against all, in integers.

use super::scenes::{Bounds, Frame};
use crate::record::Row;
use std::collections::HashSet;

/// The report of a broad phase for a frame, in any order.
pub type Answer = Vec<(u32, u32)>;

/// Pairs that share an area, and pairs that share a point.
#[derive(Debug)]
pub struct Truth {
    overlapping: HashSet<(u32, u32)>,
    touching: HashSet<(u32, u32)>,
}

fn meet(a: &Bounds, b: &Bounds, apart: impl Fn(i64, i64) -> bool) -> bool {
    !(apart(a.lo.0, b.hi.0) || apart(b.lo.0, a.hi.0) || apart(a.lo.1, b.hi.1) || apart(b.lo.1, a.hi.1))
}

/// Whether they have a point in common.
pub fn touch(a: &Bounds, b: &Bounds) -> bool {
    meet(a, b, |lo, hi| lo > hi)
}

impl Truth {
    fn among<'a>(all: impl Iterator<Item = [(&'a Bounds, u32); 2]>) -> Self {
        let (mut overlapping, mut touching) = (HashSet::new(), HashSet::new());
        for [(a, i), (b, j)] in all.filter(|[(a, _), (b, _)]| touch(a, b)) {
            touching.insert((i, j));
            if meet(a, b, |lo, hi| lo >= hi) {
                overlapping.insert((i, j));
            }
        }
        Self { overlapping, touching }
    }

    /// All pairs of the boxes of a frame.
    pub fn pairs(frame: &Frame) -> Self {
        let after = |i: u32| frame.iter().zip(0..).skip(i as usize + 1);
        Self::among(frame.iter().zip(0..).flat_map(|a| after(a.1).map(move |b| [a, b])))
    }

    /// Pairs of a region and a box. The numbers of boxes begin with `held`.
    pub fn regions(regions: &Frame, boxes: &Frame, held: u32) -> Self {
        Self::among(regions.iter().zip(0..).flat_map(|region| boxes.iter().zip(held..).map(move |b| [region, b])))
    }
}

/// A pair that overlaps and is not reported is missing. A pair that does not even touch, or is
/// reported twice, is extra. A pair that only touches may be reported or not.
pub fn judge(row: &mut Row, truths: &[Truth], answers: &[Answer]) {
    let (mut pairs, mut missing, mut extra) = (0, 0, 0);
    for (truth, answer) in truths.iter().zip(answers) {
        let mut told = HashSet::new();
        for &(a, b) in answer {
            let pair = (a.min(b), a.max(b));
            extra += usize::from(!told.insert(pair) || !truth.touching.contains(&pair));
        }
        pairs += truth.overlapping.len();
        missing += truth.overlapping.difference(&told).count();
    }
    row.set("queries", pairs as f64).set("wrong", missing as f64).set("extra", extra as f64);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: i64, y: i64) -> Bounds {
        Bounds { lo: (x, y), hi: (x + 10, y + 10) }
    }

    fn judged(frame: &Frame, answer: &[(u32, u32)]) -> (f64, f64, f64) {
        let mut row = Row::new("w", "c", "b", "q");
        judge(&mut row, &[Truth::pairs(frame)], &[answer.to_vec()]);
        let cell = |name| row.get(name).unwrap();
        (cell("queries"), cell("wrong"), cell("extra"))
    }

    #[test]
    fn missing_and_extra_pairs_are_counted_and_touching_ones_are_free() {
        // 0 and 1 overlap by a raw unit, 1 and 2 touch, 2 and 3 are a raw unit apart.
        let frame = vec![at(0, 0), at(9, 0), at(19, 0), at(30, 0)];
        assert_eq!(judged(&frame, &[(1, 0)]), (1.0, 0.0, 0.0));
        assert_eq!(judged(&frame, &[(0, 1), (1, 2)]), (1.0, 0.0, 0.0));
        assert_eq!(judged(&frame, &[(1, 2)]), (1.0, 1.0, 0.0));
        assert_eq!(judged(&frame, &[(0, 1), (2, 3)]), (1.0, 0.0, 1.0));
        assert_eq!(judged(&frame, &[(0, 1), (1, 0)]), (1.0, 0.0, 1.0));
        // At a corner.
        assert_eq!(judged(&vec![at(0, 0), at(10, 10)], &[]), (0.0, 0.0, 0.0));
        assert_eq!(judged(&vec![at(0, 0), at(9, 9)], &[]), (1.0, 1.0, 0.0));
    }
}
