//! A game seen from above: the hero, the rooms, and the keys that lead it through them.

mod hero;
mod rooms;

pub use hero::Hero;
pub use rooms::{KEYS, SIZE, START, rooms};
