//! Fast bodies pass through nothing: corridors, and rooms that nobody leaves. Raw, y down.

use super::steps::{Swept, step_with};
use core::num::NonZeroU8;
use tilesat::broad::{BroadPhase, BruteForce, Handle, LooseGrid, Pair, SortSweep, SpatialHash};
use tilesat::scene::{Reply, SceneBody, SceneEvent, SceneTag, Shape, Sleep, Stepped};
use tilesat::{Aabb, Circle, Fx, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, Toi, Vec2};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::{Random, cases};

/// Bodies of a random scene. A scene of the judge's size has room, and is compiled anyway.
const CROWD: usize = 16;
pub(super) const PX: i64 = 1 << 16;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
pub(super) const NOWHERE: &str = "....\n....\n";
/// Cells of 16: free from (16, 16) to (624, 32).
const CORRIDOR: &str = "\
########################################
#......................................#
########################################
";

pub(super) fn level(rows: &str) -> TileMap<'_> {
    TileMap::from_ascii(rows, &KINDS).unwrap()
}

pub(super) fn vec2(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

pub(super) fn boxed(x: i64, y: i64, w: i64, h: i64) -> Aabb {
    Aabb::new(vec2(x, y), vec2(x + w, y + h)).unwrap()
}

pub(super) fn ball(x: i64, y: i64, r: i64) -> Circle {
    Circle::new(vec2(x, y), Fx::from_bits(r as i32)).unwrap()
}

pub(super) fn scene(bodies: &[SceneBody]) -> Swept {
    filled(SortSweep::new(), bodies.iter())
}

fn filled<'a, B: BroadPhase<Tag = SceneTag>>(near: B, bodies: impl Iterator<Item = &'a SceneBody>) -> Scene<B, BODIES> {
    let mut scene = Scene::with_sleep(near, Sleep { steps: 10, ..Sleep::default() });
    for body in bodies {
        assert!(scene.insert(body).is_ok());
    }
    scene
}

fn handle<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, BODIES>, key: u32) -> Handle {
    scene.bodies().find(|(_, body)| body.key == key).unwrap().0
}

pub(super) fn body_of<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, BODIES>, key: u32) -> SceneBody {
    *scene.body(handle(scene, key)).unwrap()
}

/// The bodies that met in a step, and the time.
pub(super) fn meetings<B: BroadPhase<Tag = SceneTag>>(
    scene: &mut Scene<B, BODIES>,
    map: &TileMap<'_>,
    gravity: Vec2,
) -> (Stepped, Vec<(Pair, Toi)>) {
    let mut met = Vec::new();
    let stepped = scene.step(map, gravity, |event| {
        if let SceneEvent::Meet { pair, toi, .. } = event {
            met.push((pair, toi));
        }
    });
    (stepped.unwrap(), met)
}

fn ratio(r: &mut Random) -> Ratio {
    Ratio::percent([0, 100, r.below(101)][r.below(3) as usize] as u8).unwrap()
}

fn surface(r: &mut Random) -> Surface {
    Surface::new(ratio(r), ratio(r)).resting_below(Fx::from_bits(r.below(2) as i32 * 20_000))
}

/// A velocity of up to a hundred sizes per step. Small ones are as frequent as large ones.
pub(super) fn launch(r: &mut Random, size: i64) -> Vec2 {
    let most = size * [1, 2, 8, 30, 100][r.below(5) as usize];
    vec2(r.around(most), if r.one_in(2) { 0 } else { r.around(most) })
}

/// A floating circle of radius 2 flies at a fixed body of 8 x 80 units.
fn at_a_wall<B: BroadPhase<Tag = SceneTag>>(near: impl Fn() -> B) {
    let map = level(NOWHERE);
    for speed in [1, 3, 8, 12, 24, 80, 160, 1000] {
        for k in 0..80 {
            let bullet = ball((20 + k % 10) * PX + 8111 * k, (k % 30 - 15) * PX + 77 * k, 2 * PX);
            let velocity = vec2(speed * PX, 1000 * (k % 7));
            let mut scene = filled(
                near(),
                [
                    SceneBody::fixed(boxed(200 * PX, -40 * PX, 8 * PX, 80 * PX), 1),
                    SceneBody { velocity, floats: true, ..SceneBody::new(bullet, 2) },
                ]
                .iter(),
            );
            for _ in 0..400 / speed + 3 {
                scene.step(&map, Vec2::ZERO, |_| {}).unwrap();
            }
            assert_eq!(body_of(&scene, 2).shape.position().x, 198, "{k} at {speed} a step");
        }
    }
}

