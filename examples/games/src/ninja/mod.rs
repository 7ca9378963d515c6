//! A round ninja: its response to the keys, its level, and a script that plays it. Also a rope, and
//! the ragdoll that a mine makes of the ninja.

pub mod level;
mod ragdoll;
mod rope;
mod runner;
mod script;
mod sticks;

pub use ragdoll::ragdoll;
pub use rope::rope;
pub use runner::{Keys, Ninja, State};
pub use script::Script;
pub use sticks::Sticks;
