//! All broad phases give the pairs of the definition, each once, frame after frame. In canonical
//! order they are the same bits for every order of insertion (invariant P26, torture scenes 29, 38,
//! 47).
//!
//! `TILESAT_FRAMES` sets the number of random frames (default 4 000, or 12 000 in long runs). From
//! a million on, the test prints its progress.

use heapless::Vec as Room;
use std::collections::HashMap;
use tilesat::broad::{BroadError, BroadHit, Handle, Nearest, Pair, PairCursor};
use tilesat::{Aabb, Fx};
use tilesat_judge::Random;
use tilesat_judge::broad::frames::{Change, Frame, KINDS, Kind, scene};
use tilesat_judge::broad::near::Near;
use tilesat_judge::broad::reference::Rect;
use tilesat_judge::broad::{Cells, Check, Large, Mark, aabb, everywhere, vec2};

fn frames() -> u64 {
    tilesat_judge::frames(tilesat_judge::thorough(4_000, 12_000))
}

fn bounds(rect: &Rect) -> Aabb {
    aabb(rect.lo, rect.hi)
}

struct Play<'a> {
    what: String,
    frames: &'a [Frame],
    seed: u64,
    pairs: u64,
}

impl Check for Play<'_> {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let (mut phase, mut handles, mut random) = (empty.clone(), HashMap::new(), Random::new(self.seed));
        for (number, frame) in self.frames.iter().enumerate() {
            apply(&mut phase, &mut handles, &frame.changes);
            let snapshot = phase.clone();
            let what = || format!("{name}, frame {number} of {}", self.what);
            assert_eq!(in_order(&phase, |phase, each| phase.pairs(each)), frame.pairs, "{}", what());
            self.pairs += frame.pairs.len() as u64;
            match random.below(4) {
                0 => assert_eq!(sorted(&mut phase), frame.pairs, "{}", what()),
                1 => {
                    let all: Vec<_> = handles.values().copied().collect();
                    let found = in_order(&phase, |phase, each| phase.pairs_of(&all, each).unwrap());
                    assert_eq!(found, frame.pairs, "{}", what());
                }
                _ => {}
            }
            resumed(&mut phase, &mut handles, frame, &mut random, &what());
            // An enumeration does not change the structure's answers.
            assert_eq!(in_order(&snapshot, |phase, each| phase.pairs(each)), frame.pairs, "{}", what());
        }
    }
}

fn apply(phase: &mut Near<Mark>, handles: &mut HashMap<u32, Handle>, changes: &[Change]) {
    for change in changes {
        match change {
            Change::Insert(key, rect, mark) => {
                let handle = phase.insert(&bounds(rect), *mark).unwrap();
                handles.insert(*key, handle);
            }
            Change::Move(key, rect) => phase.move_to(handles[key], &bounds(rect)).unwrap(),
            Change::Remove(key) => {
                let handle = handles.remove(key).unwrap();
                assert_eq!(phase.remove(handle).unwrap().key, *key);
            }
        }
    }
}

fn keys(phase: &Near<Mark>, pair: Pair) -> (u32, u32) {
    (phase.tag(pair.a).unwrap().key, phase.tag(pair.b).unwrap().key)
}

/// The keys of the pairs that an enumeration of a copy finds, in order.
fn in_order(phase: &Near<Mark>, ask: impl Fn(&mut Near<Mark>, &mut dyn FnMut(Pair))) -> Vec<(u32, u32)> {
    let mut found = Vec::new();
    ask(&mut phase.clone(), &mut |pair| found.push(keys(phase, pair)));
    found.sort_unstable();
    found
}

fn sorted(phase: &mut Near<Mark>) -> Vec<(u32, u32)> {
    let mut out = Room::<Pair, 5000>::new();
    phase.pairs_sorted(&mut out).unwrap();
    out.iter().map(|pair| keys(phase, *pair)).collect()
}

