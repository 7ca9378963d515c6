//! The verdict on one call of the mover.

use super::body::{Body, Outcome};
use super::level::Level;
use super::rect::{self, First};
use super::{P, Time, add, disc, dot, len2, path, point, ways};
use tilesat::{Hit, Mover, Response};

/// How near along its normal a surface is that binds a way up to 64 raw. The distance from it is at
/// least as much: whatever is as near binds.
const NEAR: i64 = 4;

/// Whether a body is past what it hit last: its place beside a corner is rounded, so the tangent
/// there may lead into the corner by less than a raw unit. Then a circle misses the corner however
/// far it goes, or in the next 64 raw units it enters neither the cell that it hit nor another one
/// that is nearer than `near`. One that is farther binds no way: it is a hit of the next sweep, or
/// of the next call.
///
/// A circle in a gap that closes may have no free place as near to the corner as what is touched.
fn is_past(level: &Level, body: &Body, v: P, hit: &Hit, near: i64) -> bool {
    let Body::Disc { core, r, .. } = *body else { return false };
    let m = ways::from_corner(body, ways::corner(level, hit));
    let across = i128::from(m.0) * i128::from(v.1) - i128::from(m.1) * i128::from(v.0);
    let misses = dot(v, m) >= 0 || across * across >= i128::from(r) * i128::from(r) * len2(v);
    let way = v.0.abs().max(v.1.abs());
    let (far, way) = if way < 64 { ((v.0 * 64, v.1 * 64), way * 64) } else { (v, way) };
    let touched = i128::from(r + ways::TOUCH);
    let is_away = len2(m) > touched * touched;
    let of_hit: P = (hit.cell.x.into(), hit.cell.y.into());
    let binds = |cell: P| cell == of_hit || disc::is_near(level, body, cell, near);
    (hit.index >= 4 && (is_away || core == (0, 0) && misses))
        || !disc::enters_cells(level, body, far, Time::new(64, way), binds)
}

/// How early a call may report a circle's corner contact, in parts of 2^30: a few roundings of 31
/// bits, and the roots of short motions, which are whole raw units (less than a raw unit of way).
fn early(d: P) -> i64 {
    (8 + (2 << 30) / len2(d)) as i64
}

/// How far a circle may end from the exact position of its reported moment, on each axis.
pub const ASIDE: i64 = 2;

/// The faults of an outcome. All conditions must hold for every response.
pub fn judge(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let check = |ok: bool, what: &str| if ok { Ok(()) } else { Err(what.to_owned()) };
    check(!level.overlaps(&out.body), "ends in the solid")?;
    check(start.moved(offset(start, &out.body)) == out.body, "changed its size")?;
    check(len2(out.v) <= len2(v), "is faster than before")?;
    check(out.work.iterations <= Mover::ITERATIONS, "too many iterations")?;
    check(out.hits.len() as u32 <= out.work.iterations, "more hits than iterations")?;
    check(out.times().is_sorted(), "times go back")?;
    first_hit(level, start, v, out.hits.first())?;
    judge_hits(level, response, out)?;
    path::follows(level, start, v, response, out)?;
    if matches!(start, Body::Rect { .. }) {
        path::box_is_exact(level, start, v, response, out)?;
    }
    if response == Response::Touch {
        check(add(offset(start, &out.body), out.remaining) == v, "place and rest are not the motion")?;
    }
    if out.hits.is_empty() {
        check(out.body == start.moved(v), "a free motion did not arrive")?;
        check(out.v == v && out.remaining == (0, 0), "a free motion lost something")?;
    }
    let obeyed: Vec<&Hit> = out.hits.iter().filter(|h| response != Response::DropThrough || !h.one_way).collect();
    let axes: Vec<P> = obeyed.iter().map(|h| (i64::from(h.axis.x), i64::from(h.axis.y))).collect();
    if let (Some(&last), Some(hit)) = (axes.last(), obeyed.last()) {
        // Past it where it stands now, or where it chose its way, which is known within roundings.
        let is_past = |body: &Body, near| is_past(level, body, out.v, hit, near);
        let rounded = NEAR - i64::from(ways::PLACE);
        let was_past = || ways::place_of_last(response, out).is_some_and(|(at, _)| is_past(&at, rounded));
        // Between two corners, on both sides, as far as roundings turn the line through both.
        let between = |m: &P| {
            let gap = (last.0 - m.0, last.1 - m.1);
            dot(*m, last) < 0 && dot(out.v, gap).pow(2) <= 64 * len2(gap)
        };
        let passes = dot(out.v, last) >= 0 || is_past(&out.body, NEAR) || was_past() || axes.iter().any(between);
        check(passes, "still moves into what it hit last")?;
    } else {
        check(out.v == v, "lost velocity without a hit")?;
    }
    check(
        out.remaining == (0, 0) || response == Response::Touch || out.work.iterations == Mover::ITERATIONS,
        "motion left over",
    )?;
    match response {
        Response::Touch => check(axes.is_empty() || out.v == (0, 0), "touched and went on"),
        Response::Slide | Response::DropThrough if matches!(start, Body::Rect { .. }) => {
            let stopped = |by: fn(&P) -> i64| axes.iter().any(|n| by(n) != 0);
            let expected = (if stopped(|n| n.0) { 0 } else { v.0 }, if stopped(|n| n.1) { 0 } else { v.1 });
            check(out.v == expected, "a box slides with another velocity")
        }
        Response::Bounce if matches!(start, Body::Rect { .. }) => {
            let turns = |by: fn(&P) -> i64| {
                let on_axis = || (0..axes.len()).filter(|&i| by(&axes[i]) != 0);
                let ends = on_axis().any(|i| path::is_squeezed(&obeyed, i));
                if ends {
                    0
                } else if on_axis().count() % 2 == 0 {
                    1
                } else {
                    -1
                }
            };
            check(out.v == (v.0 * turns(|n| n.0), v.1 * turns(|n| n.1)), "a box bounces with another velocity")
        }
        _ => Ok(()),
    }
}

