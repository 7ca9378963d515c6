//! Circle against segment.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::prelude::*;
use tilesat::{Circle, Segment};
tilesat_flash::program!(|a: Circle, b: Segment| a.overlaps(b));
