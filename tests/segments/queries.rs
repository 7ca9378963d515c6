//! Segment maps as levels, against a judge that knows only the input polygons.

use std::collections::BTreeMap;
use tilesat::scene::Shape;
use tilesat::{
    Aabb, Circle, Fx, PathKind, SegmentMap,
    world::{Feature, Geometry, OneWay},
};
use tilesat_judge::segments;
use tilesat_judge::segments::{Body, P, SCALE, Scene, build};
use tilesat_judge::{Random, cases};

fn aabb(scene: &Scene, lo: P, hi: P) -> Aabb {
    Aabb::new(scene.vec2(lo), scene.vec2(hi)).unwrap()
}

/// Overlap, touch and flags of bodies and points of every kind.
#[test]
fn overlap_touch_and_flags_equal_the_polygons() {
    let mut random = Random::new(41);
    let (mut done, mut overlapped, mut touched, mut thin) = (0u64, 0u64, 0u64, 0u64);
    while done < cases(150_000) {
        let scene = build::scene(&mut random);
        let bytes = scene.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let blocking = scene.blocking();
        for _ in 0..60 {
            let body = scene.body(&mut random);
            let (overlaps, touches, flags) = match body {
                Body::Box { lo, hi } => {
                    let b = aabb(&scene, lo, hi);
                    if lo == hi {
                        assert_eq!(map.flags_touched(&scene.vec2(lo)), map.flags_touched(&b));
                    }
                    (map.overlaps(&b), map.touches(&b), map.flags_touched(&b))
                }
                Body::Circle { c, r } => {
                    let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
                    (map.overlaps(&b), map.touches(&b), map.flags_touched(&b))
                }
            };
            assert_eq!(overlaps, scene.overlaps(&blocking, body), "overlaps: {scene:?} {body:?}");
            assert_eq!(touches, scene.touches(&blocking, body), "touches: {scene:?} {body:?}");
            // Cancelled edges have lost their flags too.
            assert_eq!(flags & !scene.flags(body), 0, "flags: {scene:?} {body:?}");
            overlapped += u64::from(overlaps);
            touched += u64::from(touches && !overlaps);
            thin += u64::from(overlaps && !body.has_area());
            done += 1;
        }
    }
    println!("{done} bodies: {overlapped} overlap ({thin} without area), {touched} touch");
    assert!(overlapped > done / 5 && touched > done / 20 && thin > done / 50);
}

/// A feature's index and what it is.
fn all(map: &SegmentMap<'_>, region: &Aabb) -> BTreeMap<u16, Feature> {
    let mut out = BTreeMap::new();
    for f in map.features(region) {
        assert!(out.insert(f.index, f).is_none(), "served twice: {f:?}");
    }
    out
}

