//! Walkers in named scenes: rest, wedges, jumps, one-way floors, steep slopes, quarter pipes.

use tilesat::world::World;
use tilesat::{Aabb, Axis, Circle, Inside, Mover, Response, SlopeSpeed, TileMap, Walker, motion::Support};
use tilesat_judge::ground;
use tilesat_judge::ground::{CELL, Frame, P, PX, Shape, fx, vec2};
use tilesat_judge::shapes::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);
const BOX: Shape = Shape::Rect(5 * PX, 7 * PX);
const DISC: Shape = Shape::Disc(7 * PX);
const G: i64 = PX / 4;

fn walker() -> Walker {
    Walker::new(UP).with_slope_speed(SlopeSpeed::Constant).with_snap(fx(6 * PX)).unwrap()
}

/// Cells of 16 units: `/` `\` slopes, `s` `S` the lower and upper half of a steep one to the right,
/// `)` `(` quarter pipes, `-` one-way, `o` a coin.
fn level(rows: &[&str]) -> Level {
    let id = |c: char| match c {
        '.' => 0,
        '#' => 1,
        '/' => 8,
        '\\' => 9,
        's' => 32,
        'S' => 28,
        ')' => 16,
        '(' => 17,
        '-' => 34,
        't' => 7,
        _ => panic!("no shape {c}"),
    };
    let tiles = rows.iter().flat_map(|row| row.chars().map(id)).collect();
    let (width, height) = (rows[0].len() as i64, rows.len() as i64);
    Level { tiles, width, height, cell: CELL, x: 0, y: 0, outside: tilesat::Outside::Solid }
}

fn at(x: i64, y: i64) -> P {
    (x * PX, y * PX)
}

/// Frames at one velocity, with gravity on top of the last frame's result.
fn play<W: World>(walker: &Walker, world: &W, shape: Shape, from: Frame, speed: i64, frames: usize) -> Vec<Frame> {
    let mut last = from;
    (0..frames)
        .map(|_| {
            last = shape.step(walker, world, last.at, (speed, last.v.1 + G), last.floor).unwrap();
            last
        })
        .collect()
}

/// Falls until it stands.
fn stand<W: World>(walker: &Walker, world: &W, shape: Shape, at: P) -> Frame {
    let start = shape.step(walker, world, at, (0, G), None).unwrap();
    let seen = play(walker, world, shape, start, 0, 100);
    assert!(seen[99].floor.is_some(), "{:?}", seen[99]);
    seen[99]
}

fn supported(map: &TileMap<'_, tilesat::AllShapes>, shape: Shape, at: P) -> Option<Support> {
    match shape {
        Shape::Rect(w, h) => {
            let body = Aabb::new(vec2((at.0 - w, at.1 - h)), vec2((at.0 + w, at.1 + h))).unwrap();
            UP.supported(map, &body).unwrap()
        }
        Shape::Disc(r) => UP.supported(map, &Circle::new(vec2(at), fx(r)).unwrap()).unwrap(),
    }
}

/// On flat ground, on slopes and in a V it stays at its position, whatever pulls it down. A probe
/// finds the same floor, and none in the air.
#[test]
fn rest() {
    let flat_and_v = level(&["........", "........", r"#\..../#", r"##\../##", "########"]);
    let map = flat_and_v.all();
    for shape in [BOX, DISC] {
        for x in [22, 28, 37, 44, 64, 70, 90, 101] {
            let start = stand(&walker(), &map, shape, at(x, 12));
            for pull in [0, 1, G, 5 * PX] {
                let still = shape.step(&walker(), &map, start.at, (0, pull), start.floor).unwrap();
                assert_eq!((still.at, still.v, still.floor), (start.at, (0, 0), start.floor), "{x}");
                assert_eq!((still.snapped, still.work), (0, 1));
            }
            let floor = supported(&map, shape, start.at).unwrap();
            assert_eq!((floor.axis, floor.flags), (start.floor.unwrap().axis, start.floor.unwrap().flags), "{x}");
            assert_eq!(supported(&map, shape, (start.at.0, start.at.1 - 20)), None);
        }
    }
}

