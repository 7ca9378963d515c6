//! The suite of a minute: scenes and judges of levels, motion, broad phases and scenes in one program.

#![allow(dead_code, reason = "only parts of each test are run")]

mod cast_support;
mod motion_shape_support;
mod motion_support;
mod oracle;
mod response_support;
mod segment_support;
mod segment_world_support;
mod solids_support;
mod support;
mod walk_support;

mod broad_removals;
mod cast_rays;
mod features;
mod motion_floor;
mod motion_one_way;
mod motion_scenes;
mod motion_segments;
mod pair_events;
mod response;
mod scene_rules;
mod scene_sleep;
mod segment_build;
mod segment_world;
mod solids_push;
mod tile_map;
mod walk_scenes;
mod world_oracle;
