//! The platformer's player, boxes and balls on a chip: 600 frames on the level in flash, and the hash of all of them.
//!
//! ```text
//! cargo run --release --example firmware                               this computer
//! cargo run --release --example firmware --target thumbv6m-none-eabi   a Cortex-M0 (micro:bit, emulated)
//! cargo run --release --example firmware --target thumbv7m-none-eabi   a Cortex-M3 (mps2-an385, emulated)
//!   ... thumbv7em-none-eabihf, thumbv8m.main-none-eabihf               a Cortex-M4F, a Cortex-M33 (emulated)
//!   ... riscv32imc-unknown-none-elf, riscv32imac-unknown-none-elf      RISC-V (virt, emulated)
//! cargo firmware-defmt 2> frames.bin                                   with defmt: frames on standard error
//! ```
//!
//! All of them print the same line; `.ci/targets` compares them.

#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points and the logger of a bare-metal program are unsafe by nature")
)]

#[path = "platformer/flash.rs"]
mod flash;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    match flash::run(|_, _| {}) {
        Ok(outcome) => {
            println!("{outcome}");
            std::process::ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("no run: {failure:?}");
            std::process::ExitCode::FAILURE
        }
    }
}

/// For a page or a script: the hash of all frames, 0 where there is no run.
#[cfg(target_arch = "wasm32")]
#[allow(unsafe_code, reason = "a name that the host finds is promised to be the only one")]
#[unsafe(no_mangle)]
pub extern "C" fn firmware_hash() -> u32 {
    flash::run(|_, _| {}).map_or(0, |outcome| outcome.hash)
}

#[cfg(target_os = "none")]
#[path = "chip/fault.rs"]
mod fault;

#[cfg(target_os = "none")]
mod chip {
    #[cfg(target_arch = "arm")]
    use cortex_m_rt::entry;
    #[cfg(target_arch = "riscv32")]
    use riscv_rt::entry;
    use semihosting::{eprintln, println, process};

    #[entry]
    fn main() -> ! {
        match super::flash::run(log) {
            Ok(outcome) => {
                println!("{outcome}");
                process::exit(0)
            }
            Err(failure) => {
                eprintln!("no run: {failure:?}");
                process::exit(1)
            }
        }
    }

    #[cfg(not(feature = "defmt"))]
    fn log(_: u32, _: &super::flash::sim::FrameReport) {}

    #[cfg(feature = "defmt")]
    fn log(frame: u32, report: &super::flash::sim::FrameReport) {
        if frame.is_multiple_of(60) {
            defmt::info!("frame {=u32}: {=u32} contacts", frame, report.contacts);
        }
    }
}

/// defmt's frames go to standard error, so that they and the plain line do not mix.
#[cfg(all(target_os = "none", feature = "defmt"))]
mod frames {
    use semihosting::io::{Write, stderr};

    static mut ENCODER: defmt::Encoder = defmt::Encoder::new();

    #[defmt::global_logger]
    struct Logger;

    fn put(bytes: &[u8]) {
        if let Ok(mut out) = stderr() {
            let _ = out.write_all(bytes);
        }
    }

    fn encoder() -> &'static mut defmt::Encoder {
        let encoder = &raw mut ENCODER;
        // SAFETY: one thread and no interrupt handler that logs; defmt never nests these calls.
        unsafe { &mut *encoder }
    }

    // SAFETY: acquire and release need no lock where nothing can come between them.
    unsafe impl defmt::Logger for Logger {
        fn acquire() {
            encoder().start_frame(put);
        }
        unsafe fn flush() {}
        unsafe fn release() {
            encoder().end_frame(put);
        }
        unsafe fn write(bytes: &[u8]) {
            encoder().write(bytes, put);
        }
    }
}
