//! Scenes: pairs that the game refuses, bodies that it changes, floating bodies, and sensors that
//! wake nobody. Units, y down.

use super::steps::{Swept, step_with};
use core::num::NonZeroU8;
use tilesat::broad::{BroadError, BroadPhase, BruteForce, Handle, Pair, SortSweep, Tag};
use tilesat::scene::{Answer, SceneBody, SceneError, SceneEvent, SceneFault, SceneTag, Shape, Sleep, Stepped};
use tilesat::{Aabb, Circle, Filter, Fx, LayerMask, Ratio, Scene, Surface, Vec2};
use tilesat_judge::scenes::{BODIES, check, room};

const GRAVITY: Vec2 = Vec2::from_raw(0, 6554);

fn scene() -> Swept {
    Scene::new(SortSweep::new())
}

fn boxed(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}

fn run<B: BroadPhase<Tag = SceneTag>>(scene: &mut Scene<B, BODIES>, steps: u32) -> Stepped {
    (0..steps).map(|_| scene.step(&room(), GRAVITY, |_| {}).unwrap()).last().unwrap()
}

/// A sequence without a pattern that matters here.
struct Random(u64);

impl Random {
    fn below(&mut self, n: i16) -> i16 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n.unsigned_abs() as u64) as i16
    }

    fn body(&mut self, key: u32) -> SceneBody {
        let (x, y, size) = (16 + self.below(140), self.below(48), 4 + 2 * self.below(5));
        let shape: Shape = match self.below(2) {
            0 => boxed(x, y, size, size).into(),
            _ => Circle::new(Vec2::from_ints(x + 8, y + 6), Fx::from_num(size / 2)).unwrap().into(),
        };
        let ratio = |r: &mut Self| Ratio::percent(r.below(101) as u8).unwrap();
        SceneBody {
            velocity: Vec2::from_raw(i32::from(self.below(20_000)) * 8, 0),
            mass: NonZeroU8::new(self.below(6) as u8),
            surface: Surface::new(ratio(self), ratio(self)).resting_below(Fx::from_num(0.5)),
            filter: self.filter(),
            floats: self.below(5) == 0,
            ..SceneBody::new(shape, key)
        }
    }

    fn filter(&mut self) -> Filter {
        let mask = |r: &mut Self| LayerMask(1 + r.below(15) as u16);
        Filter::new(mask(self), mask(self)).with_sensor(self.below(6) == 0)
    }
}

fn filled<B: BroadPhase<Tag = SceneTag>>(near: B, bodies: &[SceneBody]) -> Scene<B, BODIES> {
    let mut scene = Scene::with_sleep(near, Sleep { steps: 15, ..Sleep::default() });
    for body in bodies {
        assert!(scene.insert(body).is_ok());
    }
    scene
}

type Change = fn(&mut SceneBody);

/// The positions of all bodies, and which are awake.
fn seen<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, BODIES>) -> Vec<(u32, Shape, Vec2, bool, bool)> {
    let seen = |(handle, body): (Handle, &SceneBody)| {
        (body.key, body.shape, body.velocity, scene.is_awake(handle).unwrap(), scene.is_supported(handle).unwrap())
    };
    scene.bodies().map(seen).collect()
}

/// The filters say the same as a veto in a scene in which all bodies meet.
#[test]
fn a_refused_pair_is_as_if_it_were_none() {
    let (mut refused, mut slept, mut woken) = (0, 0, 0);
    for case in 0..60 {
        let mut r = Random(case);
        let bodies: Vec<_> = (0..BODIES as u32).map(|key| r.body(key)).collect();
        let open: Vec<_> = bodies
            .iter()
            .map(|body| SceneBody { filter: Filter::default().with_sensor(body.filter.sensor()), ..*body })
            .collect();
        let mut one = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies);
        let mut other = filled(SortSweep::<BODIES, SceneTag>::new(), &open);
        for frame in 0..200 {
            let (mut told, mut told_other) = (Vec::new(), Vec::new());
            let log = |told: &mut Vec<_>, event: SceneEvent<'_>| {
                if let SceneEvent::Touch { pair, contact } = event {
                    told.push((pair, contact.copied()));
                }
            };
            let a = one.step(&room(), GRAVITY, |event| log(&mut told, event)).unwrap();
            let mut counts = |pair: Pair| {
                let pass = bodies[pair.a.slot()].filter.pairs_with(&bodies[pair.b.slot()].filter);
                refused += u32::from(!pass);
                pass.reply()
            };
            let b =
                step_with(&mut other, &room(), GRAVITY, &mut counts, &mut |event| log(&mut told_other, event)).unwrap();
            told.sort_by_key(|told| told.0);
            told_other.sort_by_key(|told| told.0);
            assert_eq!(told, told_other, "{case}, {frame}");
            assert_eq!(a, Stepped { pairs: a.pairs, ..b }, "{case}, {frame}");
            assert_eq!(seen(&one), seen(&other), "{case}, {frame}");
            (slept, woken) = (slept + a.slept, woken + a.woken);
        }
    }
    println!("{refused} refused, {slept} slept, {woken} woken");
    assert!(refused > 10_000 && slept > 300 && woken > 30);
}

