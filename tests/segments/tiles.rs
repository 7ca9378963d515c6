//! A map of tiles and the segment map of its tiles' outlines are one level: the same overlaps, and
//! the same surface with collinear pieces merged.

use std::collections::{BTreeMap, BTreeSet};
use tilesat::{
    Aabb, Circle, Fx, Grid, PathKind, SegmentMap, Slopes, TileKind, TileKinds, TileMap, TileShape, World,
    world::Geometry,
};
use tilesat_judge::segments;
use tilesat_judge::segments::{Body, P, Scene, Shape, cross, dot, sub};
use tilesat_judge::{Random, cases};

/// The straight shapes by their id: the corner that is solid and the line, in halves of a cell. Of
/// halves, either corner.
const LINES: [(u8, P, P, P); 16] = [
    (2, (0, 0), (0, 1), (2, 1)),
    (3, (2, 0), (1, 0), (1, 2)),
    (4, (2, 2), (2, 1), (0, 1)),
    (5, (0, 2), (1, 2), (1, 0)),
    (6, (0, 0), (0, 2), (2, 0)),
    (7, (2, 0), (0, 0), (2, 2)),
    (8, (2, 2), (2, 0), (0, 2)),
    (9, (0, 2), (2, 2), (0, 0)),
    (18, (0, 0), (0, 1), (2, 0)),
    (19, (2, 0), (0, 0), (2, 1)),
    (22, (0, 0), (0, 2), (2, 1)),
    (23, (2, 0), (0, 1), (2, 2)),
    (28, (2, 2), (2, 0), (1, 2)),
    (29, (0, 2), (1, 2), (0, 0)),
    (32, (2, 2), (1, 0), (0, 2)),
    (33, (0, 2), (2, 2), (1, 0)),
];

/// The corners of a shape in order, in halves of a cell.
fn outline(id: u8) -> Vec<P> {
    let square = [(0, 0), (2, 0), (2, 2), (0, 2)];
    let Some(&(_, corner, a, b)) = LINES.iter().find(|l| l.0 == id) else { return square.to_vec() };
    let side = |p: P| cross(sub(b, a), sub(p, a)) * cross(sub(b, a), sub(corner, a)).signum();
    let mut points: Vec<P> = square.into_iter().filter(|&p| side(p) >= 0).chain([a, b]).collect();
    points.sort_unstable();
    points.dedup();
    let n = points.len() as i128;
    let sum = points.iter().fold((0, 0), |s, p| (s.0 + p.0, s.1 + p.1));
    let key = |p: &P| (p.0 * n - sum.0, p.1 * n - sum.1);
    let lower = |d: P| d.1 < 0 || (d.1 == 0 && d.0 < 0);
    points.sort_by(|a, b| lower(key(a)).cmp(&lower(key(b))).then(0.cmp(&cross(key(a), key(b)))));
    points
}

/// Ids are discriminants of shapes.
fn kinds() -> TileKinds {
    let mut out = TileKinds::EMPTY.with(1, TileKind::FULL);
    for (id, ..) in LINES {
        out = out.with(id, TileKind::of(TileShape::ALL[usize::from(id)]));
    }
    out
}

/// All lines of one direction with the parts that are faces, and the vertices.
type Surface = (BTreeMap<(P, i128), Vec<(i128, i128)>>, BTreeSet<(P, P, P)>);

fn surface(world: &impl World, scene: &Scene) -> Surface {
    let end = (1 << 29) - 1;
    let everything = Aabb::new(tilesat::Vec2::from_raw(-end, -end), tilesat::Vec2::from_raw(end, end)).unwrap();
    let (mut faces, mut vertices) = (BTreeMap::<(P, i128), Vec<(i128, i128)>>::new(), BTreeSet::new());
    for f in world.features(&everything) {
        let axis = |a: tilesat::Axis| (i128::from(a.x), i128::from(a.y));
        match f.geometry {
            Geometry::Face { a, dir, len, .. } => {
                let (a, dir) = (scene.local(a), axis(dir));
                let t = dot(a, dir);
                faces.entry((dir, cross(dir, a))).or_default().push((t, t + dot(dir, dir) * i128::from(len)));
            }
            Geometry::Vertex { p, e_in, e_out } => {
                assert!(vertices.insert((scene.local(p), axis(e_in), axis(e_out))));
            }
            _ => panic!("{f:?}"),
        }
    }
    for parts in faces.values_mut() {
        parts.sort_unstable();
        let mut merged: Vec<(i128, i128)> = Vec::new();
        for &(s, t) in parts.iter() {
            match merged.last_mut() {
                Some(last) if last.1 >= s => last.1 = last.1.max(t),
                _ => merged.push((s, t)),
            }
        }
        *parts = merged;
    }
    (faces, vertices)
}

