//! Golden hashes: every public query over fixed vectors, the same bits on every core, at every level of optimisation, in every build.
//!
//! The program `golden`, the Game Boy Advance's and `tests/golden.rs` all include this folder. `tests/golden/hashes.txt` has the reviewed hashes.
#![allow(unreachable_pub, dead_code, reason = "a module of programs, each of which uses its part")]

mod bodies;
mod encode;
mod family;
#[cfg(not(target_os = "none"))]
mod games;
mod hash;
mod levels;
mod motion;
mod ninja;
mod numbers;
mod pairs;
mod random;
mod responses;
#[cfg(not(target_os = "none"))]
pub mod table;
mod world;
mod worlds;

pub use family::{Line, Run};

/// Families of some kinds.
pub type Part = fn(&mut Run<'_>);

/// Vectors of each query at least. Where it is asked of several kinds of shapes or levels, each with a family of its own, they share them.
pub const VECTORS: u32 = 100_000;

/// Vectors before which no query has a hash.
pub const LEAST: u32 = 1_000;

// Groups: as much as the flash of a small chip holds, at the worst without optimisation.
pub const SHAPES: &[Part] = &[numbers::run, pairs::run, responses::run];
pub const BODIES: &[Part] = &[bodies::run];
pub const LEVELS: &[Part] = &[worlds::run_tiles, worlds::run_blocks, worlds::run_slopes, worlds::run_shapes];
pub const SEGMENTS: &[Part] = &[worlds::run_segments, motion::run_segments];
pub const JOINED: &[Part] = &[worlds::run_joined];
pub const MOVING: &[Part] = &[worlds::run_moving];
pub const BLOCKS: &[Part] = &[motion::run_blocks];
pub const MOTION: &[Part] = &[motion::run_shapes, ninja::run];
pub const GROUPS: [&[Part]; 8] = [SHAPES, BODIES, LEVELS, SEGMENTS, JOINED, MOVING, BLOCKS, MOTION];

/// Firmwares of their own on chips.
#[cfg(not(target_os = "none"))]
pub const GAMES: &[Part] = &[games::run];
