//! A part of golden on a chip. A number on the command line limits the vectors of each family.

use tilesat_chip::{number, println, process};

use super::family::{LEAST, Line, Run, VECTORS};
use super::groups::Part;

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
