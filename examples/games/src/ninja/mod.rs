//! A round ninja: what the keys do to it, its level, and a script that plays it.

pub mod level;
mod runner;
mod script;

pub use runner::{Keys, Ninja, State};
pub use script::Script;
