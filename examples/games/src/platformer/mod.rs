//! The platformer: its rules, its two levels in flash, and its run on a chip.

pub mod flash;
pub mod meadow;
pub mod ninja;
pub mod sim;
