//! Plays a baked level with a scripted player and 32 boxes and balls, and watches them.
//!
//! What moves the bodies is the game itself, [`tilesat_games::platformer`]; everything here only looks.

pub mod check;
pub mod constants;
mod figure;
mod flags;
mod meets;
mod outline;
pub mod picture;
mod run;
mod trail;

pub use figure::Figure;
pub use flags::{coins, rules};
pub use run::{Run, play};
