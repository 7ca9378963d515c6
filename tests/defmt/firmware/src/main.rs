//! Logs a value of every public type: one frame each, with the type's path and the value. The host
//! decodes them (`check`).

#![no_std]
#![no_main]

mod bodies;
mod levels;
mod motion;
mod numbers;
mod responses;
mod scenes;

use defmt::Format;
use tilesat_chip::{entry, process};

/// The path comes from the compiler, so a line cannot have another type's path.
fn tell<T: Format>(value: &T) {
    defmt::println!("{=str} = {}", core::any::type_name::<T>(), value);
}

#[entry]
fn main() -> ! {
    numbers::tell_all();
    levels::tell_all();
    motion::tell_all();
    responses::tell_all();
    bodies::tell_all();
    scenes::tell_all();
    process::exit(0)
}
