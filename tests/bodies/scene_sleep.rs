//! Scenes: which bodies rest, which wake, and the cost. Stacks, sensors, fixed bodies and refusals.
//! Units, y down.

use core::num::NonZeroU8;
use tilesat::broad::{Border, BroadError, BroadPhase, Handle, LooseGrid, Pair, PairEvent, PairEvents, SortSweep};
use tilesat::prelude::*;
use tilesat::scene::{SceneBody, SceneError, SceneEvent, SceneFault, SceneTag, Shape, Sleep, Stepped};
use tilesat::{
    Aabb, Circle, Filter, Fx, LayerMask, MoveError, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, Vec2,
};
use tilesat_judge::scenes::BODIES;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// Cells of 16: the floor is at y = 128.
const ROOM: &str = "\
#..............#
#..............#
#..............#
#..............#
#..............#
#..............#
#..............#
#..............#
################
";
const GRAVITY: Vec2 = Vec2::from_raw(0, 6554);

type Bodies = Scene<SortSweep<64, SceneTag>, 64>;

fn room(rows: &str) -> TileMap<'_> {
    TileMap::from_ascii(rows, &KINDS).unwrap()
}

fn scene() -> Bodies {
    Scene::new(SortSweep::new())
}

fn boxed(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}

fn ball(x: i16, y: i16, r: i16) -> Circle {
    Circle::new(Vec2::from_ints(x, y), Fx::from_num(r)).unwrap()
}

fn run(scene: &mut Bodies, map: &TileMap<'_>, steps: u32) -> Stepped {
    (0..steps).map(|_| scene.step(map, GRAVITY, |_| {}).unwrap()).last().unwrap()
}

fn asleep(scene: &Bodies, handles: &[Handle]) -> bool {
    handles.iter().all(|&handle| !scene.is_awake(handle).unwrap())
}

fn bottom(scene: &Bodies, handle: Handle) -> f64 {
    scene.body(handle).unwrap().shape.aabb().max().y.to_num()
}

/// A stack that stands on the floor, in no order.
fn stack(scene: &mut Bodies, height: i16) -> Vec<Handle> {
    let crates = (0..height).map(|k| (k * 7) % height);
    let mut handles: Vec<_> = crates
        .map(|k| (k, scene.insert(&SceneBody::new(boxed(100, 128 - 10 * (k + 1), 12, 10), k as u32)).unwrap()))
        .collect();
    handles.sort_by_key(|handle| handle.0);
    handles.into_iter().map(|handle| handle.1).collect()
}

#[test]
fn stacks_come_to_rest_and_sleep() {
    let map = room(ROOM);
    for height in [1, 2, 3, 5, 8, 11] {
        let mut scene = scene();
        let handles = stack(&mut scene, height);
        let mut slept_after = 0;
        while !asleep(&scene, &handles) {
            run(&mut scene, &map, 1);
            slept_after += 1;
            assert!(slept_after < 200, "{height}: {:?}", scene.body(handles[0]));
        }
        // Each sinks into the one below by the fall of a step.
        for (k, &handle) in handles.iter().enumerate() {
            let sunk = bottom(&scene, handle) - f64::from(128 - 10 * k as i16);
            assert!((0.0..=0.1001 * f64::from(k as u32)).contains(&sunk), "{height}: crate {k} sank by {sunk}");
            assert!(scene.is_supported(handle).unwrap());
        }
        println!("a stack of {height} sleeps after {slept_after} steps");
        assert_eq!(run(&mut scene, &map, 1), Stepped::default());
    }
}

#[test]
fn a_heap_of_boxes_and_balls_comes_to_rest() {
    let map = room(ROOM);
    let mut scene = scene();
    let rubber =
        Surface::new(Ratio::percent(40).unwrap(), Ratio::percent(30).unwrap()).resting_below(Fx::from_num(0.5));
    for k in 0..40_i16 {
        let (x, y) = (22 + 12 * (k % 13) + k, 20 + 16 * (k / 13));
        let shape: Shape = if k % 2 == 0 { boxed(x, y, 8, 10).into() } else { ball(x + 5, y + 5, 5).into() };
        scene.insert(&SceneBody { surface: rubber, ..SceneBody::new(shape, k as u32) }).unwrap();
    }
    let mut steps = 0;
    while !scene.awake().is_empty() {
        let stepped = run(&mut scene, &map, 1);
        assert_eq!((usize::from(stepped.moved), stepped.held), (scene.awake().len() + usize::from(stepped.slept), 0));
        steps += 1;
        assert!(steps < 5000, "{} still awake", scene.awake().len());
    }
    println!("a heap of 40 sleeps after {steps} steps");
}

