//! The time at which a motion first makes two shapes overlap, exactly enough.
//!
//! Whether they meet is one question about the polygon of all differences. The way of one shape,
//! grown by the other, has the origin inside or not. The time is the first one in one of the pieces
//! of the grown shape: two boxes and four discs, or for a segment a strip and two discs. Each entry
//! is a fraction, or a root without cancellation, so 15 digits are right.

use super::classes::Case;
use crate::job::Format;
use crate::record::Row;
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::measure::Measure;
use tilesat_judge::oracle::sum::Sum;

#[derive(Clone, Copy, Debug)]
pub struct Truth {
    pub toi: Option<f64>,
    /// Whether it touches or overlaps on the way: a hit by the other convention.
    touches: bool,
    /// The length of the motion, in pixels.
    length: f64,
}

/// A moving point, and the set that it must not enter: a box, a point or a segment, grown by a
/// radius.
struct Relative {
    p: Point,
    lo: Point,
    hi: Point,
    r: i64,
    is_segment: bool,
}

fn relative(case: &Case) -> Relative {
    match (case.a, case.b) {
        (Figure::Circle { centre, radius }, Figure::Circle { centre: c, radius: s }) => {
            Relative { p: centre, lo: c, hi: c, r: radius + s, is_segment: false }
        }
        (Figure::Circle { centre, radius }, Figure::Aabb { min, max }) => {
            Relative { p: centre, lo: min, hi: max, r: radius, is_segment: false }
        }
        (Figure::Circle { centre, radius }, Figure::Segment { a, b }) => {
            Relative { p: centre, lo: a, hi: b, r: radius, is_segment: true }
        }
        (Figure::Aabb { min, max }, Figure::Aabb { min: lo, max: hi }) => {
            let lo = (lo.0 - (max.0 - min.0), lo.1 - (max.1 - min.1));
            Relative { p: min, lo, hi, r: 0, is_segment: false }
        }
        _ => panic!("no such cast"),
    }
}

impl Truth {
    /// Without a motion: an overlap is a hit at once.
    pub fn at_once(overlaps: bool, touches: bool) -> Self {
        Self { toi: overlaps.then_some(0.0), touches, length: 0.0 }
    }

    pub fn is_free(&self) -> bool {
        self.toi.is_none()
    }

    /// One motion toward several shapes: the first hit of all.
    pub fn first(all: impl IntoIterator<Item = Self>) -> Self {
        let none = Self::at_once(false, false);
        all.into_iter().fold(none, |a, b| Self {
            toi: a.toi.into_iter().chain(b.toi).reduce(f64::min),
            touches: a.touches || b.touches,
            length: b.length,
        })
    }

    pub fn starts_apart(case: &Case) -> bool {
        !Measure::new(&case.a, &case.b).overlaps()
    }

    /// The answer to a case that starts apart.
    pub fn new(case: &Case) -> Self {
        let Relative { p, lo, hi, r, is_segment } = relative(case);
        let d = case.d;
        let way = Figure::Segment { a: p, b: (p.0 + d.0, p.1 + d.1) };
        let core = if is_segment { Figure::Segment { a: lo, b: hi } } else { Figure::Aabb { min: lo, max: hi } };
        let mut sum = Sum::new(&way, &core);
        sum.radius = r;
        let exact = Measure::of(&sum);
        let toi = exact.overlaps().then(|| {
            if is_segment {
                let ends = [lo, hi].map(|c| enters_disc((p.0 - c.0, p.1 - c.1), d, r));
                let first = ends.into_iter().chain([enters_strip(p, d, lo, hi, r)]).flatten().reduce(f64::min);
                return first.expect("what is entered is entered by a piece");
            }
            let wide = enters_box(p, d, (lo.0 - r, lo.1), (hi.0 + r, hi.1));
            let high = enters_box(p, d, (lo.0, lo.1 - r), (hi.0, hi.1 + r));
            let discs = [lo, (hi.0, lo.1), (lo.0, hi.1), hi].map(|c| enters_disc((p.0 - c.0, p.1 - c.1), d, r));
            let first = [wide, high].into_iter().chain(discs).flatten().reduce(f64::min);
            first.expect("what is entered is entered by a piece")
        });
        Self { toi, touches: exact.touches(), length: (d.0 as f64).hypot(d.1 as f64) / 65536.0 }
    }
}

