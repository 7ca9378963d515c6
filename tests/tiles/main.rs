//! Maps of tiles: their content, their surface, and bodies that overlap and touch in them.

#![cfg(not(target_os = "none"))]

mod blocks;
mod compound_contacts;
mod compound_motion;
mod contacts;
mod contacts_sources;
mod convex;
mod convex_contacts;
mod features;
mod joined;
mod joined_starts;
mod map;
mod mutants;
mod occupancy;
mod rooms;
mod shape_features;
mod shape_features_views;
mod shape_overlap;
mod swept_flags;
