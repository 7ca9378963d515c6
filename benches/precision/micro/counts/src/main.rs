//! Prints what the queries cost on this core: a line a workload, class, backend and question, with the mean of all, of hits and of misses.
//!
//! The inputs are the host's. A query is called through a pointer with its operands by reference and stores its answer; an
//! empty call of the same kind is taken off.

#![no_std]
#![no_main]

#[path = "../../../../target/counts/src/counter.rs"]
mod counter;
#[path = "../../queries.rs"]
mod queries;

use core::hint::black_box;
use core::mem::MaybeUninit;
use cortex_m_rt::{ExceptionFrame, entry, exception};
use counter::{Counter, elapsed, now};
use queries::*;
use semihosting::{eprintln, print, println, process};

/// The host's: for each workload and class its name, and pairs of nine words.
static INPUTS: &[u8] = include_bytes!(env!("PRECISION_INPUTS"));

/// What is read of the inputs so far.
struct Reader(&'static [u8]);

impl Reader {
    fn word(&mut self) -> i32 {
        let (word, rest) = self.0.split_first_chunk().expect("the inputs end too early");
        self.0 = rest;
        i32::from_le_bytes(*word)
    }

    fn text(&mut self) -> &'static str {
        let length = self.word() as usize;
        let (text, rest) = self.0.split_at(length);
        self.0 = rest;
        core::str::from_utf8(text).expect("a name")
    }
}

/// The pairs of a class.
struct Class {
    workload: &'static str,
    name: &'static str,
    pairs: &'static [u8],
}

/// Two shapes, and whether they overlap.
struct Pair {
    a: Raw,
    b: Raw,
    overlap: bool,
}

const WORDS: usize = 9;

impl Class {
    fn pairs(&self) -> impl Iterator<Item = Pair> {
        self.pairs.chunks_exact(4 * WORDS).map(|bytes| {
            let mut r = Reader(bytes);
            let mut four = || [r.word(), r.word(), r.word(), r.word()];
            let (a, b) = (four(), four());
            Pair { a, b, overlap: r.word() != 0 }
        })
    }
}

/// All classes of all workloads.
fn classes() -> impl Iterator<Item = Class> {
    let mut r = Reader(INPUTS);
    core::iter::from_fn(move || {
        if r.0.is_empty() {
            return None;
        }
        let (workload, name) = (r.text(), r.text());
        let bytes = r.word() as usize * 4 * WORDS;
        let (pairs, rest) = r.0.split_at(bytes);
        r.0 = rest;
        Some(Class { workload, name, pairs })
    })
}

type Query<P, O> = fn(&P, &mut MaybeUninit<O>);

/// Ticks of one call. Out of line, so that nothing of the caller moves between the two readings.
#[inline(never)]
fn ticks<P, O>(query: Query<P, O>, input: &P, out: &mut MaybeUninit<O>) -> u32 {
    let (query, input, out) = black_box((query, input, out));
    let from = now();
    query(input, out);
    elapsed(from, now())
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

/// One row of every class of the workload; how many of its answers are not the host's.
#[inline(never)]
fn row<A: Shape, B: Shape, O>(
    counter: &Counter,
    (workload, backend, asked): (&str, &str, &str),
    query: Query<(A, B), O>,
    hit: fn(&O) -> bool,
) -> u32 {
    let mut wrong = 0;
    for class in classes().filter(|c| c.workload == workload) {
        let (mut all, mut hits, mut misses) = (Mean::default(), Mean::default(), Mean::default());
        for pair in class.pairs() {
            let input = (A::of(&pair.a), B::of(&pair.b));
            let mut out = MaybeUninit::uninit();
            let empty = counter.instructions(ticks(nothing::<(A, B), O>, &input, &mut out));
            let n = counter.instructions(ticks(query, &input, &mut out)).saturating_sub(empty);
            all.add(n);
            if pair.overlap {
                hits.add(n)
            } else {
                misses.add(n)
            }
            // SAFETY: a query always stores its answer.
            let answer = unsafe { out.assume_init_ref() };
            wrong += u32::from(hit(answer) != pair.overlap);
        }
        print!("{workload}|{}|{backend}|{asked}", class.name);
        [all, hits, misses].iter().for_each(Mean::print);
        println!();
    }
    wrong
}

#[entry]
fn main() -> ! {
    let counter = Counter::start();
    let mut failed = counter.wrong_loops();
    if failed != 0 {
        eprintln!("the counter is wrong on {failed} loops of known length");
        process::exit(1);
    }
    macro_rules! count {
        ($workload:literal, $backend:literal, $asked:literal, $a:ty, $b:ty, $out:ty, |$p:ident| $ask:expr, |$o:ident| $hit:expr) => {{
            let query: Query<($a, $b), $out> = |$p, out| {
                out.write($ask);
            };
            let wrong = row(&counter, ($workload, $backend, $asked), query, |$o| $hit);
            if $backend == "tilesat" && wrong != 0 {
                eprintln!("{} {}: {wrong} answers are not the host's", $workload, $asked);
                failed += wrong;
            }
        }};
    }
    each_query!(count);
    process::exit(i32::from(failed != 0))
}

/// The default handler loops for ever; a fault must end the run.
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    eprintln!("hard fault at {:#010x}", frame.pc());
    process::exit(70)
}