#[test]
fn a_wall_stops_what_flies_at_it() {
    at_a_wall(SortSweep::<BODIES, SceneTag>::new);
    at_a_wall(BruteForce::<BODIES, SceneTag>::new);
    at_a_wall(|| LooseGrid::<8, BODIES, SceneTag>::new(Vec2::ZERO, Fx::from_num(128), 16).unwrap());
    at_a_wall(|| SpatialHash::<64, BODIES, SceneTag>::new(Fx::from_num(128)).unwrap());
}

/// A row of bodies from left to right, boxes and circles. No two fit beside each other. Also doors.
fn row(r: &mut Random, flagged: bool) -> Vec<SceneBody> {
    let count = r.within(3, 9);
    (0..count)
        .map(|k| {
            let (x, high) = ((30 + 60 * k) * PX + r.below(40 * PX), r.within(9 * PX, 15 * PX) & !1);
            let y = 16 * PX + r.within(0, 16 * PX - high);
            let key = 100 + (k * 37 % 11) as u32;
            if r.one_in(5) {
                return SceneBody::fixed(boxed(x, 16 * PX + PX / 2, PX, 15 * PX), key);
            }
            let shape: Shape = match r.below(2) {
                0 => boxed(x, y, r.within(2 * PX, 12 * PX), high).into(),
                _ => ball(x, y + high / 2, high / 2).into(),
            };
            let velocity = launch(r, 8 * PX);
            SceneBody { velocity, floats: r.one_in(3), fast: flagged, ..with_surface(r, shape, key) }
        })
        .collect()
}

fn with_surface(r: &mut Random, shape: Shape, key: u32) -> SceneBody {
    SceneBody { mass: NonZeroU8::new(r.within(1, 9) as u8), surface: surface(r), ..SceneBody::new(shape, key) }
}

/// Left and right end.
fn ends(body: &SceneBody) -> (i64, i64) {
    let bounds = body.shape.aabb();
    (bounds.min().x.to_bits().into(), bounds.max().x.to_bits().into())
}

/// Whether it moves by more than half of its smaller side.
fn is_fast(body: &SceneBody, gravity: Vec2) -> bool {
    let (size, (x, y)) = (body.shape.aabb().size().raw(), (body.velocity + gravity).raw());
    body.mass.is_some() && 2 * x.abs().max(y.abs()) > size.0.min(size.1)
}

/// Ways, and passes. If not all are flagged, only disjoint pairs with a fast body count.
fn corridor(case: u64, flagged: bool, frames: u32) -> (u64, u64) {
    let (mut r, map) = (Random::new(case), level(CORRIDOR));
    let bodies = row(&mut r, flagged);
    let mut scene = scene(&bodies);
    let gravity = vec2(0, [0, 6554, PX][r.below(3) as usize]);
    let row = |scene: &Swept| bodies.iter().map(|body| body_of(scene, body.key)).collect::<Vec<_>>();
    let (mut made, mut before) = (0, row(&scene));
    for frame in 0..frames {
        if frame % 12 == 11 {
            let body = bodies[r.below(bodies.len() as i64) as usize];
            if body.mass.is_some() {
                let handle = handle(&scene, body.key);
                scene.set_velocity(handle, launch(&mut r, 8 * PX)).unwrap();
            }
            before = row(&scene);
        }
        let stepped = scene.step(&map, gravity, |_| {}).unwrap();
        assert_eq!(stepped.held, 0);
        made += u64::from(stepped.moved);
        let after = row(&scene);
        for (was, is) in before.windows(2).zip(after.windows(2)) {
            let ((a, b), (c, d)) = (ends(&is[0]), ends(&is[1]));
            if a + b >= c + d {
                let apart = ends(&was[0]).1 <= ends(&was[1]).0;
                let counts = flagged || apart && was.iter().any(|body| is_fast(body, gravity));
                if counts {
                    println!("{case}, frame {frame}: {was:?} became {is:?}");
                }
                return (made, u64::from(counts));
            }
        }
        before = after;
    }
    (made, 0)
}

fn corridors(from: u64, wanted: u64, told: u64) {
    let (mut made, mut passed, mut case) = (0, 0, from);
    while made < wanted {
        let (more, passes) = corridor(case, case % 2 == 0, 120);
        (made, passed, case) = (made + more, passed + passes, case + 1);
        if (case - from).is_multiple_of(told) {
            eprintln!("{made} of {wanted} ways, {passed} passes");
        }
    }
    assert_eq!(passed, 0, "of {made} ways in {} corridors", case - from);
}

