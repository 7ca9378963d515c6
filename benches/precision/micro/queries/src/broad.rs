//! Broad phases: a frame moves all boxes and reports all pairs.

use crate::{Shape, book};
use core::marker::PhantomData;
use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SortSweep, SpatialHash};
use tilesat::{Aabb, Fx, Vec2};
use tilesat_textbook::{Scalar, broad};

/// The size of the world.
#[derive(Clone, Copy)]
pub struct Area {
    /// The first corner on both axes, raw.
    pub origin: i32,
    /// Cells on a side; a box is smaller than one.
    pub columns: u16,
}

/// One that holds N boxes.
pub trait Phase<const N: usize> {
    type Box: Shape;
    fn start(boxes: &[Self::Box; N], area: Area) -> Self;
    fn frame(&mut self, boxes: &[Self::Box; N], each: impl FnMut(usize, usize));
}

/// With the pairs of its last report.
pub struct Scene<P, const N: usize> {
    phase: P,
    pairs: [(u16, u16); N],
    told: usize,
}

impl<P: Phase<N>, const N: usize> Scene<P, N> {
    #[inline(always)]
    pub fn start(boxes: &[P::Box; N], area: Area) -> Self {
        Self { phase: P::start(boxes, area), pairs: [(0, 0); N], told: 0 }
    }

    /// # Panics
    /// If there are more pairs than boxes.
    pub fn frame(&mut self, boxes: &[P::Box; N]) {
        self.told = 0;
        self.phase.frame(boxes, |a, b| {
            self.pairs[self.told] = (a as u16, b as u16);
            self.told += 1;
        });
    }

    pub fn pairs(&self) -> &[(u16, u16)] {
        &self.pairs[..self.told]
    }
}

const CELL: Fx = Fx::lit("32");

/// The library's, each from the first boxes.
pub trait Own: BroadPhase<Tag = ()> {
    fn empty(area: Area) -> Self;
}

fn corner(area: Area) -> Vec2 {
    Vec2::from_raw(area.origin, area.origin)
}

impl<const N: usize> Own for SortSweep<N> {
    fn empty(_: Area) -> Self {
        Self::new()
    }
}

impl<const N: usize> Own for BruteForce<N> {
    fn empty(_: Area) -> Self {
        Self::new()
    }
}

impl<const BLOCKS: usize, const N: usize> Own for LooseGrid<BLOCKS, N> {
    fn empty(area: Area) -> Self {
        Self::new(corner(area), CELL, area.columns).expect("a legal grid")
    }
}

impl<const BUCKETS: usize, const N: usize> Own for SpatialHash<BUCKETS, N> {
    fn empty(_: Area) -> Self {
        Self::new(CELL).expect("a legal cell")
    }
}

impl<B: Own, const N: usize> Phase<N> for B {
    type Box = Aabb;

    #[inline(always)]
    fn start(boxes: &[Aabb; N], area: Area) -> Self {
        let mut near = B::empty(area);
        for bounds in boxes {
            near.insert(bounds, ()).expect("there is room for all of them");
        }
        near
    }

    fn frame(&mut self, boxes: &[Aabb; N], mut each: impl FnMut(usize, usize)) {
        self.move_each(|handle, _| boxes[handle.slot()]).expect("boxes are smaller than cells");
        self.pairs(|pair| each(pair.a.slot(), pair.b.slot()));
    }
}

/// The textbook's, all against all.
pub struct All<S>(PhantomData<S>);

impl<S: Scalar, const N: usize> Phase<N> for All<S> {
    type Box = book::Aabb<S>;

    fn start(_: &[Self::Box; N], _: Area) -> Self {
        Self(PhantomData)
    }

    fn frame(&mut self, boxes: &[Self::Box; N], mut each: impl FnMut(usize, usize)) {
        broad::brute(boxes, |a, b| each(a as usize, b as usize));
    }
}

/// The textbook's, sorted along x.
pub struct Sorted<S, const N: usize>([u32; N], PhantomData<S>);

impl<S: Scalar, const N: usize> Phase<N> for Sorted<S, N> {
    type Box = book::Aabb<S>;

    fn start(_: &[Self::Box; N], _: Area) -> Self {
        Self(core::array::from_fn(|i| i as u32), PhantomData)
    }

    fn frame(&mut self, boxes: &[Self::Box; N], mut each: impl FnMut(usize, usize)) {
        broad::sweep(&mut self.0, boxes, |a, b| each(a as usize, b as usize));
    }
}

/// Calls a macro for each broad phase of N boxes: the row's keys, and its type for so many blocks
/// of 32 cells, or buckets.
#[macro_export]
macro_rules! each_broad {
    ($each:ident $n:literal, $blocks:literal, $buckets:literal) => {
        $each! { "pairs of boxes", "tilesat", "sweep", $n, SortSweep<$n> }
        $each! { "pairs of boxes", "tilesat", "grid", $n, LooseGrid<$blocks, $n> }
        $each! { "pairs of boxes", "tilesat", "hash", $n, SpatialHash<$buckets, $n> }
        $each! { "pairs of boxes", "tilesat", "brute", $n, BruteForce<$n> }
        $each! { "pairs of boxes", "textbook f32", "sweep", $n, Sorted<f32, $n> }
        $each! { "pairs of boxes", "textbook f32", "brute", $n, All<f32> }
    };
}
