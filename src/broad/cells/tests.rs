//! Paths and neighbourhoods in cells against definitions in wide integers.

#![allow(clippy::indexing_slicing, clippy::unwrap_used, reason = "a test may panic")]

use crate::broad::{BroadPhase, BruteForce, LooseGrid, SpatialHash};
use crate::num::{Fx, Raw, Toi, Vec2};
use crate::shape::Aabb;

const CELL: i32 = 8;
const BODIES: usize = 200;

type Fractions = (i128, i128);

/// `SplitMix64`.
struct Random(u64);

impl Random {
    fn within(&mut self, low: i32, high: i32) -> i32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let z = z ^ (z >> 31);
        low + (z % (i64::from(high) - i64::from(low) + 1) as u64) as i32
    }

    fn corners(&mut self, span: i32, size: i32) -> Aabb {
        let (x, y) = (self.within(-span, span), self.within(-span, span));
        let (w, h) = (self.within(0, size), self.within(0, size));
        Aabb::from_raw_unchecked(Raw { x, y }, Raw { x: x + w, y: y + h })
    }
}

/// When a moving box first touches another one, in parts of 2^30 rounded down; closed at both ends.
fn touched(start: &Aabb, motion: Raw, body: &Aabb) -> Option<u32> {
    // The latest entry and the earliest exit, as fractions with a positive denominator.
    let (mut enter, mut leave): (Fractions, Fractions) = ((0, 1), (1, 1));
    let axes = [
        (start.lo().x, start.hi().x, motion.x, body.lo().x, body.hi().x),
        (start.lo().y, start.hi().y, motion.y, body.lo().y, body.hi().y),
    ];
    for (lo, hi, m, from, to) in axes.map(|(a, b, c, d, e)| (a as i128, b as i128, c as i128, d as i128, e as i128)) {
        if m == 0 {
            if lo > to || from > hi {
                return None;
            }
            continue;
        }
        let (near, far) = if m > 0 { (from - hi, to - lo) } else { (lo - to, hi - from) };
        let size = m.abs();
        if near * enter.1 > enter.0 * size {
            enter = (near, size);
        }
        if far * leave.1 < leave.0 * size {
            leave = (far, size);
        }
    }
    (enter.0 * leave.1 <= leave.0 * enter.1).then(|| ((enter.0 << 30) / enter.1) as u32)
}

/// The distance along the longer axis from a point to a box.
fn distance(point: Raw, body: &Aabb) -> i32 {
    let axis = |p: i32, lo: i32, hi: i32| (lo - p).max(p - hi).max(0);
    axis(point.x, body.lo().x, body.hi().x).max(axis(point.y, body.lo().y, body.hi().y))
}

fn is_body(bounds: &Aabb) -> bool {
    bounds.lo().x <= bounds.hi().x
}

fn path<B: BroadPhase<Tag = ()>>(near: &B, start: &Aabb, motion: Raw) {
    let bounds = near.table().bounds;
    // The whole way, then up to the first touched body.
    for stop in [false, true] {
        let (mut came, mut until) = ([false; BODIES], Toi::ONE);
        near.visit_path(start, motion, |slot| {
            assert!(!core::mem::replace(&mut came[slot], true), "a body came twice");
            assert!(is_body(&bounds[slot]), "a free slot came");
            if let Some(toi) = touched(start, motion, &bounds[slot]).filter(|_| stop) {
                until = until.min(Toi::from_raw(toi).unwrap());
            }
            until
        });
        for (body, came) in bounds.iter().zip(came).filter(|(body, _)| is_body(body)) {
            let due = touched(start, motion, body).is_some_and(|toi| toi <= until.raw());
            assert!(came || !due, "{start:?} by {motion:?} misses {body:?}");
        }
    }
}

fn around<B: BroadPhase<Tag = ()>>(near: &B, point: Raw, reach: i32) {
    let bounds = near.table().bounds;
    for stop in [false, true] {
        let (mut came, mut reach) = ([false; BODIES], reach);
        near.visit_near(point, reach, |slot| {
            assert!(!core::mem::replace(&mut came[slot], true), "a body came twice");
            assert!(is_body(&bounds[slot]), "a free slot came");
            if stop {
                reach = reach.min(distance(point, &bounds[slot]));
            }
            reach
        });
        for (body, came) in bounds.iter().zip(came).filter(|(body, _)| is_body(body)) {
            assert!(came || distance(point, body) > reach, "{point:?} within {reach} misses {body:?}");
        }
    }
}

