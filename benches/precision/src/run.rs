//! How much is run, and timing.

use crate::job::Job;
use std::time::Instant;

/// How many inputs a class has.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// Pairs that are judged.
    pub judged: usize,
    /// Pairs or casts of a pass that is timed.
    pub timed: usize,
    /// The first of them, which are counted: callgrind is fifty times slower.
    pub counted: usize,
    /// Rays a map and class, which are judged and timed.
    pub rays: usize,
    /// Casts that are judged.
    pub casts: usize,
    /// Sequences of frames that are judged.
    pub moves: usize,
    /// Boxes times frames, all of which are judged and timed.
    pub boxes: usize,
    /// Passes of which the fastest is taken.
    pub passes: usize,
}

impl Sizes {
    pub const FULL: Self = Self {
        judged: 200_000,
        timed: 4_096,
        counted: 1_024,
        rays: 4_096,
        casts: 100_000,
        moves: 1_024,
        boxes: 65_536,
        passes: 7,
    };
    /// For a look that takes seconds.
    pub const QUICK: Self =
        Self { judged: 2_000, timed: 256, counted: 64, rays: 128, casts: 1_000, moves: 32, boxes: 4_096, passes: 2 };
}

/// Nanoseconds an input, of the fastest pass of each; the jobs take turns, so that what disturbs one disturbs all.
pub fn fastest<A>(jobs: &mut [Box<dyn Job<A>>], sizes: &Sizes) -> Vec<f64> {
    let mut best = vec![f64::INFINITY; jobs.len()];
    for _ in 0..sizes.passes {
        for (job, best) in jobs.iter_mut().zip(&mut best) {
            let start = Instant::now();
            job.pass();
            *best = best.min(start.elapsed().as_nanos() as f64 / job.len() as f64);
        }
    }
    best
}
