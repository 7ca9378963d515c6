//! Walkers at steps, ledges, walls and wedges, to the raw unit.

use tilesat::world::World;
use tilesat::{
    Aabb, Axis, Body, Capsule, Circle, ConvexPolygon, Joined, Mover, Slopes, Solid, Solids, TileKind, TileKinds,
    TileMap, TileShape, Vec2, Walker,
};
use tilesat_judge::ground::{CELL, Frame, Ground, P, PX, Shape, fx, vec2};

const BOX: Shape = Shape::Rect(5 * PX, 8 * PX);
const DISC: Shape = Shape::Disc(8 * PX);

fn walker(snap: i64, step: i64) -> Walker {
    Walker::new(Mover::platformer(Axis::NEG_Y)).with_snap(fx(snap)).unwrap().with_step(fx(step)).unwrap()
}

/// Ground left of x = 0 at y = 0, right of it `rise` higher, up to 8 cells away, seen in a mirror
/// where `left`.
fn ledge(rise: i64, left: bool) -> Ground {
    let mut points = vec![(-8 * CELL, 0), (0, 0), (0, -rise), (8 * CELL, -rise)];
    if left {
        points = points.into_iter().rev().map(|(x, y)| (-x, y)).collect();
    }
    Ground::corners(&points)
}

/// Frames at one speed from a stand on the ground.
fn play<W: World>(world: &W, shape: Shape, walker: &Walker, from: P, v: P, frames: u32) -> Vec<Frame> {
    let mut last = shape.step(walker, world, (from.0, from.1 - shape.half() - PX), (0, 2 * PX), None).unwrap();
    // A wide body that starts over a slope meets it later.
    for _ in 0..8 {
        last = shape.step(walker, world, last.at, (0, 2 * PX), last.floor).unwrap();
    }
    assert!(last.floor.is_some(), "{last:?}");
    (0..frames)
        .map(|_| {
            last = shape.step(walker, world, last.at, v, last.floor).unwrap();
            last
        })
        .collect()
}

/// It climbs a step of exactly the walker's height. One raw unit more is a wall. At any phase and
/// speed, to both sides.
#[test]
fn steps_to_the_raw_unit() {
    for (shape, reach) in [(BOX, 5 * PX), (DISC, 8 * PX)] {
        for left in [false, true] {
            let side = if left { -1 } else { 1 };
            // A circle rolls over obstacles that it meets as a floor: 2.3 units at 45 degrees.
            for step in [PX, 4 * PX, 6 * PX].into_iter().filter(|&s| shape == BOX || s > 3 * PX) {
                for more in [-1, 0, 1] {
                    ledge(step + more, left).with_polygon(|map| {
                        for phase in 0..24 {
                            let speed = PX / 3 + phase * 12_345;
                            let from = (-side * (3 * CELL - phase * 777), 0);
                            let seen = play(map, shape, &walker(2 * PX, step), from, (side * speed, PX / 4), 360);
                            let tell = |f: &Frame| format!("{shape:?} {step}+{more} by {speed} {left}: {f:?}");
                            for f in seen.iter().take_while(|f| f.at.0 * side < 4 * CELL) {
                                assert!(f.floor.is_some(), "{}", tell(f));
                                assert!(more > 0 || !f.hit_wall, "a step is no wall: {}", tell(f));
                            }
                            let last = seen.iter().find(|f| f.at.0 * side > 3 * CELL).unwrap_or(&seen[359]);
                            if more <= 0 {
                                assert!(last.at.0 * side > 3 * CELL, "{}", tell(last));
                                assert_eq!(last.at.1, -step - more - shape.half(), "{}", tell(last));
                                let up: i64 =
                                    seen.iter().take_while(|f| f.at.0 * side < 4 * CELL).map(|f| f.stepped).sum();
                                assert!(up > 0 && (shape == DISC || up == step + more), "{} {up}", tell(last));
                            } else {
                                assert!((last.at.0 * side).abs() <= reach && last.at.0 * side <= 0, "{}", tell(last));
                                assert_eq!((last.at.1, last.stepped), (-shape.half(), 0), "{}", tell(last));
                                assert!(last.hit_wall && last.v == (0, 0), "{}", tell(last));
                            }
                        }
                    });
                }
            }
        }
    }
}

