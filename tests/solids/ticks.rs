//! Many ticks of levels with solids and bodies, each one judged. No body is in the level, and none
//! is in a solid unless the call reports it as squashed. No solid passes a body, and carried bodies
//! move exactly. Shuffled, mirrored and translated scenes give the same bits.

use tilesat::{AllShapes, TileMap};
use tilesat_judge::solids::convex::polygons;
use tilesat_judge::solids::judge::Block;
use tilesat_judge::solids::ticks::{ALL, CELL, SIDE, Scene, Seen, balls, boxes, capsules, grid, tiles};
use tilesat_judge::solids::twins::{BLOCKS, KINDS, mirrored_level};
use tilesat_judge::{Random, cases};

#[test]
fn bodies_among_blocks() {
    let (mut random, mut seen) = (Random::new(81), Seen::default());
    for _ in 0..cases(tilesat_judge::thorough(200, 600)) {
        let tiles = tiles(&mut random, 1);
        let by = (random.around(900_000), random.around(900_000));
        let mirror = mirrored_level(&tiles, SIDE as usize);
        let level = TileMap::on_grid(&tiles, grid((0, 0)), &BLOCKS).unwrap();
        let mirror = TileMap::on_grid(&mirror, grid((-ALL, 0)), &BLOCKS).unwrap();
        let moved = TileMap::on_grid(&tiles, grid(by), &BLOCKS).unwrap();
        let full = (0..SIDE * SIDE).filter(|&i| tiles[i as usize] == 1);
        let cells = full
            .map(|i| (i % SIDE * CELL, i / SIDE * CELL))
            .map(|lo| Block { lo, hi: (lo.0 + CELL, lo.1 + CELL) })
            .collect();
        let scene = Scene { level: &level, mirror: &mirror, moved: &moved, by, cells: Some(cells) };
        scene.play(boxes, 40, &mut random, &mut seen);
        scene.play(balls, 40, &mut random, &mut seen);
        scene.play(capsules, 40, &mut random, &mut seen);
        scene.play(polygons, 40, &mut random, &mut seen);
    }
    println!("{seen:?}");
    let least = [seen.free, seen.carried, seen.pushed, seen.squashed, seen.exact, seen.alone];
    assert!(least.iter().all(|&n| n > 9), "{seen:?}");
}

#[test]
fn bodies_among_all_shapes() {
    let (mut random, mut seen) = (Random::new(82), Seen::default());
    for _ in 0..cases(tilesat_judge::thorough(200, 600)) {
        let tiles = tiles(&mut random, 37);
        let by = (random.around(900_000), random.around(900_000));
        let mirror = mirrored_level(&tiles, SIDE as usize);
        let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
        let mirror = TileMap::<AllShapes>::of(&mirror, grid((-ALL, 0)), &KINDS).unwrap();
        let moved = TileMap::<AllShapes>::of(&tiles, grid(by), &KINDS).unwrap();
        let scene = Scene { level: &level, mirror: &mirror, moved: &moved, by, cells: None };
        scene.play(boxes, 40, &mut random, &mut seen);
        scene.play(balls, 40, &mut random, &mut seen);
        scene.play(capsules, 40, &mut random, &mut seen);
        scene.play(polygons, 40, &mut random, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.free > 9 && seen.carried > 9 && seen.pushed > 9 && seen.squashed > 9, "{seen:?}");
}