/// In chunks, while some bodies leave half way. Pairs of the remaining bodies come once. Pairs with
/// the others come at most once, before they leave.
fn resumed(phase: &mut Near<Mark>, handles: &mut HashMap<u32, Handle>, frame: &Frame, random: &mut Random, what: &str) {
    let (mut cursor, mut found, mut chunks) = (PairCursor::new(), Vec::new(), 0);
    let mut leave = frame.leave.clone();
    let (budget, eager) = (random.within(1, 400) as u32, random.within(0, 20));
    loop {
        let mut out = Room::<Pair, 8>::new();
        let told = phase.pairs_from(&mut cursor, budget, &mut out);
        found.extend(out.iter().map(|pair| keys(phase, *pair)));
        if told.is_ok() {
            break;
        }
        chunks += 1;
        assert!(chunks < 100_000, "{what}");
        if chunks > eager {
            if let Some(key) = leave.pop() {
                phase.remove(handles.remove(&key).unwrap()).unwrap();
            }
        }
    }
    found.sort_unstable();
    assert!(found.windows(2).all(|two| two[0] != two[1]), "a pair came twice, {what}");
    assert!(found.iter().all(|pair| frame.pairs.binary_search(pair).is_ok()), "{what}");
    assert!(frame.left.iter().all(|pair| found.binary_search(pair).is_ok()), "{what}");
    for key in leave {
        phase.remove(handles.remove(&key).unwrap()).unwrap();
    }
}

#[test]
fn random_frames() {
    let (total, length) = (frames(), 40);
    let (mut random, mut pairs, mut done) = (Random::new(26), 0, 0);
    for round in 0u64.. {
        let kind = KINDS[(round % KINDS.len() as u64) as usize];
        let log = [21, 20, 8, 2, 16, 23, 1, 24][random.below(8) as usize];
        let origin =
            [(0, 0), (-5 << 20, 3), (-(1 << 29) + 1, 99), (1 << 28, -(1 << 28)), (1, 1)][random.below(5) as usize];
        let cells = Cells { side: 1 << log, origin };
        let seed = random.next();
        let most = if round % 16 < 8 { 24 } else { 90 };
        let frames = scene(kind, cells, most, length, &mut Random::new(seed));
        let mut play = Play { what: format!("{kind:?}, {cells:?}, seed {seed}"), frames: &frames, seed, pairs: 0 };
        if kind == Kind::Large {
            everywhere(90, cells, &mut Large(&mut play));
        } else {
            everywhere(90, cells, &mut play);
        }
        pairs += play.pairs;
        let before = done;
        done += length as u64;
        if total >= 1_000_000 && before * 50 / total != done * 50 / total {
            eprintln!("{done} frames of {total}, {pairs} pairs");
        }
        if done >= total {
            break;
        }
    }
    println!("{done} frames, {pairs} pairs");
    assert!(pairs > 100 * done);
}

/// The answers to all queries, with keys for bodies.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Answers {
    pairs: Vec<(u32, u32)>,
    cut: Vec<(u32, u32)>,
    region: Vec<u32>,
    neighbours: Vec<(u32, Fx)>,
    nearest: Option<(u32, Fx)>,
    ray: Vec<(u32, u32)>,
    cast: Vec<(u32, u32)>,
}

impl Answers {
    fn of(phase: &mut Near<Mark>) -> Self {
        let pairs = sorted(phase);
        let mut out = Room::<Pair, 3>::new();
        let told = phase.pairs_sorted(&mut out).unwrap_err();
        assert_eq!((told.seen as usize, told.kept), (pairs.len(), 3));
        let cut = out.iter().map(|pair| keys(phase, *pair)).collect();
        let key = |handle: Handle| phase.tag(handle).unwrap().key;
        let mut region = Room::<Handle, 9>::new();
        phase.collect_region(&aabb((10, 5), (40, 20)), &mut region).unwrap();
        let (middle, far) = (vec2((21, 9)), Fx::from_bits(1000));
        let mut near = Room::<Nearest, 9>::new();
        phase.neighbours(middle, far, |_, _| true, &mut near).unwrap();
        let nearest = phase.nearest(middle, far, |_, mark| mark.key != 2).unwrap();
        let (mut ray, mut cast) = (Room::<BroadHit, 9>::new(), Room::<BroadHit, 9>::new());
        phase.cast_ray(vec2((-20, 12)), vec2((120, 0)), |_, _| true, &mut ray).unwrap();
        phase.cast_shape(&aabb((90, -20), (96, -16)), vec2((-100, 33)), |_, _| true, &mut cast).unwrap();
        let hits = |hits: &[BroadHit]| hits.iter().map(|hit| (key(hit.handle), hit.toi.raw())).collect();
        Self {
            pairs,
            cut,
            region: region.iter().map(|handle| key(*handle)).collect(),
            neighbours: near.iter().map(|near| (key(near.handle), near.distance)).collect(),
            nearest: nearest.map(|near| (key(near.handle), near.distance)),
            ray: hits(&ray),
            cast: hits(&cast),
        }
    }
}

