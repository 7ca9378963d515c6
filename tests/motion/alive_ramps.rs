//! Ramps under ceilings: a body loses speed only to surfaces that it touches at its position (L1,
//! L2, L5).

use tilesat::{AllShapes, Axis, Mover, TileMap};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, PX, drawn};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
const GRAVITY: i64 = PX / 4;
const SHAPES: [(char, u8); 6] = [('/', 8), ('7', 6), ('l', 24), ('L', 20), ('u', 28), ('U', 32)];

/// Whether a body that is driven to the right at a constant speed stops dead although a unit to the
/// right is free.
fn stops_dead(map: &TileMap<'_, AllShapes>, room: &Room, mut body: Body, speed: i64) -> bool {
    let mut v = (speed, 0);
    for _ in 0..20 {
        let out = body.step(&PLAYER, map, v).unwrap();
        if out.v == (0, 0) {
            return (1..=64).all(|k| !room.overlaps(out.body, (PX, 0), 8 * k));
        }
        (body, v) = (out.body, (speed, out.v.1 + GRAVITY));
        if body.middle().0 > 150 * PX {
            break;
        }
    }
    false
}

/// Boxes, balls and upright capsules of five heights. They start at 23 speeds from 16 positions on
/// a ramp of 45 degrees, into a corridor of one tile.
#[test]
fn a_ramp_under_a_ceiling() {
    let level = drawn(&["...#########", "............", "../#########", "############"], 16 * PX, &SHAPES);
    let (map, room) = (level.all(), Room::new(&level));
    let (mut all, mut stopped) = (0, [0; 3]);
    for high in [10, 12, 13, 14, 15] {
        for (eighths, place) in (8..=96).step_by(4).flat_map(|v| (0..16).map(move |p| (v, p))) {
            let right = 34 * PX + place * 30_011;
            let bottom = 80 * PX - right;
            let bodies = [
                Body::Rect((right - 8 * PX, bottom - high * PX), (8 * PX, high * PX)),
                Body::Disc((right - 5 * PX, bottom - high * PX / 2 - 5 * PX), high * PX / 2),
                Body::Pill((right - 4 * PX, bottom - 6 * PX), (0, (8 - high) * PX), 4 * PX),
            ];
            all += 1;
            for (kind, body) in bodies.into_iter().enumerate() {
                stopped[kind] += i32::from(stops_dead(&map, &room, body, eighths * PX / 8));
            }
        }
    }
    assert_eq!(stopped, [0; 3], "boxes, balls and capsules that stop dead in free space, of {all} each");
}

/// Surfaces behind a body are not in its way: past the end of a slope of the floor, and of one of
/// the ceiling.
#[test]
fn what_was_left_behind_takes_nothing() {
    let rows = ["...#####", "........", "../#####", "########"];
    let (level, player) = (drawn(&rows, 16 * PX, &SHAPES), Body::Rect((39 * PX, 21 * PX), (8 * PX, 12 * PX)));
    let out = player.step(&PLAYER, &level.all(), (8 * PX, -4 * PX)).unwrap();
    assert_eq!((out.v, out.ceiling), ((6 * PX, 0), true), "{out:?}");
    let level = drawn(&["...7....", "........", "........", "........", "########"], 16 * PX, &SHAPES);
    let ball = Body::Disc((72 * PX, 12 * PX), 4 * PX);
    let out = ball.step(&PLAYER, &level.all(), (-120 * PX, 4 * PX)).unwrap();
    assert!(out.body.position().0 < 20 * PX, "{out:?}");
}

/// A body that slides up a ramp without gravity keeps its speed along the ramp, to the multiple of
/// the direction below it. The ceiling takes only the part that leads into it. That holds for every
/// height of the body, every speed, and every moment of the frame at which it reaches the joint.
#[test]
fn the_ceiling_alone_takes_speed() {
    let scenes: [(&[&str], P); 3] = [
        (&["######", "......", "......", "../###", "######"], (1, -1)),
        (&["######", "......", "......", "..Ll##", "######"], (2, -1)),
        (&["######", "......", "......", "......", "..u###", "..U###", "######"], (1, -2)),
    ];
    let (mut runs, mut wrong) = (0, Vec::new());
    for (rows, along) in scenes {
        let level = drawn(rows, 16 * PX, &SHAPES);
        let (map, floor) = (level.all(), (level.height - 1) * 16 * PX);
        for (high, speed, at) in (4..=12).flat_map(|h| (1..=40).flat_map(move |s| (0..4).map(move |a| (h, s, a)))) {
            let v = (speed * PX / 4 + 77 * at, 0);
            let mut body = Body::Rect((2 * PX + 9_999 * at, floor - high * PX), (6 * PX, high * PX));
            let mut now = v;
            for _ in 0..2000 {
                let out = body.step(&PLAYER, &map, now).unwrap();
                (body, now) = (out.body, out.v);
                if now == (0, 0) || body.middle().0 > 70 * PX {
                    break;
                }
            }
            // The multiple of the ramp's direction below the projection.
            let k = v.0 * along.0 / (along.0 * along.0 + along.1 * along.1);
            runs += 1;
            if now != (k * along.0, 0) && now != (k * along.0, k * along.1) {
                wrong.push((rows[2], high, v, now, k));
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {runs} runs, such as {:?}", wrong.len(), &wrong[..wrong.len().min(4)]);
}