/// It follows a ledge of exactly the snap down. One raw unit more leaves it flying.
#[test]
fn ledges_to_the_raw_unit() {
    for left in [false, true] {
        let side = if left { -1 } else { 1 };
        for fall in [PX / 2, 2 * PX, 6 * PX] {
            for more in [-1, 0, 1] {
                ledge(fall + more, left).with_polygon(|map| {
                    for phase in 0..24 {
                        let speed = PX / 3 + phase * 12_345;
                        let from = (side * (2 * CELL - phase * 777), -fall - more);
                        let seen = play(map, BOX, &walker(fall, 0), from, (-side * speed, 0), 240);
                        let end = seen.iter().find(|f| f.at.0 * side < -5 * PX).unwrap();
                        let tell = || format!("{fall}+{more} by {speed} {left}: {end:?}");
                        if more <= 0 {
                            assert!(end.floor.is_some() && end.at.1 == -BOX.half(), "{}", tell());
                            assert_eq!((end.snapped, end.v), (fall + more, (-side * speed, 0)), "{}", tell());
                        } else {
                            assert!(end.floor.is_none() && end.at.1 == -fall - more - BOX.half(), "{}", tell());
                            assert_eq!(end.v, (-side * speed, 0), "{}", tell());
                        }
                    }
                });
            }
        }
    }
}

/// Slopes on both sides of a step, rising, falling or level, from a seam of one raw unit on. More
/// than the walker's height is a wall: by one raw unit, or by the rounding of a rest on a slope.
#[test]
fn steps_between_slopes() {
    let step = 4 * PX;
    let grades = [(0, 1), (1, 4), (1, 3), (1, 1), (-1, 4), (-1, 2), (-1, 1)];
    for (before, after) in grades.iter().flat_map(|b| grades.iter().map(move |a| (*b, *a))) {
        let more = if before.0 == 0 { 1 } else { 8 };
        for rise in [1, 216, PX / 2, PX, 3 * PX, step - 1, step, step + more] {
            let down = |(num, den): (i64, i64), x: i64| -x * num / den;
            let points =
                [(-6 * CELL, down(before, -6 * CELL)), (0, 0), (0, -rise), (6 * CELL, down(after, 6 * CELL) - rise)];
            let start = (-5 * CELL, down(before, -5 * CELL) - 10 * PX);
            Ground::corners(&points).with_polygon(|map| {
                for shape in [BOX, DISC, Shape::Disc(2 * PX)] {
                    // For a circle the rise of the slopes over its radius counts too. On its way
                    // down to the step, a box stands on its other corner.
                    // On a slope at the limit it meets the seam as a wall.
                    let most = if before == (1, 1) { 0 } else { PX / 2 };
                    if (shape != BOX && rise > most) || (rise > step && before.0 < 0) {
                        continue;
                    }
                    for speed in [PX / 2, 3 * PX / 2, 3 * PX] {
                        let walker = walker(6 * PX, step);
                        let seen = play(map, shape, &walker, start, (speed, PX / 4), (32 * CELL / speed) as u32);
                        let end = seen.iter().find(|f| f.at.0 > 4 * CELL).unwrap_or(&seen[seen.len() - 1]);
                        let tell = || format!("{shape:?}, {before:?} then {rise} then {after:?}, by {speed}: {end:?}");
                        assert_eq!(end.at.0 > 4 * CELL, rise <= step, "{}", tell());
                        // A circle may leave an edge by its tangent, and land on another.
                        let mut run = seen.iter().take_while(|f| f.at.0 < 4 * CELL && shape == BOX);
                        assert!(rise > step || run.all(|f| !f.hit_wall && f.floor.is_some()), "{}", tell());
                    }
                }
            });
        }
    }
}

/// No step leads to ground that is steeper than the slope limit.
#[test]
fn no_step_onto_a_wall() {
    for (rise, steep) in [(1, (5, 4)), (PX, (5, 4)), (3 * PX, (2, 1)), (PX / 2, (8, 1))] {
        let top = (2 * CELL, -rise - 2 * CELL * steep.0 / steep.1);
        Ground::corners(&[(-6 * CELL, 0), (0, 0), (0, -rise), top, (8 * CELL, top.1)]).with_polygon(|map| {
            for (shape, speed) in [BOX, Shape::Disc(2 * PX)].into_iter().flat_map(|s| [(s, PX / 2), (s, 3 * PX)]) {
                let seen = play(map, shape, &walker(6 * PX, 4 * PX), (-5 * CELL, 0), (speed, PX / 4), 400);
                let end = seen[seen.len() - 1];
                assert!(end.at.0 < 0 && end.hit_wall, "{shape:?}, {rise}, {steep:?}, by {speed}: {end:?}");
            }
        });
    }
}

