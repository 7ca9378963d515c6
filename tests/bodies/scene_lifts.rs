//! Piles of crates on lifts: awake or not, in a cart, and on lifts that are faster than a crate is
//! high.

use super::steps::open;
use tilesat::broad::SortSweep;
use tilesat::motion::Ride;
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::{Aabb, Circle, Fx, Joined, Scene, Solid, Solids, Vec2, fx};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::solids::{P, raw};

type Crates = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

const GRAVITY: Vec2 = Vec2::new(fx!(0), fx!(0.25));

fn rect(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}

fn units(n: i16) -> i64 {
    i64::from(n) << 16
}

fn step(scene: &mut Crates, solids: &[Solid]) {
    scene.step(&Joined::new(&open(), &Solids::new(solids)), GRAVITY, |_| {}).unwrap();
}

/// Rides by one motion of all solids. Returns the keys of the bodies with the reports about them.
fn ride(scene: &mut Crates, solids: &mut [Solid], motion: (i16, i16)) -> Vec<(u32, Ride)> {
    for solid in &mut *solids {
        solid.set_motion(Vec2::from_ints(motion.0, motion.1)).unwrap();
    }
    let mut told = Vec::new();
    scene.ride(&open(), solids, GRAVITY, fx!(16), |body, ride| told.push((body, ride.unwrap()))).unwrap();
    let mut told: Vec<_> = told.iter().map(|(body, ride)| (scene.body(*body).unwrap().key, *ride)).collect();
    told.sort_by_key(|told| told.0);
    told
}

/// The corners of the crates in raw units, by their keys from 1 on.
fn corners(scene: &Crates) -> Vec<P> {
    let mut all: Vec<_> = scene.bodies().map(|(_, body)| (body.key, raw(body.shape.position()))).collect();
    all.sort_by_key(|body| body.0);
    all.iter().map(|body| body.1).collect()
}

/// Crates of 10 by 10 upon each other, at rest on a floor at `y`.
fn column(crates: u32, y: i16, solids: &[Solid]) -> Crates {
    let mut scene = Crates::new(SortSweep::new());
    for k in 1..=crates {
        scene.insert(&SceneBody::new(rect(60, y - 10 * k as i16, 10, 10), k)).unwrap();
    }
    for _ in 0..60 {
        step(&mut scene, solids);
    }
    scene
}

/// Whatever has woken the lowest crate before its lift starts: the others go with it.
#[test]
fn a_pile_that_is_half_awake_goes_along() {
    for how in 0..5 {
        let mut lift = [Solid::new(rect(40, 100, 60, 6), 0).unwrap()];
        let mut scene = column(3, 100, &lift);
        assert!(scene.awake().is_empty());
        let lowest = scene.bodies().find(|(_, body)| body.key == 1).unwrap().0;
        match how {
            0 => {}
            1 => scene.wake(lowest).unwrap(),
            2 => scene.push(lowest, Vec2::from_raw(1, 0)).unwrap(),
            3 => {
                let ball = Circle::new(Vec2::from_ints(56, 96), fx!(4)).unwrap();
                scene.insert(&SceneBody::new(ball, 9)).unwrap();
            }
            _ => {
                let beside = scene.insert(&SceneBody::new(rect(70, 92, 8, 8), 9)).unwrap();
                scene.remove(beside).unwrap();
            }
        }
        for frame in 1..=20_i16 {
            ride(&mut scene, &mut lift, (0, 1));
            step(&mut scene, &lift);
            for (k, (_, y)) in corners(&scene).iter().take(3).enumerate() {
                assert_eq!(*y, units(90 - 10 * k as i16 + frame), "{how}, frame {frame}, crate {k}");
            }
        }
    }
}

/// A floor and a wall that touches the upper crate go together: the crates stay where they are on
/// the floor.
#[test]
fn a_cart_does_not_tear_its_pile() {
    for gap in [0, 1, 2, 5] {
        for motion in [(-2, 0), (2, 0), (-2, -1), (-2, 1)] {
            let mut cart = [rect(40, 100, 60, 6), rect(70 + gap, 60, 4, 32)].map(|shape| Solid::new(shape, 0).unwrap());
            let mut scene = column(2, 100, &cart);
            for frame in 1..=6 {
                ride(&mut scene, &mut cart, motion);
                step(&mut scene, &cart);
                let at = |y: i16| (units(60 + motion.0 * frame), units(y + motion.1 * frame));
                assert_eq!(corners(&scene), [at(90), at(80)], "gap {gap}, {motion:?}, frame {frame}");
            }
        }
    }
}

/// The floor passes into the second crate, or beyond it, within a frame.
#[test]
fn a_lift_may_be_faster_than_a_crate_is_high() {
    for up in [9, 10, 11, 12, 15] {
        let mut lift = [Solid::new(rect(40, 140, 60, 6), 0).unwrap()];
        let mut scene = column(3, 140, &lift);
        for frame in 1..=3 {
            ride(&mut scene, &mut lift, (0, -up));
            step(&mut scene, &lift);
            let at = |y: i16| (units(60), units(y - up * frame));
            assert_eq!(corners(&scene), [at(130), at(120), at(110)], "up by {up}, frame {frame}");
        }
    }
}

/// A shelf comes down as fast as the floor sinks.
#[test]
fn a_shelf_over_a_pile_sinks_with_it() {
    for gap in [0, 1, 2, 3] {
        let mut cabin = [rect(40, 100, 60, 6), rect(40, 76 - gap, 60, 4)].map(|shape| Solid::new(shape, 0).unwrap());
        let mut scene = column(2, 100, &cabin);
        for frame in 1..=6 {
            let told = ride(&mut scene, &mut cabin, (0, 3));
            assert!(told.iter().all(|told| !matches!(told.1, Ride::Squashed { .. })), "{told:?}");
            step(&mut scene, &cabin);
            let at = |y: i16| (units(60), units(y + 3 * frame));
            assert_eq!(corners(&scene), [at(90), at(80)], "gap {gap}, frame {frame}");
        }
    }
}

/// Gaps as they arise where a crate slid on a slope in the step before.
#[test]
fn a_crate_a_little_above_goes_along() {
    for gap in [0, 1, 2, 3, 14, 32] {
        let mut lift = [Solid::new(rect(40, 100, 60, 6), 0).unwrap()];
        let mut scene = column(2, 100, &lift);
        let upper = scene.bodies().find(|(_, body)| body.key == 2).unwrap().0;
        scene.place(upper, rect(60, 80, 10, 10).translated(Vec2::from_raw(0, -gap)).unwrap()).unwrap();
        ride(&mut scene, &mut lift, (5, 0));
        assert_eq!(scene.body(upper).unwrap().shape.position().x, Fx::from_num(65), "gap {gap}");
    }
}
