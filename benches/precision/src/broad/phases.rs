//! Broad phases, each behind the same two calls: it gets the boxes of a frame and reports all
//! pairs.

use super::scenes::{Bounds, Class, Frame};
use super::truth::Answer;
use crate::job::{Backend, Format, Job, List};
use crate::peers::ours;
use crate::peers::textbook::{Named, vector};
use std::hint::black_box;
use std::marker::PhantomData;
use std::rc::Rc;
use tilesat::broad::{BruteForce, LooseGrid, SortSweep, SpatialHash};
use tilesat::prelude::*;
use tilesat::{Aabb, Fx};
use tilesat_textbook::broad;
use tilesat_textbook::shape::Aabb as Book;

/// A broad phase that holds the boxes of one frame after the other.
pub trait Phase: 'static {
    type Box: 'static;
    fn boxed(bounds: &Bounds) -> Self::Box;
    /// Moves all boxes and reports all pairs.
    fn frame(&mut self, boxes: &[Self::Box], pairs: &mut Answer);
}

/// Frames forth and back, so that no pass begins with a jump.
struct Run<P: Phase> {
    phase: P,
    frames: Vec<Vec<P::Box>>,
    told: Vec<Answer>,
    pairs: Answer,
}

impl<P: Phase> Job<Answer> for Run<P> {
    #[inline(never)]
    fn pass(&mut self) {
        let n = self.frames.len();
        for i in (1..n).chain((0..n - 1).rev()) {
            self.pairs.clear();
            self.phase.frame(black_box(&self.frames[i]), &mut self.pairs);
        }
    }

    fn answers(&self) -> Vec<Answer> {
        self.told.clone()
    }

    fn len(&self) -> usize {
        2 * (self.frames.len() - 1)
    }
}

/// A broad phase from its first boxes.
pub fn add<P: Phase>(
    list: &mut List<Frame, Answer>,
    (name, asked, format): (&'static str, &'static str, Format),
    start: impl Fn(&[P::Box]) -> P + 'static,
) {
    let make = Rc::new(move |raw: &[Frame]| {
        let frames: Vec<Vec<P::Box>> = raw.iter().map(|f| f.iter().map(P::boxed).collect()).collect();
        let mut phase = start(&frames[0]);
        let tell = |boxes: &Vec<P::Box>| {
            let mut pairs = Answer::new();
            phase.frame(boxes, &mut pairs);
            pairs
        };
        let told: Vec<Answer> = frames.iter().map(tell).collect();
        // Back to the first frame.
        let pairs = Answer::with_capacity(told.iter().map(Vec::len).max().unwrap_or(0));
        let mut run = Run { phase, frames, told, pairs };
        run.phase.frame(&run.frames[0], &mut run.pairs);
        Box::new(run) as Box<dyn Job<Answer>>
    });
    list.0.push(Backend { name, asked, format, make, fits: |_| true });
}

/// The work of a broad phase per frame.
pub trait Ask: 'static {
    fn ask<B: BroadPhase<Tag = ()>>(near: &mut B, boxes: &[Aabb], answer: &mut Answer);
}

/// All boxes move, and it reports all pairs.
pub struct Pairs;

impl Ask for Pairs {
    fn ask<B: BroadPhase<Tag = ()>>(near: &mut B, boxes: &[Aabb], pairs: &mut Answer) {
        near.move_each(|handle, _| boxes[handle.slot()]).expect("boxes are smaller than cells");
        near.pairs(|pair| pairs.push((pair.a.slot() as u32, pair.b.slot() as u32)));
    }
}

/// Any broad phase of the library. Slots ascend.
struct Own<B, A>(B, PhantomData<A>);

impl<B: BroadPhase<Tag = ()> + 'static, A: Ask> Own<B, A> {
    fn of(mut near: B, boxes: &[Aabb]) -> Self {
        for bounds in boxes {
            near.insert(bounds, ()).expect("there is room for all of them");
        }
        Self(near, PhantomData)
    }
}

impl<B: BroadPhase<Tag = ()> + 'static, A: Ask> Phase for Own<B, A> {
    type Box = Aabb;

    fn boxed(bounds: &Bounds) -> Aabb {
        Aabb::new(ours::vec2(bounds.lo), ours::vec2(bounds.hi)).expect("scenes stay inside the domain")
    }

    fn frame(&mut self, boxes: &[Aabb], answer: &mut Answer) {
        A::ask(&mut self.0, boxes, answer);
    }
}

/// For a number of bodies: blocks of 32 cells, and buckets, at least 64.
fn sized<A: Ask, const N: usize, const BLOCKS: usize, const BUCKETS: usize, const LARGE: bool>(
    list: &mut List<Frame, Answer>,
    class: Class,
) {
    let corner = ours::vec2((class.origin << 16, class.origin << 16));
    let (cell, named) = (Fx::from_num(class.cell()), |asked| (ours::NAME, asked, Format::RAW));
    add(list, named("sweep"), |boxes| Own::<_, A>::of(SortSweep::<N>::new(), boxes));
    add(list, named("grid"), move |boxes| {
        let near = LooseGrid::<BLOCKS, N, (), LARGE>::new(corner, cell, class.grid_columns());
        Own::<_, A>::of(near.expect("a legal grid"), boxes)
    });
    add(list, named("hash"), move |boxes| {
        Own::<_, A>::of(SpatialHash::<BUCKETS, N, (), LARGE>::new(cell).expect("a legal cell"), boxes)
    });
    add(list, named("brute"), |boxes| Own::<_, A>::of(BruteForce::<N>::new(), boxes));
}

pub fn library<A: Ask>(list: &mut List<Frame, Answer>, class: Class) {
    match (class.bodies, class.has_large()) {
        (8, _) => sized::<A, 8, 2, 64, false>(list, class),
        (64, _) => sized::<A, 64, 8, 64, false>(list, class),
        (256, false) => sized::<A, 256, 32, 256, false>(list, class),
        (256, true) => sized::<A, 256, 32, 256, true>(list, class),
        (1024, false) => sized::<A, 1024, 128, 1024, false>(list, class),
        (1024, true) => sized::<A, 1024, 128, 1024, true>(list, class),
        _ => sized::<A, 4096, 512, 4096, false>(list, class),
    }
}

/// A number format's boxes, all against all.
struct Brute<S>(PhantomData<S>);

impl<S: Named> Phase for Brute<S> {
    type Box = Book<S>;

    fn boxed(bounds: &Bounds) -> Book<S> {
        Book { lo: vector(bounds.lo), hi: vector(bounds.hi) }
    }

    fn frame(&mut self, boxes: &[Book<S>], pairs: &mut Answer) {
        broad::brute(boxes, |a, b| pairs.push((a, b)));
    }
}

/// The same, sorted along x.
struct Sweep<S>(Vec<u32>, PhantomData<S>);

impl<S: Named> Phase for Sweep<S> {
    type Box = Book<S>;

    fn boxed(bounds: &Bounds) -> Book<S> {
        Brute::boxed(bounds)
    }

    fn frame(&mut self, boxes: &[Book<S>], pairs: &mut Answer) {
        broad::sweep(&mut self.0, boxes, |a, b| pairs.push((a, b)));
    }
}

pub fn textbook<S: Named>(list: &mut List<Frame, Answer>) {
    let sorted = |boxes: &[Book<S>]| Sweep::<S>((0..boxes.len() as u32).collect(), PhantomData);
    add(list, (S::NAME, "sweep", S::FORMAT), sorted);
    add(list, (S::NAME, "brute", S::FORMAT), |_| Brute::<S>(PhantomData));
}
