//! Tile maps against a judge written from the definitions: rays, overlap, touch, regions, flags.

use tilesat::{Aabb, Axis, Blocks, Fx, Inside, TileMap, Vec2, world::Bits};
use tilesat_judge::blocks::ask::{Shape, body, check_ray, ray, shape, vec2};
use tilesat_judge::blocks::bodies::{self, Body};
use tilesat_judge::blocks::build;
use tilesat_judge::blocks::level::{KINDS, Level};
use tilesat_judge::blocks::rays::Scene;
use tilesat_judge::{Random, cases};

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

/// Mirrored, transposed and reversed scenes give mirrored answers, bit for bit, where the tie rule
/// (x first) does not decide.
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
