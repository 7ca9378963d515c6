//! An exact instruction counter for the emulator.
//!
//! Under `-icount shift=10` one instruction takes 1024 ns of virtual time. SysTick runs off that time at 16 MHz (micro:bit)
//! or 25 MHz (mps2), so it moves by 16.4 or 25.6 ticks an instruction, and a difference of ticks divided by that is the
//! number of instructions. A known loop gives the divisor, so no clock rate is written down here.

use core::arch::asm;
use core::hint::black_box;

const CONTROL: *mut u32 = 0xE000_E010 as *mut u32;
const RELOAD: *mut u32 = 0xE000_E014 as *mut u32;
const CURRENT: *mut u32 = 0xE000_E018 as *mut u32;
const MASK: u32 = 0x00ff_ffff;

/// The timer's count, which falls.
#[inline(always)]
pub fn now() -> u32 {
    // SAFETY: SysTick's current value register exists on every Cortex-M board used here; reading it has no effect.
    unsafe { CURRENT.read_volatile() }
}

/// Ticks between two readings less than 2^24 ticks (650 000 instructions) apart.
#[inline(always)]
pub fn elapsed(from: u32, to: u32) -> u32 {
    from.wrapping_sub(to) & MASK
}

/// A calibrated counter.
pub struct Counter {
    /// Ticks that 65 536 instructions take.
    ticks: u64,
}

impl Counter {
    /// Starts the timer and calibrates it.
    pub fn start() -> Self {
        // SAFETY: the only user of SysTick; no interrupt is enabled.
        unsafe {
            RELOAD.write_volatile(MASK);
            CURRENT.write_volatile(0);
            CONTROL.write_volatile(0b101);
        }
        // The emulator settles the timer at its first reading.
        time_two(black_box(1));
        let one = time_two(black_box(1));
        let many = time_two(black_box(1 + 32_768));
        Self { ticks: u64::from(many - one) }
    }

    /// The instructions that took so many ticks.
    pub fn instructions(&self, ticks: u32) -> u32 {
        ((u64::from(ticks) * 65_536 + self.ticks / 2) / self.ticks) as u32
    }

    /// Compares loops of known length with what the counter says: the number of wrong readings.
    pub fn wrong_loops(&self) -> u32 {
        let mut wrong = 0;
        let two = self.instructions(time_two(black_box(1)));
        let five = self.instructions(time_five(black_box(1)));
        for n in [10, 100, 1_000, 10_000, 60_000] {
            let got = self.instructions(time_two(black_box(n))) - two;
            wrong += u32::from(got != 2 * (n - 1));
        }
        for n in [10, 100, 1_000, 10_000] {
            let got = self.instructions(time_five(black_box(n))) - five;
            wrong += u32::from(got != 5 * (n - 1));
        }
        wrong
    }
}

#[inline(never)]
fn time_two(turns: u32) -> u32 {
    let from = now();
    // SAFETY: counts a register down.
    unsafe { asm!("2:", "subs {0}, #1", "bne 2b", inout(reg) turns => _) };
    elapsed(from, now())
}

#[inline(never)]
fn time_five(turns: u32) -> u32 {
    let from = now();
    // SAFETY: counts a register down.
    unsafe { asm!("2:", "nop", "nop", "nop", "subs {0}, #1", "bne 2b", inout(reg) turns => _) };
    elapsed(from, now())
}
