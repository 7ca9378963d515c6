//! The workload of pairs: six kinds, nine classes.

pub mod backends;
pub mod classes;
pub mod truth;

use crate::each::{self, Judge};
use crate::record::Row;
use crate::run::Sizes;
use classes::CLASSES;
use tilesat_judge::oracle::figure::{Kind, PAIRS};
use truth::{Truth, judge};

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
            let judge = Judge { truth: Truth::new, judge };
            each::measure((name(kinds), class.name()), &list, (&pairs, &judge), sizes, rows);
        }
    }
}

/// Instructions per call, under callgrind.
pub fn count(sizes: &Sizes) {
    for kinds in PAIRS {
        let list = backends::all(kinds);
        for class in CLASSES {
            each::count((name(kinds), class.name()), &list, &class.pairs(kinds, sizes.counted));
        }
    }
}
