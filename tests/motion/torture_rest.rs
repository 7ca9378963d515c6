//! Rest, wedges and joints of slopes among segments: torture scenes 13, 40, 43, 45 and 49.

use tilesat::{MoveError, Mover, PathKind, Ratio, SegmentMap, Surface, motion::StartInside};
use tilesat_judge::drawing::{Drawing, VIEWS, at, back, direction, disc, mover, place, rect};
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::{P, PX, drawn, len2};
use tilesat_judge::shapes::level::Level;

const CELL: i64 = 16 * PX;
const GRAVITY: i64 = PX / 4;
const TICKS: usize = 10_000;

/// Frames under gravity in each view. The frame from which on nothing changes is at most `settled`.
/// The end, seen upright, is the same in all.
fn rests(drawing: &Drawing, body: Body, v: P, settled: usize) -> Outcome {
    let ends = ends(drawing, body, v, settled);
    let first = ends[0];
    for (views, out) in VIEWS.iter().zip(&ends) {
        assert_eq!(place(views, first.body), out.body, "{views:?}");
        assert_eq!((out.floor, out.wall, out.ceiling), (first.floor, first.wall, first.ceiling), "{views:?}");
    }
    first
}

/// The end in each view, as it is seen there.
fn ends(drawing: &Drawing, body: Body, v: P, settled: usize) -> Vec<Outcome> {
    let mut ends = Vec::new();
    for views in VIEWS {
        let bytes = drawing.seen(views).bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let (mut b, mut v, pull) = (place(views, body), direction(views, v), direction(views, (0, GRAVITY)));
        let (mut last, mut moved) = (None, 0);
        for k in 0..TICKS {
            let pulled = (v.0 + pull.0, v.1 + pull.1);
            let out = b.step(&mover(views), &map, pulled).unwrap();
            assert!(len2(out.v) <= len2(pulled) && out.work.iterations <= Mover::ITERATIONS);
            if (out.body, out.v) != (b, v) {
                moved = k;
            }
            let still = (out.body, out.v) == (b, v);
            (b, v) = (out.body, out.v);
            last = Some(out);
            // Only body and velocity enter the next call, so it is the same. The upright view plays
            // all ticks.
            if still && !views.is_empty() {
                break;
            }
        }
        assert!(moved < settled, "{views:?}: {body:?} moved in frame {moved}, {last:?}");
        assert_eq!(v, (0, 0), "{views:?}");
        ends.push(last.unwrap());
    }
    ends
}

/// A notch of one degree: its mouth at y = 100 from x = 0 to 7/4 (100 deep, tan 1 degree =
/// 0.01746), in walls and in a polygon.
fn notches() -> [Drawing; 2] {
    let (a, b, c) = ((0, 100 * PX), (7 * PX / 8, 150 * PX), (7 * PX / 4, 100 * PX));
    let ring = [at(-60, 100), a, b, c, at(60, 100), at(60, 200), at(-60, 200)];
    [Drawing::new(CELL, &[(PathKind::Solid, &ring)]), Drawing::new(CELL, &[(PathKind::Wall, &ring[..5])])]
}

#[test]
fn scene_13_a_wedge_narrower_than_the_body() {
    let mouth = 7 * PX / 4;
    for notch in notches() {
        // On the rims: the circle in the middle, with its lowest point in the mouth by r - sqrt(r^2
        // - (mouth / 2)^2).
        for r in [PX, 8 * PX, 40 * PX] {
            // Exactly over the middle it meets both rims at once: a tie, which mirrors need not
            // preserve (two raw, see `Mover::move_and_slide`).
            for out in ends(&notch, Body::Disc((mouth / 2, 99 * PX - r), r), (0, 0), 3000) {
                assert!(out.floor == (r > PX) && out.wall != out.floor, "{out:?}");
            }
            for dx in [1, -1, PX / 8] {
                let out = rests(&notch, Body::Disc((mouth / 2 + dx, 100 * PX - r - PX), r), (0, 0), 3000);
                let (x, y) = out.body.position();
                let deep = r - (r * r - mouth * mouth / 4).isqrt();
                assert!(
                    (x - mouth / 2).abs() <= 8 + r / PX && (y + r - 100 * PX - deep).abs() <= 8,
                    "{r} {dx}: {out:?}"
                );
                // On rims that are steeper than the limit it rests between two walls.
                assert!(out.floor == (r > PX) && out.wall != out.floor, "{out:?}");
            }
        }
        // Flat bodies lie on the rims, wherever their middle is.
        for x in [mouth / 2 - 8 * PX, mouth / 2 - 8 * PX + 1, -12 * PX, -PX] {
            let out = rests(&notch, Body::Rect((x, 80 * PX), at(16, 16)), (0, 0), 60);
            assert_eq!((out.body.position(), out.floor), ((x, 84 * PX), true));
        }
        // Driven into it at any speed, it stops there and does not slip in.
        for v in [at(0, 4000), at(300, 4000), at(-60, 60)] {
            let out = notch.step(Body::Disc((mouth / 2 + PX / 16, 40 * PX), 8 * PX), v, |m| m);
            assert!(out.body.position().1 < 93 * PX && out.work.iterations <= Mover::ITERATIONS, "{out:?}");
        }
        // A body narrower than the mouth goes in until it meets both sides.
        let out = rests(&notch, Body::Disc((mouth / 2, 90 * PX), PX / 2), (0, 0), 3000);
        assert!(out.body.position().1 > 110 * PX && out.hits.len() <= 4, "{out:?}");
    }
}

