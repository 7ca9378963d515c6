//! Maps of segments: how they are built, what their bytes say, and what bodies overlap and touch in
//! them.

#![cfg(not(target_os = "none"))]

mod build;
mod build_bytes;
mod build_errors;
mod build_shapes;
mod convex;
mod hostile;
mod queries;
mod tiles;
