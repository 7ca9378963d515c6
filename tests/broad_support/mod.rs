//! What tests of broad phases share: a list of all structures, and a reference that knows the definitions only.

#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod frames;
#[path = "../oracle/random.rs"]
pub(crate) mod random;
pub(crate) mod reference;
pub(crate) mod script;

use std::fmt::Debug;
use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SortSweep, SpatialHash, Tag};
use tilesat::{Aabb, Fx, Vec2};

/// A key and a team: bodies of one team do not pair; those of team 0 pair with all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mark {
    pub(crate) key: u32,
    pub(crate) team: u8,
}

impl Mark {
    pub(crate) const fn new(key: u32, team: u8) -> Self {
        Self { key, team }
    }
}

impl Tag for Mark {
    const BLANK: Self = Self::new(u32::MAX, 77);

    fn pairs_with(&self, other: &Self) -> bool {
        self.team == 0 || self.team != other.team
    }

    fn key(&self) -> u32 {
        self.key
    }
}

/// Where the cells of grids are; the others do not care.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells {
    /// The side, raw, a power of two.
    pub(crate) side: i32,
    pub(crate) origin: (i32, i32),
}

/// What is to hold for every structure.
pub(crate) trait Check {
    /// `limit` is the longest side of a box that is taken.
    fn on<P: BroadPhase<Tag = Mark> + Copy + Debug>(&mut self, name: &str, limit: Option<i32>, empty: P);
}

/// Runs a check on each structure with room for `N` bodies.
pub(crate) fn everywhere<const N: usize>(cells: Cells, check: &mut impl Check) {
    let (side, origin) = (Fx::from_bits(cells.side), Vec2::from_raw(cells.origin.0, cells.origin.1));
    let limit = Some(cells.side);
    check.on("brute force", None, BruteForce::<N, Mark>::new());
    check.on("sweep", None, SortSweep::<N, Mark>::new());
    check.on("grid 16 x 16", limit, LooseGrid::<8, N, Mark>::new(origin, side, 16).unwrap());
    check.on("grid 64 x 4, large", None, LooseGrid::<8, N, Mark, true>::new(origin, side, 64).unwrap());
    check.on("grid 4 x 8", limit, LooseGrid::<1, N, Mark>::new(origin, side, 4).unwrap());
    check.on("hash", limit, SpatialHash::<64, N, Mark>::new(side).unwrap());
    check.on("hash, large", None, SpatialHash::<256, N, Mark, true>::new(side).unwrap());
}

/// The same on those that take boxes of every size.
pub(crate) struct Large<'a, C>(pub(crate) &'a mut C);

impl<C: Check> Check for Large<'_, C> {
    fn on<P: BroadPhase<Tag = Mark> + Copy + Debug>(&mut self, name: &str, limit: Option<i32>, empty: P) {
        if limit.is_none() {
            self.0.on(name, limit, empty);
        }
    }
}

/// A box by its corners, raw.
pub(crate) fn aabb(lo: (i64, i64), hi: (i64, i64)) -> Aabb {
    Aabb::new(vec2(lo), vec2(hi)).unwrap()
}

pub(crate) fn vec2(p: (i64, i64)) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}
