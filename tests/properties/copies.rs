//! Many bodies: neither an order nor a copy changes anything (P19, P26). Rollbacks.

use super::config;
use proptest::prelude::*;
use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SortSweep, SpatialHash};
use tilesat::scene::SceneTag;
use tilesat::{Aabb, AllShapes, Circle, Filter, Fx, Grid, Mover, Scene, SceneBody, TileKind, TileKinds, TileMap, Vec2};

type P = (i64, i64);

const MOST: usize = 16;

/// Boxes around lines and corners of cells of 16 units: corner and size in quarters of a cell, up
/// to 2 raw off.
fn boxes() -> impl Strategy<Value = Vec<(P, P, P)>> {
    let one = ((0i64..40, 0i64..30), (0i64..=4, 0i64..=4), (-2i64..=2, -2i64..=2));
    prop::collection::vec(one, 1..MOST)
}

fn aabb(((x, y), (w, h), off): (P, P, P)) -> Aabb {
    let unit = 4 << 16;
    let lo = (x * unit + off.0, y * unit + off.1);
    let raw = |p: P| Vec2::from_raw(p.0 as i32, p.1 as i32);
    // At most as large as a cell.
    Aabb::new(raw(lo), raw((lo.0 + w * unit, lo.1 + h * unit))).unwrap()
}

/// Pairs of the numbers that bodies got, each once, in order. Repeats stay, so that a test sees
/// them.
fn pairs<B: BroadPhase<Tag = Filter>>(
    mut near: B,
    order: &[usize],
    boxes: &[Aabb],
    start: &[Aabb],
) -> Vec<(usize, usize)> {
    let handles: Vec<_> = order.iter().map(|&i| (near.insert(&start[i], Filter::default()).unwrap(), i)).collect();
    for &(handle, i) in &handles {
        near.move_to(handle, &boxes[i]).unwrap();
    }
    let name = |h| handles.iter().find(|n| n.0 == h).unwrap().1;
    let mut found = Vec::new();
    near.pairs(|pair| {
        let (a, b) = (name(pair.a), name(pair.b));
        found.push((a.min(b), a.max(b)));
    });
    found.sort_unstable();
    found
}

static KINDS: TileKinds =
    TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'/', TileKind::of(tilesat::TileShape::SlopeBottomRight));
const ROOM: &[u8; 48] = b"#......##......##......##......##./...######.###";

fn level() -> TileMap<'static, AllShapes> {
    TileMap::of(ROOM, Grid::new(8, 6, Fx::from_num(32), Vec2::ZERO).unwrap(), &KINDS).unwrap()
}

/// Bodies of a scene: middle, size and velocity, in units.
fn crowds() -> impl Strategy<Value = Vec<SceneBody>> {
    let one = ((50i16..200, 20i16..110), 4i16..=12, (-3i16..=3, -3i16..=3), any::<bool>());
    prop::collection::vec(one, 1..8).prop_map(|all| {
        let made = all.iter().enumerate().map(|(key, &((x, y), size, v, round))| {
            let c = Vec2::from_ints(x, y);
            let half = Vec2::from_ints(size / 2, size / 2);
            let key = key as u32 + 7;
            let body = if round {
                SceneBody::new(Circle::new(c, Fx::from_num(size / 2)).unwrap(), key)
            } else {
                SceneBody::new(Aabb::new(c - half, c + half).unwrap(), key)
            };
            SceneBody { velocity: Vec2::from_ints(v.0, v.1), ..body }
        });
        made.filter(|b| !b.shape.overlaps_level(&level())).collect()
    })
}

type Sweep = Scene<SortSweep<MOST, SceneTag>, MOST>;

fn filled<B: BroadPhase<Tag = SceneTag>>(near: B, bodies: &[SceneBody]) -> Scene<B, MOST> {
    let mut scene = Scene::new(near);
    for body in bodies {
        scene.insert(body).unwrap();
    }
    scene
}

fn step<B: BroadPhase<Tag = SceneTag>>(scene: &mut Scene<B, MOST>) {
    scene.step(&level(), Vec2::from_raw(0, 1 << 14), |_| {}).unwrap();
}

fn states<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, MOST>) -> Vec<SceneBody> {
    let mut all: Vec<_> = scene.bodies().map(|(_, body)| *body).collect();
    all.sort_by_key(|body| body.key);
    all
}

