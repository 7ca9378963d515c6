//! Rays: at single shapes and through levels of blocks, of all tile shapes, of segments and of
//! solids.

#![cfg(not(target_os = "none"))]

mod blocks;
mod convex_solids;
mod segments;
mod shapes;
mod shapes_scenes;
mod shapes_views;
mod single;
mod solids;