/// How many parts of the boundary leave a point.
fn rays(pieces: &[segments::Piece], p: P) -> usize {
    let through = |a: P, b: P| (Body::Box { lo: p, hi: p }).meets(a, b, true);
    pieces.iter().filter(|s| through(s.a, s.b)).map(|s| if s.a == p || s.b == p { 1 } else { 2 }).sum()
}

#[test]
fn tiles_and_their_outlines_are_one_level() {
    let mut random = Random::new(44);
    let kinds = kinds();
    let ids: Vec<u8> = [0, 0, 0, 1, 1, 1].into_iter().chain(LINES.map(|l| l.0)).collect();
    let (mut done, mut overlapped) = (0u64, 0u64);
    while done < cases(60_000) {
        let (w, h) = (random.within(1, 4), random.within(1, 4));
        let blocks = random.one_in(3);
        let pool = if blocks { &ids[..6] } else { &ids[..] };
        let mut tiles: Vec<u8> = (0..w * h).map(|_| pool[random.below(pool.len() as i64) as usize]).collect();
        if tiles.iter().all(|&t| t == 0) {
            tiles[0] = 1;
        }
        let side = [256, 300, 14 * 64, 512][random.below(4) as usize];
        let half = side / 2;
        let shape = |i: usize| {
            let (x, y) = ((i as i128 % i128::from(w)) * side, (i as i128 / i128::from(w)) * side);
            let points = outline(tiles[i]).into_iter().map(|p| (x + p.0 * half, y + p.1 * half)).collect();
            Shape { kind: PathKind::Solid, flags: 0, points }
        };
        let shapes = (0..tiles.len()).filter(|&i| tiles[i] != 0).map(shape).collect();
        let cell = [256, 258, side as i32, 2 * side as i32, 14 * 64][random.below(5) as usize];
        let scene = Scene { shapes, origin: (-777, i128::from(random.around(1 << 28))), cell, grid: None };
        let bytes = scene.bytes();
        let segments = SegmentMap::from_bytes(&bytes).unwrap();
        let grid = Grid::new(w as u16, h as u16, Fx::from_bits(side as i32), scene.vec2((0, 0))).unwrap();
        let map = TileMap::<Slopes>::of(&tiles, grid, &kinds).unwrap();

        let (pieces, case) = (scene.boundary(), || format!("{tiles:?} of {w}, {side}"));
        let ((faces, vertices), (other_faces, other_vertices)) = (surface(&map, &scene), surface(&segments, &scene));
        assert_eq!(faces, other_faces, "{}", case());
        // Where two pieces of solid meet in a point, a tile map has the corners of both. A segment
        // map has only those that a body can reach.
        for v in vertices.symmetric_difference(&other_vertices) {
            assert!(rays(&pieces, v.0) > 2, "{}: {v:?} of tiles: {}", case(), vertices.contains(v));
        }
        for _ in 0..50 {
            let body = scene.body(&mut random);
            let (tile, segment) = match body {
                Body::Box { lo, hi } => {
                    let b = Aabb::new(scene.vec2(lo), scene.vec2(hi)).unwrap();
                    ((map.overlaps(&b), map.touches(&b)), (segments.overlaps(&b), segments.touches(&b)))
                }
                Body::Circle { c, r } => {
                    let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
                    ((map.overlaps(&b), map.touches(&b)), (segments.overlaps(&b), segments.touches(&b)))
                }
            };
            assert_eq!(tile, segment, "{} {body:?}", case());
            overlapped += u64::from(tile.0);
            done += 1;
        }
    }
    println!("{done} bodies, {overlapped} overlap");
}
