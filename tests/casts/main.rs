//! Cast shapes: at each other and through levels of tiles, segments and both.

#![cfg(not(target_os = "none"))]

mod blocks;
mod classes;
mod convex;
mod convex_ray;
mod corners;
mod lattice;
mod mutants;
mod ranges;
mod scenes;
mod segments;
mod shapes;
