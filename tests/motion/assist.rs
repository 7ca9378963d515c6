//! Corners and gaps that a body narrowly misses, compared with all ways aside.

use tilesat::motion::Body;
use tilesat::{
    Aabb, Axis, Blocks, Capsule, Character, Circle, ConvexPolygon, Feel, Fx, Grid, Input, Inside, Mover, Outcome,
    Quantity, TileKind, TileKinds, TileMap, Vec2, fx,
};
use tilesat_judge::Random;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const CELL: i64 = 256;
const SIDE: i64 = 7;

fn vec2(p: (i64, i64)) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

fn map(tiles: &[u8]) -> TileMap<'_, Blocks> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), Vec2::ZERO).unwrap();
    TileMap::on_grid(tiles, grid, &KINDS).unwrap()
}

fn shifted(body: &Aabb, by: (i64, i64)) -> Aabb {
    body.translated(vec2(by)).unwrap()
}

/// How far a slide gets.
fn slide(map: &TileMap<'_, Blocks>, mover: &Mover, body: &Aabb, d: (i64, i64)) -> (i64, i64) {
    let made = (mover.move_and_slide(map, body, vec2(d)).unwrap().position() - body.min()).raw();
    (made.0.into(), made.1.into())
}

/// The least displacement aside, try by try. Its whole way is free, it does not lead against the
/// motion, and from its end the motion gets farther into the obstacle. If both sides of a gap stop
/// the motion there, it also leads a raw unit into the gap.
fn least(map: &TileMap<'_, Blocks>, mover: &Mover, body: &Aabb, d: (i64, i64), reach: i64) -> Option<(i64, i64)> {
    let hit = map.cast_shape(body, vec2(d), Inside::Ignore).unwrap()?;
    let normal = hit.hit.axis;
    if *mover != Mover::new() && normal == Axis::NEG_Y {
        return None;
    }
    let into = |v: (i64, i64)| v.0 * i64::from(normal.x) + v.1 * i64::from(normal.y);
    let tangent = (-i64::from(normal.y), i64::from(normal.x));
    let with = tangent.0 * d.0 + tangent.1 * d.1;
    let made = into(slide(map, mover, body, d));
    let ways = (1..=reach).flat_map(|n| [n, -n]).filter(|n| n * with >= 0).map(|n| (tangent.0 * n, tangent.1 * n));
    let depth = |b: &Aabb, of: &Aabb| into(((b.min() - of.min()).raw().0.into(), (b.min() - of.min()).raw().1.into()));
    let was = depth(&hit.body, body);
    ways.into_iter().find_map(|aside| {
        let free = |from: &Aabb, way| map.cast_shape(from, vec2(way), Inside::Ignore).unwrap().is_none();
        let from = shifted(body, aside);
        if !free(body, aside) {
            return None;
        }
        // At least to the depth of the hit, and there farther, or along the side of a gap.
        let next = map.cast_shape(&from, vec2(d), Inside::Ignore).unwrap();
        let next = next.map_or(i64::MIN, |next| depth(&next.body, &from));
        let ahead = (-i64::from(normal.x), -i64::from(normal.y));
        let by =
            if next == 0 && was == 0 && free(&from, ahead) { (aside.0 + ahead.0, aside.1 + ahead.1) } else { aside };
        let leads = into(slide(map, mover, &shifted(body, by), d)) < made;
        (next <= was && leads).then_some(by)
    })
}

#[test]
fn the_least_way_aside_that_leads_on() {
    let mut r = Random::new(41);
    let (mut asides, mut all) = (0, 0);
    for _ in 0..3000 {
        let tiles: Vec<u8> = (0..SIDE * SIDE).map(|_| if r.one_in(3) { b'#' } else { b'.' }).collect();
        let map = map(&tiles);
        for _ in 0..8 {
            let size = [CELL, CELL - 1, CELL / 2, 2 * CELL, r.within(1, CELL)];
            let (w, h) = (size[r.below(5) as usize], size[r.below(5) as usize]);
            let at = |r: &mut Random| r.within(0, SIDE) * CELL + [0, 1, -1, 3, -9, 40][r.below(6) as usize];
            let (x, y) = (at(&mut r), at(&mut r));
            let body = Aabb::new(vec2((x, y)), vec2((x + w, y + h))).unwrap();
            if map.overlaps(&body) {
                continue;
            }
            let d = (r.around(CELL), [0, 1][r.below(2) as usize] * r.around(CELL));
            let d = if r.one_in(2) { d } else { (d.1, d.0) };
            // Now and then past more than one obstacle.
            let reach = if r.one_in(6) { r.within(24, 3 * CELL) } else { r.within(0, 24) };
            let up = r.one_in(2);
            let mover = if up { Mover::platformer(Axis::NEG_Y) } else { Mover::new() };
            let aside = mover.assist(&map, &body, vec2(d), Fx::from_bits(reach as i32)).unwrap();
            let expected = least(&map, &mover, &body, d, reach).unwrap_or((0, 0));
            assert_eq!(aside, shifted(&body, expected), "{body:?} {d:?} {reach} {up} {:?}", tiles.chunks(7));
            (all, asides) = (all + 1, asides + u32::from(expected != (0, 0)));
        }
    }
    assert!(asides > 300, "{asides} of {all}");
}

