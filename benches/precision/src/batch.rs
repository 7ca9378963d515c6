//! One shape against 10 000: a loop over a slice, and columns of coordinates, which compilers test
//! several at a time.
//!
//! The library has columns of boxes only. Those of circles are a trial, to show what they would
//! gain.

use crate::callgrind;
use crate::job::Job;
use crate::peers::ours::{self, Shape};
use crate::peers::textbook::Shape as Book;
use crate::record::Row;
use crate::run::{Sizes, time};
use std::fmt::Write;
use std::hint::black_box;
use tilesat::prelude::*;
use tilesat::query::BoxColumns;
use tilesat::{Aabb, Circle};
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::Figure;
use tilesat_judge::oracle::generate::UNIT;
use tilesat_textbook::{pair, shape};

pub const NAME: &str = "one against many";
const MANY: usize = 10_000;
/// Places of a block of columns.
const BLOCK: usize = 64;

/// Answers for all shapes. No input is hidden from the compiler.
struct Loop<F> {
    ask: F,
    answers: Vec<bool>,
}

impl<F: FnMut(&mut [bool])> Job<bool> for Loop<F> {
    #[inline(never)]
    fn pass(&mut self) {
        (self.ask)(&mut self.answers);
        black_box(&self.answers);
    }

    fn answers(&self) -> Vec<bool> {
        self.answers.clone()
    }

    fn len(&self) -> usize {
        1
    }
}

type Named = (&'static str, &'static str, &'static str, Box<dyn Job<bool>>);

/// A loop over a slice.
fn slice<B: 'static>(many: Vec<B>, ask: impl Fn(&B) -> bool + 'static) -> Box<dyn Job<bool>> {
    let all = move |out: &mut [bool]| many.iter().zip(out).for_each(|(b, out)| *out = ask(b));
    Box::new(Loop { ask: all, answers: vec![false; MANY] })
}

/// A loop over four columns, one value of each per shape.
fn columns<T: Copy + 'static>(many: [Vec<T>; 4], ask: impl Fn(T, T, T, T) -> bool + 'static) -> Box<dyn Job<bool>> {
    let all = move |out: &mut [bool]| {
        let [a, b, c, d] = &many;
        for ((out, (&a, &b)), (&c, &d)) in out.iter_mut().zip(a.iter().zip(b)).zip(c.iter().zip(d)) {
            *out = ask(a, b, c, d);
        }
    };
    Box::new(Loop { ask: all, answers: vec![false; MANY] })
}

/// Shapes of 2 to 16 pixels from the middle to a side, within 64 pixels of the origin. The first is
/// asked about all.
fn figures(round: bool) -> Vec<Figure> {
    let mut r = Random::new(0xba7c);
    let figure = |r: &mut Random| {
        let (c, w, h) = ((r.around(64 * UNIT), r.around(64 * UNIT)), r.within(2, 16) * UNIT, r.within(2, 16) * UNIT);
        if round {
            Figure::Circle { centre: c, radius: w }
        } else {
            Figure::Aabb { min: (c.0 - w, c.1 - h), max: (c.0 + w, c.1 + h) }
        }
    };
    (0..MANY).map(|_| figure(&mut r)).collect()
}

fn jobs() -> Vec<Named> {
    let (boxes, circles) = (figures(false), figures(true));
    let (b, c) = (Aabb::of(&boxes[0]), Circle::of(&circles[0]));
    let all: Vec<Aabb> = boxes.iter().map(Aabb::of).collect();
    let round: Vec<Circle> = circles.iter().map(Circle::of).collect();
    let blocks: Vec<_> = all.chunks(BLOCK).map(|b| BoxColumns::<BLOCK>::of(b).expect("as many places")).collect();
    let in_blocks = move |out: &mut [bool]| {
        for (block, out) in blocks.iter().zip(out.chunks_mut(BLOCK)) {
            out.copy_from_slice(&block.overlaps(&b)[..out.len()]);
        }
    };
    let column = |f: &dyn Fn(&Figure) -> (i64, i64, i64), all: &[Figure]| {
        let of = |n: usize| all.iter().map(|g| [f(g).0 as i32, f(g).1 as i32, f(g).2 as i32][n]).collect::<Vec<_>>();
        [of(0), of(1), of(2), of(2)]
    };
    let centres = |f: &Figure| match *f {
        Figure::Circle { centre, radius } => (centre.0, centre.1, radius),
        _ => unreachable!("circles only"),
    };
    let ((x, y), r) = (c.centre().raw(), c.radius().to_bits());
    let in_circle = move |bx: i32, by: i32, br: i32, _| {
        let square = |v: i32| u64::from(v.unsigned_abs()) * u64::from(v.unsigned_abs());
        square(x - bx) + square(y - by) < square(r + br)
    };
    let mut jobs: Vec<Named> = vec![
        ("one box and boxes", ours::NAME, "slice", slice(all, move |o| b.overlaps(o))),
        ("one box and boxes", ours::NAME, "columns", Box::new(Loop { ask: in_blocks, answers: vec![false; MANY] })),
        ("one circle and circles", ours::NAME, "slice", slice(round, move |o| c.overlaps(o))),
        ("one circle and circles", ours::NAME, "columns (trial)", columns(column(&centres, &circles), in_circle)),
    ];
    textbook::<f32>("textbook f32", &mut jobs, &boxes, &circles);
    textbook::<f64>("textbook f64", &mut jobs, &boxes, &circles);
    jobs
}

