//! Many bodies: broad phases, pairs and their events, responses between bodies, and scenes.

#![cfg(not(target_os = "none"))]

mod broad_grid;
mod broad_model;
mod broad_pairs;
mod broad_removals;
mod chased;
mod crates_in_rows;
mod fast_curves;
mod fast_overlaps;
mod fast_pressed;
mod filters;
mod hanging;
mod heaps;
mod kept_out;
mod leaning;
mod pair_events;
mod piles;
mod pressed;
mod response;
mod response_pair;
mod response_ratio;
mod response_verlet;
mod rollback;
mod scene_and_level;
mod scene_change;
mod scene_character;
mod scene_levels;
mod scene_lifts;
mod scene_masses;
mod scene_memory;
mod scene_pushes;
mod scene_queries;
mod scene_reach;
mod scene_replies;
mod scene_rest;
mod scene_rules;
mod scene_sleep;
mod scene_snapshot;
mod scene_solids;
mod scripts;
mod sort_sweep;
mod steps;
mod sums;
mod swept;
mod swept_pairs;