#[test]
fn nobody_passes_in_a_corridor() {
    corridors(0, 150_000 * cases(1), 100);
}

#[test]
#[ignore = "two minutes"]
fn nobody_passes_in_ten_million_ways() {
    corridors(1_000_000, 10_000_000, 1000);
}

/// Three bodies in a room of four fixed walls, a unit thick, and the room in a level of tiles.
#[test]
fn nobody_leaves_a_room_of_thin_walls() {
    let map = level(NOWHERE);
    let (mut made, wanted, mut case) = (0, 60_000 * cases(1), 0);
    while made < wanted {
        let mut r = Random::new(5000 + case);
        let mut bodies: Vec<_> = [(0, 0, 100, 1), (0, 99, 100, 1), (0, 0, 1, 100), (99, 0, 1, 100)]
            .iter()
            .enumerate()
            .map(|(k, &(x, y, w, h))| SceneBody::fixed(boxed(x * PX, y * PX, w * PX, h * PX), k as u32))
            .collect();
        for key in 4..4 + r.within(1, 3) as u32 {
            let (at, size) = ((i64::from(key) * 24 - 80) * PX, r.within(1, 10 * PX) & !1);
            let shape: Shape = match r.below(2) {
                0 => boxed(at, r.within(2 * PX, 80 * PX), size, 8 * PX).into(),
                _ => ball(at + size / 2, r.within(15 * PX, 80 * PX), size / 2).into(),
            };
            let velocity = launch(&mut r, size);
            bodies.push(SceneBody { velocity, fast: true, ..with_surface(&mut r, shape, key) });
        }
        let mut scene = scene(&bodies);
        let gravity = vec2(r.around(PX) / 8, r.around(PX) / 8);
        for frame in 0..100 {
            if frame % 10 == 9 {
                let key = 4 + r.below(bodies.len() as i64 - 4) as u32;
                let handle = handle(&scene, key);
                scene.set_velocity(handle, launch(&mut r, 10 * PX)).unwrap();
            }
            let stepped = scene.step(&map, gravity, |_| {}).unwrap();
            assert_eq!(stepped.held, 0);
            made += u64::from(stepped.moved);
            for body in &bodies[4..] {
                let at = body_of(&scene, body.key).shape.aabb().centre();
                let inside = |c: Fx| c > 0 && c < 100;
                assert!(inside(at.x) && inside(at.y), "{case}, {frame}: {:?}", body_of(&scene, body.key));
            }
        }
        case += 1;
    }
}

/// Many bodies of all kinds among tiles, up to a hundred sizes per step fast.
#[test]
fn neither_order_nor_broad_phase_matters() {
    let map = level(CORRIDOR);
    let (mut met, mut woken) = (0, 0);
    for case in 0..cases(60) {
        let mut r = Random::new(20_000 + case);
        let bodies: Vec<_> = (0..CROWD as u32)
            .map(|key| {
                let (x, y, size) = (r.within(20, 200) * PX, r.within(17, 23) * PX, r.within(1, 7) * PX);
                let shape: Shape = if r.one_in(2) {
                    boxed(x, y, size, size).into()
                } else {
                    ball(x + 4 * PX, y + 4 * PX, size / 2).into()
                };
                let filter = tilesat::Filter::default().with_sensor(r.one_in(6));
                let body =
                    SceneBody { filter, floats: r.one_in(3), fast: r.one_in(8), ..with_surface(&mut r, shape, key) };
                if r.one_in(8) {
                    SceneBody { mass: None, ..body }
                } else {
                    SceneBody { velocity: launch(&mut r, size), ..body }
                }
            })
            .collect();
        let mut shuffled: Vec<_> = bodies.iter().collect();
        r.shuffle(&mut shuffled);
        let mut one = filled(SortSweep::<BODIES, SceneTag>::new(), bodies.iter());
        let mut other = filled(SortSweep::<BODIES, SceneTag>::new(), shuffled.iter().copied());
        let mut brute = filled(BruteForce::<BODIES, SceneTag>::new(), shuffled.iter().rev().copied());
        let grid = LooseGrid::<8, BODIES, SceneTag>::new(Vec2::ZERO, Fx::from_num(16), 16).unwrap();
        let mut grid = filled(grid, bodies.iter().rev());
        let mut hash =
            filled(SpatialHash::<64, BODIES, SceneTag>::new(Fx::from_num(16)).unwrap(), shuffled.iter().copied());
        for frame in 0..60 {
            if frame % 15 == 14 {
                let (key, velocity) = (r.below(CROWD as i64) as u32, launch(&mut r, 8 * PX));
                one.set_velocity(handle(&one, key), velocity).unwrap();
                other.set_velocity(handle(&other, key), velocity).unwrap();
                brute.set_velocity(handle(&brute, key), velocity).unwrap();
                grid.set_velocity(handle(&grid, key), velocity).unwrap();
                hash.set_velocity(handle(&hash, key), velocity).unwrap();
            }
            let all = told(&mut one, &map);
            assert_eq!(all, told(&mut other, &map), "{case}, {frame}: another order");
            assert_eq!(all, told(&mut brute, &map), "{case}, {frame}: brute force");
            assert_eq!(all, told(&mut grid, &map), "{case}, {frame}: grid");
            assert_eq!(all, told(&mut hash, &map), "{case}, {frame}: hash");
            let pairs: Vec<_> = all.1.iter().map(|told| (told.0, told.1)).collect();
            let solid = |key: u32| !bodies[key as usize].filter.sensor();
            for (k, pair) in pairs.iter().enumerate().filter(|(_, pair)| solid(pair.0) && solid(pair.1)) {
                assert!(!pairs[..k].contains(pair), "{case}, {frame}: {pair:?} met twice");
            }
            (met, woken) = (met + pairs.len(), woken + u32::from(all.0.woken));
        }
    }
    println!("{met} met, {woken} woken");
    assert!(met > 2000);
}

