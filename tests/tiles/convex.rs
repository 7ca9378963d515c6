//! Capsules, oriented boxes and polygons against maps of all shapes.
//!
//! A shape is the union of discs of its radius around the points of its core. If a disc overlaps
//! the level, so does the shape, by the judge of circles. If the library reports an overlap and no
//! sampled disc has one, a disc larger by the samples' spacing must. Exact touches use shapes that
//! are boxes and circles under other names, and tangents with whole numbers.

use tilesat::prelude::*;
use tilesat::{
    Aabb, Capsule, Circle, ConvexPolygon, Fx, Grid, OrientedBox, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2,
};
use tilesat::{Axis, world::AllShapes, world::Placed};
use tilesat_judge::convex::shape::hull;
use tilesat_judge::shapes::build::mosaic;
use tilesat_judge::shapes::judge::{Body, Judge};
use tilesat_judge::{Random, cases};

type P = (i64, i64);

fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

/// Points of the hull: on its sides and inside, closer than `1 / n` of its size.
fn samples(hull: &[P], n: i64) -> Vec<P> {
    let at = |a: P, b: P, k: i64| (a.0 + (b.0 - a.0) * k / n, a.1 + (b.1 - a.1) * k / n);
    let mut out = Vec::new();
    for (i, &a) in hull.iter().enumerate() {
        let b = hull[(i + 1) % hull.len()];
        for k in 0..n {
            let on = at(a, b, k);
            out.extend((0..=n).map(|j| at(hull[0], on, j)));
        }
    }
    out
}

struct Asked {
    overlaps: bool,
    touches: bool,
}

fn ask(map: &TileMap<'_, AllShapes>, corners: &[P], r: i64) -> Asked {
    let radius = Fx::from_bits(r as i32);
    // A shifted level and a shifted shape give the same.
    let by = Vec2::from_raw(12_345, -777);
    let shifted = Placed::new(map, by).unwrap();
    if corners.len() < 3 {
        let shape = Capsule::new(vec2(corners[0]), vec2(corners[corners.len() - 1]), radius).unwrap();
        let moved = shape.translated(by).unwrap();
        let out = Asked { overlaps: map.overlaps(&shape), touches: map.touches(&shape) };
        assert_eq!((shifted.overlaps(&moved), shifted.touches(&moved)), (out.overlaps, out.touches));
        return out;
    }
    let points: Vec<_> = corners.iter().map(|p| vec2(*p)).collect();
    let shape = ConvexPolygon::<6>::new(&points).unwrap().with_radius(radius).unwrap();
    let moved = shape.translated(by).unwrap();
    let out = Asked { overlaps: map.overlaps(&shape), touches: map.touches(&shape) };
    assert_eq!((shifted.overlaps(&moved), shifted.touches(&moved)), (out.overlaps, out.touches));
    out
}

#[test]
fn mosaics_equal_their_discs() {
    let mut random = Random::new(77);
    let (mut done, mut yes, mut no, mut close) = (0u64, 0u64, 0u64, 0u64);
    while done < cases(6_000) {
        let level = mosaic(&mut random);
        if level.cell < 32 || level.cell > 1 << 20 || level.x.abs() > 1 << 26 || level.y.abs() > 1 << 26 {
            continue;
        }
        let (map, judge) = (level.all(), Judge::new(&level));
        for _ in 0..20 {
            let size = level.cell * random.within(1, 3);
            let mut place = |from: i64, count: i64| from + random.within(-1, 8 * count + 1) * level.cell / 8;
            let middle = (place(level.x, level.width), place(level.y, level.height));
            let count = random.within(1, 5);
            let lattice = random.one_in(2);
            let coordinate = |random: &mut Random| {
                if lattice { random.within(-4, 4) * level.cell / 4 } else { random.around(size) }
            };
            let points: Vec<P> =
                (0..count).map(|_| (middle.0 + coordinate(&mut random), middle.1 + coordinate(&mut random))).collect();
            let core = hull(&points);
            let r = [0, 0, level.cell / 4, level.cell, random.within(0, size)][random.below(5) as usize];
            let asked = ask(&map, &core, r);
            let discs = samples(&core, 9);
            // A disc of no radius is the inside of the union. Two points on a line are tested as
            // such.
            let shown = |r: i64| discs.iter().any(|&c| judge.overlaps(Body::Circle { c, r }));
            let spacing = 3 * size / 9 + 3;
            let case = || format!("{level:?} {core:?} {r}");
            // Samples are rounded by a raw unit.
            if r > 2 && shown(r - 2) {
                assert!(asked.overlaps, "{}", case());
            } else if asked.overlaps {
                assert!(shown(r + spacing), "{}", case());
                close += u64::from(r > 2);
            }
            if discs.iter().any(|&c| r > 2 && judge.touches(Body::Circle { c, r: r - 2 })) {
                assert!(asked.touches, "{}", case());
            }
            if asked.touches {
                assert!(discs.iter().any(|&c| judge.touches(Body::Circle { c, r: r + spacing })), "{}", case());
            }
            assert!(asked.touches || !asked.overlaps, "{}", case());
            // Corners are exact points of the shape.
            if core.iter().any(|&c| judge.overlaps(Body::Circle { c, r })) {
                assert!(asked.overlaps, "{}", case());
            }
            if core.iter().any(|&c| judge.touches(Body::Circle { c, r })) {
                assert!(asked.touches, "{}", case());
            }
            done += 1;
            yes += u64::from(asked.overlaps);
            no += u64::from(!asked.touches);
        }
    }
    println!("{done} shapes: {yes} overlap, {no} are apart, {close} of {yes} not shown by a disc");
    assert!(yes > done / 5 && no > done / 20 && close < yes / 5, "{yes} {no} {close}");
}

