//! Random worlds of all 34 shapes: every frame judged by sets of points of the plane that share nothing with the library.
//!
//! Each frame: no overlap, no overlap on the way to the first contact (P20), never faster (P14), mirrored, transposed and moved worlds give
//! mirrored, transposed and the same bits (P5, P6, P7; full ties apart), and hardly ever is a motion refused that nothing is in the way of. `TILESAT_FRAMES` sets the number of frames (default 100 000).

#![cfg(not(target_os = "none"))]
#![allow(clippy::indexing_slicing, clippy::unwrap_used, clippy::panic, reason = "tests stop at the first surprise")]

mod motion_shape_support;

use motion_shape_support::body::{Body, Outcome};
use motion_shape_support::level::Level;
use motion_shape_support::random::Random;
use motion_shape_support::room::{FINE, Room};
use motion_shape_support::view::View;
use motion_shape_support::{P, PX, len2, mosaic};
use tilesat::{Axis, Mover, Response};

const FRAMES_A_BODY: u64 = 200;
const RESPONSES: [Response; 4] = [Response::Slide, Response::Bounce, Response::Cross, Response::Touch];

fn frames() -> u64 {
    std::env::var("TILESAT_FRAMES").ok().and_then(|n| n.parse().ok()).unwrap_or(100_000)
}

#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    frames: u64,
    hits: u64,
    askew: u64,
    free: u64,
    /// Frames of circles, the rest is of boxes.
    round: u64,
    /// Motions of circles and of boxes that met nothing and were not made: roundings, no obstacles.
    refused: [u64; 2],
    full_iterations: u64,
    at_rest: u64,
    ties: u64,
    /// Hits that left the body where it was although its way was free for more than a unit.
    held: u64,
    features: u64,
}

struct Scene<'a> {
    level: &'a Level,
    room: &'a Room,
    body: Body,
    v: P,
    response: Response,
}

fn mover(up: P, response: Response) -> Mover {
    Mover::platformer(Axis::new(up.0 as i32, up.1 as i32)).with_response(response)
}

fn describe(s: &Scene, what: &str) -> String {
    let rows: Vec<_> = s.level.tiles.chunks(s.level.width as usize).collect();
    format!(
        "{what}: {:?} by {:?} {:?}, cell {} at {:?}\n{rows:?}",
        s.body,
        s.v,
        s.response,
        s.level.cell,
        (s.level.x, s.level.y)
    )
}

/// The first contact: the way to it is free, at sixteen exact places.
fn judge_way(r: &mut Random, s: &Scene, tally: &mut Tally) {
    let touch = s.body.step(&mover((0, -1), Response::Touch), &s.level.all(), s.v).unwrap();
    assert!(!s.room.overlaps(touch.body, (0, 0), 0), "{}", describe(s, "stops inside"));
    let one = i64::from(1 << 30);
    let until = touch.hits.first().map_or(one, |h| i64::from(h.toi.raw())) * FINE / one;
    for _ in 0..16 {
        let k = 2 * r.within(0, until / 2);
        assert!(!s.room.overlaps(s.body, s.v, k), "{}", describe(s, "passes through"));
    }
    if until > FINE / 2 && touch.body == s.body && len2(s.v) > (4 * PX as i128).pow(2) {
        tally.held += 1;
    }
}

/// All but the names of cells and the work.
type Bits = (Body, P, P, [bool; 3], Vec<(u32, P, bool)>);

fn bits(out: &Outcome, view: Option<View>) -> Bits {
    let turn = |p: P| view.map_or(p, |v| v.direction(p));
    let hits = out.hits.iter().map(|h| (h.toi.raw(), turn((h.axis.x.into(), h.axis.y.into())), h.one_way));
    let body = view.map_or(out.body, |v| v.body(out.body));
    (body, turn(out.v), turn(out.remaining), [out.floor, out.wall, out.ceiling], hits.collect())
}

fn judge_views(s: &Scene, out: &Outcome, views: &[View], tally: &mut Tally) {
    for &view in views {
        let level = view.level(s.level);
        let seen =
            view.body(s.body).step(&mover(view.direction((0, -1)), s.response), &level.all(), view.direction(s.v));
        let (seen, expected) = (bits(&seen.unwrap(), None), bits(out, Some(view)));
        if seen != expected {
            // A full tie: other surfaces at the same moment. What is reported first may differ; the end only where x goes before y.
            let parts = seen.4.iter().zip(&expected.4).find(|(a, b)| a != b);
            let tie = parts.is_some_and(|(a, b)| a.0 == b.0 && len2(a.1) == len2(b.1))
                && (view == View::Transpose || (seen.0, seen.1, seen.2) == (expected.0, expected.1, expected.2));
            // Of two lattice vectors equally near to a bounce one goes first, by coordinate.
            let near = |p: P, q: P| (p.0 - q.0).abs().max((p.1 - q.1).abs()) <= 1;
            let bounce = view == View::Transpose && s.response == Response::Bounce && near(seen.1, expected.1);
            assert!(
                (tie || bounce) && !matches!(view, View::Moved(_)),
                "{}\n{seen:?}\n{expected:?}",
                describe(s, &format!("{view:?}"))
            );
            tally.ties += 1;
        }
    }
}

