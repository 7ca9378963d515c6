//! Scenes: the order of insertion and the broad phase change nothing. A copy is a snapshot.
//! Mirrored and shifted scenes stay equal bit for bit. No body enters the solid. Meetings keep
//! momentum and gain no energy. `TILESAT_CASES` makes the runs longer. Raw units, y down.

use core::num::NonZeroU8;
use tilesat::broad::{BroadPhase, BruteForce, LooseGrid, SortSweep, SpatialHash};
use tilesat::scene::{SceneBody, SceneEvent, SceneTag, Shape, Sleep, Stepped};
use tilesat::{Aabb, Circle, Filter, Fx, LayerMask, Outside, Ratio, Scene, Surface, Vec2};
use tilesat_judge::rooms::body::{Body, point, vec2};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, mosaic};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::{Random, cases};

const BODIES: usize = 32;
const GRAVITY: P = (0, 6554);

fn shape(body: Body) -> Shape {
    match body {
        Body::Rect(..) => {
            let (lo, hi) = body.bounds();
            Aabb::new(vec2(lo), vec2(hi)).unwrap().into()
        }
        Body::Disc(c, r) => Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap().into(),
        Body::Pill(..) => panic!("scenes have no capsules"),
    }
}

fn body(shape: Shape) -> Body {
    match shape {
        Shape::Aabb(b) => {
            let (lo, hi) = (point(b.min()), point(b.max()));
            Body::Rect(lo, (hi.0 - lo.0, hi.1 - lo.1))
        }
        Shape::Circle(c) => Body::Disc(point(c.centre()), c.radius().to_bits().into()),
    }
}

/// A level and bodies in it. Some are fixed, some are sensors, some overlap each other, and none is
/// in the solid.
fn crowd(r: &mut Random) -> (Level, Vec<SceneBody>) {
    let level = mosaic(r, (16, 12), 24 * PX, 12, 4);
    let (room, mut bodies) = (Room::new(&level), Vec::new());
    while bodies.len() < BODIES - 2 {
        let at = (r.within(0, 16 * 24 * PX), r.within(0, 12 * 24 * PX));
        let size = |r: &mut Random| r.within(6 * PX, 24 * PX) & !1;
        let it = if r.one_in(2) { Body::Disc(at, size(r) / 2) } else { Body::Rect(at, (size(r), size(r))) };
        if room.overlaps(it, (0, 0), 0) {
            continue;
        }
        let surface =
            Surface::new(Ratio::percent(r.below(101) as u8).unwrap(), Ratio::percent(r.below(101) as u8).unwrap())
                .resting_below(Fx::from_bits(r.below(3) as i32 * 20_000));
        let layers = LayerMask::layer(r.below(3) as u8);
        let filter = Filter::new(layers, if r.one_in(3) { LayerMask::ALL } else { layers | LayerMask::layer(0) });
        bodies.push(SceneBody {
            velocity: vec2((r.around(2 * PX), r.around(2 * PX))),
            mass: if r.one_in(6) { None } else { NonZeroU8::new(r.within(1, 9) as u8) },
            surface,
            filter: filter.with_sensor(r.one_in(6)),
            floats: r.one_in(5),
            ..SceneBody::new(shape(it), 100 + bodies.len() as u32)
        });
    }
    for body in &mut bodies {
        if body.mass.is_none() {
            body.velocity = Vec2::ZERO;
        }
    }
    (level, bodies)
}

/// Inserted in this order, with another body that leaves again, so that slots are reused.
fn filled<B: BroadPhase<Tag = SceneTag>>(near: B, bodies: &[&SceneBody], stranger: usize) -> Scene<B, BODIES> {
    let mut scene = Scene::with_sleep(near, Sleep { still: Fx::from_num(0.1), steps: 20 });
    let strangers: Vec<_> = (0..2).map(|_| scene.insert(bodies[stranger]).unwrap()).collect();
    for (k, body) in bodies.iter().enumerate() {
        if k == stranger {
            for &handle in &strangers {
                scene.remove(handle).unwrap();
            }
        }
        scene.insert(body).unwrap();
    }
    scene
}

/// The whole visible state of a scene, by key.
fn seen<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, BODIES>) -> Vec<(SceneBody, bool, bool)> {
    let (mut all, far) = (Vec::new(), Vec2::from_raw((1 << 29) - 1, (1 << 29) - 1));
    scene.near().in_region(&Aabb::new(Vec2::ZERO - far, far).unwrap(), |handle| {
        all.push((*scene.body(handle).unwrap(), scene.is_awake(handle).unwrap(), scene.is_supported(handle).unwrap()));
    });
    all.sort_by_key(|seen| seen.0.key);
    all
}

