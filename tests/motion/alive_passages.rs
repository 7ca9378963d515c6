//! Walkers in passages that they just fit (L3): a corridor between two ramps, and a slope under a
//! parallel ceiling. Doorways for all bodies (L8). Bodies that come to rest in random levels have a
//! floor (L7).

use super::walk_worlds::{Frame, step};
use tilesat::{
    Aabb, AllShapes, Axis, Circle, Fx, Grid, Mover, SlopeSpeed, TileKind, TileKinds, TileMap, Vec2, Walker, World,
};
use tilesat_judge::Random;
use tilesat_judge::rooms::P;
use tilesat_judge::rooms::body::{Body, vec2};
use tilesat_judge::shapes::level::Level;

const CELLS: [i64; 2] = [1 << 20, 54_322];
const SPEEDS: [SlopeSpeed; 2] = [SlopeSpeed::Constant, SlopeSpeed::Projected];

fn fx(raw: i64) -> Fx {
    Fx::from_bits(raw as i32)
}

/// Whether a driven body gets this far.
fn arrives<W: World>(walker: &Walker, map: &W, mut body: Body, v: P, there: impl Fn(P, P) -> bool) -> bool {
    let mut floor = None;
    for _ in 0..2500 {
        let (lo, hi) = body.bounds();
        if there(lo, hi) {
            return true;
        }
        Frame { body, floor, .. } = step(walker, map, body, v, floor).unwrap();
    }
    false
}

fn goat(snap: i64, speed: SlopeSpeed) -> Walker {
    let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1);
    Walker::new(mover).with_snap(fx(snap)).unwrap().with_slope_speed(speed)
}

fn level(width: i64, cell: i64, tiles: Vec<u8>) -> Level {
    let height = tiles.len() as i64 / width;
    Level { tiles, width, height, cell, x: 0, y: 0, outside: tilesat::Outside::Empty }
}

/// Up a ramp, through a corridor of the body's height, and down a ramp.
#[test]
fn up_through_and_down() {
    for (ramp, back) in [(1, 1), (8, 9), (24, 25), (28, 29), (32, 33), (12, 13)] {
        for cell in CELLS {
            let mut tiles = vec![0; 36];
            tiles[27..].fill(1);
            tiles[2..6].fill(1);
            tiles[20..24].fill(1);
            (tiles[19], tiles[24]) = (ramp, back);
            let level = level(9, cell, tiles);
            let map: TileMap<'_, AllShapes> = level.all();
            for n in 0..6 * 4 * 6 * 4 {
                let (less, kind, part) = (n % 6, n / 6 % 4, [2, 5, 8, 16, 37, 64][n / 24 % 6]);
                let offset = [100, 3000, cell / 8, cell / 2][n / 144];
                let (high, round) = (cell - less as i64, kind & 1 == 1);
                let body = if round {
                    Body::Disc((2 * cell - high / 2 - offset, 2 * cell - high / 2), high / 2)
                } else {
                    Body::Rect((2 * cell - cell / 2 - offset, 2 * cell - high), (cell / 2, high))
                };
                let v = (cell / part, cell / part / [10, 3, 1][n % 3]);
                let through = arrives(&goat(cell, SPEEDS[kind / 2]), &map, body, v, |lo, _| lo.0 > 7 * cell);
                assert!(through, "{ramp}, {body:?} by {v:?}");
            }
        }
    }
}

/// Tiles of a column between two slopes: the number of rows above the lower floor, and ids.
type Column = &'static [(i64, u8)];

/// The floor's tiles and the ceiling's two cells above them, and their steepness.
const SLOPES: [(&[Column], i64, i64); 3] = [
    (&[&[(0, 8), (2, 6)], &[(1, 8), (3, 6)], &[(2, 8), (4, 6)]], 1, 1),
    (&[&[(0, 20), (2, 22)], &[(0, 24), (2, 18)], &[(1, 20), (3, 22)], &[(1, 24), (3, 18)]], 1, 2),
    (&[&[(0, 32), (1, 28), (2, 26), (3, 30)], &[(2, 32), (3, 28), (4, 26), (5, 30)]], 2, 1),
];

