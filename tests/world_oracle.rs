//! Tile maps against a judge written from the definitions: rays, overlap, touch, regions, flags.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    missing_docs,
    reason = "tests stop at the first surprise"
)]

mod support;

use support::bodies::{self, Body};
use support::build;
use support::cases;
use support::level::{KINDS, Level};
use support::random::Random;
use support::rays::{Scene, cells_entered};
use tilesat::{Aabb, Axis, Bits, Blocks, Cell, Circle, Fx, Inside, TileMap, Vec2};

fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// Compares everything that a ray reports.
fn check_ray(level: &Level, scene: &Scene, map: &TileMap, o: (i64, i64), d: (i64, i64)) -> bool {
    let mut hit_any = false;
    for inside in [Inside::Ignore, Inside::Hit] {
        let got = map.cast_ray(vec2(o), vec2(d), inside).unwrap();
        let expected = scene.cast(o, d, inside == Inside::Hit);
        let case = || format!("{level:?}\nfrom {o:?} by {d:?}, {inside:?}\ngot {got:?}\nexpected {expected:?}");
        match (&got, &expected) {
            (None, None) => {}
            (Some(hit), Some(expected)) => {
                hit_any = true;
                assert_eq!(hit.toi.raw(), expected.toi(), "toi: {}", case());
                assert_eq!(hit.point, vec2(expected.point(o, d)), "point: {}", case());
                assert_eq!((hit.axis.x, hit.axis.y), expected.axis(d), "axis: {}", case());
                assert_eq!(hit.inside, expected.inside, "inside: {}", case());
                let at = |&(c, r): &(i64, i64)| {
                    let repeated = level.outside == tilesat::Outside::Edge;
                    let clamp = |v: i64, n: i64| if repeated { v.clamp(0, n - 1) } else { v };
                    Cell::new(clamp(c, level.width) as i16, clamp(r, level.height) as i16)
                };
                assert!(expected.owners.iter().any(|owner| at(owner) == hit.cell), "cell: {}", case());
                assert_eq!(hit.flags, map.kind(hit.cell).flags, "flags: {}", case());
                // At a corner, what is met in a cell beside it may be told before the other line is counted.
                let entered = cells_entered(level, o, d, expected.num, expected.den);
                assert!(entered.contains(&hit.cells), "cells: {entered:?} {}", case());
                assert!(i64::from(hit.cells) <= level.width + level.height + 4);
            }
            _ => panic!("{}", case()),
        }
    }
    hit_any
}

/// A ray of one of the classes: mixed coordinates, along lines, through corners, one raw wide, of no length, across the domain.
fn ray(random: &mut Random, level: &Level) -> ((i64, i64), (i64, i64)) {
    let limit = (1i64 << 29) - 1;
    let o = build::point(random, level);
    let end = match random.below(10) {
        0 => (o.0, build::point(random, level).1),
        1 => (build::point(random, level).0, o.1),
        2 => o,
        3 => (o.0 + random.around(1), build::point(random, level).1),
        4 => (build::point(random, level).0, o.1 + random.around(1)),
        5 => {
            // Through a corner or one raw beside it, with a small direction, so that it meets more corners.
            let corner = (
                level.x + level.cell * random.within(0, level.width),
                level.y + level.cell * random.within(0, level.height),
            );
            let (p, q, k) = (random.around(3), random.around(3), level.cell * random.within(1, 8) / 2);
            let from = (corner.0 - p * k + random.around(1), corner.1 - q * k);
            let to = (from.0 + 2 * p * k, from.1 + 2 * q * k);
            if [from.0, from.1, to.0, to.1].iter().all(|v| v.abs() <= limit) {
                return (from, (to.0 - from.0, to.1 - from.1));
            }
            build::point(random, level)
        }
        6 => (random.sign() * limit, random.around(limit)),
        7 => (o.0 + random.around(8), o.1 + random.around(8)),
        _ => build::point(random, level),
    };
    let end = (end.0.clamp(-limit, limit), end.1.clamp(-limit, limit));
    (o, (end.0 - o.0, end.1 - o.1))
}

#[test]
fn rays_equal_the_first_opposing_face() {
    let mut random = Random::new(15);
    let (mut hits, mut done) = (0u64, 0);
    let total = cases(1_000_000);
    while done < total {
        let level = build::level(&mut random);
        let (scene, map) = (Scene::new(&level), level.map());
        for _ in 0..100 {
            let (o, d) = ray(&mut random, &level);
            hits += u64::from(check_ray(&level, &scene, &map, o, d));
            done += 1;
        }
    }
    assert!(hits > done / 4, "{hits} of {done} rays hit");
    println!("{done} rays, {hits} hit");
}

