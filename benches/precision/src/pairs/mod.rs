//! The workload of pairs: six kinds, nine classes.

pub mod backends;
pub mod classes;
pub mod truth;

use crate::callgrind;
use crate::job::Job;
use crate::record::Row;
use crate::run::{Sizes, time};
use classes::CLASSES;
use tilesat_judge::oracle::figure::{Kind, PAIRS};
use truth::{Answer, Truth, judge};

pub fn name(kinds: (Kind, Kind)) -> &'static str {
    match kinds {
        (Kind::Aabb, _) => "AABB-AABB",
        (Kind::Circle, Kind::Circle) => "circle-circle",
        (Kind::Circle, Kind::Aabb) => "circle-AABB",
        (Kind::Circle, Kind::Segment) => "circle-segment",
        (Kind::Segment, Kind::Aabb) => "segment-AABB",
        (Kind::Segment, _) => "segment-segment",
    }
}

/// Errors, and the time per call.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for kinds in PAIRS {
        let list = backends::all(kinds);
        for class in CLASSES {
            let pairs = class.pairs(kinds, sizes.judged);
            if pairs.is_empty() {
                continue;
            }
            eprintln!("{}, {}: {} pairs", name(kinds), class.name(), pairs.len());
            let truths: Vec<Truth> = pairs.iter().map(Truth::new).collect();
            let asked: Vec<_> = list.0.iter().filter(|b| pairs.iter().all(b.fits)).collect();
            let mut jobs: Vec<Box<dyn Job<Answer>>> = Vec::new();
            let from = rows.len();
            for backend in &asked {
                let mut row = Row::new(name(kinds), class.name(), backend.name, backend.asked);
                judge(&mut row, &truths, &(backend.make)(&pairs).answers(), backend.format);
                jobs.push((backend.make)(&pairs[..sizes.timed]));
                rows.push(row);
            }
            time(&mut rows[from..], &mut jobs, 1, sizes);
        }
    }
}

/// Instructions per call, under callgrind.
pub fn count(sizes: &Sizes) {
    for kinds in PAIRS {
        let list = backends::all(kinds);
        for class in CLASSES {
            // The judged pairs come first in the same stream, so these are the first of them. All
            // pairs decide whether a format fits.
            let pairs = class.pairs(kinds, sizes.counted);
            if pairs.is_empty() {
                continue;
            }
            for backend in list.0.iter().filter(|b| pairs.iter().all(b.fits)) {
                let mut job = (backend.make)(&pairs);
                let label =
                    [name(kinds), class.name(), backend.name, backend.asked, &pairs.len().to_string()].join("|");
                callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
            }
        }
    }
}
