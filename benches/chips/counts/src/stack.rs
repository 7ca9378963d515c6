//! The stack that a call takes, exactly for this run: it paints the memory below, and reads it
//! afterwards.

use crate::measure::Query;
use core::arch::asm;
use core::hint::black_box;
use tilesat_chip::{eprintln, process};

/// Words to paint below the caller: more than any bound of the table, and less than half of 16 KB.
const WORDS: usize = 1792;
const PAINT: u32 = 0x5a5a_a5a5;

/// Bytes of stack that a query takes, with its return address. Its operands and its answer are the
/// caller's.
///
/// It misses a deepest word that is written with the paint's value. With several inputs it does
/// not. A call that goes below all paint ends the run, because its depth is unknown then.
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

/// Bytes from the lowest changed word up to the start of the paint.
#[inline(always)]
fn used(bottom: *const u32) -> u32 {
    let mut i = 0;
    // SAFETY: still below the caller's frame, which has not moved, and inside RAM. Nothing else
    // runs.
    while i < WORDS && unsafe { bottom.add(i).read_volatile() } == PAINT {
        i += 1;
    }
    4 * (WORDS - i) as u32
}

/// Paints the memory below the stack pointer. Returns its lowest word.
#[inline(always)]
fn paint() -> *const u32 {
    let mut at: *const u32;
    // SAFETY: no interrupt is enabled, so nobody uses memory below the stack pointer. It is inside
    // RAM, whose 16 KB are mostly stack.
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
