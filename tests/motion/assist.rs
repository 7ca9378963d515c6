//! Corners and gaps that a body narrowly misses, compared with all ways aside.

use tilesat::{Aabb, Axis, Blocks, Circle, Fx, Grid, Inside, Mover, Quantity, TileKind, TileKinds, TileMap, Vec2};
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

/// The least displacement aside, try by try. Its whole way is free, and from its end the motion
/// gets farther into the obstacle.
fn least(map: &TileMap<'_, Blocks>, mover: &Mover, body: &Aabb, d: (i64, i64), reach: i64) -> Option<(i64, i64)> {
    let hit = map.cast_shape(body, vec2(d), Inside::Ignore).unwrap()?;
    let normal = hit.hit.axis;
    if *mover != Mover::new() && normal == Axis::NEG_Y {
        return None;
    }
    let into = |v: (i64, i64)| v.0 * i64::from(normal.x) + v.1 * i64::from(normal.y);
    let tangent = (-i64::from(normal.y), i64::from(normal.x));
    let with = if tangent.0 * d.0 + tangent.1 * d.1 < 0 { -1 } else { 1 };
    let made = into(slide(map, mover, body, d));
    let ways = (1..=reach).flat_map(|n| [n * with, -n * with]).map(|n| (tangent.0 * n, tangent.1 * n));
    ways.into_iter().find(|&aside| {
        let free = map.cast_shape(body, vec2(aside), Inside::Ignore).unwrap().is_none();
        let from = shifted(body, aside);
        // At least to the depth of the hit, and there farther, or along the side of a gap.
        let reached = map.cast_shape(&from, vec2(d), Inside::Ignore).unwrap().is_none_or(|next| {
            let depth =
                |b: &Aabb, of: &Aabb| into(((b.min() - of.min()).raw().0.into(), (b.min() - of.min()).raw().1.into()));
            depth(&next.body, &from) <= depth(&hit.body, body)
        });
        free && reached && into(slide(map, mover, &from, d)) < made
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

        let ball = Circle::new(vec2((3 * CELL - miss, 3 * CELL + 130)), Fx::from_bits(100)).unwrap();
        let aside = mover.assist(&map, &ball, up, Fx::from_bits(reach)).unwrap();
        let moved = (aside.centre() - ball.centre()).raw();
        assert!(moved.1 == 0 && (0..=reach).contains(&moved.0) && !map.overlaps(&aside), "{miss} {aside:?}");
    }
}

/// A walk along the wall at any speed up to the reach finds a gap exactly as wide as the body.
#[test]
fn a_gap_as_wide_as_the_body() {
    let tiles: Vec<u8> = (0..SIDE * SIDE).map(|k| if k / SIDE == 2 && k % SIDE != 3 { b'#' } else { b'.' }).collect();
    let (map, mover) = (map(&tiles), Mover::new());
    for (speed, start) in (1..90).flat_map(|speed| [0, 1, 7].map(|start| (speed, start))) {
        for side in [1, -1] {
            let x = if side > 0 { start } else { 6 * CELL - start };
            let mut body = Aabb::new(vec2((x, 3 * CELL)), vec2((x + CELL, 4 * CELL))).unwrap();
            let v = vec2((side * speed, -speed));
            for _ in 0..8 * CELL / speed {
                body = mover.assist(&map, &body, v, Fx::from_bits(speed as i32)).unwrap();
                body = mover.move_and_slide(&map, &body, v).unwrap().body;
            }
            assert!(body.max().y.to_bits() < 2 * CELL as i32, "{speed} {start} {side}: {body:?}");
        }
    }
    let body = Aabb::new(Vec2::ZERO, vec2((9, 9))).unwrap();
    let refused = mover.assist(&map, &body, Vec2::ZERO, Fx::from_bits(-1));
    assert!(matches!(refused, Err(tilesat::MoveError::Range(e)) if e.what == Quantity::Assist));
}
