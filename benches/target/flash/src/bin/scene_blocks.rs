//! A whole game of a scene among blocks: balls and boxes that fall, bounce and rest.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::{Aabb, Blocks, Circle, Scene, Vec2, fx};
use tilesat_flash::hero::level;
use tilesat_flash::port;

tilesat_flash::game!(
    Scene<SortSweep<30, SceneTag>, 30> = Scene::new(SortSweep::new()),
    map = level::<Blocks>(),
    |scene| {
        for key in 0..30 {
            let at = Vec2::from_raw(port() as i32, port() as i32);
            let ball = Circle::new(at, fx!(4)).map(|ball| SceneBody::new(ball, key));
            let box_ = Aabb::new(at, at + Vec2::from_ints(8, 8)).map(|box_| SceneBody::new(box_, key));
            if let Ok(body) = if port() & 1 == 0 { ball } else { box_ } {
                let _ = core::hint::black_box(scene.insert(&body));
            }
        }
        scene
    },
    |scene| scene.step(&map, Vec2::new(fx!(0), fx!(0.1)), |_| {})
);
