//! One row of the table: a query over a fixed set of inputs.
//!
//! Calls a query through a pointer with its operands by reference, so that the compiler inlines and
//! folds nothing. *By reference* is that call minus an empty call of the same signature. *Kernel*
//! is that call minus a call that only loads the operand words that the query needs in that class.
//! So it is the count with operands in registers.

use crate::CORE;
use crate::clock::{Clock, Short};
use crate::counter::{Counter, known_loop};
use crate::inputs::Random;
use crate::span::Span;
use crate::stack::depth;
use core::arch::asm;
use core::fmt;
use core::hint::black_box;
use core::mem::MaybeUninit;
use tilesat_chip::{eprintln, println, process};

/// A query on two operands. The wrapper gives the empty call and the loads the same type as the
/// query.
pub type Query<A, B, R> = fn(&A, &B) -> MaybeUninit<R>;

/// Inputs per row.
const INPUTS: u32 = 64;

/// Budget of kernel instructions on a Cortex-M0 and on a Cortex-M3.
pub type Budget = Option<(u32, u32)>;

/// An instruction without effect. It marks the start and the end of a call for the emulator's
/// plugin, which models its cycles.
macro_rules! mark {
    ($instruction:literal) => {
        // SAFETY: changes nothing.
        #[cfg(target_arch = "arm")]
        unsafe {
            asm!($instruction, options(nostack, preserves_flags))
        }
    };
}

/// Prints one line of the table.
pub fn tell(section: &str, name: impl fmt::Display, value: impl fmt::Display, budget: Budget) {
    let (m0, m3) = budget.unwrap_or_default();
    let limit = match CORE {
        "M0" => m0,
        "M3" => m3,
        _ => 0,
    };
    println!("{CORE}|{section}|{name}|{value}|{limit}");
}

/// Measures and prints rows.
pub struct Table {
    pub counter: Counter<Short>,
    random: Random,
    /// Rows whose inputs were not of the class that they claim.
    pub wrong: u32,
}

impl Table {
    /// Adds a row of two instructions per turn, which checks that counts and model are complete.
    pub fn start() -> Self {
        let mut table = Self { counter: Counter::start(), random: Random::new(1), wrong: 0 };
        let turns: Query<u32, u32, ()> = |many, _| {
            known_loop(*many);
            MaybeUninit::uninit()
        };
        let one: Query<u32, u32, ()> = |_, one| {
            known_loop(*one);
            MaybeUninit::uninit()
        };
        table.row(
            "a loop of two instructions, 1000 turns more",
            None,
            turns,
            |_, _| one,
            |_| Some((1001, 1)),
            |()| true,
        );
        table
    }

    /// Ends the run. It fails if a row's inputs were not of its class.
    pub fn end(&self) -> ! {
        process::exit(i32::from(self.wrong != 0))
    }

    /// Measures one row. `next` makes an input of the class, `loads` is its baseline, and `expect`
    /// checks that the answer fits the class.
    pub fn row<A, B, R>(
        &mut self,
        name: &str,
        budget: Budget,
        query: Query<A, B, R>,
        loads: impl Fn(&A, &B) -> Query<A, B, R>,
        mut next: impl FnMut(&mut Random) -> Option<(A, B)>,
        expect: impl Fn(&R) -> bool,
    ) {
        let (mut kernel, mut api) = (Span::EMPTY, Span::EMPTY);
        let (mut wrong, mut stack) = (false, 0);
        // Rows do not depend on each other: a new row does not change the others' inputs.
        self.random = Random::new(1);
        while api.len() < INPUTS {
            let Some((a, b)) = next(&mut self.random) else { continue };
            let counts = sample(&self.counter, query, loads(&a, &b), &a, &b);
            kernel.add(counts.0);
            api.add(counts.1);
            stack = stack.max(depth(query, &a, &b));
            // SAFETY: a query always writes its answer. Only the baselines do not.
            let answer = unsafe { query(&a, &b).assume_init() };
            wrong |= !expect(&answer);
        }
        self.print(name, wrong, budget, &[kernel, api], stack);
    }

    /// A separate function: the measurement is compiled once per row.
    #[inline(never)]
    fn print(&mut self, name: &str, wrong: bool, budget: Budget, [kernel, api]: &[Span; 2], stack: u32) {
        if wrong {
            self.wrong += 1;
            eprintln!("{name}: some inputs are not of this class");
        }
        tell("kernel", name, kernel, budget);
        tell("reference", name, api, None);
        tell("stack", name, stack, None);
    }
}

/// Instructions of one call: minus the call with loads, and minus an empty call. `query` runs once.
pub fn sample<A, B, R>(
    counter: &Counter<Short>,
    query: Query<A, B, R>,
    loads: Query<A, B, R>,
    a: &A,
    b: &B,
) -> (u32, u32) {
    let call = counter.instructions(ticks(query, a, b));
    let empty = counter.instructions(ticks(nothing::<A, B, R>, a, b));
    let load = counter.instructions(ticks(loads, a, b));
    (call.saturating_sub(load), call - empty)
}

/// Ticks of one call. Not inlined, so that no code of the caller moves between the two readings.
#[inline(never)]
fn ticks<A, B, R>(query: Query<A, B, R>, a: &A, b: &B) -> u32 {
    let (query, a, b) = black_box((query, a, b));
    let from = Short::now();
    mark!("mov r9, r9");
    let answer = query(a, b);
    mark!("mov r10, r10");
    let to = Short::now();
    black_box(&answer);
    Short::elapsed(from, to)
}

/// The empty call.
#[inline(never)]
pub fn nothing<A, B, R>(_: &A, _: &B) -> MaybeUninit<R> {
    // SAFETY: no instruction at all. It only keeps the call.
    unsafe { asm!("", options(nomem, nostack, preserves_flags)) };
    MaybeUninit::uninit()
}

/// A call that loads the first `NA` words of A and the first `NB` of B, in any way that the
/// compiler likes.
#[inline(never)]
pub fn load<A, B, R, const NA: usize, const NB: usize>(a: &A, b: &B) -> MaybeUninit<R> {
    const {
        assert!(4 * NA <= size_of::<A>() && 4 * NB <= size_of::<B>());
        assert!(NA == 0 || align_of::<A>() >= 4);
        assert!(NB == 0 || align_of::<B>() >= 4);
    }
    // SAFETY: the assertions check that it stays inside both aligned operands. The rows' operands
    // have no padding.
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
    // SAFETY: the caller guarantees N words at p. The empty instructions only hold the values.
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
