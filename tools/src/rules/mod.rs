//! Decides what is solid, by the names of tiles, layers and objects, and by the user's options.

mod cells;
mod doubts;
pub mod flags;
mod flat;
mod form;
pub mod ground;
mod guess;
mod identifier;
pub mod kind;
mod knots;
mod layers;
mod likeness;
mod marked;
pub mod names;
mod nothing;
mod objects;
pub mod options;
pub mod outline;
mod oversize;
mod paths;
mod piece;
mod place;
mod report;
mod sides;
mod stamps;
mod stood_on;
mod traits;
pub(crate) mod union;
mod unread;
mod unused;
mod verdict;
mod weld;
mod words;

pub use report::{Applied, Rule};
pub(crate) use words::same;
