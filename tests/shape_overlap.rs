//! Overlap and touch of boxes and circles with every tile shape, against a judge written from the definitions.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    missing_docs,
    reason = "tests stop at the first surprise"
)]

mod solids;
mod support;

use solids::build::{body, in_domain, mosaic};
use solids::judge::{Body, Judge};
use solids::level::Level;
use support::build::OUTSIDES;
use support::cases;
use support::random::Random;
use tilesat::world::Set;
use tilesat::{Aabb, Circle, Fx, TileMap, Vec2};

fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// Both answers of a map.
fn answers<S: Set>(map: &TileMap<'_, S>, body: Body) -> (bool, bool) {
    match body {
        Body::Box { lo, hi } => {
            let b = Aabb::new(vec2(lo), vec2(hi)).unwrap();
            (map.overlaps(&b), map.touches(&b))
        }
        Body::Circle { c, r } => {
            let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
            (map.overlaps(&b), map.touches(&b))
        }
    }
}

/// Counts of what was met, so that a test cannot pass by meeting nothing.
#[derive(Default, Debug)]
struct Met {
    bodies: u64,
    blocks: u64,
    overlaps: u64,
    touches: u64,
}

impl Met {
    fn check(&mut self, level: &Level, judge: &Judge, body: Body) {
        let expected = (judge.overlaps(body), judge.touches(body));
        assert_eq!(answers(&level.all(), body), expected, "(overlaps, touches) {body:?}\n{level:?}");
        let mut words = vec![0; level.all().occupancy_words()];
        level.all().fill_occupancy(&mut words).unwrap();
        let skipping = level.all().with_occupancy(&words).unwrap();
        assert_eq!(answers(&skipping, body), expected, "with occupancy: {body:?}\n{level:?}");
        if let Some(blocks) = level.blocks() {
            assert_eq!(answers(&blocks, body), expected, "blocks: {body:?}\n{level:?}");
            self.blocks += 1;
        }
        self.bodies += 1;
        self.overlaps += u64::from(expected.0);
        self.touches += u64::from(expected.1 && !expected.0);
    }
}

/// Radii that are small, as long as a half, a whole and two cells, give or take one.
fn radii(cell: i64) -> impl Iterator<Item = i64> {
    [cell / 7, cell / 2, cell, 2 * cell].into_iter().flat_map(|r| [r - 1, r, r + 1]).chain([1])
}

/// Each shape alone, and each with all of the plane around it solid; every body on the lattice of eighths around it, and one raw beside.
#[test]
fn every_shape_on_the_lattice_of_eighths() {
    let cell = 2 * 7 * 64;
    let (mut met, mut turn) = (Met::default(), 0);
    let keep = cases(100_000).max(1);
    let all = 38 * 3 * 25 * 25 * (13 + 16);
    for id in 0..38 {
        for outside in OUTSIDES {
            let level = Level { width: 1, height: 1, cell, x: -cell, y: 3 * cell, outside, tiles: vec![id] };
            let judge = Judge::new(&level);
            for place in 0..25 * 25 {
                let at = |k: i64| (k - 8) * cell / 8;
                let p = (level.x + at(place % 25), level.y + at(place / 25));
                let sizes = [0, 1, cell / 8, cell];
                let boxes = (0..16).map(|i| Body::Box { lo: p, hi: (p.0 + sizes[i % 4], p.1 + sizes[i / 4]) });
                for body in radii(cell).map(|r| Body::Circle { c: p, r }).chain(boxes) {
                    turn += keep;
                    if turn >= all {
                        turn -= all;
                        met.check(&level, &judge, body);
                    }
                }
            }
        }
    }
    assert!(met.overlaps > met.bodies / 4 && met.touches > met.bodies / 100, "{met:?}");
    println!("{met:?}");
}

/// All pairs of neighbours, in four directions: points and segments on their common side, and along the lattice of quarters.
#[test]
fn every_pair_of_neighbours_with_bodies_without_area() {
    let cell = 256;
    let mut random = Random::new(3);
    let (mut met, rate) = (Met::default(), cases(100_000).div_ceil(34 * 34 * 2));
    for a in 0..34 {
        for b in 0..34 {
            for (width, height) in [(2, 1), (1, 2)] {
                let outside = OUTSIDES[random.below(3) as usize];
                let level = Level { width, height, cell, x: 0, y: -cell, outside, tiles: vec![a, b] };
                let judge = Judge::new(&level);
                for _ in 0..rate {
                    let quarter = |random: &mut Random, count: i64| {
                        random.within(-1, 4 * count + 1) * cell / 4
                            + if random.one_in(4) { random.around(1) } else { 0 }
                    };
                    // A coordinate on the common side more often than not.
                    let on = |random: &mut Random, count: i64| {
                        if count == 2 && random.one_in(2) { cell } else { quarter(random, count) }
                    };
                    let (x, y) = (on(&mut random, width), level.y + on(&mut random, height));
                    let (u, v) = (quarter(&mut random, width), level.y + quarter(&mut random, height));
                    let body = match random.below(6) {
                        0 => Body::Box { lo: (x, y), hi: (x, y) },
                        1 => Body::Circle { c: (x, y), r: 0 },
                        // Along the common side, and across it.
                        k if (k < 4) == (width == 2) => Body::Box { lo: (x, y.min(v)), hi: (x, y.max(v)) },
                        _ => Body::Box { lo: (x.min(u), y), hi: (x.max(u), y) },
                    };
                    met.check(&level, &judge, body);
                }
            }
        }
    }
    assert!(met.overlaps > met.bodies / 8 && met.touches > met.bodies / 8, "{met:?}");
    println!("{met:?}");
}

#[test]
fn mosaics_equal_the_definitions() {
    let mut random = Random::new(34);
    let (mut met, total) = (Met::default(), cases(80_000));
    while met.bodies < total {
        let level = mosaic(&mut random);
        let judge = Judge::new(&level);
        for _ in 0..50 {
            let body = body(&mut random, &level);
            if in_domain(body) {
                met.check(&level, &judge, body);
            }
        }
    }
    assert!(met.overlaps > met.bodies / 5 && met.blocks > met.bodies / 50 && met.touches > met.bodies / 50, "{met:?}");
    println!("{met:?}");
}