#[test]
fn a_veto_that_says_now_this_now_that_breaks_nothing() {
    for case in 0..20 {
        let (mut r, mut asked) = (Random(100 + case), Random(case));
        let bodies: Vec<_> =
            (0..BODIES as u32).map(|key| SceneBody { velocity: Vec2::from_ints(4000, 0), ..r.body(key) }).collect();
        let mut scene = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies);
        for _ in 0..60 {
            step_with(&mut scene, &room(), GRAVITY, &mut |_| (asked.below(2) == 0).reply(), &mut |_| {}).unwrap();
            check(&scene);
            assert!(scene.bodies().all(|(_, body)| body.mass.is_none()
                || !body.shape.overlaps_level(&room())
                || body.velocity == Vec2::ZERO));
        }
    }
}

/// Random changes. The scene stays consistent on every broad phase.
#[test]
fn bodies_may_be_altered_in_any_way() {
    let mut turned = 0;
    for case in 0..40 {
        let mut r = Random(1000 + case);
        let bodies: Vec<_> = (0..16).map(|key| r.body(key)).collect();
        let mut one = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies);
        let mut other = filled(BruteForce::<BODIES, SceneTag>::new(), &bodies);
        let handles: Vec<_> = one.bodies().map(|(handle, _)| handle).collect();
        for frame in 0..150 {
            if frame % 4 == 0 {
                let handle = handles[r.below(16) as usize];
                let (what, new) = (r.below(6), r.body(500 + frame));
                let change = |body: &mut SceneBody| match what {
                    0 => body.mass = new.mass,
                    1 => body.filter = new.filter,
                    2 => (body.surface, body.floats) = (new.surface, new.floats),
                    3 => body.key = 1000 * case as u32 + new.key,
                    4 => body.shape = new.shape,
                    _ => *body = SceneBody { key: body.key, ..new },
                };
                let was = one.body(handle).unwrap().mass.is_some();
                one.alter(handle, change).unwrap();
                other.alter(handle, change).unwrap();
                let moves = one.body(handle).unwrap().mass.is_some();
                assert_eq!(one.is_awake(handle), Ok(moves));
                turned += u32::from(was != moves);
                check(&one);
                check(&other);
            }
            assert_eq!(run(&mut one, 1), run(&mut other, 1));
            assert_eq!(seen(&one), seen(&other), "{case}, {frame}");
        }
        check(&one);
    }
    assert!(turned > 50, "{turned}");
}

#[test]
fn what_is_altered_wakes_its_neighbours() {
    let ghost = Filter::new(LayerMask::NONE, LayerMask::NONE);
    let changes: [(&str, Change, bool); 5] = [
        ("filter", |body| body.filter = Filter::new(LayerMask::layer(1), LayerMask::ALL), true),
        ("mass", |body| body.mass = NonZeroU8::new(9), true),
        ("fixed", |body| body.mass = None, true),
        ("surface", |body| body.surface = Surface::new(Ratio::ONE, Ratio::ONE), false),
        ("velocity", |body| body.velocity = Vec2::ZERO, false),
    ];
    for (name, change, wakes) in changes {
        let mut scene = scene();
        let below = scene.insert(&SceneBody::new(boxed(40, 54, 10, 10), 1)).unwrap();
        let above = scene.insert(&SceneBody::new(boxed(40, 44, 10, 10), 2)).unwrap();
        run(&mut scene, 60);
        assert!(scene.awake().is_empty());
        scene.alter(below, change).unwrap();
        assert_eq!(scene.is_awake(above), Ok(wakes), "{name}");
        // And then the top body knows that nothing carries it.
        scene.alter(below, |body| body.filter = ghost).unwrap();
        run(&mut scene, 60);
        assert_eq!(scene.body(above).unwrap().shape, boxed(40, 54, 10, 10).into());
        assert!(scene.awake().is_empty());
    }
}

#[test]
fn a_refused_change_changes_nothing() {
    let mut scene = scene();
    let handle = scene.insert(&SceneBody::new(boxed(40, 20, 10, 10), 1)).unwrap();
    run(&mut scene, 100);
    let before = format!("{scene:?}");
    let fast = |body: &mut SceneBody| {
        *body = SceneBody { velocity: Vec2::from_ints(0, -4096), ..SceneBody::fixed(boxed(0, 0, 5, 5), 9) };
    };
    let error = scene.alter(handle, fast).unwrap_err();
    assert_eq!(
        error.to_string(),
        "body 0 (generation 1): MotionY is out of range: -4096 (-268435456 raw); a motion must be less than 4096 units on each axis"
    );
    assert_eq!(format!("{scene:?}"), before);
    scene.remove(handle).unwrap();
    let stale = SceneError { body: Some(handle), fault: SceneFault::Broad(BroadError::Stale(handle)) };
    assert_eq!(stale.to_string(), "body 0 (generation 1) was removed: drop its handle");
    assert_eq!(scene.alter(handle, |_| panic!("nobody is asked")), Err(stale));
}

