//! Tunnels of one height that bend down and up. A walker that fits keeps its speed around each
//! bend, however little room the ceiling leaves.
//!
//! `TILESAT_CASES` sets the number of starts (default 8, or 32 in long runs).

#![allow(clippy::cast_precision_loss, reason = "lengths are below 2^30")]

use super::walk_worlds::step;
use tilesat::world::World;
use tilesat::{Axis, Fx, Joined, Mover, Outside, Path, PathKind, SegmentMap, SlopeSpeed, Vec2, Walker};
use tilesat_judge::cases;
use tilesat_judge::ground::way::{along, height, length, projected};
use tilesat_judge::ground::{CELL, Ground, PX, Shape, fx, vec2};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::shapes::level::Level;

/// From floor to ceiling, in cells.
const HIGH: usize = 2;

/// The bends of a picture, and its steepest slope: so many halves of a unit per unit.
const TUNNELS: [(&str, i64); 4] = [("__\\_/\\\\_//__", 2), ("__w_m_mw__", 1), ("__z_s_sz__", 4), ("__w\\_/mzs__", 4)];

const RUNS: [i64; 5] = [PX, PX + PX / 2, 3 * PX, 4 * PX, 6 * PX];
const SPARE: [i64; 4] = [PX / 4, PX, 2 * PX, 4 * PX];

#[derive(Clone, Copy, Debug)]
enum Kind {
    Box,
    Ball,
    Pill,
}

/// The ids of tiles whose solid and whose empty parts are exchanged.
fn complement(id: u8) -> u8 {
    match id {
        0 => 1,
        1 => 0,
        8 | 9 => id - 2,
        20 | 21 | 28 | 29 => id + 2,
        24 | 25 | 32 | 33 => id - 6,
        _ => panic!("no piece of ground {id}"),
    }
}

/// The ground's tiles and the same surface as a ceiling.
fn tunnel(ground: &Ground) -> Level {
    let floor = ground.level();
    let wide = floor.width as usize;
    let above = |k: usize| floor.tiles.get(k + HIGH * wide).map_or(0, |&id| complement(id));
    let tiles = floor.tiles.iter().enumerate().map(|(k, &id)| if id == 0 { above(k) } else { id }).collect();
    Level { tiles, outside: Outside::Empty, ..floor }
}

/// The floor, the ceiling or both as polygons.
fn with_polygons(ground: &Ground, floor: bool, then: impl FnOnce(&SegmentMap<'_>)) {
    let (end, high) = (ground.end(), HIGH as i64 * CELL);
    let below: Vec<Vec2> = ground.points.iter().copied().chain([(end, 30 * CELL), (0, 30 * CELL)]).map(vec2).collect();
    let line = ground.points.iter().rev().map(|p| (p.0, p.1 - high));
    let above: Vec<Vec2> = [(0, -30 * CELL), (end, -30 * CELL)].into_iter().chain(line).map(vec2).collect();
    let paths = [Path::new(PathKind::Solid, &above), Path::new(PathKind::Solid, &below)];
    let paths = if floor { &paths[..] } else { &paths[..1] };
    let cell = fx(CELL);
    let mut bytes = vec![0; SegmentMap::measure(paths, cell).unwrap().bytes()];
    SegmentMap::build_into(paths, cell, &mut bytes).unwrap();
    then(&SegmentMap::from_bytes(&bytes).unwrap());
}

/// A body that has `spare` room between parallel slopes, measured along y, and its lowest part,
/// which the judge moves over the ground.
fn body(kind: Kind, steep: i64, spare: i64, x: i64, ground: &Ground) -> (Body, Shape) {
    let room = HIGH as i64 * CELL - spare;
    let slanted = (1.0 + (steep * steep) as f64 / 4.0).sqrt();
    let ball = |high: i64| (high as f64 / (2.0 * slanted)) as i64 - 1;
    match kind {
        Kind::Box => {
            let wide = 14 * PX / steep.max(2) * 2;
            let high = room - wide * steep / 2;
            let shape = Shape::Rect(wide / 2, high / 2);
            let y = height(ground, shape, x as f64) as i64 - high / 2 - 1;
            (Body::Rect((x - wide / 2, y), (wide, high)), shape)
        }
        Kind::Ball => {
            let shape = Shape::Disc(ball(room));
            (Body::Disc((x, height(ground, shape, x as f64) as i64 - 1), ball(room)), shape)
        }
        Kind::Pill => {
            let r = ball(room / 2);
            let shape = Shape::Disc(r);
            let core = room - (2.0 * r as f64 * slanted).ceil() as i64;
            (Body::Pill((x, height(ground, shape, x as f64) as i64 - 1), (0, -core), r), shape)
        }
    }
}

/// One walk through a tunnel. Each frame is judged.
struct Walk<'a> {
    ground: &'a Ground,
    walker: &'a Walker,
    part: fn(f64, f64) -> f64,
    speed: i64,
}

