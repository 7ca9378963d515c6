//! The emulated core's own count of instructions.
//!
//! Under `-icount shift=8` one instruction takes 256 ns of virtual time. Timers of a Cortex-M count
//! in that time. SysTick runs at 12.5 to 25 MHz, so it moves by 3.2 to 6.4 ticks per instruction. A
//! RISC-V core counts retired instructions itself.

/// A count that changes by a fixed amount per instruction.
pub trait Clock {
    /// Its number of bits.
    const MASK: u32;
    /// Starts it.
    fn start();
    /// Reads it.
    fn now() -> u32;
    /// Ticks between two readings, which must be less than its range apart.
    fn elapsed(from: u32, to: u32) -> u32;
}

#[cfg(target_arch = "arm")]
pub use arm::{Board as Long, SysTick as Short};
#[cfg(target_arch = "riscv32")]
pub use riscv::{Retired as Long, Retired as Short};

#[cfg(target_arch = "arm")]
mod arm {
    use super::Clock;

    /// Every Cortex-M has it. Its 24 bits last for at least 2 600 000 instructions.
    pub struct SysTick;

    const CONTROL: *mut u32 = 0xE000_E010 as *mut u32;
    const RELOAD: *mut u32 = 0xE000_E014 as *mut u32;
    const CURRENT: *mut u32 = 0xE000_E018 as *mut u32;

    impl Clock for SysTick {
        const MASK: u32 = 0x00ff_ffff;

        fn start() {
            // SAFETY: nothing else uses SysTick, and no interrupt is enabled.
            unsafe {
                RELOAD.write_volatile(Self::MASK);
                CURRENT.write_volatile(0);
                CONTROL.write_volatile(0b101);
            }
        }

        #[inline(always)]
        fn now() -> u32 {
            // SAFETY: every Cortex-M board used here has SysTick's current value register. Reading
            // it has no effect.
            unsafe { CURRENT.read_volatile() }
        }

        #[inline(always)]
        fn elapsed(from: u32, to: u32) -> u32 {
            from.wrapping_sub(to) & Self::MASK
        }
    }

    /// A timer of the boards mps2-an385 and mps2-an386. Its 32 bits last for 670 million
    /// instructions.
    pub struct Board;

    const BOARD_CONTROL: *mut u32 = 0x4000_0000 as *mut u32;
    const BOARD_VALUE: *mut u32 = 0x4000_0004 as *mut u32;
    const BOARD_RELOAD: *mut u32 = 0x4000_0008 as *mut u32;

    impl Clock for Board {
        const MASK: u32 = u32::MAX;

        fn start() {
            // SAFETY: nothing else uses this timer, and its interrupt stays off.
            unsafe {
                BOARD_RELOAD.write_volatile(u32::MAX);
                BOARD_VALUE.write_volatile(u32::MAX);
                BOARD_CONTROL.write_volatile(1);
            }
        }

        #[inline(always)]
        fn now() -> u32 {
            // SAFETY: the board has this register. Reading it has no effect.
            unsafe { BOARD_VALUE.read_volatile() }
        }

        #[inline(always)]
        fn elapsed(from: u32, to: u32) -> u32 {
            from.wrapping_sub(to)
        }
    }
}

#[cfg(target_arch = "riscv32")]
mod riscv {
    use super::Clock;
    use core::arch::asm;

    /// The lower half of `minstret`.
    pub struct Retired;

    impl Clock for Retired {
        const MASK: u32 = u32::MAX;

        fn start() {}

        #[inline(always)]
        fn now() -> u32 {
            let count: u32;
            // SAFETY: firmware runs in machine mode, which may read this register. Reading it has
            // no effect.
            unsafe { asm!("csrr {0}, minstret", out(reg) count) };
            count
        }

        #[inline(always)]
        fn elapsed(from: u32, to: u32) -> u32 {
            to.wrapping_sub(from)
        }
    }
}
