//! A scene that remembers how bodies at rest lie is the scene that looks each time.

use super::swept::vec2;
use tilesat::broad::{Handle, Pair, SortSweep};
use tilesat::motion::Hits;
use tilesat::query::Contact;
use tilesat::scene::{SceneBody, SceneEvent, SceneFault, SceneTag, Shape, Sleep, Snapshot, Stepped};
use tilesat::world::Trail;
use tilesat::{
    Aabb, AllShapes, Axis, Circle, Fx, Grid, Outside, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, TileShape,
    Toi, Vec2,
};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::{Random, cases};

/// Room for ways too. One number for all tests: each one is another scene to compile.
const WAYS: usize = BODIES + 12;
const SIDE: usize = 12;

// The bytes per body and per place that the pages of `Scene` and `Scene::remembering` give. The
// firmware `memory` of `benches/chips/counts` checks those of a place on 32-bit chips.
type Sized<const N: usize, const M: usize> = Scene<SortSweep<N, SceneTag>, N, M>;
type Near<const N: usize> = SortSweep<N, SceneTag>;
const _: () = assert!(size_of::<Sized<64, 64>>() - size_of::<Sized<64, 0>>() == 64 * 124);
const BODIES_OF_64: usize = size_of::<Sized<128, 0>>() - size_of::<Sized<64, 0>>();
const _: () = assert!(BODIES_OF_64 - (size_of::<Near<128>>() - size_of::<Near<64>>()) == 64 * 164);

static KINDS: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0);
    while id < 38 {
        kinds = kinds.with(id as u8, TileKind::of(TileShape::ALL[id]).with_flags(1 << (id % 8)));
        id += 1;
    }
    kinds
};

fn level(tiles: &[u8]) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(Outside::Solid)
}

/// An event of a step, to keep. Of text, the tests took twice as long.
#[derive(Debug, PartialEq)]
enum Told {
    Touch(Pair, Option<Contact>),
    Meet(Pair, Toi, Axis, Fx),
    Level(Handle, Hits, u8, Vec2),
    Held(Handle, SceneFault),
}

impl Told {
    fn of(event: SceneEvent<'_>) -> Self {
        match event {
            SceneEvent::Touch { pair, contact } => Self::Touch(pair, contact.copied()),
            SceneEvent::Meet { pair, toi, axis, speed } => Self::Meet(pair, toi, axis, speed),
            SceneEvent::Level { body, hits, flags, velocity } => Self::Level(body, *hits, flags, velocity),
            SceneEvent::Held { body, fault } => Self::Held(body, fault),
            other => panic!("an event that this test does not know: {other:?}"),
        }
    }
}

/// What a step reports, and the bodies after it.
#[derive(Debug, PartialEq)]
struct Frame {
    /// `pairs` counts work, which memory saves: zero here.
    stepped: Stepped,
    events: Vec<Told>,
    supported: Vec<bool>,
    /// The bodies, and their order: what later steps depend on.
    after: Snapshot<SortSweep<BODIES, SceneTag>, BODIES>,
}

fn told<const M: usize>(
    scene: &mut Scene<SortSweep<BODIES, SceneTag>, BODIES, M>,
    tiles: &[u8],
    gravity: Vec2,
) -> Frame {
    let mut events = Vec::new();
    let each = |event: SceneEvent<'_>| events.push(Told::of(event));
    let stepped = Stepped { pairs: 0, ..scene.step(&level(tiles), gravity, each).unwrap() };
    let supported = scene.bodies().map(|(handle, _)| scene.is_supported(handle).unwrap()).collect();
    Frame { stepped, events, supported, after: scene.snapshot() }
}