/// A slope down to a wall, a slope up under a ceiling: it stops, once, and stays.
#[test]
fn scene_40_slope_meets_wall_and_ceiling() {
    let wall = [at(-100, 0), at(0, 0), at(60, 60), at(60, -60), at(100, -60), at(100, 100), at(-100, 100)];
    let wall = Drawing::new(CELL, &[(PathKind::Solid, &wall)]);
    for (body, v) in [(disc(5, -9, 6), at(2, 0)), (rect(2, -12, 9, 10), at(2, 0))] {
        let out = rests(&wall, body, v, 400);
        let (_, hi) = out.body.bounds();
        assert!(out.floor && out.wall && hi.0 == 60 * PX, "{out:?}");
    }
    let ramp = [at(-100, 100), at(0, 100), at(80, 60), at(80, 140), at(-100, 140)];
    let lid = Drawing::block(at(20, 0), at(120, 80));
    let wedge = Drawing::of(CELL, vec![(PathKind::Solid, ramp.to_vec()), lid]);
    for body in [disc(-20, 94, 6), rect(-30, 88, 9, 12)] {
        // Pushed into it again and again without gravity.
        let (mut b, mut still) = (body, 0);
        for _ in 0..300 {
            let out = wedge.step(b, at(3, 0), |m| m);
            still = if out.body == b { still + 1 } else { 0 };
            assert!(len2(out.v) <= len2(at(3, 0)));
            b = out.body;
        }
        assert!(still > 200 && b.bounds().1.0 < 60 * PX, "{b:?}");
        let back = wedge.step(b, at(-3, 0), |m| m);
        assert_eq!((back.body, back.hits.len()), (b.moved(at(-3, 0)), 0));
    }
}

/// Flat, slope, flat, slope of the same steepness. Pressed to it at walking speed, it touches the
/// ground in every frame, and nothing else.
#[test]
fn scene_40_no_hop_at_the_joints() {
    let points =
        [at(-200, 100), at(0, 100), at(40, 80), at(80, 80), at(120, 60), at(300, 60), at(300, 200), at(-200, 200)];
    let hills = Drawing::new(24 * PX, &[(PathKind::Solid, &points)]);
    for views in VIEWS {
        let bytes = hills.seen(views).bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        for body in [disc(-40, 92, 8), rect(-48, 84, 16, 16)] {
            for (speed, pull) in [(2 * PX, PX), (3 * PX + 77, 3 * PX)] {
                let mut b = place(views, body);
                for k in 0..110 {
                    let out = b.step(&mover(views), &map, direction(views, (speed, pull))).unwrap();
                    assert!(out.floor && !out.wall && !out.ceiling, "{views:?} frame {k}: {out:?}");
                    b = out.body;
                }
            }
        }
    }
}

/// A quarter pipe continues into a floor and a wall along their tangents. Those joints are no
/// corners, at any phase.
#[test]
fn scene_40_a_tangent_joint_is_no_corner() {
    let level = drawn(&["#......#", "#......#", "#(....)#", "########"], CELL, &[(')', 16), ('(', 17)]);
    for views in &VIEWS[..8] {
        let seen: Level = views.iter().fold(level.clone(), |l, view| view.level(&l));
        let map = seen.all();
        for phase in 0..64 {
            for body in [disc(64, 42, 6), rect(60, 40, 8, 8)] {
                let (mut b, mut v) = (place(views, body.moved((phase * 1024, 0))), (3 * PX, 0));
                for _ in 0..30 {
                    let pulled = (v.0, v.1 + PX / 64);
                    let out = b.step(&mover(views), &map, direction(views, pulled)).unwrap();
                    assert!(len2(out.v) <= len2(pulled), "{views:?}: {out:?}");
                    // Of tiles, 4 to 7 are corners.
                    assert!(out.hits.iter().all(|h| !(4..8).contains(&h.index)), "{views:?}: {out:?}");
                    (b, v) = (out.body, back(views, out.v));
                }
                // It went up the pipe, and lost almost nothing at the joint.
                assert!(v.1 < 0 || b.middle() != body.middle(), "{views:?}: {b:?}");
            }
        }
    }
}