type Told = (Stepped, Vec<(u32, u32, u32, Fx)>, Vec<(SceneBody, bool)>);

/// All effects of a step, by key.
fn told<B: BroadPhase<Tag = SceneTag>>(scene: &mut Scene<B, BODIES>, map: &TileMap<'_>) -> Told {
    let keys: Vec<_> = scene.bodies().map(|(handle, body)| (handle, body.key)).collect();
    let key = |of: Handle| keys.iter().find(|(handle, _)| *handle == of).unwrap().1;
    let mut met = Vec::new();
    let stepped = scene.step(map, vec2(0, 6554), |event| {
        if let SceneEvent::Meet { pair, toi, speed, .. } = event {
            met.push((key(pair.a), key(pair.b), toi.raw(), speed));
        }
    });
    met.sort_unstable();
    let mut bodies: Vec<_> = scene.bodies().map(|(handle, body)| (*body, scene.is_awake(handle).unwrap())).collect();
    bodies.sort_by_key(|body| body.0.key);
    (stepped.unwrap(), met, bodies)
}

/// From (100, 24) to the right, a standing body at 300, a flying one: one order of the times.
#[test]
fn the_level_and_bodies_come_in_one_order() {
    let map = level(CORRIDOR);
    let flies = |x: i64, v: i64, key: u32| SceneBody {
        velocity: vec2(v * PX, 0),
        surface: Surface::ELASTIC,
        floats: true,
        ..SceneBody::new(ball(x * PX, 24 * PX, 4 * PX), key)
    };
    let events = |scene: &mut Swept| {
        let mut told = Vec::new();
        let stepped = scene.step(&map, Vec2::ZERO, |event| match event {
            SceneEvent::Meet { pair, toi, speed, .. } => {
                told.push((toi.to_fx().to_num::<f64>(), Some((pair.a.slot(), pair.b.slot(), speed))));
            }
            SceneEvent::Level { hits, .. } => told.push((hits.first().unwrap().toi.to_fx().to_num(), None)),
            _ => {}
        });
        assert_eq!(stepped.unwrap().held, 0);
        told
    };
    // The wall is at 624: to 620 and back to the body that stands behind its start.
    let mut shot = scene(&[flies(420, 400, 1), SceneBody { velocity: Vec2::ZERO, ..flies(412, 0, 2) }]);
    let told = events(&mut shot);
    assert_eq!(told, [(0.5, None)]);
    let told = events(&mut shot);
    assert_eq!(told, [(0.0, Some((0, 1, Fx::from_num(400))))]);
    // Equal masses exchange their velocities. The standing one flies from the next step on.
    assert_eq!((body_of(&shot, 1).velocity.x, body_of(&shot, 2).velocity.x), (Fx::ZERO, Fx::from_num(-400)));
    // A row: each is met after the one before it, and the wall last.
    let mut shot = scene(&[flies(424, 392, 1), flies(532, -98, 2)]);
    let told = events(&mut shot);
    // 100 apart at 490 per step. The first one turns back at 98, the second one at 392 at the wall.
    assert_eq!(told[0].1, Some((0, 1, Fx::from_num(490))));
    assert!((told[0].0 - 100.0 / 490.0).abs() < 1e-4 && told[1].1.is_none() && told[1].0 > told[0].0);
    assert_eq!(told.len(), 2);
}