pub fn offset(from: &Body, to: &Body) -> P {
    let (a, b) = (from.position(), to.position());
    (b.0 - a.0, b.1 - a.1)
}

/// Whether each hit names an existing feature with its flags, and the summary agrees (up is -y; a
/// crossed face is no floor).
fn judge_hits(level: &Level, response: Response, out: &Outcome) -> Result<(), String> {
    let (mut floor, mut wall, mut ceiling, mut flags) = (false, false, false, 0);
    for hit in out.hits.iter() {
        let n: P = (hit.axis.x.into(), hit.axis.y.into());
        let (x, y) = (i64::from(hit.cell.x), i64::from(hit.cell.y));
        // Indices turn from the side toward row 0.
        let sides = [(0, -1), (1, 0), (0, 1), (-1, 0)];
        let side = |k: u16| sides[usize::from(k & 3)];
        let open = |s: P| !level.full(x + s.0, y + s.1);
        let there = if hit.one_way {
            hit.index == 0 && level.one_way(x, y) && n == (0, -1)
        } else if hit.index < 4 {
            level.full(x, y) && open(side(hit.index)) && n == side(hit.index)
        } else {
            let (s, t) = (side(hit.index), side(hit.index + 1));
            level.full(x, y) && open(s) && open(t) && dot(n, s) > 0 && dot(n, t) > 0
        };
        if !there {
            return Err(format!("hit something that is not there: {hit:?}"));
        }
        if hit.flags & level.flags(x, y) != level.flags(x, y) {
            return Err(format!("flags of the cell are missing: {hit:?}"));
        }
        flags |= hit.flags;
        if hit.one_way && response == Response::DropThrough {
            continue;
        }
        if -n.1 >= n.0.abs() {
            floor = true;
        } else if n.1 >= n.0.abs() {
            ceiling = true;
        } else {
            wall = true;
        }
    }
    if (floor, wall, ceiling, flags) == (out.floor, out.wall, out.ceiling, out.flags) {
        Ok(())
    } else {
        Err("floor, wall, ceiling or flags disagree with the hits".to_owned())
    }
}

/// The first hit against the exact first moment: whether there is one, when, and on which side.
pub fn first_hit(level: &Level, body: &Body, d: P, hit: Option<Hit>) -> Result<(), String> {
    let one_way = rect::first_one_way(level, body, d);
    match *body {
        Body::Disc { r, .. } if r > 0 => {
            let Some(hit) = hit else {
                let misses = one_way.is_none() && !disc::enters_solid(level, body, d, Time::END);
                return if misses { Ok(()) } else { Err("missed a hit".to_owned()) };
            };
            let raw = hit.toi.raw();
            let early = if hit.index < 4 { 1 } else { early(d) };
            if disc::enters_solid(level, body, d, Time::parts(raw)) {
                return Err(format!("late: {hit:?}"));
            }
            if one_way.as_ref().is_some_and(|f| f.time.floor() < i64::from(raw)) {
                return Err(format!("late at a one-way face: {hit:?}"));
            }
            if hit.one_way {
                let agrees = one_way.as_ref().is_some_and(|f| f.time.floor() == i64::from(raw));
                return if agrees {
                    Ok(())
                } else {
                    Err(format!("a one-way face at another time: {hit:?}, exact {one_way:?}"))
                };
            }
            // The time of a corner is a lower bound: it may come before a face that is met as much
            // earlier.
            let face = disc::first_face(level, body, d).unwrap_or(Time::END);
            let wrong = if hit.index < 4 {
                disc::enters_corner(level, body, d, face)
            } else {
                let then = Time { num: (face.floor() + 1 + early).min(1 << 30), den: 1 << 30 };
                !disc::enters_corner(level, body, d, then)
            };
            if wrong {
                return Err(format!("a corner instead of a face, or the other way round: {hit:?}"));
            }
            let until = Time { num: (i64::from(raw) + early).min(1 << 30), den: 1 << 30 };
            if disc::enters_solid(level, body, d, until) {
                Ok(())
            } else {
                Err(format!("hit nothing, or early: {hit:?}"))
            }
        }
        _ => {
            let solid = if body.has_area() {
                rect::first_solid(level, body, d)
            } else {
                // The judge skips the side for bodies without area.
                point::first_solid(level, body, d).map(|time| First { time, faces: Vec::new() })
            };
            let exact = First::earlier(solid, one_way);
            let found = hit.map(|h| (i64::from(h.toi.raw()), (i64::from(h.axis.x), i64::from(h.axis.y))));
            let agrees = match (&exact, found) {
                (None, None) => true,
                (Some(f), Some((raw, axis))) => {
                    f.time.floor() == raw && (!body.has_area() || f.normal(d) == Some(axis))
                }
                _ => false,
            };
            if agrees { Ok(()) } else { Err(format!("first hit {found:?}, exact {exact:?}")) }
        }
    }
}

