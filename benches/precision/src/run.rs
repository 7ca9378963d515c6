//! How much is run, and timing.

use crate::job::Job;
use crate::record::Row;

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
    /// The most segments of a map that is built.
    pub largest: usize,
    /// Passes of which the fastest is taken; none where nothing is timed.
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
        largest: 10_000,
        passes: 7,
    };
    /// For a look that takes seconds.
    pub const QUICK: Self = Self {
        judged: 2_000,
        timed: 256,
        counted: 64,
        rays: 128,
        casts: 1_000,
        moves: 32,
        boxes: 4_096,
        largest: 100,
        passes: 2,
    };
}

/// Nanoseconds for which this thread has run so far: what others do in between is not its time.
fn cpu_time() -> u64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: the clock is there, and the place for its answer is valid.
    let failed = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) } != 0;
    assert!(!failed, "no clock of this thread");
    time.tv_sec as u64 * 1_000_000_000 + time.tv_nsec as u64
}

/// How far the middle one of some passes may be above the fastest. All take the same instructions,
/// so more is the machine's doing.
const STEADY: f64 = 1.25;

/// The fastest of some passes, if most were about as fast: else the machine was busy, and the time
/// says nothing.
fn steady(mut passes: Vec<f64>) -> Option<f64> {
    passes.sort_by(f64::total_cmp);
    let (fastest, middle) = (*passes.first()?, passes[passes.len() / 2]);
    (middle <= fastest * STEADY).then_some(fastest)
}

/// Sets the time of a query in each row, by a job of inputs that hold so many queries each. The
/// jobs take turns, so that what disturbs one disturbs all; a time that strays is not set.
pub fn time<A>(rows: &mut [Row], jobs: &mut [Box<dyn Job<A>>], queries: usize, sizes: &Sizes) {
    let mut passes = vec![Vec::new(); jobs.len()];
    for _ in 0..sizes.passes {
        for (job, passes) in jobs.iter_mut().zip(&mut passes) {
            let start = cpu_time();
            job.pass();
            passes.push((cpu_time() - start) as f64 / (job.len() * queries) as f64);
        }
    }
    for (row, passes) in rows.iter_mut().zip(passes) {
        if let Some(ns) = steady(passes) {
            row.set("ns", ns);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::steady;

    #[test]
    fn a_time_that_strays_is_none() {
        assert_eq!(steady(vec![12.0, 10.0, 90.0]), Some(10.0));
        assert_eq!(steady(vec![14.0, 10.0, 90.0]), None);
        assert_eq!(steady(Vec::new()), None);
    }
}
