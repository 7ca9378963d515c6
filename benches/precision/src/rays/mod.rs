//! The workload of rays through tiles: three maps, five classes.

pub mod backends;
pub mod classes;
pub mod level;
pub mod trees;
pub mod truth;

use crate::callgrind;
use crate::job::Job;
use crate::record::Row;
use crate::run::{Sizes, time};
use classes::CLASSES;
use level::{Level, MAPS, Map};
use std::rc::Rc;
use truth::{Answer, Truth, judge};

pub fn name(map: Map) -> String {
    format!("rays: {}", map.name())
}

/// Errors, and the time per call.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for map in MAPS {
        let level = Rc::new(Level::new(map));
        let list = backends::all(&level);
        for class in CLASSES {
            let rays = class.rays(&level, sizes.rays);
            eprintln!("{}, {}: {} rays", name(map), class.name(), rays.len());
            let truths: Vec<Truth> = rays.iter().map(|r| Truth::new(&level, r)).collect();
            let from = rows.len();
            let mut jobs: Vec<Box<dyn Job<Answer>>> = Vec::new();
            for backend in &list.0 {
                let mut row = Row::new(&name(map), class.name(), backend.name, backend.asked);
                let job = (backend.make)(&rays);
                judge(&mut row, &truths, &job.answers(), backend.format);
                jobs.push(job);
                rows.push(row);
            }
            time(&mut rows[from..], &mut jobs, 1, sizes);
        }
    }
}

/// Instructions per call, under callgrind.
pub fn count(sizes: &Sizes) {
    for map in MAPS {
        let level = Rc::new(Level::new(map));
        let list = backends::all(&level);
        for class in CLASSES {
            let rays = class.rays(&level, sizes.counted / 4);
            for backend in &list.0 {
                let mut job = (backend.make)(&rays);
                let label = [&name(map), class.name(), backend.name, backend.asked, &rays.len().to_string()].join("|");
                callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::classes::Ray;
    use super::level::CELL;
    use super::*;
    use tilesat_judge::num_bigint::BigInt;
    use tilesat_judge::num_rational::BigRational;

    type Q = BigRational;

    fn q(n: i64) -> Q {
        Q::from_integer(BigInt::from(n))
    }

    /// The time at which a ray enters the closed cell, by clipping.
    fn enters(ray: &Ray, x: i64, y: i64) -> Option<Q> {
        let (mut from, mut to) = (q(0), q(1));
        for (o, d, cell) in [(ray.o.0, ray.d.0, x), (ray.o.1, ray.d.1, y)] {
            let (lo, hi) = (q(cell * CELL - o), q((cell + 1) * CELL - o));
            if d == 0 {
                if lo > q(0) || hi < q(0) {
                    return None;
                }
                continue;
            }
            let (a, b) = (lo / q(d), hi / q(d));
            let (a, b) = if a < b { (a, b) } else { (b, a) };
            from = from.max(a);
            to = to.min(b);
        }
        (from <= to).then_some(from)
    }

    #[test]
    fn closed_truths_are_the_first_of_all_cells() {
        for map in MAPS {
            let level = Level::new(map);
            for class in CLASSES {
                for ray in class.rays(&level, 4) {
                    let first = level.solid_cells().filter_map(|(x, y)| enters(&ray, x, y)).min();
                    let told = Truth::new(&level, &ray);
                    let closed = told.closed.map(|t| q(t.num) / q(t.den));
                    assert_eq!(closed, first, "{map:?} {class:?} {ray:?}");
                    // Entering is not before touching.
                    let open = told.open.map(|t| q(t.num) / q(t.den));
                    assert!(open.is_none() || open >= closed, "{map:?} {class:?} {ray:?}");
                }
            }
        }
    }

    #[test]
    fn ours_is_the_floor_of_the_closed_truth() {
        for map in MAPS {
            let level = Rc::new(Level::new(map));
            let list = backends::all(&level);
            for class in CLASSES {
                let rays = class.rays(&level, 500);
                for backend in list.0.iter().filter(|b| b.name == crate::peers::ours::NAME) {
                    for (ray, answer) in rays.iter().zip((backend.make)(&rays).answers()) {
                        let closed = Truth::new(&level, ray).closed;
                        let floor = closed.map(|t| ((i128::from(t.num) << 30) / i128::from(t.den)) as f64);
                        assert_eq!(answer.map(|t| t * f64::from(1 << 30)), floor, "{} {map:?} {ray:?}", backend.asked);
                    }
                }
            }
        }
    }
}