/// Where the first contact stops a body: the exact position for a box, within [`ASIDE`] of it for a
/// circle's corner contact, and not beyond a one-way face that the exact motion has not passed.
pub fn first_place(level: &Level, start: &Body, d: P, touched: &Outcome) -> Result<(), String> {
    let Some(hit) = touched.hits.first() else { return Ok(()) };
    let moved = offset(start, &touched.body);
    // Faces: the normal's axis is exact, the other one is rounded toward the start: from the gap,
    // not from the reported time.
    let exact = if hit.index < 4 {
        let (num, den) = gap(level, start, d, &hit);
        Time::new(num, den).part_of(d)
    } else {
        Time::parts(hit.toi.raw()).part_of(d)
    };
    let aside = (moved.0 - exact.0).abs().max((moved.1 - exact.1).abs());
    let free = !level.overlaps(&start.moved(exact));
    let allowed = match start {
        Body::Rect { .. } => 0,
        Body::Disc { .. } if hit.index < 4 && free => 0,
        Body::Disc { .. } => ASIDE,
    };
    let held = allowed > 0 && is_on_way(moved, exact) && wedged(start, exact);
    if aside > allowed && !held {
        return Err(format!("stopped after {moved:?}, exact {exact:?}"));
    }
    if aside == 0 || matches!(start, Body::Rect { .. }) {
        return Ok(());
    }
    // A face that does not block the exact motion up to here is still entirely below.
    let (_, before) = start.bounds();
    let (_, after) = touched.body.bounds();
    let passed = level.cells_along(start, d).any(|(x, y)| {
        let (a, b) = level.square(x, y);
        let under = start.position().0.min(touched.body.position().0) >= a.0
            && start.position().0.max(touched.body.position().0) <= b.0;
        level.one_way(x, y) && under && before.1 <= a.1 && after.1 > a.1
    });
    if passed { Err("went through a one-way face".to_owned()) } else { Ok(()) }
}

/// Whether a place is on a way, from its start to its end, within the roundings.
fn is_on_way(place: P, way: P) -> bool {
    let off = i128::from(place.0) * i128::from(way.1) - i128::from(place.1) * i128::from(way.0);
    let most = i128::from(ways::PLACE).pow(2) * len2(way);
    off * off <= most && (0..=len2(way)).contains(&dot(place, way))
}

/// A circle that slides along one corner and reaches another may have no free lattice position
/// there. It ends farther back or stays. After `s` along a tangent the first corner is `s^2 / 2r`
/// away: beyond two raw, roundings are no obstacle any more.
fn wedged(body: &Body, exact: P) -> bool {
    let Body::Disc { r, .. } = *body else { return false };
    len2(exact) < 4 * i128::from(r)
}

/// The distance to the face that was hit and the speed on its axis.
fn gap(level: &Level, body: &Body, d: P, hit: &Hit) -> (i64, i64) {
    let (a, b) = level.square(hit.cell.x.into(), hit.cell.y.into());
    let (lo, hi) = body.bounds();
    match hit.index & 3 {
        0 => (a.1 - hi.1, d.1),
        1 => (b.0 - lo.0, d.0),
        2 => (b.1 - lo.1, d.1),
        _ => (a.0 - hi.0, d.0),
    }
}

/// Everything at once, and a report that can be pasted into a test.
pub fn check(level: &Level, mover: Mover, response: Response, body: &Body, v: P) -> Outcome {
    let map = level.map();
    let mover = mover.with_response(response);
    let fail = |what: &str, out: &dyn core::fmt::Debug| -> ! {
        let rows: Vec<_> = level.tiles.chunks(level.width as usize).map(String::from_utf8_lossy).collect();
        panic!(
            "{what}\n{body:?} by {v:?} {response:?}\ncell {} origin {:?} {:?}\n{rows:#?}\n{out:?}",
            level.cell, level.origin, level.outside
        )
    };
    let out = body.step(&mover, &map, v).unwrap_or_else(|e| fail("refused", &e));
    judge(level, body, v, response, &out).unwrap_or_else(|what| fail(&what, &out));
    let touched = body.step(&mover.with_response(Response::Touch), &map, v).unwrap_or_else(|e| fail("refused", &e));
    first_place(level, body, v, &touched).unwrap_or_else(|what| fail(&what, &touched));
    assert!(add(body.position(), offset(body, &out.body)) == out.body.position());
    out
}
