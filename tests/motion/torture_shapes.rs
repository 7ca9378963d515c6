//! Torture scenes of the survey among tiles of all shapes, by its numbers: 25, 42 and 49.

use tilesat::{Axis, Circle, Fx, MoveError, Mover, Outside, Response, Vec2, world::OneWay};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::{FINE, Room};
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, drawn};
use tilesat_judge::shapes::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);
const TOUCH: Mover = UP.with_response(Response::Touch);

/// A circle whose centre is exactly on a face, on a corner, on a slope, an arc, or in the middle of
/// a block. It is stuck, no normal is zero, and the first push clears it.
#[test]
fn scene_25_a_centre_exactly_on_the_surface() {
    let shapes = [('/', 8), ('d', 13)];
    let cell = 16 * PX;
    let level = drawn(&[".......", ".#./.d.", "......."], cell, &shapes);
    let level = Level { outside: Outside::Empty, ..level };
    let map = level.all();
    let r = 5 * PX;
    let (x, y) = (cell, cell);
    // 3-4-5: on the arc of radius 16 around (80, 32), at (80 + 9.6, 32 - 12.8).
    let on_arc = (5 * cell + cell * 3 / 5, 2 * cell - cell * 4 / 5);
    for c in [
        (x + cell / 2, y),
        (x, y),
        (x + cell, y + cell),
        (x + cell / 2, y + cell / 2),
        (3 * cell + cell / 2, y + cell / 2),
        on_arc,
    ] {
        // From the middle of a block it must reach its sides.
        let r = if c == (x + cell / 2, y + cell / 2) { 12 * PX } else { r };
        let body = Body::Disc(c, r);
        for v in [(0, 1), (3 * PX, -PX), (-PX, 70 * PX)] {
            assert!(matches!(body.step(&UP, &map, v), Err(MoveError::Stuck(_))), "{c:?}");
        }
        let ball = Circle::new(Vec2::from_raw(c.0 as i32, c.1 as i32), Fx::from_bits(r as i32)).unwrap();
        let mut out = heapless::Vec::<_, 8>::new();
        map.contacts(&ball, OneWay::Ignore, &mut out).unwrap();
        assert!(!out.is_empty() && out.iter().all(|c| !c.axis().is_zero()), "{c:?}");
        let free = ball.translated(out[0].push_out()).unwrap();
        assert!(!map.overlaps(&free), "{c:?}: {out:?}");
    }
}

/// Every shape alone and beside a full tile on each of its sides. Circles and boxes on a lattice of
/// positions move in eight directions. The way is free, a hit would be entered, a miss has nothing
/// there, and mirrored scenes give mirrored bits.
#[test]
fn scene_42_every_tile_and_its_neighbours() {
    let cell = 16 * PX;
    let (mut hits, mut misses) = (0, 0);
    for id in 1..34 {
        for side in [None, Some(1), Some(3), Some(5), Some(7)] {
            let mut tiles = vec![0u8; 9];
            tiles[4] = id;
            if let Some(side) = side {
                tiles[side] = 1;
            }
            let level = Level { tiles, width: 3, height: 3, cell, x: 0, y: 0, outside: Outside::Solid };
            let (room, mirror) = (Room::new(&level), View::MirrorX.level(&level));
            for kind in [Body::Disc((0, 0), 5 * PX), Body::Rect((0, 0), (7 * PX, 9 * PX))] {
                for (i, j) in (0..7).flat_map(|i| (0..7).map(move |j| (i, j))) {
                    let body = kind.at((i * 8 * PX, j * 8 * PX));
                    let stuck = room.overlaps(body, (0, 0), 0);
                    for k in 0..8 {
                        let d = [(1, 0), (2, 1), (1, 2), (0, 1), (-1, 1), (-2, 0), (-1, -2), (2, -1)][k];
                        let v: P = (d.0 * 8 * PX, d.1 * 8 * PX);
                        let out = body.step(&TOUCH, &level.all(), v);
                        assert_eq!(out.is_err(), stuck);
                        let Ok(out) = out else { continue };
                        let case = || format!("{id} {side:?} {body:?} by {v:?}: {out:?}");
                        let until = out.hits.first().map_or(1 << 30, |h| i64::from(h.toi.raw())) * FINE / (1 << 30);
                        for part in 0..=4 {
                            assert!(!room.overlaps(body, v, until * part / 8 * 2), "{}", case());
                        }
                        let seen =
                            View::MirrorX.body(body).step(&TOUCH, &mirror.all(), View::MirrorX.direction(v)).unwrap();
                        assert_eq!(seen.body, View::MirrorX.body(out.body), "{}", case());
                        if out.hits.is_empty() {
                            misses += 1;
                            assert_eq!(out.body, body.moved(v), "{}", case());
                        } else {
                            hits += 1;
                            // The lattice and the lower bound are early by some raw units.
                            let enters = |k: i64| room.overlaps(out.body.moved((d.0 * k, d.1 * k)), (0, 0), 0);
                            assert!([1, 4, 16, 64, 4096].into_iter().any(enters), "{}", case());
                        }
                    }
                }
            }
        }
    }
    assert!(hits > 20_000 && misses > 5_000, "{hits} {misses}");
}

/// Ten thousand frames on a flat, on a one-way, at a slope's foot, in a pipe's foot, on the top of
/// a dome.
#[test]
fn scene_49_resting_ten_thousand_ticks() {
    let shapes = [('/', 8), ('(', 17), ('d', 13), ('b', 12), ('-', 34)];
    let level = drawn(&["#.......#", "#......-#", "#.bd(.../", "#########"], 16 * PX, &shapes);
    let place = |x: i64, y: i64, kind: Body| kind.at((x * PX, y * PX));
    let all = level.all();
    // On the pipe's foot and on the dome's top the normal is exactly up.
    for start in [
        place(90, 40, Body::Disc((0, 0), 8 * PX)),
        place(90, 38, Body::Rect((0, 0), (5 * PX, 10 * PX))),
        place(120, 11, Body::Disc((0, 0), 5 * PX)),
        place(48, 24, Body::Disc((0, 0), 8 * PX)),
        place(40, 20, Body::Rect((0, 0), (12 * PX, 12 * PX))),
        place(80, 43, Body::Disc((0, 0), 5 * PX)),
    ] {
        let first = start.step(&UP, &all, (0, PX / 4)).unwrap();
        assert_eq!((first.body, first.v), (start, (0, 0)), "{first:?}");
        for _ in 0..10_000 {
            assert_eq!(start.step(&UP, &all, (0, PX / 4)).unwrap(), first);
        }
    }
}
