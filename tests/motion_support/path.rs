//! Where a motion must end, from its reported hits: boxes exactly, circles from legs of straight motion, in floating point, within a few raw.
//!
//! The other checks say what must not happen; this one says that the body gets on.

#![allow(clippy::cast_precision_loss, reason = "lengths are below 2^30")]

use super::body::{Body, Outcome};
use super::level::Level;
use super::{P, len2};
use tilesat::{Hit, Mover, Response};

type V = (f64, f64);

fn respond(v: V, n: V, response: Response) -> V {
    let into = (v.0 * n.0 + v.1 * n.1) / (n.0 * n.0 + n.1 * n.1);
    let k = match response {
        Response::Touch => return (0.0, 0.0),
        Response::Slide | Response::Cross => into.min(0.0),
        Response::Bounce => 2.0 * into.min(0.0),
    };
    (v.0 - k * n.0, v.1 - k * n.1)
}

fn near(a: P, b: V, within: f64) -> bool {
    (a.0 as f64 - b.0).abs() <= within && (a.1 as f64 - b.1).abs() <= within
}

/// Whether velocity and place are what the hits imply. Corners with hits at the same place are not judged: planes that are touched
/// together are projected on together.
pub(crate) fn follows(start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let hits: Vec<&Hit> = out.hits.iter().collect();
    let corners = hits.iter().any(|h| h.index >= 4);
    let (mut vel, mut place, mut now) = ((v.0 as f64, v.1 as f64), (0.0, 0.0), 0.0);
    let leg = |place: &mut V, vel: V, time: f64| *place = (place.0 + vel.0 * time, place.1 + vel.1 * time);
    let mut first_leg = None;
    // A circle between two corners may stay where it is, a little before the contact: then both are touched together.
    let wedge = if let Body::Disc { r, .. } = *start { 2.0 * (r as f64).sqrt() } else { 0.0 };
    for (i, hit) in hits.iter().enumerate() {
        let toi = f64::from(hit.toi.raw()) / f64::from(1u32 << 30);
        if corners && first_leg.is_some() && vel.0.hypot(vel.1) * (toi - now) < wedge.max(16.0) {
            return Ok(());
        }
        if response == Response::Cross && hit.one_way && i as u32 + 1 == Mover::ITERATIONS {
            // It takes an iteration to see that it can be passed, and there is none left to do so.
            break;
        }
        leg(&mut place, vel, toi - now);
        first_leg.get_or_insert(place);
        now = toi;
        if response != Response::Cross || !hit.one_way {
            vel = respond(vel, (hit.axis.x.into(), hit.axis.y.into()), response);
        }
    }
    // Four hits use up the iterations: what is left is reported and not made.
    if (hits.len() as u32) < Mover::ITERATIONS {
        leg(&mut place, vel, 1.0 - now);
    }
    let length = (len2(v) as f64).sqrt();
    let rounding = (8.0 + length / f64::from(1 << 24)) * hits.len().max(1) as f64;
    if !near(out.v, vel, rounding) {
        return Err(format!("goes on by {:?}, not {vel:?}", out.v));
    }
    let short_leg = if first_leg.is_some_and(|leg| leg.0.hypot(leg.1) < wedge) { wedge } else { 0.0 };
    let (p, q) = (start.position(), out.body.position());
    let moved = (q.0 - p.0, q.1 - p.1);
    if near(moved, place, rounding + short_leg) { Ok(()) } else { Err(format!("moved by {moved:?}, not {place:?}")) }
}

/// A box's motion along each axis is exact: from face to face, and what is left of the speed after the last one.
pub(crate) fn box_is_exact(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let ((lo, hi), (end, _)) = (start.bounds(), out.body.bounds());
    let size = (hi.0 - lo.0, hi.1 - lo.1);
    // Where the box is, on the axis of the hit, when it touches each face in turn.
    let mut stops = (vec![lo.0], vec![lo.1]);
    for hit in out.hits.iter().filter(|h| response != Response::Cross || !h.one_way) {
        let (a, b) = level.square(hit.cell.x.into(), hit.cell.y.into());
        match hit.index {
            0 => stops.1.push(a.1 - size.1),
            1 => stops.0.push(b.0),
            2 => stops.1.push(b.1),
            _ => stops.0.push(a.0 - size.0),
        }
    }
    let axis = |stops: &[i64], end: i64, v: i64, remaining: i64| {
        let way: i64 = stops.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
        let last = *stops.last().unwrap_or(&end);
        match response {
            Response::Slide | Response::Cross if stops.len() > 1 => end == last && remaining == 0,
            _ => way + (end - last).abs() + remaining.abs() == v.abs(),
        }
    };
    let ok = axis(&stops.0, end.0, v.0, out.remaining.0) && axis(&stops.1, end.1, v.1, out.remaining.1);
    let stopped = response == Response::Touch && !out.hits.is_empty();
    if ok || stopped { Ok(()) } else { Err("a box's motion is not exact".to_owned()) }
}
