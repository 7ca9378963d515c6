//! Oriented box against oriented box.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::OrientedBox;
use tilesat::prelude::*;
tilesat_flash::program!(|a: OrientedBox, b: OrientedBox| a.overlaps(b));
