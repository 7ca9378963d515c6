//! Many ticks of levels with convex solids and bodies, each one judged. No body is in the level,
//! and none is in a solid unless the call reports it as squashed. No solid passes a body, and
//! carried bodies move exactly. Shuffled and mirrored scenes give the same bits.

use tilesat::{AllShapes, TileMap};
use tilesat_judge::solids::convex::polygons;
use tilesat_judge::solids::shapes::{Scene, Seen};
use tilesat_judge::solids::ticks::{ALL, SIDE, balls, boxes, capsules, grid, tiles};
use tilesat_judge::solids::twins::{KINDS, mirrored_level};
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
