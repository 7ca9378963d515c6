//! Bodies that come, go and move in this broad phase, and all pairs of them.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::Aabb;
use tilesat::broad::BruteForce;
use tilesat_flash::frame;
tilesat_flash::program!(|boxes: [Aabb; 64], moved: [Aabb; 64]| frame(BruteForce::<64>::new(), boxes, moved));