/// Every order of six bodies, and of five of them after others came and went.
fn orders(n: usize) -> Vec<Vec<usize>> {
    if n == 0 {
        return vec![vec![]];
    }
    let shorter = orders(n - 1);
    shorter.iter().flat_map(|order| (0..n).map(move |at| [&order[..at], &[n - 1], &order[at..]].concat())).collect()
}

/// Torture scene 47: the same scene, every order of insertion of six, with ties of distances and of
/// times.
struct Permutation(Option<Answers>);

impl Check for Permutation {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let boxes =
            [((0, 0), (16, 16)), ((16, 16), (30, 20)), ((12, 10), (20, 30)), ((30, 0), (40, 12)), ((40, 12), (44, 12))];
        let boxes = [boxes.as_slice(), &[((12, 10), (20, 30))]].concat();
        for (number, order) in orders(6).iter().enumerate() {
            let mut phase = empty.clone();
            if number % 2 == 1 {
                // Then the free slots are in another order.
                let crumbs = [0, 1, 2, 3].map(|i| phase.insert(&aabb((i, i), (i, i)), Mark::new(99, 0)).unwrap());
                for i in [2, 0, 3, 1] {
                    phase.remove(crumbs[(i + number / 2) % 4]).unwrap();
                }
            }
            for i in order {
                phase.insert(&aabb(boxes[*i].0, boxes[*i].1), Mark::new(*i as u32, 0)).unwrap();
            }
            let answers = Answers::of(&mut phase);
            let first = self.0.get_or_insert_with(|| answers.clone());
            assert_eq!(&answers, first, "{name}, {order:?}");
        }
    }
}

#[test]
fn scene_47_every_order_of_six() {
    let mut check = Permutation(None);
    for origin in [(0, 0), (-100, -64), (7, 30)] {
        everywhere(6, Cells { side: 32, origin }, &mut check);
    }
    let answers = check.0.unwrap();
    assert_eq!(answers.pairs, [(0, 1), (0, 2), (0, 5), (1, 2), (1, 5), (2, 5), (3, 4)]);
    assert_eq!(answers.cut, [(0, 1), (0, 2), (0, 5)]);
    assert_eq!((answers.region.len(), answers.neighbours.len()), (6, 6));
    assert_eq!(answers.ray.iter().map(|hit| hit.0).collect::<Vec<_>>(), [0, 2, 5, 3, 4]);
}

/// Torture scene 29: as large as a cell, larger by one raw, without size, on the lines of cells and
/// outside the grid.
struct Sizes;

impl Check for Sizes {
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>) {
        let mut phase = empty.clone();
        let mut insert = |lo: (i64, i64), hi: (i64, i64), key| phase.insert(&aabb(lo, hi), Mark::new(key, 0));
        let cell = insert((0, 0), (8, 8), 1).unwrap();
        insert((8, 8), (8, 8), 2).unwrap();
        insert((8, 8), (8, 8), 3).unwrap();
        insert((-8, 0), (0, 0), 4).unwrap();
        insert((-500, -500), (-500, -500), 5).unwrap();
        insert((-508, -508), (-500, -500), 6).unwrap();
        let wide = insert((8, 3), (17, 3), 7);
        let world = insert((-(1 << 29) + 1, 8), ((1 << 29) - 1, 9), 8);
        let mut expected = vec![(1, 2), (1, 3), (1, 4), (2, 3), (5, 6)];
        if let Some(limit) = limit {
            assert_eq!(wide, Err(BroadError::TooLarge { size: 9, limit }), "{name}");
            assert_eq!(world, Err(BroadError::TooLarge { size: (1 << 30) - 2, limit }), "{name}");
            assert_eq!(phase.move_to(cell, &aabb((0, 0), (9, 8))), Err(BroadError::TooLarge { size: 9, limit }));
            assert_eq!(phase.bounds(cell), Ok(aabb((0, 0), (8, 8))));
        } else {
            expected.extend([(1, 7), (1, 8), (2, 8), (3, 8)]);
            expected.sort_unstable();
        }
        assert_eq!(sorted(&mut phase), expected, "{name}");
        let mut here = Room::<Handle, 8>::new();
        phase.collect_region(&aabb((8, 8), (8, 8)), &mut here).unwrap();
        let keys: Vec<_> = here.iter().map(|handle| phase.tag(*handle).unwrap().key).collect();
        assert_eq!(keys, if limit.is_some() { vec![1, 2, 3] } else { vec![1, 2, 3, 8] }, "{name}");
    }
}

