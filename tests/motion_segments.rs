//! Bodies among random polygons, walls and one-way chains, judged by the polygons as they were given.
//!
//! Each frame: no overlap, none on the way to the first contact, never faster, and a contact is followed by an overlap if the motion goes on.
//! `TILESAT_FRAMES` sets the number of frames (default 20 000).

#![cfg(not(target_os = "none"))]
#![allow(clippy::indexing_slicing, clippy::unwrap_used, clippy::panic, reason = "tests stop at the first surprise")]

mod segment_world_support;

use segment_world_support::random::Random;
use segment_world_support::{Body, P, Piece, Scene, Shape, build};
use tilesat::{Aabb, Axis, Circle, Fx, MoveError, Moved, Mover, PathKind, Response, SegmentMap, Vec2};

fn frames() -> u64 {
    std::env::var("TILESAT_FRAMES").ok().and_then(|n| n.parse().ok()).unwrap_or(20_000)
}

fn at(body: Body, by: P) -> Body {
    let add = |p: P| (p.0 + by.0, p.1 + by.1);
    match body {
        Body::Box { lo, hi } => Body::Box { lo: add(lo), hi: add(hi) },
        Body::Circle { c, r } => Body::Circle { c: add(c), r },
    }
}

fn place(body: Body) -> P {
    match body {
        Body::Box { lo, .. } => lo,
        Body::Circle { c, .. } => c,
    }
}

fn len2(v: P) -> i128 {
    v.0 * v.0 + v.1 * v.1
}

/// Where a call leads, its velocity, whether it hit anything solid or anything, and the part of the motion before.
struct Step {
    body: Body,
    v: P,
    solid: bool,
    free: bool,
    toi: i128,
}

fn step(scene: &Scene, map: &SegmentMap, mover: &Mover, body: Body, v: P) -> Result<Step, MoveError> {
    let velocity = Vec2::from_raw(v.0 as i32, v.1 as i32);
    match body {
        Body::Box { lo, hi } => {
            let b = Aabb::new(scene.vec2(lo), scene.vec2(hi)).unwrap();
            mover.move_and_slide(map, &b, velocity).map(|m| made(scene, body, &m))
        }
        Body::Circle { c, r } => {
            let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
            mover.move_and_slide(map, &b, velocity).map(|m| made(scene, body, &m))
        }
    }
}

fn made<B: tilesat::Body>(scene: &Scene, body: Body, m: &Moved<B>) -> Step {
    let (p, q) = (place(body), scene.local(m.position()));
    let (x, y) = m.velocity.raw();
    let first = m.hits.first();
    Step {
        body: at(body, (q.0 - p.0, q.1 - p.1)),
        v: (x.into(), y.into()),
        solid: first.is_some_and(|h| !h.one_way),
        free: first.is_none(),
        toi: first.map_or(1 << 30, |h| h.toi.raw().into()),
    }
}

#[derive(Debug, Default)]
struct Tally {
    frames: u64,
    hits: u64,
    refused: u64,
    unconfirmed: u64,
    at_rest: u64,
}

/// The first contact: sixteenths of the way are free, and a little farther it overlaps.
fn judge_way(scene: &Scene, blocking: &[Piece], map: &SegmentMap, body: Body, v: P, tally: &mut Tally) {
    let touch = step(scene, map, &Mover::new().with_response(Response::Touch), body, v).unwrap();
    for k in (0..=16).filter(|k| k << 26 <= touch.toi) {
        // Sixteenths are places of the lattice.
        let there = at(body, (v.0 / 16 * k, v.1 / 16 * k));
        assert!(!scene.overlaps(blocking, there), "passes through: {scene:?} {body:?} by {v:?}");
    }
    if touch.solid {
        let length = len2(v).isqrt().max(1);
        let confirmed = [2, 4, 8, 32, 128].iter().any(|k| {
            let far = |d: i128| (d * k * 2 + d.signum() * length) / (2 * length);
            scene.overlaps(blocking, at(touch.body, (far(v.0), far(v.1))))
        });
        tally.unconfirmed += u64::from(!confirmed);
    }
}

/// Whether there is solid behind every edge. Where a polygon crosses itself, or a hole is in nothing, there are edges that only stop a body from one
/// side, and that none may rest on.
fn is_proper(scene: &Scene) -> bool {
    let cross = |o: P, a: P, b: P| (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0);
    let apart = |p: P, q: P, a: P, b: P| cross(a, b, p).signum() * cross(a, b, q).signum() > 0;
    let between = |p: P, a: P, b: P| {
        let inside = |p: i128, a: i128, b: i128| a.min(b) <= p && p <= a.max(b);
        cross(a, b, p) == 0 && inside(p.0, a.0, b.0) && inside(p.1, a.1, b.1)
    };
    scene.shapes.iter().all(|s| match s.kind {
        PathKind::Solid => {
            let edges = s.edges();
            let n = edges.len();
            (0..n).all(|i| {
                (0..n).filter(|j| *j != i).all(|j| {
                    let ((a, b), (p, q)) = (edges[i], edges[j]);
                    // Neighbours share an end, and nothing else.
                    let (next, before) = (j == (i + 1) % n, i == (j + 1) % n);
                    if next || before {
                        let far = if next { q } else { p };
                        return !between(far, a, b) && !between(if next { a } else { b }, p, q);
                    }
                    let meet = !apart(p, q, a, b) && !apart(a, b, p, q);
                    !meet || (cross(a, b, p) == 0 && cross(a, b, q) == 0 && !between(p, a, b) && !between(q, a, b))
                })
            })
        }
        PathKind::Hole => false,
        _ => true,
    })
}

