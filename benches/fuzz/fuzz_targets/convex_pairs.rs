#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| tilesat_fuzz::check("convex_pairs", data));
