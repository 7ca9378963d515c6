//! The minimum for a program on the Game Boy Advance: start-up, registers, the emulator's log, a
//! cycle counter, screen and keys.
//!
//! All `unsafe` of the example is in `start`, `register`, `stack` and `sample`. The library has
//! none. On a computer the crate is empty.
#![no_std]
#![cfg(target_os = "none")]

mod copy;
pub mod cycles;
pub mod log;
pub mod pad;
mod register;
pub mod sample;
pub mod screen;
pub mod stack;
mod start;