#[test]
fn asleep_costs_nothing_and_what_is_awake_costs_itself() {
    let map = room(ROOM);
    let mut scene = scene();
    for k in 0..13 {
        scene.insert(&SceneBody::new(boxed(20 + 16 * k, 118, 10, 10), k as u32)).unwrap();
    }
    assert_eq!(run(&mut scene, &map, 1).moved, 13);
    run(&mut scene, &map, 40);
    for _ in 0..100 {
        let mut told = 0;
        assert_eq!(scene.step(&map, GRAVITY, |_| told += 1).unwrap(), Stepped::default());
        assert_eq!(told, 0);
    }
    let fly = scene.insert(&SceneBody::new(ball(120, 20, 3), 99)).unwrap();
    let stepped = run(&mut scene, &map, 1);
    assert_eq!((stepped.moved, stepped.pairs), (1, 0));
    assert_eq!(scene.awake(), [fly]);
}

#[test]
fn a_touch_wakes_and_the_island_follows() {
    let map = room(ROOM);
    let mut scene = scene();
    let handles = stack(&mut scene, 4);
    run(&mut scene, &map, 60);
    assert!(asleep(&scene, &handles));
    let stone = scene.insert(&SceneBody::new(ball(106, 60, 4), 9)).unwrap();
    let mut woken = Vec::new();
    for step in 0..60 {
        woken.extend((0..run(&mut scene, &map, 1).woken).map(|_| step));
    }
    // The top one, and the ones below with it.
    assert_eq!(woken.len(), 4);
    assert!(woken.iter().all(|&step| step == woken[0]), "{woken:?}");
    run(&mut scene, &map, 200);
    assert!(asleep(&scene, &handles) && asleep(&scene, &[stone]));
}

#[test]
fn a_push_wakes() {
    let map = room(ROOM);
    let mut scene = scene();
    let handles = stack(&mut scene, 1);
    run(&mut scene, &map, 60);
    assert!(asleep(&scene, &handles));
    scene.push(handles[0], Vec2::from_ints(1, 0)).unwrap();
    assert_eq!(scene.awake(), handles);
    run(&mut scene, &map, 1);
    assert_eq!(scene.body(handles[0]).unwrap().shape.position(), Vec2::from_ints(101, 118));
}

#[test]
fn a_tile_that_changes_wakes_who_is_told() {
    let mut scene = scene();
    let map = room(ROOM);
    let handles = stack(&mut scene, 3);
    run(&mut scene, &map, 60);
    // The floor is gone, and no body knows.
    let hole = ROOM.replace("################", "######...#######");
    let open = room(&hole);
    assert_eq!(run(&mut scene, &open, 50), Stepped::default());
    scene.wake_region(&boxed(96, 128, 48, 16));
    assert_eq!(scene.awake(), [handles[0]]); // the box of the tiles touches that one
    run(&mut scene, &open, 20);
    assert!(handles.iter().all(|&handle| bottom(&scene, handle) > 129.0 - 20.0));
    assert!(bottom(&scene, handles[0]) > 128.0);
}

#[test]
fn what_stood_on_a_body_wakes_when_it_goes() {
    let map = room(ROOM);
    for taken in [true, false] {
        let mut scene = scene();
        let handles = stack(&mut scene, 3);
        run(&mut scene, &map, 60);
        assert!(asleep(&scene, &handles));
        if taken {
            let gone = scene.remove(handles[0]).unwrap();
            assert_eq!(gone.key, 0);
        } else {
            scene.place(handles[0], boxed(40, 118, 12, 10)).unwrap();
        }
        run(&mut scene, &map, 300);
        assert!((bottom(&scene, handles[2]) - 118.0).abs() < 0.3, "{taken}: {}", bottom(&scene, handles[2]));
        assert!(asleep(&scene, &handles[1..]));
    }
}

