//! The invariants of motion among random polygons, walls and chains: P5 to P12, P14 to P16, P19 and
//! P25.
//!
//! `TILESAT_CASES` sets the number of motions per test (default 12 000).

use tilesat::{Aabb, Circle, Fx, Inside, Mover, PathKind, Response, SegmentMap, world::RayRules};
use tilesat_judge::drawing::{Drawing, direction, mover, place};
use tilesat_judge::rooms::body::{Body, Outcome, point, vec2};
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, len2};
use tilesat_judge::segments::{Body as Shape, Piece, Scene, build};
use tilesat_judge::{Random, cases};

const RESPONSES: [Response; 4] = [Response::Slide, Response::Touch, Response::DropThrough, Response::Bounce];
const RULES: RayRules = RayRules { inside: Inside::Hit, one_way: true };

/// A random level, as its judge and as paths around the origin.
struct World {
    scene: Scene,
    blocking: Vec<Piece>,
    drawing: Drawing,
    bytes: Vec<u8>,
}

fn small(p: (i128, i128)) -> P {
    (p.0 as i64, p.1 as i64)
}

fn world(r: &mut Random) -> Option<World> {
    let mut scene = build::scene(r);
    (scene.origin, scene.grid) = ((0, 0), None);
    // Edges without a solid behind them are separate, see `PathKind::Hole`.
    scene.shapes.retain(|s| match s.kind {
        PathKind::Hole => false,
        PathKind::Solid => is_simple(&s.points.iter().map(|p| small(*p)).collect::<Vec<_>>()),
        _ => true,
    });
    if scene.shapes.is_empty() {
        return None;
    }
    let paths = scene.shapes.iter().map(|s| (s.kind, s.points.iter().map(|p| small(*p)).collect()));
    let drawing = Drawing::of(scene.cell.into(), paths.collect());
    Some(World { blocking: scene.blocking(), bytes: drawing.bytes(), scene, drawing })
}

fn of(shape: Shape) -> Body {
    match shape {
        Shape::Box { lo, hi } => Body::Rect(small(lo), small((hi.0 - lo.0, hi.1 - lo.1))),
        Shape::Circle { c, r } => Body::Disc(small(c), r as i64),
    }
}

fn judged(body: Body) -> Shape {
    let wide = |p: P| (i128::from(p.0), i128::from(p.1));
    match body {
        Body::Rect(..) => Shape::Box { lo: wide(body.bounds().0), hi: wide(body.bounds().1) },
        Body::Disc(c, r) => Shape::Circle { c: wide(c), r: r.into() },
        Body::Pill(..) => panic!("no capsule"),
    }
}

impl World {
    fn free(&self, body: Body) -> bool {
        !self.scene.overlaps(&self.blocking, judged(body))
    }

    /// Free bodies with motions: toward a corner and beyond, along an axis, of few raw units,
    /// anywhere.
    fn motions(&self, r: &mut Random) -> Vec<(Body, P)> {
        let (lo, hi) = self.scene.bounds();
        let size = small((hi.0 - lo.0, hi.1 - lo.1));
        let size = size.0.max(size.1);
        (0..16)
            .filter_map(|_| {
                let body = of(self.scene.body(r));
                let area = body.bounds().0.0 < body.bounds().1.0 && body.bounds().0.1 < body.bounds().1.1;
                let to = self.scene.shapes[r.below(self.scene.shapes.len() as i64) as usize].points[0];
                let (p, to) = (body.middle(), small(to));
                let v = match r.below(5) {
                    0 => (r.around(2 * size), 0),
                    1 => (0, r.around(2 * size)),
                    2 => (r.around(5), r.around(5)),
                    3 => ((to.0 - p.0) * r.within(1, 3), (to.1 - p.1) * r.within(1, 3)),
                    _ => (r.around(2 * size), r.around(2 * size)),
                };
                (area && self.free(body)).then_some((body, v))
            })
            .collect()
    }
}

/// Whether no two sides of a polygon cross or touch except at their common end. Then there is solid
/// behind each of them.
fn is_simple(points: &[P]) -> bool {
    let n = points.len();
    let cross = |o: P, a: P, b: P| ((a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0)).signum();
    let apart = |a: P, b: P, p: P, q: P| cross(a, b, p) * cross(a, b, q) > 0;
    (0..n).all(|i| {
        let (a, b) = (points[i], points[(i + 1) % n]);
        let next = points[(i + 2) % n];
        let turns = cross(a, b, next) != 0;
        turns
            && (0..n).filter(|j| (j + n - i) % n > 1 && (i + n - j) % n > 1).all(|j| {
                let (p, q) = (points[j], points[(j + 1) % n]);
                apart(a, b, p, q) || apart(p, q, a, b)
            })
    })
}

/// Motions of random worlds until there are as many as asked for.
fn each(seed: u64, mut f: impl FnMut(&mut Random, &World, &SegmentMap, Body, P)) -> u64 {
    let (mut r, mut done) = (Random::new(seed), 0);
    while done < cases(12_000) {
        let Some(w) = world(&mut r) else { continue };
        if w.blocking.is_empty() {
            continue;
        }
        let map = SegmentMap::from_bytes(&w.bytes).unwrap();
        for (body, v) in w.motions(&mut r) {
            f(&mut r, &w, &map, body, v);
            done += 1;
        }
    }
    done
}

