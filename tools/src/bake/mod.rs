//! Converts levels to files that a firmware includes, and reports their cost.

mod baked;
pub mod bundle;
pub(crate) mod items;
mod json;
pub mod level;
pub(crate) mod names;
mod outputs;
#[cfg(feature = "program")]
mod picture;
#[cfg(feature = "program")]
pub mod reopen;
#[cfg(feature = "program")]
mod report;
pub mod segments;
pub(crate) mod source;
pub(crate) mod things;
#[cfg(feature = "program")]
mod view;

pub use baked::Baked;
pub use bundle::{Bundle, Settings, bake};
pub use outputs::Outputs;