#[test]
fn an_island_sleeps_together() {
    let map = room(ROOM);
    let mut scene = scene();
    scene.set_sleep(Sleep { still: Fx::from_num(0.05), steps: 10 });
    // A row of crates, each overlapping the next, on the floor; a fly hops on the last.
    let row: Vec<_> =
        (0..12).map(|k| scene.insert(&SceneBody::new(boxed(30 + 10 * k, 118, 10, 10), k as u32)).unwrap()).collect();
    let fly = scene.insert(&SceneBody::new(ball(145, 113, 5), 50)).unwrap();
    for step in 0..100 {
        // It moves to and fro, and always touches the last crate.
        scene.set_velocity(fly, Vec2::from_raw(if step % 2 == 0 { 20_000 } else { -20_000 }, 0)).unwrap();
        assert_eq!(run(&mut scene, &map, 1).slept, 0, "step {step}");
        assert!(scene.is_awake(row[0]).unwrap());
    }
    scene.remove(fly).unwrap();
    run(&mut scene, &map, 12);
    assert!(asleep(&scene, &row));
}

#[test]
fn sensors_sense_and_do_not_push() {
    let map = room(ROOM);
    let mut scene = scene();
    let zone = Filter::default().with_sensor(true);
    let trap = scene.insert(&SceneBody { filter: zone, ..SceneBody::fixed(boxed(90, 72, 30, 56), 1) }).unwrap();
    let hero = scene.insert(&SceneBody::new(boxed(100, 60, 10, 10), 2)).unwrap();
    // One falls on the other inside.
    scene.insert(&SceneBody { velocity: Vec2::from_ints(0, 4), ..SceneBody::new(ball(104, 20, 4), 3) }).unwrap();
    let mut alone = scene;
    alone.remove(trap).unwrap();
    let mut events = PairEvents::<8>::new();
    let (mut log, mut lone) = (Vec::new(), Vec::new());
    for step in 0..120 {
        scene
            .step(&map, GRAVITY, |event| {
                if let SceneEvent::Touch { pair, .. } = event {
                    events.feed(pair);
                }
            })
            .unwrap();
        events.finish(|pair| scene.rests(pair)).unwrap();
        log.extend(events.iter().filter(|event| !matches!(event, PairEvent::Stay(_))).map(|event| (step, event)));
        alone.step(&map, GRAVITY, |_| {}).unwrap();
        lone.push(alone.body(hero).unwrap().shape);
        assert_eq!(scene.body(hero), alone.body(hero));
    }
    assert!(asleep(&scene, &[hero]));
    // It begins when the boxes first touch, and does not end while it sleeps.
    log.retain(|(_, event)| event.pair().a == trap && event.pair().b == hero);
    assert!(matches!(log[..], [(_, PairEvent::Begin(_))]), "{log:?}");
    let first = lone.iter().position(|shape| shape.touches(&scene.body(trap).unwrap().shape)).unwrap();
    assert_eq!(log[0].0, first + 1);
}

#[test]
fn fixed_bodies_are_moved_by_nobody() {
    let map = room(ROOM);
    let mut scene = scene();
    let shelf = scene.insert(&SceneBody::fixed(boxed(80, 80, 60, 8), 1)).unwrap();
    let heavy =
        SceneBody { mass: NonZeroU8::new(255), velocity: Vec2::from_ints(0, 5), ..SceneBody::new(ball(100, 30, 8), 2) };
    let stone = scene.insert(&heavy).unwrap();
    let before = *scene.body(shelf).unwrap();
    run(&mut scene, &map, 200);
    assert_eq!(scene.body(shelf).unwrap(), &before);
    for _ in 0..3 {
        println!("{:?} {:?}", run(&mut scene, &map, 1), scene.body(stone).unwrap().shape);
    }
    assert!(asleep(&scene, &[stone]) && (bottom(&scene, stone) - 80.0).abs() < 0.11);
    // A body that stands on it wakes when it moves.
    scene.place(shelf, boxed(80, 78, 60, 8)).unwrap();
    assert!(scene.is_awake(stone).unwrap() && !scene.is_awake(shelf).unwrap());
    run(&mut scene, &map, 1);
    assert!((bottom(&scene, stone) - 78.0).abs() < 0.3);
    run(&mut scene, &map, 60);
    assert!(asleep(&scene, &[stone]));
    // So does a body that it touches from far away.
    let door = scene.insert(&SceneBody::fixed(boxed(20, 20, 8, 8), 3)).unwrap();
    assert!(asleep(&scene, &[stone]));
    scene.place(door, boxed(108, 60, 8, 8)).unwrap();
    assert_eq!(scene.awake(), [stone]);
}