/// All maps of 2 x 2 cells, all starts and ends on the lattice of half cells around them.
#[test]
fn rays_on_the_half_cell_lattice_exhaustively() {
    let outsides = build::OUTSIDES;
    for tiles in 0..16u8 {
        for outside in outsides {
            let tiles = (0..4).map(|i| tiles >> i & 1).collect();
            let level = Level { width: 2, height: 2, cell: 300, x: -300, y: -300, outside, tiles };
            let (scene, map) = (Scene::new(&level), level.map());
            for from in 0..49 {
                for to in 0..49 {
                    let at = |k: i64| ((k % 7 - 3) * 150, (k / 7 - 3) * 150);
                    let (o, e) = (at(from), at(to));
                    check_ray(&level, &scene, &map, o, (e.0 - o.0, e.1 - o.1));
                }
            }
        }
    }
}

fn body(random: &mut Random, level: &Level) -> Body {
    let limit = (1i64 << 29) - 1;
    let (x, y) = build::point(random, level);
    if random.one_in(2) {
        let (u, v) = match random.below(4) {
            0 => (x, build::point(random, level).1),
            1 => (build::point(random, level).0, y),
            2 => (x + random.magnitude(level.cell), y + random.magnitude(level.cell)),
            _ => build::point(random, level),
        };
        let (u, v) = (u.min(limit), v.min(limit));
        Body::Box { x0: x.min(u), y0: y.min(v), x1: x.max(u), y1: y.max(v) }
    } else {
        // Often exactly as far as a corner, by a Pythagorean triple, or one raw more or less.
        let (x, y, r) = match random.below(4) {
            0 => (x, y, random.magnitude(level.cell * 3)),
            1 => (x, y, 0),
            _ => {
                let corner = (
                    level.x + level.cell * random.within(0, level.width),
                    level.y + level.cell * random.within(0, level.height),
                );
                let (a, b, c) = [(3, 4, 5), (8, 15, 17), (20, 21, 29), (0, 1, 1), (1, 0, 1)][random.below(5) as usize];
                let k = random.magnitude(level.cell / 10) + 1;
                let x = corner.0 + random.sign() * a * k;
                let y = corner.1 + random.sign() * b * k;
                (x, y, (c * k + random.around(1)).max(0))
            }
        };
        if x.abs().max(y.abs()) + r > limit {
            return Body::Circle { x: x.clamp(-limit, limit), y: y.clamp(-limit, limit), r: 0 };
        }
        Body::Circle { x, y, r }
    }
}

#[derive(Clone, Copy)]
enum Shape {
    Box(Aabb),
    Circle(Circle),
}

fn shape(body: Body) -> Shape {
    match body {
        Body::Box { x0, y0, x1, y1 } => Shape::Box(Aabb::new(vec2((x0, y0)), vec2((x1, y1))).unwrap()),
        Body::Circle { x, y, r } => Shape::Circle(Circle::new(vec2((x, y)), Fx::from_bits(r as i32)).unwrap()),
    }
}

#[test]
fn overlap_touch_and_flags_equal_the_definitions() {
    let mut random = Random::new(26);
    let (mut done, mut overlapped, mut touched) = (0u64, 0u64, 0u64);
    while done < cases(400_000) {
        let level = build::level(&mut random);
        let map = level.map();
        for _ in 0..100 {
            let body = body(&mut random, &level);
            let (overlaps, touches, flags) = match shape(body) {
                Shape::Box(b) => (map.overlaps(&b), map.touches(&b), map.flags_touched(&b)),
                Shape::Circle(b) => (map.overlaps(&b), map.touches(&b), map.flags_touched(&b)),
            };
            assert_eq!(overlaps, bodies::overlaps(&level, body), "overlaps: {level:?} {body:?}");
            assert_eq!(touches, bodies::touches(&level, body), "touches: {level:?} {body:?}");
            assert_eq!(flags, bodies::flags(&level, body), "flags: {level:?} {body:?}");
            overlapped += u64::from(overlaps);
            touched += u64::from(touches && !overlaps);
            done += 1;
        }
        let p = build::point(&mut random, &level);
        let point = Body::Box { x0: p.0, y0: p.1, x1: p.0, y1: p.1 };
        assert_eq!(map.flags_touched(&vec2(p)), bodies::flags(&level, point));
    }
    assert!(overlapped > done / 5 && touched > done / 50, "{overlapped} overlaps, {touched} touches in {done}");
}

