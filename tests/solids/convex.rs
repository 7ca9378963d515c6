//! Many ticks of levels with convex solids and bodies, each one judged. No body is in the level,
//! and none is in a solid unless the call reports it as squashed. No solid passes a body, and
//! carried bodies move exactly. Shuffled and mirrored scenes give the same bits.

use tilesat::motion::{Ridden, Ride};
use tilesat::prelude::*;
use tilesat::world::ConvexSolid;
use tilesat::{Aabb, AllShapes, Capsule, Fx, Solid, TileMap};
use tilesat_judge::solids::convex::polygons;
use tilesat_judge::solids::shapes::{Figure, Rider, Scene, Seen, plank};
use tilesat_judge::solids::ticks::{
    ALL, CELL, FOLLOW, MOVER, SIDE, balls, boxes, capsules, grid, solids, steer, tiles,
};
use tilesat_judge::solids::twins::{BLOCKS, KINDS, mirrored_level};
use tilesat_judge::solids::{disc, rect, vec2};
use tilesat_judge::{Random, cases};

fn play(kinds: i64, seed: u64, count: u64, seen: &mut Seen) {
    let mut random = Random::new(seed);
    for _ in 0..cases(count) {
        let tiles = if kinds == 0 { vec![0; (SIDE * SIDE) as usize] } else { tiles(&mut random, kinds) };
        let mirror = mirrored_level(&tiles, SIDE as usize);
        let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
        let mirror = TileMap::<AllShapes>::of(&mirror, grid((-ALL, 0)), &KINDS).unwrap();
        let scene = Scene { level: &level, mirror: &mirror, open: kinds == 0 };
        scene.play(boxes, 40, &mut random, seen);
        scene.play(balls, 40, &mut random, seen);
        scene.play(capsules, 40, &mut random, seen);
        scene.play(polygons, 40, &mut random, seen);
    }
    println!("{seen:?}");
}

#[test]
fn bodies_in_the_open() {
    let mut seen = Seen::default();
    play(0, 281, 300, &mut seen);
    let least = [seen.free, seen.carried, seen.pushed, seen.squashed, seen.exact, seen.alone, seen.turned, seen.moves];
    assert!(least.iter().all(|&n| n > 9), "{seen:?}");
    // In the open each body can yield to a single solid.
    assert!(seen.dead == 0, "{seen:?}");
}

#[test]
fn bodies_among_blocks() {
    let mut seen = Seen::default();
    play(1, 282, 300, &mut seen);
    assert!(seen.free.min(seen.carried).min(seen.pushed).min(seen.squashed) > 9, "{seen:?}");
}

#[test]
fn bodies_among_all_shapes() {
    let mut seen = Seen::default();
    play(37, 283, 300, &mut seen);
    assert!(seen.free.min(seen.carried).min(seen.pushed).min(seen.squashed) > 9, "{seen:?}");
}

/// Boxes as convex solids carry and push boxes as plain ones do, to the bit.
#[test]
fn boxes_are_boxes() {
    let (mut random, mut seen, mut alive) = (Random::new(284), 0, 0);
    for _ in 0..cases(2_000) {
        let tiles = tiles(&mut random, 1);
        let level = TileMap::on_grid(&tiles, grid((0, 0)), &BLOCKS).unwrap();
        for _ in 0..20 {
            let mut list = solids(&mut random);
            steer(&mut list, &mut random);
            let plain = |s: &Solid| s.one_way().is_none();
            let list: Vec<_> =
                list.iter().filter(|s| plain(s)).map(|s| s.with_conveyor(tilesat::Vec2::ZERO).unwrap()).collect();
            let convex: Vec<_> = list
                .iter()
                .map(|s| ConvexSolid::new(s.shape(), s.key()).unwrap().with_motion(s.motion()).unwrap())
                .collect();
            let mut body = boxes(&mut random);
            if let (Some(s), true) = (list.first(), random.one_in(2)) {
                let over = tilesat::Vec2::new(s.shape().min().x - body.min().x, s.shape().min().y - body.max().y);
                body = body.translated(over).unwrap();
            }
            if level.overlaps(&body) {
                continue;
            }
            let follow = Fx::from_bits(FOLLOW as i32);
            let one = MOVER.ride(&level, &list, &body, follow).unwrap();
            let two = MOVER.ride_convex(&level, &convex, &body, follow).unwrap();
            let case = format!("{body:?}\n{list:?}\n{one:?}\n{two:?}");
            let inside = list.iter().any(|s| s.shape().overlaps(&body));
            // Of several solids that squash a body either may be named.
            let ride = |r: &Ridden<Aabb>| match r.ride {
                Ride::Squashed { .. } => None,
                ride => Some(ride),
            };
            let told = |r: &Ridden<Aabb>| (r.body, r.floor, r.carry, ride(r));
            if inside {
                continue;
            }
            // Where plain boxes find no way, convex ones may find that the body can stay.
            if ride(&one).is_none() && ride(&two).is_some() {
                let clear = !list.iter().any(|s| s.moved().shape().overlaps(&two.body));
                assert!(clear && !level.overlaps(&two.body), "{case}");
                alive += 1;
            } else {
                assert_eq!(told(&one), told(&two), "{case}");
            }
            seen += u32::from(one.ride != Ride::Free);
        }
    }
    println!("{seen} rides, {alive} more alive");
    assert!(seen > 1000 && alive * 1000 < seen);
}