type Bits = (Body, P, P, [bool; 3], Vec<(u32, P, bool)>);

fn bits(out: &Outcome) -> Bits {
    let hits = out.hits.iter().map(|h| (h.toi.raw(), (h.axis.x.into(), h.axis.y.into()), h.one_way));
    (out.body, out.v, out.remaining, [out.floor, out.wall, out.ceiling], hits.collect())
}

/// P5, P6, P7 and P9: mirrors, the transpose, all four turns and a translation give the same bits,
/// except for full ties. P19: so does any order of the paths, without exception.
#[test]
fn p5_p6_p7_p9_p19_every_view() {
    let (mut hits, mut ties, mut r2) = (0, 0, Random::new(77));
    let done = each(5, |r, w, map, body, v| {
        let response = RESPONSES[r.below(4) as usize];
        let out = bits(&body.step(&mover(&[]).with_response(response), map, v).unwrap());
        hits += u64::from(!out.4.is_empty());
        let case = || format!("{body:?} by {v:?} {response:?} in {:?}", w.drawing);
        let mut shuffled = w.drawing.clone();
        r2.shuffle(&mut shuffled.paths);
        let bytes = shuffled.bytes();
        let other = body.step(&mover(&[]).with_response(response), &SegmentMap::from_bytes(&bytes).unwrap(), v);
        assert_eq!(bits(&other.unwrap()), out, "shuffled: {}", case());
        let by = (r.around(1 << 28), r.around(1 << 28));
        let turns: [&[View]; 6] = [
            &[View::MirrorX],
            &[View::MirrorY],
            &[View::Transpose],
            &[View::Transpose, View::MirrorX],
            &[View::Transpose, View::MirrorY],
            &[View::Moved(by)],
        ];
        for views in [turns[r2.below(5) as usize], turns[5]] {
            let bytes = w.drawing.seen(views).bytes();
            let there = SegmentMap::from_bytes(&bytes).unwrap();
            let mover = mover(views).with_response(response);
            let seen = bits(&place(views, body).step(&mover, &there, direction(views, v)).unwrap());
            let turned = out.4.iter().map(|h| (h.0, direction(views, h.1), h.2)).collect();
            let due = (place(views, out.0), direction(views, out.1), direction(views, out.2), out.3, turned);
            if seen == due {
                continue;
            }
            // A tie: other surfaces at the same moment, equally opposed.
            let first = seen.4.iter().zip(&due.4).find(|(a, b)| a != b);
            let d = direction(views, v);
            let square = |n: P| {
                let into = i128::from(n.0) * i128::from(d.0) + i128::from(n.1) * i128::from(d.1);
                (into * into, len2(n))
            };
            let tie = first.is_some_and(|(a, b)| {
                let ((p, q), (s, t)) = (square(a.1), square(b.1));
                a.0 == b.0 && (p * t == s * q || a != &seen.4[0])
            });
            assert!(tie && !matches!(views[0], View::Moved(_)), "{views:?}: {}\n{seen:?}\n{due:?}", case());
            ties += 1;
        }
    });
    println!("{done} motions, {hits} with hits, {ties} ties");
    assert!(hits > done / 4 && ties < done / 50, "{hits} hits, {ties} ties of {done}");
}

/// P8: a world twice, four times, 2^j times as large answers yes and no alike.
#[test]
fn p8_scaling_changes_no_answer() {
    let mut yes = 0;
    let done = each(8, |r, w, map, body, v| {
        let j = 1 << r.within(1, 10);
        let by = |p: &P| (p.0 * j, p.1 * j);
        let paths = w.drawing.paths.iter().map(|(k, p)| (*k, p.iter().map(by).collect()));
        let large = Drawing::of((w.drawing.cell * j).min(1 << 24), paths.collect()).bytes();
        let large = SegmentMap::from_bytes(&large).unwrap();
        // Free ones, and ones that lie somewhere.
        let any = of(w.scene.body(r));
        for b in [body, any] {
            let answers = |map: &SegmentMap, b: Body, v: P| match b {
                Body::Pill(..) => panic!("no capsule"),
                Body::Disc(c, r) => {
                    let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
                    (map.overlaps(&b), map.touches(&b), map.cast_shape(&b, vec2(v), RULES).unwrap().is_some())
                }
                Body::Rect(..) => {
                    let b = Aabb::new(vec2(b.bounds().0), vec2(b.bounds().1)).unwrap();
                    (map.overlaps(&b), map.touches(&b), map.cast_shape(&b, vec2(v), RULES).unwrap().is_some())
                }
            };
            let scaled = match b {
                Body::Disc(c, r) => Body::Disc(by(&c), r * j),
                Body::Rect(p, s) => Body::Rect(by(&p), by(&s)),
                Body::Pill(p, core, r) => Body::Pill(by(&p), by(&core), r * j),
            };
            let here = answers(map, b, v);
            assert_eq!(answers(&large, scaled, by(&v)), here, "{j} times: {b:?} by {v:?} in {:?}", w.drawing);
            yes += u64::from(here.2);
        }
    });
    assert!(yes > done / 4, "{yes} of {done}");
}

