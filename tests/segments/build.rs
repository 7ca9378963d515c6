//! The tables of segment maps: the cells of a segment, the inside, the rest of shared edges, and
//! where the boundary continues.
//!
//! `TILESAT_CASES` sets the number of random levels of each kind (default 1500).

use tilesat::PathKind::{OneWay, Solid, Wall};
use tilesat::{Fx, Grid, Vec2};
use tilesat_judge::paths;
use tilesat_judge::paths::generate;
use tilesat_judge::paths::level::{Shape, bytes_on, decode, level, placed, shape};
use tilesat_judge::paths::oracle::{check_outline, check_refs, check_winding, polygon_edges};
use tilesat_judge::paths::vertices::check_joints;
use tilesat_judge::{Random, cases};

/// Powers of two and not: 2^8, 2 * 3 * 43, 2 * 7 * 64.
const CELLS: [i64; 3] = [256, 258, 896];

#[test]
fn short_segments_meet_the_cells_that_they_meet() {
    for cell in CELLS {
        let lines = [0, 1, 2].map(|i| i * cell);
        let coordinates: Vec<i64> = lines
            .iter()
            .flat_map(|&v| [v - 1, v, v + 1, v + cell / 2])
            .filter(|v| (0..=2 * cell).contains(v))
            .collect();
        let points: Vec<_> = coordinates.iter().flat_map(|&x| coordinates.iter().map(move |&y| (x, y))).collect();
        for origin in [(0, 0), (-517, 300_001)] {
            let grid = Grid::new(2, 2, Fx::from_bits(cell as i32), Vec2::from_raw(origin.0, origin.1)).unwrap();
            for &a in &points {
                for &b in points.iter().filter(|&&b| b != a) {
                    let line = placed(&[shape(OneWay, &[a, b])], 1, (i64::from(origin.0), i64::from(origin.1)));
                    check_refs(&decode(&bytes_on(&line, grid).unwrap()));
                }
            }
        }
    }
}

#[test]
fn long_segments_meet_the_cells_that_they_meet() {
    let mut random = Random::new(31);
    for case in 0..cases(1500) {
        let cell = [256, 258, 896, 1 << 20, (1 << 24) - 2, 3 << 19][random.below(6) as usize];
        let n = random.within(1, 12);
        // On lines and corners, one or two raw beside them, or anywhere.
        let coordinate = |random: &mut Random| {
            let line = random.within(0, n) * cell;
            let v = match random.below(4) {
                0 => line,
                1 => line + random.around(2),
                2 => line + cell / 2,
                _ => random.within(0, n * cell),
            };
            v.clamp(0, n * cell)
        };
        let mut point = || (coordinate(&mut random), coordinate(&mut random));
        let (a, b) = (point(), point());
        if a != b {
            let limit = (1 << 29) - 1 - n * cell;
            let by = if case % 3 == 0 { (limit, 1 - (1 << 29)) } else { (random.around(limit), random.around(limit)) };
            check_refs(&level(&placed(&[shape(Wall, &[a, b])], 1, by), cell));
        }
    }
}

fn check(shapes: &[Shape], cell: i64) {
    let level = level(shapes, cell);
    check_refs(&level);
    check_winding(&level, &polygon_edges(shapes));
    check_joints(&level);
}

#[test]
fn mosaics_are_their_outline() {
    let mut random = Random::new(5);
    for _ in 0..cases(tilesat_judge::thorough(400, 1500)) {
        let shapes = generate::mosaic(&mut random);
        // Tiles of 128 raw; the lattice step of the outline is 64.
        let near = placed(&shapes, 64, (random.around(5000), random.around(5000)));
        let level = level(&near, 256);
        check_outline(&level, &near);
        check(&near, 258);
        let far = placed(&shapes, 7 << 14, (random.around(1 << 28), random.around(1 << 28)));
        check(&far, 2 * 7 * (1 << 13));
    }
}