#[test]
fn scene_29_sizes() {
    everywhere(8, Cells { side: 8, origin: (0, 0) }, &mut Sizes);
    everywhere(8, Cells { side: 8, origin: (-2, 5) }, &mut Sizes);
}

/// Torture scene 38: four bodies are pushed into a corner and all end at one position. Every order
/// of insertion, every frame.
struct Corner(Vec<Vec<(u32, u32)>>);

impl Check for Corner {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let starts = [(30i64, 9i64), (9, 28), (40, 41), (17, 3)];
        for order in orders(4) {
            let mut phase = empty.clone();
            for i in &order {
                let (x, y) = starts[*i];
                phase.insert(&aabb((x, y), (x + 8, y + 8)), Mark::new(*i as u32, 0)).unwrap();
            }
            for frame in 0..20usize {
                phase
                    .move_each(|_, bounds| {
                        let rect = Rect::of(bounds);
                        let lo = ((rect.lo.0 - 3).max(0), (rect.lo.1 - 3).max(0));
                        aabb(lo, (lo.0 + 8, lo.1 + 8))
                    })
                    .unwrap();
                let pairs = sorted(&mut phase);
                if self.0.len() == frame {
                    self.0.push(pairs.clone());
                }
                assert_eq!(pairs, self.0[frame], "{name}, {order:?}, frame {frame}");
            }
        }
    }
}

#[test]
fn scene_38_four_in_a_corner() {
    let mut check = Corner(Vec::new());
    everywhere(4, Cells { side: 8, origin: (0, 0) }, &mut check);
    assert_eq!(check.0[0], []);
    assert_eq!(check.0[19], [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]);
}

/// A slot has 70 000 tenants. No handle of the last 32 767 is mistaken for the present one, and
/// other bodies keep theirs.
struct Tenants;

impl Check for Tenants {
    fn on(&mut self, name: &str, _: Option<i32>, empty: &Near<Mark>) {
        let (mut phase, unit) = (empty.clone(), aabb((0, 0), (1, 1)));
        let stays = phase.insert(&unit, Mark::new(0, 0)).unwrap();
        let mut handles: Vec<Handle> = Vec::new();
        for tenant in 0..70_000usize {
            let handle = phase.insert(&unit, Mark::new(1, 0)).unwrap();
            let old = |ago: usize| tenant.checked_sub(ago).map(|i| handles[i]);
            for ago in [1, 2, 3, 255, 256, 16_383, 16_384, 32_766, 32_767] {
                assert!(old(ago).is_none_or(|old| old != handle && !phase.contains(old)), "{name}, {ago} ago");
            }
            // The documented limit.
            assert!(old(32_768).is_none_or(|old| old == handle), "{name}");
            let mut pairs = Vec::new();
            phase.pairs(|pair| pairs.push((pair.a, pair.b)));
            assert_eq!(pairs, [(stays, handle)], "{name}");
            assert_eq!(phase.remove(handle), Ok(Mark::new(1, 0)));
            handles.push(handle);
        }
    }
}

#[test]
fn seventy_thousand_tenants() {
    everywhere(2, Cells { side: 8, origin: (0, 0) }, &mut Tenants);
}
