//! Torture scenes of the survey among segments, by its numbers, with the required results. Whole
//! units, y grows downward.

use tilesat::{Aabb, Axis, Circle, Fx, Mover, Path, PathKind, Response, SegmentMap, Vec2, motion::Hits};

type P = (i32, i32);

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
const ONE: i32 = 1 << 16;

fn at(x: i32, y: i32) -> P {
    (x * ONE, y * ONE)
}

/// The bytes of a level of paths.
fn build(paths: &[(PathKind, Vec<P>)]) -> Vec<u8> {
    let points: Vec<Vec<Vec2>> =
        paths.iter().map(|(_, p)| p.iter().map(|&(x, y)| Vec2::from_raw(x, y)).collect()).collect();
    let paths: Vec<Path<'_>> =
        paths.iter().zip(&points).map(|((kind, _), points)| Path { points, kind: *kind, flags: 0 }).collect();
    let size = SegmentMap::measure(&paths, Fx::from_num(32)).unwrap();
    let mut out = vec![0; size.bytes()];
    SegmentMap::build_on(&paths, size.grid(), &mut out).unwrap();
    out
}

/// A body, box or circle: `(corner or centre, size or radius twice)`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Body {
    Rect(P, P),
    Disc(P, i32),
}

#[derive(Clone, Debug, PartialEq)]
struct Out {
    at: P,
    v: P,
    hits: Vec<(u32, Axis)>,
    iterations: u32,
}

fn go(map: &SegmentMap<'_>, mover: Mover, body: Body, v: P) -> Out {
    let velocity = Vec2::from_raw(v.0, v.1);
    let list = |hits: &Hits| hits.iter().map(|h| (h.toi.raw(), h.axis)).collect();
    match body {
        Body::Rect((x, y), (w, h)) => {
            let b = Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).unwrap();
            let m = mover.move_and_slide(map, &b, velocity).unwrap_or_else(|e| panic!("{e}: {b:?} by {velocity:?}"));
            Out { at: m.position().raw(), v: m.velocity.raw(), hits: list(&m.hits), iterations: m.work.iterations }
        }
        Body::Disc((x, y), r) => {
            let b = Circle::new(Vec2::from_raw(x, y), Fx::from_bits(r)).unwrap();
            let m = mover.move_and_slide(map, &b, velocity).unwrap_or_else(|e| panic!("{e}: {b:?} by {velocity:?}"));
            Out { at: m.position().raw(), v: m.velocity.raw(), hits: list(&m.hits), iterations: m.work.iterations }
        }
    }
}

fn moved(body: Body, to: P) -> Body {
    match body {
        Body::Rect(_, size) => Body::Rect(to, size),
        Body::Disc(_, r) => Body::Disc(to, r),
    }
}

fn rect(x: i32, y: i32, w: i32, h: i32) -> (PathKind, Vec<P>) {
    (PathKind::Solid, vec![at(x, y), at(x + w, y), at(x + w, y + h), at(x, y + h)])
}

/// A room with its floor at y = 100 and its wall at x = 100, each a chain of segments of 16 units
/// in one polygon.
fn room() -> Vec<u8> {
    let floor = (0..=6).map(|k| at(4 + 16 * k, 100));
    let wall = (0..=6).rev().map(|k| at(100, 4 + 16 * k)).skip(1);
    let mut points: Vec<P> = floor.chain(wall).collect();
    points.extend([at(140, 4), at(140, 140), at(4, 140)]);
    build(&[(PathKind::Solid, points)])
}