/// Between a slope and a parallel one above it, for boxes that touch both.
#[test]
fn along_a_slope_under_a_slope() {
    const WIDE: i64 = 12;
    for (columns, rise, run) in SLOPES {
        let long = columns.len() as i64;
        let up = long * rise / run;
        let mut tiles = vec![0; (WIDE * 12) as usize];
        let mut put = |x: i64, y: i64, id: u8| tiles[(y * WIDE + x) as usize] = id;
        for x in 0..WIDE {
            let k = x - 4;
            let base = 10 - if k < 0 { 0 } else { up.min(k * rise / run) };
            // The floor's row and all below it, the ceiling's and all above it.
            let (mut low, mut high) = (base, base - 3);
            if let Some(&column) = usize::try_from(k).ok().and_then(|k| columns.get(k)) {
                for &(up, id) in column {
                    put(x, 9 - up, id);
                }
                (low, high) = (10 - column[0].0, 8 - column[column.len() - 1].0);
            }
            (low..12).for_each(|y| put(x, y, 1));
            (0..=high).for_each(|y| put(x, y, 1));
        }
        for (cell, upward) in CELLS.into_iter().flat_map(|cell| [(cell, true), (cell, false)]) {
            let level = level(WIDE, cell, tiles.clone());
            let map: TileMap<'_, AllShapes> = level.all();
            for n in 0..6 * 2 * 6 * 3 {
                let (less, speed, part) = (n % 6, SPEEDS[n / 6 % 2], [2, 5, 8, 16, 37, 64][n / 12 % 6]);
                let wide = [cell / 2, cell, 7 * cell / 8 + 1][n / 72];
                let high = 2 * cell - (wide * rise + run - 1) / run - less as i64;
                let offset = [0, 100, 3000, cell / 8][n % 4];
                if high <= 0 {
                    continue;
                }
                let (x, y) =
                    if upward { (4 * cell - wide - offset, 10) } else { ((4 + long) * cell + offset, 10 - up) };
                let body = Body::Rect((x, y * cell - high), (wide, high));
                let v = (if upward { cell / part } else { -cell / part }, cell / part / 3);
                let through = arrives(&goat(2 * cell, speed), &map, body, v, |lo, hi| {
                    if upward { lo.0 > (4 + long) * cell } else { hi.0 < 4 * cell }
                });
                assert!(through, "{rise} : {run}, {body:?} by {v:?}");
            }
        }
    }
}

/// A sill no higher than the step, under a lintel that leaves room for the body on the sill. For
/// boxes, those lower than their step, and balls. Balls get a unit more between the corners.
#[test]
fn doorways() {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    const WIDE: i64 = 80;
    let mut r = Random::new(31);
    for n in 0..6000 {
        let (round, unit) = (n % 4 == 3, [1 << 16, 54_322][n / 4 % 2]);
        let step = r.within(1, 8);
        let sill = r.within(1, step);
        let radius = r.within(2, 8);
        let (w, h) = if round { (2 * radius, 2 * radius) } else { (r.within(2, 16), r.within(1, 16)) };
        let headroom = r.within(i64::from(round), 6);
        let (before, mirror) = (if r.one_in(2) { 0 } else { r.within(0, 12) }, r.one_in(2));
        let tile = |k: i64| {
            let (x, y) = (if mirror { WIDE - 1 - k % WIDE } else { k % WIDE }, k / WIDE);
            let floor = y >= 40 || (x >= 40 && y >= 40 - sill);
            if floor || (x >= 40 - before && y < 40 - sill - h - headroom) { b'#' } else { b'.' }
        };
        let tiles: Vec<u8> = (0..WIDE * 56).map(tile).collect();
        let map = TileMap::on_grid(&tiles, Grid::new(WIDE as u16, 56, fx(unit), Vec2::ZERO).unwrap(), &KINDS).unwrap();
        let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_snap(fx(4 * unit)).unwrap();
        let walker = walker.with_step(fx(step * unit)).unwrap();
        let (start, speed) = (r.within(unit, 8 * unit), r.within(unit / 3, 3 * unit));
        let x = if mirror { WIDE * unit - start - w * unit } else { start };
        let body = if round {
            Body::Disc((x + radius * unit, (40 - radius) * unit), radius * unit)
        } else {
            let high = h * unit - r.within(0, 5);
            Body::Rect((x, 40 * unit - high), (w * unit, high))
        };
        let v = (if mirror { -speed } else { speed }, unit / 4);
        let through =
            arrives(&walker, &map, body, v, |lo, hi| if mirror { hi.0 < (WIDE - 44) * unit } else { lo.0 > 44 * unit });
        assert!(through, "sill {sill} of {step}, headroom {headroom}, {before} before it: {body:?} by {v:?}");
    }
}

