//! Saved and restored states: the same bits, or an error.

#![cfg(not(target_os = "none"))]

mod bytes;
mod places;
mod refused;
mod same;
mod values;
