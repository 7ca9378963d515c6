//! Prints what every query costs on this core, in instructions.

#![no_std]
#![no_main]

mod counter;
mod inputs;
mod level;
mod measure;
mod pairs;
mod shapes;

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
    level::rows(&mut table);
    shapes::rows(&mut table);
    process::exit(i32::from(table.wrong != 0))
}

/// The default handler loops for ever; a fault must end the run.
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    eprintln!("hard fault at {:#010x}", frame.pc());
    process::exit(70)
}
