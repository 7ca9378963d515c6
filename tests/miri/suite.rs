//! Tests of every part of the library that need neither files nor C and can end in an interpreter, as one program for Miri.
//!
//! Not here: what plays the examples' levels, what takes its cases from proptest, and mass runs. `TILESAT_CASES` cuts the number of random
//! cases down, and `.ci/miri`, which sets it, leaves out by name the tests that go through a lattice in any case.

#[path = "../cast_scenes.rs"]
mod cast_scenes;
#[path = "../cast_shapes.rs"]
mod cast_shapes;
#[path = "../degenerate.rs"]
mod degenerate;
#[path = "../motion_scenes.rs"]
mod motion_scenes;
#[path = "../rays.rs"]
mod rays;
#[path = "../scene_rest.rs"]
mod scene_rest;
#[path = "../segment_build_shapes.rs"]
mod segment_build_shapes;
#[path = "../segment_world_hostile.rs"]
mod segment_world_hostile;
#[path = "../segment_world_rays.rs"]
mod segment_world_rays;
#[path = "../shape_rays_scenes.rs"]
mod shape_rays_scenes;
#[path = "../shape_rays_views.rs"]
mod shape_rays_views;
#[path = "../solids_games.rs"]
mod solids_games;
#[path = "../solids_placed.rs"]
mod solids_placed;
#[path = "../torture_peers.rs"]
mod torture_peers;
