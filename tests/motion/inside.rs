//! Bodies that start in the solid: reported, ignored, pushed out.

use tilesat::motion::escape;
use tilesat::world::World;
use tilesat::{
    Aabb, Axis, Circle, Fx, Joined, MoveError, Mover, Outside, Solid, Solids,
    motion::{StartInside, Stuck},
};
use tilesat_judge::Random;
use tilesat_judge::rooms;
use tilesat_judge::rooms::body::{Body, point, vec2};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, PX, mosaic};
use tilesat_judge::shapes::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);
const LEAVES: Mover = UP.with_inside(StartInside::Ignore);

fn freed<W: World>(world: &W, body: Body) -> Result<Body, Stuck> {
    let (lo, hi) = body.bounds();
    match body {
        Body::Rect(..) => {
            let b = Aabb::new(vec2(lo), vec2(hi)).unwrap();
            escape(world, &b).map(|b| body.at(point(b.min())))
        }
        Body::Disc(c, r) => {
            let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
            escape(world, &b).map(|b| body.at(point(b.centre())))
        }
        Body::Pill(..) => panic!("no capsule is pushed out"),
    }
}

/// One tile in the middle of nothing, 16 units; the cell is at (2, 2).
fn alone(shape: u8) -> Level {
    let mut tiles = vec![0; 25];
    tiles[12] = shape;
    Level { tiles, width: 5, height: 5, cell: 16 * PX, x: 0, y: 0, outside: Outside::Empty }
}

fn way(a: Body, b: Body) -> P {
    let (p, q) = (a.position(), b.position());
    (q.0 - p.0, q.1 - p.1)
}

/// A box in a block leaves by the least of its depths, x before y, + before -, to the raw unit.
#[test]
fn out_of_a_block_by_the_nearest_side() {
    let level = alone(1);
    let (lo, hi) = (32 * PX, 48 * PX);
    for (w, h) in [(4 * PX, 6 * PX), (PX, PX), (10 * PX, 3 * PX)] {
        for i in -12..40 {
            for j in -12..40 {
                let p = (lo - 8 * PX + i * (PX * 2 / 3 + 11), lo - 8 * PX + j * (PX * 2 / 3 - 7));
                let body = Body::Rect(p, (w, h));
                let out = freed(&level.all(), body);
                let depths = [(hi - p.0, (1, 0)), (p.0 + w - lo, (-1, 0)), (hi - p.1, (0, 1)), (p.1 + h - lo, (0, -1))];
                if depths.iter().any(|d| d.0 <= 0) {
                    assert_eq!(out, Ok(body));
                    continue;
                }
                // Only sides within reach count. With its middle outside the block, only the sides
                // that it is before.
                let m = (p.0 + w / 2, p.1 + h / 2);
                let inside = m.0 > lo && m.0 < hi && m.1 > lo && m.1 < hi;
                let before = [m.0 >= hi, m.0 <= lo, m.1 >= hi, m.1 <= lo];
                let reached = [p.0 + w > hi, p.0 < lo, p.1 + h > hi, p.1 < lo];
                let ways = (0..4).filter(|&k| reached[k] && (inside || before[k])).map(|k| depths[k]);
                let Some((depth, side)) = ways.reduce(|a, b| if b.0 < a.0 { b } else { a }) else {
                    assert!(out.is_err(), "{body:?} {out:?}");
                    continue;
                };
                let (out, due) = (out.unwrap(), (side.0 * depth, side.1 * depth));
                assert_eq!(way(body, out), due, "{body:?}");
            }
        }
    }
}

/// It leaves a corner by one push per side, the least first. It leaves a niche of its own width by
/// two, and a narrower one by none.
#[test]
fn out_of_corners_and_niches() {
    let rows = rooms::drawn(&["#....", "#..#.", "#####"], 16 * PX, &[]);
    let map = rows.all();
    let corner = Body::Rect((14 * PX, 19 * PX), (9 * PX, 16 * PX));
    assert_eq!(way(corner, freed(&map, corner).unwrap()), (2 * PX, -3 * PX));
    let niche = Body::Rect((15 * PX, 20 * PX), (32 * PX, 14 * PX));
    assert_eq!(way(niche, freed(&map, niche).unwrap()), (PX, -2 * PX));
    let disc = Body::Disc((22 * PX, 24 * PX + 5), 8 * PX);
    assert_eq!(way(disc, freed(&map, disc).unwrap()), (2 * PX, -5));
    let wide = Body::Rect((15 * PX, 20 * PX), (34 * PX, 14 * PX));
    assert!(freed(&map, wide).is_err());
}

