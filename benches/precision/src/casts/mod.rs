//! The workload of casts: four kinds, four classes.

pub mod backends;
pub mod classes;
pub mod truth;

use crate::each::{self, Judge};
use crate::pairs;
use crate::record::Row;
use crate::run::Sizes;
use classes::{CLASSES, KINDS};
use tilesat_judge::oracle::figure::Kind;
use truth::{Truth, judge};

pub fn name(kinds: (Kind, Kind)) -> String {
    format!("cast: {}", pairs::name(kinds))
}

/// Errors, and the time per call.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for kinds in KINDS {
        let list = backends::all(kinds);
        for class in CLASSES {
            let cases = class.cases(kinds, sizes.casts);
            let judge = Judge { truth: Truth::new, judge };
            each::measure((&name(kinds), class.name()), &list, (&cases, &judge), sizes, rows);
        }
    }
}

/// Instructions per call, under callgrind.
pub fn count(sizes: &Sizes) {
    for kinds in KINDS {
        let list = backends::all(kinds);
        for class in CLASSES {
            each::count((&name(kinds), class.name()), &list, &class.cases(kinds, sizes.counted));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peers::ours::{Shape, vec2};
    use tilesat::prelude::*;
    use tilesat::{Aabb, Circle, Inside, Segment};
    use tilesat_judge::oracle::measure::Measure;

    fn ends_apart<A: Shape + CastShape<B>, B: Shape>(kinds: (Kind, Kind)) {
        for class in CLASSES {
            for case in class.cases(kinds, 2_000) {
                let (a, b) = (A::of(&case.a), B::of(&case.b));
                let Some(hit) = a.cast_shape(&b, vec2(case.d), Inside::Hit).expect("in the domain") else { continue };
                let (x, y) = hit.displacement.raw();
                let moved = case.a.moved((x.into(), y.into()));
                assert!(!Measure::new(&moved, &case.b).overlaps(), "{class:?} {case:?} ends inside");
            }
        }
    }

    #[test]
    fn ours_ends_apart() {
        ends_apart::<Circle, Circle>(KINDS[0]);
        ends_apart::<Circle, Aabb>(KINDS[1]);
        ends_apart::<Circle, Segment>(KINDS[2]);
        ends_apart::<Aabb, Aabb>(KINDS[3]);
    }
}
