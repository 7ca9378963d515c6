//! One class of inputs: errors, times and instructions of all backends.

use crate::callgrind;
use crate::job::{Format, Job, List};
use crate::record::Row;
use crate::run::{Sizes, time};

/// The exact answers, and the comparison with them.
pub struct Judge<I, A, T> {
    pub truth: fn(&I) -> T,
    pub judge: fn(&mut Row, &[T], &[A], Format),
}

/// Errors, and the time per call.
pub fn measure<I: 'static, A: 'static, T>(
    (workload, class): (&str, &str),
    list: &List<I, A>,
    (inputs, judge): (&[I], &Judge<I, A, T>),
    sizes: &Sizes,
    rows: &mut Vec<Row>,
) {
    if list.0.is_empty() || inputs.is_empty() {
        return;
    }
    eprintln!("{workload}, {class}: {} inputs", inputs.len());
    let truths: Vec<T> = inputs.iter().map(judge.truth).collect();
    let mut jobs: Vec<Box<dyn Job<A>>> = Vec::new();
    let from = rows.len();
    for backend in list.0.iter().filter(|b| inputs.iter().all(b.fits)) {
        let mut row = Row::new(workload, class, backend.name, backend.asked);
        (judge.judge)(&mut row, &truths, &(backend.make)(inputs).answers(), backend.format);
        jobs.push((backend.make)(&inputs[..sizes.timed]));
        rows.push(row);
    }
    time(&mut rows[from..], &mut jobs, 1, sizes);
}

/// Instructions per call, under callgrind. The judged inputs come first in the same stream, so
/// these are the first of them. All inputs decide whether a format fits.
pub fn count<I: 'static, A: 'static>((workload, class): (&str, &str), list: &List<I, A>, inputs: &[I]) {
    if inputs.is_empty() {
        return;
    }
    for backend in list.0.iter().filter(|b| inputs.iter().all(b.fits)) {
        let mut job = (backend.make)(inputs);
        let label = [workload, class, backend.name, backend.asked, &inputs.len().to_string()].join("|");
        callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
    }
}
