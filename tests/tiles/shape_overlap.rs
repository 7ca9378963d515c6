//! Overlap and touch of boxes and circles with every tile shape, against a judge written from the
//! definitions.

use tilesat_judge::blocks::build::OUTSIDES;
use tilesat_judge::shapes::build::{body, in_domain, mosaic};
use tilesat_judge::shapes::judge::{Body, Judge};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::shapes::met::Met;
use tilesat_judge::{Random, cases};

/// Radii that are small, as long as a half, a whole and two cells, give or take one.
fn radii(cell: i64) -> impl Iterator<Item = i64> {
    [cell / 7, cell / 2, cell, 2 * cell].into_iter().flat_map(|r| [r - 1, r, r + 1]).chain([1])
}

/// Each shape alone, and each with all of the plane around it solid; every body on the lattice of
/// eighths around it, and one raw beside.
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

/// All pairs of neighbours, in four directions: points and segments on their common side, and along
/// the lattice of quarters.
#[test]
fn every_pair_of_neighbours_with_bodies_without_area() {
    let cell = 256;
    let mut random = Random::new(3);
    let (mut met, rate) = (Met::default(), cases(100_000_u64).div_ceil(34 * 34 * 2));
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
