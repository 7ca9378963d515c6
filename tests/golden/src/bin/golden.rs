//! Golden hashes: every public query over fixed vectors, and ten thousand frames of three games,
//! the same bits on every target.
//!
//! ```text
//! cargo run --release -p tilesat-golden                  on this computer: a line for each query and each kind of shape or level,
//!                                                        QUERY OF VECTORS HASH; exit 1 where one is not in tests/golden/hashes.txt
//! cargo run --release -p tilesat-golden -- 10000         no more than so many vectors of each
//! cargo run --release -p tilesat-golden -- --accept      writes that table, and prints the changelog's list of outputs
//! cargo run --release -p tilesat-golden --features chip --bin golden_shapes --target thumbv6m-none-eabi [-- 10000]
//!                                                        on a chip (emulated), in thirteen parts:
//!   ... golden_bodies, golden_scenes, golden_levels, golden_segments, golden_joined, golden_moving, golden_blocks,
//!       golden_motion, golden_capsules, golden_turned, golden_convex, golden_ninja;
//!                                                        also firmware and bullets_firmware
//! .ci/targets                                            all that, on all targets
//! ```
#![allow(clippy::std_instead_of_core, reason = "files and strings, on a computer")]

use std::path::Path;
use std::process::ExitCode;

use tilesat_golden::table::{PATH, Table, VERSION};
use tilesat_golden::{LEAST, VECTORS};

/// For a page or a script: runs everything with at most this many vectors. Passes each line as text
/// to the import `golden.line`.
#[cfg(target_arch = "wasm32")]
#[allow(unsafe_code, reason = "names that the host finds, and a function that it has")]
mod page {
    use tilesat_golden::table::Table;

    #[link(wasm_import_module = "golden")]
    unsafe extern "C" {
        fn line(text: *const u8, length: usize);
    }

    #[unsafe(no_mangle)]
    pub extern "C" fn golden(count: u32) {
        Table::fresh(count, |found| {
            let text = found.to_string();
            // SAFETY: the host reads this many bytes there, and keeps no reference.
            unsafe { line(text.as_ptr(), text.len()) }
        });
    }
}

fn main() -> ExitCode {
    let (mut count, mut accept) = (VECTORS, false);
    for word in std::env::args().skip(1) {
        match word.parse() {
            Ok(number) if number >= LEAST => count = number,
            Err(_) if word == "--accept" => accept = true,
            _ => {
                eprintln!("golden [VECTORS] [--accept], at least {LEAST} vectors: before that no query has a hash");
                return ExitCode::from(2);
            }
        }
    }
    match run(count, accept) {
        Ok(status) => status,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(count: u32, accept: bool) -> Result<ExitCode, std::io::Error> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("hashes.txt");
    let reviewed = Table::parse(&std::fs::read_to_string(&path).unwrap_or_default()).unwrap_or_default();
    if !accept {
        let differences = Table::fresh(count, |line| println!("{line}")).differences(&reviewed);
        for family in &differences {
            eprintln!("DIFFERENT: {family}");
        }
        return Ok(if differences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    let fresh = Table::fresh(VECTORS, |_| {}).dated(&reviewed);
    std::fs::write(&path, fresh.text())?;
    for line in fresh.outputs(VERSION) {
        println!("{line}");
    }
    for family in fresh.differences(&reviewed) {
        eprintln!("accepted: {family}");
    }
    eprintln!("{PATH} is this now; the lines above belong under \"### Outputs\" of this version in CHANGELOG.md");
    Ok(ExitCode::SUCCESS)
}
