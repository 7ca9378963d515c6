//! A whole game of a scene among blocks: balls and boxes that fall, bounce and rest.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::SortSweep;
use tilesat::{Blocks, Scene};
use tilesat_flash::bodies::{Bodies, GRAVITY, fill};
use tilesat_flash::hero::level;

tilesat_flash::game!(
    Bodies = Scene::new(SortSweep::new()),
    map = level::<Blocks>(),
    |scene| {
        fill(scene);
        scene
    },
    |scene| scene.step(&map, GRAVITY, |_| {})
);
