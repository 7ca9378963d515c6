//! Bodies that move through levels: hits, sliding, rest, one-way edges, walking, friction.

#![cfg(not(target_os = "none"))]

mod clear;
mod floor;
mod inside;
mod invariants;
mod long_runs;
mod memo;
mod mutants;
mod one_way;
mod one_way_bridge;
mod pinch;
mod points;
mod response_energy;
mod response_gravity;
mod response_mover;
mod rest;
mod rest_segments;
mod rooms;
mod same;
mod scenes;
mod segments;
mod shape_scenes;
mod shapes;
mod sweep;
mod symmetry;
mod torture;
mod torture_corners;
mod torture_order;
mod torture_peers;
mod torture_rest;
mod torture_rooms;
mod torture_seams;
mod torture_segments;
mod torture_shapes;
mod torture_views;
mod walk_edges;
mod walk_joined;
mod walk_scenes;
mod walk_slopes;
mod walk_steps;
mod walk_worlds;
mod wedge;
mod worlds;