fn run(r: &mut Random, tally: &mut Tally) {
    let scene = build::scene(r);
    if !is_proper(&scene) {
        return;
    }
    let bytes = scene.bytes();
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let blocking = scene.blocking();
    if blocking.is_empty() {
        return;
    }
    let (lo, hi) = scene.bounds();
    let size = (hi.0 - lo.0).max(hi.1 - lo.1) as i64;
    for _ in 0..12 {
        let Some(mut body) = (0..60).map(|_| scene.body(r)).find(|b| b.has_area() && !scene.overlaps(&blocking, *b))
        else {
            continue;
        };
        let response = [Response::Slide, Response::Slide, Response::Bounce, Response::Cross][r.below(4) as usize];
        let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
        let mut v = (0, 0);
        for k in 0..60 {
            if len2(v) < 64 || k % 4 == 0 {
                // Toward an edge and beyond, or anywhere.
                let p = place(body);
                let any = |r: &mut Random| i128::from(r.sign() * r.magnitude(size));
                let end = blocking[r.below(blocking.len() as i64) as usize].a;
                let far = i128::from(1 + r.below(3));
                v = if r.one_in(4) {
                    (any(r), any(r))
                } else {
                    (far * (end.0 - p.0) + any(r) / 8, far * (end.1 - p.1) + any(r) / 8)
                };
            }
            v = (v.0 / 16 * 16, (v.1 + i128::from(size / 64)) / 16 * 16);
            let Ok(out) = step(&scene, &map, &mover, body, v) else { break };
            let case = || format!("{scene:?} {body:?} by {v:?} {response:?}");
            assert!(!scene.overlaps(&blocking, out.body), "ends inside: {}", case());
            assert!(len2(out.v) <= len2(v), "is faster: {}", case());
            judge_way(&scene, &blocking, &map, body, v, tally);
            tally.frames += 1;
            tally.hits += u64::from(!out.free);
            tally.at_rest += u64::from(out.v == (0, 0));
            tally.refused += u64::from(out.free && place(out.body) != place(at(body, v)));
            (body, v) = (out.body, out.v);
            let p = place(body);
            if (p.0 - lo.0).abs().max((p.1 - lo.1).abs()) > 4 * i128::from(size) {
                break;
            }
        }
    }
}

#[test]
fn random_polygons() {
    let (mut r, mut tally) = (Random::new(11), Tally::default());
    while tally.frames < frames() {
        run(&mut r, &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8);
    assert!(tally.refused <= tally.frames / 1000, "{tally:?}");
    assert!(tally.unconfirmed <= tally.hits / 20, "{tally:?}");
}

/// A body that lands on a one-way slope slides down it to a wall or a kink and rests; roundings at what it meets there never push it through.
#[test]
fn one_way_slopes_carry() {
    let (mut r, mut rested) = (Random::new(12), 0);
    for _ in 0..frames() / 50 {
        let unit = 1 << 10;
        let at = |r: &mut Random| i128::from(r.within(1, 15)) * unit;
        // From left to right, its normal up (y down): down to the kink and up again, or to the wall at the right.
        let kink = (8 * unit + at(&mut r) / 4, 12 * unit + at(&mut r) / 8);
        let chain = vec![(0, at(&mut r) / 2), kink, (16 * unit, if r.one_in(2) { 20 * unit } else { at(&mut r) / 2 })];
        let rect = |x: i128, y: i128, w: i128, h: i128| vec![(x, y), (x + w, y), (x + w, y + h), (x, y + h)];
        let shape = |kind, points| Shape { kind, flags: 0, points };
        let walls = [rect(-unit, -64 * unit, unit, 88 * unit), rect(16 * unit, -64 * unit, unit, 88 * unit)];
        let mut shapes: Vec<Shape> = walls.map(|w| shape(PathKind::Solid, w)).into();
        shapes.push(shape(PathKind::OneWay, chain.clone()));
        let scene = Scene { shapes, origin: (0, 0), cell: 4096, grid: None };
        let bytes = scene.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let size = i128::from(r.within(2, 3 * unit as i64));
        let c = (3 * unit + at(&mut r) / 2, -6 * unit);
        let mut body = if r.one_in(2) {
            Body::Circle { c, r: size / 2 + 1 }
        } else {
            Body::Box { lo: c, hi: (c.0 + size, c.1 + size) }
        };
        let (mut v, gravity) = ((i128::from(r.around(unit as i64)), 0), i128::from(r.within(1, 400)));
        for _ in 0..300 {
            v.1 += gravity;
            let out = step(&scene, &map, &Mover::platformer(Axis::NEG_Y), body, v).unwrap();
            (body, v) = (out.body, out.v);
        }
        // Still in front of the slope that is under its middle.
        let (lo, hi) = body.bounds();
        let (x, y) = (i128::midpoint(lo.0, hi.0), i128::midpoint(lo.1, hi.1));
        let (a, b) = if x <= kink.0 { (chain[0], kink) } else { (kink, chain[2]) };
        let height = |p: P| (b.1 - a.1) * (p.0 - a.0) - (p.1 - a.1) * (b.0 - a.0);
        assert!(height((x, y)) > 0, "fell through {chain:?}: {body:?}");
        rested += u64::from(v == (0, 0));
    }
    assert!(rested > frames() / 100, "{rested}");
}
