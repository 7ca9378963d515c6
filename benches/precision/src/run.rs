//! The amount of work, and timing.

use crate::job::Job;
use crate::record::Row;

/// Inputs per class.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// Pairs to judge.
    pub judged: usize,
    /// Pairs or casts per timed pass.
    pub timed: usize,
    /// The first of them are counted: callgrind is fifty times slower.
    pub counted: usize,
    /// Rays per map and class, to judge and to time.
    pub rays: usize,
    /// Casts to judge.
    pub casts: usize,
    /// Sequences of frames to judge.
    pub moves: usize,
    /// Boxes times frames, to judge and to time.
    pub boxes: usize,
    /// The most segments of a built map.
    pub largest: usize,
    /// Passes, of which the fastest counts. Zero if nothing is timed.
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
    /// For a look of seconds.
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

/// Nanoseconds that this thread has run so far, without the time of other threads.
pub fn cpu_time() -> u64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: the clock exists, and the memory for its answer is valid.
    let failed = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) } != 0;
    assert!(!failed, "no clock of this thread");
    time.tv_sec as u64 * 1_000_000_000 + time.tv_nsec as u64
}

/// How far the median of some passes may be above the fastest. All run the same instructions, so
/// the machine causes the rest.
const STEADY: f64 = 1.25;

/// The fastest of some passes, if most were about as fast. Otherwise the machine was busy, and the
/// time means nothing.
pub fn steady(mut passes: Vec<f64>) -> Option<f64> {
    passes.sort_by(f64::total_cmp);
    let (fastest, middle) = (*passes.first()?, passes[passes.len() / 2]);
    (middle <= fastest * STEADY).then_some(fastest)
}

/// Sets the time of a query in each row, from a job of inputs with so many queries each. The jobs
/// take turns, so that a disturbance affects all. Does not set a time that strays.
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