proptest! {
    #![proptest_config(config(4))]

    /// Each structure finds the pairs of the definition, each once, whatever the order of insertion
    /// and the earlier positions.
    #[test]
    fn p26_pairs_of_the_definition(now in boxes(), before in boxes(), turn in 0usize..MOST) {
        let boxes: Vec<_> = now.iter().map(|b| aabb(*b)).collect();
        let start: Vec<_> = (0..boxes.len()).map(|i| aabb(before[i % before.len()])).collect();
        let n = boxes.len();
        let touch = |a: &Aabb, b: &Aabb| {
            let (a, b) = ((a.min().raw(), a.max().raw()), (b.min().raw(), b.max().raw()));
            a.0.0 <= b.1.0 && b.0.0 <= a.1.0 && a.0.1 <= b.1.1 && b.0.1 <= a.1.1
        };
        let expected: Vec<_> =
            (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).filter(|&(i, j)| touch(&boxes[i], &boxes[j])).collect();
        let straight: Vec<usize> = (0..n).collect();
        let turned: Vec<usize> = (0..n).rev().map(|i| (i + turn) % n).collect();
        for order in [&straight, &turned] {
            prop_assert_eq!(&pairs(BruteForce::<MOST, Filter>::new(), order, &boxes, &start), &expected);
            prop_assert_eq!(&pairs(SortSweep::<MOST, Filter>::new(), order, &boxes, &start), &expected);
            let grid = LooseGrid::<8, MOST, Filter>::new(Vec2::ZERO, Fx::from_num(16), 16).unwrap();
            prop_assert_eq!(&pairs(grid, order, &boxes, &start), &expected);
            prop_assert_eq!(&pairs(SpatialHash::<64, MOST, Filter>::new(Fx::from_num(16)).unwrap(), order, &boxes, &start), &expected);
        }
    }

    /// A scene is the same for every order of insertion and on every broad phase.
    #[test]
    fn p19_order_of_bodies(bodies in crowds(), turn in 0usize..8) {
        let mut turned = bodies.clone();
        turned.reverse();
        turned.rotate_left(turn % bodies.len().max(1));
        let mut one = filled(SortSweep::<MOST, SceneTag>::new(), &bodies);
        let mut other: Sweep = filled(SortSweep::new(), &turned);
        let mut brute = filled(BruteForce::<MOST, SceneTag>::new(), &turned);
        let mut hash = filled(SpatialHash::<64, MOST, SceneTag>::new(Fx::from_num(16)).unwrap(), &turned);
        for frame in 0..60 {
            step(&mut one);
            step(&mut other);
            step(&mut brute);
            step(&mut hash);
            let state = states(&one);
            prop_assert_eq!(&states(&other), &state, "frame {}", frame);
            prop_assert_eq!(&states(&brute), &state, "frame {}", frame);
            prop_assert_eq!(&states(&hash), &state, "frame {}", frame);
        }
    }

    /// Copied, run on, rolled back and run again: the same bits, including the structure's own.
    /// Also a copy of the copy.
    #[test]
    fn rolled_back_scenes(bodies in crowds(), before in 0usize..40, frames in 1usize..40) {
        let mut scene: Sweep = filled(SortSweep::new(), &bodies);
        (0..before).for_each(|_| step(&mut scene));
        let snapshot = scene;
        let run = |mut scene: Sweep| {
            let log: Vec<_> = (0..frames).map(|_| { step(&mut scene); states(&scene) }).collect();
            (log, format!("{scene:?}"))
        };
        let first = run(scene);
        prop_assert_eq!(format!("{snapshot:?}"), format!("{scene:?}"));
        prop_assert_eq!(&run(snapshot), &first);
        // Half of it, rolled back, and all of it.
        let mut half = snapshot;
        (0..frames / 2).for_each(|_| step(&mut half));
        half = snapshot;
        prop_assert_eq!(&run(half), &first);
    }

    /// A mover's whole state is a body and its velocity: rolled back, it moves the same way.
    #[test]
    fn rolled_back_bodies(x in 40i16..200, y in 20i16..110, v in (-9i16..=9, -9i16..=9), before in 0usize..30, frames in 1usize..30) {
        let ball = Circle::new(Vec2::from_ints(x, y), Fx::from_num(5)).unwrap();
        prop_assume!(!level().overlaps(&ball));
        let frame = |(body, v): (Circle, Vec2)| {
            let moved = Mover::platformer(tilesat::Axis::NEG_Y).move_and_slide(&level(), &body, v + Vec2::from_raw(0, 1 << 14)).unwrap();
            (moved.body, moved.velocity)
        };
        let start = (0..before).fold((ball, Vec2::from_ints(v.0, v.1)), |s, _| frame(s));
        let run = || (0..frames).scan(start, |s, _| { *s = frame(*s); Some(*s) }).collect::<Vec<_>>();
        prop_assert_eq!(run(), run());
    }

    /// A copied and rolled back broad phase finds the same pairs in the same order.
    #[test]
    fn rolled_back_broad_phases(first in boxes(), then in boxes()) {
        let mut near = SortSweep::<MOST, Filter>::new();
        let handles: Vec<_> = first.iter().map(|b| near.insert(&aabb(*b), Filter::default()).unwrap()).collect();
        let snapshot = near;
        let play = |mut near: SortSweep<MOST, Filter>| {
            let mut log = Vec::new();
            for (k, to) in then.iter().enumerate() {
                near.move_to(handles[k % handles.len()], &aabb(*to)).unwrap();
                near.pairs(|pair| log.push(pair));
            }
            (log, format!("{near:?}"))
        };
        prop_assert_eq!(play(near), play(snapshot));
    }
}