#[test]
fn anything_over_anything() {
    let mut random = Random::new(6);
    for _ in 0..cases(tilesat_judge::thorough(400, 1500)) {
        let n = [3, 6, 40][random.below(3) as usize];
        let shapes = generate::heap(&mut random, n);
        let scale = [1, 64, 100, 256][random.below(4) as usize];
        let near = placed(&shapes, scale, (random.around(5000), random.around(5000)));
        let cell = [256, 258, 300][random.below(3) as usize];
        check_outline(&level(&near, cell), &near);
        check(&near, cell);
    }
}

/// Some 500 edges in no order: the polygons of 16 mosaics over each other, in turn. The outline is
/// counted step by step on the lattice, for each edge.
#[test]
fn edges_far_apart_in_the_list_cancel() {
    let mut random = Random::new(61);
    for _ in 0..cases(1500) / 500 {
        let mut mosaics: Vec<Vec<Shape>> = Vec::new();
        for _ in 0..16 {
            let by = (2 * random.within(0, 7), 2 * random.within(0, 7));
            mosaics.push(placed(&generate::mosaic(&mut random), 1, by));
        }
        let mut shapes = Vec::new();
        while mosaics.iter().any(|m| !m.is_empty()) {
            shapes.extend(mosaics.iter_mut().filter_map(Vec::pop));
        }
        let near = placed(&shapes, 128, (random.around(5000), random.around(5000)));
        check_outline(&level(&near, 256), &near);
        check(&near, 514);
    }
}

/// More segments through a cell than have a picture.
#[test]
fn crowds_in_one_cell() {
    let mut random = Random::new(62);
    for _ in 0..cases(1500) / 300 {
        let mut shapes: Vec<Shape> = Vec::new();
        for _ in 0..60 {
            let by = (random.within(0, 40), random.within(0, 40));
            shapes.extend(placed(&generate::heap(&mut random, 12), 1, by));
        }
        let near = placed(&shapes, 1, (random.around(5000), random.around(5000)));
        check(&near, 256);
    }
}

#[test]
fn the_domain_from_corner_to_corner() {
    let end = (1 << 29) - 1;
    let square = shape(Solid, &[(-end, -end), (end, -end), (end, end), (-end, end)]);
    let across = shape(Wall, &[(-end, -end), (end, end), (-end, end), (end, 1 - end)]);
    let shapes = [square, across];
    // 63 cells of 2^24 - 2 are too few, and 64 leave the domain.
    assert!(paths::level::bytes(&shapes, (1 << 24) - 2).is_err());
    // 2^30 - 2 = 2 * 233 * 1103 * 2089
    let cell = 2 * 1103 * 2089;
    let level = level(&shapes, cell);
    assert_eq!((level.width, level.height), (233, 233));
    check_refs(&level);
    check_winding(&level, &polygon_edges(&shapes));
}

/// A wall across the domain with a bend of a raw unit or none. A vertex exactly on the side toward
/// which it bulges.
#[test]
fn bends_of_a_raw_unit_at_any_length() {
    let (lo, hi) = (1 - (1 << 29), (1 << 29) - 1);
    for turn in [-2, -1, 0, 1, 2] {
        for p in [(1, 0), (1, 7), (123_456_789, 98_765_432), (-3, -400_000_000)] {
            // From one corner through p toward its mirror image, with `turn` beside it.
            let a = (lo, lo + 5);
            let b: (i64, i64) = (2 * p.0 - a.0, 2 * p.1 - a.1 + turn);
            if b.0 > hi || b.1 > hi || b.0 < lo || b.1 < lo {
                continue;
            }
            let level = level(&[shape(Wall, &[a, p, b])], 2 * 1103 * 2089);
            let cross = i128::from(p.0 - a.0) * i128::from(b.1 - p.1) - i128::from(p.1 - a.1) * i128::from(b.0 - p.0);
            let expected = |convex: bool, next: u16| if convex { next } else { u16::MAX };
            assert_eq!(level.segs[0].next, expected(cross > 0, 2), "{p:?} {turn}");
            assert_eq!(level.segs[3].next, expected(cross < 0, 1), "{p:?} {turn}");
            assert_eq!((level.segs[2].next, level.segs[1].next), (3, 0));
        }
    }
}