/// Time at which a point enters an open box.
fn enters_box(p: Point, d: Point, lo: Point, hi: Point) -> Option<f64> {
    // Fractions with the first one's denominators: from and to.
    let (mut from, mut to) = ((0i64, 1i64), (1i64, 1i64));
    let less = |a: (i64, i64), b: (i64, i64)| i128::from(a.0) * i128::from(b.1) < i128::from(b.0) * i128::from(a.1);
    for (p, d, lo, hi) in [(p.0, d.0, lo.0, hi.0), (p.1, d.1, lo.1, hi.1)] {
        if d == 0 {
            if p <= lo || p >= hi {
                return None;
            }
            continue;
        }
        let (enter, leave) = if d > 0 { (lo - p, hi - p) } else { (p - hi, p - lo) };
        let (enter, leave) = ((enter, d.abs()), (leave, d.abs()));
        from = if less(from, enter) { enter } else { from };
        to = if less(leave, to) { leave } else { to };
    }
    less(from, to).then(|| from.0 as f64 / from.1 as f64)
}

/// Time at which a point comes within `r` of a segment's line, if that is beside the segment. It
/// comes from outside.
fn enters_strip(p: Point, d: Point, a: Point, b: Point, r: i64) -> Option<f64> {
    let (e, m) = ((b.0 - a.0, b.1 - a.1), (p.0 - a.0, p.1 - a.1));
    let cross = |p: Point, q: Point| i128::from(p.0) * i128::from(q.1) - i128::from(p.1) * i128::from(q.0);
    let dot = |p: Point, q: Point| i128::from(p.0) * i128::from(q.0) + i128::from(p.1) * i128::from(q.1);
    let (aside, toward, square) = (cross(e, m), cross(e, d), dot(e, e));
    let gap = aside * aside - i128::from(r) * i128::from(r) * square;
    if gap < 0 || aside.signum() * toward.signum() >= 0 {
        return None;
    }
    // (|aside| - r |e|) / |toward|: nothing cancels.
    let root = r as f64 * (square as f64).sqrt();
    let t = gap as f64 / (toward.unsigned_abs() as f64 * (aside.unsigned_abs() as f64 + root));
    let along = dot(m, e) as f64 + dot(d, e) as f64 * t;
    ((0.0..=square as f64).contains(&along) && t < 1.0).then_some(t)
}

/// Time at which a point, `m` from the centre and not inside, enters an open disc.
fn enters_disc(m: Point, d: Point, r: i64) -> Option<f64> {
    let dot = |p: Point, q: Point| i128::from(p.0) * i128::from(q.0) + i128::from(p.1) * i128::from(q.1);
    let square = i128::from(r) * i128::from(r);
    let (a, b, c) = (dot(d, d), -dot(m, d), dot(m, m) - square);
    let across = i128::from(d.0) * i128::from(m.1) - i128::from(d.1) * i128::from(m.0);
    let end = (m.0 + d.0, m.1 + d.1);
    let free = square * a - across * across;
    let hits = b > 0 && ((b < a && free > 0) || dot(end, end) < square);
    // c / (b + root): nothing cancels.
    hits.then(|| c as f64 / (b as f64 + (free as f64).sqrt()))
}

/// An answer: whether it hits, and the time, if the query gives one.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    pub hit: bool,
    pub toi: Option<f64>,
}

/// Less than this many pixels late is rounding of the judge.
const EVEN: f64 = 1.0 / 4_294_967_296.0;

