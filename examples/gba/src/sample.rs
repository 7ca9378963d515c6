//! Samples the program counter while the bodies move, with the feature `profile` only. An interrupt
//! of the third timer stores it every 499 cycles, in memory that nothing else uses.

use crate::println;
use crate::register::{read32, write16, write32};

const BUFFER: u32 = 0x0200_0000;
/// The handler stores no more.
const MOST: u32 = 60_000;

const TIMER: u32 = 0x0400_0108;
/// Runs, and interrupts when it overflows.
const RUN: u16 = 0xc0;
const PERIOD: u16 = 499;
/// Which interrupts are enabled, and whether any is.
const ENABLED: u32 = 0x0400_0200;
const MASTER: u32 = 0x0400_0208;
const TIMER_2: u16 = 1 << 5;
/// The BIOS calls the function at this address. It has pushed six registers, the last of which is
/// where the program goes on.
const HANDLER: u32 = 0x0300_7ffc;

#[cfg(feature = "profile")]
core::arch::global_asm!(
    r#"
    .section .text.sampler, "ax", %progbits
    .arm
    .global sampler
sampler:
    mov r0, #0x02000000
    ldr r1, [r0]
    ldr r2, ={most}
    cmp r1, r2
    addlo r1, r1, #1
    strlo r1, [r0]
    ldrlo r3, [sp, #20]
    strlo r3, [r0, r1, lsl #2]
    mov r0, #0x04000000
    add r0, r0, #0x200
    mov r1, #{timer}
    strh r1, [r0, #2]
    bx lr
    .pool
"#,
    most = const MOST,
    timer = const TIMER_2,
);

#[cfg(feature = "profile")]
fn handler() -> u32 {
    unsafe extern "C" {
        fn sampler();
    }
    sampler as *const () as usize as u32
}

#[cfg(not(feature = "profile"))]
const fn handler() -> u32 {
    0
}

/// Goes on sampling, if this program does.
pub fn resume() {
    if cfg!(feature = "profile") {
        write32(HANDLER, handler());
        write16(ENABLED, TIMER_2);
        write16(MASTER, 1);
        write16(TIMER, PERIOD.wrapping_neg());
        write16(TIMER + 2, RUN);
    }
}

/// Stops for now.
pub fn pause() {
    if cfg!(feature = "profile") {
        write16(TIMER + 2, 0);
    }
}

/// Prints all samples, one per line: four bytes past the instruction that was next.
pub fn print() {
    if cfg!(feature = "profile") {
        for i in 1..=read32(BUFFER).min(MOST) {
            println!("PC {:x}", read32(BUFFER + 4 * i));
        }
    }
}
