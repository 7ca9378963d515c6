//! Two shapes: overlap, touch, contacts, distances and closest points against exact judges, and the
//! numbers behind them.

#![cfg(not(target_os = "none"))]

mod any_shapes;
mod closest_ties;
mod columns;
mod compound_casts;
mod convex;
mod convex_lattice;
mod convex_shapes;
mod convex_symmetry;
mod degenerate;
mod distances;
mod exact;
mod lattice;
mod manifold_mirrors;
mod mirrored_casts;
mod mutants;
mod number_types;
mod numbers;
mod oracle_self;
mod parts;
mod pictures;
mod push_out;
mod random;
mod set_shapes;
mod symmetry;
mod vectors;
