//! An exact instruction counter for long runs: like the counter on SysTick, on a timer of mps2-an385 that has 32 bits.

use core::arch::asm;
use core::hint::black_box;

const CONTROL: *mut u32 = 0x4000_0000 as *mut u32;
const VALUE: *mut u32 = 0x4000_0004 as *mut u32;
const RELOAD: *mut u32 = 0x4000_0008 as *mut u32;

/// The timer's count, which falls.
#[inline(always)]
fn now() -> u32 {
    // SAFETY: the board has this register; reading it has no effect.
    unsafe { VALUE.read_volatile() }
}

/// A calibrated counter.
#[derive(Clone, Copy)]
pub struct Timer {
    /// Ticks that 65 536 instructions take.
    ticks: u64,
}

impl Timer {
    /// Starts the timer and calibrates it on a loop of known length.
    pub fn start() -> Self {
        // SAFETY: the only user of this timer; its interrupt stays off.
        unsafe {
            RELOAD.write_volatile(u32::MAX);
            VALUE.write_volatile(u32::MAX);
            CONTROL.write_volatile(1);
        }
        let turns = |n: u32| {
            let from = now();
            // SAFETY: counts a register down.
            unsafe { asm!("2:", "subs {0}, #1", "bne 2b", inout(reg) black_box(n) => _) };
            from.wrapping_sub(now())
        };
        turns(1);
        let one = turns(1);
        Self { ticks: u64::from(turns(1 + 32_768) - one) }
    }

    /// The instructions of a call, up to 160 million, with some of the call's own.
    #[inline(never)]
    pub fn count<R>(&self, call: impl FnOnce() -> R) -> u32 {
        let from = now();
        let answer = call();
        let to = now();
        black_box(answer);
        ((u64::from(from.wrapping_sub(to)) * 65_536 + self.ticks / 2) / self.ticks) as u32
    }
}
