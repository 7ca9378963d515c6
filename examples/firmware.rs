//! The platformer's player, boxes and balls on a chip, with the level in flash. Prints the hash of
//! 600 frames and of 10 000.
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
//! All of them print the same two lines. `.ci/targets` compares them.

#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    allow(unsafe_code, reason = "entry points of a bare-metal program are unsafe by nature")
)]

use tilesat_games::platformer::{flash, sim};

/// The run of the desktop example by default, and the run of the golden hashes.
const RUNS: [u32; 2] = [sim::FIRMWARE_FRAMES, 10_000];

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    for frames in RUNS {
        match flash::run(frames, |_, _| {}) {
            Ok(outcome) => println!("{outcome}"),
            Err(failure) => {
                eprintln!("no run: {failure:?}");
                return std::process::ExitCode::FAILURE;
            }
        }
    }
    std::process::ExitCode::SUCCESS
}

/// For a page or a script: the hash of this many frames, or 0 without a run.
#[cfg(target_arch = "wasm32")]
#[allow(unsafe_code, reason = "a program exports this name only once")]
#[unsafe(no_mangle)]
pub extern "C" fn firmware_hash(frames: u32) -> u32 {
    flash::run(frames, |_, _| {}).map_or(0, |outcome| outcome.hash)
}

#[cfg(target_os = "none")]
mod chip {
    use tilesat_chip::{entry, eprintln, println, process};

    #[entry]
    fn main() -> ! {
        for frames in super::RUNS {
            // Only the first run is logged: both start with the same frames.
            let logged = frames == super::RUNS[0];
            match super::flash::run(frames, |frame, report| {
                if logged {
                    log(frame, report);
                }
            }) {
                Ok(outcome) => println!("{outcome}"),
                Err(failure) => {
                    eprintln!("no run: {failure:?}");
                    process::exit(1)
                }
            }
        }
        process::exit(0)
    }

    #[cfg(not(feature = "defmt"))]
    fn log(_: u32, _: &super::sim::FrameReport) {}

    #[cfg(feature = "defmt")]
    fn log(frame: u32, report: &super::sim::FrameReport) {
        if frame.is_multiple_of(60) {
            defmt::info!("frame {=u32}: {=u32} contacts", frame, report.contacts);
        }
    }
}
