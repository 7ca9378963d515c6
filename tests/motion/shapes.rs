//! Random worlds of all 34 shapes. Sets of points of the plane that share nothing with the library
//! judge every frame.
//!
//! In each frame: no overlap, no overlap on the way to the first contact (P20), and no gain of
//! speed (P14). Mirrored, transposed and shifted worlds give mirrored, transposed and the same bits
//! (P5, P6, P7), except for full ties. It hardly ever refuses a free motion. `TILESAT_FRAMES` sets
//! the number of frames (default 100 000).

use tilesat_judge::Random;
use tilesat_judge::rooms::frames::{RESPONSES, Scene, Tally, any_body, any_velocity, frame};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

const FRAMES_A_BODY: u64 = 200;

fn frames() -> u64 {
    tilesat_judge::frames(100_000)
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