/// Deep in a polygon: refused, and never moved. With the start ignored, it moves by the motion and
/// no more.
#[test]
fn scene_43_start_deep_inside() {
    let block = Drawing::of(CELL, vec![Drawing::block(at(0, 0), at(160, 160))]);
    for views in VIEWS {
        let bytes = block.seen(views).bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        for body in [disc(80, 85, 6), rect(74, 80, 12, 10), disc(80, 80, 0)] {
            let body = place(views, body);
            // Nothing moves, and the call does not look at the level.
            assert_eq!(body.step(&mover(views), &map, (0, 0)).unwrap().body, body);
            for v in [(1, 0), at(5, 5), at(0, 300), at(-4000, 4000)] {
                assert!(matches!(body.step(&mover(views), &map, v), Err(MoveError::Stuck(_))), "{body:?} by {v:?}");
                let leaves = mover(views).with_inside(StartInside::Ignore);
                let out = body.step(&leaves, &map, v).unwrap();
                assert_eq!((out.body, out.v, out.hits.len()), (body.moved(v), v, 0));
            }
        }
    }
}

/// A door of one tile byte: closed on a body, on one at its edge, and opened again.
#[test]
fn scene_45_door_toggled() {
    let open = drawn(&["#####", "#...#", "#####"], CELL, &[]);
    let closed = drawn(&["#####", "#.#.#", "#####"], CELL, &[]);
    for views in &VIEWS[..8] {
        let turn = |l: &Level| views.iter().fold(l.clone(), |l, view| view.level(&l));
        let (open, closed) = (turn(&open), turn(&closed));
        let go = |l: &Level, b: Body, v: P| place(views, b).step(&mover(views), &l.all(), direction(views, v));
        for (inside, edge) in [(rect(28, 20, 8, 8), rect(24, 20, 8, 8)), (disc(30, 24, 4), disc(28, 24, 4))] {
            for v in [(0, 1), at(3, 0), at(-3, 0)] {
                assert!(matches!(go(&closed, inside, v), Err(MoveError::Stuck(_))));
                assert_eq!(go(&open, inside, v).unwrap().body, place(views, inside.moved(v)));
            }
            // At the edge: the door's side stops it at once. It is free away from it and along it.
            let out = go(&closed, edge, at(3, 0)).unwrap();
            assert_eq!((out.body, out.hits.len(), out.wall), (place(views, edge), 1, true));
            for v in [at(-3, 0), at(0, 2)] {
                assert_eq!(go(&closed, edge, v).unwrap().hits.len(), 0);
            }
            // Opened, the floor under it has no seam and no side.
            let (lo, hi) = edge.bounds();
            let low = edge.moved((0, 32 * PX - hi.1));
            let out = go(&open, low, at(9, 1)).unwrap();
            assert_eq!((out.body, out.hits.len()), (place(views, low.moved(at(9, 0))), 1), "{lo:?}");
        }
    }
}

/// Ten thousand ticks on segments: flat without friction, a slope and a valley with.
#[test]
fn scene_49_resting_ten_thousand_ticks() {
    let flat = Drawing::new(CELL, &[(PathKind::Wall, &[at(-50, 100), at(3, 100), at(50, 100)])]);
    for body in [disc(0, 92, 8), rect(-5, 88, 12, 12), disc(3, 96, 4)] {
        let out = rests(&flat, body, (0, 0), 1);
        assert_eq!((out.body, out.floor), (body, true));
    }
    let rough = |views| mover(views).with_surface(Surface::new(Ratio::ZERO, Ratio::ONE));
    for slope in [[at(-100, 150), at(0, 100), at(100, 50)], [at(-90, 190), at(0, 100), at(90, 10)]] {
        let drawing = Drawing::new(CELL, &[(PathKind::Wall, &slope)]);
        for (views, body) in VIEWS.iter().flat_map(|v| [(v, disc(5, 70, 8)), (v, rect(-6, 60, 12, 12))]) {
            let bytes = drawing.seen(views).bytes();
            let map = SegmentMap::from_bytes(&bytes).unwrap();
            let (mut b, mut v, pull) = (place(views, body), (0, 0), direction(views, (0, GRAVITY)));
            let mut moved = 0;
            for k in 0..TICKS {
                let out = b.step_on(&rough(views), &map, (v.0 + pull.0, v.1 + pull.1)).unwrap();
                let still = (out.body, out.v) == (b, v);
                moved = if still { moved } else { k };
                (b, v) = (out.body, out.v);
                if still && !views.is_empty() {
                    break;
                }
            }
            assert!(moved < 200 && v == (0, 0), "{views:?}: {body:?} moved in frame {moved}");
        }
    }
}
