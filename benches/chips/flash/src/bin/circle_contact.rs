//! Contact of two circles with normal, push-out and both points.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::Circle;
use tilesat::prelude::*;
tilesat_flash::program!(|a: Circle, b: Circle| a.contact(b).map(|c| (
    c.depth(),
    c.normal(),
    c.push_out(),
    c.point_on_a(),
    c.point_on_b()
)));
