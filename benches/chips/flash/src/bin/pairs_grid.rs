//! Bodies that come, go and move in this broad phase, and all pairs of them.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::LooseGrid;
use tilesat::{Aabb, Fx, Vec2};
use tilesat_flash::frame;
tilesat_flash::program!(|boxes: [Aabb; 64], moved: [Aabb; 64]| LooseGrid::<24, 64>::new(Vec2::ZERO, Fx::ONE, 32)
    .map(|near| frame(near, boxes, moved)));
