//! Walkers: a body wedged by gravity has a floor (L7). It climbs obstacles no higher than the step
//! wherever it fits (L8).

use tilesat::{Aabb, Axis, Circle, Fx, Grid, Mover, TileKind, TileKinds, TileMap, Vec2, Walker};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::vec2;
use tilesat_judge::rooms::{PX, drawn};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
const GRAVITY: i64 = PX / 4;

/// Whether a ball that runs to the right, over two domes, comes to rest for good without a floor to
/// jump from.
fn locks(speed: i64, x: i64, r: i64) -> bool {
    let level =
        drawn(&["............", "............", "####)(######", "############"], 16 * PX, &[(')', 13), ('(', 12)]);
    let map = level.all();
    let walker = Walker::new(PLAYER).with_snap(Fx::from_num(4)).unwrap();
    let mut body = Circle::new(vec2((x, 32 * PX - r)), Fx::from_bits(r as i32)).unwrap();
    let (mut v, mut floor, mut still) = (Vec2::ZERO, None, 0);
    for _ in 0..600 {
        let push = (speed, i64::from(v.raw().1) + GRAVITY);
        let walked = walker.walk(&map, &body, vec2(push), floor).unwrap();
        still = if walked.moved.body == body && walked.floor.is_none() { still + 1 } else { 0 };
        if still == 100 {
            return true;
        }
        (body, v, floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
        if body.centre().raw().0 > 150 * PX as i32 {
            break;
        }
    }
    false
}

#[test]
fn what_gravity_wedges_has_a_floor() {
    let mut r = Random::new(7);
    let runs: Vec<_> = (0..tilesat_judge::thorough(250, 1000))
        .map(|_| (r.within(PX / 4, 3 * PX), r.within(8 * PX, 50 * PX), r.within(2 * PX, 8 * PX)))
        .collect();
    let locked: Vec<_> = runs.iter().filter(|&&(speed, x, r)| locks(speed, x, r)).collect();
    assert!(locked.is_empty(), "{} of {} end in a lock, such as {:?}", locked.len(), runs.len(), locked[0]);
}

/// Between two faces that are each too steep, by the cone of both: domes, slopes of 63 degrees, one
/// of them beside a block.
#[test]
fn two_walls_are_a_floor() {
    let scenes: [&[&str]; 3] = [
        &["......", "......", "##)(##", "######"],
        &["......", "..UV..", "##uv##", "######"],
        &["......", "..#V..", "###v##", "######"],
    ];
    let shapes = [(')', 13), ('(', 12), ('U', 33), ('u', 29), ('V', 32), ('v', 28)];
    for (rows, round) in scenes.into_iter().flat_map(|rows| [(rows, true), (rows, false)]) {
        let level = drawn(rows, 16 * PX, &shapes);
        let map = level.all();
        for x in [45, 48, 50, 53] {
            let at = (x * PX, 8 * PX);
            let (mut v, mut floor) = (Vec2::ZERO, None);
            let walker = Walker::new(PLAYER).with_snap(Fx::from_num(4)).unwrap();
            let mut rests = 0;
            macro_rules! falls {
                ($body:expr) => {{
                    let mut body = $body;
                    for _ in 0..400 {
                        let walked = walker.walk(&map, &body, v + Vec2::from_raw(0, GRAVITY as i32), floor).unwrap();
                        rests = if walked.moved.body == body { rests + 1 } else { 0 };
                        (body, v, floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
                    }
                    assert!(rests > 100, "{rows:?} {round} {x}: no rest, {body:?} {v:?}");
                    assert!(floor.is_some(), "{rows:?} {round} {x}: rests at {body:?} without a floor");
                    assert!(PLAYER.supported(&map, &body).unwrap().is_some(), "{rows:?} {round} {x}: {body:?}");
                }};
            }
            if round {
                falls!(Circle::new(vec2(at), Fx::from_num(6)).unwrap());
            } else {
                falls!(Aabb::new(vec2((at.0 - 4 * PX, at.1 - 4 * PX)), vec2((at.0 + 4 * PX, at.1 + 4 * PX))).unwrap());
            }
        }
    }
}

/// A doorway: a sill, a lintel over it, and the room between the body on the sill and the lintel.
fn passes(sill: i64, headroom: i64, before: i64, speed: i64, start: i64) -> bool {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    let (wide, high) = (64, 48);
    let tiles: Vec<u8> = (0..wide * high)
        .map(|k| {
            let (x, y) = (k % wide, k / wide);
            let floor = y >= 40 || (x >= 30 && y >= 40 - sill);
            let lintel = x >= 30 - before && y < 40 - sill - 16 - headroom;
            if floor || lintel { b'#' } else { b'.' }
        })
        .collect();
    let map = TileMap::on_grid(&tiles, Grid::new(64, 48, Fx::ONE, Vec2::ZERO).unwrap(), &KINDS).unwrap();
    let walker = Walker::new(PLAYER).with_snap(Fx::from_num(4)).unwrap().with_step(Fx::from_num(8)).unwrap();
    let mut body = Aabb::new(vec2((start, 24 * PX)), vec2((start + 10 * PX, 40 * PX))).unwrap();
    let mut floor = None;
    for _ in 0..200 {
        let walked = walker.walk(&map, &body, vec2((speed, GRAVITY)), floor).unwrap();
        (body, floor) = (walked.moved.body, walked.floor);
        if body.min().raw().0 > 36 * PX as i32 {
            return true;
        }
    }
    false
}

#[test]
fn doorways_are_passed() {
    let mut r = Random::new(3);
    let mut blocked = Vec::new();
    for _ in 0..3000 {
        let (sill, headroom) = (r.within(1, 8), r.within(0, 8));
        // The lintel may begin before the sill.
        let before = if r.one_in(2) { 0 } else { r.within(0, 12) };
        let door = (sill, headroom, before, r.within(PX / 2, 3 * PX), r.within(PX, 8 * PX));
        if !passes(door.0, door.1, door.2, door.3, door.4) {
            blocked.push(door);
        }
    }
    assert!(blocked.is_empty(), "{} of 3000 doorways, such as {:?}", blocked.len(), blocked[0]);
}
