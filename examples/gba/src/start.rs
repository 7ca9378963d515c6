//! From the cartridge's header to `main`.

use core::arch::global_asm;

use crate::register::write16;

// The header has 192 bytes: a branch, the maker's logo and a title. An emulator checks only the
// byte 0x96, and the front end writes the checksum. The code sets up two stacks, copies initialised
// data and hot code to fast RAM, and clears memory up to the stack. Then it calls the program, in
// either state of the core.
global_asm!(
    r#"
    .section .header, "ax", %progbits
    .arm
    .global _start
_start:
    b 1f
    .space 156
    .ascii "TILESAT\0\0\0\0\0"
    .ascii "ATSE00"
    .byte 0x96
    .space 13
1:  mov r0, #0x12
    msr cpsr_c, r0
    ldr sp, =0x03007fa0
    mov r0, #0x1f
    msr cpsr_c, r0
    ldr sp, =__stack_top
    ldr r0, =__iwram_load
    ldr r1, =__iwram_start
    ldr r2, =__iwram_end
2:  cmp r1, r2
    ldrlo r3, [r0], #4
    strlo r3, [r1], #4
    blo 2b
    ldr r1, =__bss_start
    mov r2, sp
    mov r3, #0
3:  cmp r1, r2
    strlo r3, [r1], #4
    blo 3b
    ldr r0, =start
    mov lr, pc
    bx r0
4:  b 4b
    .pool
"#
);

const WAITCNT: u32 = 0x0400_0204;

unsafe extern "Rust" {
    safe fn gba_main() -> i32;
}

/// Sets the cartridge to 3 cycles for the first and 1 for each further halfword, with prefetch, as
/// released games do. Then runs the program.
#[unsafe(no_mangle)]
extern "C" fn start() -> ! {
    write16(WAITCNT, 0x4317);
    crate::log::exit(gba_main())
}

/// Makes a function `fn() -> i32` the program; its result is the exit status.
#[macro_export]
macro_rules! entry {
    ($main:path) => {
        #[unsafe(no_mangle)]
        fn gba_main() -> i32 {
            $main()
        }
    };
}