fn cast(map: &SegmentMap, body: Body, v: P) -> Option<(u32, P, bool)> {
    match body {
        Body::Pill(..) => panic!("no capsule"),
        Body::Disc(c, r) => {
            let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
            let found = map.cast_shape(&b, vec2(v), RULES).unwrap()?;
            Some((found.hit.toi.raw(), point(found.body.centre()), found.hit.one_way))
        }
        Body::Rect(..) => {
            let b = Aabb::new(vec2(body.bounds().0), vec2(body.bounds().1)).unwrap();
            let found = map.cast_shape(&b, vec2(v), RULES).unwrap()?;
            Some((found.hit.toi.raw(), point(found.body.min()), found.hit.one_way))
        }
    }
}

/// P10, P11, P12: the position of a hit is free, and so are 64 positions of a way without a hit.
/// Longer ways hit no sooner. A way of no length hits nothing.
#[test]
fn p10_p11_p12_casts() {
    let mut hits = 0;
    let done = each(10, |_, w, map, body, v| {
        let d = (v.0 / 64 * 64, v.1 / 64 * 64);
        let case = || format!("{body:?} by {d:?} in {:?}", w.drawing);
        assert_eq!(cast(map, body, (0, 0)), None, "{}", case());
        let found = cast(map, body, d);
        let until = found.map_or(1 << 30, |f| f.0);
        assert!(until <= 1 << 30);
        for k in (0..=64).filter(|k| k << 24 <= until) {
            assert!(w.free(body.moved((d.0 / 64 * i64::from(k), d.1 / 64 * i64::from(k)))), "{k}: {}", case());
        }
        let Some((toi, there, _)) = found else { return };
        hits += 1;
        assert!(w.free(body.at(there)), "ends inside: {}", case());
        // Three times the way: the hit is at a third of the time, within a raw unit of way.
        let long = cast(map, body, (3 * d.0, 3 * d.1)).unwrap_or_else(|| panic!("lost: {}", case()));
        let way = |toi: u32, k: i64| i128::from(toi) * i128::from(k);
        let slack = 3 + i128::from(1u64 << 31) / len2(d).isqrt().max(1);
        assert!((way(long.0, 3) - way(toi, 1)).abs() <= slack, "{toi} and {}: {}", long.0, case());
    });
    assert!(hits > done / 4, "{hits} of {done}");
}

/// P14, P15, P16, P25: no gain of speed, no velocity into a surface that it has hit and still
/// touches, no effect without a velocity, and limited work.
#[test]
fn p14_p15_p16_p25_slides() {
    let mut touching = 0;
    each(14, |r, w, map, body, v| {
        let response = RESPONSES[r.below(4) as usize];
        let out = body.step(&mover(&[]).with_response(response), map, v).unwrap();
        let case = || format!("{body:?} by {v:?} {response:?} in {:?}\n{out:?}", w.drawing);
        assert!(len2(out.v) <= len2(v), "{}", case());
        assert!(w.free(out.body), "{}", case());
        let again = out.body.step(&mover(&[]), map, (0, 0)).unwrap();
        assert_eq!((again.body, again.v, again.hits.len(), again.work.iterations), (out.body, (0, 0), 0, 0));
        // Boxes have the faces' own normals: they touch a face where a step of two raw units
        // against its normal overlaps. A box at the end of a face goes past it if the next 64 raw
        // units, up to which a surface binds a way, are free.
        let long = 64 / out.v.0.abs().max(out.v.1.abs()).max(1) + 1;
        let passes = || (1..=long).all(|k| w.free(out.body.moved((k * out.v.0, k * out.v.1))));
        if response == Response::Slide && matches!(body, Body::Rect(..)) {
            for h in out.hits.iter().filter(|h| !h.one_way) {
                let n = (i64::from(h.axis.x), i64::from(h.axis.y));
                let near = out.body.moved((-2 * n.0.signum(), -2 * n.1.signum()));
                if !w.free(near) && (n.0 == 0 || n.1 == 0 || out.hits.len() == 1) {
                    touching += 1;
                    let leads_in = n.0 * out.v.0 + n.1 * out.v.1 < 0;
                    assert!(!leads_in || passes(), "into {n:?}: {}", case());
                }
            }
        }
        let segments: usize = w.drawing.paths.iter().map(|(_, p)| p.len()).sum();
        let (lo, hi) = body.bounds();
        let piece = w.drawing.cell.max(hi.0 - lo.0).max(hi.1 - lo.1);
        let pieces = v.0.abs().max(v.1.abs()) * 3 / 2 / piece + 2;
        // Where paths cross their segments are cut, at most once by each other.
        let features = 2 * (segments * segments) as i64 * pieces * i64::from(out.work.iterations);
        assert!(i64::from(out.work.features) <= features && out.work.iterations <= Mover::ITERATIONS, "{}", case());
    });
    assert!(touching > cases(12_000) / 60, "{touching}");
}
