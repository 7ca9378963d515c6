//! Circle against circle.
#![no_std]
#![no_main]
use tilesat::Circle;
use tilesat::prelude::*;
tilesat_flash::program!(|a: Circle, b: Circle| a.overlaps(b));
