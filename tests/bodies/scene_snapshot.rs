//! Snapshots: a restored scene makes the same steps, to the last bit and in the same order of
//! events. Units, y down.

use core::num::NonZeroU8;
use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SortSweep, SpatialHash};
use tilesat::scene::{SceneBody, SceneEvent, SceneTag, Shape, Snapshot};
use tilesat::{Aabb, Circle, Filter, Fx, Ratio, Scene, Surface, TileMap, Vec2};
use tilesat_judge::scenes::{BODIES, room};
use tilesat_judge::{Random, cases};

const GRAVITY: Vec2 = Vec2::from_raw(0, 6554);

type Sixty<B> = Snapshot<B, 64>;
// The entry of a rollback history.
const _: () = assert!(size_of::<Sixty<SortSweep<64, SceneTag>>>() <= 8192);
const _: () = assert!(size_of::<Sixty<BruteForce<64, SceneTag>>>() <= 8192);

fn body(random: &mut Random, key: u32) -> SceneBody {
    let at = Vec2::from_raw(random.within(17 << 16, 160 << 16) as i32, random.within(0, 50 << 16) as i32);
    let size = random.within(1 << 16, 7 << 16) as i32;
    let shape = if random.below(2) == 0 {
        Aabb::new(at, at + Vec2::from_raw(size, random.within(1 << 16, 7 << 16) as i32)).unwrap().into()
    } else {
        Shape::from(Circle::new(at + Vec2::from_raw(size, size), Fx::from_bits(size / 2)).unwrap())
    };
    let speed = if random.below(4) == 0 { 40 } else { 2 };
    let component = |random: &mut Random| random.within(-speed << 16, speed << 16) as i32;
    let velocity = Vec2::from_raw(component(random), component(random));
    let ratio = |random: &mut Random| Ratio::percent(random.below(101) as u8).unwrap();
    let surface = Surface::new(ratio(random), ratio(random));
    let kind = random.below(8);
    SceneBody {
        velocity,
        mass: if kind == 0 { None } else { NonZeroU8::new(1 + random.below(9) as u8) },
        surface: if kind < 4 { surface } else { Surface::SLICK },
        filter: Filter::default().with_sensor(kind == 7),
        floats: kind == 6,
        fast: kind == 5,
        ..SceneBody::new(shape, key)
    }
}

/// Changes that a game makes between two steps.
fn change<B: BroadPhase<Tag = SceneTag>>(scene: &mut Scene<B, BODIES>, random: &mut Random, key: &mut u32) {
    let who = random.below(BODIES as i64) as usize;
    let handle = scene.bodies().nth(who).map(|(handle, _)| handle);
    match (random.below(12), handle) {
        (0, _) => {
            *key += 1;
            let _ = scene.insert(&body(random, *key));
        }
        (1, Some(handle)) => {
            scene.remove(handle).unwrap();
        }
        (2, Some(handle)) => scene.push(handle, Vec2::from_ints(0, -3)).unwrap(),
        (3, Some(handle)) => {
            let shape = body(random, 0).shape;
            scene.place(handle, shape).unwrap();
        }
        (4, Some(handle)) => {
            scene.alter(handle, |body| body.mass = if body.mass.is_some() { None } else { NonZeroU8::new(3) }).unwrap();
        }
        _ => {}
    }
}

fn step<B: BroadPhase<Tag = SceneTag>>(scene: &mut Scene<B, BODIES>, map: &TileMap<'_>) -> Vec<String> {
    let mut told = Vec::new();
    let stepped = scene.step(map, GRAVITY, |event: SceneEvent<'_>| told.push(format!("{event:?}")));
    told.push(format!("{stepped:?}"));
    told
}

fn goes_on<B: BroadPhase<Tag = SceneTag> + Copy + PartialEq + core::fmt::Debug>(near: B) {
    let map = room();
    let (mut slept, mut events) = (0, 0);
    for case in 0..cases(12) {
        let mut random = Random::new(case);
        let (mut scene, mut key) = (Scene::<B, BODIES>::new(near), 0);
        for _ in 0..BODIES {
            key += 1;
            let _ = scene.insert(&body(&mut random, key));
        }
        // The twin was just restored, from any earlier state.
        let mut twin = Scene::<B, BODIES>::new(near);
        // Written over again and again, whatever was in it.
        let mut kept = Snapshot::new(near);
        assert_eq!(kept, twin.snapshot(), "an empty one");
        for frame in 0..120 {
            // The same changes for both: everything that a call reads is in the snapshot.
            let seed = case * 1000 + frame;
            let mut next = key;
            change(&mut scene, &mut Random::new(seed), &mut next);
            if frame % 3 == 0 {
                twin.restore(&scene.snapshot());
            } else {
                change(&mut twin, &mut Random::new(seed), &mut key);
            }
            key = next;
            scene.snapshot_into(&mut kept);
            assert_eq!(kept, scene.snapshot(), "case {case}, frame {frame}: in place");
            assert_eq!(Scene::from(&scene.snapshot()).snapshot(), scene.snapshot(), "case {case}, frame {frame}");
            let (one, other) = (step(&mut scene, &map), step(&mut twin, &map));
            assert_eq!(one, other, "case {case}, frame {frame}");
            assert_eq!(scene.snapshot(), twin.snapshot(), "case {case}, frame {frame}");
            assert!(scene.bodies().eq(twin.bodies()) && scene.awake() == twin.awake());
            (slept, events) = (slept + scene.bodies().count() - scene.awake().len(), events + one.len());
        }
    }
    assert!(slept > 5000 && events > 8000, "nothing happens: {slept} asleep, {events} events");
}

#[test]
fn a_scene_that_is_put_back_goes_on_the_same() {
    goes_on(SortSweep::<BODIES, SceneTag>::new());
    goes_on(BruteForce::<BODIES, SceneTag>::new());
    goes_on(LooseGrid::<8, BODIES, SceneTag, true>::new(Vec2::ZERO, Fx::from_num(16), 16).unwrap());
    goes_on(SpatialHash::<64, BODIES, SceneTag, true>::new(Fx::from_num(16)).unwrap());
}