#[test]
fn sensors_on_the_way_are_told_and_pushed_by_nobody() {
    let map = level(NOWHERE);
    let gate = |x: i64, key: u32| {
        let gate = SceneBody::fixed(boxed(x * PX, -20 * PX, PX, 40 * PX), key);
        SceneBody { filter: gate.filter.with_sensor(true), ..gate }
    };
    let bullet = SceneBody { velocity: vec2(500 * PX, 0), floats: true, ..SceneBody::new(ball(0, 0, 2 * PX), 9) };
    let mut scene = scene(&[gate(100, 1), gate(200, 2), gate(300, 3), gate(700, 4), bullet]);
    let mut told: Vec<_> = meetings(&mut scene, &map, Vec2::ZERO).1;
    told.sort_by_key(|told| told.1);
    let keys: Vec<_> = told.iter().map(|(pair, _)| scene.body(pair.a).unwrap().key).collect();
    assert_eq!(keys, [1, 2, 3]);
    assert_eq!(body_of(&scene, 9).shape.position(), vec2(500 * PX, 0));
    assert_eq!(body_of(&scene, 9).velocity, vec2(500 * PX, 0));
}

#[test]
fn what_sleeps_is_woken_by_what_flies_at_it() {
    let map = level(CORRIDOR);
    let mut scene = scene(&[SceneBody::new(boxed(300 * PX, 22 * PX, 10 * PX, 10 * PX), 1)]);
    for _ in 0..40 {
        scene.step(&map, vec2(0, 6554), |_| {}).unwrap();
    }
    assert!(scene.awake().is_empty());
    let bullet =
        SceneBody { velocity: vec2(700 * PX, 0), floats: true, ..SceneBody::new(ball(30 * PX, 26 * PX, PX), 2) };
    scene.insert(&bullet).unwrap();
    let (stepped, met) = meetings(&mut scene, &map, vec2(0, 6554));
    assert_eq!((stepped.moved, stepped.woken, met.len()), (1, 1, 1));
    assert_eq!(body_of(&scene, 1).velocity.x, 350);
    assert_eq!(scene.awake().len(), 2);
}

/// Large and not faster than half its size, it passes a small body. With the flag it does not.
#[test]
fn a_crusher_is_flagged() {
    let map = level(NOWHERE);
    let behind = |fast: bool| {
        let mut scene = scene(&[
            SceneBody {
                velocity: vec2(45 * PX, 0),
                mass: NonZeroU8::new(200),
                floats: true,
                fast,
                ..SceneBody::new(boxed(0, 0, 100 * PX, 100 * PX), 1)
            },
            SceneBody { floats: true, ..SceneBody::new(boxed(120 * PX, 3 * PX, 2 * PX, 2 * PX), 2) },
        ]);
        for _ in 0..10 {
            scene.step(&map, Vec2::ZERO, |_| {}).unwrap();
        }
        body_of(&scene, 2).shape.position().x < body_of(&scene, 1).shape.aabb().max().x
    };
    assert!(behind(false) && !behind(true));
}

/// It passes pairs that the game refuses.
#[test]
fn what_is_refused_is_passed() {
    let map = level(NOWHERE);
    let bullet = SceneBody { velocity: vec2(500 * PX, 0), floats: true, ..SceneBody::new(ball(0, 0, 2 * PX), 9) };
    let wall = SceneBody::fixed(boxed(100 * PX, -20 * PX, PX, 40 * PX), 1);
    let mut refused = scene(&[wall, bullet]);
    step_with(&mut refused, &map, Vec2::ZERO, &mut |_| Reply::Ignore, &mut |event| panic!("{event:?}")).unwrap();
    assert_eq!(body_of(&refused, 9).shape.position().x, 500);
    let ghost = tilesat::Filter::new(tilesat::LayerMask::layer(1), tilesat::LayerMask::layer(1));
    let mut filtered = scene(&[
        SceneBody { filter: ghost.with_group(-1), ..wall },
        SceneBody { filter: ghost.with_group(-1), ..bullet },
    ]);
    filtered.step(&map, Vec2::ZERO, |event| panic!("{event:?}")).unwrap();
    assert_eq!(body_of(&filtered, 9).shape.position().x, 500);
}