impl Walk<'_> {
    fn through<W: World>(&self, world: &W, (mut body, shape): (Body, Shape)) {
        let place = |body: Body| match body {
            Body::Rect(p, size) => p.0 + size.0 / 2,
            Body::Disc(p, _) | Body::Pill(p, ..) => p.0,
        };
        let end = if self.speed > 0 { self.ground.end() - CELL } else { CELL };
        let open = self.ground.level();
        let mut floor = step(self.walker, world, body, (0, PX), None).unwrap().floor;
        while (end - place(body)) * self.speed.signum() > 0 {
            let next = step(self.walker, world, body, (self.speed, 0), floor).unwrap();
            let tell = || format!("{shape:?} by {} at {body:?} {:?}: {next:?}", self.speed, self.walker);
            assert!(next.floor.is_some() && next.v == (self.speed, 0) && !next.wall, "stopped: {}", tell());
            // Nothing but its floor is on its way.
            assert!(next.hits.iter().all(|hit| hit.axis.y < 0), "{}", tell());
            let other = step(self.walker, &open.all(), body, (self.speed, 0), floor).unwrap();
            if next.body != other.body {
                let way = |to| along(self.ground, shape, place(body) as f64, place(to) as f64, self.part);
                let (made, under_the_sky) = (way(next.body), way(other.body));
                let due = self.speed.abs() as f64;
                // A circle goes around a corner by tangents, and by others if it meets the ceiling.
                let most = if matches!(shape, Shape::Rect(..)) { 8.0 } else { due / 5.0 };
                assert!(made > under_the_sky - most, "slow: {made} {under_the_sky} {}", tell());
                assert!(made < under_the_sky.max(due) + 8.0, "fast: {made} {under_the_sky} {}", tell());
            }
            (body, floor) = (next.body, next.floor);
        }
    }
}

/// The body of a kind at the start of a walk.
type Bodies<'a> = dyn Fn(Kind) -> (Body, Shape) + 'a;

/// All tunnels, runs, rooms and kinds of bodies, each from many starts.
fn through_all(starts: i64, then: &mut dyn FnMut(&Walk<'_>, &Bodies<'_>)) {
    for (picture, steep) in TUNNELS {
        let ground = Ground::of(picture, 8, 8);
        for (run, spare) in RUNS.into_iter().flat_map(|run| SPARE.map(|spare| (run, spare))) {
            for start in 0..starts {
                let way = if start % 4 < 2 { 1 } else { -1 };
                let x = 10 * PX + run * start / starts;
                let x = if way > 0 { x } else { ground.end() - x };
                let (kind, part): (_, fn(f64, f64) -> f64) =
                    if start % 2 == 0 { (SlopeSpeed::Constant, length) } else { (SlopeSpeed::Projected, projected) };
                let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1);
                let walker = Walker::new(mover).with_snap(fx(run * (1 + steep) / 2)).unwrap();
                let walker = walker.with_slope_speed(kind).with_step(Fx::from_num(start % 3)).unwrap();
                let walk = Walk { ground: &ground, walker: &walker, part, speed: way * run };
                then(&walk, &|kind| body(kind, steep, spare, x, &ground));
            }
        }
    }
}

