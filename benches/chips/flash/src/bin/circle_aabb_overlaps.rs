//! Circle against AABB.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::prelude::*;
use tilesat::{Aabb, Circle};
tilesat_flash::program!(|a: Circle, b: Aabb| a.overlaps(b));
