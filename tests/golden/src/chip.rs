//! A part of golden, as a program for a chip. A number on the command line limits the vectors of
//! each family.

#[cfg(not(target_os = "none"))]
use std::{println, process};
#[cfg(target_os = "none")]
use tilesat_chip::{println, process};

use super::family::{LEAST, Line, Run, VECTORS};
use super::groups::Part;

#[cfg(target_os = "none")]
pub use tilesat_chip::{entry, number};

/// The last number on the command line, if there is one.
#[cfg(not(target_os = "none"))]
fn number() -> Option<u32> {
    std::env::args().filter_map(|word| word.parse().ok()).next_back()
}

/// The entry point of a program that runs a part, on a chip or on this computer.
#[macro_export]
macro_rules! program {
    ($part:expr) => {
        #[cfg_attr(target_os = "none", $crate::chip::entry)]
        fn main() -> ! {
            $crate::chip::run($part)
        }
    };
}

/// Runs the part, prints its lines, and ends the program.
pub fn run(parts: &[Part]) -> ! {
    let count = number().unwrap_or(VECTORS);
    if count < LEAST {
        println!("at least {LEAST} vectors: before that no query has a hash");
        process::exit(2)
    }
    let mut tell = |line: &Line| println!("{line}");
    let mut run = Run::new(count, &mut tell);
    for part in parts {
        part(&mut run);
    }
    println!("{run}");
    process::exit(0)
}
