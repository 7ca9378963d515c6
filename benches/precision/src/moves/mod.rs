//! The workload of bodies that move through tiles and slide: three levels, six classes.

pub mod backends;
pub mod classes;
mod engines;
mod pieces;
pub mod room;
pub mod truth;

use crate::callgrind;
use crate::job::Job;
use crate::record::Row;
use crate::run::{Sizes, time};
use classes::{CLASSES, Class, FRAMES};
use room::{MAPS, Map, Room};
use truth::{Answer, Verdict};

pub fn name(map: Map) -> String {
    format!("move: {}", map.name())
}

/// Far from the origin the small level would not fit the classes. They use the other levels.
pub fn classes(map: Map) -> impl Iterator<Item = Class> {
    CLASSES.into_iter().filter(move |class| map != Map::Ninja || class.origin == 0)
}

/// Errors, and the time per frame.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for map in MAPS {
        for class in classes(map) {
            let room = Room::new(map, class.origin);
            let list = backends::all(&room, class.kind);
            let cases = class.cases(&room, sizes.moves);
            eprintln!("{}, {}: {} frames", name(map), class.name(), cases.len() * FRAMES);
            let from = rows.len();
            let mut jobs: Vec<Box<dyn Job<Answer>>> = Vec::new();
            for backend in &list.0 {
                let mut row = Row::new(&name(map), &class.name(), backend.name, backend.asked);
                let mut verdict = Verdict::default();
                for (case, ends) in cases.iter().zip((backend.make)(&cases).answers()) {
                    verdict.add(&room, case, &ends);
                }
                verdict.set(&mut row);
                jobs.push((backend.make)(&cases[..cases.len().min(sizes.timed / FRAMES)]));
                rows.push(row);
            }
            time(&mut rows[from..], &mut jobs, FRAMES, sizes);
        }
    }
}

/// Instructions per frame, under callgrind.
pub fn count(sizes: &Sizes) {
    for map in MAPS {
        for class in classes(map) {
            let room = Room::new(map, class.origin);
            let list = backends::all(&room, class.kind);
            let cases = class.cases(&room, (sizes.counted / FRAMES).max(1));
            for backend in &list.0 {
                let mut job = (backend.make)(&cases);
                let frames = (cases.len() * FRAMES).to_string();
                let label = [&name(map), &class.name(), backend.name, backend.asked, &frames].join("|");
                callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
            }
        }
    }
}
