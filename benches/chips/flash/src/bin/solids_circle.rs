//! One body of this shape in a game with platforms: it rides on them, and moves and slides through
//! a tile map that they are joined to.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::motion::Mover;
use tilesat::world::{Joined, Solid, Solids, TileMap};
use tilesat::{Axis, Circle, Fx, Vec2};
tilesat_flash::program!(|map: TileMap<'static>, input: ([Solid; 4], Circle, Vec2)| {
    let mover = Mover::platformer(Axis::NEG_Y);
    let mut solids = input.0;
    let ridden = mover.ride(&Joined::new(map, &Solids::new(&[])), &solids, &input.1, Fx::ONE);
    Solid::move_all(&mut solids);
    let here = Solids::new(&solids);
    ridden.and_then(|ridden| mover.move_and_slide(&Joined::new(map, &here), &ridden.body, input.2))
});
