//! Invariants of motion in levels of all shapes, by the numbers of the study they come from: P8,
//! P9, P10, P12, P15, P16, P20, P25.
//!
//! Other files test the rest: P5, P6, P7, P11 and P14 in `motion_shapes` and `motion_symmetry`, P13
//! in `cast`, P17 in `motion_rest`, P18 in `motion_shape_scenes` and `motion_floor`, P19 in
//! `motion_torture_segments`. `TILESAT_CASES` sets the number of motions (default 20 000).

use tilesat::{Axis, Mover, Response, Toi};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::frames::any_capsule;
use tilesat_judge::rooms::room::{FINE, Room};
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);
const TOUCH: Mover = UP.with_response(Response::Touch);

fn cases() -> u64 {
    tilesat_judge::cases(20_000)
}

struct Scene {
    level: Level,
    room: Room,
}

/// Random scenes with a free body, and a motion of up to `tiles` tiles.
fn each(seed: u64, one_way: i64, tiles: i64, mut check: impl FnMut(&mut Random, &Scene, Body, P)) {
    let mut r = Random::new(seed);
    let mut seen = 0;
    while seen < cases() {
        let cell = if r.one_in(2) { 16 * PX } else { 2 * 7 * 64 * r.within(2, 900) };
        let dense = r.within(5, 45);
        let level = mosaic(&mut r, (20, 15), cell, dense, one_way);
        let scene = Scene { room: Room::new(&level), level };
        for _ in 0..100 {
            let size = |r: &mut Random| 2 + r.below(2 * cell);
            let kind = match r.below(3) {
                0 => Body::Rect((0, 0), (size(&mut r), size(&mut r))),
                1 => Body::Disc((0, 0), size(&mut r) / 2),
                _ => any_capsule(&mut r, cell),
            };
            let body = kind.at((r.below(20 * cell), r.below(15 * cell)));
            if !scene.room.overlaps(body, (0, 0), 0) {
                let v = (r.sign() * r.magnitude(tiles * cell), r.sign() * r.magnitude(tiles * cell));
                check(&mut r, &scene, body, v);
                seen += 1;
            }
        }
    }
}

fn step(mover: Mover, s: &Scene, body: Body, v: P) -> Outcome {
    body.step(&mover, &s.level.all(), v).unwrap()
}

/// For a first hit: the kind of surface, and the direction of the normal.
fn first(o: &Outcome) -> Option<(u16, P)> {
    o.hits.first().map(|h| (h.index, (h.axis.x.signum().into(), h.axis.y.signum().into())))
}

/// P8: at twice the size, the same surface is hit first.
#[test]
fn p8_scaling() {
    each(1, 8, 4, |_, s, body, v| {
        let double = |p: P| (2 * p.0, 2 * p.1);
        let large = Level { cell: 2 * s.level.cell, ..s.level.clone() };
        let big = match body {
            Body::Rect(p, size) => Body::Rect(double(p), double(size)),
            Body::Disc(c, r) => Body::Disc(double(c), 2 * r),
            Body::Pill(c, core, r) => Body::Pill(double(c), double(core), 2 * r),
        };
        let (a, b) = (step(TOUCH, s, body, v), big.step(&TOUCH, &large.all(), double(v)).unwrap());
        assert_eq!(a.hits.len(), b.hits.len(), "{body:?} by {v:?}");
        assert_eq!(first(&a).map(|f| f.0), first(&b).map(|f| f.0), "{body:?} by {v:?}");
    });
}

/// P9: turned by a right angle, the same bits. Ties between x and y are separate: x goes first.
#[test]
fn p9_rotation() {
    let mut ties = 0;
    each(2, 0, 4, |_, s, body, v| {
        let turn = |b: Body| View::Transpose.body(View::MirrorY.body(b));
        let way = |p: P| View::Transpose.direction(View::MirrorY.direction(p));
        let level = View::Transpose.level(&View::MirrorY.level(&s.level));
        let up = way((0, -1));
        let mover = Mover::platformer(Axis::new(up.0 as i32, up.1 as i32));
        let (a, b) = (step(UP, s, body, v), turn(body).step(&mover, &level.all(), way(v)).unwrap());
        if (turn(a.body), way(a.v)) != (b.body, b.v) {
            let parts = a.hits.iter().zip(b.hits.iter()).find(|(p, q)| {
                let n = way((p.axis.x.into(), p.axis.y.into()));
                n != (q.axis.x.into(), q.axis.y.into())
            });
            assert!(parts.is_some_and(|(p, q)| p.toi == q.toi), "{body:?} by {v:?}");
            ties += 1;
        }
    });
    println!("{ties} ties");
    assert!(ties <= cases() / 1000);
}