/// Torture scene 40: down a slope to a wall, and up into the wedge under a ceiling. It stops, once,
/// and stays. Then it goes back freely.
#[test]
fn walls_and_wedges() {
    let wall = level(&["...#....", "...#....", r"\..#....", r"#\.#....", r"##\#....", "########"]);
    let wedge = level(&["........", "........", "...####.", ".../###.", "../###..", "./####..", "########"]);
    let low = level(&["........", "....####", "....t###", "########"]);
    for (scene, from) in [(&wall, at(20, 12)), (&wedge, at(9, 80)), (&low, at(20, 40))] {
        let map = scene.all();
        for shape in [Shape::Rect(3 * PX, 4 * PX), Shape::Disc(4 * PX)] {
            let start = stand(&walker(), &map, shape, from);
            for speed in [PX / 3, 2 * PX, 5 * PX] {
                let seen = play(&walker(), &map, shape, start, speed, 400);
                let last = seen[399];
                let stopped = seen.iter().position(|f| f.at == last.at).unwrap();
                assert!(stopped < 390, "{shape:?} by {speed}: {last:?}");
                assert!(seen[stopped..].iter().all(|f| f.at == last.at), "jitter: {shape:?} by {speed}: {last:?}");
                assert!(
                    seen.iter().all(|f| f.floor.is_some()),
                    "hop: {from:?} {shape:?} by {speed}: {:?}",
                    seen.iter().find(|f| f.floor.is_none())
                );
                let back = play(&walker(), &map, shape, last, -speed, 1)[0];
                assert!(back.at.0 < last.at.0 && back.floor.is_some(), "{back:?}");
            }
        }
    }
}

/// A jump leaves the ground at once, even uphill and downhill, and nothing draws it back. It lands
/// when it is over the ground again.
#[test]
fn jumps() {
    let hill = level(&["..........", "..........", "..........", "....##....", r".../##\...", "##########"]);
    let map = hill.all();
    for shape in [BOX, DISC] {
        for (x, speed) in [(30, 0), (20, 2 * PX), (56, PX), (56, -PX), (72, PX), (120, 2 * PX), (118, -2 * PX)] {
            let start = stand(&walker(), &map, shape, at(x, 20));
            let up = shape.step(&walker(), &map, start.at, (speed, -3 * PX), start.floor).unwrap();
            assert!(up.floor.is_none() && up.snapped == 0 && up.at.1 < start.at.1, "{x} {up:?}");
            let seen = play(&walker(), &map, shape, up, speed / 4, 60);
            let rise = seen.iter().take_while(|f| f.floor.is_none()).map(|f| f.at.1).min().unwrap();
            assert!(rise <= start.at.1 - 13 * PX, "{x} {rise}");
            assert!(seen[59].floor.is_some(), "{x} {:?}", seen[59]);
        }
    }
}

/// Landing on level ground costs no raw unit of the sideways motion.
#[test]
fn landing_is_exact() {
    let flat = level(&["........", "........", "########"]);
    for shape in [BOX, DISC] {
        for k in 0..200 {
            let v = (3 * PX + k * 977, 9 * PX + k * 313);
            let out = shape.step(&walker(), &flat.all(), (20 * PX, 20 * PX - k), v, None).unwrap();
            assert_eq!((out.at, out.v), ((20 * PX + v.0, 32 * PX - shape.half()), (v.0, 0)));
        }
    }
}

