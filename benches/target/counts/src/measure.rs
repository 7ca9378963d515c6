//! One row of the table: a query over a fixed set of inputs.
//!
//! A query is called through a pointer with its operands by reference, so that nothing is inlined or folded.
//! *API* is that call minus an empty call of the same signature. *Kernel* is that call minus a call which does nothing but
//! load the operand words that the query needs in that class: the count with operands in registers.

use crate::counter::{Counter, elapsed, now};
use crate::inputs::Random;
use crate::stack::depth;
use core::arch::asm;
use core::fmt;
use core::hint::black_box;
use core::mem::MaybeUninit;
use semihosting::{eprintln, println};

/// A query on two operands. The wrapper makes the empty call and the loads the same type as the query.
pub type Query<A, B, R> = fn(&A, &B) -> MaybeUninit<R>;

/// The core that this firmware is built for.
pub const CORE: &str = env!("CORE");

/// How many inputs a row is measured on.
const INPUTS: u32 = 64;

/// Kernel instructions that a row may take on a Cortex-M0 and on a Cortex-M3.
pub type Budget = Option<(u32, u32)>;

/// Measures and prints rows.
pub struct Table {
    pub counter: Counter,
    random: Random,
    /// Rows whose inputs were not of the class that they claim.
    pub wrong: u32,
}

impl Table {
    pub fn new(counter: Counter) -> Self {
        Self { counter, random: Random::new(1), wrong: 0 }
    }

    /// One row: `next` makes an input of the class, `loads` is the baseline for it, `expect` tells whether the answer is the class's.
    pub fn row<A, B, R>(
        &mut self,
        name: &str,
        budget: Budget,
        query: Query<A, B, R>,
        loads: impl Fn(&A, &B) -> Query<A, B, R>,
        mut next: impl FnMut(&mut Random) -> Option<(A, B)>,
        expect: impl Fn(&R) -> bool,
    ) {
        let (mut kernel, mut api) = (Span::new(), Span::new());
        let (mut wrong, mut stack) = (false, 0);
        // Rows do not depend on each other: adding one leaves the others' inputs as they were.
        self.random = Random::new(1);
        while api.n < INPUTS {
            let Some((a, b)) = next(&mut self.random) else { continue };
            let call = self.counter.instructions(ticks(query, &a, &b));
            let empty = self.counter.instructions(ticks(nothing::<A, B, R>, &a, &b));
            let load = self.counter.instructions(ticks(loads(&a, &b), &a, &b));
            api.add(call - empty);
            kernel.add(call.saturating_sub(load));
            stack = stack.max(depth(query, &a, &b));
            // SAFETY: a query always writes its answer; only the baselines do not.
            let answer = unsafe { query(&a, &b).assume_init() };
            wrong |= !expect(&answer);
        }
        self.tell(name, wrong, budget, &[kernel, api], stack);
    }

    /// Apart from the measurement, which is compiled once a row.
    #[inline(never)]
    fn tell(&mut self, name: &str, wrong: bool, budget: Budget, [kernel, api]: &[Span; 2], stack: u32) {
        if wrong {
            self.wrong += 1;
            eprintln!("{name}: some inputs are not of this class");
        }
        let (m0, m3) = budget.unwrap_or_default();
        let limit = if CORE == "M0" { m0 } else { m3 };
        println!("{CORE}|{name}|{kernel}|{api}|{limit}");
        println!("{CORE} stack|{name}|{stack}|{stack}|0");
    }
}

/// Ticks of one call. Out of line, so that nothing of the caller moves between the two readings.
#[inline(never)]
fn ticks<A, B, R>(query: Query<A, B, R>, a: &A, b: &B) -> u32 {
    let (query, a, b) = black_box((query, a, b));
    let from = now();
    let answer = query(a, b);
    let to = now();
    black_box(&answer);
    elapsed(from, to)
}

/// The empty call.
#[inline(never)]
fn nothing<A, B, R>(_: &A, _: &B) -> MaybeUninit<R> {
    // SAFETY: no instruction at all; it only keeps the call.
    unsafe { asm!("", options(nomem, nostack, preserves_flags)) };
    MaybeUninit::uninit()
}

/// A call that loads the first `NA` words of A and the first `NB` of B, however the compiler likes to.
#[inline(never)]
pub fn load<A, B, R, const NA: usize, const NB: usize>(a: &A, b: &B) -> MaybeUninit<R> {
    const {
        assert!(4 * NA <= size_of::<A>() && 4 * NB <= size_of::<B>());
        assert!(NA == 0 || align_of::<A>() >= 4);
        assert!(NB == 0 || align_of::<B>() >= 4);
    }
    // SAFETY: inside both operands and aligned, by the assertions; the operands of the rows have no padding.
    unsafe {
        words::<NA>(core::ptr::from_ref(a).cast());
        words::<NB>(core::ptr::from_ref(b).cast());
    }
    MaybeUninit::uninit()
}

/// Loads `N` words, four at a time so that they fit the low registers of a Cortex-M0.
#[inline(always)]
unsafe fn words<const N: usize>(p: *const u32) {
    let mut i = 0;
    // SAFETY: the caller vouches for N words at p; the empty instructions only hold the values.
    unsafe {
        while i + 4 <= N {
            let (a, b, c, d) = (p.add(i).read(), p.add(i + 1).read(), p.add(i + 2).read(), p.add(i + 3).read());
            asm!("/* {0} {1} {2} {3} */", in(reg) a, in(reg) b, in(reg) c, in(reg) d, options(nomem, nostack, preserves_flags));
            i += 4;
        }
        while i < N {
            let a = p.add(i).read();
            asm!("/* {0} */", in(reg) a, options(nomem, nostack, preserves_flags));
            i += 1;
        }
    }
}

/// Mean and range.
struct Span {
    n: u32,
    sum: u32,
    min: u32,
    max: u32,
}

impl Span {
    fn new() -> Self {
        Self { n: 0, sum: 0, min: u32::MAX, max: 0 }
    }

    fn add(&mut self, count: u32) {
        self.n += 1;
        self.sum += count;
        self.min = self.min.min(count);
        self.max = self.max.max(count);
    }
}

impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tenths = (self.sum * 10 + self.n / 2) / self.n;
        write!(f, "{}.{} ({}..{})", tenths / 10, tenths % 10, self.min, self.max)
    }
}
