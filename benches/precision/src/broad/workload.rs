//! A workload of boxes: its classes, its backends, and its judge.

use super::scenes::{Class, Frame};
use super::truth::{Answer, Truth, judge};
use crate::callgrind;
use crate::job::{Backend, Job, List};
use crate::record::Row;
use crate::run::{Sizes, time};

pub struct Workload {
    pub name: &'static str,
    pub classes: &'static [Class],
    /// The most frames to judge and time, and to count.
    pub most: (usize, usize),
    pub truths: fn(&[Frame]) -> Vec<Truth>,
    pub backends: fn(Class) -> List<Frame, Answer>,
}

impl Workload {
    fn judged(
        &self,
        class: Class,
        backend: &Backend<Frame, Answer>,
        frames: &[Frame],
        truths: &[Truth],
    ) -> (Row, Box<dyn Job<Answer>>) {
        let mut row = Row::new(self.name, &class.name(), backend.name, backend.asked);
        let job = (backend.make)(frames);
        judge(&mut row, truths, &job.answers());
        (row, job)
    }

    /// Errors, and the time per frame.
    pub fn measure(&self, sizes: &Sizes, rows: &mut Vec<Row>) {
        for &class in self.classes {
            let frames = class.frames((sizes.boxes / class.bodies).clamp(8, self.most.0));
            eprintln!("{}, {}: {} frames", self.name, class.name(), frames.len());
            let truths = (self.truths)(&frames);
            let from = rows.len();
            let mut jobs = Vec::new();
            for backend in &(self.backends)(class).0 {
                let (row, job) = self.judged(class, backend, &frames, &truths);
                jobs.push(job);
                rows.push(row);
            }
            time(&mut rows[from..], &mut jobs, 1, sizes);
        }
    }

    /// Instructions per frame, under callgrind.
    pub fn count(&self, sizes: &Sizes) {
        for &class in self.classes {
            let frames = class.frames((8 * sizes.counted / class.bodies).clamp(3, self.most.1));
            for backend in &(self.backends)(class).0 {
                let mut job = (backend.make)(&frames);
                let label = [self.name, &class.name(), backend.name, backend.asked, &job.len().to_string()].join("|");
                callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
            }
        }
    }

    /// The rows of the smaller classes, of the backends that count.
    #[cfg(test)]
    pub fn small(&self, counts: impl Fn(&str) -> bool) -> Vec<Row> {
        let small = self.classes.iter().copied().filter(|class| class.bodies <= 256);
        let rows = small.flat_map(|class| {
            let frames = class.frames(16);
            let truths = (self.truths)(&frames);
            let all = (self.backends)(class).0;
            let judged = all.iter().filter(|b| counts(b.name)).map(|b| self.judged(class, b, &frames, &truths).0);
            judged.collect::<Vec<_>>()
        });
        rows.collect()
    }
}
