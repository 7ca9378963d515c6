//! What a circle or a capsule among blocks may do at a hit, from its place alone. Where it stops,
//! nothing leads on; and it keeps the longest part of its velocity that leads on.
//!
//! All in integers. Velocities have [`BITS`] bits below a raw unit, and each projection errs by
//! less than one of those.

use super::body::{Body, Outcome};
use super::level::Level;
use super::{P, Time, add, disc, dot, len2, rect};
use tilesat::{Hit, Mover, Response};

const BITS: u32 = 16;
/// A velocity, in parts of a raw unit. They are below 2^46, normals below 2^31: products below
/// 2^109.
type V = (i128, i128);

/// How far a way is free that counts as one, raw: twice the 64 up to which what is touched may bind
/// it.
const WAY: i64 = 128;
/// A corner that is farther than this from the body is not touched: the rounding distance of 4 raw,
/// and as much for the body's own place.
pub const TOUCH: i64 = 8;
/// A way must be faster than 4 raw along x or y, after its tangent was shortened by 2 raw for its
/// roundings: `2 + 5 sqrt 2 < 10`.
pub const SLOWEST: u8 = 10;
const SLOW: i128 = (SLOWEST as i128) << BITS;

fn fine(v: P) -> V {
    (i128::from(v.0) << BITS, i128::from(v.1) << BITS)
}

fn part(v: V, d: P) -> i128 {
    v.0 * i128::from(d.0) + v.1 * i128::from(d.1)
}

/// `v` without its part into a plane.
fn along(v: V, n: P) -> V {
    if part(v, n) < 0 { on(v, n) } else { v }
}

/// `v` without its part along a normal.
fn on(v: V, n: P) -> V {
    let (into, square) = (part(v, n), len2(n));
    (v.0 - into * i128::from(n.0) / square, v.1 - into * i128::from(n.1) / square)
}

/// `a / sqrt(square)`, rounded away from zero or toward it.
fn over_root(a: i128, square: i128, away: bool) -> i64 {
    let size = (a * a / square).isqrt();
    let size = size + i128::from(away && size * size * square != a * a);
    (size * a.signum()) as i64
}

/// Whether a displacement leads into the solid, or into the front of a one-way face.
fn is_blocked(level: &Level, body: &Body, d: P, response: Response) -> bool {
    let one_way = || response != Response::DropThrough && rect::first_one_way(level, body, d).is_some();
    disc::enters_solid(level, body, d, Time::END) || one_way()
}

/// From a point to the nearest one of a body's core.
pub fn from_corner(body: &Body, p: P) -> P {
    let Body::Disc { c, core, .. } = *body else { panic!("a circle is needed") };
    let end = add(c, core);
    (p.0.clamp(c.0, end.0) - p.0, p.1.clamp(c.1, end.1) - p.1)
}

/// A direction that may lead on, exactly, and a way of [`WAY`] along it, rounded away from the
/// corner that it passes.
type Direction = (P, P);

/// From the corners of full cells that a body touches to the body.
fn corners(level: &Level, body: &Body, r: i64) -> Vec<P> {
    let (lo, hi) = body.bounds();
    let square = |by: i64| i128::from((r + by).max(0)).pow(2);
    let cells = level.cells((lo.0 - TOUCH, lo.1 - TOUCH), (hi.0 + TOUCH, hi.1 + TOUCH));
    let all = cells.filter(|&(x, y)| level.full(x, y)).flat_map(|(x, y)| {
        let (a, b) = level.square(x, y);
        [a, b, (a.0, b.1), (b.0, a.1)].map(|p| from_corner(body, p))
    });
    let touched = |n: &P| len2(*n) > 0 && (square(-TOUCH)..=square(TOUCH)).contains(&len2(*n));
    all.filter(touched).collect()
}

/// The gaps between corners on both sides of a body: each leads across the line through both.
fn gaps(of: &[P]) -> Vec<P> {
    let pairs = of.iter().flat_map(|a| of.iter().map(move |b| (*a, *b)));
    pairs.filter(|&(a, b)| a < b && dot(a, b) < 0).map(|(a, b)| (a.0 - b.0, a.1 - b.1)).collect()
}

