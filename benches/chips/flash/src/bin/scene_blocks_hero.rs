//! A whole game of a scene among blocks with a hero, who stands on its boxes and pushes them.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::SortSweep;
use tilesat::scene::{SceneBody, SceneCharacter};
use tilesat::{Aabb, Blocks, Character, Feel, Joined, Scene, Solids, Vec2};
use tilesat_flash::bodies::{Bodies, GRAVITY, fill};
use tilesat_flash::hero::{input, level};

const BODY: Aabb = match Aabb::from_size(Vec2::from_ints(20, 20), Vec2::from_ints(10, 14)) {
    Ok(body) => body,
    Err(_) => panic!("a hero"),
};
const LIMITS: Aabb = match Aabb::from_size(Vec2::ZERO, Vec2::from_ints(128, 80)) {
    Ok(limits) => limits,
    Err(_) => panic!("limits"),
};

tilesat_flash::game!(
    Bodies = Scene::new(SortSweep::new()),
    map = level::<Blocks>(),
    |scene| {
        let body = scene.insert(&SceneBody::led(BODY, 100)).ok();
        fill(scene);
        let hero = Character::new(BODY, LIMITS, Feel::DEFAULT);
        &mut (scene, body.map(|body| SceneCharacter::new(hero, body)))
    },
    |game| {
        let (scene, hero) = game;
        // The type of level in which the hero walks: the game links one mover.
        let none = Solids::new(&[]);
        let here = Joined::new(&map, &none);
        hero.as_mut().map(|hero: &mut SceneCharacter| {
            (
                core::hint::black_box(hero.lead(scene, &map, &[], input())),
                core::hint::black_box(scene.step(&here, GRAVITY, |_| {})),
                hero.follow(scene, &map, &[]),
            )
        })
    }
);