fn body(r: &mut Random, key: u32) -> SceneBody {
    let (x, y) = (r.within(0, 170 << 16), r.within(0, 170 << 16));
    let size = r.within(3 << 16, 14 << 16) & !1;
    let shape: Shape = if r.one_in(2) {
        Aabb::new(vec2(x, y), vec2(x + size, y + size)).unwrap().into()
    } else {
        Circle::new(vec2(x + size / 2, y + size / 2), Fx::from_bits(size as i32 / 2)).unwrap().into()
    };
    let surface = Surface::new(Ratio::percent(r.below(60) as u8).unwrap(), Ratio::percent(r.below(90) as u8).unwrap());
    let surface = surface.resting_below(Fx::from_num(0.5));
    let fast = r.one_in(20);
    SceneBody {
        surface,
        fast,
        floats: r.one_in(10),
        velocity: vec2(r.around(1 << 17), 0),
        ..SceneBody::new(shape, key)
    }
}

#[test]
fn a_scene_that_remembers_is_the_scene_that_looks() {
    let (mut rested, mut changes) = (0, 0);
    for case in 0..cases(60) {
        let mut r = Random::new(41_000 + case);
        let sleep = if case % 3 == 0 { Sleep::default() } else { Sleep::NEVER };
        let mut plain = Scene::<_, BODIES>::with_sleep(SortSweep::<BODIES, SceneTag>::new(), sleep);
        // Half of the slots, all of them, and the ways of bodies that are pushed to and fro.
        let mut half = Scene::<_, BODIES, { BODIES / 2 }>::remembering(SortSweep::<BODIES, SceneTag>::new(), sleep);
        let mut whole = Scene::<_, BODIES, BODIES>::remembering(SortSweep::<BODIES, SceneTag>::new(), sleep);
        let mut ways = Scene::<_, BODIES, WAYS>::remembering(SortSweep::<BODIES, SceneTag>::new(), sleep);
        macro_rules! all {
            ($call:ident $arguments:tt) => {
                all!($call $arguments: plain half whole ways)
            };
            ($call:ident $arguments:tt: $($scene:ident)+) => {
                {$(let _ = $scene.$call $arguments;)+}
            };
        }
        let mut tiles = [0_u8; SIDE * SIDE];
        // Among tiles most bodies lie alone, and in an empty room in one heap.
        let open = case % 4 == 1;
        tiles.fill_with(|| if !open && r.one_in(3) { r.below(38) as u8 } else { 0 });
        let mut gravity = vec2(0, 6554);
        let mut handles: Vec<Handle> = Vec::new();
        // Those that hardly moved in the last step.
        let mut restless: Vec<Handle> = Vec::new();
        for key in 0..BODIES as u32 {
            let body = body(&mut r, key);
            if !body.shape.overlaps_level(&level(&tiles)) {
                handles.push(plain.insert(&body).unwrap());
                all!(insert(&body): half whole ways);
            }
        }
        for frame in 0..400 {
            if frame > 150 && r.one_in(20) && !handles.is_empty() {
                changes += 1;
                let pick = |from: &[Handle], r: &mut Random| from[r.below(from.len() as i64) as usize];
                let handle =
                    if restless.is_empty() || r.one_in(2) { pick(&handles, &mut r) } else { pick(&restless, &mut r) };
                let by = vec2(r.around(1 << 17), r.around(1 << 17));
                let shape = plain.body(handle).unwrap().shape;
                let mut cell = (r.below(SIDE as i64), r.below(SIDE as i64));
                match r.below(6) {
                    0 => all!(push(handle, by)),
                    1 => all!(place(handle, shape)),
                    // A tile that opens: what lay on it falls. The last is one beside a body.
                    what @ 2..=4 => {
                        if what == 4 {
                            let at = shape.aabb().centre().raw();
                            let side = |at: i32, by: i64| (i64::from(at >> 20) + by).clamp(0, SIDE as i64 - 1);
                            cell = (side(at.0, r.below(3) - 1), side(at.1, r.below(3) - 1));
                        }
                        let at = (cell.0 << 20, cell.1 << 20);
                        let region = Aabb::new(vec2(at.0, at.1), vec2(at.0 + (1 << 20), at.1 + (1 << 20))).unwrap();
                        tiles[(cell.1 * SIDE as i64 + cell.0) as usize] = 0;
                        all!(wake_region(&region));
                    }
                    _ => {
                        let surface = Surface::new(Ratio::HALF, Ratio::percent(r.below(90) as u8).unwrap());
                        all!(alter(handle, |body| body.surface = surface));
                    }
                }
            }
            if frame >= 300 && frame % 30 == 0 {
                gravity = match r.below(3) {
                    0 => vec2(0, 6554),
                    1 => vec2(6554, 0),
                    _ => vec2(r.around(9000), r.around(9000)),
                };
            }
            if frame == 200 {
                let snapshot = plain.snapshot();
                all!(restore(&snapshot): whole ways);
            }
            let before: Vec<_> = plain.bodies().map(|(_, body)| body.shape).collect();
            let due = told(&mut plain, &tiles, gravity);
            assert_eq!(told(&mut half, &tiles, gravity), due, "{case}, {frame}: half");
            assert_eq!(told(&mut whole, &tiles, gravity), due, "{case}, {frame}");
            assert_eq!(told(&mut ways, &tiles, gravity), due, "{case}, {frame}: ways");
            restless.clear();
            for (was, (handle, is)) in before.iter().zip(plain.bodies()) {
                let (x, y) = (is.shape.position() - was.position()).raw();
                if (1..1 << 14).contains(&x.abs().max(y.abs())) {
                    restless.push(handle);
                }
            }
            rested += before.iter().zip(plain.bodies()).filter(|(was, (_, is))| **was == is.shape).count();
        }
    }
    println!("{rested} rested, {changes} changes");
    assert!(rested > 100_000 && changes > 300, "{rested} {changes}");
}

