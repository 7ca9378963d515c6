//! Scenes of bullets, crushers, piles and lifts, played by random scripts in three broad phases and
//! orders of insertion. The judge knows the level's bytes and the lanes, and none of the library's
//! answers: nobody passes anybody, nobody is in the solid, what is free moves, what may rest
//! sleeps. Every other script has capsules too; those without are also played by a scene that knows
//! none. `TILESAT_CASES=500` plays ten million frames.

use super::swept::{PX, ball, boxed, vec2};
use core::num::NonZeroU8;
use tilesat::broad::{BroadPhase, BruteForce, Handle, SortSweep, SpatialHash};
use tilesat::scene::{BodyShape, SceneBody, SceneEvent, SceneTag, Shape, WithCapsules};
use tilesat::{Capsule, Fx, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const CELL: i64 = 16 * PX;
/// Two corridors for bullets and for a crusher, a pit, and a shaft for a lift.
const ROWS: &str = "\
########################
#......................#
########################
#......................#
########################
#..........#############
#..........#######.....#
#..........#######.....#
#..........#######.....#
#..........#######.....#
#..........#######.....#
#..........#######.....#
########################
";
const GRAVITY: i64 = 6554;
/// What a key belongs to: 100 bullets, 200 the crusher's corridor, 300 the pit, 400 the shaft.
const LIFT: u32 = 400;

/// The corridor, the pit or the shaft of a key: `x0..x1`, `y0..y1`, in cells.
fn lane(key: u32) -> (i64, i64, i64, i64) {
    [(1, 23, 1, 2), (1, 23, 3, 4), (1, 11, 5, 12), (18, 23, 6, 12)][key as usize / 100 - 1]
}

/// A capsule that lies or stands. The other side of its box is `along`.
fn capsule(x: i64, y: i64, height: i64, along: i64) -> WithCapsules {
    let r = height.min(along) / 2;
    let (a, b) = (vec2(x + r, y + r), vec2(x + along - r, y + height - r));
    Capsule::new(a, b, Fx::from_bits(r as i32)).unwrap().into()
}

/// As high as `size`, and no wider than that, or than 16 units.
fn shape(r: &mut Random, capsules: bool, x: i64, y: i64, size: i64) -> WithCapsules {
    if capsules && r.one_in(2) {
        let along = if r.one_in(2) { r.within(size, 16 * PX) } else { r.within(3 * PX, size) };
        capsule(x, y, size, along & !1)
    } else if r.one_in(2) {
        boxed(x, y, size, size).into()
    } else {
        ball(x + size / 2, y + size / 2, size / 2).into()
    }
}

/// The body of a scene that knows no capsules.
fn plain(body: &SceneBody<WithCapsules>) -> SceneBody {
    let shape = match body.shape {
        WithCapsules::Aabb(it) => Shape::Aabb(it),
        WithCapsules::Circle(it) => Shape::Circle(it),
        WithCapsules::Capsule(_) => unreachable!("a script without capsules"),
    };
    let SceneBody { velocity, mass, surface, responses, filter, key, floats, fast, .. } = *body;
    SceneBody { shape, velocity, mass, surface, responses, filter, key, floats, fast }
}

/// The same body in a scene that knows capsules.
fn wide<S: BodyShape + Into<WithCapsules>>(body: &SceneBody<S>) -> SceneBody<WithCapsules> {
    let SceneBody { shape, velocity, mass, surface, responses, filter, key, floats, fast } = *body;
    SceneBody { shape: shape.into(), velocity, mass, surface, responses, filter, key, floats, fast }
}

/// Bodies that do not fit beside each other in their corridor; a heap; crates on a lift.
fn bodies(r: &mut Random, capsules: bool) -> Vec<SceneBody<WithCapsules>> {
    let mut all = Vec::new();
    let rough = Surface::new(Ratio::ZERO, Ratio::percent(60).unwrap());
    for k in 0..r.within(2, 5) {
        let (size, bounces) = (r.within(9 * PX, 14 * PX) & !1, Ratio::percent(r.within(60, 100) as u8).unwrap());
        let at = (20 * PX + k * 60 * PX + r.below(30 * PX), CELL + r.within(0, CELL - size));
        let velocity = vec2(r.around(200 * PX), r.around(20 * PX));
        let surface = Surface::new(bounces, Ratio::ZERO);
        let body = SceneBody::of(shape(r, capsules, at.0, at.1, size), 100 + (k as u32 * 3) % 7);
        // Slow ones may pass each other, if they are not flagged.
        all.push(SceneBody { velocity, surface, floats: true, fast: true, ..body });
    }
    for k in 0..r.within(2, 5) {
        let size = if k == 0 { 15 * PX } else { r.within(9 * PX, 14 * PX) & !1 };
        let at = (20 * PX + k * 50 * PX + r.below(20 * PX), 4 * CELL - size);
        let mass = NonZeroU8::new(if k == 0 { 250 } else { r.within(1, 5) as u8 });
        let body = SceneBody::of(shape(r, capsules, at.0, at.1, size), 200 + k as u32);
        all.push(SceneBody { mass, fast: true, surface: rough, ..body });
    }
    for k in 0..r.within(4, 12) {
        let size = r.within(7 * PX, 12 * PX) & !1;
        let at = (18 * PX + k % 8 * 18 * PX, 82 * PX + k / 8 * 18 * PX);
        let surface = Surface::new(Ratio::percent(r.below(31) as u8).unwrap(), Ratio::percent(50).unwrap());
        let surface = surface.resting_below(Fx::from_num(0.5));
        all.push(SceneBody { surface, ..SceneBody::of(shape(r, capsules, at.0, at.1, size), 300 + k as u32) });
    }
    let lift = boxed(18 * CELL + 8 * PX, 11 * CELL, 64 * PX, 4 * PX);
    all.push(SceneBody { surface: rough, mass: None, ..SceneBody::of(lift, LIFT) });
    for k in 0..r.within(1, 5) {
        let (x, y) = (20 * CELL + k * 1000, 11 * CELL - (k + 1) * 8 * PX);
        // A capsule lies on its flat side, and others on it.
        let lies = capsules && r.one_in(2);
        let at = if lies { capsule(x - 4 * PX, y, 8 * PX, 16 * PX) } else { boxed(x, y, 8 * PX, 8 * PX).into() };
        all.push(SceneBody { surface: rough, ..SceneBody::of(at, LIFT + 1 + k as u32) });
    }
    all
}

/// Whether a shape is in the solid, from the bytes of the level.
fn is_inside(shape: &WithCapsules) -> bool {
    let rows: Vec<&[u8]> = ROWS.lines().map(str::as_bytes).collect();
    let solid = |x: i64, y: i64| rows.get(y as usize).and_then(|row| row.get(x as usize)).is_none_or(|&b| b == b'#');
    let raw = |v: Vec2| (i64::from(v.raw().0), i64::from(v.raw().1));
    // All points within a radius of a box, a point or a segment along x or y.
    let (lo, hi, r) = match shape {
        WithCapsules::Aabb(it) => (it.min(), it.max(), Fx::ZERO),
        WithCapsules::Circle(it) => (it.centre(), it.centre(), it.radius()),
        WithCapsules::Capsule(it) => (it.a().min(it.b()), it.a().max(it.b()), it.radius()),
    };
    let ((x0, y0), (x1, y1), r) = (raw(lo), raw(hi), i64::from(r.to_bits()));
    ((y0 - r).div_euclid(CELL)..=(y1 + r).div_euclid(CELL)).any(|y| {
        ((x0 - r).div_euclid(CELL)..=(x1 + r).div_euclid(CELL)).any(|x| {
            let (dx, dy) = ((x * CELL - x1).max(x0 - x * CELL - CELL), (y * CELL - y1).max(y0 - y * CELL - CELL));
            let gap = i128::from(dx.max(0)).pow(2) + i128::from(dy.max(0)).pow(2);
            solid(x, y) && (gap < i128::from(r).pow(2) || (dx < 0 && dy < 0))
        })
    })
}

struct Played<B, S> {
    scene: Scene<B, BODIES, 0, S>,
    handles: Vec<(u32, Handle)>,
}

impl<B: BroadPhase<Tag = SceneTag>, S: BodyShape + Into<WithCapsules>> Played<B, S> {
    fn new(near: B, bodies: impl Iterator<Item = SceneBody<S>>) -> Self {
        let mut scene = Scene::new(near);
        let handles = bodies.map(|body| (body.key, scene.insert(&body).unwrap())).collect();
        Self { scene, handles }
    }

    fn handle(&self, key: u32) -> Option<Handle> {
        self.handles.iter().find(|at| at.0 == key).map(|at| at.1)
    }

    fn body(&self, key: u32) -> &SceneBody<S> {
        self.scene.body(self.handle(key).unwrap()).unwrap()
    }

    /// One frame: a command, the step, the lift. Whom an event named.
    fn frame(&mut self, map: &TileMap<'_>, command: Option<(u32, Vec2)>, lift: Vec2) -> Vec<u32> {
        if let Some((key, velocity)) = command {
            self.scene.set_velocity(self.handle(key).unwrap(), velocity).unwrap();
        }
        let platform = self.handle(LIFT).unwrap();
        if self.body(LIFT).velocity != lift {
            self.scene.set_velocity(platform, lift).unwrap();
        }
        let mut named = Vec::new();
        let handles = &self.handles;
        let key = |of: Handle| handles.iter().find(|at| at.1 == of).unwrap().0;
        self.scene
            .step(map, vec2(0, GRAVITY), |event| match event {
                SceneEvent::Touch { pair, .. } | SceneEvent::Meet { pair, .. } => {
                    named.extend([key(pair.a), key(pair.b)]);
                }
                SceneEvent::Level { body, .. } => named.push(key(body)),
                other => panic!("{other:?}"),
            })
            .unwrap();
        if lift != Vec2::ZERO {
            let bounds = wide(self.body(LIFT)).shape.aabb().translated(lift).unwrap();
            self.scene.place(platform, bounds).unwrap();
        }
        named.sort_unstable();
        named
    }

    fn all(&self) -> Vec<(SceneBody<WithCapsules>, bool)> {
        let awake = |handle: Handle| self.scene.is_awake(handle).unwrap();
        let mut all: Vec<_> = self.scene.bodies().map(|(handle, body)| (wide(body), awake(handle))).collect();
        all.sort_by_key(|body| body.0.key);
        all
    }
}

/// In raw units, doubled.
fn middle<S: BodyShape + Into<WithCapsules>>(body: &SceneBody<S>) -> (i64, i64) {
    let body = wide(body);
    let bounds = body.shape.aabb();
    let ((a, b), (c, d)) = (bounds.min().raw(), bounds.max().raw());
    (i64::from(a) + i64::from(c), i64::from(b) + i64::from(d))
}

/// What is wrong after a frame, if anything is.
fn judge(bodies: &[SceneBody<WithCapsules>], after: &[(SceneBody<WithCapsules>, bool)]) -> Option<String> {
    let found = |key: u32| &after.iter().find(|body| body.0.key == key).unwrap().0;
    for (body, _) in after {
        let (x0, x1, y0, y1) = lane(body.key);
        let (x, y) = middle(body);
        if x <= 2 * x0 * CELL || x >= 2 * x1 * CELL || y <= 2 * y0 * CELL || y >= 2 * y1 * CELL {
            return Some(format!("left its lane: {body:?}"));
        }
        if body.mass.is_some() && is_inside(&body.shape) {
            return Some(format!("in the solid: {body:?}"));
        }
    }
    // They were inserted from left to right, and on the lift from the lowest up.
    for pair in bodies.windows(2).filter(|pair| pair[0].key / 100 == pair[1].key / 100) {
        let (a, b) = (found(pair[0].key), found(pair[1].key));
        let passed = match a.key / 100 {
            1 | 2 => middle(a).0 >= middle(b).0,
            4 => middle(a).1 <= middle(b).1,
            _ => false,
        };
        if passed {
            return Some(format!("{a:?} passed {b:?}"));
        }
    }
    None
}

#[test]
fn nobody_passes_and_all_live() {
    let (mut frames, mut flown, mut met) = (0, 0, 0);
    for case in 0..20 * cases(1) {
        let mut r = Random::new(51_000 + case);
        let capsules = case % 2 == 1;
        let all = bodies(&mut r, capsules);
        let mut shuffled: Vec<_> = all.iter().collect();
        r.shuffle(&mut shuffled);
        let one = Played::new(SortSweep::<BODIES, SceneTag>::new(), all.iter().copied());
        let hash = SpatialHash::<64, BODIES, SceneTag>::new(Fx::from_num(64)).unwrap();
        let three = Played::new(hash, shuffled.iter().rev().copied().copied());
        let brute = BruteForce::<BODIES, SceneTag>::new();
        let counts = if capsules {
            play(case, r, &all, (one, Played::new(brute, shuffled.into_iter().copied()), three))
        } else {
            play(case, r, &all, (one, Played::new(brute, shuffled.into_iter().map(plain)), three))
        };
        (frames, flown, met) = (frames + counts[0], flown + counts[1], met + counts[2]);
    }
    println!("{frames} frames, {flown} free ways of bullets, {met} with a hit");
    assert!(flown > frames / 4 && met > frames / 4);
}

type Sorted = Played<SortSweep<BODIES, SceneTag>, WithCapsules>;
type Brute<S> = Played<BruteForce<BODIES, SceneTag>, S>;
type Hashed = Played<SpatialHash<64, BODIES, SceneTag>, WithCapsules>;

/// One script. The number of frames, of free ways of bullets, and of those with a hit.
fn play<S: BodyShape + Into<WithCapsules>>(
    case: u64,
    mut r: Random,
    all: &[SceneBody<WithCapsules>],
    (mut one, mut two, mut three): (Sorted, Brute<S>, Hashed),
) -> [u64; 3] {
    const BUSY: u32 = 300;
    // One of 7500 scripts takes more than 1000 frames, 1765. A capsule squeezed between two others
    // sinks by 15 raw units per frame, at a velocity of half a unit that they stop in each step.
    const LONGEST: u32 = 4000;
    let map = TileMap::from_ascii(ROWS, &KINDS).unwrap();
    let (mut frames, mut flown, mut met) = (0_u64, 0_u64, 0_u64);
    let mut lift = Vec2::ZERO;
    for frame in 0..LONGEST {
        let awake = one.all().into_iter().filter(|(body, awake)| *awake && body.key >= 200);
        if frame >= 1000 && awake.count() == 0 {
            break;
        }
        let mut command = None;
        if frame < BUSY && r.one_in(6) {
            let body = all[r.below(all.len() as i64) as usize];
            let velocity = match body.key / 100 {
                1 => vec2(r.around(400 * PX), r.around(30 * PX)),
                2 => vec2(r.around(if body.key == 200 { 6 * PX } else { 60 * PX }), 0),
                3 => vec2(r.around(3 * PX), r.within(-4 * PX, 0)),
                _ => Vec2::ZERO,
            };
            command = (body.key / 100 != 4).then_some((body.key, velocity));
        }
        // Slower than what lies on it falls, and it turns only where there is room.
        if frame % 40 == 0 {
            let y = middle(one.body(LIFT)).1 / 2;
            let speed = r.within(0, GRAVITY);
            let way = if y > 10 * CELL {
                -1
            } else if y < 10 * CELL - 40 * PX {
                1
            } else {
                r.sign()
            };
            lift = if frame < BUSY { vec2(0, way * speed) } else { Vec2::ZERO };
        }
        let before = one.all();
        let named = one.frame(&map, command, lift);
        let after = one.all();
        assert_eq!(named, two.frame(&map, command, lift), "case {case}, frame {frame}: brute force, another order");
        assert_eq!(after, two.all(), "case {case}, frame {frame}: brute force, another order");
        assert_eq!(named, three.frame(&map, command, lift), "case {case}, frame {frame}: hash, another order");
        assert_eq!(after, three.all(), "case {case}, frame {frame}: hash, another order");
        if let Some(fault) = judge(all, &after) {
            panic!("case {case}, frame {frame}: {fault}");
        }
        for ((was, _), (is, _)) in before.iter().zip(&after).filter(|body| body.0.0.key < 200) {
            let told = named.binary_search(&was.key).is_ok();
            let velocity = command.filter(|to| to.0 == was.key).map_or(was.velocity, |to| to.1);
            if !told {
                assert_eq!(is.shape.position() - was.shape.position(), velocity, "case {case}, frame {frame}");
            }
            (flown, met) = (flown + u64::from(!told), met + u64::from(told));
        }
        frames += 1;
    }
    let awake = one.all().into_iter().filter(|(body, awake)| *awake && body.key >= 200);
    assert_eq!(awake.map(|(body, _)| body.key).collect::<Vec<_>>(), [0; 0], "case {case}: still awake");
    [frames, flown, met]
}