/// A thin arm turns by up to forty degrees per tick among small bodies. None gets to its other
/// side, and none that it can push out is squashed. Of the bodies that are clear of the hull of
/// both positions, less than 1 % are pushed: no line that is tried is between that hull and the
/// body.
#[test]
fn no_arm_passes_a_body() {
    fn turn<B: Rider>(make: impl Fn(&mut Random) -> B, seed: u64, least: u32) {
        let (mut random, mut beside, mut pushed, mut squashed) = (Random::new(seed), 0, 0, 0);
        let (mut clear, mut moved) = (0, 0);
        let tiles = vec![0; (SIDE * SIDE) as usize];
        let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
        for _ in 0..cases(20_000) {
            let (long, wide) = (2 * CELL + random.within(0, CELL), random.within(2, CELL / 8));
            let angle = |random: &mut Random| {
                let (x, y) = (random.around(200), random.around(200));
                if (x, y) == (0, 0) { (1, 0) } else { (x, y) }
            };
            let from = angle(&mut random);
            // To the side by up to 40 degrees.
            let k = random.around(83);
            let to = (from.0 * 100 - from.1 * k, from.1 * 100 + from.0 * k);
            let arm = |direction| plank((0, 0), (long, wide), direction);
            let Ok(solid) = ConvexSolid::new(arm(from), 3) else { continue };
            let Ok(solid) = solid.with_turn(arm(to)) else { continue };
            let body = make(&mut random);
            if Figure::of(&arm(from)).meets(&body.figure()) {
                continue;
            }
            let ridden = MOVER.ride_convex(&level, &[solid], &body, Fx::ONE).unwrap();
            let centre = |b: &B| {
                let all = b.figure().points;
                let sum = |of: fn(&(i64, i64)) -> i64| all.iter().map(of).sum::<i64>() / all.len() as i64;
                (sum(|p| p.0), sum(|p| p.1))
            };
            // The side of the arm, and whether the body is beside it with all of its size, and not
            // where the arm's tip is in the middle of the turn only.
            let place = |dir: (i64, i64), c: (i64, i64), size: i64| {
                let (along, across) = (dir.0 * c.0 + dir.1 * c.1, dir.0 * c.1 - dir.1 * c.0);
                let length = (dir.0 * dir.0 + dir.1 * dir.1).isqrt() + 1;
                (along.abs() / length + size < long * 93 / 100).then_some(across.signum())
            };
            let size = ridden.body.any().aabb().size();
            let size = i64::from(size.x.to_bits().max(size.y.to_bits()));
            let sides = (place(from, centre(&body), size), place(to, centre(&ridden.body), size));
            if let (Some(before), Some(after)) = sides {
                assert_eq!(before, after, "{solid:?} {body:?} {ridden:?}");
                beside += 1;
            }
            pushed += u32::from(matches!(ridden.ride, Ride::Pushed { .. }));
            let mut both = Figure::of(&arm(from));
            both.points.extend(Figure::of(&arm(to)).points);
            if ridden.floor.is_none() && !both.meets(&body.figure()) {
                clear += 1;
                moved += u32::from(ridden.ride != Ride::Free);
            }
            if matches!(ridden.ride, Ride::Squashed { .. }) {
                squashed += 1;
            } else {
                assert!(!Figure::of(&arm(to)).meets(&ridden.body.figure()), "{solid:?} {body:?} {ridden:?}");
            }
        }
        println!("{beside} beside, {pushed} pushed, {squashed} squashed; {clear} clear, of these {moved} pushed");
        assert!(beside > 1000 && pushed > least && squashed == 0);
        assert!(moved * 100 < clear);
    }
    let at = |random: &mut Random| (random.around(3 * CELL), random.around(3 * CELL));
    turn(
        |random| {
            let c = at(random);
            rect(c, (c.0 + random.within(1, CELL / 2), c.1 + random.within(1, CELL / 2)))
        },
        285,
        1000,
    );
    turn(|random| disc(at(random), random.within(1, CELL / 4)), 286, 1000);
    turn(
        |random| {
            let (c, long) = (at(random), random.within(1, CELL / 2));
            let (x, y) = if random.one_in(2) { (long, 0) } else { (0, long) };
            let radius = Fx::from_bits(random.within(1, CELL / 8) as i32);
            Capsule::new(vec2(c), vec2((c.0 + x, c.1 + y)), radius).unwrap()
        },
        287,
        1000,
    );
    turn(polygons, 288, 400);
}
