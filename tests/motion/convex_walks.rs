//! Walkers and characters with sides in any direction, in random rooms: never inside, never through
//! a wall, never faster, not held where the floor leads on, and the same in a mirror.

#![allow(clippy::cast_precision_loss, reason = "lengths are below 2^30")]

use tilesat::prelude::*;
use tilesat::world::RayRules;
use tilesat::{
    AllShapes, Axis, Character, Feel, Fx, Grid, Input, Inside, Mover, Outcome, Outside, SlopeSpeed, TileMap, Vec2,
    Walked, Walker,
};
use tilesat_judge::convex::bodies::{Any, any, figure, raw, seen, way, width};
use tilesat_judge::convex::shape::Shape;
use tilesat_judge::rooms::body::vec2;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2};
use tilesat_judge::solids::twins::{KINDS, mirrored_level};
use tilesat_judge::{Random, cases};

use super::convex_bodies::{CELL, SIDE, tiles};

const ALL: i64 = SIDE as i64 * CELL;
const SOLID: RayRules = RayRules { one_way: true, inside: Inside::Hit };

fn room(tiles: &[u8], origin: P) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), vec2(origin)).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(Outside::Empty)
}

/// Raw units, a 512th of a unit. Walkers thinner than that may differ from their mirror images by a
/// few raw.
const THIN: f64 = 128.0;

/// A body in the room that overlaps nothing.
fn placed(r: &mut Random, map: &TileMap<'_, AllShapes>) -> Shape {
    loop {
        let c = (r.within(2 * CELL, ALL - 2 * CELL), r.within(2 * CELL, ALL - 2 * CELL));
        let shape = figure(r, c, 12 * PX).filter(|s| map.bounds().contains(&any(s).aabb()));
        if let Some(shape) = shape.filter(|s| !map.overlaps(&any(s))) {
            return shape;
        }
    }
}

#[derive(Debug, Default)]
struct Tally {
    frames: u64,
    stood: u64,
    stepped: u64,
    snapped: u64,
    blocked: u64,
    /// Blocked with a free way along the floor.
    dead: u64,
    creeps: u64,
    /// Bodies thinner than [`THIN`] that walked otherwise in the mirror.
    askew: u64,
}

fn walk(r: &mut Random, tally: &mut Tally) {
    let mut tiles = tiles(r);
    // Steps of half a cell on the ground.
    for tile in &mut tiles[SIDE * (SIDE - 2) + 1..SIDE * (SIDE - 1) - 1] {
        *tile = if r.one_in(3) { 4 } else { 0 };
    }
    let mirror = mirrored_level(&tiles, SIDE);
    let (map, mirror) = (room(&tiles, (0, 0)), room(&mirror, (-ALL, 0)));
    let mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(1 + r.below(2) as u16, 1);
    let speeds = if r.one_in(3) { SlopeSpeed::Projected } else { SlopeSpeed::Constant };
    let (snap, height) = (r.within(PX, 17 * PX), if r.one_in(3) { 0 } else { r.within(6 * PX, 18 * PX) });
    let walker = Walker::new(mover).with_slope_speed(speeds).with_snap(Fx::from_bits(snap as i32)).unwrap();
    let walker = walker.with_step(Fx::from_bits(height as i32)).unwrap();
    let step = |map: &TileMap<'_, AllShapes>, shape: &Shape, v, floor| {
        let walked: Walked<Any> = walker.walk(map, &any(shape), vec2(v), floor).unwrap();
        (walked, way(&any(shape), &walked.moved.body))
    };
    for _ in 0..6 {
        let mut shape = placed(r, &map);
        let (mut floor, mut mirror_floor, mut fall, mut speed) = (None, None, 0, PX);
        for _ in 0..80 {
            if r.one_in(12) {
                speed = r.within(-6 * PX, 6 * PX);
            }
            let v = (if r.one_in(40) { 0 } else { speed }, if r.one_in(90) { -4 * PX } else { fall + PX / 4 });
            let (out, d) = step(&map, &shape, v, floor);
            let tell = || format!("{walker:?} {shape:?} by {v:?} from {floor:?}: {out:?} {tiles:?}");
            assert!(!map.overlaps(&out.moved.body), "overlaps: {}", tell());
            assert!(map.bounds().contains(&out.moved.body.aabb()), "out of the room: {}", tell());
            let (there, e) = step(&mirror, &seen(View::MirrorX, &shape), (-v.0, v.1), mirror_floor);
            let velocity = raw(out.moved.velocity);
            let (seen, wanted) = ((e, raw(there.moved.velocity)), ((-d.0, d.1), (-velocity.0, velocity.1)));
            if seen != wanted && width(&shape) < THIN {
                tally.askew += 1;
                break;
            }
            assert_eq!(seen, wanted, "mirrored: {} {there:?}", tell());
            mirror_floor = there.floor;
            let (snapped, stepped) = (i64::from(out.snapped.to_bits()), i64::from(out.stepped.to_bits()));
            assert!(snapped <= snap && stepped <= 4 * height, "{}", tell());
            assert!(len2(velocity) <= len2(v), "faster: {}", tell());
            if floor.is_some() && v.1 >= 0 {
                tally.stood += 1;
                let most = (v.0.abs() + stepped + snapped + 4) as f64;
                assert!((len2(d) as f64).sqrt() <= most, "too far: {}", tell());
                assert!(out.floor.is_none() || velocity == (v.0, 0) || velocity == (0, 0), "{}", tell());
            }
            let next = shape.moved(d);
            if let Some(support) = out.floor {
                assert!(support.axis.y < 0, "{}", tell());
                if out.moved.wall && velocity == (0, 0) && v.0 != 0 && stepped == 0 {
                    tally.blocked += 1;
                    let (again, e) = step(&map, &next, (v.0, PX / 4), out.floor);
                    assert!(e.0 * v.0.signum() >= 0, "back: {} {again:?}", tell());
                    tally.creeps += u64::from(e != (0, 0));
                    // Half a unit along the floor, in the direction in which it wants to go.
                    let along = support.axis.perp().unit().scaled(Fx::from_bits(1 << 15));
                    let along = if raw(along).0.signum() == v.0.signum() { along } else { -along };
                    let free = map.cast_shape(&any(&next), along, SOLID).unwrap().is_none();
                    tally.dead += u64::from(e == (0, 0) && again.floor.is_some() && free);
                }
            }
            tally.frames += 1;
            tally.stepped += u64::from(stepped > 0);
            tally.snapped += u64::from(snapped > 0);
            (shape, floor, fall) = (next, out.floor, velocity.1.min(6 * PX));
        }
    }
}