/// Torture scene 43: deep in 10 x 10 blocks there is no way out, and nothing moves. Near the rim it
/// takes the nearest one.
#[test]
fn deep_inside() {
    let mut tiles = vec![0; 400];
    for k in 0..100 {
        tiles[(k / 10 + 5) * 20 + k % 10 + 5] = 1;
    }
    let level = Level { tiles, width: 20, height: 20, cell: 16 * PX, x: 0, y: 0, outside: Outside::Empty };
    let map = level.all();
    let middle = (160 * PX, 160 * PX);
    for body in
        [Body::Rect(middle, (8 * PX, 8 * PX)), Body::Disc(middle, 8 * PX), Body::Rect(middle, (60 * PX, 9 * PX))]
    {
        assert_eq!(freed(&map, body), Err(Stuck { at: (middle.0 as i32, middle.1 as i32) }));
        for v in [(3 * PX, PX), (-100 * PX, 0)] {
            assert!(matches!(body.step(&UP, &map, v), Err(MoveError::Stuck(_))));
            // With its start ignored, it moves as asked, and out.
            let out = body.step(&LEAVES, &map, v).unwrap();
            assert_eq!((way(body, out.body), out.v, out.hits.len()), (v, v, 0));
        }
    }
    let rim = Body::Disc((80 * PX + 5 * PX, 100 * PX), 8 * PX);
    assert_eq!(way(rim, freed(&map, rim).unwrap()), (-13 * PX, 0));
}

/// In rooms of all shapes: free bodies stay. Others get free by at most four times their size, or
/// are reported.
#[test]
fn free_or_stuck() {
    let mut r = Random::new(0x43);
    let (mut freed_ones, mut stuck, mut stays) = (0, 0, 0);
    for _ in 0..12 {
        let level = mosaic(&mut r, (10, 10), 16 * PX, 35, 10);
        let room = Room::new(&level);
        for k in 0..300 {
            let p = (r.within(0, 160 * PX), r.within(0, 160 * PX));
            let (w, h) = (r.within(1, 12 * PX), r.within(1, 12 * PX));
            let body = if k % 2 == 0 { Body::Rect(p, (w, h)) } else { Body::Disc(p, w / 2 + 1) };
            let inside = room.overlaps(body, (0, 0), 0);
            match freed(&level.all(), body) {
                Ok(out) => {
                    assert!(!room.overlaps(out, (0, 0), 0), "{body:?} {out:?}");
                    let (x, y) = way(body, out);
                    let most = 4 * (w.max(h) + 4);
                    assert!(x.abs() <= most && y.abs() <= most, "{body:?} {out:?}");
                    assert!(inside || (x, y) == (0, 0), "{body:?} {out:?}");
                    assert_eq!(freed(&level.all(), out), Ok(out));
                    if inside { freed_ones += 1 } else { stays += 1 }
                }
                Err(at) => {
                    assert!(inside && at.at == (p.0 as i32, p.1 as i32));
                    stuck += 1;
                }
            }
        }
    }
    assert!(freed_ones > 500 && stays > 300 && stuck > 50, "{freed_ones} freed, {stays} free, {stuck} stuck");
}

/// Around each convex shape: a body inside leaves in every direction, by its whole motion, whatever
/// it reaches on the way.
#[test]
fn what_it_overlaps_does_not_stop_it() {
    let mut cases = 0;
    for shape in (1..34).filter(|s| !(14..18).contains(s)) {
        let level = alone(shape);
        let room = Room::new(&Level { outside: Outside::Solid, ..level.clone() });
        for k in 0..900 {
            let p = (26 * PX + k % 30 * (PX - 1234), 26 * PX + k / 30 * (PX - 4321));
            for body in [Body::Rect(p, (5 * PX, 3 * PX)), Body::Disc(p, 3 * PX)] {
                if !room.overlaps(body, (0, 0), 0) {
                    continue;
                }
                for (x, y) in (-2..3).flat_map(|x| (-2..3).map(move |y| (x, y))) {
                    let v = (x * 9 * PX + y, y * 9 * PX - x);
                    let out = body.step(&LEAVES, &level.all(), v).unwrap();
                    assert_eq!((way(body, out.body), out.v), (v, v), "{shape} {body:?}: {out:?}");
                    assert!(out.hits.is_empty());
                    cases += 1;
                }
            }
        }
    }
    assert!(cases > 100_000, "{cases}");
}

