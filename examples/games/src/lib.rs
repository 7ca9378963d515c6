//! The logic of the example games, shared by desktop, firmware, console and golden runs.
//!
//! | module | game |
//! |---|---|
//! | [`bullets`] | 240 bullets, 32 enemies and a player: pairs and events in fixed memory |
//! | [`ninja`] | one circle among all tile shapes: slopes, quarter pipes, wall jumps |
//! | [`pinball`] | balls on a table of tiles and polygons: bumpers, slingshots, a kicker, flippers |
//! | [`platformer`] | a scripted player, 16 boxes and 16 balls in a baked level |
//! | [`platforms`] | a walker on lifts, on a conveyor, on steps and under a crusher |
//! | [`racing`] | a car that turns, crates, and a marshal behind a turnstile |
//! | [`rollback`] | two players over a link that loses packets: delay, prediction, rollback |
//! | [`scroller`] | a runner through rooms, in a world of 40 000 pixels |
//! | [`top_down`] | eight directions, no up; the hero slips around corners |
//!
//! Integers only, no heap, no panic: the same frames everywhere, bit for bit.
#![no_std]
#![warn(clippy::indexing_slicing, clippy::std_instead_of_core, clippy::float_arithmetic)]
#![allow(
    clippy::must_use_candidate,
    clippy::missing_errors_doc,
    clippy::new_without_default,
    reason = "these are games, not a library: every call here has one caller or two"
)]

pub mod bullets;
pub mod ninja;
pub mod pinball;
pub mod platformer;
pub mod platforms;
pub mod racing;
pub mod rollback;
pub mod scroller;
pub mod top_down;
