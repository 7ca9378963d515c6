//! Plays a baked level with a scripted player and 32 boxes and balls, and checks them.
//!
//! The game itself, [`tilesat_games::platformer`], moves the bodies. This module only observes.

mod arena;
pub mod check;
pub mod constants;
mod drift;
mod figure;
mod flags;
mod meets;
mod outline;
pub mod picture;
mod run;
mod spawn;
mod trail;
mod walls;

pub use arena::Arena;
pub use figure::Figure;
pub use flags::{coins, rules};
pub use run::{Run, play};
pub use spawn::Spawn;
