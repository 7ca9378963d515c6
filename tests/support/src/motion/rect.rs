//! Boxes with area: the first moment of a motion at which a box starts to overlap a square.

use super::body::Body;
use super::disc;
use super::level::Level;
use super::{P, Time, dot};

/// When a box with area enters the open square, and through which sides: (x, y).
///
/// The box relative to the square is a point against the open sum of both; each axis gives an open
/// interval of time.
pub fn enters(lo: P, hi: P, d: P, a: P, b: P) -> Option<(Time, (bool, bool))> {
    let x = span(a.0 - hi.0, b.0 - lo.0, d.0)?;
    let y = span(a.1 - hi.1, b.1 - lo.1, d.1)?;
    let from = later(x.0, y.0)?;
    let to = x.1.into_iter().chain(y.1).chain([Time::END]).min()?;
    (from < to && from >= Time::START).then(|| (from, (x.0 == Some(from), y.0 == Some(from))))
}

fn later(a: Option<Time>, b: Option<Time>) -> Option<Time> {
    a.into_iter().chain(b).max()
}

/// The open interval of time in which `d * t` is strictly between `lo` and `hi`; `None` ends are
/// infinite.
pub fn span(lo: i64, hi: i64, d: i64) -> Option<(Option<Time>, Option<Time>)> {
    match d.signum() {
        0 => (lo < 0 && 0 < hi).then_some((None, None)),
        1 => Some((Some(Time::new(lo, d)), Some(Time::new(hi, d)))),
        _ => Some((Some(Time::new(hi, d)), Some(Time::new(lo, d)))),
    }
}

/// A moment at which something is hit, and the faces that are met then: normal, and whether over a
/// length and not at an end only.
#[derive(Clone, Debug)]
pub struct First {
    pub time: Time,
    pub faces: Vec<(P, bool)>,
}

impl First {
    /// Keeps the earlier of both, or the faces of both.
    fn with(first: Option<Self>, time: Time, faces: impl IntoIterator<Item = (P, bool)>) -> Self {
        match first {
            Some(f) if f.time < time => f,
            Some(mut f) if f.time == time => {
                f.faces.extend(faces);
                f
            }
            _ => Self { time, faces: faces.into_iter().collect() },
        }
    }

    pub fn earlier(a: Option<Self>, b: Option<Self>) -> Option<Self> {
        match (a, b) {
            (a, Some(b)) => Some(Self::with(a, b.time, b.faces)),
            (a, None) => a,
        }
    }

    /// The documented choice: met over a length first, then more opposed to the motion, then x.
    pub fn normal(&self, d: P) -> Option<P> {
        let key = |&(n, over): &(P, bool)| (over, -dot(n, d), n.0 != 0);
        self.faces.iter().max_by_key(|f| key(f)).map(|f| f.0)
    }
}

/// The first entry of a box with area into the solid.
pub fn first_solid(level: &Level, body: &Body, d: P) -> Option<First> {
    let (lo, hi) = body.bounds();
    let mut first = None;
    for (x, y) in level.cells_along(body, d) {
        if !level.full(x, y) {
            continue;
        }
        let (a, b) = level.square(x, y);
        let Some((time, (by_x, by_y))) = enters(lo, hi, d, a, b) else { continue };
        let (n_x, n_y) = ((-d.0.signum(), 0), (0, -d.1.signum()));
        let faces = [(by_x, n_x), (by_y, n_y)].into_iter().filter(|&(by, n)| by && !level.full(x + n.0, y + n.1));
        first = Some(First::with(first, time, faces.map(|(_, n)| (n, by_x != by_y))));
    }
    first
}

/// The first one-way face that blocks the motion: the body is entirely in front of it, moves in,
/// and starts to overlap beyond it.
pub fn first_one_way(level: &Level, body: &Body, d: P) -> Option<First> {
    let (lo, hi) = body.bounds();
    let mut first = None;
    for (x, y) in level.cells_along(body, d) {
        if !level.one_way(x, y) {
            continue;
        }
        let (a, b) = level.square(x, y);
        let gap = a.1 - hi.1;
        if d.1 <= 0 || gap < 0 || gap >= d.1 {
            continue;
        }
        // Positions at that moment, scaled by the speed.
        let at = |v: i64, face: i64| i128::from(v - face) * i128::from(d.1) + i128::from(d.0) * i128::from(gap);
        let (spans, over) = match *body {
            Body::Disc { c, core, r } if r > 0 => (at(c.0 + core.0, a.0) >= 0 && at(c.0, b.0) <= 0, true),
            _ => {
                let (right, left) = (at(hi.0, a.0), at(lo.0, b.0));
                let goes_on = |x: i64| level.full(x, y) || level.one_way(x, y);
                let begins = right > 0 || right == 0 && (d.0 > 0 || goes_on(x - 1));
                (begins && (left < 0 || left == 0 && (d.0 < 0 || goes_on(x + 1))), right > 0 && left < 0)
            }
        };
        if spans {
            first = Some(First::with(first, Time::new(gap, d.1), [((0, -1), over)]));
        }
    }
    first
}

impl Body {
    /// Whether a body with area reaches the inside of a square whose bounds overlap its bounds.
    pub fn reaches(&self, a: P, b: P) -> bool {
        match *self {
            Self::Rect { .. } => true,
            Self::Disc { c, core, r } => {
                let (a, b) = disc::drawn_out((a, b), core);
                disc::overlaps(c, r, a, b)
            }
        }
    }
}
