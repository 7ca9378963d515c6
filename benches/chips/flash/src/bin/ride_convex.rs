//! One circle that rides on four planks that move and turn.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::motion::Mover;
use tilesat::world::{ConvexSolid, TileMap};
use tilesat::{Axis, Circle, Fx, OrientedBox};
tilesat_flash::program!(|map: TileMap<'static>, input: ([ConvexSolid<OrientedBox>; 4], Circle, Fx)| {
    Mover::platformer(Axis::NEG_Y).ride_convex(map, &input.0, &input.1, input.2)
});