/// Along x and y, the tangents of the corners that are touched, and the gaps between those.
fn directions(level: &Level, body: &Body, r: i64) -> Vec<Direction> {
    let mut all: Vec<_> = [(WAY, 0), (-WAY, 0), (0, WAY), (0, -WAY)].map(|d| (d, d)).into();
    let mut add = |n: P| all.extend([(-n.1, n.0), (n.1, -n.0)].map(|t| (t, tangent(t, n))));
    let corners = corners(level, body, r);
    gaps(&corners).into_iter().for_each(&mut add);
    corners.into_iter().for_each(add);
    all
}

/// A way of [`WAY`] along a tangent, rounded to the side of the normal.
fn tangent(t: P, n: P) -> P {
    let of = |c: i64, n: i64| {
        let away = i128::from(c) * i128::from(n) > 0;
        over_root(i128::from(c) * i128::from(WAY), len2(t), away)
    };
    (of(t.0, n.0), of(t.1, n.1))
}

fn axis(hit: &Hit) -> P {
    (hit.axis.x.into(), hit.axis.y.into())
}

fn obeyed(response: Response, out: &Outcome) -> impl Iterator<Item = &Hit> {
    out.hits.iter().filter(move |hit| response != Response::DropThrough || !hit.one_way)
}

/// The error of a velocity by the roundings of some hits, in parts: of each 8 raw, a part in 2^24
/// of the velocity for unit vectors, and what a corner's tangent turns.
///
/// The place at a corner is [off](off_place). That turns the tangent by `off / rho`, and a velocity
/// along it by less than `off |v| / rho`.
fn rounding<'h>(v: P, out: &Outcome, hits: impl Iterator<Item = &'h Hit>) -> i128 {
    let length = (len2(v) << (2 * BITS)).isqrt() + 1;
    let off = i128::from(off_place(out));
    let turn = |hit: &Hit| if hit.index < 4 { 0 } else { off * length / len2(axis(hit)).isqrt() };
    hits.map(|hit| (8 << BITS) + (length >> 24) + turn(hit)).sum()
}

/// How far roundings may put a body from the place of its hit, raw: up to 2 raw on each axis,
/// `2 sqrt 2 < 3` in all.
pub const PLACE: u8 = 3;

/// How far a body may be from the place of its hit, raw. A body that no way is free for creeps up
/// to 64 more, and needs one look more than its hits and the rest of its way.
pub fn off_place(out: &Outcome) -> u8 {
    if out.work.iterations as usize > out.hits.len() + 1 { PLACE + 64 } else { PLACE }
}

/// The hits before the place of the last one.
///
/// The time that a hit uses is rounded up, by less than one part of 2^30. So what a body touches at
/// the place of the hit is reported up to one part later, and one more for each hit between them.
fn before_place(out: &Outcome) -> impl Iterator<Item = &Hit> {
    let last = out.hits.iter().last().map_or(0, |hit| hit.toi.raw());
    let to_last = (0..out.hits.len() as u32).rev();
    out.hits.iter().zip(to_last).filter(move |(hit, to_last)| hit.toi.raw() + to_last < last).map(|(hit, _)| hit)
}

