//! Circle against circle.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::Circle;
use tilesat::prelude::*;
tilesat_flash::program!(|a: Circle, b: Circle| a.overlaps(b));
