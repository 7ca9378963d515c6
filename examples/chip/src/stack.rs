//! How much of the stack a whole program leaves: it paints what is free at the start, and looks at
//! what is still painted at the end.

use core::arch::asm;

const PAINT: u32 = 0x5a5a_a5a5;

unsafe extern "C" {
    /// Where cortex-m-rt's statics end: the stack grows down to it.
    static mut __sheap: u32;
}

/// Paints all memory between the statics and the stack. Call it first.
#[inline(never)]
pub fn paint() {
    let sp: *mut u32;
    // SAFETY: it only reads a register.
    unsafe { asm!("mov {sp}, sp", sp = out(reg) sp, options(nomem, nostack)) };
    let mut at = &raw mut __sheap;
    // SAFETY: between the statics and the stack pointer nobody has anything. There are no
    // interrupts.
    unsafe {
        while at < sp {
            at.write_volatile(PAINT);
            at = at.add(1);
        }
    }
}

/// How many bytes the stack has not come to since [`paint`].
///
/// Words that a function reserved and never wrote count as free, and so does a word that has the
/// paint's value. Both are few beside a margin of some hundred bytes.
#[must_use]
#[inline(never)]
pub fn left() -> usize {
    let sp: *mut u32;
    // SAFETY: as above.
    unsafe { asm!("mov {sp}, sp", sp = out(reg) sp, options(nomem, nostack)) };
    let start = &raw mut __sheap;
    let mut at = start;
    // SAFETY: as above.
    unsafe {
        while at < sp && at.read_volatile() == PAINT {
            at = at.add(1);
        }
    }
    at.addr() - start.addr()
}
