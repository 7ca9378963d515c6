//! Maps of segments: building, their bytes, and bodies that overlap and touch in them.

#![cfg(not(target_os = "none"))]

mod build;
mod build_bytes;
mod build_errors;
mod build_shapes;
mod convex;
mod hostile;
mod nooks;
mod queries;
mod tiles;
