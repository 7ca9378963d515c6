//! Golden hashes: every public query over fixed vectors, and ten thousand frames of three games,
//! the same bits on every core, at every level of optimisation, in every build.
//!
//! The programs in `src/bin`, the Game Boy Advance's and `tests.rs` run them.
//! `hashes.txt` has the reviewed ones. Inputs come from a seeded generator of integers, in classes
//! (`random.rs`): ordinary, on a lattice, touching exactly, touching within 2 raw units, at the
//! ends of the domain, and anywhere of any size. Every field of every answer enters the hash of its
//! query (`encode.rs`).
#![cfg_attr(target_os = "none", no_std)]
#![allow(clippy::must_use_candidate, clippy::new_without_default, reason = "read as programs, not as a library")]

mod bodies;
#[cfg(feature = "chip")]
pub mod chip;
mod convex;
mod encode;
mod family;
#[cfg(not(target_os = "none"))]
mod games;
mod groups;
mod hash;
mod levels;
mod motion;
mod ninja;
mod numbers;
mod pairs;
mod random;
mod responses;
mod scene_hero;
mod scenes;
#[cfg(not(target_os = "none"))]
pub mod table;
#[cfg(test)]
mod tests;
mod world;
mod worlds;

pub use family::{LEAST, Line, Run, VECTORS};
#[cfg(not(target_os = "none"))]
pub use groups::GAMES;
pub use groups::{
    BLOCKS, BODIES, CAPSULES, CONVEX, GROUPS, JOINED, LEVELS, MOTION, MOVING, NINJA, PILLS, Part, SCENE_HERO, SCENES,
    SEGMENTS, SHAPES, TURNED,
};
pub use hash::Hash;
