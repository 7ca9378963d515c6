//! `Axis::unit`.
#![no_std]
#![no_main]
tilesat_flash::program!(|a: tilesat::Axis, _b: u32| a.unit());