/// Upright boxes, and capsules without length, equal the plain shapes, including thin ones: bit for
/// bit, on all shapes of tiles.
#[test]
fn boxes_and_circles_by_other_names() {
    let mut random = Random::new(78);
    let mut touched = 0u64;
    for _ in 0..cases(1_500) {
        let level = mosaic(&mut random);
        let map = level.all();
        for _ in 0..20 {
            let mut place = |from: i64, count: i64| {
                from + random.within(-2, 8 * count + 2) * level.cell / 8
                    + if random.one_in(3) { random.around(1) } else { 0 }
            };
            let c = (place(level.x, level.width), place(level.y, level.height));
            let h = (random.within(0, 8) * level.cell / 8, random.within(0, 8) * level.cell / 8);
            let Ok(turned) = OrientedBox::new(vec2(c), vec2(h), Axis::X) else { continue };
            let plain = Aabb::new(vec2((c.0 - h.0, c.1 - h.1)), vec2((c.0 + h.0, c.1 + h.1))).unwrap();
            assert_eq!(map.overlaps(&turned), map.overlaps(&plain), "{level:?} {plain:?}");
            assert_eq!(map.touches(&turned), map.touches(&plain), "{level:?} {plain:?}");
            let Ok(short) = Capsule::new(vec2(c), vec2(c), Fx::from_bits(h.0 as i32)) else { continue };
            let ball = Circle::new(vec2(c), Fx::from_bits(h.0 as i32)).unwrap();
            assert_eq!(map.overlaps(&short), map.overlaps(&ball), "{level:?} {ball:?}");
            assert_eq!(map.touches(&short), map.touches(&ball), "{level:?} {ball:?}");
            touched += u64::from(map.touches(&plain) && !map.overlaps(&plain));
        }
    }
    assert!(touched > 100, "{touched}");
}

/// A dome and a pipe of radius 5 k, and the tangents at (3 k, 4 k). They touch, and one raw unit
/// farther they overlap.
#[test]
fn tangents_of_arcs() {
    static KINDS: TileKinds = {
        let mut kinds = TileKinds::EMPTY;
        let mut i = 0;
        while i < 38 {
            kinds = kinds.with(i as u8 + 1, TileKind::of(TileShape::ALL[i]));
            i += 1;
        }
        kinds
    };
    let k = 64;
    let side = 10 * k;
    let (mut domes, mut pipes) = (0, 0);
    for id in 0..38u8 {
        let tiles = [id + 1];
        let grid = tilesat::Grid::new(1, 1, Fx::from_bits(side as i32), Vec2::ZERO).unwrap();
        let map = TileMap::<AllShapes>::of(&tiles, grid, &KINDS).unwrap();
        for (corner, sx, sy) in [((0, 0), 1, 1), ((side, 0), -1, 1), ((side, side), -1, -1), ((0, side), 1, -1)] {
            // The tangent at (6 k, 8 k) from the corner, from one end to the other, along (4, -3).
            let at = |u: i64, v: i64| vec2((corner.0 + sx * u, corner.1 + sy * v));
            let thin = |d: i64, r: i64| {
                let out = |u, v| at(u + 3 * (r + d) / 5, v + 4 * (r + d) / 5);
                Capsule::new(out(2 * k, 11 * k), out(10 * k, 5 * k), Fx::from_bits(r as i32)).unwrap()
            };
            let map_says = |d, r| (map.overlaps(&thin(d, r)), map.touches(&thin(d, r)));
            let dome = [0, 5 * k].map(|r| (map_says(0, r), map_says(-5, r), map_says(5, r)));
            let expected = ((false, true), (true, true), (false, false));
            // Domes, of which one is around this corner.
            domes += u32::from((10..14).contains(&id) && dome == [expected; 2]);
            // From near the corner straight to the arc of a pipe around it, by its round end.
            let inner = |d: i64, r: i64| {
                let end = at(6 * k + 3 * (d - r) / 5, 8 * k + 4 * (d - r) / 5);
                Capsule::new(at(k, k), end, Fx::from_bits(r as i32)).unwrap()
            };
            let map_says = |d, r| (map.overlaps(&inner(d, r)), map.touches(&inner(d, r)));
            let pipe = [0, 5].map(|r| (map_says(0, r), map_says(5, r), map_says(-5, r)));
            pipes += u32::from((14..18).contains(&id) && pipe == [expected; 2]);
        }
    }
    assert_eq!((domes, pipes), (4, 4));
}

