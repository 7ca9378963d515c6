//! States that were written and read again: to the same bits, or not at all.
//! `cargo test --test saved --features serde`.

#![cfg(all(feature = "serde", not(target_os = "none")))]

mod bytes;
mod places;
mod refused;
mod same;
mod values;
