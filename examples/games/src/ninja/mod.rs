//! A round ninja: what the keys do to it, its level, and a script that plays it. Beside it a rope,
//! and the ragdoll that a mine makes of it.

use tilesat::{Ratio, Surface};

pub mod level;
pub mod ragdoll;
pub mod rope;
mod runner;
mod script;

pub use ragdoll::Ragdoll;
pub use rope::Rope;
pub use runner::{Keys, Ninja, State};
pub use script::Script;

/// What ropes and limbs are made of: it does not bounce, and slides badly.
const CLOTH: Surface = Surface::new(Ratio::ZERO, Ratio::HALF);
