//! The rows of a program.

use crate::clock::{Clock, Short};
use crate::counter::Counter;
use crate::inputs::classes;
use core::hint::black_box;
use core::mem::MaybeUninit;
use semihosting::{eprintln, print, println, process};

pub type Query<P, O> = fn(&P, &mut MaybeUninit<O>);

/// Ticks of one call. Out of line, so that nothing of the caller moves between the two readings.
#[inline(never)]
fn ticks<P, O>(query: Query<P, O>, input: &P, out: &mut MaybeUninit<O>) -> u32 {
    let (query, input, out) = black_box((query, input, out));
    let from = Short::now();
    query(input, out);
    Short::elapsed(from, Short::now())
}

#[inline(never)]
fn nothing<P, O>(_: &P, out: &mut MaybeUninit<O>) {
    black_box(out.as_mut_ptr());
}

#[derive(Default)]
struct Mean {
    sum: u32,
    n: u32,
}

impl Mean {
    fn add(&mut self, count: u32) {
        self.sum += count;
        self.n += 1;
    }

    /// With one decimal, after a bar; nothing where there was nothing.
    fn print(&self) {
        if self.n == 0 {
            print!("|");
        } else {
            let tenths = (u64::from(self.sum) * 10 + u64::from(self.n) / 2) / u64::from(self.n);
            print!("|{}.{}", tenths / 10, tenths % 10);
        }
    }
}

/// Counts over the same inputs.
pub struct Table {
    counter: Counter<Short>,
    inputs: &'static [u8],
    wrong: u32,
}

impl Table {
    pub fn start(inputs: &'static [u8]) -> Self {
        Self { counter: Counter::start(), inputs, wrong: 0 }
    }

    /// One row of every class of the workload. The library's answers have to be the host's.
    #[inline(never)]
    pub fn row<P, O>(
        &mut self,
        (workload, backend, asked): (&str, &str, &str),
        make: impl Fn(&[i32]) -> P,
        query: Query<P, O>,
        hit: fn(&O) -> bool,
    ) {
        let mut wrong = 0;
        for class in classes(self.inputs).filter(|c| c.workload == workload) {
            let (mut all, mut hits, mut misses) = (Mean::default(), Mean::default(), Mean::default());
            for (words, hits_there) in class.records() {
                let input = make(&words);
                let mut out = MaybeUninit::uninit();
                let empty = self.counter.instructions(ticks(nothing::<P, O>, &input, &mut out));
                let n = self.counter.instructions(ticks(query, &input, &mut out)).saturating_sub(empty);
                all.add(n);
                if hits_there {
                    hits.add(n)
                } else {
                    misses.add(n)
                }
                // SAFETY: a query always stores its answer.
                let answer = unsafe { out.assume_init_ref() };
                wrong += u32::from(hit(answer) != hits_there);
            }
            print!("{workload}|{}|{backend}|{asked}", class.name);
            [all, hits, misses].iter().for_each(Mean::print);
            println!();
        }
        if backend == "tilesat" && wrong != 0 {
            eprintln!("{workload} {asked}: {wrong} answers are not the host's");
            self.wrong += wrong;
        }
    }

    pub fn end(&self) -> ! {
        process::exit(i32::from(self.wrong != 0))
    }
}
