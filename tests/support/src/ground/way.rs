//! The way of a body's middle over a ground that it never leaves.

use super::{Ground, Shape};

/// How high the middle is at `x`: y down, so the least.
pub fn height(ground: &Ground, shape: Shape, x: f64) -> f64 {
    let reach = match shape {
        Shape::Rect(w, _) => w,
        Shape::Disc(r) => r,
    } + 1;
    let (lo, hi) = (x as i64 - reach, x as i64 + reach);
    let mut best = f64::INFINITY;
    for pair in ground.points.windows(2).filter(|p| p[0].0 <= hi && p[1].0 >= lo) {
        let (a, b) = ((pair[0].0 as f64, pair[0].1 as f64), (pair[1].0 as f64, pair[1].1 as f64));
        best = best.min(match shape {
            Shape::Rect(w, h) => over_box(a, b, x, w as f64) - h as f64,
            Shape::Disc(r) => over_disc(a, b, x, r as f64),
        });
    }
    best
}

/// The highest point of a piece under a box.
fn over_box(a: (f64, f64), b: (f64, f64), x: f64, w: f64) -> f64 {
    let (lo, hi) = (a.0.max(x - w), b.0.min(x + w));
    if lo > hi {
        return f64::INFINITY;
    }
    if a.0 == b.0 {
        return a.1.min(b.1);
    }
    let at = |t: f64| a.1 + (b.1 - a.1) * (t - a.0) / (b.0 - a.0);
    at(lo).min(at(hi))
}

fn over_disc(a: (f64, f64), b: (f64, f64), x: f64, r: f64) -> f64 {
    let end = |p: (f64, f64)| {
        let d = x - p.0;
        if d.abs() > r { f64::INFINITY } else { p.1 - (r * r - d * d).sqrt() }
    };
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let len = (dx * dx + dy * dy).sqrt();
    let mut best = end(a).min(end(b));
    if dx != 0.0 {
        // The foot on the line of the middle that is r above it.
        let foot = (x - r * dy / len - a.0) / dx;
        if (0.0..=1.0).contains(&foot) {
            best = best.min(a.1 + dy * foot - r * dx / len);
        }
    }
    best
}

/// Sums `part` over straight parts of the way between two positions: those whose middle and
/// quarters are within a twentieth of a raw unit of the chord. The chord is then short by less than
/// a hundredth in all.
pub fn along(ground: &Ground, shape: Shape, from: f64, to: f64, part: fn(f64, f64) -> f64) -> f64 {
    let f = |x: f64| height(ground, shape, x);
    piece((from, f(from)), (to, f(to)), &f, part)
}

/// Whether it is one straight part.
pub fn is_straight(ground: &Ground, shape: Shape, from: f64, to: f64) -> bool {
    let f = |x: f64| height(ground, shape, x);
    (0..=8).all(|k| {
        let k = f64::from(k) / 8.0;
        (f(from + (to - from) * k) - f(from) - (f(to) - f(from)) * k).abs() < 1e-3
    })
}

fn piece(a: (f64, f64), b: (f64, f64), f: &dyn Fn(f64) -> f64, part: fn(f64, f64) -> f64) -> f64 {
    let at = |k: f64| (a.0 + (b.0 - a.0) * k, a.1 + (b.1 - a.1) * k);
    let straight = [0.25, 0.5, 0.71].iter().all(|&k| {
        let p = at(k);
        (f(p.0) - p.1).abs() < 0.05
    });
    if straight || (b.0 - a.0).abs() < 0.5 {
        return part(b.0 - a.0, b.1 - a.1);
    }
    let x = f64::midpoint(a.0, b.0);
    let m = (x, f(x));
    piece(a, m, f, part) + piece(m, b, f, part)
}

/// The length of a straight part.
pub fn length(dx: f64, dy: f64) -> f64 {
    dx.hypot(dy)
}

/// The share of the level speed on a straight part if the velocity is projected: s cos(a) per
/// frame.
pub fn projected(dx: f64, dy: f64) -> f64 {
    (dx * dx + dy * dy) / dx.abs()
}
