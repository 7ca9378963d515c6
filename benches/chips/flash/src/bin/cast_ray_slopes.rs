//! A ray through a tile map of this set.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::Vec2;
use tilesat::world::{Inside, Slopes, TileMap};
tilesat_flash::program!(|map: TileMap<'static, Slopes>, ray: (Vec2, Vec2)| {
    map.cast_ray(ray.0, ray.1, Inside::Ignore)
});