#[test]
fn walkers_in_random_rooms() {
    let (mut r, mut tally) = (Random::new(71), Tally::default());
    for _ in 0..cases(150) {
        walk(&mut r, &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.stood > tally.frames / 4 && tally.stepped > 100 && tally.snapped > 100 && tally.blocked > 100);
    assert!(tally.dead == 0 && tally.askew * 1000 < tally.frames, "{tally:?}");
}

#[test]
fn characters_in_random_rooms() {
    let (mut r, mut frames, mut jumps, mut landings, mut stood) = (Random::new(72), 0, 0, 0, 0);
    for _ in 0..cases(150) {
        let tiles = tiles(&mut r);
        let mirror = mirrored_level(&tiles, SIDE);
        let (map, mirror) = (room(&tiles, (0, 0)), room(&mirror, (-ALL, 0)));
        let shape = placed(&mut r, &map);
        let feel = Feel { wall_jump: Some(Fx::from_num(2)), ..Feel::DEFAULT };
        let mut hero = Character::new(any(&shape), map.bounds(), feel);
        let mut twin = Character::new(any(&seen(View::MirrorX, &shape)), mirror.bounds(), feel);
        let (from, start) = (*hero.body(), *twin.body());
        let mut run = 0;
        for frame in 0..200 {
            if r.one_in(15) {
                run = r.within(-3 * PX, 3 * PX) as i32;
            }
            let input = Input { run: Fx::from_bits(run), jump: r.one_in(8), drop: r.one_in(20) };
            let before = (*hero.body(), hero.velocity);
            let step = hero.step(&map, input).unwrap();
            let other = twin.step(&mirror, Input { run: -input.run, ..input }).unwrap();
            let tell = || format!("{frame} {before:?} {input:?} {feel:?}: {step:?} {hero:?} {tiles:?}");
            assert_eq!(step.outcome, Outcome::Moved, "{}", tell());
            assert!(!map.overlaps(hero.body()), "inside: {}", tell());
            assert!(map.bounds().contains(&hero.body().aabb()), "out of the room: {}", tell());
            let (d, e) = (way(&from, hero.body()), way(&start, twin.body()));
            assert_eq!(
                (e, other.jumped, other.landed),
                ((-d.0, d.1), step.jumped, step.landed),
                "mirrored: {}",
                tell()
            );
            assert_eq!(twin.velocity, Vec2::new(-hero.velocity.x, hero.velocity.y), "mirrored: {}", tell());
            frames += 1;
            jumps += u64::from(step.jumped);
            landings += u64::from(step.landed);
            stood += u64::from(hero.on_floor());
        }
    }
    println!("{frames} frames, {jumps} jumps, {landings} landings, {stood} on floors");
    assert!(
        jumps > frames / 100 && landings > frames / 200 && stood > frames / 8,
        "{frames} {jumps} {landings} {stood}"
    );
}
