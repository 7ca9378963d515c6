//! Bodies among random polygons, walls and one-way chains. The original polygons judge them.
//!
//! In each frame: no overlap, none on the way to the first contact, and no gain of speed. After a
//! contact there would be an overlap if the motion went on. `TILESAT_FRAMES` sets the number of
//! frames (default 20 000).

use tilesat::{Axis, Mover, PathKind, Response, SegmentMap};
use tilesat_judge::Random;
use tilesat_judge::segments::frames::{Tally, at, is_proper, judge_way, len2, place, step};
use tilesat_judge::segments::{Body, P, Scene, Shape, build};

fn frames() -> u64 {
    tilesat_judge::frames(20_000)
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
        let response = [Response::Slide, Response::Slide, Response::Bounce, Response::DropThrough][r.below(4) as usize];
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

/// A body that lands on a one-way slope slides down it to a wall or a kink and rests. Roundings
/// there never push it through.
#[test]
fn one_way_slopes_carry() {
    let (mut r, mut rested) = (Random::new(12), 0);
    for _ in 0..frames() / 50 {
        let unit = 1 << 10;
        let at = |r: &mut Random| i128::from(r.within(1, 15)) * unit;
        // From left to right, its normal up (y down): down to the kink and up again, or to the wall
        // at the right.
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
