//! Floors of pieces, corners in which bodies rest, and the order of a level's parts: P17, P18, P19.

use super::config;
use proptest::prelude::*;
use tilesat::{PathKind, SegmentMap};
use tilesat_judge::drawing::{Drawing, at, disc, mover, rect};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::{P, PX};

const GRAVITY: i64 = 10_922;

fn bodies() -> impl Strategy<Value = Body> {
    let raw = || prop_oneof![Just(0i64), -2i64..=2];
    (1i64..=12, 1i64..=12, any::<bool>(), raw()).prop_map(|(w, h, round, off)| {
        if round { Body::Disc((0, 0), w * PX + off) } else { Body::Rect((0, 0), (w * PX + off, h * PX)) }
    })
}

/// Bodies above the floor y = 0 (y down), touching it, close to it or falling, and velocities along
/// it.
fn above() -> impl Strategy<Value = (Body, P)> {
    let gap = prop_oneof![Just(0i64), 1i64..=3, 0i64..8 * PX];
    let speed = prop_oneof![-3i64..=3, -PX..PX];
    (bodies(), gap, -30i64..=30, -2i64..=2, speed, 0i64..2 * PX).prop_map(|(body, gap, x, off, vx, vy)| {
        let (_, hi) = body.bounds();
        (body.moved((x * PX + off, -hi.1 - gap)), (vx, vy))
    })
}

/// A level drop in pieces: the ends of segments between -100 and 100 units.
fn cuts() -> impl Strategy<Value = Vec<i64>> {
    prop::collection::btree_set(prop_oneof![(-99i64..100).prop_map(|x| x * PX), -100 * PX + 1..100 * PX], 0..12)
        .prop_map(|set| set.into_iter().collect())
}

/// The states of a body on a level, frame after frame.
fn trajectory(drawing: &Drawing, mut body: Body, mut v: P, frames: usize) -> Vec<(Body, P)> {
    let bytes = drawing.bytes();
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    (0..frames)
        .map(|_| {
            let out = body.step(&mover(&[]), &map, (v.0, v.1 + GRAVITY)).unwrap();
            (body, v) = (out.body, out.v);
            (body, v)
        })
        .collect()
}

proptest! {
    #![proptest_config(config(8))]

    /// In a V of any two sides whose slopes are k : n, a body comes to rest, and then never moves
    /// again.
    #[test]
    fn p17_rest(left in (1i64..=4, 1i64..=4), right in (1i64..=4, 1i64..=4), body in bodies(), x in -20i64..=20, off in -2i64..=2) {
        let far = |(n, k): (i64, i64)| (40 * n * PX, -40 * k * PX);
        let (l, r) = (far(left), far(right));
        let valley = vec![(0, 0), r, (r.0, 50 * PX), (-l.0, 50 * PX), (-l.0, l.1)];
        let drawing = Drawing::of(16 * PX, vec![(PathKind::Solid, valley)]);
        // High above both sides: slopes are at most 4.
        let start = body.moved((x * PX / 4 + off, -150 * PX));
        let states = trajectory(&drawing, start, (0, 0), 1500);
        let last = *states.last().unwrap();
        // Without friction, so a body that does not fit swings out first.
        prop_assert!(last.1 == (0, 0), "moves still: {last:?}");
        let first = states.iter().position(|s| *s == last).unwrap();
        prop_assert!(states[first..].iter().all(|s| *s == last), "moved again after {first}");
    }

    /// A floor of any number of pieces is one long floor: the same bits, frame after frame. The
    /// same upside down, and as separate walls.
    #[test]
    fn p18_pieces_are_one((body, v) in above(), cuts in cuts()) {
        let ends = |cuts: &[i64]| -> Vec<P> {
            [-100 * PX].iter().chain(cuts).chain(&[100 * PX]).map(|&x| (x, 0)).collect()
        };
        let whole = trajectory(&Drawing::new(16 * PX, &[(PathKind::Wall, &ends(&[])[..])]), body, v, 60);
        let pieces = ends(&cuts);
        prop_assert_eq!(&trajectory(&Drawing::new(16 * PX, &[(PathKind::Wall, &pieces)]), body, v, 60), &whole);
        let apart = pieces.windows(2).map(|w| (PathKind::Wall, w.to_vec())).collect();
        prop_assert_eq!(&trajectory(&Drawing::of(16 * PX, apart), body, v, 60), &whole);
        let mut solid = pieces.clone();
        solid.extend([at(100, 40), at(-100, 40)]);
        prop_assert_eq!(&trajectory(&Drawing::new(24 * PX, &[(PathKind::Solid, &solid)]), body, v, 60), &whole);
    }

    /// Shuffled paths and mirrored scenes give one result.
    #[test]
    fn p19_order_of_paths(order in Just((0..5usize).collect::<Vec<_>>()).prop_shuffle(), x in 0i64..64, y in 0i64..40, v in (-64i64..=64, -64i64..=64), round in any::<bool>()) {
        // Blocks side by side, a ramp, a one-way chain and a wall, all with common corners.
        let parts = [
            Drawing::block(at(0, 64), at(32, 80)),
            Drawing::block(at(32, 64), at(64, 80)),
            (PathKind::Solid, vec![at(64, 64), at(96, 48), at(96, 80), at(64, 80)]),
            (PathKind::OneWay, vec![at(0, 32), at(16, 32), at(48, 32)]),
            (PathKind::Wall, vec![at(96, 48), at(96, 0)]),
        ];
        let body = if round { disc(x + 6, y + 6, 5) } else { rect(x, y, 10, 9) };
        let v = (v.0 * PX / 2, v.1 * PX / 2);
        let plain = Drawing::of(16 * PX, parts.to_vec());
        let free = |d: &Drawing| {
            let bytes = d.bytes();
            let map = SegmentMap::from_bytes(&bytes).unwrap();
            body.step(&mover(&[]), &map, v).map(|o| (o.body, o.v, o.remaining, o.floor, o.wall, o.ceiling)).map_err(|e| format!("{e:?}"))
        };
        let shuffled = Drawing::of(16 * PX, order.iter().map(|&i| parts[i].clone()).collect());
        prop_assert_eq!(free(&shuffled), free(&plain));
    }
}
