//! Circles and capsules: does a motion enter the open disc sum of a square, up to a given moment?
//!
//! A capsule meets a square if the disc around one end of its core meets the square stretched by
//! the core toward the other side.

use super::body::Body;
use super::level::Level;
use super::rect;
use super::{P, Time, dot, len2};

/// The obstacle of the first end of a core: a square, stretched backward by the core.
pub fn drawn_out((a, b): (P, P), core: P) -> (P, P) {
    ((a.0 - core.0, a.1 - core.1), b)
}

/// Whether the open disc meets the open square.
pub fn overlaps(c: P, r: i64, a: P, b: P) -> bool {
    let gap = (c.0 - c.0.clamp(a.0, b.0), c.1 - c.1.clamp(a.1, b.1));
    len2(gap) < i128::from(r) * i128::from(r)
}

/// Whether a disc of positive radius that does not overlap the square does so at a moment up to
/// `until`.
///
/// The sum of square and disc is two boxes and four discs around the corners.
pub fn enters(c: P, r: i64, d: P, a: P, b: P, until: Time) -> bool {
    if !passes(c, r, d, a, b) {
        return false;
    }
    let wide = rect::enters(c, c, d, (a.0 - r, a.1), (b.0 + r, b.1));
    let high = rect::enters(c, c, d, (a.0, a.1 - r), (b.0, b.1 + r));
    let boxes = [wide, high].iter().flatten().any(|(t, _)| *t < until);
    boxes || [a, b, (a.0, b.1), (b.0, a.1)].iter().any(|&p| enters_disc((c.0 - p.0, c.1 - p.1), r, d, until))
}

/// Whether the line of the motion crosses the open box that holds the sum of square and disc. Far
/// motions come by many cells: most of them are off the line.
fn passes(c: P, r: i64, d: P, a: P, b: P) -> bool {
    let (m, half) = ((2 * c.0 - a.0 - b.0, 2 * c.1 - a.1 - b.1), (b.0 - a.0 + 2 * r, b.1 - a.1 + 2 * r));
    let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
    (product(m.0, d.1) - product(m.1, d.0)).abs() < product(half.0, d.1.abs()) + product(half.1, d.0.abs())
}

/// Whether `|m + d t| < r` at a moment `0 <= t <= until`. It does not hold at 0.
fn enters_disc(m: P, r: i64, d: P, until: Time) -> bool {
    let toward = -dot(m, d);
    if toward <= 0 {
        return false;
    }
    let (a, rr) = (len2(d), i128::from(r) * i128::from(r));
    // The nearest moment is toward / a. Motions are below 2^29 and distances below 2^30.5 on each
    // axis: products below 2^123.
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

/// The first moment at which the foremost point of a circle on some axis meets a face, its ends
/// included, and moves in.
pub fn first_face(level: &Level, body: &Body, d: P) -> Option<Time> {
    let Body::Disc { c, core, r } = *body else { panic!("a circle is needed") };
    let mut first: Option<Time> = None;
    for (x, y) in level.cells_along(body, d).filter(|&(x, y)| level.full(x, y)) {
        let (a, b) = drawn_out(level.square(x, y), core);
        // The gap along the motion, the speed, and the position beside it: low end, speed, length
        // of the face.
        let x_face = (
            if d.0 > 0 { a.0 - c.0 } else { c.0 - b.0 } - r,
            d.0.abs(),
            c.1 - a.1,
            d.1,
            b.1 - a.1,
            (x - d.0.signum(), y),
        );
        let y_face = (
            if d.1 > 0 { a.1 - c.1 } else { c.1 - b.1 } - r,
            d.1.abs(),
            c.0 - a.0,
            d.0,
            b.0 - a.0,
            (x, y - d.1.signum()),
        );
        for (gap, speed, beside, along, along_face, across) in [x_face, y_face] {
            if gap < 0 || gap >= speed || level.full(across.0, across.1) {
                continue;
            }
            let at = i128::from(beside) * i128::from(speed) + i128::from(along) * i128::from(gap);
            if at >= 0 && at <= i128::from(along_face) * i128::from(speed) {
                first = first.into_iter().chain([Time::new(gap, speed)]).min();
            }
        }
    }
    first
}

/// Whether a circle enters the disc around some corner of a full cell before `until`.
pub fn enters_corner(level: &Level, body: &Body, d: P, until: Time) -> bool {
    let Body::Disc { c, core, r } = *body else { panic!("a circle is needed") };
    level.cells_along(body, d).filter(|&(x, y)| level.full(x, y)).any(|(x, y)| {
        let (a, b) = drawn_out(level.square(x, y), core);
        passes(c, r, d, a, b)
            && [a, b, (a.0, b.1), (b.0, a.1)].iter().any(|&p| enters_disc((c.0 - p.0, c.1 - p.1), r, d, until))
    })
}

/// Whether a circle enters the solid up to `until`.
pub fn enters_solid(level: &Level, body: &Body, d: P, until: Time) -> bool {
    enters_cells(level, body, d, until, |_| true)
}

/// Whether a circle enters one of the full cells that count up to `until`.
pub fn enters_cells(level: &Level, body: &Body, d: P, until: Time, counts: impl Fn(P) -> bool) -> bool {
    let Body::Disc { c, core, r } = *body else { panic!("a circle is needed") };
    level.cells_along(body, d).any(|(x, y)| {
        let (a, b) = drawn_out(level.square(x, y), core);
        level.full(x, y) && counts((x, y)) && enters(c, r, d, a, b, until)
    })
}

/// Whether a circle is nearer to a cell than some raw units.
pub fn is_near(level: &Level, body: &Body, (x, y): P, by: i64) -> bool {
    let Body::Disc { c, core, r } = *body else { panic!("a circle is needed") };
    let (a, b) = drawn_out(level.square(x, y), core);
    overlaps(c, r + by, a, b)
}
