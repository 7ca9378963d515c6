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

/// How many series of passes a job gets. A disturbance is often over before the next one.
const SERIES: usize = 4;

/// The steady time of each of so many jobs. They take turns, so that a disturbance affects all.
fn settled(jobs: usize, passes: usize, mut pass: impl FnMut(usize) -> f64) -> Vec<Option<f64>> {
    let mut times = vec![None; jobs];
    for _ in 0..SERIES {
        let mut open: Vec<(usize, Vec<f64>)> =
            (0..jobs).filter(|&job| times[job].is_none()).map(|job| (job, Vec::new())).collect();
        for _ in 0..passes {
            open.iter_mut().for_each(|(job, taken)| taken.push(pass(*job)));
        }
        open.into_iter().for_each(|(job, taken)| times[job] = steady(taken));
    }
    times
}

/// Sets the time of a query in each row, from a job of inputs with so many queries each. Names
/// those whose time strays, and does not set it.
pub fn time<A>(rows: &mut [Row], jobs: &mut [Box<dyn Job<A>>], queries: usize, sizes: &Sizes) {
    let times = settled(jobs.len(), sizes.passes, |job| {
        let (job, start) = (&mut jobs[job], cpu_time());
        job.pass();
        (cpu_time() - start) as f64 / (job.len() * queries) as f64
    });
    for (row, time) in rows.iter_mut().zip(times) {
        match time {
            Some(ns) => {
                row.set("ns", ns);
            }
            None if sizes.passes > 0 => eprintln!("no steady time: {}", row.key.join(", ")),
            None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{SERIES, settled, steady};

    #[test]
    fn a_time_that_strays_is_none() {
        assert_eq!(steady(vec![12.0, 10.0, 90.0]), Some(10.0));
        assert_eq!(steady(vec![14.0, 10.0, 90.0]), None);
        assert_eq!(steady(Vec::new()), None);
    }
    #[test]
    fn a_job_whose_time_strays_is_timed_again() {
        let mut calls = [0; 3];
        let times = settled(3, 2, |job| {
            calls[job] += 1;
            let busy = [0, 2, usize::MAX][job];
            if calls[job] <= busy && calls[job] % 2 == 0 { 90.0 } else { 10.0 }
        });
        assert_eq!(times, [Some(10.0), Some(10.0), None]);
        assert_eq!(calls, [2, 4, 2 * SERIES]);
    }
}