pub fn judge(row: &mut Row, truths: &[Truth], answers: &[Answer], format: Format) {
    let (mut wrong, mut closed, mut hits, mut late, mut deepest) = (0u32, 0u32, 0u32, 0u32, 0.0f64);
    let (mut max, mut sum, mut n) = ((0.0f64, 0.0f64), (0.0, 0.0), 0u32);
    for (truth, answer) in truths.iter().zip(answers) {
        wrong += u32::from(answer.hit != truth.toi.is_some());
        closed += u32::from(answer.hit != truth.touches);
        hits += u32::from(truth.toi.is_some());
        let (Some(exact), Some(told)) = (truth.toi, answer.toi) else { continue };
        let px = (told - exact) * truth.length;
        late += u32::from(px > EVEN);
        deepest = deepest.max(px);
        let ulps = (told - exact).abs() / format.ulp(exact);
        max = (max.0.max(px.abs()), max.1.max(ulps));
        sum = (sum.0 + px.abs(), sum.1 + ulps);
        n += 1;
    }
    row.set("queries", truths.len() as f64).set("hits", hits.into()).set("wrong", wrong.into());
    row.set("wrong_closed", closed.into());
    if n > 0 {
        let n = f64::from(n);
        row.set("max_px", max.0).set("mean_px", sum.0 / n).set("max_ulp", max.1).set("mean_ulp", sum.1 / n);
        row.set("late", late.into()).set("deepest_px", if deepest > EVEN { deepest } else { 0.0 });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::casts::classes::{CLASSES, KINDS};
    use tilesat_judge::num_bigint::BigInt;
    use tilesat_judge::num_rational::BigRational;

    type Q = BigRational;

    fn q(n: i64) -> Q {
        Q::from_integer(BigInt::from(n))
    }

    /// The squared distance from the moving point to the box, minus the squared radius.
    fn beyond(case: &Case, t: &Q) -> Q {
        let Relative { p, lo, hi, r, is_segment } = relative(case);
        let at = |i: usize, t: &Q| q([p.0, p.1][i]) + q([case.d.0, case.d.1][i]) * t;
        if is_segment {
            // Its nearest point, as a position along it from 0 to 1.
            let (e, m) = ([q(hi.0 - lo.0), q(hi.1 - lo.1)], [at(0, t) - q(lo.0), at(1, t) - q(lo.1)]);
            let along = (&m[0] * &e[0] + &m[1] * &e[1]) / (&e[0] * &e[0] + &e[1] * &e[1]);
            let along = along.clamp(q(0), q(1));
            let (x, y) = (&m[0] - &e[0] * &along, &m[1] - &e[1] * &along);
            return &x * &x + &y * &y - q(r) * q(r);
        }
        let off = |p: i64, d: i64, lo: i64, hi: i64| {
            let at = q(p) + q(d) * t;
            if at < q(lo) {
                q(lo) - at
            } else if at > q(hi) {
                at - q(hi)
            } else {
                q(0)
            }
        };
        let (x, y) = (off(p.0, case.d.0, lo.0, hi.0), off(p.1, case.d.1, lo.1, hi.1));
        &x * &x + &y * &y - q(r) * q(r)
    }

    /// Shortly before the time they are disjoint, and shortly after it they overlap. Without a time
    /// they are disjoint all the way.
    #[test]
    fn moments_separate_apart_from_overlap() {
        let little = Q::new(BigInt::from(1), BigInt::from(1u64 << 44));
        for kinds in KINDS {
            for class in CLASSES {
                let mut hits = 0;
                for case in class.cases(kinds, 300) {
                    let Some(toi) = Truth::new(&case).toi else {
                        let steps = 64;
                        let apart =
                            (0..=steps).all(|i| beyond(&case, &(q(i) / q(steps))) >= q(0) || relative(&case).r == 0);
                        assert!(apart, "{class:?} {case:?}");
                        continue;
                    };
                    hits += 1;
                    let t = Q::from_float(toi).unwrap();
                    let (before, after) = (&t - &little, &t + &little);
                    if relative(&case).r > 0 {
                        assert!(before < q(0) || beyond(&case, &before) > q(0), "{class:?} {case:?}");
                        // The shortest graze may have ended before that.
                        let (inside, zero) = (beyond(&case, &after), q(0));
                        assert!(inside < zero || after > q(1) || class != CLASSES[1], "{class:?} {case:?}: {inside}");
                    }
                    assert!((0.0..1.0).contains(&toi));
                }
                assert!((15..=300).contains(&hits), "{kinds:?} {class:?}: {hits}");
            }
        }
    }
}
