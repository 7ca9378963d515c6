//! The solid of a level: by the names that people give to tiles, layers and objects, and by
//! what a user says.

mod cells;
mod doubts;
pub mod flags;
mod form;
pub mod ground;
mod identifier;
pub mod kind;
mod layers;
mod likeness;
pub mod names;
mod nothing;
mod objects;
pub mod options;
pub mod outline;
mod paths;
mod piece;
mod place;
mod report;
mod traits;
pub(crate) mod union;
mod verdict;
mod words;

pub use report::{Applied, Rule};
pub(crate) use words::same;
