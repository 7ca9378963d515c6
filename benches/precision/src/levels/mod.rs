//! The workloads of whole levels: circles among tiles, rays across empty maps, and building of
//! segment maps.

mod build;
mod empty;
mod tiles;

use crate::callgrind;
use crate::job::{Job, List};
use crate::record::Row;
use crate::run::{Sizes, time};

/// A class of a workload: its backends, and its query.
struct Asked<I, A> {
    workload: &'static str,
    class: String,
    list: List<I, A>,
    inputs: Vec<I>,
}

impl<I: 'static, A: 'static> Asked<I, A> {
    fn measure(&self, sizes: &Sizes, rows: &mut Vec<Row>, judge: impl Fn(&mut Row, &[A], &str)) {
        eprintln!("{}, {}: {} queries", self.workload, self.class, self.inputs.len());
        let from = rows.len();
        let mut jobs: Vec<Box<dyn Job<A>>> = Vec::new();
        for backend in self.list.0.iter().filter(|b| self.inputs.iter().all(b.fits)) {
            let mut row = Row::new(self.workload, &self.class, backend.name, backend.asked);
            let job = (backend.make)(&self.inputs);
            judge(&mut row, &job.answers(), backend.name);
            jobs.push(job);
            rows.push(row);
        }
        time(&mut rows[from..], &mut jobs, 1, sizes);
    }

    fn count(&self) {
        for backend in self.list.0.iter().filter(|b| self.inputs.iter().all(b.fits)) {
            let mut job = (backend.make)(&self.inputs);
            let label = [self.workload, &self.class, backend.name, backend.asked, &job.len().to_string()].join("|");
            callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
        }
    }
}

pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    tiles::measure(sizes, rows);
    empty::all(sizes.rays / 32).iter().for_each(|a| a.measure(sizes, rows, empty::judge));
    build::all(sizes.largest).iter().for_each(|a| a.measure(sizes, rows, build::judge));
}

/// Instructions per call, under callgrind.
pub fn count(sizes: &Sizes) {
    tiles::all(sizes.counted / 4).iter().for_each(Asked::count);
    empty::all(sizes.counted / 32).iter().for_each(Asked::count);
    build::all(sizes.largest).iter().for_each(Asked::count);
}
