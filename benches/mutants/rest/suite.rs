//! The suite of a minute: scenes and judges of levels, motion, broad phases and scenes in one program.

#![allow(dead_code, reason = "only parts of each test are run")]

mod broad_support;
mod cast_support;
mod motion_shape_support;
mod motion_support;
mod oracle;
mod ray_support;
mod response_support;
mod segment_support;
mod segment_world_support;
mod shape_support;
mod solids;
mod solids_support;
mod support;
mod walk_support;

mod broad_pairs;
mod broad_removals;
mod cast_rays;
mod features;
mod joined;
mod motion_floor;
mod motion_one_way;
mod motion_rest;
mod motion_scenes;
mod motion_segments;
mod mutants_motion;
mod mutants_world;
mod pair_events;
mod response;
mod response_gravity;
mod scene_rules;
mod scene_sleep;
mod segment_build;
mod segment_world;
mod shape_features;
mod shape_rays;
mod solids_push;
mod tile_map;
mod walk_scenes;
mod world_contacts;
mod world_oracle;