/// Stairs of half tiles, up and down, even faster than they are wide.
#[test]
fn stairs_of_tiles() {
    for shape in [BOX, DISC, Shape::Rect(9 * PX, 4 * PX)] {
        for speed in [PX / 2, 2 * PX, 7 * PX, 20 * PX] {
            for up in [true, false] {
                let mut ground = Ground::of("__________________", 3, 8);
                let steps: [&[(usize, u8)]; 4] = [&[(7, 4)], &[(7, 1)], &[(7, 1), (6, 4)], &[(7, 1), (6, 1)]];
                for x in 0..18 {
                    let stair: usize = if up { x } else { 17 - x };
                    for &(y, id) in
                        steps.get(stair.wrapping_sub(6)).copied().unwrap_or(if stair < 6 { &[] } else { steps[3] })
                    {
                        ground.put(x, y, id);
                    }
                }
                let level = ground.level();
                let start = if up { (2 * CELL, 8 * CELL) } else { (2 * CELL, 6 * CELL) };
                let seen = play(
                    &level.all(),
                    shape,
                    &walker(30 * PX, 8 * PX),
                    start,
                    (speed, PX / 4),
                    (20 * CELL / speed) as u32,
                );
                for f in seen.iter().take_while(|f| f.at.0 < 16 * CELL) {
                    assert!(f.floor.is_some() && f.v == (speed, 0) && !f.hit_wall, "{shape:?} by {speed} {up}: {f:?}");
                }
                let end = seen.iter().find(|f| f.at.0 > 14 * CELL).unwrap();
                assert_eq!(
                    end.at.1,
                    (if up { 6 } else { 8 }) * CELL - shape.half(),
                    "{shape:?} by {speed} {up}: {end:?}"
                );
            }
        }
    }
}

/// A step in the same frame as a wall on top of it. The walker makes the step, and reports the wall
/// in that frame or the next one, not before. The step is half a tile, a ledge of a polygon or a
/// platform on the floor.
#[test]
fn a_wall_behind_a_step() {
    let mut ground = Ground::of("________________", 3, 8);
    ground.put(8, 7, 4);
    ground.put(9, 7, 1);
    ground.put(9, 6, 1);
    let tiles = ground.level();
    let corners = Ground::corners(&[
        (0, 8 * CELL),
        (8 * CELL, 8 * CELL),
        (8 * CELL, 15 * CELL / 2),
        (9 * CELL, 15 * CELL / 2),
        (9 * CELL, 6 * CELL),
        (16 * CELL, 6 * CELL),
    ]);
    ground.put(8, 7, 0);
    let bare = ground.level();
    let platform = Aabb::new(vec2((8 * CELL, 15 * CELL / 2)), vec2((9 * CELL, 8 * CELL))).unwrap();
    let solids = [Solid::new(platform, 1).unwrap()];
    for shape in [BOX, Shape::Disc(6 * PX)] {
        let mut both = 0;
        // A circle that is faster than it is wide leaves the edge by its tangent, and may be in the
        // air at the wall.
        for speed in [PX, 3 * PX, 11 * PX, 25 * PX].into_iter().filter(|&s| shape == BOX || s < 12 * PX) {
            for phase in 0..40 {
                let tell = |f: &Frame| format!("{shape:?} by {speed} {phase}: {f:?}");
                let judge = |seen: &[Frame]| {
                    let stop = seen.iter().position(|f| f.hit_wall).unwrap();
                    let (way, end) = (&seen[..stop], seen[stop]);
                    assert!(way.iter().all(|f| f.v == (speed, 0)), "{}", tell(&end));
                    // Up, at the wall, and not on before the call reports the wall.
                    let width = if let Shape::Rect(w, _) = shape { w } else { shape.half() };
                    assert!((9 * CELL - width - end.at.0 - 2).abs() <= 2 && end.v == (0, 0), "{}", tell(&end));
                    assert!((end.at.1 - 15 * CELL / 2 + shape.half() + 1).abs() <= 1, "{}", tell(&end));
                    assert!(seen[..=stop].iter().any(|f| f.stepped > 0), "{}", tell(&end));
                    seen[..=stop].iter().any(|f| f.hit_wall && f.stepped > 0)
                };
                let (from, v) = ((3 * CELL + phase * 40_961, 8 * CELL), (speed, PX / 4));
                let walker = walker(9 * PX, 8 * PX);
                judge(&play(&tiles.all(), shape, &walker, from, v, 120));
                corners.with_polygon(|map| judge(&play(map, shape, &walker, from, v, 120)));
                let solids = Solids::new(&solids);
                both += u32::from(judge(&play(&Joined::new(&bare.all(), &solids), shape, &walker, from, v, 120)));
            }
        }
        assert!(both > 0 || shape != BOX, "{shape:?}: both in one frame");
    }
}

