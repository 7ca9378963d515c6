//! The rows of a program.

use crate::inputs::{Class, classes};
use core::hint::black_box;
use core::mem::MaybeUninit;
use semihosting::print;
use tilesat_chip::{eprintln, println, process};
use tilesat_counts::clock::Clock;
use tilesat_counts::counter::Counter;

pub type Query<P, O> = fn(&P, &mut MaybeUninit<O>);

/// Ticks of one call. Not inlined, so that no code of the caller moves between the two readings.
#[inline(never)]
fn ticks<C: Clock, P, O>(call: fn(&P, &mut O), input: &P, out: &mut O) -> u32 {
    let (call, input, out) = black_box((call, input, out));
    let from = C::now();
    call(input, out);
    C::elapsed(from, C::now())
}

#[inline(never)]
fn nothing<P, O>(_: &P, out: &mut O) {
    black_box(core::ptr::from_mut(out));
}

#[derive(Default)]
pub(crate) struct Mean {
    sum: u64,
    n: u32,
}

impl Mean {
    pub(crate) fn add(&mut self, count: u32) {
        self.sum += u64::from(count);
        self.n += 1;
    }

    /// With one decimal, after a bar. Empty if there is none.
    fn print(&self) {
        if self.n == 0 {
            print!("|");
        } else {
            let tenths = (self.sum * 10 + u64::from(self.n) / 2) / u64::from(self.n);
            print!("|{}.{}", tenths / 10, tenths % 10);
        }
    }
}

/// Identifies a row within its class: workload, backend and question.
pub type Key = (&'static str, &'static str, &'static str);

/// Counts over the same inputs, by a clock that lasts for a call.
pub struct Table<C> {
    counter: Counter<C>,
    inputs: &'static [u8],
    wrong: bool,
}

impl<C: Clock> Table<C> {
    pub fn start(inputs: &'static [u8]) -> Self {
        Self { counter: Counter::start(), inputs, wrong: false }
    }

    pub fn classes(&self, workload: &'static str) -> impl Iterator<Item = Class> + use<C> {
        classes(self.inputs).filter(move |c| c.workload == workload)
    }

    /// The instructions of a call, minus the call's own.
    pub(crate) fn count<P, O>(&self, call: fn(&P, &mut O), input: &P, out: &mut O) -> u32 {
        let empty = self.counter.instructions(ticks::<C, P, O>(nothing, input, out));
        self.counter.instructions(ticks::<C, P, O>(call, input, out)).saturating_sub(empty)
    }

    pub(crate) fn print(&self, (workload, backend, asked): Key, class: &str, means: [&Mean; 3]) {
        print!("{workload}|{class}|{backend}|{asked}");
        means.into_iter().for_each(Mean::print);
        println!();
    }

    pub(crate) fn refuse(&mut self, (workload, backend, asked): Key, class: &str) {
        eprintln!("{workload}, {class}, {backend}, {asked}: the answers are not the host's");
        self.wrong = true;
    }

    /// One row of every class of the workload. The library must give the host's answers.
    #[inline(never)]
    pub fn row<P, O>(&mut self, key: Key, make: impl Fn(&[i32]) -> P, query: Query<P, O>, hit: fn(&O) -> bool) {
        for class in self.classes(key.0) {
            let (mut all, mut hits, mut misses) = (Mean::default(), Mean::default(), Mean::default());
            let mut right = true;
            for (words, hits_there) in class.queries() {
                let input = make(&words);
                let mut out = MaybeUninit::uninit();
                let n = self.count(query, &input, &mut out);
                all.add(n);
                if hits_there {
                    hits.add(n)
                } else {
                    misses.add(n)
                }
                // SAFETY: a query always stores its answer.
                let answer = unsafe { out.assume_init_ref() };
                right &= hit(answer) == hits_there;
            }
            self.print(key, class.name, [&all, &hits, &misses]);
            if key.1 == "tilesat" && !right {
                self.refuse(key, class.name);
            }
        }
    }

    pub fn end(&self) -> ! {
        process::exit(i32::from(self.wrong))
    }
}
