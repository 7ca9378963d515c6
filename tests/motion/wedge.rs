//! Bodies that slide into a gap that closes at an acute angle. They go in to the last free
//! position, and rest there.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "a place in floats, within a raw unit"
)]

use std::fmt::Debug;
use tilesat::motion::Body;
use tilesat::{Aabb, AllShapes, Axis, Circle, Fx, Grid, Mover, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};
use tilesat_judge::Random;

static KINDS: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0u8);
    while id < 34 {
        kinds = kinds.with(id, TileKind::of(TileShape::ALL[id as usize]));
        id += 1;
    }
    kinds
};

const SIDE: usize = 32;
const UNIT: i64 = 1 << 16;

fn map(tiles: &[u8]) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(Outside::Solid)
}

fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::new(Fx::from_bits(x as i32), Fx::from_bits(y as i32))
}

fn exact(v: Vec2) -> [f64; 2] {
    [f64::from(v.x.to_bits()), f64::from(v.y.to_bits())]
}

/// A box that comes up a slope of one in two under a round tile. No position within two raw units
/// of the contact with both is free.
#[test]
fn goes_into_the_gap() {
    let mut tiles = [0; SIDE * SIDE];
    let mut put = |x: usize, y: usize, shape: TileShape| tiles[y * SIDE + x] = shape as u8;
    put(17, 20, TileShape::ConvexTopLeft);
    put(17, 21, TileShape::MildLowBottomRight);
    let body = Aabb::new(raw(17_810_228, 22_076_362), raw(18_494_676, 22_734_230)).unwrap();
    let push = raw(1_397_858, 531_275);

    let moved = Mover::new().move_and_slide(&map(&tiles), &body, push).unwrap();
    assert_eq!(moved.position() - body.min(), raw(123_714, -61_857));
    assert_eq!((moved.velocity, moved.hits.len()), (Vec2::ZERO, 2));
    let again = Mover::new().move_and_slide(&map(&tiles), &moved.body, push).unwrap();
    assert_eq!((again.body, again.velocity), (moved.body, Vec2::ZERO));
}

/// How many frames of bodies among all shapes end without velocity between a straight face and the
/// surface that they met after it. For each, the end of the motion along that face, up to 512 raw
/// units back on its way, and the part that rounding takes.
fn held_frames<B: Body + Debug>(rooms: usize, mut body: impl FnMut(&mut Random) -> Option<B>) -> u32 {
    let (mut random, mut held) = (Random::new(20), 0);
    for _ in 0..rooms {
        let mut tiles = [0; SIDE * SIDE];
        tiles.fill_with(|| if random.one_in(4) { random.within(1, 33) as u8 } else { 0 });
        let map = map(&tiles);
        for _ in 0..100 {
            let Some(mut body) = body(&mut random) else { continue };
            let mut velocity = Vec2::ZERO;
            for frame in 0..48 {
                if frame % 12 == 0 {
                    velocity = raw(random.around(30 * UNIT), random.around(30 * UNIT));
                }
                // The test skips bodies that start in the solid.
                let Ok(moved) = Mover::new().move_and_slide(&map, &body, velocity) else { break };
                if moved.velocity == Vec2::ZERO && moved.hits.len() == 2 {
                    let mut hits = moved.hits.iter();
                    let (first, second) = (hits.next().unwrap(), hits.next().unwrap());
                    if let Some(to) = along(velocity, first.axis, first.toi.raw(), second.toi.raw()) {
                        held += 1;
                        let made = exact(moved.position() - body.position());
                        let short = (made[0] - to[0]).abs().max((made[1] - to[1]).abs());
                        assert!(
                            short < 16.0 + 10.0 / sine(first.axis, second.axis),
                            "{body:?} by {velocity:?}: {moved:?}"
                        );
                    }
                }
                body = moved.body;
            }
        }
    }
    held
}

