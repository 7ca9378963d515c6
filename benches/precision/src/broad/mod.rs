//! The workload of broad phases: all boxes move, and the broad phase reports all pairs.

mod engines;
mod phases;
pub mod regions;
pub mod scenes;
mod trees;
mod truth;
mod workload;

use crate::job::List;
use crate::record::Row;
use crate::run::Sizes;
use scenes::{CLASSES, Class, Frame};
use truth::{Answer, Truth};
use workload::Workload;

pub const NAME: &str = "pairs of boxes";

const PAIRS: Workload = Workload {
    name: NAME,
    classes: &CLASSES,
    most: (2048, 64),
    truths: |frames| frames.iter().map(Truth::pairs).collect(),
    backends,
};

pub fn backends(class: Class) -> List<Frame, Answer> {
    let mut list = List(Vec::new());
    phases::library::<phases::Pairs>(&mut list, class);
    phases::textbook::<f32>(&mut list);
    phases::textbook::<f64>(&mut list);
    engines::all(&mut list);
    trees::all(&mut list, class);
    list
}

pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    PAIRS.measure(sizes, rows);
}

pub fn count(sizes: &Sizes) {
    PAIRS.count(sizes);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ours misses nothing and reports nothing twice. The judge checks all of a frame.
    #[test]
    fn ours_tells_each_pair_once() {
        for row in PAIRS.small(|name| name == crate::peers::ours::NAME) {
            assert!(row.get("queries") > Some(0.0));
            assert_eq!((row.get("wrong"), row.get("extra")), (Some(0.0), Some(0.0)), "{row:?}");
        }
    }
}
