//! Brute force and sort and sweep against a list of boxes: random lives of bodies, enumerations in
//! parts, and the cost of a part.

use heapless::Vec as Room;
use std::collections::BTreeSet;
use tilesat::broad::{BroadError, BroadPhase, BruteForce, Handle, PairCursor, PairsError, SortSweep};
use tilesat::num::DOMAIN;
use tilesat::{Aabb, Filter, Vec2};
use tilesat_judge::Random;
use tilesat_judge::broad::near::Near;

const N: usize = 12;

/// Left, top, right, bottom in raw units.
type Sides = [i64; 4];

fn boxed([left, top, right, bottom]: Sides) -> Aabb {
    Aabb::new(Vec2::from_raw(left as i32, top as i32), Vec2::from_raw(right as i32, bottom as i32)).unwrap()
}

/// A box of up to 4 raw units per side on a lattice of 10. Half of all pairs touch exactly, or miss
/// by one.
fn any(r: &mut Random, origin: [i64; 2]) -> Sides {
    let (x, y) = (origin[0] + r.below(10), origin[1] + r.below(6));
    [x, y, x + r.below(5), y + r.below(5)]
}

/// The present bodies.
#[derive(Clone, Default)]
struct List(Vec<(Handle, Sides)>);

impl List {
    /// Both handles in order, for every two boxes with a common point.
    fn pairs(&self) -> BTreeSet<(Handle, Handle)> {
        let meet = |a: &Sides, b: &Sides| (0..2).all(|i| a[i].max(b[i]) <= a[i + 2].min(b[i + 2]));
        let two = |i: usize| self.0[i + 1..].iter().map(move |b| (self.0[i], *b));
        let all = (0..self.0.len()).flat_map(two).filter(|(a, b)| meet(&a.1, &b.1));
        all.map(|(a, b)| if a.0.slot() < b.0.slot() { (a.0, b.0) } else { (b.0, a.0) }).collect()
    }
}

/// All pairs of one enumeration; none comes twice.
fn pairs(near: &mut Near<()>) -> BTreeSet<(Handle, Handle)> {
    let mut found = BTreeSet::new();
    near.pairs(|pair| assert!(found.insert((pair.a, pair.b)), "{pair:?} came twice"));
    found
}

/// A change: a body comes, leaves or moves, or all move.
fn event(r: &mut Random, near: &mut Near<()>, list: &mut List, origin: [i64; 2]) {
    let some = r.below(list.0.len().max(1) as i64) as usize;
    match r.below(8) {
        0..3 => {
            let sides = any(r, origin);
            match near.insert(&boxed(sides), ()) {
                Ok(handle) => list.0.push((handle, sides)),
                Err(error) => assert!(error == BroadError::Full { capacity: N as u16 } && list.0.len() == N),
            }
        }
        3 | 4 if !list.0.is_empty() => remove(near, list, some),
        5 if !list.0.is_empty() => {
            list.0[some].1 = any(r, origin);
            near.move_to(list.0[some].0, &boxed(list.0[some].1)).unwrap();
        }
        6 => {
            for (_, sides) in &mut list.0 {
                let by = if sides[0] > origin[0] && r.one_in(2) { -1 } else { 1 };
                (sides[0], sides[2]) = (sides[0] + by, sides[2] + by);
            }
            let of = |handle| list.0.iter().find(|(h, _)| *h == handle).unwrap().1;
            near.move_each(|handle, old| {
                assert_eq!(old.min().y.to_bits(), of(handle)[1] as i32);
                boxed(of(handle))
            })
            .unwrap();
        }
        _ => {}
    }
    assert_eq!(near.len(), list.0.len());
}

fn remove(near: &mut Near<()>, list: &mut List, some: usize) {
    let (handle, _) = list.0.swap_remove(some);
    near.remove(handle).unwrap();
    assert_eq!(near.remove(handle), Err(BroadError::Stale(handle)));
}

const ORIGINS: [[i64; 2]; 3] =
    [[-5, -3], [DOMAIN as i64 - 400, 7 - DOMAIN as i64], [1 - DOMAIN as i64, DOMAIN as i64 - 40]];

