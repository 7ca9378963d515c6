//! AABB against AABB.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::Aabb;
use tilesat::prelude::*;
tilesat_flash::program!(|a: Aabb, b: Aabb| a.overlaps(b));
