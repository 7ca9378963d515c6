//! Shapes of any kind against each other.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::prelude::*;
use tilesat::shape::AnyShape;
tilesat_flash::program!(|a: AnyShape<4>, b: AnyShape<4>| a.overlaps(b));
