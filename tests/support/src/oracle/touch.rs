//! Pairs constructed to touch: exactly, with Pythagorean directions, and to the nearest lattice
//! point, with any direction.

use super::figure::{Figure, Kind, Point};
use super::generate::aabb;
use crate::{Random, gcd};

/// A touching pair of the kinds asked for, its numbers within a few times `scale`.
pub fn exact(r: &mut Random, pair: (Kind, Kind), scale: i64) -> (Figure, Figure) {
    let arm = if r.one_in(4) { lattice_arm(r, scale) } else { triple(r, scale) };
    touching(r, pair, scale, arm)
}

/// The same with a direction that is not rational: the touch holds to within rounding.
pub fn rounded(r: &mut Random, pair: (Kind, Kind), scale: i64) -> (Figure, Figure) {
    let n = r.magnitude(scale);
    let arm = any_direction(r, n);
    touching(r, pair, scale, arm)
}

/// A vector and its length.
type Arm = (Point, i64);

/// A scaled Pythagorean triple in any of the eight octants; its hypotenuse is the exact length.
fn triple(r: &mut Random, scale: i64) -> Arm {
    loop {
        let (m, n) = (r.within(1, 40), r.within(0, 39));
        let (p, q, h) = (m * m - n * n, 2 * m * n, m * m + n * n);
        let most = scale / h;
        if n < m && most > 0 {
            let k = r.within(1, most);
            let (p, q) = if r.one_in(2) { (p, q) } else { (q, p) };
            return ((r.sign() * p * k, r.sign() * q * k), h * k);
        }
    }
}

fn lattice_arm(r: &mut Random, scale: i64) -> Arm {
    let n = r.magnitude(scale);
    let s = r.sign() * n;
    (if r.one_in(2) { (s, 0) } else { (0, s) }, n)
}

/// About `n` long in a direction of the circle, rounded to the lattice. Only `+ - * /` and the
/// square root are used: the same stream on every host.
#[expect(clippy::cast_precision_loss, reason = "generators may use any number, the judge may not")]
fn any_direction(r: &mut Random, n: i64) -> Arm {
    let (x, y) = (r.around(1 << 20) as f64, r.around(1 << 20) as f64);
    let length = (x * x + y * y).sqrt().max(1.0);
    let round = |v: f64| (v + if v < 0.0 { -0.5 } else { 0.5 }) as i64;
    ((round(x / length * n as f64), round(y / length * n as f64)), n)
}

/// A pair whose nearest points are `arm` apart once the radii are left aside.
fn touching(r: &mut Random, pair: (Kind, Kind), scale: i64, arm: Arm) -> (Figure, Figure) {
    let ((dx, dy), length) = arm;
    match pair {
        (Kind::Circle, Kind::Circle) => {
            let part = r.within(0, length);
            (circle((dx, dy), part), circle((0, 0), length - part))
        }
        (Kind::Circle, Kind::Aabb) => {
            // The box lies behind its corner at the origin as seen along the arm, or behind a side
            // when the arm is axis-parallel.
            let b = behind(r, (dx, dy), scale);
            (circle((dx, dy), length), b)
        }
        (Kind::Circle, Kind::Segment) if r.one_in(2) => {
            // The foot is inside the segment, which is perpendicular to the arm.
            let g = gcd(dx, dy).max(1);
            let unit = (-dy / g, dx / g);
            let most = (scale / (unit.0.abs().max(unit.1.abs()).max(1))).max(1);
            let (back, on) = (r.magnitude(most), r.magnitude(most));
            (circle((dx, dy), length), segment(r, times(unit, -back), times(unit, on)))
        }
        (Kind::Circle, Kind::Segment) => {
            // The foot is an end: the rest of the segment lies behind it.
            let mut e = (r.around(scale), r.around(scale));
            if i128::from(e.0) * i128::from(dx) + i128::from(e.1) * i128::from(dy) > 0 {
                e = (-e.0, -e.1);
            }
            (circle((dx, dy), length), segment(r, (0, 0), e))
        }
        (Kind::Aabb, Kind::Aabb) => boxes(r, scale),
        (Kind::Segment, Kind::Aabb) => {
            let g = gcd(dx, dy).max(1);
            let (b, line) = if r.one_in(2) {
                // The corner at the origin is on the segment, whose direction misses the box's
                // quadrant.
                let beyond = times((dx / g, dy / g), r.within(0, 2 * g));
                let line = segment(r, (-dx, -dy), beyond);
                (aabb((0, 0), (-sign_of(r, dx) * r.magnitude(scale), sign_of(r, dy) * r.magnitude(scale))), line)
            } else {
                // One end is on the box, the rest leads away.
                (behind(r, (dx, dy), scale), segment(r, (0, 0), (dx, dy)))
            };
            (line, b)
        }
        (Kind::Segment, Kind::Segment) => {
            let g = gcd(dx, dy).max(1);
            let at = times((dx / g, dy / g), r.within(0, g));
            let end = match r.below(4) {
                // On the same line, overlapping, meeting or apart by whole steps.
                0 => times((dx / g, dy / g), r.within(-g, 2 * g)),
                _ => (r.around(scale), r.around(scale)),
            };
            (segment(r, (0, 0), (dx, dy)), segment(r, at, end))
        }
        (a, b) => panic!("no touching construction for {a:?} and {b:?}"),
    }
}

/// A box with the origin on its boundary that a vector in direction `d` leaves.
fn behind(r: &mut Random, d: Point, scale: i64) -> Figure {
    let corner = (-sign_of(r, d.0) * r.magnitude(scale), -sign_of(r, d.1) * r.magnitude(scale));
    // Towards an axis-parallel arm the origin may be anywhere on the side.
    let other = match d {
        (0, _) => (-corner.0.signum() * r.magnitude(scale), 0),
        (_, 0) => (0, -corner.1.signum() * r.magnitude(scale)),
        _ => (0, 0),
    };
    aabb(corner, other)
}

/// Boxes that share part of a side or a corner.
fn boxes(r: &mut Random, scale: i64) -> (Figure, Figure) {
    let (w, h) = (r.magnitude(scale), r.magnitude(scale));
    let (v, k) = (r.magnitude(scale), r.magnitude(scale));
    let left = if r.one_in(2) { w } else { -v };
    let low = match r.below(4) {
        0 => -k,
        1 => h,
        _ => r.within(-k, h),
    };
    let turn = r.one_in(2);
    let place = |p: Point| if turn { (p.1, p.0) } else { p };
    (aabb((0, 0), (w, h)).map(place), aabb((left, low), (left + v, low + k)).map(place))
}

fn circle(centre: Point, radius: i64) -> Figure {
    Figure::Circle { centre, radius }
}

/// Either order of the ends.
fn segment(r: &mut Random, a: Point, b: Point) -> Figure {
    if r.one_in(2) { Figure::Segment { a, b } } else { Figure::Segment { a: b, b: a } }
}

fn times(p: Point, k: i64) -> Point {
    (p.0 * k, p.1 * k)
}

/// The sign of `n`, or either one of zero.
fn sign_of(r: &mut Random, n: i64) -> i64 {
    if n == 0 { r.sign() } else { n.signum() }
}