/// A belt holds a floating ball at a wall. Under another gravity the wall is a floor.
#[test]
fn another_gravity_is_another_floor() {
    let tiles = [0_u8; SIDE * SIDE];
    let mut plain = Scene::<_, BODIES>::with_sleep(SortSweep::<BODIES, SceneTag>::new(), Sleep::NEVER);
    let mut whole = Scene::<_, BODIES, WAYS>::remembering(SortSweep::<BODIES, SceneTag>::new(), Sleep::NEVER);
    let wall = (SIDE as i64) << 20;
    let ball = Circle::new(vec2(wall - (4 << 16), 40 << 16), Fx::from_num(4)).unwrap();
    let belt = Aabb::new(vec2(wall - (20 << 16), 20 << 16), vec2(wall - (7 << 16), 60 << 16)).unwrap();
    let belt = SceneBody { velocity: vec2(1 << 14, 0), ..SceneBody::fixed(belt, 1) };
    for body in [belt, SceneBody { floats: true, velocity: vec2(1 << 14, 0), ..SceneBody::new(ball, 2) }] {
        plain.insert(&body).unwrap();
        whole.insert(&body).unwrap();
    }
    for frame in 0..60 {
        let gravity = if frame / 10 % 2 == 0 { vec2(0, 6554) } else { vec2(6554, 0) };
        assert_eq!(told(&mut whole, &tiles, gravity), told(&mut plain, &tiles, gravity), "{frame}");
    }
}

