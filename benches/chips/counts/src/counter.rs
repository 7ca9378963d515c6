//! An exact instruction counter for the emulator: a clock, and its ticks per instruction.
//!
//! A known loop gives the divisor, so the code contains no clock rate.

use crate::clock::Clock;
use core::arch::asm;
use core::hint::black_box;
use core::marker::PhantomData;
use tilesat_chip::{eprintln, process};

/// A calibrated counter.
pub struct Counter<C> {
    /// Ticks of 2^20 instructions. One tick more or less is then a quarter of an instruction in a
    /// million.
    ticks: u64,
    clock: PhantomData<C>,
}

impl<C: Clock> Counter<C> {
    /// Starts the clock, calibrates it and tests it. Ends the run if it is wrong.
    pub fn start() -> Self {
        C::start();
        // The emulator settles a timer at its first reading.
        time_two::<C>(black_box(1));
        let one = time_two::<C>(black_box(1));
        let many = time_two::<C>(black_box(1 + (1 << 19)));
        let counter = Self { ticks: u64::from(many - one), clock: PhantomData };
        let wrong = counter.wrong_loops();
        if wrong != 0 {
            eprintln!("the counter is wrong on {wrong} loops of known length");
            process::exit(1);
        }
        counter
    }

    /// Converts ticks to instructions.
    pub fn instructions(&self, ticks: u32) -> u32 {
        (((u64::from(ticks) << 20) + self.ticks / 2) / self.ticks) as u32
    }

    /// The instructions of a call, including some of the call itself.
    #[inline(never)]
    pub fn count<R>(&self, call: impl FnOnce() -> R) -> u32 {
        let from = C::now();
        let answer = call();
        let to = C::now();
        black_box(answer);
        self.instructions(C::elapsed(from, to))
    }

    /// Compares loops of known length with the counter. Returns the number of wrong readings.
    fn wrong_loops(&self) -> u32 {
        let mut wrong = 0;
        let two = self.instructions(time_two::<C>(black_box(1)));
        let five = self.instructions(time_five::<C>(black_box(1)));
        for n in [10, 100, 1_000, 10_000, 60_000] {
            let got = self.instructions(time_two::<C>(black_box(n))) - two;
            wrong += u32::from(got != 2 * (n - 1));
        }
        for n in [10, 100, 1_000, 10_000] {
            let got = self.instructions(time_five::<C>(black_box(n))) - five;
            wrong += u32::from(got != 5 * (n - 1));
        }
        wrong
    }
}

/// Counts a register down: two instructions per turn, plus idle ones.
macro_rules! turns {
    ($turns:expr $(, $idle:literal)*) => {{
        // SAFETY: changes only the register.
        #[cfg(target_arch = "arm")]
        unsafe { asm!("2:", $($idle,)* "subs {0}, #1", "bne 2b", inout(reg) $turns => _) };
        // SAFETY: as above.
        #[cfg(target_arch = "riscv32")]
        unsafe { asm!("2:", $($idle,)* "addi {0}, {0}, -1", "bnez {0}, 2b", inout(reg) $turns => _) };
    }};
}

#[inline(never)]
fn time_two<C: Clock>(turns: u32) -> u32 {
    let from = C::now();
    turns!(turns);
    C::elapsed(from, C::now())
}

#[inline(never)]
fn time_five<C: Clock>(turns: u32) -> u32 {
    let from = C::now();
    turns!(turns, "nop", "nop", "nop");
    C::elapsed(from, C::now())
}

/// A loop of known length, for programs that model cycles.
#[inline(never)]
pub fn known_loop(turns: u32) {
    turns!(turns);
}