#[test]
fn tunnels_of_tiles() {
    through_all(cases(tilesat_judge::thorough(8, 32)), &mut |walk, body| {
        let level = tunnel(walk.ground);
        for kind in [Kind::Box, Kind::Ball, Kind::Pill] {
            walk.through(&level.all(), body(kind));
        }
    });
}

/// Of polygons, and with a floor of tiles under a ceiling that is a polygon.
#[test]
fn tunnels_of_segments() {
    through_all(cases(32) / 8, &mut |walk, body| {
        let floor = walk.ground.level();
        for kind in [Kind::Box, Kind::Ball, Kind::Pill] {
            with_polygons(walk.ground, true, |map| walk.through(map, body(kind)));
            with_polygons(walk.ground, false, |map| {
                walk.through(&Joined::new(&floor.all(), map), body(kind));
            });
        }
    });
}

/// A ledge of three units in front of the slope: the bend of the two lines is behind the ledge.
#[test]
fn tunnels_with_a_ledge() {
    let deep = 3 * PX;
    let ground = Ground::corners(&[
        (0, 0),
        (4 * CELL, 0),
        (4 * CELL, deep),
        (7 * CELL, 3 * CELL + deep),
        (9 * CELL, 3 * CELL + deep),
    ]);
    with_polygons(&ground, true, |map| {
        for (run, start) in RUNS.into_iter().flat_map(|run| (0..64).map(move |start| (run, start))) {
            let x = 10 * PX + run * start / 64;
            let (mut body, _) = body(Kind::Box, 2, deep + PX / 4, x, &ground);
            let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_slope_speed(SlopeSpeed::Constant);
            let walker = walker.with_snap(fx(2 * run + deep)).unwrap();
            let mut floor = step(&walker, map, body, (0, PX), None).unwrap().floor;
            for _ in 0..6 * CELL / run {
                let next = step(&walker, map, body, (run, 0), floor).unwrap();
                let made = next.body.position().0 - body.position().0;
                let moves = (7 * run / 10..=run).contains(&made);
                assert!(
                    next.v == (run, 0) && moves && !next.wall && next.floor.is_some(),
                    "{walker:?} {body:?} {next:?}"
                );
                (body, floor) = (next.body, next.floor);
            }
        }
    });
}

/// Stairs of blocks under a ceiling of the same stairs. A box that leaves a tread too late hits the
/// ceiling.
#[test]
fn tunnels_of_stairs() {
    const CELL: i64 = 4 * PX;
    let (wide, high) = (60, 24);
    let row = |y: i64| (0..wide).map(move |x| u8::from(!(x / 6 + 2..x / 6 + 10).contains(&y)));
    for (mirror, run, start, step_height) in (0..2).flat_map(|mirror| {
        RUNS.into_iter()
            .flat_map(move |run| (0..64).flat_map(move |start| [0, 4].map(|h| (mirror == 1, run, start, h))))
    }) {
        let mut tiles: Vec<u8> = (0..high).flat_map(row).collect();
        if mirror {
            tiles.chunks_mut(wide as usize).for_each(<[u8]>::reverse);
        }
        let level = Level { tiles, width: wide, height: high, cell: CELL, x: 0, y: 0, outside: Outside::Empty };
        let blocks = level.blocks().unwrap();
        let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_snap(Fx::from_num(6)).unwrap();
        let walker = walker.with_step(Fx::from_num(step_height)).unwrap();
        let (size, x) = ((22 * PX, 26 * PX), PX + run * start / 64);
        let x = if mirror { wide * CELL - x - size.0 } else { x };
        let mut body = Body::Rect((x, 10 * CELL - size.1), size);
        let mut floor = step(&walker, &blocks, body, (0, PX), None).unwrap().floor;
        let v = (if mirror { -run } else { run }, 0);
        for _ in 0..180 * PX / run {
            let next = step(&walker, &blocks, body, v, floor).unwrap();
            let made = next.body.position().0 - body.position().0;
            // The time that is left after a hit is rounded down.
            let whole = made.abs() <= run && made * v.0.signum() >= run - 2;
            assert!(next.v == v && whole && !next.wall && next.floor.is_some(), "{walker:?} {body:?} {next:?}");
            (body, floor) = (next.body, next.floor);
        }
    }
}
