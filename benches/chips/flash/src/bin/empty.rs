//! Only the frame.
#![cfg_attr(target_os = "none", no_std, no_main)]
tilesat_flash::program!(|a: u32, b: u32| (a, b));