/// The end of a motion that slides along a face from one moment to another. `None` if the first is
/// not a face of a tile.
fn along(v: Vec2, n: Axis, from: u32, to: u32) -> Option<[f64; 2]> {
    if n.x.abs().max(n.y.abs()) > 2 {
        return None;
    }
    let (v, n) = (exact(v), [f64::from(n.x), f64::from(n.y)]);
    let into = (v[0] * n[0] + v[1] * n[1]) / (n[0] * n[0] + n[1] * n[1]);
    let part = |t: u32| f64::from(t) / f64::from(1 << 30);
    let at = |k: usize| v[k] * part(from) + (v[k] - n[k] * into) * (part(to) - part(from));
    Some([at(0), at(1)])
}

/// The sine of the angle between two directions.
fn sine(a: Axis, b: Axis) -> f64 {
    let length = |v: Axis| f64::from(v.x).hypot(f64::from(v.y));
    a.perp_dot(b).abs() as f64 / (length(a) * length(b))
}

fn place(r: &mut Random) -> (i64, i64) {
    (r.within(16 * UNIT, 496 * UNIT), r.within(16 * UNIT, 496 * UNIT))
}

#[test]
fn circles_stop_where_the_gap_does() {
    let held = held_frames(160, |r| {
        let (x, y) = place(r);
        Circle::new(raw(x, y), Fx::from_bits(r.within(4 * UNIT, 6 * UNIT) as i32)).ok()
    });
    assert!(held > 10_000, "{held}");
}

#[test]
fn boxes_stop_where_the_gap_does() {
    let held = held_frames(tilesat_judge::thorough(160, 640), |r| {
        let ((x, y), w, h) = (place(r), r.within(UNIT, 6 * UNIT), r.within(UNIT, 6 * UNIT));
        Aabb::new(raw(x - w, y - h), raw(x + w, y + h)).ok()
    });
    assert!(held > tilesat_judge::thorough(2_500, 10_000), "{held}");
}

/// Discs pressed between the corners of two blocks, after a short way along the tangent of one. The
/// way's end is rounded out of the other corner, which may be into the first.
#[test]
fn discs_go_in_between_two_corners() {
    let mut tiles = [0; SIDE * SIDE];
    tiles[22 * SIDE + 10] = TileShape::Full as u8;
    tiles[19 * SIDE + 12] = TileShape::Full as u8;
    let level = map(&tiles);
    // The upper right corner of the lower block, and the lower left one of the upper block.
    let corners = [(11 * 16 * UNIT, 22 * 16 * UNIT), (12 * 16 * UNIT, 20 * 16 * UNIT)];
    let from = |p: (i64, i64), c: Vec2| [exact(c)[0] - p.0 as f64, exact(c)[1] - p.1 as f64];
    let gap = |p, c, r: i64| f64::hypot(from(p, c)[0], from(p, c)[1]) - r as f64;
    let [[x, y], [to_x, to_y]] = corners.map(|p| [p.0 as f64, p.1 as f64]);
    let (half_x, half_y) = ((to_x - x) / 2.0, (to_y - y) / 2.0);
    let mut random = Random::new(33);
    for _ in 0..4000 {
        let r = random.within(18 * UNIT, 20 * UNIT);
        // Where it touches both, relative to the lower corner; then turned back around that one.
        let along = ((r * r) as f64 / (half_x * half_x + half_y * half_y) - 1.0).sqrt();
        let (x, y) = (half_x - half_y * along, half_y + half_x * along);
        let turn = random.within(40, 4000) as f64 / r as f64;
        let away = |by: f64| {
            let (x, y) = (x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos());
            raw((x * by) as i64 + corners[0].0, (y * by) as i64 + corners[0].1)
        };
        let start = (1..9).map(|k| away(1.0 + f64::from(k) / r as f64)).find(|c| gap(corners[0], *c, r) >= 0.0);
        let mut body = Circle::new(start.unwrap(), Fx::from_bits(r as i32)).unwrap();
        let push = raw(-random.within(UNIT, 20 * UNIT), random.around(UNIT / 4));
        let mut velocity = push;
        for _ in 0..4 {
            let moved = Mover::new().move_and_slide(&level, &body, push).unwrap();
            (body, velocity) = (moved.body, moved.velocity);
        }
        let left = corners.map(|p| gap(p, body.centre(), r));
        assert!(velocity == Vec2::ZERO && left.iter().all(|gap| *gap < 8.0), "{left:?}: {body:?} by {push:?}");
    }
}