fn textbook<S: crate::peers::textbook::Named>(
    name: &'static str,
    jobs: &mut Vec<Named>,
    boxes: &[Figure],
    circles: &[Figure],
) {
    let all: Vec<shape::Aabb<S>> = boxes.iter().map(Book::of).collect();
    let round: Vec<shape::Circle<S>> = circles.iter().map(Book::of).collect();
    let (b, c) = (all[0], round[0]);
    let of = |f: fn(&shape::Aabb<S>) -> S| all.iter().map(f).collect::<Vec<_>>();
    let sides = [of(|b| b.lo.x), of(|b| b.lo.y), of(|b| b.hi.x), of(|b| b.hi.y)];
    let in_box = move |x0, y0, x1, y1| (x0 < b.hi.x) & (b.lo.x < x1) & (y0 < b.hi.y) & (b.lo.y < y1);
    jobs.push(("one box and boxes", name, "slice", slice(all, move |o| pair::aabb_aabb(&b, o))));
    jobs.push(("one box and boxes", name, "columns (trial)", columns(sides, in_box)));
    jobs.push(("one circle and circles", name, "slice", slice(round, move |o| pair::circle_circle(&c, o))));
}

fn row(job: &Named) -> Row {
    Row::new(NAME, job.0, job.1, job.2)
}

/// The time per shape.
///
/// # Panics
/// If columns answer unlike the slice.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    let mut named = jobs();
    for job in &mut named {
        job.3.pass();
    }
    let slice = |class| named.iter().find(|j| (j.0, j.1, j.2) == (class, ours::NAME, "slice")).map(|j| j.3.answers());
    assert!(named.iter().all(|j| j.1 != ours::NAME || slice(j.0) == Some(j.3.answers())), "columns differ");
    let from = rows.len();
    rows.extend(named.iter().map(row));
    let mut jobs: Vec<_> = named.into_iter().map(|job| job.3).collect();
    time(&mut rows[from..], &mut jobs, MANY, sizes);
}

/// Instructions per shape, under callgrind.
pub fn count(_: &Sizes) {
    for mut job in jobs() {
        let label = [&row(&job).key[..].join("|"), MANY.to_string().as_str()].join("|");
        callgrind::instrumented(|| callgrind::count(&label, || job.3.pass()));
    }
}

/// A section of the page.
pub fn page(rows: &[Row]) -> String {
    let mut out = String::from(HEAD);
    let all: Vec<&Row> = rows.iter().filter(|r| r.workload() == NAME).collect();
    for class in ["one box and boxes", "one circle and circles"] {
        for form in ["slice", "columns"] {
            let cells = [ours::NAME, "textbook f32", "textbook f64"].map(|backend| {
                let is = |r: &&&Row| (r.class(), r.backend()) == (class, backend) && r.asked().starts_with(form);
                let told = all.iter().find(is).and_then(|r| Some((r.get("host")?, r.asked())));
                told.map_or_else(String::new, |(n, asked)| format!("{n:.2}{}", &asked[form.len()..]))
            });
            let _ = writeln!(out, "| {class}, {form} | {} |", cells.join(" | "));
        }
    }
    out
}

const HEAD: &str = "
## One call for many

Instructions per shape, of one against 10 000: a loop over a slice that the compiler sees whole, and
columns of coordinates. tilesat's columns are `query::BoxColumns`, in blocks of 64. A trial is this
benchmark's own code. Circles gain too little in columns for a type. In f32 they take half of ours.
Casts and moves take another path for each body, so a call for 10 000 would be the same loop.
Threads share a level without locks: `run.sh --threads` prints what they add.

| | tilesat | textbook f32 | textbook f64 |
|---|--:|--:|--:|
";
