//! Shared code of the tests of broad phases: a list of all structures, and a reference that knows
//! only the definitions.

pub mod frames;
pub mod near;
pub mod reference;
pub mod script;

use near::Near;
use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SortSweep, SpatialHash, Tag};
use tilesat::{Aabb, Fx, Vec2};

/// A key and a team. Bodies of one team do not pair, but those of team 0 pair with all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark {
    pub key: u32,
    pub team: u8,
}

impl Mark {
    pub const fn new(key: u32, team: u8) -> Self {
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

/// The position of a grid's cells. The other structures ignore it.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    /// The side, raw, a power of two.
    pub side: i32,
    pub origin: (i32, i32),
}

/// A check for every structure.
pub trait Check {
    /// `limit` is the longest side of an accepted box.
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>);
}

/// Runs a check on each structure, which is full once the check has inserted this many bodies.
/// Structures for more than 24 answer only about pairs: all answers of a size take a twelfth of
/// this crate's build.
pub fn everywhere(bodies: usize, cells: Cells, check: &mut dyn Check) {
    match bodies {
        0..=2 => with_room::<2, true>(bodies, cells, check),
        3..=24 => with_room::<24, true>(bodies, cells, check),
        _ => with_room::<90, false>(bodies, cells, check),
    }
}

/// A position where no check puts a body.
const AWAY: (i64, i64) = (1 << 20, 1 << 20);

/// Each kind of structure is compiled for few sizes. Bodies without neighbours fill the extra room.
fn with_room<const N: usize, const ASKED: bool>(bodies: usize, cells: Cells, check: &mut dyn Check) {
    let (side, origin) = (Fx::from_bits(cells.side), Vec2::from_raw(cells.origin.0, cells.origin.1));
    let limit = Some(cells.side);
    let mut on = |name, limit, mut near: Near<Mark>| {
        for _ in bodies..N {
            near.insert(&aabb(AWAY, AWAY), Mark::BLANK).unwrap();
        }
        check.on(name, limit, &near);
    };
    on("brute force", None, near::<_, ASKED>(BruteForce::<N, Mark>::new()));
    on("sweep", None, near::<_, ASKED>(SortSweep::<N, Mark>::new()));
    on("grid 16 x 16", limit, near::<_, ASKED>(LooseGrid::<8, N, Mark>::new(origin, side, 16).unwrap()));
    on("grid 64 x 4, large", None, near::<_, ASKED>(LooseGrid::<8, N, Mark, true>::new(origin, side, 64).unwrap()));
    on("grid 4 x 64", limit, near::<_, ASKED>(LooseGrid::<8, N, Mark>::new(origin, side, 4).unwrap()));
    on("hash", limit, near::<_, ASKED>(SpatialHash::<64, N, Mark>::new(side).unwrap()));
    on("hash, large", None, near::<_, ASKED>(SpatialHash::<256, N, Mark, true>::new(side).unwrap()));
}

fn near<P: BroadPhase<Tag = Mark> + Copy + 'static, const ASKED: bool>(phase: P) -> Near<Mark> {
    if ASKED { Near::asked(phase) } else { Near::paired(phase) }
}

/// The same on the structures that accept boxes of every size.
pub struct Large<'a, C>(pub &'a mut C);

impl<C: Check> Check for Large<'_, C> {
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>) {
        if limit.is_none() {
            self.0.on(name, limit, empty);
        }
    }
}

/// A box by its corners, raw.
pub fn aabb(lo: (i64, i64), hi: (i64, i64)) -> Aabb {
    Aabb::new(vec2(lo), vec2(hi)).unwrap()
}

pub fn vec2(p: (i64, i64)) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}