fn check<B: BroadPhase<Tag = ()>>(mut near: B, large: i32, seed: u64) {
    let mut r = Random(seed);
    for round in 0..tilesat_judge::thorough(15, 60) {
        // A crowd about as large as the grid, with some bodies gone.
        let span = [6, 40, 400][round % 3];
        for i in 0..BODIES {
            let size = if i % 10 == 0 { large } else { CELL };
            let bounds = r.corners(span, size);
            match near.table().handle(i) {
                body if body.is_taken() => near.move_to(body, &bounds).unwrap(),
                _ => drop(near.insert(&bounds, ()).unwrap()),
            }
        }
        for _ in 0..r.within(0, 5) {
            let body = near.table().handle(r.within(0, BODIES as i32 - 1) as usize);
            if body.is_taken() {
                near.remove(body).unwrap();
            }
        }
        for _ in 0..60 {
            let size = [0, 0, 5, 60][r.within(0, 3) as usize];
            let start = r.corners(span + 20, size);
            let reach = [0, 1, 7, 8, 40, 900][r.within(0, 5) as usize];
            let (x, y) = (r.within(-reach, reach), r.within(-reach, reach));
            for motion in [Raw { x, y }, Raw { x, y: 0 }, Raw { x: 0, y }, Raw { x, y: x }] {
                path(&near, &start, motion);
            }
            around(&near, start.lo(), reach);
        }
        let edge = crate::num::DOMAIN - 1;
        let start = Aabb::from_raw_unchecked(Raw { x: -edge, y: r.within(-50, 50) }, Raw { x: -edge, y: 60 });
        path(&near, &start, Raw { x: 2 * edge, y: r.within(-90, 90) });
        path(&near, &start, Raw { x: edge + r.within(-50, 50), y: r.within(-3, 3) });
        around(&near, Raw { x: edge, y: -edge }, edge);
        around(&near, Raw { x: 3, y: 4 }, edge);
    }
}

#[test]
fn all_that_is_on_a_way_or_near_a_point_comes_once() {
    let (origin, cell) = (|x, y| Vec2::from_raw(x, y), Fx::from_bits(CELL));
    check(BruteForce::<BODIES>::new(), CELL, 0);
    check(LooseGrid::<1, BODIES>::new(origin(0, 0), cell, 4).unwrap(), CELL, 1);
    check(LooseGrid::<4, BODIES>::new(origin(-50, -40), cell, 16).unwrap(), CELL, 2);
    check(LooseGrid::<64, BODIES>::new(origin(-150, -140), cell, 64).unwrap(), CELL, 3);
    check(LooseGrid::<4, BODIES, (), true>::new(origin(-50, -40), cell, 16).unwrap(), 90, 4);
    check(SpatialHash::<64, BODIES>::new(cell).unwrap(), CELL, 5);
    check(SpatialHash::<512, BODIES>::new(cell).unwrap(), CELL, 6);
    check(SpatialHash::<64, BODIES, (), true>::new(cell).unwrap(), 90, 7);
}

mod lattice {
    use crate::broad::cells::lattice::{CellRange, Window};

    /// If a window has more cells than a word can count, it has more than there are bodies.
    #[test]
    fn windows_are_counted_beyond_a_word() {
        let run = |cells: i32| CellRange { lo: -3, hi: cells - 4 };
        let left = |w: i32, h: i32| Window { x: run(w), y: run(h) }.cells_of(8);
        assert_eq!((left(1 << 29, 8), left(8, 1 << 29), left(9, 1)), (None, None, None));
        assert_eq!((left(2, 3), left(8, 1), left(1, 8)), (Some(2), Some(0), Some(0)));
    }
}

mod hash {
    use crate::broad::cells::hash::factor;

    /// Checks the claim for every distance. Two cells with a list in common are far apart, or in
    /// one column or row at a multiple of all buckets.
    #[test]
    fn cells_that_share_a_list_are_far_apart() {
        for log in 6..=15 {
            let buckets = 1u64 << log;
            let factor = u64::from(factor(1 << log));
            for y in 1..buckets {
                let x = factor * y % buckets;
                assert!(x != 0, "a column");
                assert!(4 * x.min(buckets - x) * y.min(buckets - y) > buckets, "{buckets} buckets: ({x}, {y})");
            }
        }
    }
}

/// The compiler's messages for a number in the wrong place, because `N` is not always the first
/// one.
mod refusals {
    use crate::broad::cells::{grid::check_blocks, hash::factor};
    use crate::broad::table::check_bodies;

    #[test]
    #[should_panic(expected = "the first parameter, BUCKETS, must be a power of two")]
    fn buckets_are_named() {
        let _ = factor(300);
    }

    #[test]
    #[should_panic(expected = "the first parameter, BLOCKS, must be from 1 to 2047")]
    fn blocks_are_named() {
        check_blocks(2048);
    }

    #[test]
    #[should_panic(expected = "the parameter N, the most bodies, must be at most 65534")]
    fn bodies_are_named() {
        check_bodies(65_535);
    }
}
