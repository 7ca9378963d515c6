//! The workload of broad phases: all boxes move, all pairs are told.

mod engines;
mod phases;
pub mod regions;
pub mod scenes;
mod trees;
mod truth;

use crate::callgrind;
use crate::job::{Job, List};
use crate::record::Row;
use crate::run::{Sizes, time};
use scenes::{CLASSES, Class, Frame};
use truth::{Answer, Truth, judge};

pub const NAME: &str = "pairs of boxes";

pub fn backends(class: Class) -> List<Frame, Answer> {
    let mut list = List(Vec::new());
    phases::library(&mut list, class);
    phases::textbook::<f32>(&mut list);
    phases::textbook::<f64>(&mut list);
    engines::all(&mut list);
    trees::all(&mut list, class);
    list
}

/// What is missing, and how long a frame takes.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for class in CLASSES {
        let frames = class.frames((sizes.boxes / class.bodies).clamp(8, 2048));
        eprintln!("{NAME}, {}: {} frames", class.name(), frames.len());
        let truths: Vec<Truth> = frames.iter().map(Truth::new).collect();
        let from = rows.len();
        let mut jobs: Vec<Box<dyn Job<Answer>>> = Vec::new();
        for backend in &backends(class).0 {
            let mut row = Row::new(NAME, &class.name(), backend.name, backend.asked);
            let job = (backend.make)(&frames);
            judge(&mut row, &truths, &job.answers());
            jobs.push(job);
            rows.push(row);
        }
        time(&mut rows[from..], &mut jobs, 1, sizes);
    }
}

/// How many instructions a frame takes; under callgrind.
pub fn count(sizes: &Sizes) {
    for class in CLASSES {
        let frames = class.frames((8 * sizes.counted / class.bodies).clamp(3, 64));
        for backend in &backends(class).0 {
            let mut job = (backend.make)(&frames);
            let label = [NAME, &class.name(), backend.name, backend.asked, &job.len().to_string()].join("|");
            callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ours misses nothing and tells nothing twice, and all of a frame is judged.
    #[test]
    fn ours_tells_each_pair_once() {
        for class in CLASSES.into_iter().filter(|c| c.bodies <= 256) {
            let frames = class.frames(16);
            let truths: Vec<Truth> = frames.iter().map(Truth::new).collect();
            for backend in backends(class).0.iter().filter(|b| b.name == crate::peers::ours::NAME) {
                let mut row = Row::new(NAME, &class.name(), backend.name, backend.asked);
                judge(&mut row, &truths, &(backend.make)(&frames).answers());
                assert!(row.get("queries") > Some(0.0));
                assert_eq!((row.get("wrong"), row.get("extra")), (Some(0.0), Some(0.0)), "{row:?}");
            }
        }
    }
}
