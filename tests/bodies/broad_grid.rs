//! Loose grids and spatial hashes, compared with a test of every pair of boxes.

use std::collections::BTreeSet;
use tilesat::broad::{
    Border, BroadError, BruteForce, GridError, LooseGrid, Pair, PairCursor, PairsError, SortSweep, SpatialHash,
};
use tilesat::heapless::Vec as Fixed;
use tilesat::{Fx, Vec2};
use tilesat_judge::Random;
use tilesat_judge::broad_twin::{END, Twin, aabb, beside, region, small};

/// The raw side of cells in these tests.
const CELL: i32 = 8;

fn grid<const BLOCKS: usize, const N: usize, const LARGE: bool>(
    (x, y): (i32, i32),
    columns: u16,
) -> LooseGrid<BLOCKS, N, (), LARGE> {
    LooseGrid::new(Vec2::from_raw(x, y), Fx::from_bits(CELL), columns).unwrap()
}

fn hash<const BUCKETS: usize, const N: usize, const LARGE: bool>() -> SpatialHash<BUCKETS, N, (), LARGE> {
    SpatialHash::new(Fx::from_bits(CELL)).unwrap()
}

/// Runs a check on structures of all forms: rows shorter than a block, of a block, and longer; with
/// large bodies and without.
macro_rules! on_all {
    ($check:expr) => {
        $check(&Twin::new(grid::<1, 48, false>((0, 0), 4)));
        $check(&Twin::new(grid::<1, 48, true>((-16, -16), 8)));
        $check(&Twin::new(grid::<3, 48, false>((-37, -5), 32)));
        $check(&Twin::new(grid::<4, 48, false>((-511, -13), 128)));
        $check(&Twin::new(grid::<2, 48, true>((-512, 3), 64)));
        $check(&Twin::new(grid::<3, 48, false>((END - 100, 1 - END), 16)));
        $check(&Twin::new(hash::<64, 48, false>()));
        $check(&Twin::new(hash::<64, 48, true>()));
        $check(&Twin::new(hash::<1024, 48, false>()));
    };
}

/// Two boxes in every relation to each other, to lines of cells and to the border on one axis. On
/// the other axis they touch, or just do not.
#[test]
fn two_boxes_in_all_relations_on_a_line() {
    fn check(twin: &Twin) {
        let mut twin = twin.clone();
        let line: Vec<_> = (-CELL - 2..4 * CELL + 10)
            .flat_map(|v| [0, 1, CELL / 2, CELL - 1, CELL].map(|size| (v, v + size)))
            .collect();
        let (a, b) = ((CELL - 3, CELL + 1), [(CELL + 1, CELL + 9), (CELL + 2, 2 * CELL), (-3, CELL - 3), (CELL, CELL)]);
        twin.insert([0; 4]).unwrap();
        twin.insert([0; 4]).unwrap();
        for (i, &(x0, x1)) in line.iter().enumerate() {
            for (k, &(u0, u1)) in line.iter().enumerate() {
                let b = b[(i + k) & 3];
                twin.set(0, [x0, a.0, x1, a.1]);
                twin.set(1, [u0, b.0, u1, b.1]);
                twin.check_pairs();
                twin.set(0, [a.0, x0, a.1, x1]);
                twin.set(1, [b.0, u0, b.1, u1]);
                twin.check_pairs();
            }
        }
    }
    on_all!(check);
}

/// The position of a crowd, and how many cells it covers to each side.
const PLACES: [((i32, i32), i64); 6] =
    [((0, 0), 3), ((0, 0), 40), ((0, 0), 0), ((END, -END), 3), ((-END, END), 5), ((END - 60, 60 - END), 9)];

#[test]
fn crowds_that_come_move_and_go() {
    fn check(fresh: &Twin) {
        for (seed, &(place, cells)) in PLACES.iter().enumerate() {
            let (mut r, mut twin) = (Random::new(seed as u64), fresh.clone());
            for _ in 0..tilesat_judge::thorough(400, 1500) {
                let corners = small(&mut r, i64::from(CELL), cells, place);
                match (r.below(8), twin.bodies.len()) {
                    (0, 1..) => drop(twin.remove(r.below(twin.bodies.len() as i64) as usize)),
                    (1 | 2, ..48) => drop(twin.insert(corners).unwrap()),
                    (3.., n @ 1..) => twin.set(r.below(n as i64) as usize, corners),
                    _ => {}
                }
                twin.check_pairs();
                twin.check_region(region(&mut r, i64::from(CELL), cells, place));
                twin.check_region(small(&mut r, i64::from(CELL), cells, place));
                let at = (beside(&mut r, i64::from(CELL), cells), beside(&mut r, i64::from(CELL), cells));
                twin.check_point(place.0.saturating_add(at.0), place.1.saturating_add(at.1));
            }
            twin.check_region([-END, -END, END, END]);
            for (x, y) in [(i32::MIN, 0), (i32::MAX, i32::MIN), (END + 1, 0), (0, -END - 1)] {
                twin.check_point(x, y);
            }
        }
    }
    on_all!(check);
}

