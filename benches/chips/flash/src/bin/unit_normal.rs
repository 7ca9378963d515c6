//! `Axis::unit`.
#![cfg_attr(target_os = "none", no_std, no_main)]
tilesat_flash::program!(|a: tilesat::Axis, _b: u32| a.unit());
