//! Bodies without area: the moments at which they start to reach the inside of the union of all
//! full cells.

use super::body::Body;
use super::level::Level;
use super::{P, Time};

/// The first moment after which the body is in the solid.
///
/// Its overlaps can change only where one of its sides crosses a line of the grid. Between two such
/// moments one sample decides.
pub fn first_solid(level: &Level, body: &Body, d: P) -> Option<Time> {
    let (lo, hi) = body.bounds();
    let mut moments = vec![Time::START, Time::END];
    for (v, d, origin) in [
        (lo.0, d.0, level.origin.0),
        (hi.0, d.0, level.origin.0),
        (lo.1, d.1, level.origin.1),
        (hi.1, d.1, level.origin.1),
    ] {
        let (from, to) = (v.min(v + d), v.max(v + d));
        let mut k = (from - origin).div_euclid(level.cell);
        while origin + k * level.cell <= to && d != 0 {
            let line = origin + k * level.cell;
            if line >= from {
                moments.push(Time::new(line - v, d));
            }
            k += 1;
        }
    }
    moments.sort();
    moments.dedup();
    moments.windows(2).find(|w| overlaps_between(level, body, d, w[0], w[1])).map(|w| w[0])
}

/// Whether the body overlaps the solid half way between two moments.
///
/// The level and the body are scaled so that the sample lies on the lattice.
fn overlaps_between(level: &Level, body: &Body, d: P, from: Time, to: Time) -> bool {
    // t = (n1 d2 + n2 d1) / (2 d1 d2)
    let (n1, d1, n2, d2) = (i128::from(from.num), i128::from(from.den), i128::from(to.num), i128::from(to.den));
    let (num, den) = (n1 * d2 + n2 * d1, 2 * d1 * d2);
    let (lo, hi) = body.bounds();
    let cell = i128::from(level.cell) * den;
    // The columns (rows) that an interval overlaps: groups that must be full together.
    let group = |lo: i64, hi: i64, d: i64, origin: i64| -> Vec<(i64, i64)> {
        let at = |v: i64| i128::from(v - origin) * den + i128::from(d) * num;
        let (first, last) = (at(lo).div_euclid(cell) as i64, (at(hi) - 1).div_euclid(cell) as i64);
        if lo == hi { vec![(last, first)] } else { (first..=last).map(|k| (k, k)).collect() }
    };
    let columns = group(lo.0, hi.0, d.0, level.origin.0);
    let rows = group(lo.1, hi.1, d.1, level.origin.1);
    columns.iter().any(|&(x0, x1)| rows.iter().any(|&(y0, y1)| (x0..=x1).all(|x| (y0..=y1).all(|y| level.full(x, y)))))
}