/// P10: moments are in [0, 1]. A longer motion in the same direction meets the same surface no
/// earlier and no later.
#[test]
fn p10_monotone() {
    let mut hits = 0;
    each(3, 8, 4, |r, s, body, v| {
        let Some(short) = step(TOUCH, s, body, v).hits.first() else { return };
        let k = r.within(2, 5);
        let long = step(TOUCH, s, body, (k * v.0, k * v.1)).hits.first().unwrap();
        assert!(short.toi <= Toi::ONE && long.toi <= Toi::ONE);
        let (a, b) = (i64::from(short.toi.raw()), k * i64::from(long.toi.raw()));
        // A unit of each, and a raw unit of way.
        let raw = ((1i128 << 30) * (1i128 << 30) / len2(v).max(1)).isqrt() as i64;
        assert!((a - b).abs() <= k + 8 + 2 * raw, "{body:?} by {v:?} and {k}: {a} {b}");
        hits += 1;
    });
    assert!(hits > cases() / 10);
}

/// P12 and P16: without velocity nothing is hit and nothing moves, wherever a motion has ended.
#[test]
fn p12_p16_without_velocity() {
    let mut rests = 0;
    each(4, 8, 4, |_, s, body, v| {
        let out = step(UP, s, body, v);
        let still = step(UP, s, out.body, (0, 0));
        assert_eq!((still.body, still.v, still.hits.len(), still.work.iterations), (out.body, (0, 0), 0, 0));
        rests += u64::from(out.v == (0, 0));
    });
    assert!(rests > 0);
}

/// P15: if the call was not cut short, the returned velocity leads into no face along x or y that
/// the body touches.
#[test]
fn p15_not_into_what_is_touched() {
    let mut slides = 0;
    each(5, 8, 4, |_, s, body, v| {
        let out = step(UP, s, body, v);
        if out.hits.is_empty() || out.work.iterations == Mover::ITERATIONS {
            return;
        }
        for hit in out.hits.iter().filter(|h| h.axis.x == 0 || h.axis.y == 0) {
            let n: P = (hit.axis.x.into(), hit.axis.y.into());
            if out.v.0 * n.0 + out.v.1 * n.1 < 0 {
                // It has left that face since.
                let there = step(TOUCH, s, out.body, (-n.0, -n.1));
                let same = there.hits.iter().any(|h| h.axis == hit.axis && h.cell == hit.cell && h.index == hit.index);
                assert!(!same, "{body:?} by {v:?}: {out:?}");
            }
        }
        slides += 1;
    });
    assert!(slides > cases() / 10);
}

/// P20: at up to 16 tiles per frame it passes through nothing. The way to the first contact is free
/// at many exact positions, and so is the end.
#[test]
fn p20_no_tunnel_at_sixteen_tiles() {
    let mut hits = 0;
    each(6, 0, 16, |r, s, body, v| {
        let out = step(TOUCH, s, body, v);
        let until = out.hits.first().map_or(1 << 30, |h| i64::from(h.toi.raw())) * FINE / (1 << 30);
        for _ in 0..24 {
            let k = 2 * r.within(0, until / 2);
            assert!(!s.room.overlaps(body, v, k), "{body:?} by {v:?} at {k} of {FINE}");
        }
        assert!(!s.room.overlaps(step(UP, s, body, v).body, (0, 0), 0), "{body:?} by {v:?}");
        hits += u64::from(!out.hits.is_empty());
    });
    assert!(hits > cases() / 5);
}

/// P25: work is limited by the cells under the motion, ten features per cell, and by the
/// iterations.
#[test]
fn p25_work_is_bounded() {
    let mut largest = 0;
    each(7, 8, 8, |_, s, body, v| {
        for response in [Response::Slide, Response::Bounce] {
            let out = step(UP.with_response(response), s, body, v);
            let (lo, hi) = body.bounds();
            let cell = s.level.cell;
            let across = |size: i64, way: i64| (size + way + 2) / cell + 2;
            let longest = len2(v).isqrt() as i64 + 1;
            let (w, h) = (hi.0 - lo.0, hi.1 - lo.1);
            // Pieces are as long as a cell or the body, and overlap by the body's width.
            let pieces = longest / cell.max(w).max(h) + 1;
            let a_piece = across(w, cell.max(w).max(h)) * across(h, cell.max(w).max(h)) * 10;
            let iterations = i64::from(out.work.iterations);
            let bound = a_piece * (2 * pieces + 1) * iterations;
            largest = largest.max(i64::from(out.work.features) * 100 / bound.max(1));
            assert!(i64::from(out.work.features) <= bound, "{} of {bound}: {body:?} by {v:?}", out.work.features);
            assert!(out.work.iterations <= Mover::ITERATIONS && out.work.checks <= 1 + 7 * out.work.iterations);
        }
    });
    println!("at most {largest} % of the bound");
    assert!(largest > 2);
}
