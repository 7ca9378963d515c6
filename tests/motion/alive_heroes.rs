//! Walkers that jump about with a constant input in small levels. If one stays for good, it has a
//! floor, and no way of free positions leads ahead or down (L6, L7). Raw units, y down.

use super::alive_graph::{leads, leaves_room};
use super::walk_worlds::{Frame, step};
use tilesat::{
    Aabb, Axis, Character, Feel, Fx, Input, Mover, SlopeSpeed, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2,
    Walker, fx,
};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, mosaic};
use tilesat_judge::{Random, cases};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
/// Small, so that a search raw unit by raw unit goes far, but the gravity of a frame is far more
/// than roundings.
const CELL: i64 = 256 * K;
const K: i64 = 128;
/// Frames in which it jumps where it stands, and frames in which it does not.
const FRAMES: [i64; 2] = [60, 160];

/// How a hero is driven: to this speed across "up" by this acceleration.
#[derive(Clone, Copy, Debug)]
struct Drive {
    speed: i64,
    acceleration: i64,
    gravity: i64,
    jump: i64,
}

/// The last frame of a hero that stays at its place.
fn stays(walker: &Walker, map: &tilesat::TileMap<'_, tilesat::AllShapes>, body: Body, drive: &Drive) -> Option<Frame> {
    let (mut at, mut v, mut floor, mut still): (Body, P, _, _) = (body, (0, 0), None, 0);
    for frame in 0..FRAMES[1] {
        let jumps = frame < FRAMES[0] && floor.is_some();
        let push = (
            v.0 + (drive.speed - v.0).clamp(-drive.acceleration, drive.acceleration),
            if jumps { -drive.jump } else { v.1 + drive.gravity },
        );
        let next = step(walker, map, at, push, if jumps { None } else { floor }).ok()?;
        still = if next.body == at && frame > FRAMES[0] { still + 1 } else { 0 };
        if still == 8 {
            return Some(next);
        }
        (at, v, floor) = (next.body, next.v, next.floor);
    }
    None
}

fn play(levels: u64) {
    let mut r = Random::new(17);
    let (mut runs, mut stayed, mut stuck) = (0, 0, Vec::new());
    for _ in 0..levels {
        let dense = [15, 30, 50][r.below(3) as usize];
        let mut level = mosaic(&mut r, (5, 5), CELL, dense, 0);
        // Often full tiles and slopes alone: bodies as large as a tile fit between them exactly.
        let fits = r.one_in(2);
        for tile in level.tiles.iter_mut().filter(|tile| **tile != 0) {
            *tile = match r.below(6) {
                0..3 if fits => 1,
                _ if fits => [6, 7, 8, 9, r.within(18, 33) as u8][r.below(5) as usize],
                0 => 1,
                _ => *tile,
            };
        }
        let (map, room) = (level.all(), Room::new(&level));
        for _ in 0..8 {
            let size = |r: &mut Random| if fits { [64, 128, 192, 256, 256][r.below(5) as usize] } else { r.within(40, 400) } * K;
            let (w, h) = (size(&mut r), size(&mut r));
            let at = (r.within(0, (5 * CELL - w) / 4096) * 4096, r.within(0, (5 * CELL - h) / 4096) * 4096);
            let body =
                if r.one_in(3) { Body::Disc((at.0 + w / 2, at.1 + w / 2), w / 2) } else { Body::Rect(at, (w, h)) };
            let speed = [200, 96, 40][r.below(3) as usize] * K * if r.one_in(2) { 1 } else { -1 };
            let gravity = [40, 16, 8][r.below(3) as usize] * K;
            let acceleration = [gravity / 2, gravity, 3 * gravity / 2, 1 << 20][r.below(4) as usize];
            let drive = Drive { speed, acceleration, gravity, jump: [0, 90, 160, 240][r.below(4) as usize] * K };
            let snap = Fx::from_bits([0, 64 * K as i32][r.below(2) as usize]);
            let walker = Walker::new(PLAYER).with_snap(snap).unwrap();
            let walker = walker.with_slope_speed([SlopeSpeed::Constant, SlopeSpeed::Projected][r.below(2) as usize]);
            if room.overlaps(body, (0, 0), 0) {
                continue;
            }
            runs += 1;
            let Some(end) = stays(&walker, &map, body, &drive) else { continue };
            stayed += 1;
            // Ahead and down, without a climb.
            let ahead = drive.speed.signum();
            let ways = [(ahead, 0), (ahead, 1), (0, 1)];
            let goes_on = |body| leads(&room, body, &ways, (ahead, 1), CELL / 16);
            let straight = !level.tiles.iter().any(|&tile| (10..=17).contains(&tile));
            let dead = goes_on(end.body) && (straight || leaves_room(&room, end.body, (ahead, 1), goes_on));
            if end.floor.is_none() || dead {
                stuck.push((level.tiles.clone(), body, end.body, end.floor.is_some(), drive, snap));
            }
        }
    }
    assert!(stayed > runs / 4, "{stayed} of {runs}");
    assert!(
        stuck.is_empty(),
        "{} of {stayed} heroes that stay, such as {:?}",
        stuck.len(),
        &stuck[..stuck.len().min(3)]
    );
}

#[test]
fn what_stays_stands_and_has_no_way_on() {
    play(cases(tilesat_judge::thorough(2_000, 30_000)));
}

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'p', TileKind::of(TileShape::SlopeTopRight))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight));

/// Where a hero of this width, 16 units high, ends that runs right and jumps in some frames.
fn ends(
    rows: &str,
    (x, width): (i16, i16),
    feel: Feel,
    run: Fx,
    jump: core::ops::Range<u32>,
) -> (Character, (f32, f32)) {
    let level = TileMap::<Slopes>::of_ascii(rows, &KINDS).unwrap();
    let start = Aabb::from_size(Vec2::from_ints(x, 48), Vec2::from_ints(width, 16)).unwrap();
    let mut hero = Character::new(start, level.bounds(), feel);
    for frame in 0..400 {
        let _ = hero.step(&level, Input { run, jump: jump.contains(&frame), drop: false }).unwrap();
    }
    (hero, hero.body().min().to_f32())
}

/// The head is at the ceiling, and a foot at the end of a ramp that the ceiling bars.
#[test]
fn a_ramp_beside_the_feet_is_no_landing() {
    let quick = Feel { air_acceleration: fx!(0.5), ..Feel::DEFAULT };
    for (rows, feel) in
        [("#####\n#.ab#\n#.###\n#.###\n#####\n", Feel::DEFAULT), ("#####\n#./##\n#.###\n#.###\n#####\n", quick)]
    {
        let (hero, at) = ends(rows, (22, 10), feel, fx!(1.5), 5..40);
        assert!(at == (22.0, 48.0) && hero.on_floor(), "{at:?}");
    }
}

/// A slope over the end of a ledge bars the way one raw unit before the end, by rounding alone.
#[test]
fn the_last_raw_unit_of_a_ledge_is_no_floor() {
    let rows = "############\n#..........#\n#.....p#...#\n#......p...#\n######.....#\n#..........#\n############\n";
    let (hero, at) = ends(rows, (20, 16), Feel::DEFAULT, fx!(3), 16..18);
    assert!(at == (160.0, 80.0) && hero.on_floor(), "{at:?}");
}