fn step<B: BroadPhase<Tag = SceneTag>>(scene: &mut Scene<B, BODIES>, level: &Level, gravity: P) -> Stepped {
    scene.step(&level.all(), vec2(gravity), |_| {}).unwrap()
}

#[test]
fn neither_order_nor_broad_phase_matters() {
    for case in 0..cases(20) {
        let mut r = Random::new(case);
        let (level, bodies) = crowd(&mut r);
        let mut shuffled: Vec<_> = bodies.iter().collect();
        let straight = shuffled.clone();
        r.shuffle(&mut shuffled);
        let mut one = filled(SortSweep::<BODIES, SceneTag>::new(), &straight, 0);
        let mut other = filled(SortSweep::<BODIES, SceneTag>::new(), &shuffled, 7);
        let mut brute = filled(BruteForce::<BODIES, SceneTag>::new(), &shuffled, 3);
        let grid = LooseGrid::<8, BODIES, SceneTag>::new(Vec2::ZERO, Fx::from_num(32), 16).unwrap();
        let mut grid = filled(grid, &straight, 11);
        let hash = SpatialHash::<64, BODIES, SceneTag>::new(Fx::from_num(32)).unwrap();
        let mut hash = filled(hash, &shuffled, 5);
        let mut slept = 0;
        for frame in 0..300 {
            let stepped = step(&mut one, &level, GRAVITY);
            let state = seen(&one);
            assert_eq!((stepped, &state), (step(&mut other, &level, GRAVITY), &seen(&other)), "{case}, {frame}");
            assert_eq!((stepped, &state), (step(&mut brute, &level, GRAVITY), &seen(&brute)), "{case}, {frame}");
            assert_eq!((stepped, &state), (step(&mut grid, &level, GRAVITY), &seen(&grid)), "{case}, {frame}");
            assert_eq!((stepped, &state), (step(&mut hash, &level, GRAVITY), &seen(&hash)), "{case}, {frame}");
            slept += stepped.slept;
            if frame % 97 == 50 {
                // Somewhere something explodes.
                let region = Aabb::new(Vec2::from_ints(40, 40), Vec2::from_ints(200, 200)).unwrap();
                one.wake_region(&region);
                other.wake_region(&region);
                brute.wake_region(&region);
                grid.wake_region(&region);
                hash.wake_region(&region);
            }
        }
        assert!(slept > 0, "{case}: nobody slept");
    }
}

#[test]
fn a_copy_is_a_snapshot() {
    for case in 0..cases(10) {
        let mut r = Random::new(1000 + case);
        let (level, bodies) = crowd(&mut r);
        let mut scene = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies.iter().collect::<Vec<_>>(), 0);
        let handle = scene.awake()[0];
        let run = |scene: &mut Scene<_, BODIES>, from: u32| {
            let log: Vec<_> = (from..from + 60)
                .map(|frame| {
                    if frame % 25 == 0 {
                        scene.push(handle, Vec2::from_ints(1, -2)).unwrap();
                    }
                    (step(scene, &level, GRAVITY), seen(scene))
                })
                .collect();
            (log, format!("{scene:?}"))
        };
        for from in [0, 60, 120] {
            let snapshot = scene;
            let first = run(&mut scene, from);
            let mut again = snapshot;
            assert_eq!(first, run(&mut again, from), "{case}");
            scene = again;
        }
    }
}