/// A head under a corner by up to the reach, to the raw unit. Also a ball, for which a corner is
/// rounder.
#[test]
fn a_head_under_a_corner() {
    let tiles: Vec<u8> = (0..SIDE * SIDE).map(|k| if k / SIDE < 3 && k % SIDE < 3 { b'#' } else { b'.' }).collect();
    let (map, mover, reach) = (map(&tiles), Mover::platformer(Axis::NEG_Y), 20);
    let up = vec2((0, -100));
    for miss in 0..25 {
        let body = Aabb::new(vec2((3 * CELL - miss, 4 * CELL)), vec2((4 * CELL, 5 * CELL))).unwrap();
        let (close, far) = (shifted(&body, (0, 50 - CELL)), shifted(&body, (0, CELL)));
        let aside = mover.assist(&map, &close, up, Fx::from_bits(reach)).unwrap();
        let by = if miss <= i64::from(reach) { miss } else { 0 };
        assert_eq!(aside, shifted(&close, (by, 0)), "{miss}");
        let moved = mover.move_and_slide(&map, &aside, up).unwrap();
        assert_eq!(
            (moved.ceiling, moved.velocity),
            if by == miss { (false, up) } else { (true, Vec2::ZERO) },
            "{miss}"
        );
        // Nothing is in the way yet.
        assert_eq!(mover.assist(&map, &far, up, Fx::from_bits(reach)).unwrap(), far);
    }
}

/// A round or pointed body that rises past a corner steps aside as a box does, or not at all. What
/// it did: a ball beside the corner lost speed to it. A ball below it stepped aside, and hit it.
#[test]
fn a_round_head_under_a_corner() {
    fn check<B: Body>(make: impl Fn(i64) -> B, half: i64) {
        let tiles: Vec<u8> = (0..SIDE * SIDE).map(|k| if k / SIDE < 3 && k % SIDE < 3 { b'#' } else { b'.' }).collect();
        let (map, mover, reach) = (map(&tiles), Mover::platformer(Axis::NEG_Y), 60);
        let mut passed = 0;
        for miss in 0..2 * half {
            let body = make(3 * CELL + half - miss);
            let (mut with, mut alone, mut aside) = (body, body, 0);
            let (mut hit, mut v) = (false, vec2((0, -40)));
            for _ in 0..12 {
                let next = mover.assist(&map, &with, v, Fx::from_bits(reach)).unwrap();
                aside += (next.position() - with.position()).raw().0;
                let moved = mover.move_and_slide(&map, &next, v).unwrap();
                hit |= !moved.hits.is_empty();
                (with, v) = (moved.body, moved.velocity);
                alone = mover.move_and_slide(&map, &alone, vec2((0, -40))).unwrap().body;
            }
            if i64::from(reach) < miss {
                assert_eq!(aside, 0, "{miss}");
            } else {
                assert!(!hit && i64::from(aside) == miss, "{miss} {aside}");
                assert_eq!((with.position() - body.position()).raw(), (miss as i32, -480), "{miss}");
                passed += u32::from(alone.position().raw().1 != with.position().raw().1);
            }
        }
        assert!(passed > 30, "{passed}");
    }
    let at = |x: i64, y: i64| vec2((x, 3 * CELL + 130 + y));
    check(|x| Circle::new(at(x, 0), Fx::from_bits(100)).unwrap(), 100);
    check(|x| Capsule::new(at(x, 0), at(x, 90), Fx::from_bits(70)).unwrap(), 70);
    check(|x| ConvexPolygon::<4>::new(&[at(x, -90), at(x + 80, 0), at(x, 90), at(x - 80, 0)]).unwrap(), 80);
}