/// The velocities that a body may have come to its last hit with, and their error: what the hits
/// before leave of that of the call, one after the other, what leads across the gap between two of
/// them, and what a corner that it [touched at first](at_first) leaves before them.
fn before_last(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> (Vec<V>, i128) {
    let before = || before_place(out).filter(|hit| response != Response::DropThrough || !hit.one_way);
    let normals: Vec<P> = before().map(axis).collect();
    let after = |u: V| normals.iter().fold(u, |u, n| along(u, *n));
    let mut all = vec![after(fine(v))];
    all.extend(gaps(&normals).into_iter().map(|gap| on(fine(v), gap)));
    all.extend(at_first(level, start, v, out).into_iter().map(|n| after(along(fine(v), n))));
    (all, rounding(v, out, before()))
}

/// Whether more than `least` of a velocity is along a direction.
fn is_along(u: V, t: P, least: i128) -> bool {
    part(u, t) > least * (len2(t).isqrt() + 1)
}

/// A body that ends without velocity ends where no direction leads on in which the call's velocity
/// and all that [it may have had](before_last) before its last hit have a part.
///
/// A part of less than [`SLOW`] is no way. A corner that the body turned round since may leave the
/// latter a part against the former: nothing pushes it that way.
pub fn stops_rightly(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let Body::Disc { r, .. } = out.body else { return Ok(()) };
    if r == 0 || out.v != (0, 0) || out.hits.is_empty() || level.overlaps(&out.body) {
        return Ok(());
    }
    let (before, error) = before_last(level, start, v, response, out);
    let has = |t: P| before.iter().all(|u| is_along(*u, t, SLOW + error)) && is_along(fine(v), t, SLOW);
    // Both: beside the end of a face the tangent of its corner may lead into the face by a part of
    // a raw unit, which is gone when it is rounded.
    let mut ways = directions(level, &out.body, r).into_iter().filter(|way| has(way.0) && has(way.1));
    match ways.find(|way| !is_blocked(level, &out.body, way.1, response)) {
        Some((_, d)) => Err(format!("stops where {d:?} is free")),
        None => Ok(()),
    }
}

/// A velocity that is left is, within the roundings, the longest free part of what some of the hits
/// leave of the call's. The body has made all of the way that it had time for.
///
/// Which of the hits are still touched at the last one may be decided by a raw unit. That it is
/// some of them may not, and what it goes on along is one plane that it touches there.
pub fn keeps_the_longest(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let Body::Disc { r, .. } = out.body else { return Ok(()) };
    if out.v == (0, 0) {
        return Ok(());
    }
    let hits: Vec<P> = obeyed(response, out).map(axis).collect();
    let at = place_of_last(response, out).map_or(out.body, |(at, _)| at);
    let touched = corners(level, &at, r);
    // What it came with: at each hit it went on along one of the planes that it had met, along a
    // face that ends at one of their corners, or across the gap between two of them.
    let ends = |n: P| [n, (n.0.signum(), 0), (0, n.1.signum())].into_iter().filter(|n| *n != (0, 0));
    let of_first = at_first(level, start, v, out);
    let mut came = vec![fine(v)];
    for k in 1..=hits.len() {
        let met: Vec<P> = of_first.iter().chain(hits.iter().take(k)).copied().collect();
        let planes: Vec<P> = gaps(&met).into_iter().chain(met.into_iter().flat_map(ends)).collect();
        let more: Vec<V> = came.iter().flat_map(|u| planes.iter().map(|n| on(*u, *n))).collect();
        came.extend(more);
        came.sort_unstable();
        came.dedup();
    }
    // What it goes on along: nothing, a face, a corner, or the gap between two corners.
    let mut planes: Vec<P> = vec![(1, 0), (0, 1)];
    let both: Vec<P> = hits.iter().copied().chain(touched).collect();
    planes.extend(gaps(&both));
    planes.extend(both);
    // A corner that was hit before, and that the way still touches: its tangent has turned since.
    for hit in obeyed(response, out).filter(|hit| hit.index >= 4) {
        let m = from_corner(&out.body, corner(level, hit));
        let across = i128::from(out.v.0) * i128::from(m.1) - i128::from(out.v.1) * i128::from(m.0);
        let from_line = over_root(across.abs(), len2(out.v), false);
        if (from_line - r).abs() <= TOUCH {
            planes.push((-out.v.1, out.v.0));
        }
    }
    let error = rounding(v, out, out.hits.iter());
    let is = |p: &V| {
        let o = fine(out.v);
        (o.0 - p.0).abs() <= error && (o.1 - p.1).abs() <= error
    };
    let explains = |u: &&V| is(u) || planes.iter().any(|n| is(&on(**u, *n)));
    let bases: Vec<&V> = came.iter().filter(explains).collect();
    if bases.is_empty() {
        return Err(format!("goes on by {:?}, no part of {v:?}", out.v));
    }
    let longer: Vec<_> = bases.iter().map_while(|u| longer_way(level, v, **u, response, out)).collect();
    if longer.len() == bases.len() {
        return Err(format!("goes on by {:?} where {longer:?} is free and longer", out.v));
    }
    makes_its_way(level, v, response, out)
}

/// The corners that a body touches where it first hits something, which need not be reported.
fn at_first(level: &Level, start: &Body, v: P, out: &Outcome) -> Vec<P> {
    let (Some(hit), Body::Disc { r, .. }) = (out.hits.first(), *start) else { return Vec::new() };
    corners(level, &start.moved(Time::parts(hit.toi.raw()).part_of(v)), r)
}

/// Whether it touches a corner there beside what it hits: by 16 raw or more of the corner's circle,
/// which is more than the place is rounded by.
pub fn touches_another_at_first(level: &Level, start: &Body, v: P, out: &Outcome) -> bool {
    let Some(hit) = out.hits.first() else { return false };
    let n = axis(&hit);
    let aside = |m: &P| dot(*m, (-n.1, n.0)).abs();
    at_first(level, start, v, out).iter().any(|m| aside(m) > 16 * len2(n).isqrt())
}

/// The place of the last hit, if the body has moved on from there by its velocity alone.
pub fn place_of_last(response: Response, out: &Outcome) -> Option<(Body, Hit)> {
    let last = *out.hits.iter().last()?;
    let is_last = out.hits.len() < Mover::ITERATIONS as usize && out.remaining == (0, 0);
    if !is_last || out.v == (0, 0) || (response == Response::DropThrough && last.one_way) {
        return None;
    }
    let left = Time::parts((1 << 30) - last.toi.raw());
    let made = left.part_of(out.v);
    Some((out.body.moved((-made.0, -made.1)), last))
}

/// The way since the last hit, made backwards, leads to what was hit within the roundings. A place
/// is rounded by 2 raw on each axis, `2 sqrt 2 < 3`.
fn makes_its_way(level: &Level, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let (Some((at, last)), Body::Disc { r, .. }) = (place_of_last(response, out), out.body) else { return Ok(()) };
    // For a face any point of its line, for a corner the corner: both lie to the side to which the
    // normal points.
    let (p, n) = (corner(level, &last), axis(&last));
    let m = from_corner(&at, p);
    let distance = if last.index < 4 { dot(m, n) } else { len2(m).isqrt() };
    let off = (distance - i128::from(r)).abs();
    let most = (rounding(v, out, out.hits.iter()) >> BITS) + 3;
    // A circle that has come a way `s` round a corner is `s^2 / 2r` off it. Up to two raw there may
    // be no free place on the lattice, and it stays at the corner: `s = 2 sqrt r`.
    let on_corner = |hit: &Hit| {
        let from = len2(from_corner(&at, corner(level, hit))).isqrt() - i128::from(r);
        hit.index >= 4 && from.abs() <= i128::from(TOUCH)
    };
    let stays =
        off <= most + i128::from(4 * r).isqrt() && obeyed(response, out).any(|hit| *hit != last && on_corner(hit));
    if off <= most || stays { Ok(()) } else { Err(format!("has not made its way: {off} off")) }
}

/// A longer way than the one taken that leads on from the place of the last hit, of which both the
/// call's velocity and the one before that hit have more.
///
/// The place is known within the roundings of the way since. So a way counts as free if it is from
/// all free places within 3 raw units of it.
fn longer_way(level: &Level, v: P, u: V, response: Response, out: &Outcome) -> Option<P> {
    let (at, _) = place_of_last(response, out)?;
    let Body::Disc { r, .. } = at else { return None };
    let taken = (len2(out.v) << (2 * BITS)).isqrt();
    let least = SLOW + rounding(v, out, out.hits.iter()) + taken;
    let has = |t: P| is_along(u, t, least) && is_along(fine(v), t, least);
    let around = (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y)));
    let places: Vec<Body> = around.map(|by| at.moved(by)).filter(|body| !level.overlaps(body)).collect();
    let longer = directions(level, &at, r).into_iter().filter(|way| has(way.0) && has(way.1));
    let is_free = |d: P| !places.is_empty() && places.iter().all(|p| !is_blocked(level, p, d, response));
    longer.map(|way| way.1).find(|d| is_free(*d))
}

/// The corner of the cell that was hit, to the side of the normal.
pub fn corner(level: &Level, hit: &Hit) -> P {
    let (a, b) = level.square(hit.cell.x.into(), hit.cell.y.into());
    (if hit.axis.x > 0 { b.0 } else { a.0 }, if hit.axis.y > 0 { b.1 } else { a.1 })
}
