//! One body of this shape that rides on moving solids.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::motion::Mover;
use tilesat::world::{Solid, TileMap};
use tilesat::{Axis, Circle, Fx};
tilesat_flash::program!(|map: TileMap<'static>, input: ([Solid; 4], Circle, Fx)| {
    Mover::platformer(Axis::NEG_Y).ride(map, &input.0, &input.1, input.2)
});
