//! Circle against AABB.
#![no_std]
#![no_main]
use tilesat::prelude::*;
use tilesat::{Aabb, Circle};
tilesat_flash::program!(|a: Circle, b: Aabb| a.overlaps(b));
