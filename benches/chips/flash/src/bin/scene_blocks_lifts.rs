//! A whole game of a scene among blocks with lifts, which carry and push its bodies.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::SortSweep;
use tilesat::{Blocks, Joined, Scene, Solids, fx};
use tilesat_flash::bodies::{Bodies, GRAVITY, LIFTS, fill, way};
use tilesat_flash::hero::level;

tilesat_flash::game!(
    Bodies = Scene::new(SortSweep::new()),
    map = level::<Blocks>(),
    |scene| {
        fill(scene);
        &mut (scene, LIFTS)
    },
    |game| {
        let (scene, lifts) = game;
        for lift in &mut *lifts {
            let _ = core::hint::black_box(lift.set_motion(way()));
        }
        let _ = core::hint::black_box(scene.ride(&map, lifts, GRAVITY, fx!(2), |_, _| {}));
        scene.step(&Joined::new(&map, &Solids::new(lifts)), GRAVITY, |_| {})
    }
);
