//! Checks the fast judge before the run: by big rationals and other means, on samples of every
//! class.

use crate::convex;
use crate::queries::{ROWS, samples};
use crate::quick::Pair;
use crate::state::name;
use tilesat_judge::convex::shape::{Shape, sum};
use tilesat_judge::num_rational::BigRational;
use tilesat_judge::oracle::figure::Figure;
use tilesat_judge::oracle::measure::Measure;
use tilesat_judge::oracle::rational;
use tilesat_judge::oracle::sum::Place;

/// Pairs per row.
const EACH: usize = 40;

/// A search finds the depth or the distance from an exact square and the radii. The judge must
/// agree.
pub fn judge(seed: u64) -> Result<(), String> {
    for row in 0..ROWS {
        for (a, b) in samples(row, seed, EACH) {
            let fast = Pair::new(&a, &b);
            let (overlap, touch) = (rational::overlaps(&a, &b), rational::touches(&a, &b));
            let length = length(&a, &b, overlap);
            let right =
                if overlap { fast.depth_is(length) && !fast.depth_is(length - 1) } else { fast.distance_is(length) };
            if (fast.overlaps(), fast.touches(), right) != (overlap, touch, true) {
                return Err(format!("the fast judge is wrong, {}: {a:?} {b:?}, {overlap} {touch} {length}", name(row)));
            }
        }
    }
    for row in 0..convex::ROWS {
        let all = convex::samples(row, seed, EACH);
        all.iter().try_for_each(|(a, b)| agree(a, b).map_err(|pair| format!("{}: {pair}", convex::name(row))))?;
    }
    Ok(())
}

/// The explicit sum and exact fractions, in 256 bits. The fast judge must give the same answers,
/// and accept the same one number.
pub fn agree(a: &Shape, b: &Shape) -> Result<(), String> {
    let (fast, slow) = (Pair::new(a, b), Measure::of(&sum(a, b)));
    let (overlap, touch) = (slow.overlaps(), slow.touches());
    let (root, radius) = (|n: i64| slow.square.root_minus(n), slow.radius);
    // radius + root <= n, radius - root <= n, root - radius < n + 1
    let enough = |n: i64| match (overlap, slow.place) {
        (true, Place::Inside) => n >= radius && root(n - radius) <= 0,
        (true, _) => root(radius - n) >= 0,
        _ => touch || root(n + 1 + radius) < 0,
    };
    let quick = |n: i64| if overlap { fast.depth_is(n) } else { fast.distance_is(n) };
    let (mut low, mut high) = (-1i64, 1i64 << 32);
    while high - low > 1 {
        let n = i64::midpoint(low, high);
        if enough(n) { high = n } else { low = n }
    }
    let right = quick(high) && !quick(high - 1) && !quick(high + 1);
    if (fast.overlaps(), fast.touches(), right) == (overlap, touch, true) {
        Ok(())
    } else {
        Err(format!("the fast judge is wrong: {a:?} {b:?}, {overlap} {touch} {high}"))
    }
}

/// The depth rounded up, or the distance rounded down.
fn length(a: &Figure, b: &Figure, overlap: bool) -> i64 {
    let whole = |n: i64| BigRational::from_integer(n.into());
    let radius = a.radius() + b.radius();
    let inside = rational::square_exit(a, b);
    let square = inside.clone().unwrap_or_else(|| rational::square_distance(a, b));
    // The sign of sqrt(square) - n.
    let above = |n: i64| n < 0 || square > whole(n) * whole(n);
    let (mut low, mut high) = (-1i64, 1i64 << 32);
    while high - low > 1 {
        let n = i64::midpoint(low, high);
        let enough = match (overlap, inside.is_some()) {
            // radius + root <= n, radius - root <= n, root - radius < n + 1
            (true, true) => !above(n - radius),
            (true, false) => n >= radius || above(radius - n) || square == whole(radius - n) * whole(radius - n),
            _ => !above(n + 1 + radius) && square != whole(n + 1 + radius) * whole(n + 1 + radius),
        };
        if enough { high = n } else { low = n }
    }
    high
}
