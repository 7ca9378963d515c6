//! A hero among the bodies of a scene, on a lift from time to time. A vector is a frame.

use tilesat::broad::{BroadPhase, SortSweep};
use tilesat::scene::{SceneCharacter, SceneTag};
use tilesat::{
    Aabb, Blocks, Character, Feel, Fx, Input, Joined, Outcome, Scene, SceneBody, Solid, Solids, TileMap, Vec2,
};

use super::VECTORS;
use super::family::Run;
use super::random::{Random, UNIT};
use super::scenes::{GRAVITY, KINDS, ROWS, plain};

const BODIES: usize = 9;
const HERO: u32 = u32::MAX;

/// Keys that stay down for a while.
fn wild(r: &mut Random, was: Input) -> Input {
    let run = if r.once_in(24) { Fx::from_bits(r.small(2) * UNIT) } else { was.run };
    let jump = if r.once_in(12) { !was.jump } else { was.jump };
    Input { run, jump, drop: r.once_in(40) }
}

pub(crate) fn run(run: &mut Run<'_>) {
    let place = Aabb::from_size(Vec2::from_ints(70, 20), Vec2::from_ints(10, 14));
    let lift = Aabb::from_size(Vec2::from_ints(20, 80), Vec2::from_ints(30, 6)).and_then(|lift| Solid::new(lift, 1));
    let (Ok(level), Ok(body), Ok(lift)) = (TileMap::<Blocks>::from_ascii(ROWS, &KINDS), place, lift) else { return };
    let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES>::new(SortSweep::new());
    let Ok(at) = scene.insert(&SceneBody::led(body, HERO)) else { return };
    let mut hero = SceneCharacter::new(Character::new(body, level.bounds(), Feel::DEFAULT), at);
    let (mut lifts, mut input) = ([lift], Input::default());
    run.family("scene_with_a_hero", VECTORS / 8, ["step"], |number, r, [step]| {
        input = wild(r, input);
        if number % 64 == 0 && number < 64 * (BODIES as u32 - 1) {
            let Some(shape) = plain(r) else { return };
            step.add(scene.insert(&SceneBody { fast: r.once_in(2), ..SceneBody::new(shape, number) }).is_ok());
        }
        let up = if number % 80 < 40 { -1 } else { 1 };
        step.add(lifts[0].set_motion(Vec2::from_ints(0, up)).is_ok());
        step.add(scene.ride(&level, &mut lifts, GRAVITY, Fx::from_bits(5 * UNIT), |_, _| ()).is_ok());
        let led = hero.lead(&mut scene, &level, &lifts, input);
        step.add(led.map(|step| [u32::from(step.outcome == Outcome::Moved), u32::from(step.landed)]).ok());
        step.add(hero.character.body().min());
        step.add(scene.step(&Joined::new(&level, &Solids::new(&lifts)), GRAVITY, |_| {}).is_ok());
        step.add(hero.follow(&scene, &level, &lifts).ok());
        step.add(hero.character.body().min());
        step.add(hero.character.velocity);
        step.add(hero.stands_on());
        for (handle, _) in scene.bodies() {
            step.add(scene.near().bounds(handle).ok());
        }
    });
}