#[test]
fn what_floats_does_not_fall() {
    let mut scene = scene();
    let balloon = SceneBody { floats: true, ..SceneBody::new(boxed(40, 20, 10, 10), 1) };
    let lift = SceneBody { velocity: Vec2::from_raw(6000, -3000), ..SceneBody::new(boxed(80, 40, 8, 8), 2) };
    let lift = scene.insert(&SceneBody { floats: true, ..lift }).unwrap();
    let balloon = scene.insert(&balloon).unwrap();
    run(&mut scene, 20);
    let at = |scene: &Swept, handle| scene.body(handle).unwrap().shape.position();
    assert_eq!(at(&scene, lift), Vec2::from_ints(80, 40) + Vec2::from_raw(120_000, -60_000));
    run(&mut scene, 40);
    // It sleeps in the air. A push wakes it, and only the wall stops it.
    assert_eq!(at(&scene, balloon), Vec2::from_ints(40, 20));
    assert_eq!(scene.is_awake(balloon), Ok(false));
    scene.push(balloon, Vec2::from_ints(-1, 0)).unwrap();
    run(&mut scene, 60);
    assert_eq!(at(&scene, balloon), Vec2::from_ints(16, 20));
    // It lands on a fixed body and stays there.
    let shelf = scene.insert(&SceneBody::fixed(boxed(10, 40, 30, 4), 3)).unwrap();
    scene.set_velocity(balloon, Vec2::from_ints(0, 1)).unwrap();
    run(&mut scene, 60);
    assert_eq!(at(&scene, balloon), Vec2::from_ints(16, 30));
    assert_eq!(scene.body(balloon).unwrap().velocity, Vec2::ZERO);
    scene.remove(shelf).unwrap();
    scene.alter(balloon, |body| body.floats = false).unwrap();
    run(&mut scene, 60);
    assert_eq!(at(&scene, balloon), Vec2::from_ints(16, 54));
}

#[test]
fn sensors_wake_nobody() {
    let mut scene = scene();
    let sleeper = scene.insert(&SceneBody::new(boxed(40, 54, 10, 10), 1)).unwrap();
    run(&mut scene, 60);
    assert!(scene.awake().is_empty());
    let zone = SceneBody { filter: Filter::default().with_sensor(true), ..SceneBody::fixed(boxed(36, 50, 8, 8), 2) };
    let trap = scene.insert(&zone).unwrap();
    scene.place(trap, boxed(42, 50, 8, 8)).unwrap();
    scene.set_velocity(trap, Vec2::from_ints(1, 0)).unwrap();
    scene.alter(trap, |body| body.filter.group = 3).unwrap();
    assert!(scene.awake().is_empty());
    // Both rest, so the game hears of nobody until one of them moves: the sleeper, or a sensor with
    // a mass.
    let touches = |scene: &mut Swept| {
        let mut told = 0;
        scene.step(&room(), GRAVITY, |event| told += u32::from(matches!(event, SceneEvent::Touch { .. }))).unwrap();
        told
    };
    assert_eq!(touches(&mut scene), 0);
    scene.alter(trap, |body| (body.mass, body.floats, body.velocity) = (NonZeroU8::new(1), true, Vec2::ZERO)).unwrap();
    assert_eq!(scene.awake(), [trap]);
    assert_eq!(touches(&mut scene), 1);
    assert_eq!(scene.awake(), [trap]);
    scene.remove(trap).unwrap();
    assert!(scene.awake().is_empty());
    // A body that becomes solid wakes, and so does one that stops being solid.
    let trap = scene.insert(&zone).unwrap();
    scene.alter(trap, |body| body.filter = Filter::default()).unwrap();
    assert_eq!(scene.awake(), [sleeper]);
    run(&mut scene, 90);
    assert!(scene.awake().is_empty());
    scene.alter(trap, |body| body.filter = zone.filter).unwrap();
    assert_eq!(scene.awake(), [sleeper]);
}

#[test]
fn bodies_come_by_slot() {
    let mut scene = scene();
    let body = |key| SceneBody::new(boxed(20 + 12 * key as i16, 20, 10, 10), key);
    let handles: Vec<_> = (0..5).map(|key| scene.insert(&body(9 - key)).unwrap()).collect();
    scene.remove(handles[1]).unwrap();
    scene.remove(handles[3]).unwrap();
    let again = scene.insert(&body(2)).unwrap();
    let all: Vec<_> = scene.bodies().map(|(handle, body)| (handle, body.key)).collect();
    let mut wanted = vec![(handles[0], 9), (handles[2], 7), (handles[4], 5), (again, 2)];
    wanted.sort_by_key(|(handle, _)| handle.slot());
    assert_eq!(all, wanted);
    assert_ne!(again.generation(), handles[1].generation());
}
