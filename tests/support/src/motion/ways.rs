//! What a circle among blocks may do at a hit, from its place alone: where it stops nothing leads on, and what it keeps is a part of its velocity.

#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "lengths are below 2^30")]

use super::body::{Body, Outcome};
use super::level::Level;
use super::{P, Time, disc, dot, len2, rect};
use tilesat::{Hit, Mover, Response};

type V = (f64, f64);

/// How far a way is free that counts as one, raw: twice the 64 up to which what is touched may bind it.
const WAY: f64 = 128.0;
/// Corners that are farther than this from the circle are not touched: the rounding distance of 4 raw, and as much for the circle's own place.
const TOUCH: f64 = 8.0;

/// `v` without its part into a plane.
pub fn along(v: V, n: V) -> V {
    let into = ((v.0 * n.0 + v.1 * n.1) / (n.0 * n.0 + n.1 * n.1)).min(0.0);
    (v.0 - into * n.0, v.1 - into * n.1)
}

/// Whether a displacement leads into the solid, or into the front of a one-way face.
pub fn is_blocked(level: &Level, body: &Body, d: P, response: Response) -> bool {
    let one_way = || response != Response::Cross && rect::first_one_way(level, body, d).is_some();
    disc::enters_solid(level, body, d, Time::END) || one_way()
}

/// The directions that may lead on from a place: along x and y, and the tangents of corners that are touched, each rounded away from the corner.
fn directions(level: &Level, c: P, r: i64) -> Vec<P> {
    let way = WAY as i64;
    let mut all = vec![(way, 0), (-way, 0), (0, way), (0, -way)];
    let reach = r + TOUCH as i64;
    for (x, y) in level.cells((c.0 - reach, c.1 - reach), (c.0 + reach, c.1 + reach)) {
        if !level.full(x, y) {
            continue;
        }
        let (a, b) = level.square(x, y);
        for p in [a, b, (a.0, b.1), (b.0, a.1)] {
            let n = (c.0 - p.0, c.1 - p.1);
            let rho = (len2(n) as f64).sqrt();
            if rho > 0.0 && (rho - r as f64).abs() <= TOUCH {
                let out = |part: f64, n: i64| if n > 0 { part.ceil() } else { part.floor() } as i64;
                let t = (-n.1 as f64 * WAY / rho, n.0 as f64 * WAY / rho);
                all.extend([(out(t.0, n.0), out(t.1, n.1)), (out(-t.0, n.0), out(-t.1, n.1))]);
            }
        }
    }
    all
}

/// A circle that ends without velocity ends where no direction leads on in which both the call's velocity and the one before its last hit have a part.
///
/// A part of less than `rounding` and 32 raw is one of the tangent's roundings. A corner that it turned round since may leave the latter a part
/// against the former: nothing pushes the body that way.
pub fn stops_rightly(level: &Level, v: P, response: Response, out: &Outcome, rounding: f64) -> Result<(), String> {
    let (Body::Disc { c, r }, Some(last)) = (out.body, out.hits.iter().last()) else { return Ok(()) };
    if r == 0 || out.v != (0, 0) || level.overlaps(&out.body) {
        return Ok(());
    }
    let before = obeyed(response, out).filter(|hit| hit.toi < last.toi);
    let u = before.fold((v.0 as f64, v.1 as f64), |u, hit| along(u, axis(hit)));
    let leads = |d: &P| (u.0 * d.0 as f64 + u.1 * d.1 as f64) / WAY > rounding + 32.0 && dot(v, *d) > 0;
    match directions(level, c, r).iter().find(|d| leads(d) && !is_blocked(level, &out.body, **d, response)) {
        Some(d) => Err(format!("stops with {u:?} where {d:?} is free")),
        None => Ok(()),
    }
}

/// A velocity that is left is what some of the hits leave of the call's, within `rounding`, and the body has made all of the way that it had time for.
///
/// Which of the hits are still touched at the last one may be decided by a raw unit; that it is some of them may not.
pub fn keeps_a_part(level: &Level, v: P, response: Response, out: &Outcome, rounding: f64) -> Result<(), String> {
    let mut parts = vec![(v.0 as f64, v.1 as f64)];
    for n in obeyed(response, out).map(axis).chain([(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)]) {
        parts.extend(parts.clone().into_iter().map(|u| along(u, n)));
    }
    // Along a corner that was hit before, and that the way still touches: its tangent has turned since.
    let (Body::Disc { c, r } | Body::Rect { lo: c, hi: (r, _) }) = out.body;
    let (x, y) = (out.v.0 as f64, out.v.1 as f64);
    for hit in obeyed(response, out).filter(|hit| hit.index >= 4) {
        let p = corner(level, hit);
        let m = ((c.0 - p.0) as f64, (c.1 - p.1) as f64);
        let across = (x * m.1 - y * m.0) / x.hypot(y).max(1.0);
        if (across.abs() - r as f64).abs() <= TOUCH {
            let n = if across > 0.0 { (-y, x) } else { (y, -x) };
            parts.extend(parts.clone().into_iter().map(|u| along(u, n)));
        }
    }
    let is = |p: &V| (out.v.0 as f64 - p.0).abs() <= rounding && (out.v.1 as f64 - p.1).abs() <= rounding;
    if !parts.iter().any(is) {
        return Err(format!("goes on by {:?}, no part of {v:?}", out.v));
    }
    makes_its_way(level, response, out, rounding)
}

/// The way since the last hit, made backwards, leads to what was hit: within the roundings, and 66 raw units by which a wedged circle is early on each axis,
/// `66 sqrt 2 < 94`, and 68 by which it may have crept since, up to what binds it within 64 and the rounding distance.
fn makes_its_way(level: &Level, response: Response, out: &Outcome, rounding: f64) -> Result<(), String> {
    let (Body::Disc { c, r }, Some(last)) = (out.body, out.hits.iter().last()) else { return Ok(()) };
    let is_last = out.hits.len() < Mover::ITERATIONS as usize && out.remaining == (0, 0);
    if !is_last || out.v == (0, 0) || (response == Response::Cross && last.one_way) {
        return Ok(());
    }
    let left = 1.0 - f64::from(last.toi.raw()) / f64::from(1u32 << 30);
    let at = (c.0 as f64 - out.v.0 as f64 * left, c.1 as f64 - out.v.1 as f64 * left);
    // Of a face any point of its line, of a corner the corner: both lie to the side that the normal points to.
    let (p, n) = (corner(level, last), axis(last));
    let m = (at.0 - p.0 as f64, at.1 - p.1 as f64);
    let distance = if last.index < 4 { m.0 * n.0 + m.1 * n.1 } else { m.0.hypot(m.1) };
    let off = (distance - r as f64).abs();
    if off <= rounding + 94.0 + 68.0 { Ok(()) } else { Err(format!("has not made its way: {off} off")) }
}

/// The corner of the cell that was hit, to the side of the normal.
pub fn corner(level: &Level, hit: &Hit) -> P {
    let (a, b) = level.square(hit.cell.x.into(), hit.cell.y.into());
    (if hit.axis.x > 0 { b.0 } else { a.0 }, if hit.axis.y > 0 { b.1 } else { a.1 })
}

fn axis(hit: &Hit) -> V {
    (hit.axis.x.into(), hit.axis.y.into())
}

fn obeyed(response: Response, out: &Outcome) -> impl Iterator<Item = &Hit> {
    out.hits.iter().filter(move |hit| response != Response::Cross || !hit.one_way)
}
