//! One body of this shape that moves and slides through a tile map of this set.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::motion::Mover;
use tilesat::world::{Slopes, TileMap};
use tilesat::{Axis, Circle, Vec2};
tilesat_flash::program!(|map: TileMap<'static, Slopes>, input: (Circle, Vec2)| {
    Mover::platformer(Axis::NEG_Y).move_and_slide(map, &input.0, input.1)
});
