//! How much stack a call takes, exactly for what ran: the memory below is painted before it, and
//! read after it.

use crate::measure::Query;
use core::arch::asm;
use core::hint::black_box;
use tilesat_chip::{eprintln, process};

/// Words that are painted below the caller: more than any bound of the table, and less than half of
/// 16 KB.
const WORDS: usize = 1792;
const PAINT: u32 = 0x5a5a_a5a5;

/// Bytes of stack that a query takes, its return address included, its operands and its answer not:
/// they are the caller's.
///
/// A deepest word that happens to be written with the paint's value is missed; with several inputs
/// it is not. A call that goes below all that is painted ends the run: how deep is unknown then.
#[inline(never)]
pub fn depth<A, B, R>(query: Query<A, B, R>, a: &A, b: &B) -> u32 {
    let (query, a, b) = black_box((query, a, b));
    let bottom = paint();
    let answer = query(a, b);
    let bytes = used(bottom);
    black_box(&answer);
    if bytes == 4 * WORDS as u32 {
        eprintln!("a call takes all {bytes} bytes of stack that are painted, or more");
        process::exit(1);
    }
    bytes
}

/// Bytes from the lowest word that is no longer painted up to where the paint began.
#[inline(always)]
fn used(bottom: *const u32) -> u32 {
    let mut i = 0;
    // SAFETY: still below the caller's frame, which has not moved, and inside of RAM; nothing else
    // runs.
    while i < WORDS && unsafe { bottom.add(i).read_volatile() } == PAINT {
        i += 1;
    }
    4 * (WORDS - i) as u32
}

/// Paints what is below the stack pointer; returns the lowest word of it.
#[inline(always)]
fn paint() -> *const u32 {
    let mut at: *const u32;
    // SAFETY: no interrupt is enabled, so memory below the stack pointer belongs to nobody; it is
    // inside of RAM, whose 16 KB are mostly stack.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!(
            "mov {at}, sp",
            "2:",
            "subs {at}, #4",
            "str {paint}, [{at}]",
            "subs {left}, #1",
            "bne 2b",
            at = out(reg) at,
            paint = in(reg) PAINT,
            left = inout(reg) WORDS => _,
        );
    }
    // SAFETY: as above.
    #[cfg(target_arch = "riscv32")]
    unsafe {
        asm!(
            "mv {at}, sp",
            "2:",
            "addi {at}, {at}, -4",
            "sw {paint}, 0({at})",
            "addi {left}, {left}, -1",
            "bnez {left}, 2b",
            at = out(reg) at,
            paint = in(reg) PAINT,
            left = inout(reg) WORDS => _,
        );
    }
    at
}
