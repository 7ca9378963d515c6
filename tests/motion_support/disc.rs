//! Circles: whether a motion enters the open disc sum of a square, up to a given moment.

use super::body::Body;
use super::level::Level;
use super::rect;
use super::{P, Time, dot, len2};

/// Whether the open disc meets the open square.
pub(crate) fn overlaps(c: P, r: i64, a: P, b: P) -> bool {
    let gap = (c.0 - c.0.clamp(a.0, b.0), c.1 - c.1.clamp(a.1, b.1));
    len2(gap) < i128::from(r) * i128::from(r)
}

/// Whether a disc of positive radius that does not overlap the square does so at a moment up to `until`.
///
/// The sum of square and disc is two boxes and four discs around the corners.
pub(crate) fn enters(c: P, r: i64, d: P, a: P, b: P, until: Time) -> bool {
    let wide = rect::enters(c, c, d, (a.0 - r, a.1), (b.0 + r, b.1));
    let high = rect::enters(c, c, d, (a.0, a.1 - r), (b.0, b.1 + r));
    let boxes = [wide, high].iter().flatten().any(|(t, _)| *t < until);
    boxes || [a, b, (a.0, b.1), (b.0, a.1)].iter().any(|&p| enters_disc((c.0 - p.0, c.1 - p.1), r, d, until))
}

/// Whether `|m + d t| < r` at a moment `0 <= t <= until`; not so at 0.
fn enters_disc(m: P, r: i64, d: P, until: Time) -> bool {
    let toward = -dot(m, d);
    if toward <= 0 {
        return false;
    }
    let (a, rr) = (len2(d), i128::from(r) * i128::from(r));
    // The nearest moment is toward / a. Motions are below 2^29 and distances below 2^30.5 on each axis: products below 2^123.
    if toward * i128::from(until.den) >= a * i128::from(until.num) {
        let at = |m: i64, d: i64| {
            let scaled = i128::from(m) * i128::from(until.den) + i128::from(d) * i128::from(until.num);
            scaled * scaled
        };
        let scale = i128::from(until.den) * i128::from(until.den);
        return at(m.0, d.0) + at(m.1, d.1) < rr * scale;
    }
    let cross = i128::from(m.0) * i128::from(d.1) - i128::from(m.1) * i128::from(d.0);
    cross * cross < rr * a
}

/// Whether a circle enters the solid up to `until`.
pub(crate) fn enters_solid(level: &Level, body: &Body, d: P, until: Time) -> bool {
    let Body::Disc { c, r } = *body else { panic!("a circle is needed") };
    level.cells_along(body, d).any(|(x, y)| {
        let (a, b) = level.square(x, y);
        level.full(x, y) && enters(c, r, d, a, b, until)
    })
}