#[test]
fn regions_hold_the_cells_of_the_definition() {
    let mut random = Random::new(7);
    for _ in 0..cases(40_000) / 4 {
        let level = build::level(&mut random);
        let map = level.map();
        for _ in 0..4 {
            let (a, b) = (build::point(&mut random, &level), build::point(&mut random, &level));
            let b = if random.one_in(4) { (a.0, b.1) } else { b };
            let (x0, x1, y0, y1) = (a.0.min(b.0), a.0.max(b.0), a.1.min(b.1), a.1.max(b.1));
            let region = Aabb::new(vec2((x0, y0)), vec2((x1, y1))).unwrap();
            let got: Vec<_> = map.tiles_in(&region).map(|t| (i64::from(t.cell.x), i64::from(t.cell.y))).collect();
            assert_eq!(got, bodies::tiles_in(&level, x0, y0, x1, y1), "{level:?} {region:?}");
            for t in map.tiles_in(&region) {
                assert_eq!((Some(t.id), t.kind), (map.tile(t.cell), KINDS.get(t.id)));
            }
        }
    }
}

#[test]
fn bits_and_bytes_answer_the_same() {
    let mut random = Random::new(8);
    for _ in 0..cases(200_000) / 100 {
        let mut level = build::level(&mut random);
        for id in &mut level.tiles {
            *id = u8::from(*id % 3 == 1);
        }
        let bytes = level.map();
        let mut packed = vec![0u8; level.tiles.len().div_ceil(8)];
        for (i, &id) in level.tiles.iter().enumerate() {
            packed[i / 8] |= id << (i % 8);
        }
        let small = Fx::from_bits(256);
        let bits =
            TileMap::<Blocks, Bits>::from_bits(&packed, level.width as u16, level.height as u16, &KINDS).unwrap();
        let bits = bits.with_cell(small).unwrap().with_origin(bytes.origin()).unwrap();
        let bits = bits.with_cell(bytes.cell()).unwrap().with_outside(level.outside);
        assert_eq!(bits.grid(), bytes.grid());
        for _ in 0..100 {
            let (o, d) = ray(&mut random, &level);
            let (o, d) = (vec2(o), vec2(d));
            assert_eq!(bits.cast_ray(o, d, Inside::Ignore), bytes.cast_ray(o, d, Inside::Ignore));
            match shape(body(&mut random, &level)) {
                Shape::Box(b) => {
                    assert_eq!(bits.overlaps(&b), bytes.overlaps(&b));
                    assert!(bits.tiles_in(&b).eq(bytes.tiles_in(&b)));
                    assert!(bits.features(&b).eq(bytes.features(&b)));
                }
                Shape::Circle(b) => {
                    assert_eq!((bits.overlaps(&b), bits.touches(&b)), (bytes.overlaps(&b), bytes.touches(&b)));
                }
            }
        }
    }
}

/// Mirrored, transposed and reversed scenes give mirrored answers, bit for bit, where the tie rule (x first) does not decide.
#[test]
fn rays_are_symmetric() {
    let mut random = Random::new(9);
    for _ in 0..cases(100_000) / 20 {
        let level = build::level(&mut random);
        let (w, h) = (level.width, level.height);
        let mut mirrored = level.clone();
        mirrored.x = -level.right();
        mirrored.tiles = (0..w * h).map(|i| level.tiles[(i / w * w + w - 1 - i % w) as usize]).collect();
        let mut transposed = Level { width: h, height: w, x: level.y, y: level.x, ..level.clone() };
        transposed.tiles = (0..w * h).map(|i| level.tiles[(i % h * w + i / h) as usize]).collect();
        for _ in 0..20 {
            let (o, d) = ray(&mut random, &level);
            let hit = level.map().cast_ray(vec2(o), vec2(d), Inside::Hit).unwrap();
            let other = mirrored.map().cast_ray(vec2((-o.0, o.1)), vec2((-d.0, d.1)), Inside::Hit).unwrap();
            let flip = |p: Vec2| Vec2::from_raw(-p.raw().0, p.raw().1);
            assert_eq!(hit.map(|h| (h.toi, h.point)), other.map(|h| (h.toi, flip(h.point))), "{level:?} {o:?} {d:?}");
            if (d.0, d.1) != (0, 0) {
                let axis = |h: Axis| Axis::new(-h.x, h.y);
                assert_eq!(hit.map(|h| h.axis), other.map(|h| axis(h.axis)), "{level:?} {o:?} {d:?}");
            }
            let other = transposed.map().cast_ray(vec2((o.1, o.0)), vec2((d.1, d.0)), Inside::Hit).unwrap();
            let swap = |p: Vec2| Vec2::new(p.y, p.x);
            assert_eq!(hit.map(|h| (h.toi, h.point)), other.map(|h| (h.toi, swap(h.point))), "{level:?} {o:?} {d:?}");
        }
    }
}