/// A point in one of eight views, mirrored or with x and y exchanged.
fn seen((x, y): (i64, i64), view: u8) -> (i64, i64) {
    let p = (if view & 1 == 0 { x } else { -x }, if view & 2 == 0 { y } else { -y });
    if view & 4 == 0 { p } else { (p.1, p.0) }
}

/// The point that a view shows there.
fn unseen(p: (i64, i64), view: u8) -> (i64, i64) {
    seen(if view & 4 == 0 { p } else { (p.1, p.0) }, view & 3)
}

/// A walk along the wall at any speed up to the reach finds a gap exactly as wide as the body, or
/// somewhat wider, at any speed into the wall.
#[test]
fn a_gap_as_wide_as_the_body() {
    let mover = Mover::new();
    let boxed = |a: (i64, i64), b: (i64, i64)| {
        Aabb::new(vec2((a.0.min(b.0), a.1.min(b.1))), vec2((a.0.max(b.0), a.1.max(b.1)))).unwrap()
    };
    for view in 0..8 {
        // The middle of the level is the origin. The wall is in the row before it.
        let wall = |(i, j): (i64, i64)| if j == -1 && i != 0 { b'#' } else { b'.' };
        let tiles: Vec<u8> = (0..SIDE * SIDE).map(|k| wall(unseen((k % SIDE - 3, k / SIDE - 3), view))).collect();
        let (half, corner) = (CELL / 2, -SIDE * CELL / 2);
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), vec2((corner, corner))).unwrap();
        let map = TileMap::<Blocks>::on_grid(&tiles, grid, &KINDS).unwrap();
        for (speed, start) in (1..90).flat_map(|speed| [0, 1, 7].map(|start| (speed, corner + start))) {
            for (into, slack) in [(speed, 0), (speed / 3 + 1, 0), (2 * speed, 0), (speed + 1, 1), (speed, 20)] {
                let mut body = boxed(seen((start, -half), view), seen((start + CELL - slack, half), view));
                let v = vec2(seen((speed, -into), view));
                for _ in 0..8 * CELL / speed {
                    body = mover.assist(&map, &body, v, Fx::from_bits(speed as i32)).unwrap();
                    body = mover.move_and_slide(&map, &body, v).unwrap().body;
                }
                let end = body.centre().raw();
                let end = unseen((end.0.into(), end.1.into()), view);
                assert!(end.1 < -3 * half, "view {view}, {speed} along, {into} into, slack {slack}, {start}: {body:?}");
            }
        }
    }
    let body = Aabb::new(Vec2::ZERO, vec2((9, 9))).unwrap();
    let refused = mover.assist(&map(&[b'.'; 49]), &body, Vec2::ZERO, Fx::from_bits(-1));
    assert!(matches!(refused, Err(tilesat::MoveError::Range(e)) if e.what == Quantity::Assist));
}

/// Frames at one input. No assist takes back what the frames before have made, so the body does not
/// go to and fro. It stands still only if it does so without assist.
fn advances<B: Body>(map: &TileMap<'_, Blocks>, mut body: B, (v, reach): ((i64, i64), i64), of: &str) -> u32 {
    let (mover, mut asides) = (Mover::new(), 0);
    for frame in 0..40 {
        let plain = mover.move_and_slide(map, &body, vec2(v)).unwrap().body;
        let aside = mover.assist(map, &body, vec2(v), Fx::from_bits(reach as i32)).unwrap();
        let next = mover.move_and_slide(map, &aside, vec2(v)).unwrap().body;
        let made = |b: &B| (b.position() - body.position()).dot(vec2(v));
        let seen =
            || format!("{of} by {v:?}, reach {reach}, frame {frame}: {:?} {:?}", body.position(), aside.position());
        assert!(made(&aside) >= 0, "{}", seen());
        assert!(aside.position() == body.position() || made(&next) > made(&aside), "{}", seen());
        assert!(made(&next) > 0 || made(&plain) <= 0, "{}", seen());
        asides += u32::from(aside.position() != body.position());
        body = next;
    }
    asides
}

