//! Scenes.

use crate::tell;
use tilesat::broad::BruteForce;
use tilesat::scene::{
    FirstHit, Reply, SceneBody, SceneCast, SceneCharacter, SceneEvent, SceneFault, SceneTag, Shape, Sleep, WithCapsules,
};
use tilesat::{Aabb, Capsule, Character, Circle, Feel, Fx, Inside, Scene, TileKind, TileKinds, TileMap, Vec2};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL.with_flags(8));

pub(crate) fn tell_all() {
    let level = TileMap::from_ascii("    \n    \n####\n", &KINDS).unwrap();
    let mut scene = Scene::<BruteForce<2, SceneTag>, 2>::new(BruteForce::new());
    let chest = SceneBody::new(Aabb::new(Vec2::from_ints(20, 20), Vec2::from_ints(30, 32)).unwrap(), 1);
    tell(&chest);
    tell(&Shape::from(Circle::new(Vec2::from_ints(1, 2), Fx::ONE).unwrap()));
    let pill = Capsule::new(Vec2::from_ints(0, 1), Vec2::from_ints(0, 4), Fx::ONE).unwrap();
    tell(&WithCapsules::Capsule(pill));
    let handle = scene.insert(&chest).unwrap();
    tell(&Sleep::default());
    let hero = Aabb::new(Vec2::from_ints(20, 6), Vec2::from_ints(30, 20)).unwrap();
    tell(&SceneCharacter::new(Character::new(hero, level.bounds(), Feel::DEFAULT), handle));
    let (from, by) = (Vec2::from_ints(0, 25), Vec2::from_ints(40, 0));
    let hit = scene.cast_ray(from, by, Inside::Hit, |_, _| true).unwrap().unwrap();
    tell(&hit);
    let cast = SceneCast { first: FirstHit::Body(hit), displacement: by, inside: false };
    tell(&cast.first);
    tell(&cast);
    tell(&Reply::Cross);
    tell(&tilesat::world::Trail::default());
    let mut told = 0;
    let stepped = scene.step(&level, Vec2::from_raw(0, 6554), |event| {
        if let SceneEvent::Level { .. } = event {
            told += 1;
            tell(&event);
        }
    });
    assert!(told == 1, "a chest on the floor runs into it once a step");
    tell(&stepped.unwrap());
    tell(&scene);
    tell(&scene.snapshot());
    scene.remove(handle).unwrap();
    let error = scene.remove(handle).unwrap_err();
    tell(&error);
    let fault: SceneFault = error.fault;
    tell(&fault);
}