/// Bodies that are pushed to and fro, with another friction from time to time: no way is as before.
#[test]
fn what_a_game_changes_is_looked_at() {
    let mut altered = 0;
    for case in 0..cases(60) {
        let mut r = Random::new(52_000 + case);
        let mut plain = Scene::<_, BODIES>::with_sleep(SortSweep::<BODIES, SceneTag>::new(), Sleep::NEVER);
        let near = SortSweep::<BODIES, SceneTag>::new();
        let mut ways = Scene::<_, BODIES, WAYS>::remembering(near, Sleep::NEVER);
        let mut tiles = [0_u8; SIDE * SIDE];
        tiles.fill_with(|| if r.one_in(4) { r.below(34) as u8 } else { 0 });
        for key in 0..BODIES as u32 {
            let body = SceneBody { velocity: Vec2::ZERO, fast: false, floats: false, ..body(&mut r, key) };
            if !body.shape.overlaps_level(&level(&tiles)) {
                plain.insert(&body).unwrap();
                ways.insert(&body).unwrap();
            }
        }
        for frame in 0..400 {
            let before: Vec<_> = plain.bodies().map(|(_, body)| body.shape).collect();
            let due = told(&mut plain, &tiles, vec2(0, 6554));
            if frame % 4 == 3 && case % 2 == 1 {
                // Memory hides no way from a step that asks for them.
                let (map, mut at) = (level(&tiles), before.iter().map(Shape::position).collect::<Vec<_>>());
                let slots: Vec<_> = ways.bodies().map(|(handle, _)| handle).collect();
                let passed = |handle, _: &Shape, trail: &Trail| {
                    let slot = slots.iter().position(|at| *at == handle).unwrap();
                    at[slot] = trail.parts().fold(at[slot], |at, (_, by)| at + by);
                };
                ways.step_along(|_| &map, vec2(0, 6554), |_| true, |_| (), passed).unwrap();
                assert_eq!(ways.snapshot(), due.after, "{case}, {frame}");
                assert!(ways.bodies().map(|(_, body)| body.shape.position()).eq(at), "{case}, {frame}");
            } else {
                assert_eq!(told(&mut ways, &tiles, vec2(0, 6554)), due, "{case}, {frame}");
            }
            let moved = before.iter().zip(plain.bodies()).filter(|(was, (_, is))| **was != is.shape);
            let moved: Vec<Handle> = moved.map(|(_, (handle, _))| handle).collect();
            if frame > 200 && frame % 8 == 0 {
                altered += moved.len();
                for handle in moved {
                    let surface = Surface::new(Ratio::ZERO, Ratio::percent(r.below(90) as u8).unwrap());
                    plain.alter(handle, |body| body.surface = surface).unwrap();
                    ways.alter(handle, |body| body.surface = surface).unwrap();
                }
            }
        }
    }
    println!("{altered} altered");
    assert!(altered > 200, "{altered}");
}

/// A fast body rests in a V of two slopes, next to another one. Far away a faster one comes by, so
/// the first is moved from hit to hit: but it is where memory says that it is.
#[test]
fn what_rests_in_a_v_rests_whoever_is_fast() {
    static KINDS: TileKinds = TileKinds::EMPTY
        .with(b'#', TileKind::FULL)
        .with(b'l', TileKind::of(TileShape::SlopeBottomLeft))
        .with(b'm', TileKind::of(TileShape::MildLowBottomRight));
    fn play<const M: usize>(level: &TileMap<'_, AllShapes>) -> Vec<(Vec2, Vec2)> {
        let mut scene = Scene::<SortSweep<BODIES, SceneTag>, BODIES, M>::remembering(SortSweep::new(), Sleep::NEVER);
        let ball = Circle::new(vec2(33 << 16, 36 << 16), Fx::from_bits(296_316)).unwrap();
        let ball = scene.insert(&SceneBody { fast: true, ..SceneBody::new(ball, 1) }).unwrap();
        let boxed = |x: i16, y: i16| Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(6, 6)).unwrap();
        scene.insert(&SceneBody::new(boxed(54, 26), 2)).unwrap();
        let far = scene.insert(&SceneBody { floats: true, ..SceneBody::new(boxed(600, 0), 3) }).unwrap();
        (0..150)
            .map(|frame| {
                if frame == 100 {
                    scene.set_velocity(far, Vec2::from_ints(0, -400)).unwrap();
                }
                scene.step(level, vec2(0, 16_384), |_| {}).unwrap();
                let body = scene.body(ball).unwrap();
                (body.shape.position(), body.velocity)
            })
            .collect()
    }
    let level = TileMap::<AllShapes>::of_ascii("......\n......\n.lm#..\n", &KINDS).unwrap();
    let (looks, remembers) = (play::<0>(&level), play::<BODIES>(&level));
    assert!(looks[0] != looks[90] && looks[90..].iter().all(|seen| *seen == looks[90]), "{:?}", &looks[95..105]);
    assert_eq!(looks, remembers);
}