/// A slope beyond the limit is a wall. A walker on the ground stops at it. In the air it does not
/// rise along it, and falls down along it.
#[test]
fn steep_slopes() {
    let steep = level(&["........", "........", ".....S##", ".....s##", "########"]);
    let map = steep.all();
    let goat = Walker::new(UP.with_slope_limit(2, 1)).with_snap(fx(9 * PX)).unwrap();
    for shape in [BOX, DISC] {
        let start = stand(&walker(), &map, shape, at(40, 40));
        let seen = play(&walker(), &map, shape, start, 2 * PX, 60);
        let last = seen[59];
        assert!(last.at.1 == start.at.1 && last.hit_wall && last.v == (0, 0) && last.floor.is_some(), "{last:?}");
        // Pressed to it in the air, from above its middle.
        let mut fall = shape.step(&walker(), &map, (60 * PX, 30 * PX), (2 * PX, G), None).unwrap();
        let mut seen_wall = false;
        for _ in 0..200 {
            let next = shape.step(&walker(), &map, fall.at, (2 * PX, fall.v.1 + G), fall.floor).unwrap();
            assert!(next.at.1 >= fall.at.1, "climbs: {fall:?} {next:?}");
            seen_wall |= next.hit_wall && next.floor.is_none();
            fall = next;
        }
        assert!(seen_wall && fall.floor.is_some() && fall.at.1 == start.at.1, "{fall:?}");
        // A jump against it rises as if it were none.
        let edge = last.at;
        let up = shape.step(&walker(), &map, edge, (2 * PX, -2 * PX), last.floor).unwrap();
        assert_eq!(up.at.1, edge.1 - 2 * PX, "{up:?}");
        // For another walker it is a floor.
        let seen = play(&goat, &map, shape, start, 2 * PX, 60);
        assert!(seen[59].at.1 < 32 * PX && seen.iter().all(|f| f.floor.is_some()), "{:?}", seen[59]);
    }
}

/// Into a quarter pipe it goes until that is too steep, at every speed. It neither slides back nor
/// hops.
#[test]
fn quarter_pipes() {
    let pipe = level(&["........", "........", ".......#", "(.....)#", "########"]);
    let map = pipe.all();
    for shape in [BOX, Shape::Disc(5 * PX), Shape::Disc(7 * PX)] {
        let start = stand(&walker(), &map, shape, at(60, 50));
        for speed in [PX / 5, PX, 2 * PX, 7 * PX, -PX / 5, -PX, -3 * PX] {
            let seen = play(&walker(), &map, shape, start, speed, 500);
            let last = seen[499];
            assert!(seen.iter().all(|f| f.floor.is_some()), "{shape:?} by {speed}: hop");
            assert!(seen.windows(2).all(|f| (f[1].at.0 - f[0].at.0) * speed >= 0), "{shape:?} by {speed}: back");
            assert!(seen[400..].iter().all(|f| f.at == last.at), "{shape:?} by {speed}: {last:?}");
            assert!(speed.abs() > 4 * PX || last.at.1 < start.at.1 - PX / 2, "{shape:?} by {speed}: {last:?}");
        }
    }
}

/// Down a slope that ends in a quarter pipe: at a speed whose chord would pass the limit, the body
/// still goes up to the pipe.
#[test]
fn down_a_slope_into_a_quarter_pipe() {
    let pipe = level(&["....", "....", "#...", "#\\)#", "####"]);
    let map = pipe.all();
    let mut stops = 0;
    for (half, x) in (3..=7).flat_map(|half| (18..=30).map(move |x| (half, x))) {
        let shape = Shape::Rect(half * PX, 7 * PX);
        let start = shape.step(&walker(), &map, at(x + half, x + 24), (0, 2 * PX), None);
        let on_slope = |f: &Frame| f.floor.is_some_and(|floor| floor.axis == Axis::new(1, -1));
        let Some(start) = start.ok().filter(on_slope) else { continue };
        for speed in 4..=14 {
            let seen = play(&walker(), &map, shape, start, speed * PX, 40);
            let (end, last) = (seen[39].at, seen[38].at);
            if end != last {
                continue;
            }
            stops += 1;
            let body = Aabb::new(vec2((end.0 - half * PX, end.1 - 7 * PX)), vec2((end.0 + half * PX, end.1 + 7 * PX)));
            let hit = map.cast_shape(&body.unwrap(), vec2((PX, PX)), Inside::Hit).unwrap();
            assert!(hit.is_some(), "{shape:?} from {:?} by {speed} stops at {end:?}", start.at);
        }
    }
    assert!(stops > 100, "{stops}");
}

