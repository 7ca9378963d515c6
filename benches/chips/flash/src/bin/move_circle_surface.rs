//! One body of this shape that moves and slides through a tile map of this set, with friction and
//! restitution.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::motion::Mover;
use tilesat::world::{AllShapes, TileMap};
use tilesat::{Axis, Circle, Ratio, Surface, Vec2};
const RUBBER: Surface = Surface::new(Ratio::HALF, Ratio::HALF);
tilesat_flash::program!(|map: TileMap<'static, AllShapes>, input: (Circle, Vec2)| {
    Mover::platformer(Axis::NEG_Y).with_surface(RUBBER).move_and_slide(map, &input.0, input.1)
});