#[test]
fn mirrored_and_moved_scenes_are_images() {
    let far = View::Moved((-100 * 24 * PX + 7, 70 * 24 * PX - 3));
    let mut apart = 0;
    for case in 0..cases(60) {
        let mut r = Random::new(2000 + case);
        let (level, bodies) = crowd(&mut r);
        for view in [View::MirrorX, View::MirrorY, far] {
            let image = |b: &SceneBody| SceneBody {
                shape: shape(view.body(body(b.shape))),
                velocity: vec2(view.direction(point(b.velocity))),
                ..*b
            };
            // One-way tiles have a fixed up. In a flipped scene they are those of the other side.
            let (images, level_seen) = (bodies.iter().map(image).collect::<Vec<_>>(), view.level(&level));
            let mut scene = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies.iter().collect::<Vec<_>>(), 0);
            let mut other = filled(SortSweep::<BODIES, SceneTag>::new(), &images.iter().collect::<Vec<_>>(), 0);
            for frame in 0..120 {
                let mut degenerate = false;
                let stepped = scene
                    .step(&level.all(), vec2(GRAVITY), |event| {
                        if let SceneEvent::Touch { contact: Some(contact), .. } = event {
                            degenerate |= contact.is_degenerate();
                        }
                    })
                    .unwrap();
                assert_eq!(stepped, step(&mut other, &level_seen, view.direction(GRAVITY)));
                if degenerate {
                    apart += 1;
                    break;
                }
                for (one, image_of) in seen(&scene).iter().zip(seen(&other)) {
                    assert_eq!((image(&one.0), one.1, one.2), image_of, "{case}, {view:?}, {frame}");
                }
            }
        }
    }
    println!("{apart} runs ended at a contact without a direction");
    assert!(apart < cases(60) / 2);
}

#[test]
fn no_body_enters_the_solid() {
    let (mut bodies_moved, mut held, mut overlapping, mut case) = (0, 0, 0, 0);
    let wanted = 5_000 * cases(20);
    while bodies_moved < wanted {
        let mut r = Random::new(3000 + case);
        let (level, bodies) = crowd(&mut r);
        let room = Room::new(&level);
        let mut scene = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies.iter().collect::<Vec<_>>(), 0);
        scene.set_sleep(Sleep::NEVER);
        let mut before = seen(&scene);
        for frame in 0..250 {
            let stepped = step(&mut scene, &level, GRAVITY);
            bodies_moved += u64::from(stepped.moved);
            held += u64::from(stepped.held);
            overlapping += u64::from(stepped.overlapping);
            let after = seen(&scene);
            for (was, is) in before.iter().zip(&after) {
                assert!(
                    was.0.shape == is.0.shape || !room.overlaps(body(is.0.shape), (0, 0), 0),
                    "{case}, {frame}: {is:?} overlaps the level"
                );
            }
            before = after;
            if frame % 60 == 59 {
                let all: Vec<_> = scene.awake().to_vec();
                for handle in all {
                    scene.push(handle, vec2((r.around(6 * PX), r.around(6 * PX)))).unwrap();
                }
            }
        }
        case += 1;
        if case % 4 == 0 {
            eprintln!("{bodies_moved} of {wanted} motions, {overlapping} overlaps of bodies, {held} held");
        }
    }
    assert_eq!(held, 0);
}

/// Mass times velocity, and mass times its square.
fn sums<'a>(bodies: impl Iterator<Item = &'a SceneBody>) -> ((i128, i128), i128) {
    bodies.fold(((0, 0), 0), |(p, e), body| {
        let m = body.mass.map_or(0, |m| i128::from(m.get()));
        let (x, y) = body.velocity.raw();
        let (x, y) = (i128::from(x), i128::from(y));
        ((p.0 + m * x, p.1 + m * y), e + m * (x * x + y * y))
    })
}