/// One-way floors: it walks on them, snaps down on them but not through them, and jumps up through
/// them. Inside one, nothing draws it anywhere. It drops through on request, and stays if it is
/// half on a block.
#[test]
fn one_way_floors() {
    let scene = level(&["........", "........", "---##---", "........", "........", "########"]);
    let map = scene.all();
    let drops = walker().with_drop_through(true);
    for shape in [BOX, DISC] {
        let start = stand(&walker(), &map, shape, at(20, 20));
        assert!(start.floor.unwrap().one_way && start.at.1 == 32 * PX - 7 * PX);
        let seen = play(&walker(), &map, shape, start, PX, 90);
        assert!(seen.iter().all(|f| f.floor.is_some() && f.at.1 == start.at.1 && f.v == (PX, 0)));
        assert!(seen.iter().any(|f| !f.floor.unwrap().one_way));
        // Down.
        let fall = shape.step(&drops, &map, start.at, (0, PX), start.floor).unwrap();
        assert_eq!((fall.at, fall.floor), ((start.at.0, start.at.1 + PX), None));
        let seen = play(&walker(), &map, shape, fall, 0, 60);
        assert!(seen[59].at.1 == 80 * PX - 7 * PX && seen[59].floor.is_some());
        assert!(seen.iter().all(|f| f.snapped == 0));
        // Up through it, by a higher jump.
        let up = shape.step(&walker(), &map, seen[59].at, (0, -6 * PX), seen[59].floor).unwrap();
        let seen = play(&walker(), &map, shape, up, 0, 60);
        assert_eq!((seen[59].at, seen[59].floor.is_some()), (start.at, true));
        assert!(seen.iter().all(|f| f.snapped == 0 && (f.floor.is_none() || f.at == start.at)));
        // A snap from above: a floor one unit below the walker's.
        let above = (start.at.0, start.at.1 - PX);
        let snapped = shape.step(&walker(), &map, above, (0, 0), start.floor).unwrap();
        assert_eq!((snapped.at, snapped.snapped), (start.at, PX));
        // Not from inside of it.
        let inside = (start.at.0, start.at.1 + 1);
        let stays = shape.step(&walker(), &map, inside, (0, 0), start.floor).unwrap();
        assert_eq!((stays.at, stays.floor, stays.snapped), (inside, None, 0));
    }
    // Half on the block.
    let start = stand(&walker(), &map, BOX, at(48, 20));
    let stays = BOX.step(&drops, &map, start.at, (0, PX), start.floor).unwrap();
    assert!(stays.at == start.at && stays.floor.is_some_and(|f| !f.one_way), "{stays:?}");
}

/// The limit is exact: a slope of that steepness is floor, and one part in 32 000 less is wall. The
/// same for ceilings, and for any length and direction of "up".
#[test]
fn the_limit_to_the_last_bit() {
    // Slopes of 16 units to the left and right of a middle piece, by their rise over run.
    for (rise, run) in [(16, 16), (16, 32), (32, 16)] {
        let ground = ground::Ground::corners(&[at(-100, 200), at(-run, 200), at(0, 200 - rise), at(100, 200 - rise)]);
        ground.with_polygon(|map| {
            let body = Circle::new(vec2((-run * PX / 2, 150 * PX)), fx(2 * PX)).unwrap();
            for up in [Axis::NEG_Y, Axis::new(0, -7), Axis::new(0, i32::MIN + 1)] {
                let floor = |rise: u16, run: u16| {
                    let mover = Mover::platformer(up).with_slope_limit(rise, run).with_response(Response::Touch);
                    let moved = mover.move_and_slide(map, &body, vec2(at(0, 60))).unwrap();
                    assert!(moved.floor != moved.wall && !moved.ceiling && moved.hits.len() == 1);
                    moved.floor
                };
                let (rise, run) = (rise as u16, run as u16);
                assert!(floor(rise, run) && floor(rise * 1000, run * 1000) && floor(rise * 1000 + 1, run * 1000));
                assert!(!floor(rise * 1000, run * 1000 + 1) && !floor(rise * 1000 - 1, run * 1000));
                assert!(floor(1, 0) && floor(0, 0) && !floor(0, 1) && floor(u16::MAX, 1));
            }
            // Upside down it is a ceiling.
            let down =
                Mover::platformer(Axis::Y).with_slope_limit(rise as u16, run as u16).with_response(Response::Touch);
            let moved = down.move_and_slide(map, &body, vec2(at(0, 60))).unwrap();
            assert!(moved.ceiling && !moved.wall && !moved.floor);
        });
    }
}
