//! Walkers among random tiles of all shapes, with random wishes, judged frame by frame.
//!
//! `TILESAT_FRAMES` sets the number of frames (default 200 000).

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::world::World;
use tilesat::{Aabb, Axis, Circle, Fx, MoveError, Mover, SlopeSpeed, Walked, Walker, motion::Support};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::{Body, point, vec2};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2, mosaic};

fn frames() -> u64 {
    tilesat_judge::frames(200_000)
}

fn fx(raw: i64) -> Fx {
    Fx::from_bits(raw as i32)
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) body: Body,
    pub(super) v: P,
    pub(super) floor: Option<Support>,
    stepped: i64,
    snapped: i64,
    pub(super) wall: bool,
    work: u32,
    pub(super) hits: tilesat::motion::Hits,
}

fn frame<B: tilesat::Body>(body: Body, w: &Walked<B>) -> Frame {
    Frame {
        body: body.at(point(w.moved.position())),
        v: point(w.moved.velocity),
        floor: w.floor,
        stepped: w.stepped.to_bits().into(),
        snapped: w.snapped.to_bits().into(),
        wall: w.moved.wall,
        work: w.moved.work.iterations,
        hits: w.moved.hits,
    }
}

pub(super) fn step<W: World>(
    walker: &Walker,
    world: &W,
    body: Body,
    v: P,
    floor: Option<Support>,
) -> Result<Frame, MoveError> {
    let (lo, hi) = body.bounds();
    match body {
        Body::Rect(..) => {
            let b = Aabb::new(vec2(lo), vec2(hi)).unwrap();
            walker.walk(world, &b, vec2(v), floor).map(|w| frame(body, &w))
        }
        Body::Disc(c, r) => {
            let b = Circle::new(vec2(c), fx(r)).unwrap();
            walker.walk(world, &b, vec2(v), floor).map(|w| frame(body, &w))
        }
        Body::Pill(p, e, r) => walker.walk(world, &Body::capsule(p, e, r), vec2(v), floor).map(|w| frame(body, &w)),
    }
}

#[derive(Debug, Default)]
struct Tally {
    frames: u64,
    stood: u64,
    flew: u64,
    stepped: u64,
    snapped: u64,
    blocked: u64,
    creeps: u64,
    over: f64,
    work: u32,
}

fn play(seed: u64, tally: &mut Tally) {
    let mut r = Random::new(seed);
    let (dense, one_way) = (r.within(4, 30), if r.one_in(2) { 0 } else { 10 });
    let mut level = mosaic(&mut r, (16, 12), 16 * PX, dense, one_way);
    // Steps of half a cell on the ground.
    for tile in &mut level.tiles[16 * 11..] {
        *tile = if r.one_in(3) { 4 } else { 0 };
    }
    let (room, map) = (Room::new(&level), level.all());
    let mirrored = View::MirrorX.level(&level);
    let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(1 + r.below(2) as u16, 1);
    let kind = if r.one_in(3) { SlopeSpeed::Projected } else { SlopeSpeed::Constant };
    let (snap, height) = (r.within(PX, 17 * PX), if r.one_in(3) { 0 } else { r.within(6 * PX, 18 * PX) });
    let walker = Walker::new(mover).with_slope_speed(kind).with_snap(fx(snap)).unwrap().with_step(fx(height)).unwrap();
    for _ in 0..6 {
        let p = (r.within(16 * PX, 240 * PX), r.within(16 * PX, 170 * PX));
        let mut body = match r.below(3) {
            0 => Body::Rect(p, (r.within(PX, 14 * PX), r.within(PX, 20 * PX))),
            1 => Body::Disc(p, r.within(PX / 2, 9 * PX)),
            _ => {
                let long = r.within(0, 16 * PX);
                Body::Pill(p, if r.one_in(4) { (long, 0) } else { (0, long) }, r.within(PX / 2, 8 * PX))
            }
        };
        if room.overlaps(body, (0, 0), 0) {
            continue;
        }
        let (mut floor, mut fall, mut speed) = (None, 0, PX);
        let mut mirror_floor = None;
        for _ in 0..120 {
            if r.one_in(12) {
                speed = r.within(-6 * PX, 6 * PX);
            }
            let v = (if r.one_in(40) { 0 } else { speed }, if r.one_in(90) { -4 * PX } else { fall + PX / 4 });
            let out = step(&walker, &map, body, v, floor).unwrap();
            let tell = || format!("{walker:?} {body:?} by {v:?} from {floor:?}: {out:?}");
            assert!(!room.overlaps(out.body, (0, 0), 0), "overlaps: {}", tell());
            // Seen in a mirror.
            let there = step(&walker, &mirrored.all(), View::MirrorX.body(body), (-v.0, v.1), mirror_floor);
            let there = there.unwrap();
            assert_eq!(there.body, View::MirrorX.body(out.body), "mirrored: {} {there:?}", tell());
            mirror_floor = there.floor;
            let (p, q) = (body.position(), out.body.position());
            let d = (q.0 - p.0, q.1 - p.1);
            assert!(out.snapped <= snap && out.stepped <= 4 * height, "{}", tell());
            if floor.is_some() && v.1 >= 0 {
                tally.stood += 1;
                // Never farther than the speed, except for the rise of steps and the fall to the
                // ground.
                let most = v.0.abs() + out.stepped + out.snapped;
                let over = (len2(d) as f64).sqrt() - most as f64;
                tally.over = tally.over.max(over);
                assert!(over <= 4.0, "too fast: {}", tell());
                assert!(out.floor.is_none() || out.v == (v.0, 0) || out.v == (0, 0), "{}", tell());
            } else {
                tally.flew += 1;
            }
            if let Some(axis) = out.floor.map(|f| f.axis) {
                assert!(axis.y < 0, "{}", tell());
                // It stays where it stands.
                let still = step(&walker, &map, out.body, (0, PX / 4), out.floor).unwrap();
                assert!(
                    still.body == out.body || still.floor.is_none() || out.stepped > 0,
                    "hums: {} {still:?}",
                    tell()
                );
                // A body that is blocked stays blocked.
                if out.wall && out.v == (0, 0) && v.0 != 0 && out.stepped == 0 {
                    tally.blocked += 1;
                    // It comes nearer to the obstacle, by less and less, or stays. It never goes
                    // back.
                    let mut at = out;
                    for _ in 0..6 {
                        let next = step(&walker, &map, at.body, (v.0, PX / 4), at.floor).unwrap();
                        let dx = next.body.position().0 - at.body.position().0;
                        if next.stepped > 0 || next.floor.is_none() {
                            break;
                        }
                        assert!(dx * v.0.signum() >= 0, "jitter: {} {at:?} {next:?}", tell());
                        tally.creeps += u64::from(next.body != at.body);
                        at = next;
                    }
                }
            }
            tally.frames += 1;
            tally.stepped += u64::from(out.stepped > 0);
            tally.snapped += u64::from(out.snapped > 0);
            assert!(out.work <= 64, "{}", tell());
            tally.work = tally.work.max(out.work);
            (body, floor, fall) = (out.body, out.floor, out.v.1.min(6 * PX));
        }
    }
}

#[test]
fn random_rooms() {
    let mut tally = Tally::default();
    let mut seed = 1;
    while tally.frames < frames() {
        play(seed, &mut tally);
        seed += 1;
    }
    println!("{tally:?}");
    assert!(tally.stood > tally.frames / 4 && tally.stepped > 100 && tally.snapped > 100 && tally.blocked > 100);
}
