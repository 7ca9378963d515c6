//! A part of golden on a chip; a number on the command line is how many vectors each family is given.

#[path = "../chip/fault.rs"]
mod fault;
#[path = "mod.rs"]
pub mod golden;

#[cfg(target_arch = "arm")]
use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv_rt::entry;
use semihosting::experimental::env;
use semihosting::{println, process};

use super::PARTS;
use golden::Run;

#[entry]
fn main() -> ! {
    let mut count = golden::VECTORS;
    if let Ok(args) = env::args::<64>() {
        for word in &args {
            count = word.ok().and_then(|word| word.parse().ok()).unwrap_or(count);
        }
    }
    if count < golden::LEAST {
        println!("at least {} vectors: before that no query has a hash", golden::LEAST);
        process::exit(2)
    }
    let mut tell = |line: &golden::Line| println!("{line}");
    let mut run = Run::new(count, &mut tell);
    for part in PARTS {
        part(&mut run);
    }
    println!("{run}");
    process::exit(0)
}
