//! Seams of segments: torture scenes 1 and 2, and P18: many short segments in a line are one long
//! one, bit for bit.

use tilesat::{PathKind, Response, SegmentMap};
use tilesat_judge::Random;
use tilesat_judge::drawing::{Drawing, VIEWS, at, direction, disc, mover, place, rect};
use tilesat_judge::rooms;
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::{P, PX, len2};

const CELL: i64 = 16 * PX;

/// The floor y = 100 from x = -320 to 320 in pieces of 16 units: points of one polygon, of one
/// wall, of one chain. Or separate walls and boxes, the latter side by side.
fn floors() -> Vec<Drawing> {
    let points: Vec<P> = (-20..=20).map(|k| at(16 * k, 100)).collect();
    let mut polygon = points.clone();
    polygon.extend([at(320, 150), at(-320, 150)]);
    let boxes = points.windows(2).map(|w| Drawing::block(w[0], (w[1].0, w[1].1 + 20 * PX)));
    let walls = points.windows(2).map(|w| (PathKind::Wall, w.to_vec()));
    vec![
        Drawing::new(CELL, &[(PathKind::Solid, &polygon)]),
        Drawing::new(CELL, &[(PathKind::Wall, &points)]),
        Drawing::new(24 * PX, &[(PathKind::OneWay, &points)]),
        Drawing::of(CELL, boxes.collect()),
        Drawing::of(24 * PX, walls.collect()),
    ]
}

/// Scenes 1 and 2: every phase of 1/16, speeds of 1/16 to 64, both ways, on floor, ceiling and
/// walls.
#[test]
fn scenes_1_and_2_collinear_seam_of_segments() {
    for (drawing, views) in floors().iter().flat_map(|d| VIEWS.map(|v| (d, v))) {
        let bytes = drawing.seen(views).bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let mover = mover(views);
        let up = direction(views, (0, -1));
        // All phases upright, every seventh in the other views.
        for phase in (0..256).step_by(if views.is_empty() { 1 } else { 7 }) {
            for speed in (0..=10).map(|k| 4096 << k).chain([3 * PX]).flat_map(|v| [v, -v]) {
                let x = phase * 4096;
                for start in [Body::Disc((x, 92 * PX), 8 * PX), Body::Rect((x, 92 * PX), at(8, 8))] {
                    let (mut body, along) = (place(views, start), direction(views, (speed, 0)));
                    for _ in 0..3 {
                        let out = body.step(&mover, &map, direction(views, (speed, PX / 4))).unwrap();
                        let case = || format!("{views:?} {:?} {body:?} by {speed}: {out:?}", drawing.paths[0].0);
                        assert_eq!((out.body, out.v), (body.moved(along), along), "{}", case());
                        let hit = out.hits.first().unwrap();
                        assert_eq!((i64::from(hit.axis.x), i64::from(hit.axis.y)), up, "{}", case());
                        // An odd index is a vertex.
                        assert!(out.hits.len() == 1 && hit.index % 2 == 0 && hit.toi.raw() == 0, "{}", case());
                        assert!(out.floor && !out.wall && !out.ceiling && out.remaining == (0, 0));
                        body = out.body;
                    }
                }
            }
        }
    }
}

/// Landing anywhere near a seam, from above and slanting. It hits only the floor, at the same point
/// and time as on one long segment.
#[test]
fn landing_on_a_seam_is_landing_on_one_segment() {
    let long: [P; 2] = [at(-320, 100), at(320, 100)];
    let one = Drawing::new(CELL, &[(PathKind::Wall, &long)]).bytes();
    let one = SegmentMap::from_bytes(&one).unwrap();
    let mut r = Random::new(18);
    for drawing in floors() {
        let bytes = drawing.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        for _ in 0..20_000 {
            let x = 16 * PX * r.around(3) + [0, r.around(2), r.around(8 * PX)][r.below(3) as usize];
            let (size, h) = (1 + r.magnitude(12 * PX), r.below(2) * r.magnitude(9 * PX));
            let body = if r.one_in(2) {
                Body::Disc((x, 100 * PX - size - h), size)
            } else {
                Body::Rect((x, 100 * PX - size - h), (1 + r.magnitude(20 * PX), size))
            };
            let v = (r.sign() * r.magnitude(60 * PX), r.magnitude(60 * PX));
            let response = [Response::Slide, Response::Touch, Response::Bounce][r.below(3) as usize];
            let mover = mover(&[]).with_response(response);
            let (a, b) = (body.step(&mover, &map, v).unwrap(), body.step(&mover, &one, v).unwrap());
            let list = |o: &rooms::body::Outcome| o.hits.iter().map(|h| (h.toi, h.axis)).collect::<Vec<_>>();
            let case = || format!("{:?} {body:?} by {v:?} {response:?}", drawing.paths[0].0);
            assert_eq!((a.body, a.v, a.remaining, list(&a)), (b.body, b.v, b.remaining, list(&b)), "{}", case());
        }
    }
}