/// Maps of blocks are the boxes of their full tiles and of their outside. One-way tiles are none.
/// Levels that are shifted twice are shifted by both.
#[test]
fn blocks_equal_their_boxes() {
    static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL).with(2, TileKind::ONE_WAY_UP);
    let mut random = Random::new(79);
    let mut counts = [0u64; 3];
    for _ in 0..cases(4_000) {
        let (width, height, side) = (random.within(1, 4), random.within(1, 3), 1 << random.within(8, 13));
        let tiles: Vec<u8> = (0..width * height).map(|_| random.below(3) as u8).collect();
        let at = (random.around(1 << 20), random.around(1 << 20));
        let grid = Grid::new(width as u16, height as u16, Fx::from_bits(side as i32), vec2(at)).unwrap();
        let outside = [Outside::Empty, Outside::Solid, Outside::Edge][random.below(3) as usize];
        let blocks = TileMap::on_grid(&tiles, grid, &KINDS).unwrap().with_outside(outside);
        let shapes = TileMap::<AllShapes>::of(&tiles, grid, &KINDS).unwrap().with_outside(outside);
        let (by, rest) = (vec2((random.around(9_999), 77)), vec2((-5, random.around(9_999))));
        let once = Placed::new(&blocks, by).unwrap();
        let twice = Placed::new(&once, rest).unwrap();
        // Far beyond every shape in this test.
        let tile = |x: i64, y: i64| {
            let inner = tiles[(y.clamp(0, height - 1) * width + x.clamp(0, width - 1)) as usize];
            let is_in = (0..width).contains(&x) && (0..height).contains(&y);
            let full = match outside {
                _ if is_in => inner == 1,
                Outside::Empty => false,
                Outside::Solid => true,
                Outside::Edge => inner == 1,
            };
            let lo = (at.0 + x * side, at.1 + y * side);
            full.then(|| Aabb::new(vec2(lo), vec2((lo.0 + side, lo.1 + side))).unwrap())
        };
        let solid: Vec<Aabb> = (-8..height + 8).flat_map(|y| (-8..width + 8).filter_map(move |x| tile(x, y))).collect();
        for _ in 0..12 {
            let mut point = || {
                let x = at.0 + random.within(-4, 4 * width + 4) * side / 4;
                (x + random.around(1), at.1 + random.within(-4, 4 * height + 4) * side / 4 + random.around(1))
            };
            let (p, q) = (point(), point());
            // Thin shapes along x or y run along seams, which belong to no box.
            let flat = p.0 == q.0 || p.1 == q.1;
            let r = [i64::from(flat), i64::from(flat), side / 4, side][random.below(4) as usize];
            let body = Capsule::new(vec2(p), vec2(q), Fx::from_bits(r as i32)).unwrap();
            let wanted = (solid.iter().any(|b| body.overlaps(b)), solid.iter().any(|b| body.touches(b)));
            let case = || format!("{tiles:?} {width} {side} {at:?} {outside:?} {body:?}");
            assert_eq!((blocks.overlaps(&body), blocks.touches(&body)), wanted, "blocks: {}", case());
            assert_eq!((shapes.overlaps(&body), shapes.touches(&body)), wanted, "shapes: {}", case());
            let body = body.translated(by).unwrap().translated(rest).unwrap();
            assert_eq!((twice.overlaps(&body), twice.touches(&body)), wanted, "placed: {}", case());
            counts[usize::from(wanted.0) + usize::from(wanted.1)] += 1;
        }
    }
    assert!(counts.iter().all(|n| *n > 200), "{counts:?}");
}