/// Two at a time: exactly. In a crowd within roundings: less than a raw unit per component of each
/// change.
#[test]
fn meetings_keep_momentum_and_gain_no_energy() {
    let level = Level { tiles: vec![0], width: 1, height: 1, cell: PX, x: 0, y: 0, outside: Outside::Empty };
    let (mut met, mut lost, mut most) = (0, 0, 0);
    for case in 0..cases(300) {
        let mut r = Random::new(4000 + case);
        let (count, wide) = if case % 2 == 0 { (2, 20) } else { (r.within(3, 30), 120) };
        let mut bodies = Vec::new();
        for key in 0..count as u32 {
            let at = (r.around(wide * PX / 2), r.around(wide * PX / 2));
            let size = |r: &mut Random| r.within(10 * PX, 30 * PX) & !1;
            let it = if r.one_in(2) {
                Body::Disc(at, size(&mut r) / 2)
            } else {
                Body::Rect(at, (size(&mut r), size(&mut r)))
            };
            let ratio = |r: &mut Random| Ratio::percent([0, 100, r.below(101)][r.below(3) as usize] as u8).unwrap();
            let speed = [9, PX, 100 * PX][r.below(3) as usize];
            bodies.push(SceneBody {
                velocity: vec2((r.around(speed), r.around(speed))),
                mass: NonZeroU8::new(r.within(1, 255).min(r.within(1, 255)) as u8),
                surface: Surface::new(ratio(&mut r), ratio(&mut r)),
                ..SceneBody::new(shape(it), key)
            });
        }
        let mut scene = filled(SortSweep::<BODIES, SceneTag>::new(), &bodies.iter().collect::<Vec<_>>(), 0);
        scene.set_sleep(Sleep::NEVER);
        for _ in 0..20 {
            let (p, e) = sums(seen(&scene).iter().map(|s| &s.0));
            let mut contacts = 0;
            let stepped = scene
                .step(&level.all(), Vec2::ZERO, |event| {
                    contacts += i128::from(matches!(event, SceneEvent::Touch { contact: Some(_), .. }));
                })
                .unwrap();
            let (q, f) = sums(seen(&scene).iter().map(|s| &s.0));
            met += stepped.overlapping;
            assert_eq!(stepped.held, 0);
            if stepped.overlapping <= 1 {
                assert_eq!(q, p, "{case}");
                assert!(f <= e, "{case}: {e} became {f}");
            } else {
                // For each contact, each body's change is less than a raw unit per component short.
                let slack = contacts * 2 * 255;
                assert!((q.0 - p.0).abs() <= slack && (q.1 - p.1).abs() <= slack, "{case}: {p:?} became {q:?}");
                let fastest = seen(&scene).iter().map(|s| s.0.velocity.length().to_bits()).max().unwrap();
                assert!(f <= e + 4 * slack * (i128::from(fastest) + 2), "{case}: {e} became {f}");
                most = most.max(f - e);
            }
            lost += i32::from(f < e);
        }
    }
    println!("{met} meetings, {lost} steps that lost energy; gained at most {most} square raw units of mass 1");
    assert!(met > 300);
}

/// One body above another on a floor, also on a slope. After a step there is no more energy than
/// before it, with its gravity. Only the rounding of a change against gravity may add some.
#[test]
fn what_lies_on_a_body_gains_no_energy() {
    let mut carried = 0;
    for case in 0..cases(600) {
        let mut r = Random::new(5000 + case);
        let mut level = mosaic(&mut r, (8, 8), 24 * PX, 0, 0);
        for k in 48..64 {
            level.tiles[k] = if k < 56 { r.below(10) as u8 } else { 1 };
        }
        let room = Room::new(&level);
        let mut scene =
            filled(SortSweep::<BODIES, SceneTag>::new(), &[&SceneBody::fixed(shape(Body::Disc((0, 0), 2)), 9)], 0);
        let mut put = 0;
        while put < 2 {
            let at = (r.within(60 * PX, 100 * PX), r.within(80 * PX, 130 * PX));
            let size = |r: &mut Random| r.within(10 * PX, 20 * PX) & !1;
            let it = if r.one_in(2) {
                Body::Disc(at, size(&mut r) / 2)
            } else {
                Body::Rect(at, (size(&mut r), size(&mut r)))
            };
            if room.overlaps(it, (0, 0), 0) {
                continue;
            }
            let ratio = |r: &mut Random| Ratio::percent([0, 100, r.below(101)][r.below(3) as usize] as u8).unwrap();
            let body = SceneBody {
                velocity: vec2((r.around(2 * PX), r.around(4 * PX))),
                mass: NonZeroU8::new(r.within(1, 9) as u8),
                surface: Surface::new(ratio(&mut r), ratio(&mut r))
                    .resting_below(Fx::from_bits(r.below(2) as i32 * 20_000)),
                floats: r.one_in(4),
                ..SceneBody::new(shape(it), put)
            };
            scene.insert(&body).unwrap();
            put += 1;
        }
        scene.set_sleep(Sleep::NEVER);
        for frame in 0..150 {
            let mut before: Vec<_> = seen(&scene).into_iter().map(|s| s.0).collect();
            for body in before.iter_mut().filter(|body| body.mass.is_some() && !body.floats) {
                body.velocity += vec2(GRAVITY);
            }
            let mut met = false;
            let each = |event: SceneEvent<'_>| met |= matches!(event, SceneEvent::Touch { .. });
            scene.step(&level.all(), vec2(GRAVITY), each).unwrap();
            let after = seen(&scene);
            let (_, e) = sums(before.iter());
            let (_, f) = sums(after.iter().map(|s| &s.0));
            assert!(f <= e + 9 * 4 * i128::from(GRAVITY.1), "{case}, {frame}: {e} became {f}");
            carried += u64::from(met && after.iter().filter(|s| s.2).count() == 3);
        }
    }
    println!("{carried} steps in which one was carried by the other");
    assert!(carried > 1000);
}