/// Every piece that meets a region comes once. Together the faces are the rest of the polygons,
/// walls and chains.
#[test]
fn features_come_once() {
    let mut random = Random::new(42);
    for _ in 0..cases(100_000) / 25 {
        let scene = build::scene(&mut random);
        let bytes = scene.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let end = (1 << 29) - 1;
        let everything = Aabb::new(tilesat::Vec2::from_raw(-end, -end), tilesat::Vec2::from_raw(end, end)).unwrap();
        let features = all(&map, &everything);
        let faces = features.values().filter(|f| f.index & 1 == 0).count();
        assert_eq!(faces, usize::from(map.count()));
        let ends = |f: &Feature| match f.geometry {
            Geometry::Face { a, dir, len, .. } => {
                let a = scene.local(a);
                (a, (a.0 + i128::from(dir.x) * i128::from(len), a.1 + i128::from(dir.y) * i128::from(len)))
            }
            Geometry::Vertex { p, .. } => (scene.local(p), scene.local(p)),
            _ => panic!("{f:?}"),
        };
        // Every piece of the boundary is in a face of its direction.
        for piece in scene.boundary() {
            let holds = |f: &Feature| {
                let Geometry::Face { dir, .. } = f.geometry else { return false };
                let (a, b) = ends(f);
                let dir = (i128::from(dir.x), i128::from(dir.y));
                let along = |p: P| {
                    let d = segments::sub(p, a);
                    let t = segments::dot(d, dir);
                    let end = segments::dot(segments::sub(b, a), dir);
                    (segments::cross(dir, d) == 0 && 0 <= t && t <= end).then_some(t)
                };
                along(piece.a).zip(along(piece.b)).is_some_and(|(s, t)| s < t)
            };
            assert!(features.values().any(holds), "{scene:?}: {piece:?}");
        }
        for _ in 0..20 {
            let (p, q) = (scene.point(&mut random), scene.point(&mut random));
            let q = if random.one_in(3) { p } else { q };
            let (lo, hi) = ((p.0.min(q.0), p.1.min(q.1)), (p.0.max(q.0), p.1.max(q.1)));
            let got = all(&map, &aabb(&scene, lo, hi));
            for (index, f) in &features {
                let (a, b) = ends(f);
                if (Body::Box { lo, hi }).meets(a, b, true) {
                    assert_eq!(got.get(index), Some(f), "{scene:?} {lo:?} {hi:?}");
                }
            }
            assert!(got.iter().all(|(i, f)| features.get(i) == Some(f)));
            // A body touches the flags of just the faces that it meets.
            for body in [Body::Box { lo, hi }, scene.body(&mut random)] {
                let met = |f: &&Feature| f.index & 1 == 0 && body.meets(ends(f).0, ends(f).1, true);
                let expected = features.values().filter(met).fold(0, |all, f| all | f.flags);
                let found = match body {
                    Body::Box { lo, hi } => {
                        let b = aabb(&scene, lo, hi);
                        (map.flags_touched(&b), map.flags_touched(&Shape::Aabb(b)))
                    }
                    Body::Circle { c, r } => {
                        let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
                        (map.flags_touched(&b), map.flags_touched(&Shape::Circle(b)))
                    }
                };
                assert_eq!(found, (expected, expected), "{scene:?} {body:?}");
            }
        }
    }
}

/// From outside the solid the nearest point is as far away as the nearest piece, rounded down.
#[test]
fn nearest_points_are_as_near_as_the_pieces() {
    use tilesat_judge::segments::{cross, dot, sub};
    let mut random = Random::new(47);
    let (mut done, mut found) = (0u64, 0u64);
    while done < cases(60_000) {
        let scene = build::scene(&mut random);
        let bytes = scene.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let blocking = scene.blocking();
        // A hole in nothing, and a polygon that winds backward somewhere, have edges without a
        // solid behind them. From there nothing is visible.
        let backed = |s: &segments::Piece| {
            let d = sub(s.b, s.a);
            // Beside a possible crossing there, and a little to the left.
            (0..32)
                .map(|i| SCALE / 32 * i + (1 << 40))
                .all(|k| scene.winding((s.a.0 * SCALE + d.0 * k - d.1, s.a.1 * SCALE + d.1 * k + d.0)) > 0)
        };
        if scene.shapes.iter().any(|s| s.kind == PathKind::Hole) {
            continue;
        }
        if !scene.boundary().iter().all(backed) {
            continue;
        }
        for _ in 0..40 {
            let p = scene.point(&mut random);
            if scene.inside(p) {
                continue;
            }
            // The square of the distance as a fraction.
            let square = |a: P, b: P| {
                let (d, m) = (sub(b, a), sub(p, a));
                let (along, len2) = (dot(d, m), dot(d, d));
                if along <= 0 {
                    (dot(m, m), 1)
                } else if along >= len2 {
                    (dot(sub(p, b), sub(p, b)), 1)
                } else {
                    (cross(d, m) * cross(d, m), len2)
                }
            };
            let squares = blocking.iter().map(|s| square(s.a, s.b));
            let best = squares.min_by(|s, t| (s.0 * t.1).cmp(&(t.0 * s.1)));
            let within = i128::from(random.magnitude(1 << 12));
            let near = map.closest_point(scene.vec2(p), Fx::from_bits(within as i32), OneWay::Ignore).unwrap();
            let reached = best.filter(|s| s.0 <= within * within * s.1);
            assert_eq!(near.is_some(), reached.is_some(), "{scene:?} {p:?} {within} {near:?} {best:?}");
            if let (Some(near), Some((num, den))) = (near, reached) {
                let d = i128::from(near.distance.to_bits());
                assert!(
                    d * d * den <= num && num < (d + 1) * (d + 1) * den && !near.inside,
                    "{scene:?} {p:?} {near:?}"
                );
                found += 1;
            }
            done += 1;
        }
    }
    println!("{done} points, {found} near");
    assert!(found > done / 4);
}
