//! The workload of pairs of convex shapes: four kinds, four classes.

pub mod classes;
mod distance;
mod peers;

use crate::each::{self, Judge};
use crate::pairs::truth::{Truth, judge};
use crate::record::Row;
use crate::run::Sizes;
use classes::{CLASSES, KINDS, Pair};
use distance::Gap;
use tilesat_judge::convex::shape::{Kind, sum};
use tilesat_judge::oracle::measure::Measure;

pub fn name(kinds: (Kind, Kind)) -> &'static str {
    match kinds {
        (Kind::Circle, _) => "circle-OBB",
        (Kind::Turned, _) => "OBB-OBB",
        (Kind::Polygon, _) => "quad-quad",
        _ => "capsule-capsule",
    }
}

/// Whether a workload is one of these.
pub fn is_convex(workload: &str) -> bool {
    KINDS.iter().any(|kinds| name(*kinds) == workload)
}

fn sum_of((a, b): &Pair) -> Measure {
    Measure::of(&sum(a, b))
}

/// Errors, and the time per call.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    let meets = Judge { truth: |pair| Truth::of(&sum_of(pair)), judge };
    let apart = Judge { truth: |pair| Gap::of(&sum_of(pair)), judge: distance::judge };
    for kinds in KINDS {
        let lists = (peers::all(kinds), peers::distances(kinds));
        for class in CLASSES {
            let (key, pairs) = ((name(kinds), class.name()), class.pairs(kinds, sizes.judged));
            each::measure(key, &lists.0, (&pairs, &meets), sizes, rows);
            each::measure(key, &lists.1, (&pairs, &apart), sizes, rows);
        }
    }
}

/// Instructions per call, under callgrind.
pub fn count(sizes: &Sizes) {
    for kinds in KINDS {
        let lists = (peers::all(kinds), peers::distances(kinds));
        for class in CLASSES {
            let (key, pairs) = ((name(kinds), class.name()), class.pairs(kinds, sizes.counted));
            each::count(key, &lists.0, &pairs);
            each::count(key, &lists.1, &pairs);
        }
    }
}
