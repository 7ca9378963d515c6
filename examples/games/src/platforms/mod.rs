//! A walker among lifts, a conveyor and a crusher: the level, the machines, and a script that plays
//! it.

mod game;
pub mod level;
mod machine;
mod script;

pub use game::{Game, Keys};
pub use machine::{CRUSHER, LIFT, MACHINES, Machine, SHELF};
pub use script::{SCRIPT, Stretch};