/// A shape that it does not overlap still stops it. Once outside, it does not enter again.
#[test]
fn everything_else_stops_it() {
    let mut r = Random::new(0x11);
    let (mut left, mut stopped) = (0, 0);
    for _ in 0..12 {
        let level = mosaic(&mut r, (10, 10), 16 * PX, 25, 10);
        let room = Room::new(&level);
        for k in 0..100 {
            let p = (r.within(8 * PX, 140 * PX), r.within(8 * PX, 140 * PX));
            let mut body = if k % 2 == 0 { Body::Rect(p, (7 * PX, 5 * PX)) } else { Body::Disc(p, 4 * PX) };
            let mut was_free = false;
            for _ in 0..20 {
                let free = !room.overlaps(body, (0, 0), 0);
                assert!(free || !was_free, "in again: {body:?}");
                left += u32::from(free && !was_free);
                was_free = free;
                let v = (r.within(-9 * PX, 9 * PX), r.within(-9 * PX, 9 * PX));
                let Ok(out) = body.step(&LEAVES, &level.all(), v) else { break };
                if free {
                    // The policy changes nothing for free bodies.
                    assert_eq!(out, body.step(&UP, &level.all(), v).unwrap());
                }
                let still = body.step(&LEAVES, &level.all(), (0, 0)).unwrap();
                assert_eq!(still.body, body);
                stopped += u32::from(!free && !out.hits.is_empty());
                body = out.body;
            }
        }
    }
    assert!(left > 300 && stopped > 100, "{left} left, {stopped} stopped");
    // Half in a door: the wall behind it stops it to the raw unit, and so does the floor.
    let rows = rooms::drawn(&["....#", "..#.#", "#####"], 16 * PX, &[]);
    let body = Body::Rect((40 * PX, 20 * PX), (10 * PX, 10 * PX));
    let out = body.step(&LEAVES, &rows.all(), (30 * PX, 5 * PX)).unwrap();
    assert_eq!(out.body.position(), (54 * PX, 22 * PX));
}

/// A door of one tile that closed on a body. Nothing is below it, so under gravity it falls out of
/// the world. Sideways it comes out on its floor, which stops it again. It is pushed out only if it
/// reaches a side.
#[test]
fn a_door_that_closed() {
    let closed = rooms::drawn(&["..#..", "..#..", "#####"], 16 * PX, &[]);
    let map = closed.all();
    let start = Body::Rect((35 * PX, 22 * PX), (10 * PX, 10 * PX));
    let mut falls = start;
    for k in 1..200 {
        falls = left(falls, &map, (0, k * PX / 4));
    }
    assert!(falls.position().1 > 48 * PX, "{falls:?}");
    for side in [-1, 1] {
        let mut body = start;
        for _ in 0..40 {
            let free = !Room::new(&closed).overlaps(body, (0, 0), 0);
            body = left(body, &map, (side * PX, if free { PX } else { 0 }));
        }
        assert_eq!(body.position().1, 22 * PX, "{body:?}");
    }
    for x in 22..49 {
        let body = Body::Rect((x * PX, 22 * PX), (10 * PX, 10 * PX));
        let due = match x {
            ..=22 | 48.. => Ok(0),
            ..32 => Ok(22 - x),
            32..=38 => Err(Stuck { at: (x as i32 * PX as i32, 22 * PX as i32) }),
            _ => Ok(48 - x),
        };
        assert_eq!(freed(&map, body).map(|out| way(body, out)), due.map(|x| (x * PX, 0)), "{x}");
    }
}

fn left<W: World>(body: Body, world: &W, v: P) -> Body {
    body.step(&LEAVES, world, v).unwrap().body
}

/// A crusher comes down on one edge of a body on the floor. However deep it is, the body leaves
/// sideways if less than half of it is under the crusher.
#[test]
fn the_edge_of_a_crusher() {
    let rows = rooms::drawn(&["......", "......", "######"], 16 * PX, &[]);
    let floor = rows.all();
    let (w, h) = (10 * PX, 14 * PX);
    for (edge, deep) in [1, 9, PX / 2, 2 * PX, 5 * PX].into_iter().flat_map(|edge| (0..56).map(move |k| (edge, k))) {
        let deep = 1 + deep * PX / 4;
        for side in [-1, 1] {
            let body = Body::Rect((32 * PX, 32 * PX - h), (w, h));
            let x = if side > 0 { 32 * PX + w - edge } else { edge };
            let crusher = Aabb::new(vec2((x, -9 * PX)), vec2((x + 32 * PX, 32 * PX - h + deep))).unwrap();
            let crusher = [Solid::new(crusher, 1).unwrap()];
            let out = freed(&Joined::new(&floor, &Solids::new(&crusher)), body);
            assert_eq!(out.map(|out| way(body, out)), Ok((-side * edge, 0)), "{edge} {deep} {side}");
        }
    }
}
