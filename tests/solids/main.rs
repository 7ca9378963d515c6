//! Solids that move: what they carry and push, and how bodies move among them.

#![cfg(not(target_os = "none"))]

mod carry;
mod character;
mod character_launches;
mod character_lifts;
mod character_looks;
mod games;
mod joints;
mod placed;
mod push;
mod surface;
mod ticks;
