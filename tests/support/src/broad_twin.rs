//! A broad phase beside a list of boxes, which compares every two of them.

use crate::Random;
use crate::broad::near::Near;
use std::collections::BTreeSet;
use tilesat::broad::{BroadError, BroadPhase, Handle, Pair};
use tilesat::{Aabb, Vec2};

/// The last coordinate of the domain.
pub const END: i32 = (1 << 29) - 1;

/// Raw corners.
pub type Corners = [i32; 4];

pub fn aabb([x0, y0, x1, y1]: Corners) -> Aabb {
    Aabb::new(Vec2::from_raw(x0, y0), Vec2::from_raw(x1, y1)).unwrap()
}

pub fn touch(a: Corners, b: Corners) -> bool {
    let common = |lo: usize, hi: usize| a[lo].max(b[lo]) <= a[hi].min(b[hi]);
    common(0, 2) && common(1, 3)
}

#[derive(Clone)]
pub struct Twin {
    pub near: Near<()>,
    /// The present bodies, in the order of insertion.
    pub bodies: Vec<(Handle, Corners)>,
}

impl Twin {
    pub fn new<B: BroadPhase<Tag = ()> + Copy + 'static>(near: B) -> Self {
        Self { near: Near::new(near), bodies: Vec::new() }
    }

    pub fn insert(&mut self, corners: Corners) -> Result<Handle, BroadError> {
        let handle = self.near.insert(&aabb(corners), ())?;
        self.bodies.push((handle, corners));
        Ok(handle)
    }

    pub fn set(&mut self, index: usize, corners: Corners) {
        self.near.move_to(self.bodies[index].0, &aabb(corners)).unwrap();
        self.bodies[index].1 = corners;
    }

    pub fn remove(&mut self, index: usize) -> Handle {
        let (handle, _) = self.bodies.swap_remove(index);
        self.near.remove(handle).unwrap();
        handle
    }

    /// All pairs, by definition.
    pub fn pairs(&self) -> BTreeSet<Pair> {
        let mut pairs = BTreeSet::new();
        for (i, &(a, ca)) in self.bodies.iter().enumerate() {
            for &(b, cb) in &self.bodies[..i] {
                if touch(ca, cb) {
                    pairs.insert(if a.slot() < b.slot() { Pair { a, b } } else { Pair { a: b, b: a } });
                }
            }
        }
        pairs
    }

    pub fn check_pairs(&mut self) {
        let mut found = BTreeSet::new();
        self.near.pairs(|pair| assert!(found.insert(pair), "{pair:?} twice"));
        assert_eq!(found, self.pairs(), "{:?}", self.bodies);
    }

    pub fn check_region(&self, region: Corners) {
        let mut found = BTreeSet::new();
        self.near.in_region(&aabb(region), |body| assert!(found.insert(body), "{body:?} twice in {region:?}"));
        let expected: BTreeSet<_> = self.bodies.iter().filter(|b| touch(b.1, region)).map(|b| b.0).collect();
        assert_eq!(found, expected, "{region:?} {:?}", self.bodies);
    }

    pub fn check_point(&self, x: i32, y: i32) {
        let mut found = BTreeSet::new();
        self.near.at_point(Vec2::from_raw(x, y), |body| assert!(found.insert(body), "{body:?} twice at {x}, {y}"));
        let expected: BTreeSet<_> = self.bodies.iter().filter(|b| touch(b.1, [x, y, x, y])).map(|b| b.0).collect();
        assert_eq!(found, expected, "{x}, {y} {:?}", self.bodies);
    }
}

/// A number beside a line of cells, at most two raw away from it or from the middle between lines.
/// Sometimes anywhere.
pub fn beside(r: &mut Random, cell: i64, cells: i64) -> i32 {
    if r.one_in(8) {
        return r.around(cells * cell) as i32;
    }
    (r.around(2 * cells) * cell / 2 + r.around(2)) as i32
}

/// A side of at most a cell, often none or the longest.
pub fn side(r: &mut Random, cell: i64) -> i32 {
    let sides = [0, 1, cell / 2, cell - 1, cell, cell];
    match sides.get(r.below(8) as usize) {
        Some(&side) => side as i32,
        None => r.within(0, cell) as i32,
    }
}

/// A box of at most a cell, beside lines of cells; in the domain.
pub fn small(r: &mut Random, cell: i64, cells: i64, (x, y): (i32, i32)) -> Corners {
    let mut axis = |around: i32| {
        let size = side(r, cell);
        // The centre, or the corner, is beside a line.
        let shift = if r.one_in(2) { size / 2 } else { 0 };
        let lo = (beside(r, cell, cells) - shift).saturating_add(around).clamp(-END, END - size);
        (lo, lo + size)
    };
    let ((x0, x1), (y0, y1)) = (axis(x), axis(y));
    [x0, y0, x1, y1]
}

/// A region of any size.
pub fn region(r: &mut Random, cell: i64, cells: i64, (x, y): (i32, i32)) -> Corners {
    let mut axis = |around: i32| {
        let (a, b) = (beside(r, cell, cells), beside(r, cell, cells));
        let at = |v: i32| v.saturating_add(around).clamp(-END, END);
        (at(a.min(b)), at(a.max(b)))
    };
    let ((x0, x1), (y0, y1)) = (axis(x), axis(y));
    [x0, y0, x1, y1]
}
