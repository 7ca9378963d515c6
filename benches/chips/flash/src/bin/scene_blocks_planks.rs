//! A whole game of a scene among blocks with planks, one that moves and one that turns. They carry
//! and push its bodies.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::SortSweep;
use tilesat::world::ConvexSolids;
use tilesat::{Blocks, Joined, Scene, fx};
use tilesat_flash::bodies::{Bodies, GRAVITY, PLANKS, fill, plank, way};
use tilesat_flash::hero::level;
use tilesat_flash::port;

tilesat_flash::game!(
    Bodies = Scene::new(SortSweep::new()),
    map = level::<Blocks>(),
    |scene| {
        fill(scene);
        &mut (scene, PLANKS)
    },
    |game| {
        let (scene, planks) = game;
        let [lift, seesaw] = planks;
        let _ = core::hint::black_box(lift.set_motion(way()));
        if let Some(next) = plank(80, (port() & 15) as i32 - 8) {
            let _ = core::hint::black_box(seesaw.set_turn(next));
        }
        let _ = core::hint::black_box(scene.ride(&map, planks, GRAVITY, fx!(2), |_, _| {}));
        scene.step(&Joined::new(&map, &ConvexSolids::new(planks)), GRAVITY, |_| {})
    }
);