/// A ball on a corner under a slope: it has room to the side by 52 raw units, on which it would not
/// come down by one. With level floors alone it has the floor of what is wedged.
#[test]
fn room_to_the_side_alone_is_a_floor() {
    let mut tiles = vec![0; 48];
    (tiles[28], tiles[20], tiles[21]) = (3, 26, 23);
    let level = level(8, 1 << 20, tiles);
    let map: TileMap<'_, AllShapes> = level.all();
    let ball = Circle::new(vec2((5_246_597, 2_899_097)), fx(246_659)).unwrap();
    let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(0, 1);
    let walker = Walker::new(mover).with_snap(fx(1 << 18)).unwrap();
    let walked = walker.walk(&map, &ball, vec2((-99_816, 24_385)), None).unwrap();
    assert_eq!(walked.moved.body, ball);
    assert_eq!(walked.floor.map(|floor| floor.axis), Some(Axis::NEG_Y));
    assert!(mover.supported(&map, &ball).unwrap().is_some());
}

/// What a walk or a slide under gravity leaves where it is, without velocity, is supported.
#[test]
fn rests_have_a_floor() {
    let more = tilesat_judge::thorough(1, 10);
    play_rests(600 * more, 20_000 * more as u32);
}

fn play_rests(seeds: usize, least: u32) {
    let mut r = Random::new(5);
    let (mut rests, wide, high) = (0, 8, 6);
    for seed in 0..seeds {
        let (cell, full) = (CELLS[seed % 2], r.within(1, 4));
        let tile = |r: &mut Random, k: i64| {
            let wall = k / wide == high - 1 || k % wide == 0 || k % wide == wide - 1;
            if wall {
                1
            } else if r.below(4) < full {
                0
            } else {
                r.below(34) as u8
            }
        };
        let tiles = (0..wide * high).map(|k| tile(&mut r, k)).collect();
        let level = Level { outside: tilesat::Outside::Solid, ..level(wide, cell, tiles) };
        let map: TileMap<'_, AllShapes> = level.all();
        let (size, at) = (r.within(cell / 8, cell), (r.within(cell, 6 * cell), r.within(0, 4 * cell)));
        let long = r.within(cell / 8, cell);
        let mut body = match r.below(3) {
            0 => Body::Disc(at, size / 2 + 1),
            1 => Body::Rect(at, (size, long)),
            _ => Body::Pill(at, if r.one_in(2) { (long, 0) } else { (0, long) }, size / 2 + 1),
        };
        let limit = [(1, 1), (2, 1), (1, 2), (0, 1)][seed % 4];
        let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(limit.0, limit.1);
        let walker = Walker::new(mover).with_snap(fx(cell / 4)).unwrap().with_step(fx(cell / 3)).unwrap();
        // A support that is not floor is one under a gravity of at least 1/64 unit.
        let gravity = (cell / r.within(8, 128)).max(if limit.0 == 0 { 1 << 10 } else { 0 });
        let walks = r.one_in(2);
        let (mut v, mut floor, mut run) = ((0, 0), None, 0);
        for frame in 0..300 {
            if frame % 40 == 0 {
                run = if r.one_in(2) { 0 } else { r.around(cell / 6) };
            }
            let push = (run, v.1 + gravity);
            // The test skips bodies that start in the solid.
            let next = if walks {
                step(&walker, &map, body, push, floor).ok().map(|next| (next.body, next.v, next.floor))
            } else {
                body.step(&mover, &map, push).ok().map(|moved| (moved.body, moved.v, None))
            };
            let Some((place, velocity, stands)) = next else { break };
            if place.bounds() == body.bounds() && velocity == (0, 0) && (walks || run == 0) {
                rests += 1;
                let (lo, hi) = body.bounds();
                let supported = match body {
                    Body::Rect(..) => mover.supported(&map, &Aabb::new(vec2(lo), vec2(hi)).unwrap()),
                    Body::Pill(p, core, r) => mover.supported(&map, &Body::capsule(p, core, r)),
                    Body::Disc(c, r) => mover.supported(&map, &Circle::new(vec2(c), fx(r)).unwrap()),
                };
                assert!(supported.unwrap().is_some(), "{seed} {frame}: {body:?}, {push:?}");
                assert!(!walks || stands.is_some(), "{seed} {frame}: {body:?}, {push:?}");
            }
            (body, v, floor) = (place, velocity, stands);
        }
    }
    assert!(rests > least, "{rests}");
}