#[test]
fn large_bodies_are_taken_where_there_is_a_list_for_them() {
    fn check(fresh: &Twin) {
        for (seed, &(place, cells)) in PLACES.iter().enumerate() {
            let (mut r, mut twin) = (Random::new(seed as u64), fresh.clone());
            for _ in 0..600 {
                let corners = if r.one_in(4) {
                    region(&mut r, i64::from(CELL), cells, place)
                } else {
                    small(&mut r, i64::from(CELL), cells, place)
                };
                match (r.below(6), twin.bodies.len()) {
                    (0, 1..) => drop(twin.remove(r.below(twin.bodies.len() as i64) as usize)),
                    (1 | 2, ..48) => drop(twin.insert(corners).unwrap()),
                    (3.., n @ 1..) => twin.set(r.below(n as i64) as usize, corners),
                    _ => {}
                }
                twin.check_pairs();
                twin.check_region(region(&mut r, i64::from(CELL), cells, place));
            }
            resumed(&twin);
        }
    }
    check(&Twin::new(grid::<1, 48, true>((-16, -16), 8)));
    check(&Twin::new(hash::<64, 48, true>()));
}

/// Enumerates with a budget and limited room, while bodies are removed as `lose` says. Returns all
/// pairs.
fn enumerate<const ROOM: usize>(twin: &mut Twin, budget: u32, mut lose: impl FnMut(&mut Twin)) -> Vec<Pair> {
    let (mut cursor, mut all) = (PairCursor::new(), Vec::new());
    for _ in 0..200_000 {
        let mut out = Fixed::<Pair, ROOM>::new();
        let done = twin.near.pairs_from(&mut cursor, budget, &mut out);
        for pair in &out {
            assert!(twin.near.contains(pair.a) && twin.near.contains(pair.b), "{pair:?} of a body that is gone");
        }
        all.extend_from_slice(&out);
        match done {
            Ok(()) => return all,
            Err(PairsError::BudgetExceeded) => {}
            Err(PairsError::Full) => assert!(out.is_full()),
            Err(PairsError::Changed) => panic!("nothing moved"),
        }
        lose(twin);
    }
    panic!("no end");
}

fn resumed(twin: &Twin) {
    let expected: Vec<Pair> = twin.pairs().into_iter().collect();
    for budget in (1..40).chain([100, 1000, u32::MAX]) {
        let mut twin = twin.clone();
        for mut all in [enumerate::<64>(&mut twin, budget, |_| ()), enumerate::<1>(&mut twin, budget, |_| ())] {
            all.sort_unstable();
            assert_eq!(all, expected, "budget {budget}");
        }
    }
}

fn crowd(mut twin: Twin, bodies: usize, cells: i64, seed: u64) -> Twin {
    let mut r = Random::new(seed);
    while twin.bodies.len() < bodies {
        // Some are outside a grid that refuses them.
        let _ = twin.insert(small(&mut r, i64::from(CELL), cells, (0, 0)));
    }
    // Slots in use and free ones, and lists in another order than slots.
    for _ in 0..bodies / 6 {
        twin.remove(r.below(twin.bodies.len() as i64) as usize);
    }
    for i in (0..twin.bodies.len()).rev() {
        let (body, corners) = twin.bodies[i];
        let new = small(&mut r, i64::from(CELL), cells, (0, 0));
        let moved = twin.near.move_to(body, &aabb(new));
        twin.bodies[i].1 = if moved.is_ok() { new } else { corners };
    }
    twin
}

