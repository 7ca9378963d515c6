//! Saved and restored states: the same bits, or an error. `cargo test --test saved --features
//! serde`.

#![cfg(all(feature = "serde", not(target_os = "none")))]

mod bytes;
mod places;
mod refused;
mod same;
mod values;
