//! The cells around a cell, ring by ring.

use super::{At, Run, Window};

/// The cells at distance `r` from a cell (the longer of the two ways along the axes), in up to four windows: the rows above and below, and the columns
/// at the sides between them. Each cell once; with `r` = 0 only the first window has one.
///
/// ```text
///  1 1 1
///  3 . 4
///  2 2 2
/// ```
pub(in crate::broad) fn ring(centre: At, r: i32) -> [Window; 4] {
    let (x, y) = (Run { lo: centre.x - r, hi: centre.x + r }, Run { lo: centre.y - r, hi: centre.y + r });
    let one = |v| Run { lo: v, hi: v };
    let between = Run { lo: y.lo + 1, hi: y.hi - 1 };
    let below = if r == 0 { between } else { one(y.hi) };
    [
        Window { x, y: one(y.lo) },
        Window { x, y: below },
        Window { x: one(x.lo), y: between },
        Window { x: one(x.hi), y: between },
    ]
}

/// The number of the last ring that has a cell of a window; the centre is in it.
pub(in crate::broad) fn last_ring(centre: At, window: &Window) -> i32 {
    let far = |run: Run, at: i32| (at - run.lo).max(run.hi - at);
    far(window.x, centre.x).max(far(window.y, centre.y))
}
