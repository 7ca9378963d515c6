//! Bodies that come, go and move in this broad phase, and all pairs of them.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::SpatialHash;
use tilesat::{Aabb, Fx};
use tilesat_flash::frame;
tilesat_flash::program!(
    |boxes: [Aabb; 64], moved: [Aabb; 64]| SpatialHash::<64, 64>::new(Fx::ONE).map(|near| frame(near, boxes, moved))
);