#[test]
fn a_conveyor_takes_along_what_rubs_on_it() {
    let map = room(ROOM);
    let scene = scene();
    let surface = Surface::new(Ratio::ZERO, Ratio::HALF);
    let belt = SceneBody { velocity: Vec2::from_ints(1, 0), surface, ..SceneBody::fixed(boxed(40, 80, 120, 8), 1) };
    let load = SceneBody { surface, ..SceneBody::new(boxed(50, 70, 10, 10), 2) };
    for keys in [(1, 2), (2, 1)] {
        let mut scene = scene;
        scene.insert(&SceneBody { key: keys.0, ..belt }).unwrap();
        let load = scene.insert(&SceneBody { key: keys.1, ..load }).unwrap();
        run(&mut scene, &map, 40);
        let heights: Vec<_> = (0..20)
            .map(|_| {
                run(&mut scene, &map, 1);
                scene.body(load).unwrap().shape.position().y
            })
            .collect();
        assert!(heights.iter().all(|&y| y == heights[0]), "{heights:?}");
        assert_eq!(scene.body(load).unwrap().velocity.x, 1);
        assert!(scene.is_supported(load).unwrap());
    }
}

#[test]
fn layers_are_asked_before_shapes() {
    let map = room(ROOM);
    let mut scene = scene();
    let ghost = Filter::new(LayerMask::layer(1), LayerMask::layer(2));
    let one = scene.insert(&SceneBody { filter: ghost, ..SceneBody::new(boxed(100, 118, 10, 10), 1) }).unwrap();
    let other = scene.insert(&SceneBody { filter: ghost, ..SceneBody::new(boxed(102, 118, 10, 10), 2) }).unwrap();
    let stepped = run(&mut scene, &map, 10);
    assert_eq!((stepped.pairs, stepped.touching), (0, 0));
    assert_eq!(scene.body(one).unwrap().shape, boxed(100, 118, 10, 10).into());
    assert_eq!(scene.body(other).unwrap().shape, boxed(102, 118, 10, 10).into());
}

#[test]
fn refusals_change_nothing() {
    let map = room(ROOM);
    let mut small: Scene<SortSweep<4, SceneTag>, 2> = Scene::new(SortSweep::new());
    let body = SceneBody::new(boxed(40, 40, 10, 10), 1);
    let first = small.insert(&body).unwrap();
    small.insert(&body).unwrap();
    let full = SceneError { body: None, fault: SceneFault::Broad(BroadError::Full { capacity: 2 }) };
    let before = format!("{small:?}");
    assert_eq!(small.insert(&body), Err(full));
    assert_eq!(format!("{small:?}"), before, "nor does the broad phase, which has more room");
    assert_eq!((small.near().len(), small.awake().len()), (2, 2));
    let fast = Vec2::from_ints(4096, 0);
    let fault = small.set_velocity(first, fast).unwrap_err();
    assert!(fault.body == Some(first) && matches!(fault.fault, SceneFault::Move(MoveError::Range(_))));
    assert!(small.insert(&SceneBody { velocity: fast, ..body }).is_err());
    assert_eq!((small.body(first), format!("{small:?}")), (Ok(&body), before));
    let removed = small.remove(first).unwrap();
    assert_eq!(removed, body);
    let stale = Err(SceneError { body: Some(first), fault: SceneFault::Broad(BroadError::Stale(first)) });
    assert_eq!(small.push(first, Vec2::ZERO), stale);
    assert_eq!(small.wake(first), stale);
    assert_eq!(small.place(first, boxed(0, 0, 1, 1)), stale);
    assert_eq!(small.remove(first).map(|_| ()), stale);
    assert_eq!(small.body(first).map(|_| ()), stale);
    let other = small.insert(&body).unwrap();
    assert_eq!((other.slot(), small.push(first, Vec2::ZERO)), (first.slot(), stale)); // another body has its slot
    assert!(!small.rests(&Pair { a: first, b: other }));
    small.remove(other).unwrap();
    assert_eq!(small.awake().len(), 1);
    // A step of the small scene would be compiled only for this.
    let mut scene = scene();
    scene.insert(&body).unwrap();
    let before = format!("{scene:?}");
    let fault = scene.step(&map, fast, |_| panic!("nothing happens")).unwrap_err();
    assert!(fault.body.is_none() && format!("{scene:?}") == before);
    assert_eq!(
        fault.to_string(),
        "MotionX is out of range: 4096 (268435456 raw); a motion must be less than 4096 units on each axis"
    );
}