#[test]
fn enumerations_go_on_with_any_budget() {
    fn check(fresh: &Twin) {
        for cells in [0, 1, 3] {
            let twin = crowd(fresh.clone(), 40, cells, 5);
            resumed(&twin);
            let mut near = twin.near.clone();
            let mut out = Fixed::<Pair, 4>::new();
            let mut cursor = PairCursor::new();
            for _ in 0..3 {
                assert_eq!(near.pairs_from(&mut cursor, 0, &mut out), Err(PairsError::BudgetExceeded));
                assert!(out.is_empty());
            }
            let mut none = Fixed::<Pair, 0>::new();
            assert_eq!(near.pairs_from(&mut cursor, u32::MAX, &mut none), Err(PairsError::Full));
            let (body, corners) = twin.bodies[3];
            near.move_to(body, &aabb(corners)).unwrap();
            assert_eq!(near.pairs_from(&mut cursor, u32::MAX, &mut out), Err(PairsError::Changed));
            assert_ne!(near.pairs_from(&mut cursor, u32::MAX, &mut out), Err(PairsError::Changed));
        }
    }
    on_all!(check);
}

/// Bodies are removed between any two tests. A body that stays is in all its pairs once. A body
/// that is gone is in no later pair.
#[test]
fn bodies_may_go_during_an_enumeration() {
    fn check(fresh: &Twin) {
        for seed in 0..60 {
            let mut r = Random::new(seed);
            let mut twin = crowd(fresh.clone(), 36, r.below(3), seed);
            let (before, budget, often) = (twin.pairs(), r.within(1, 12) as u32, r.within(1, 6));
            let all = enumerate::<2>(&mut twin, budget, |twin| {
                let n = twin.bodies.len() as i64;
                if n > 4 && r.one_in(often) {
                    twin.remove(r.below(n) as usize);
                }
            });
            let found: BTreeSet<Pair> = all.iter().copied().collect();
            assert_eq!(found.len(), all.len(), "a pair came twice");
            assert!(found.is_subset(&before) && found.is_superset(&twin.pairs()), "seed {seed}");
        }
    }
    on_all!(check);
}

#[test]
fn what_is_refused_changes_nothing() {
    let refuse = grid::<1, 8, false>((0, 0), 8).with_border(Border::Refuse);
    let mut twin = Twin::new(refuse);
    // Centres on the first line are inside, those on the last line outside.
    for (x, ok) in [(-4, true), (-5, false), (59, true), (60, false), (END - 8, false), (-END, false)] {
        let corners = [x, 0, x + 8, 8];
        let inserted = twin.near.clone().insert(&aabb(corners), ());
        assert_eq!(inserted.is_ok(), ok, "{x}");
        if !ok {
            assert_eq!(inserted, Err(BroadError::OutOfWorld { x: x + 4, y: 4 }));
        }
    }
    twin.insert([0, 0, 8, 8]).unwrap();
    twin.insert([8, 8, 16, 16]).unwrap();
    let (body, _) = twin.bodies[0];
    let moved = twin.near.move_to(body, &aabb([-4, -6, 4, 2]));
    assert_eq!(moved, Err(BroadError::OutOfWorld { x: 0, y: -2 }));
    assert_eq!(twin.near.move_to(body, &aabb([0, 0, 9, 2])), Err(BroadError::TooLarge { size: 9, limit: 8 }));
    assert_eq!(twin.near.move_to(body, &aabb([0, 0, 2, 9])), Err(BroadError::TooLarge { size: 9, limit: 8 }));
    for side in 0..6 {
        twin.insert([side, 0, side, 0]).unwrap();
    }
    assert_eq!(twin.insert([0; 4]), Err(BroadError::Full { capacity: 8 }));
    twin.check_pairs();
    twin.check_region([0, 0, 0, 0]);

    // A large body shrinks, and would be in a cell with the number of none.
    let mut twin = Twin::new(grid::<1, 8, true>((0, 0), 8).with_border(Border::Refuse));
    let body = twin.insert([0, 0, 30, 9]).unwrap();
    let (x, y) = (7 * CELL, (0xffff >> 3) * CELL);
    let moved = twin.near.move_each(|_, _| aabb([x, y, x + 2, y + 2]));
    assert_eq!(moved, Err((body, BroadError::OutOfWorld { x: x + 1, y: y + 1 })));
    twin.check_region([0, 0, 0, 0]);

    let mut twin = Twin::new(hash::<64, 8, false>());
    assert_eq!(twin.insert([0, 0, 9, 2]), Err(BroadError::TooLarge { size: 9, limit: 8 }));
    let gone = twin.insert([0, 0, 8, 8]).unwrap();
    twin.remove(0);
    assert_eq!(twin.near.move_to(gone, &aabb([0; 4])), Err(BroadError::Stale(gone)));
    assert!(twin.near.is_empty());
}

