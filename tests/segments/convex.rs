//! Capsules and polygons against segment maps, solids and joined levels. The exact judges of pairs
//! and of winding numbers check them.

use tilesat::prelude::*;
use tilesat::{Aabb, Capsule, ConvexPolygon, Fx, Joined, PathKind, SegmentMap, Solid, Solids};
use tilesat_judge::convex::shape::{Shape as Convex, hull, sum};
use tilesat_judge::oracle::figure::Point;
use tilesat_judge::oracle::measure::Measure;
use tilesat_judge::segments::{P, SCALE, Scene, build, cross, sub};
use tilesat_judge::{Random, cases};

fn near(p: P) -> Point {
    (p.0 as i64, p.1 as i64)
}

/// Whether the inside of the polygons has a point between two others: on both sides of the middle
/// of a piece that no edge crosses.
fn line_inside(scene: &Scene, p: P, q: P) -> bool {
    let d = sub(q, p);
    // Where edges cross the line, in parts of 2^40.
    let mut cuts = vec![0, 1i128 << 40];
    for shape in scene.shapes.iter().filter(|s| matches!(s.kind, PathKind::Solid | PathKind::Hole)) {
        for (a, b) in shape.edges() {
            let (s, t) = (cross(d, sub(a, p)), cross(d, sub(b, p)));
            if s != t && (s <= 0) != (t < 0) || s == 0 || t == 0 {
                let e = sub(b, a);
                let den = cross(d, e);
                if den != 0 {
                    cuts.push((cross(sub(a, p), e) << 40) / den);
                }
            }
        }
    }
    cuts.retain(|t| (0..=1 << 40).contains(t));
    cuts.sort_unstable();
    cuts.windows(2).filter(|w| w[1] - w[0] > 8).any(|w| {
        let t = i128::midpoint(w[0], w[1]);
        let scale = SCALE >> 40;
        let at = (p.0 * SCALE + d.0 * t * scale, p.1 * SCALE + d.1 * t * scale);
        // Far less than the distance of any two edges that do not meet, and far more than the
        // rounding.
        let n = (-d.1 * (1 << 24), d.0 * (1 << 24));
        scene.winding((at.0 + n.0, at.1 + n.1)) > 0 && scene.winding((at.0 - n.0, at.1 - n.1)) > 0
    })
}

#[test]
fn overlap_and_touch_equal_the_polygons() {
    let mut random = Random::new(91);
    let (mut done, mut yes, mut touch, mut thin) = (0u64, 0u64, 0u64, 0u64);
    while done < cases(40_000) {
        let scene = build::scene(&mut random);
        let bytes = scene.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let blocking = scene.blocking();
        for _ in 0..40 {
            let count = random.within(1, 5);
            let points: Vec<Point> = (0..count).map(|_| near(scene.point(&mut random))).collect();
            let core = hull(&points);
            let r = if random.one_in(2) { 0 } else { random.magnitude(700) };
            let at = |p: &Point| scene.vec2((p.0.into(), p.1.into()));
            let radius = Fx::from_bits(r as i32);
            let (shape, overlaps, touches) = if core.len() < 3 {
                let (a, b) = (core[0], core[core.len() - 1]);
                let ours = Capsule::new(at(&a), at(&b), radius).unwrap();
                (Convex::Capsule { a, b, radius: r }, map.overlaps(&ours), map.touches(&ours))
            } else {
                let corners: Vec<_> = core.iter().map(at).collect();
                let ours = ConvexPolygon::<6>::new(&corners).unwrap().with_radius(radius).unwrap();
                (Convex::polygon(&core, r), map.overlaps(&ours), map.touches(&ours))
            };
            let pair = |a: P, b: P| Measure::of(&sum(&shape, &Convex::Segment { a: near(a), b: near(b) }));
            // A point of the shape that is on no edge.
            let (x, y) = core.iter().take(3).fold((0, 0), |s, p| (s.0 + i128::from(p.0), s.1 + i128::from(p.1)));
            let n = core.len().min(3) as i128;
            let inner = (x * (SCALE / n) + 1, y * (SCALE / n) + (1 << 20));
            let holds = scene.winding(inner) > 0;
            let flat = core.len() < 3 && r == 0;
            let wanted = if !flat {
                blocking.iter().any(|p| pair(p.a, p.b).overlaps()) || holds
            } else if core.len() == 1 {
                scene.inside((core[0].0.into(), core[0].1.into()))
            } else {
                let p = |i: usize| (i128::from(core[i].0), i128::from(core[i].1));
                line_inside(&scene, p(0), p(1))
            };
            assert_eq!(overlaps, wanted, "overlaps, the judge on the right: {scene:?} {shape:?}");
            let wanted = blocking.iter().any(|p| pair(p.a, p.b).touches()) || holds;
            assert_eq!(touches, wanted, "touches, the judge on the right: {scene:?} {shape:?}");
            done += 1;
            yes += u64::from(overlaps);
            thin += u64::from(overlaps && flat);
            touch += u64::from(touches && !overlaps);
        }
    }
    println!("{done} shapes: {yes} overlap ({thin} without area), {touch} touch");
    assert!(yes > done / 5 && touch > done / 50 && thin > done / 100, "{yes} {touch} {thin}");
}

/// Solids are their boxes, and a joined level is either of its parts.
#[test]
fn solids_and_joined() {
    let mut random = Random::new(92);
    let mut yes = 0;
    for _ in 0..cases(20_000) {
        let mut point = || (random.around(400), random.around(400));
        let boxes: Vec<Aabb> = (0..3)
            .map(|_| {
                let (p, q) = (point(), point());
                let v = |x: i64, y: i64| tilesat::Vec2::from_raw(x as i32, y as i32);
                Aabb::new(v(p.0.min(q.0), p.1.min(q.1)), v(p.0.max(q.0) + 1, p.1.max(q.1) + 1)).unwrap()
            })
            .collect();
        let (a, b) = (point(), point());
        let v = |p: Point| tilesat::Vec2::from_raw(p.0 as i32, p.1 as i32);
        let body = Capsule::new(v(a), v(b), Fx::from_bits(random.within(0, 90) as i32)).unwrap();
        let list: Vec<Solid> = boxes.iter().zip(0..).map(|(b, key)| Solid::new(*b, key).unwrap()).collect();
        let all = Solids::new(&list);
        let (first, rest) = (Solids::new(&list[..1]), Solids::new(&list[1..]));
        let wanted = (boxes.iter().any(|b| body.overlaps(b)), boxes.iter().any(|b| body.touches(b)));
        assert_eq!((all.overlaps(&body), all.touches(&body)), wanted);
        let joined = Joined::new(&first, &rest);
        assert_eq!((joined.overlaps(&body), joined.touches(&body)), wanted);
        yes += u32::from(wanted.0);
    }
    assert!(yes > 1_000, "{yes}");
}