/// Every phase of a sixteenth along a floor of segments, at many speeds, to the right and to the
/// left: y stays, vx stays, one normal.
#[test]
fn scenes_1_and_2_collinear_seams() {
    let points = (0..=40).map(|k| at(16 * k, 100)).chain([at(640, 140), at(0, 140)]).collect();
    let bytes = build(&[(PathKind::Solid, points)]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    for body in [Body::Disc(at(0, 92), 8 * ONE), Body::Rect(at(0, 92), at(8, 8))] {
        for phase in 0..256 {
            let x0 = 320 * ONE + phase * ONE / 16;
            for speed in [ONE / 16, 3 * ONE, 17 * ONE + 1, 64 * ONE] {
                for v in [(speed, ONE / 4), (-speed, ONE / 4)] {
                    let mut x = x0;
                    for _ in 0..3 {
                        let out = go(&map, PLAYER, moved(body, (x, 92 * ONE)), v);
                        x += v.0;
                        assert_eq!((out.at, out.v), ((x, 92 * ONE), (v.0, 0)));
                        assert!(out.hits.iter().all(|h| h.1 == Axis::NEG_Y) && out.hits.len() == 1);
                    }
                }
            }
        }
    }
}

#[test]
fn scenes_4_and_5_into_an_inside_corner() {
    let bytes = room();
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    for (body, end) in [(Body::Rect(at(72, 72), at(16, 16)), at(84, 84)), (Body::Disc(at(80, 80), 8 * ONE), at(92, 92))]
    {
        let out = go(&map, PLAYER, body, at(40, 40));
        let times: Vec<u32> = out.hits.iter().map(|h| h.0).collect();
        let axes: Vec<Axis> = out.hits.iter().map(|h| h.1).collect();
        assert_eq!((out.at, out.v, axes), (end, (0, 0), vec![Axis::NEG_X, Axis::NEG_Y]));
        assert!(times.iter().all(|t| t.abs_diff((1 << 30) / 10 * 3) <= 8), "{times:?}");
    }
}

/// Two segments that meet in a peak at (16, 40).
#[test]
fn scene_9_a_peak_head_on() {
    let bytes = build(&[(PathKind::Solid, vec![at(0, 56), at(16, 40), at(32, 56)])]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let out = go(&map, PLAYER.with_response(Response::Touch), Body::Disc(at(16, 0), 8 * ONE), at(0, 64));
    assert_eq!(out.hits[0].1, Axis::NEG_Y);
    assert!((1 << 29) - out.hits[0].0 <= 2 && out.at.0 == 16 * ONE && (32 * ONE - out.at.1) <= 1, "{out:?}");
    let box_ = go(&map, PLAYER, Body::Rect(at(8, 0), at(16, 8)), at(0, 64));
    assert_eq!((box_.at, box_.v, box_.hits), (at(8, 32), (0, 0), vec![(1 << 29, Axis::NEG_Y)]));
}

#[test]
fn scene_10_box_corner_exactly_onto_a_corner() {
    let bytes = build(&[rect(0, 0, 8, 8)]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let out = go(&map, PLAYER, Body::Rect(at(10, 10), at(2, 2)), at(-9, -9));
    assert_eq!((out.at, out.hits[0].1), (at(8, 1), Axis::X));
    // A raw unit beside the tie, the swapped axes give the swapped result.
    let (x, y) = ((-9 * ONE - 1, -9 * ONE), (-9 * ONE, -9 * ONE - 1));
    let [a, b] = [x, y].map(|v| go(&map, PLAYER, Body::Rect(at(10, 10), at(2, 2)), v));
    assert_eq!((a.hits[0].1, b.hits[0].1, a.at), (Axis::Y, Axis::X, (b.at.1, b.at.0)));
}

#[test]
fn scene_11_shared_corner_is_no_hit() {
    let bytes = build(&[rect(16, 0, 16, 16)]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    for body in [Body::Rect(at(0, 16), at(16, 16)), Body::Disc(at(8, 24), 8 * ONE)] {
        let out = go(&map, PLAYER, body, at(-1, -1));
        assert!(out.hits.is_empty() && out.v == at(-1, -1));
    }
    assert_eq!(go(&map, PLAYER, Body::Rect(at(0, 16), at(16, 16)), at(1, -1)).hits.len(), 1);
}

/// A wedge of one degree: a body larger than its mouth rests on the rims, a smaller one in it.
#[test]
fn scene_13_a_wedge_of_one_degree() {
    // 1.75 wide at a depth of 100.
    let wide = 7 * ONE / 8;
    let points = vec![at(-40, 0), (-wide, 0), at(0, 100), (wide, 0), at(40, 0), at(40, 120), at(-40, 120)];
    let bytes = build(&[(PathKind::Solid, points)]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let mut iterations = 0;
    for body in [
        Body::Disc((333, -4 * ONE), 4 * ONE),
        Body::Disc((-20, -ONE), ONE),
        Body::Disc((0, -3 * ONE), ONE / 2),
        Body::Disc((5, -3 * ONE), ONE / 8),
        Body::Rect((-2 * ONE, -9 * ONE), at(4, 4)),
        Body::Rect((-ONE / 2, -3 * ONE), (ONE, ONE)),
        Body::Rect((-ONE / 8, -3 * ONE), (ONE / 4, ONE / 8)),
    ] {
        let (mut body, mut v, mut still) = (body, (0, 0), 0);
        for _ in 0..10_000 {
            let out = go(&map, PLAYER, body, (v.0, v.1 + ONE / 16));
            iterations = iterations.max(out.iterations);
            let next = moved(body, out.at);
            still = if (next, out.v) == (body, v) { still + 1 } else { 0 };
            (body, v) = (next, out.v);
        }
        assert!(still > 1000, "{body:?} by {v:?}");
    }
    assert!(iterations <= Mover::ITERATIONS);
}

/// A slope that ends at a wall, one under a ceiling, and flat, slope, flat.
#[test]
fn scene_40_slopes_and_walls() {
    let end = |bytes: &[u8], body: Body, v: P, gravity: i32| {
        let map = SegmentMap::from_bytes(bytes).unwrap();
        let (mut body, mut v, mut out) = (body, v, None);
        for _ in 0..2000 {
            let o = go(&map, PLAYER, body, (v.0, v.1 + gravity));
            (body, v) = (moved(body, o.at), o.v);
            out = Some((body, v));
        }
        let o = go(&map, PLAYER, body, (v.0, v.1 + gravity));
        assert_eq!(out, Some((moved(body, o.at), o.v)), "still moves");
        o
    };
    let wall = build(&[(PathKind::Solid, vec![at(0, 0), at(60, 25), at(60, -80), at(90, -80), at(90, 60), at(0, 60)])]);
    for body in [Body::Disc(at(20, -20), 5 * ONE), Body::Rect(at(20, -20), at(7, 9))] {
        let out = end(&wall, body, at(1, 0), ONE / 8);
        assert_eq!(out.hits.len(), 2, "{out:?}");
    }
    let wedge = build(&[
        (PathKind::Solid, vec![at(0, 40), at(80, 0), at(80, 50), at(0, 50)]),
        (PathKind::Solid, vec![at(0, -30), at(80, -30), at(80, 0), at(0, -20)]),
    ]);
    for body in [Body::Disc(at(10, 20), 3 * ONE), Body::Rect(at(4, 20), at(5, 5))] {
        let map = SegmentMap::from_bytes(&wedge).unwrap();
        let mut body = body;
        let mut last = body;
        for _ in 0..200 {
            last = body;
            body = moved(body, go(&map, PLAYER, body, at(3, 0)).at);
        }
        assert_eq!(body, last);
    }
    let hill = build(&[(
        PathKind::Solid,
        vec![at(0, 40), at(40, 40), at(80, 24), at(120, 40), at(160, 40), at(160, 60), at(0, 60)],
    )]);
    let map = SegmentMap::from_bytes(&hill).unwrap();
    let (mut body, mut v) = (Body::Disc(at(12, 32), 8 * ONE), at(2, 0));
    for _ in 0..25 {
        let out = go(&map, PLAYER, body, (v.0, v.1 + ONE / 8));
        assert!(out.hits.iter().all(|h| h.1.y < 0), "{out:?}");
        (body, v) = (moved(body, out.at), out.v);
    }
}

/// Every order of six polygons gives the same bits (P19).
#[test]
fn scene_47_every_order_of_insertion() {
    let six = [
        rect(0, 80, 200, 20),
        (PathKind::Solid, vec![at(30, 80), at(60, 60), at(90, 80)]),
        rect(120, 40, 20, 40),
        (PathKind::Solid, vec![at(0, 0), at(25, 80), at(0, 80)]),
        (PathKind::OneWay, vec![at(60, 40), at(120, 44)]),
        (PathKind::Wall, vec![at(70, 10), at(90, 20)]),
    ];
    let starts = [(Body::Disc(at(50, 20), 6 * ONE), at(3, 1)), (Body::Rect(at(20, 0), at(9, 7)), (5 * ONE, 12_345))];
    let run = |order: &[usize]| {
        let bytes = build(&order.iter().map(|&k| six[k].clone()).collect::<Vec<_>>());
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        starts.map(|(body, v)| {
            let (mut body, mut v, mut seen) = (body, v, Vec::new());
            for k in 0..80 {
                let out = go(&map, PLAYER, body, (v.0, v.1 + ONE / 2));
                let kick = (if k % 40 == 19 { -2 * ONE } else { 2 * ONE + 1 }, -2 * ONE);
                (body, v) = (moved(body, out.at), if k % 20 == 19 { kick } else { out.v });
                seen.push((out.at, out.v, out.hits));
            }
            seen
        })
    };
    let expected = run(&[0, 1, 2, 3, 4, 5]);
    assert!(expected.iter().all(|seen| seen.iter().filter(|s| !s.2.is_empty()).count() > 5));
    let mut order = [0, 1, 2, 3, 4, 5];
    let mut count = [0; 6];
    let (mut i, mut orders) = (0, 1);
    // Heap's permutations.
    while i < 6 {
        if count[i] < i {
            order.swap(if i % 2 == 0 { 0 } else { count[i] }, i);
            assert_eq!(run(&order), expected, "{order:?}");
            orders += 1;
            count[i] += 1;
            i = 0;
        } else {
            count[i] = 0;
            i += 1;
        }
    }
    assert_eq!(orders, 720);
}