/// Slots are freed, reused and moved in every order. Between two enumerations there are many
/// changes, or none.
fn any_life(new: fn() -> Near<()>) {
    let mut r = Random::new(3);
    let (mut asked, mut found) = (0, 0);
    for life in 0..400 {
        let (mut near, mut list) = (new(), List::default());
        let origin = ORIGINS[life % 3];
        let often = r.within(1, 12);
        for _ in 0..200 {
            event(&mut r, &mut near, &mut list, origin);
            if r.one_in(often) {
                let expected = list.pairs();
                assert_eq!(pairs(&mut near), expected);
                (asked, found) = (asked + 1, found + expected.len());
            }
        }
    }
    assert!(asked > 10_000 && found > 100_000, "{asked} {found}");
}

#[test]
fn any_life_of_bodies() {
    any_life(|| Near::new(BruteForce::<N>::new()));
    any_life(|| Near::new(SortSweep::<N>::new()));
}

/// An enumeration in parts of a few tests and a few pairs, while bodies are removed and others
/// enumerate.
fn in_parts(new: fn() -> Near<()>) {
    let mut r = Random::new(5);
    let mut cut = 0;
    for round in 0..6_000 {
        let (mut near, mut list) = (new(), List::default());
        for _ in 0..60 {
            event(&mut r, &mut near, &mut list, ORIGINS[round % 3]);
            // The order of an earlier frame, with gaps.
            if r.one_in(20) {
                pairs(&mut near);
            }
        }
        let before = list.pairs();
        let mut cursor = PairCursor::new();
        let mut found = BTreeSet::new();
        loop {
            let mut out = Room::<_, 3>::new();
            let done = near.pairs_from(&mut cursor, r.below(7) as u32, &mut out);
            for pair in &out {
                let handles = (pair.a, pair.b);
                assert!(near.contains(pair.a) && near.contains(pair.b), "gone");
                assert!(before.contains(&handles) && found.insert(handles), "{handles:?}");
            }
            match done {
                Ok(()) => break,
                Err(error) => assert!(error != PairsError::Changed && (error != PairsError::Full || out.is_full())),
            }
            cut += 1;
            if !list.0.is_empty() && r.one_in(4) {
                let some = r.below(list.0.len() as i64) as usize;
                remove(&mut near, &mut list, some);
            }
            if r.one_in(4) {
                assert_eq!(pairs(&mut near), list.pairs());
            }
        }
        let missed: Vec<_> = list.pairs().difference(&found).copied().collect();
        assert!(missed.is_empty(), "{missed:?}");
        assert_eq!(cursor, PairCursor::new());
    }
    assert!(cut > 20_000, "{cut}");
}

#[test]
fn enumerations_in_parts() {
    in_parts(|| Near::new(BruteForce::<N>::new()));
    in_parts(|| Near::new(SortSweep::<N>::new()));
}

/// Each running enumeration reports it once. Then it begins again and finds all.
fn changes(new: fn() -> Near<()>) {
    let changes: [fn(&mut Near<()>, Handle); 3] = [
        |near, body| near.move_to(body, &boxed([0, 0, 9, 9])).unwrap(),
        |near, _| near.move_each(|_, bounds| *bounds).unwrap(),
        |near, _| assert!(near.insert(&boxed([3, 3, 4, 4]), ()).is_ok()),
    ];
    for change in changes {
        let mut near = new();
        let bodies: Vec<_> = (0..6).map(|_| near.insert(&boxed([0, 0, 9, 9]), ()).unwrap()).collect();
        let mut cursors = [PairCursor::new(); 3];
        for (part, cursor) in cursors.iter_mut().enumerate() {
            let mut out = Room::<_, 64>::new();
            assert_eq!(near.pairs_from(cursor, 1 + part as u32, &mut out), Err(PairsError::BudgetExceeded));
            assert_eq!(out.len(), 1 + part);
        }
        // Between two finished enumerations, changes do not matter.
        pairs(&mut near);
        change(&mut near, bodies[2]);
        for cursor in &mut cursors {
            let mut out = Room::<_, 64>::new();
            assert_eq!(near.pairs_from(cursor, 100, &mut out), Err(PairsError::Changed));
            assert_eq!((*cursor, out.len()), (PairCursor::new(), 0));
            near.pairs_from(cursor, 100, &mut out).unwrap();
            assert_eq!(out.len(), near.len() * (near.len() - 1) / 2);
        }
    }
}

