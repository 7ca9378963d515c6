//! A round ninja: what the keys do to it, its level, and a script that plays it. Beside it a rope,
//! and the ragdoll that a mine makes of it.

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