#[test]
fn what_is_made_is_never_undone() {
    let (mut r, mut asides) = (Random::new(43), 0);
    for _ in 0..400 {
        let edge = |k: i64| k % SIDE == 0 || k / SIDE == 0 || k % SIDE == SIDE - 1 || k / SIDE == SIDE - 1;
        let tiles: Vec<u8> = (0..SIDE * SIDE).map(|k| if edge(k) || r.one_in(3) { b'#' } else { b'.' }).collect();
        let (map, text) = (
            map(&tiles),
            format!("{:?}", tiles.chunks(SIDE as usize).map(String::from_utf8_lossy).collect::<Vec<_>>()),
        );
        for _ in 0..20 {
            let side = |r: &mut Random| [CELL, CELL - 1, CELL - 20, CELL - 60, CELL / 2][r.below(5) as usize];
            let (w, h) = (side(&mut r), side(&mut r));
            let (x, y) = (r.within(CELL, 5 * CELL), r.within(CELL, 5 * CELL));
            let speed = [r.within(1, 9), r.within(9, CELL / 4)][r.below(2) as usize];
            let (a, b) = ([-1, 1][r.below(2) as usize], [-1, 1][r.below(2) as usize]);
            let v = [(a * speed, b * speed), (a * speed, b * r.within(0, speed)), (a * r.within(0, speed), b * speed)];
            let asked = (v[r.below(3) as usize], r.within(1, CELL / 2));
            let body = Aabb::new(vec2((x, y)), vec2((x + w, y + h))).unwrap();
            let ball = Circle::new(vec2((x + w / 2, y + w / 2)), Fx::from_bits((w / 2) as i32)).unwrap();
            if !map.overlaps(&body) {
                asides += advances(&map, body, asked, &text);
            }
            if !map.overlaps(&ball) {
                asides += advances(&map, ball, asked, &text);
            }
        }
    }
    assert!(asides > 300, "{asides}");
}

/// With a diagonal held, a hero gets into the corridor into which it walks without assist.
#[test]
fn a_diagonal_past_a_corridor() {
    let room = "########
#......#
#.##.###
#.##.###
#......#
########";
    let (level, mover) = (TileMap::from_ascii(room, &KINDS).unwrap(), Mover::new());
    for size in [fx!(10), fx!(12), fx!(14), fx!(15), fx!(15.99), fx!(16)] {
        for (speed, start) in [fx!(0.5), fx!(1.5), fx!(2)].into_iter().flat_map(|v| (0..9).map(move |k| (v, k))) {
            let walk = Axis::new(1, 1).unit().scaled(speed);
            let at = Vec2::new(fx!(36) + fx!(0.373) * start, fx!(32) - size);
            let mut body = Aabb::from_size(at, Vec2::new(size, size)).unwrap();
            for _ in 0..400 {
                body = mover.assist(&level, &body, walk, fx!(4)).unwrap();
                body = mover.move_and_slide(&level, &body, walk).unwrap().body;
            }
            assert_eq!(body.max(), Vec2::from_ints(112, 80), "{size} {speed} {start}");
        }
    }
}

/// A hero that jumps and runs under a shaft. What gets in with some reach, does so with a larger
/// one.
#[test]
fn a_larger_reach_misses_no_shaft() {
    let text = ["####.####"; 4].join(
        "
",
    ) + "
#.......#
#.......#
#.......#
#########";
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let jump = Input { run: fx!(1.5), jump: true, drop: false };
    let gets_in = |start: i32, reach: i16| {
        let at = Vec2::new(fx!(52) + fx!(0.5) * start, fx!(98));
        let body = Aabb::from_size(at, Vec2::from_ints(15, 14)).unwrap();
        let mut hero = Character::new(body, level.bounds(), Feel { jump: fx!(7), ..Feel::DEFAULT });
        let _ = hero.step(&level, Input::default()).unwrap();
        (0..60).any(|_| {
            hero.assist(&level, jump, reach.into()).unwrap();
            hero.step(&level, jump).unwrap().outcome == Outcome::Moved && hero.body().min().y < 50
        })
    };
    let reaches = [0, 2, 4, 6];
    let count = reaches.map(|reach| (0..40).filter(|&start| gets_in(start, reach)).count());
    assert_eq!(count, [2, 6, 10, 14]);
    for start in 0..40 {
        assert!(reaches.windows(2).all(|pair| !gets_in(start, pair[0]) || gets_in(start, pair[1])), "{start}");
    }
}