fn frame(r: &mut Random, s: &Scene, views: &[View], tally: &mut Tally) -> Outcome {
    let out = s.body.step(&mover((0, -1), s.response), &s.level.all(), s.v);
    let out = out.unwrap_or_else(|e| panic!("{}", describe(s, &format!("{e:?}"))));
    assert!(!s.room.overlaps(out.body, (0, 0), 0), "{}", describe(s, "ends inside"));
    assert!(len2(out.v) <= len2(s.v), "{}", describe(s, "is faster"));
    let round = matches!(s.body, Body::Disc(..));
    tally.round += u64::from(round);
    assert!(out.hits.len() as u32 <= out.work.iterations && out.work.iterations <= Mover::ITERATIONS);
    if out.hits.is_empty() {
        assert_eq!((out.v, out.remaining), (s.v, (0, 0)), "{}", describe(s, "lost something"));
        tally.refused[usize::from(!round)] += u64::from(out.body != s.body.moved(s.v));
    }
    judge_way(r, s, tally);
    judge_views(s, &out, views, tally);
    tally.frames += 1;
    tally.hits += out.hits.len() as u64;
    tally.askew += out.hits.iter().filter(|h| h.axis.x != 0 && h.axis.y != 0).count() as u64;
    tally.free += u64::from(out.hits.is_empty());
    tally.full_iterations += u64::from(out.work.iterations == Mover::ITERATIONS);
    tally.at_rest += u64::from(out.v == (0, 0));
    tally.features += u64::from(out.work.features);
    out
}

fn any_velocity(r: &mut Random, fastest: i64) -> P {
    let raw = fastest * PX;
    match r.below(6) {
        0 => (r.around(fastest) * PX, r.around(fastest) * PX),
        1 => (r.around(raw), 0),
        2 => (0, r.around(raw)),
        3 => {
            let v = r.around(raw);
            (v, v * r.sign())
        }
        4 => (r.sign() * r.magnitude(raw), r.sign() * r.magnitude(raw)),
        _ => (r.around(raw), r.around(raw)),
    }
}

fn any_body(r: &mut Random, cell: i64) -> Body {
    let size = |r: &mut Random| match r.below(4) {
        0 => 20 * PX,
        1 => 2 + r.magnitude(cell),
        2 => cell,
        _ => 2 + r.below(3 * cell),
    };
    if r.one_in(3) { Body::Rect((0, 0), (size(r), size(r))) } else { Body::Disc((0, 0), (size(r) / 2).max(1)) }
}

fn run(r: &mut Random, level: &Level, fastest: i64, tally: &mut Tally) {
    let room = Room::new(level);
    let kind = any_body(r, level.cell);
    let Some(mut body) = (0..100).find_map(|_| {
        let at = (level.x + r.below(level.width * level.cell), level.y + r.below(level.height * level.cell));
        let there = kind.at(if r.one_in(2) { at } else { (at.0 & !0xffff, at.1 & !0xffff) });
        (!room.overlaps(there, (0, 0), 0)).then_some(there)
    }) else {
        return;
    };
    let response = RESPONSES[[0, 0, 0, 1, 2, 3][r.below(6) as usize]];
    let gravity = if r.one_in(2) { PX / 4 } else { 0 };
    let by = (r.around(1000 * PX), r.around(1000 * PX));
    let mut v = any_velocity(r, fastest);
    for k in 0..FRAMES_A_BODY {
        if len2(v) < 1 << 16 || r.one_in(20) || v.0.abs().max(v.1.abs()) > fastest * PX {
            v = any_velocity(r, fastest);
        }
        v.1 = (v.1 + gravity).min(fastest * PX);
        let all = [View::MirrorX, View::Moved(by), View::MirrorY, View::Transpose];
        let views = &all[(k % 4) as usize..=(k % 4) as usize];
        let out = frame(r, &Scene { level, room: &room, body, v, response }, views, tally);
        (body, v) = (out.body, out.v);
    }
}

fn worlds(seed: u64, frames: u64, fastest: i64) -> Tally {
    let mut r = Random::new(seed);
    let mut tally = Tally::default();
    while tally.frames < frames {
        let cell = match r.below(3) {
            0 => 16 * PX,
            1 => 24 * PX,
            _ => 2 * 7 * 64 * r.within(2, 900),
        };
        let (dense, one_way) = (if r.one_in(2) { 25 } else { r.within(5, 60) }, if r.one_in(2) { 0 } else { 8 });
        let level = mosaic(&mut r, (16, 12), cell, dense, one_way);
        for _ in 0..4 {
            run(&mut r, &level, (fastest * cell / (16 * PX)).max(1), &mut tally);
        }
    }
    println!("{tally:?}");
    tally
}

#[test]
fn random_worlds() {
    let tally = worlds(1, frames() / 2, 60);
    assert!(tally.hits > tally.frames / 4 && tally.askew > tally.hits / 8);
    few_refused(&tally);
}

/// At most 20 in a million frames.
fn few_refused(tally: &Tally) {
    assert!(tally.refused[0] + tally.refused[1] <= tally.frames / 50_000, "{tally:?}");
    assert!(tally.round > tally.frames / 4 && tally.round < tally.frames * 9 / 10, "{tally:?}");
}

#[test]
fn walking_speed() {
    let tally = worlds(100, frames() / 2, 4);
    assert!(tally.hits > tally.frames / 8 && tally.askew > tally.hits / 8);
    few_refused(&tally);
}
