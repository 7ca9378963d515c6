//! Prints what every query costs on this core, in instructions and bytes of stack.

#![no_std]
#![no_main]

mod blocks;
mod cast;
mod counter;
mod frames;
mod inputs;
mod level;
mod measure;
mod pairs;
mod response;
mod shapes;
mod stack;

use cortex_m_rt::{ExceptionFrame, entry, exception};
use semihosting::{eprintln, process};

#[entry]
fn main() -> ! {
    let counter = counter::Counter::start();
    let wrong = counter.wrong_loops();
    if wrong != 0 {
        eprintln!("the counter is wrong on {wrong} loops of known length");
        process::exit(1);
    }
    let mut table = measure::Table::new(counter);
    pairs::rows(&mut table);
    cast::rows(&mut table);
    level::rows(&mut table);
    blocks::rows(&mut table);
    shapes::rows(&mut table);
    frames::rows(&mut table);
    response::rows(&mut table);
    process::exit(i32::from(table.wrong != 0))
}

/// The default handler loops for ever; a fault must end the run.
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    eprintln!("hard fault at {:#010x}", frame.pc());
    process::exit(70)
}