/// P18 on slopes: a random cave, and the same with points between the ends of its sides. Every
/// frame of every body is the same bits.
#[test]
fn p18_a_chain_of_collinear_segments_is_one() {
    let mut r = Random::new(0x18);
    let (mut frames, mut hits, mut askew) = (0, 0, 0);
    while frames < 60_000 {
        // A ring of corners around the middle, each side a multiple of twelve.
        let unit = 12 * r.magnitude(PX).max(20);
        let ring = [(0, -9), (4, -7), (9, 0), (6, 5), (2, 9), (-3, 6), (-9, 1), (-6, -6)];
        let corners: Vec<P> = ring
            .iter()
            .map(|p: &(i64, i64)| ((p.0 * 2 + r.around(2)) * unit, (p.1 * 2 + r.around(2)) * unit))
            .collect();
        let cut = |parts: i64| -> Vec<P> {
            let n = corners.len();
            (0..n)
                .flat_map(|i| {
                    let (a, b) = (corners[i], corners[(i + 1) % n]);
                    (0..parts).map(move |k| (a.0 + (b.0 - a.0) * k / parts, a.1 + (b.1 - a.1) * k / parts))
                })
                .collect()
        };
        let cell = (unit * 3 / 2 * 2).clamp(256, 1 << 24);
        let maps: Vec<Vec<u8>> = [1, 2, 3, 4, 6]
            .map(|parts| {
                let mut points = cut(parts);
                points.push(points[0]);
                Drawing::new(cell, &[(PathKind::Wall, &points)]).bytes()
            })
            .into();
        let maps: Vec<SegmentMap> = maps.iter().map(|b| SegmentMap::from_bytes(b).unwrap()).collect();
        let size = unit / 2 + r.below(3 * unit);
        let mut body = if r.one_in(2) { Body::Disc((0, 0), size) } else { Body::Rect((0, 0), (size, size / 2 + 1)) };
        let mut v = (0, 0);
        for _ in 0..100 {
            if len2(v) < 64 || r.one_in(12) {
                v = (r.around(8 * unit), r.around(8 * unit));
            }
            v.1 += unit / 16;
            let list = |o: &rooms::body::Outcome| o.hits.iter().map(|h| (h.toi.raw(), h.axis)).collect::<Vec<_>>();
            let first = body.step(&mover(&[]), &maps[0], v).unwrap();
            for (k, map) in maps.iter().enumerate().skip(1) {
                let out = body.step(&mover(&[]), map, v).unwrap();
                assert_eq!(
                    (out.body, out.v, out.remaining, list(&out)),
                    (first.body, first.v, first.remaining, list(&first)),
                    "{k}: {body:?} by {v:?} in {corners:?}, cell {cell}"
                );
            }
            hits += first.hits.len();
            askew += first.hits.iter().filter(|h| h.axis.x != 0 && h.axis.y != 0).count();
            frames += 1;
            (body, v) = (first.body, first.v);
        }
    }
    assert!(hits > frames / 4 && askew > hits / 2, "{hits} hits, {askew} askew");
}

/// A body that lies over a seam, or whose side is on one, starts to move as on one segment.
#[test]
fn a_start_on_a_seam() {
    for drawing in floors() {
        for body in [disc(0, 92, 8), rect(0, 92, 8, 8), rect(-8, 92, 8, 8), rect(-4, 92, 8, 8), disc(16, 96, 4)] {
            for (vx, vy) in [(0, 0), (0, PX), (1, 1), (-1, 1), (PX, 0), (-PX, 0), (64 * PX, PX), (-64 * PX, PX)] {
                let out = drawing.step(body, (vx, vy), |m| m);
                assert_eq!((out.body, out.v), (body.moved((vx, 0)), (vx, 0)));
                assert_eq!(out.floor, vy > 0);
            }
        }
    }
}

/// Points, and boxes without width, fall on seams and a raw unit beside them. There is no gap.
#[test]
fn no_gap_at_a_seam() {
    for drawing in floors() {
        for (x, dx) in [(0, 0), (1, 0), (-1, 0), (16 * PX, 3), (-16 * PX, -PX), (32 * PX - PX, 2 * PX)] {
            for size in [(0, 0), (0, 8 * PX), (1, 1)] {
                let body = Body::Rect((x, 99 * PX - size.1), size);
                let point = Body::Disc((x, 99 * PX), 0);
                for (body, v) in [(body, (dx, 2 * PX)), (point, (dx, 2 * PX)), (body, (dx, 300 * PX))] {
                    let out = drawing.step(body, v, |m| m);
                    assert_eq!((out.body.bounds().1.1, out.v), (100 * PX, (dx, 0)), "{body:?} by {v:?} in {drawing:?}");
                }
            }
        }
    }
}