#[test]
fn changes_are_told() {
    changes(|| Near::new(BruteForce::<N>::new()));
    changes(|| Near::new(SortSweep::<N>::new()));
}

/// The tests that an enumeration takes.
fn tests(near: &mut Near<()>) -> usize {
    let mut cursor = PairCursor::new();
    (1..9_999).find(|_| near.pairs_from(&mut cursor, 1, &mut Room::<_, 1>::new()).is_ok()).unwrap()
}

/// N - 1 if nothing touches in x, and N (N - 1) / 2 if all do, whatever the order of insertion.
#[test]
fn tests_are_counted() {
    let of = |mut near: Near<()>, sides: fn(i64) -> Sides| {
        for i in 0..64 {
            near.insert(&boxed(sides((i * 37) % 64)), ()).unwrap();
        }
        tests(&mut near)
    };
    assert_eq!(of(Near::new(SortSweep::<300>::new()), |i| [4 * i, 0, 4 * i + 3, 9]), 63);
    assert_eq!(of(Near::new(SortSweep::<300>::new()), |i| [4 * i, 0, 4 * i + 4, 9]), 63 + 62);
    assert_eq!(of(Near::new(SortSweep::<300>::new()), |i| [0, 2 * i, 9, 2 * i + 1]), 64 * 63 / 2);
}

/// Bodies at random positions: beyond 8 N shifts another sorting method takes over.
#[test]
fn teleports() {
    let mut r = Random::new(11);
    let mut near = Near::new(SortSweep::<300>::new());
    let mut list = List::default();
    for _ in 0..300 {
        let at = [r.below(2_000), r.below(900)];
        let sides = [at[0], at[1], at[0] + r.below(40), at[1] + r.below(40)];
        list.0.push((near.insert(&boxed(sides), ()).unwrap(), sides));
    }
    for round in 0..200 {
        for (i, (handle, sides)) in list.0.iter_mut().enumerate() {
            let [x, y] = match round % 4 {
                0 => [r.below(2_000), r.below(900)],
                1 => [2_000 - sides[0], sides[1]],
                2 => [7 * (i as i64 % 3), sides[1]],
                _ => [sides[0] + r.around(3), sides[1]],
            };
            *sides = [x, y, x + sides[2] - sides[0], y + sides[3] - sides[1]];
            near.move_to(*handle, &boxed(*sides)).unwrap();
        }
        assert_eq!(pairs(&mut near), list.pairs());
    }
}

static IN_FLASH_OR_RAM: SortSweep<256, Filter> = SortSweep::new();

/// The manual's claims.
#[test]
fn sizes() {
    let bodies = |n: usize, tag: usize| n * (16 + tag + 2) + 12;
    assert_eq!(size_of::<BruteForce<256>>(), bodies(256, 0));
    assert_eq!(size_of::<BruteForce<256, Filter>>(), bodies(256, 8));
    assert_eq!(size_of::<SortSweep<256>>(), bodies(256, 0) + 2 * 256 + 8);
    assert_eq!(size_of_val(&IN_FLASH_OR_RAM), bodies(256, 8) + 2 * 256 + 8);
    assert!(IN_FLASH_OR_RAM.is_empty());
}

/// A snapshot is a copy: it continues as the original did.
#[test]
fn snapshots() {
    let mut r = Random::new(13);
    let (mut near, mut list) = (Near::new(SortSweep::<N>::new()), List::default());
    for _ in 0..2_000 {
        event(&mut r, &mut near, &mut list, ORIGINS[0]);
        let (mut later, mut events, mut there) = (near.clone(), r, list.clone());
        for _ in 0..4 {
            event(&mut events, &mut later, &mut there, ORIGINS[0]);
        }
        assert_eq!(pairs(&mut later), there.pairs());
        if r.one_in(3) {
            assert_eq!(pairs(&mut near), list.pairs());
        }
    }
}