#[test]
fn what_cannot_be_moved_is_held_and_told() {
    // A grid that ends below the room, and refuses bodies outside it.
    let mut scene: Scene<LooseGrid<8, BODIES, SceneTag>, BODIES> =
        Scene::new(LooseGrid::new(Vec2::ZERO, Fx::from_num(64), 32).unwrap().with_border(Border::Refuse));
    let hole = ROOM.replace("################", "......##########");
    let map = room(&hole);
    let out = scene.insert(&SceneBody::new(boxed(30, 100, 10, 10), 1)).unwrap();
    let stuck = scene.insert(&SceneBody::new(boxed(150, 124, 10, 10), 2)).unwrap();
    let free = scene.insert(&SceneBody::new(boxed(200, 20, 10, 10), 3)).unwrap();
    let (mut held, mut last) = (Vec::new(), Stepped::default());
    for _ in 0..200 {
        held.clear();
        last = scene
            .step(&map, GRAVITY, |event| {
                if let SceneEvent::Held { body, .. } = event {
                    held.push(body);
                }
            })
            .unwrap();
        assert!(scene.body(stuck).unwrap().shape == boxed(150, 124, 10, 10).into());
    }
    // All three rest now, held or not.
    assert_eq!((last, held.len()), (Stepped::default(), 0));
    scene.wake(out).unwrap();
    scene.wake(stuck).unwrap();
    let mut faults = Vec::new();
    let stepped = scene
        .step(&map, GRAVITY, |event| {
            if let SceneEvent::Held { body, fault } = event {
                faults.push((body, fault));
            }
        })
        .unwrap();
    println!("{faults:?} {:?}", scene.body(out));
    assert_eq!((stepped.moved, stepped.held), (2, 2));
    let of = |handle| faults.iter().find(|(body, _)| *body == handle).unwrap().1;
    assert!(matches!(of(out), SceneFault::Broad(BroadError::OutOfWorld { .. })));
    assert!(matches!(of(stuck), SceneFault::Move(MoveError::Stuck(_))));
    assert!(scene.body(free).unwrap().shape == boxed(200, 118, 10, 10).into());
}

/// A body that drifts may first touch another one in the step in which it has rested for long
/// enough. It sleeps only once that was reported.
#[test]
fn a_touch_begins_before_both_rest() {
    let map = room(ROOM);
    let sensor = SceneBody { filter: Filter::default().with_sensor(true), ..SceneBody::fixed(boxed(120, 40, 8, 8), 2) };
    let others = [SceneBody::fixed(boxed(120, 40, 8, 8), 2), sensor, SceneBody::new(boxed(120, 40, 8, 8), 2)];
    let (mut touched, mut apart) = (0, 0);
    for (case, other) in (0..).zip(others) {
        for gap in (0..40).map(|k| 1000 * k + 300) {
            let (mut scene, mut events) = (scene(), PairEvents::<8>::new());
            let other = scene.insert(&SceneBody { floats: true, ..other }).unwrap();
            run(&mut scene, &map, 40);
            assert!(!scene.is_awake(other).unwrap());
            let shape = boxed(112, 42, 8, 4).translated(Vec2::from_raw(-gap, 0)).unwrap();
            let drifts = SceneBody { floats: true, fast: case > 0 && gap % 3 == 0, ..SceneBody::new(shape, 1) };
            let drifts = scene.insert(&SceneBody { velocity: Vec2::from_raw(1000, 0), ..drifts }).unwrap();
            let mut begun = 0;
            for _ in 0..100 {
                let each = |event: SceneEvent<'_>| {
                    if let SceneEvent::Touch { pair, .. } = event {
                        events.feed(pair);
                    }
                };
                scene.step(&map, GRAVITY, each).unwrap();
                events.finish(|pair| scene.rests(pair)).unwrap();
                begun += events.iter().filter(|event| matches!(event, PairEvent::Begin(_))).count();
            }
            assert!(scene.awake().is_empty());
            let touches = scene.body(drifts).unwrap().shape.touches(&scene.body(other).unwrap().shape);
            assert!(begun > 0 || !touches, "{case}: {gap}");
            *(if touches { &mut touched } else { &mut apart }) += 1;
        }
    }
    assert!(touched > 60 && apart > 10, "{touched} {apart}");
}