/// Moves all bodies in one call, of which some are refused. The others move, and the call reports
/// the first refusal.
#[test]
fn frames_move_all_bodies() {
    fn check(fresh: &Twin) {
        for (seed, &(place, cells)) in PLACES.iter().enumerate() {
            let mut r = Random::new(seed as u64);
            let mut twin = crowd(fresh.clone(), 44, cells, seed as u64);
            for round in 0..60 {
                let near = twin.near.clone();
                let mut expected = Vec::new();
                for (body, corners) in &mut twin.bodies {
                    let [x0, y0, x1, y1] = *corners;
                    // A step, a teleport, or too large.
                    let new = match r.below(if round % 2 == 0 { 12 } else { 13 }) {
                        0 | 1 => small(&mut r, i64::from(CELL), cells, place),
                        12 => [x0, y0, x0.min(END - CELL - 1) + CELL + 1, y1.max(y0)],
                        _ => {
                            let (x, y) = (r.around(2) as i32, r.around(2) as i32);
                            let by = |v: i32, by: i32| (v + by).clamp(-END, END);
                            [by(x0, x), by(y0, y), by(x1, x), by(y1, y)]
                        }
                    };
                    let refused = near.clone().move_to(*body, &aabb(new)).err();
                    expected.push((*body, new, refused));
                    if refused.is_none() {
                        *corners = new;
                    }
                }
                let moved = twin.near.move_each(|body, bounds| {
                    let (_, new, _) = expected.iter().find(|e| e.0 == body).unwrap();
                    assert_eq!(near.bounds(body), Ok(*bounds));
                    aabb(*new)
                });
                let first = expected.iter().filter_map(|e| e.2.map(|error| (e.0, error))).min_by_key(|e| e.0.slot());
                assert_eq!(moved.err(), first);
                twin.check_pairs();
                twin.check_region(region(&mut r, i64::from(CELL), cells, place));
                for (body, corners) in &twin.bodies {
                    assert_eq!(twin.near.bounds(*body), Ok(aabb(*corners)));
                }
            }
        }
    }
    on_all!(check);
    check(&Twin::new(grid::<3, 48, false>((-20, -16), 8).with_border(Border::Refuse)));
    check(&Twin::new(grid::<2, 48, true>((-20, -16), 8).with_border(Border::Refuse)));
}

#[test]
fn constructors_refuse_what_has_no_cells() {
    type Three = LooseGrid<3, 4>;
    let new = |side: i32, columns| Three::new(Vec2::ZERO, Fx::from_bits(side), columns).err();
    for side in [i32::MIN, -8, 0, 1, 3, 24, (1 << 28) + 1, 1 << 29, 1 << 30, i32::MAX] {
        assert_eq!(new(side, 32), Some(GridError::Cell { side }));
        assert_eq!(SpatialHash::<64, 4>::new(Fx::from_bits(side)).err(), Some(GridError::Cell { side }));
    }
    for columns in [0, 1, 2, 3, 5, 24, 64, 96, 128, 1 << 15, u16::MAX] {
        assert_eq!(new(8, columns), Some(GridError::Columns { columns, cells: 96 }));
    }
    for side in [2, 8, 1 << 21, 1 << 28] {
        for columns in [4, 8, 16, 32] {
            assert_eq!(new(side, columns), None);
        }
    }
    let outside = Vec2::from_raw(0, END + 1);
    assert!(matches!(Three::new(outside, Fx::ONE, 8), Err(GridError::Origin(_))));
}