/// A one-way wall of a tile that is higher than the step holds a walker from its side, however
/// round it is. With a step as high as the wall it steps over.
#[test]
fn a_one_way_wall_is_as_high_as_it_is() {
    let mut ground = Ground::of("________________", 3, 8);
    ground.put(8, 7, 37);
    let level = ground.level();
    for shape in [BOX, Shape::Disc(PX), Shape::Disc(3 * PX), Shape::Disc(8 * PX)] {
        for step in (1..16).map(|units| units * PX).chain([CELL - 1, CELL + 1]) {
            for speed in [PX / 3, 2 * PX, 5 * PX] {
                for phase in [0, 7_777, 40_961] {
                    let (from, v) = ((6 * CELL + phase, 8 * CELL), (speed, PX / 4));
                    let frames = (4 * CELL / speed) as u32;
                    let end = *play(&level.all(), shape, &walker(PX, step), from, v, frames).last().unwrap();
                    let beyond = end.at.0 > 8 * CELL;
                    assert_eq!(beyond, step > CELL, "{shape:?}, step {step}, by {speed}: {end:?}");
                }
            }
        }
    }
}

/// A polygon whose foot is narrower than its body meets the step with its middle, and comes down on
/// the edge before its foot is over it. It climbs what its walker's step allows, however slowly it
/// walks, and nothing higher.
#[test]
fn polygons_climb_on_a_narrow_foot() {
    let hexagon = [(-2, -7), (2, -7), (5, 0), (2, 7), (-2, 7), (-5, 0)];
    let trapezoid = [(-5, -7), (5, -7), (4, 7), (-4, 7)];
    let kite = [(-5, -7), (5, -7), (0, 7)];
    for corners in [&hexagon[..], &trapezoid, &kite] {
        for left in [false, true] {
            let side = if left { -1 } else { 1 };
            for more in [-1, 0, 1] {
                ledge(8 * PX + more, left).with_polygon(|map| {
                    for tenths in [3, 10, 15, 29, 30, 40, 90] {
                        let speed = side * tenths * PX / 10;
                        let at = |&(x, y): &(i64, i64)| vec2((x * PX - side * 12 * PX, y * PX - 7 * PX));
                        let mut body = ConvexPolygon::<6>::new(&corners.iter().map(at).collect::<Vec<_>>()).unwrap();
                        let (mut floor, walker, start) = (None, walker(8 * PX, 8 * PX), body.aabb().min());
                        for _ in 0..400 {
                            let walked = walker.walk(map, &body, vec2((speed, PX / 4)), floor).unwrap();
                            (body, floor) = (walked.moved.body, walked.floor);
                            if (body.aabb().min().x - start.x).abs() > 60 {
                                break;
                            }
                        }
                        let way = (body.aabb().min().x - start.x).abs();
                        assert_eq!(way > 60, more <= 0, "{corners:?} left {left}, 8 + {more} raw, by {speed}: {way}");
                    }
                });
            }
        }
    }
}

/// A step at the top of a slope, as seen by a body whose lowest point is on the slope, is higher
/// than it is from the top. What is hidden below the step does not matter.
#[test]
fn a_step_is_as_high_over_a_hole() {
    static KINDS: TileKinds = TileKinds::EMPTY
        .with(b'#', TileKind::FULL)
        .with(b'_', TileKind::of(TileShape::HalfBottom))
        .with(b'l', TileKind::of(TileShape::SlopeBottomLeft));
    fn end<B: Body>(level: &TileMap<'_, Slopes>, mut body: B, speed: i64) -> Vec2 {
        let (mut v, mut floor) = (Vec2::ZERO, None);
        for _ in 0..200 {
            let v_in = vec2((-speed, i64::from(v.raw().1) + PX / 4));
            let walked = walker(5 * PX, 8 * PX).walk(level, &body, v_in, floor).unwrap();
            (body, v, floor) = (walked.moved.body, walked.moved.velocity, walked.floor);
        }
        body.position()
    }
    let level = |rows| TileMap::<Slopes>::of_ascii(rows, &KINDS).unwrap();
    let levels =
        ["........\n........\n._......\n..l.....\n########", "........\n........\n#_......\n##l.....\n########"];
    let at = Vec2::from_ints(52, 30);
    for speed in [PX / 2, PX * 3 / 2] {
        let ends = levels.map(|rows| {
            let level = level(rows);
            let upright = Capsule::new(at, at + Vec2::from_ints(0, 7), fx(4 * PX)).unwrap();
            let lying = Capsule::new(at, at + Vec2::from_ints(8, 0), fx(4 * PX)).unwrap();
            let ball = Circle::new(at, fx(6 * PX)).unwrap();
            [end(&level, ball, speed), end(&level, upright, speed), end(&level, lying, speed)]
        });
        assert!(ends[0] == ends[1] && ends[0].iter().all(|end| end.x > 30), "{ends:?}");
    }
}