#[test]
fn refusals_say_what_would_do() {
    let cell = |side| GridError::Cell { side }.to_string();
    assert_eq!(cell(24 << 16), "a cell of 24 is not a power of two: use 16 or 32");
    assert_eq!(cell(3), "a cell of 0.00005 is not a power of two: use 0.00003 or 0.00006");
    for side in [i32::MIN, -8, 0, 1, (1 << 28) + 1, 1 << 30, i32::MAX] {
        let end = if side < 2 { "use 0.00003 or 0.00006" } else { "use 2048 or 4096" };
        assert!(cell(side).ends_with(end), "{}", cell(side));
    }
    let columns = |columns, cells| GridError::Columns { columns, cells }.to_string();
    assert_eq!(columns(24, 96), "24 columns do not fit 3 blocks: use a power of two from 4 to 32");
    assert_eq!(columns(2, 128), "2 columns do not fit 4 blocks: use a power of two from 4 to 128");
    assert_eq!(
        columns(64, 96),
        "64 columns do not fit 3 blocks: use a power of two from 4 to 32, or a multiple of 2 blocks"
    );
    assert_eq!(
        columns(1 << 15, 96),
        "32768 columns do not fit 3 blocks: use a power of two from 4 to 32, or a multiple of 1024 blocks"
    );
    // Fields are public: no message panics.
    assert!(!columns(u16::MAX, 0).is_empty() && !columns(0, u16::MAX).is_empty());
}

/// The fewest blocks with which a valid number of columns covers the world.
#[test]
fn blocks_for_a_world() {
    for cell in 1..=5u32 {
        for (width, height) in (0..700).flat_map(|width| [0, 1, 2, 7, 8, 9, 100].map(|height| (width, height))) {
            let columns = (2..16).map(|log| 1u32 << log).find(|columns| columns * cell >= width).unwrap();
            let rows = (0..=height).find(|rows| rows * cell >= height).unwrap();
            let blocks = (0..=columns * rows).find(|blocks| 32 * blocks >= columns * rows).unwrap();
            assert_eq!(32 * blocks % columns, 0, "a constructor takes them");
            assert_eq!(LooseGrid::blocks_for(width, height, cell), blocks as usize, "{width} x {height}, {cell}");
        }
    }
    assert_eq!(LooseGrid::blocks_for(2048 << 16, 1024 << 16, 32 << 16), 64);
    let ends = [0, 1, 1 << 16, (1 << 16) + 1, 1 << 31, u32::MAX];
    for (width, height) in ends.into_iter().flat_map(|width| ends.map(|height| (width, height))) {
        assert_eq!(LooseGrid::blocks_for(width, height, 0), 0);
        let (blocks, all) = (LooseGrid::blocks_for(width, height, 1), u64::from(width) * u64::from(height));
        assert!(blocks > 2047 || blocks as u64 * 32 >= all, "{width} x {height}");
    }
}

/// The documented memory: beside box, tag and the generation's 2 bytes.
#[test]
fn bytes_a_body_and_a_cell() {
    fn of<B>(_: &B) -> usize {
        size_of::<B>()
    }
    let body = 16 + 2;
    let grids = [of(&grid::<2, 64, false>((0, 0), 8)), of(&grid::<2, 128, false>((0, 0), 8))];
    assert_eq!(grids[1] - grids[0], 64 * (body + 6));
    assert_eq!(of(&grid::<3, 64, false>((0, 0), 8)) - grids[0], 68);
    let hashes = [of(&hash::<64, 64, false>()), of(&hash::<64, 128, false>())];
    assert_eq!(hashes[1] - hashes[0], 64 * (body + 6));
    assert_eq!(of(&hash::<128, 64, false>()) - hashes[0], 64 * 2);
    assert_eq!(size_of::<SortSweep<128>>() - size_of::<SortSweep<64>>(), 64 * (body + 2));
    assert_eq!(size_of::<BruteForce<128>>() - size_of::<BruteForce<64>>(), 64 * body);
}

/// The largest cells and the whole domain.
#[test]
fn cells_of_all_sizes() {
    fn check(mut twin: Twin, cell: i64) {
        let mut r = Random::new(3);
        for round in 0..300 {
            let corners = small(&mut r, cell, ((1 << 29) / cell).min(1 << 20), (0, 0));
            match twin.bodies.len() {
                ..48 => drop(twin.insert(corners).unwrap()),
                n => twin.set(round % n, corners),
            }
            twin.check_pairs();
            twin.check_region(corners);
            let [x0, y0, ..] = corners;
            twin.check_region([x0.min(0), y0.min(0), x0.max(0), y0.max(0)]);
        }
    }
    for log in [1, 2, 7, 16, 21, 27, 28] {
        let cell = Fx::from_bits(1 << log);
        for corner in [-END, 0, END] {
            check(Twin::new(LooseGrid::<3, 48>::new(Vec2::from_raw(corner, -corner), cell, 8).unwrap()), 1 << log);
        }
        check(Twin::new(SpatialHash::<64, 48>::new(cell).unwrap()), 1 << log);
    }
}
