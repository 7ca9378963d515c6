//! Sequences of operations on many bodies. Compares broad phases with a list of boxes, and scenes
//! with each other.

use core::num::NonZeroU8;
use tilesat::broad::{BroadPhase, BruteForce, Handle, LooseGrid, SortSweep, Tag};
use tilesat::prelude::*;
use tilesat::scene::{SceneBody, SceneError, SceneEvent, SceneTag, Shape, Sleep, Stepped};
use tilesat::{Aabb, Circle, Filter, Fx, LayerMask, Ratio, Scene, Surface, Vec2};
use tilesat_judge::Random;
use tilesat_judge::broad::near::Near;
use tilesat_judge::broad::script::{At, Op, Play, Shape as Place};
use tilesat_judge::broad::{Cells, Check, Mark, everywhere};
use tilesat_judge::scenes::{BODIES, check, room};

/// Operations per sequence.
const MOST: usize = 80;

/// Quarters of a cell, mostly near each other, and at most 2 raw off.
fn at(r: &mut Random) -> At {
    let quarters = match r.below(7) {
        0..=3 => r.below(16),
        4 | 5 => r.within(-8, 71),
        _ => r.within(-400, 399),
    };
    (quarters, r.around(2))
}

fn place(r: &mut Random) -> Place {
    let size = |r: &mut Random| if r.below(13) < 12 { r.below(7) } else { r.within(7, 8) } as usize;
    (at(r), at(r), size(r), size(r))
}

fn op(r: &mut Random) -> Op {
    let which = |r: &mut Random| r.below(64) as usize;
    let room = |r: &mut Random| r.below(6) as usize;
    let team = |r: &mut Random| r.below(4) as u8;
    let some = |r: &mut Random, n: i64| r.one_in(n).then(|| which(r));
    match r.below(41) {
        0..=9 => Op::Insert(place(r), r.below(6) as u32, team(r)),
        10..=13 => Op::Move(which(r), place(r)),
        14 | 15 => Op::MoveEach((r.around(6), r.around(2)), (r.around(6), r.around(2))),
        16 | 17 => Op::Remove(which(r)),
        18 => Op::SetTag(which(r), r.below(6) as u32, team(r)),
        19 => Op::Save,
        20 => Op::Restore,
        21..=24 => Op::Pairs,
        25 | 26 => Op::Sorted(room(r)),
        27..=29 => {
            let steps = r.below(12);
            Op::From(
                (0..steps).map(|_| (r.below(30) as u32, r.within(1, 4) as usize, some(r, 3), some(r, 20))).collect(),
            )
        }
        30 | 31 => {
            let movers = r.below(8);
            Op::Of((0..movers).map(|_| which(r)).collect())
        }
        32 | 33 => Op::Region(place(r), room(r)),
        34 => Op::Point(at(r), at(r)),
        35 | 36 => Op::Near(at(r), at(r), at(r), team(r), room(r)),
        37 | 38 => Op::Ray(at(r), at(r), at(r), at(r), team(r), room(r)),
        _ => Op::Cast(place(r), at(r), at(r), team(r), room(r)),
    }
}

struct Script(Cells, Vec<Op>);

impl Check for Script {
    fn on(&mut self, name: &str, limit: Option<i32>, empty: &Near<Mark>) {
        let mut play = Play::new(name, limit, self.0, empty);
        for op in &self.1 {
            play.play(op);
        }
        play.look();
    }
}

/// Compares every broad phase with brute force.
pub(crate) fn broad(data: &[u8]) {
    let mut r = Random::steered(data);
    let end = (1 << 29) - 1;
    let origin = |r: &mut Random| [0, -1, -end, end, 1000 << 16, r.around(99_999) as i32][r.below(6) as usize];
    let cells = Cells { side: 1 << r.within(1, 28), origin: (origin(&mut r), origin(&mut r)) };
    let mut ops = Vec::new();
    while ops.len() < MOST && Random::is_left() {
        ops.push(op(&mut r));
    }
    everywhere(24, cells, &mut Script(cells, ops));
}

fn shape(r: &mut Random) -> Shape {
    let raw = |r: &mut Random, units: i64| {
        let fine = if r.one_in(2) { 0 } else { r.below(1 << 16) };
        (r.below(units) << 16 | fine) as i32
    };
    let (x, y) = (raw(r, 180), raw(r, 70));
    let size = |r: &mut Random| 1 + raw(r, 14);
    if r.one_in(2) {
        let (w, h) = (size(r), size(r));
        Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).expect("inside the domain").into()
    } else {
        Circle::new(Vec2::from_raw(x, y), Fx::from_bits(size(r) / 2)).expect("inside the domain").into()
    }
}

fn velocity(r: &mut Random) -> Vec2 {
    // A motion that is sometimes longer than a step allows.
    let component = |r: &mut Random| (r.sign() * r.magnitude(1 << 29)).clamp(-(1 << 29), 1 << 29) as i32;
    if r.one_in(8) { Vec2::from_raw(component(r), component(r)) } else { slow(r) }
}

fn slow(r: &mut Random) -> Vec2 {
    Vec2::from_raw(r.around(1 << 20) as i32, r.around(1 << 20) as i32)
}

fn body(r: &mut Random, key: u32) -> SceneBody {
    let ratio = |r: &mut Random| Ratio::percent(r.below(101) as u8).expect("a share");
    let mask = |r: &mut Random| LayerMask(1 + r.below(15) as u16);
    SceneBody {
        velocity: velocity(r),
        mass: NonZeroU8::new(r.below(6) as u8),
        surface: Surface::new(ratio(r), ratio(r)).resting_below(Fx::from_bits(r.below(1 << 17) as i32)),
        filter: Filter::new(mask(r), mask(r)).with_sensor(r.one_in(6)),
        floats: r.one_in(5),
        ..SceneBody::new(shape(r), key)
    }
}

/// Everything that a scene shows of a body, by its key.
type Seen = (SceneBody, bool, bool);

fn seen<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, BODIES>) -> Vec<Seen> {
    let one = |(handle, body): (Handle, &SceneBody)| {
        (*body, scene.is_awake(handle).expect("it is in"), scene.is_supported(handle).expect("it is in"))
    };
    let mut all: Vec<_> = scene.bodies().map(one).collect();
    all.sort_by_key(|seen| seen.0.key);
    all
}

/// A scene, and the key of each body in it.
#[derive(Clone)]
struct Stage<B> {
    scene: Scene<B, BODIES>,
    names: Vec<(u32, Handle)>,
}

/// The reported changes, by key.
type Told = Result<Option<Stepped>, tilesat::scene::SceneFault>;

#[derive(Clone, Copy)]
enum Change {
    Insert(SceneBody),
    Remove(u32),
    Push(u32, Vec2),
    Velocity(u32, Vec2),
    Place(u32, Shape),
    Alter(u32, SceneBody),
    Wake(u32),
    Region(Aabb),
    Step(Vec2),
}

impl<B: BroadPhase<Tag = SceneTag> + Copy> Stage<B> {
    fn new(near: B, sleep: Sleep) -> Self {
        Self { scene: Scene::with_sleep(near, sleep), names: Vec::new() }
    }

    fn handle(&self, key: u32) -> Option<Handle> {
        self.names.iter().find(|name| name.0 == key).map(|name| name.1)
    }

    fn make(&mut self, change: &Change) -> Told {
        let none = |result: Result<(), SceneError>| result.map(|()| None).map_err(|error| error.fault);
        let of = |key: &u32| self.handle(*key);
        match change {
            Change::Insert(body) => {
                let handle = self.scene.insert(body).map_err(|error| error.fault)?;
                self.names.push((body.key, handle));
                Ok(None)
            }
            Change::Remove(key) => {
                let Some(handle) = of(key) else { return Ok(None) };
                self.names.retain(|name| name.0 != *key);
                assert_eq!(self.scene.remove(handle).map(|body| body.key), Ok(*key));
                assert!(self.scene.remove(handle).is_err() && self.scene.body(handle).is_err());
                Ok(None)
            }
            Change::Push(key, by) => of(key).map_or(Ok(None), |handle| none(self.scene.push(handle, *by))),
            Change::Velocity(key, v) => of(key).map_or(Ok(None), |handle| none(self.scene.set_velocity(handle, *v))),
            Change::Place(key, shape) => of(key).map_or(Ok(None), |handle| none(self.scene.place(handle, *shape))),
            Change::Alter(key, to) => of(key).map_or(Ok(None), |handle| {
                none(self.scene.alter(handle, |body| *body = SceneBody { key: *key, ..*to }))
            }),
            Change::Wake(key) => of(key).map_or(Ok(None), |handle| none(self.scene.wake(handle))),
            Change::Region(region) => {
                self.scene.wake_region(region);
                Ok(None)
            }
            Change::Step(gravity) => self.step(*gravity).map(Some),
        }
    }

    /// Checks that no body enters the solid. A body that could not move is reported, stays, and has
    /// no velocity.
    fn step(&mut self, gravity: Vec2) -> Result<Stepped, tilesat::scene::SceneFault> {
        let before: Vec<_> = self.scene.bodies().map(|(handle, body)| (handle, *body)).collect();
        let rest_together: Vec<_> = before
            .iter()
            .flat_map(|a| before.iter().map(move |b| (a, b)))
            .filter(|((a, one), (b, other))| a.slot() < b.slot() && joins(one, other))
            // One of two sleeping bodies may wake in this step and the other in the next.
            .filter(|((a, _), (b, _))| [a, b].iter().any(|body| self.scene.is_awake(**body) == Ok(true)))
            .map(|((a, _), (b, _))| (*a, *b))
            .collect();
        let mut held = Vec::new();
        let stepped = self.scene.step(&room(), gravity, |event| {
            if let SceneEvent::Held { body, .. } = event {
                held.push(body);
            }
        });
        let stepped = stepped.map_err(|error| error.fault)?;
        assert_eq!(usize::from(stepped.held), held.len());
        for (a, b) in rest_together {
            let awake = |handle| self.scene.is_awake(handle).expect("a step removes nobody");
            assert_eq!(awake(a), awake(b), "one of two that touched sleeps: {a:?} {b:?}");
        }
        for (handle, was) in before {
            let is = self.scene.body(handle).expect("a step removes nobody");
            if held.contains(&handle) {
                assert_eq!((is.shape, is.velocity), (was.shape, Vec2::ZERO), "held: {was:?}");
            } else if was.mass.is_some() && !was.shape.overlaps_level(&room()) {
                assert!(!is.shape.overlaps_level(&room()), "entered the solid: {was:?}, {is:?}");
            }
        }
        Ok(stepped)
    }
}

/// Whether two bodies touch and collide, so that they sleep together or not at all.
fn joins(one: &SceneBody, other: &SceneBody) -> bool {
    let moves = |body: &SceneBody| body.mass.is_some() && !body.filter.sensor();
    moves(one) && moves(other) && one.filter.pairs_with(&other.filter) && one.shape.touches(&other.shape)
}

fn change(r: &mut Random, key: &mut u32) -> Change {
    let any = |r: &mut Random, key: u32| r.below(i64::from(key) + 1) as u32;
    match r.below(16) {
        0..=3 => {
            *key += 1;
            Change::Insert(body(r, *key))
        }
        4 => Change::Remove(any(r, *key)),
        5 => Change::Push(any(r, *key), velocity(r)),
        6 => Change::Velocity(any(r, *key), velocity(r)),
        7 => Change::Place(any(r, *key), shape(r)),
        8 => Change::Alter(any(r, *key), body(r, 0)),
        9 => Change::Wake(any(r, *key)),
        10 => Change::Region(shape(r).aabb()),
        _ => Change::Step(if r.one_in(4) { slow(r) } else { Vec2::from_raw(0, 6554) }),
    }
}

/// Runs a scene on three broad phases at once, with the same bodies. Checks consistency, and that a
/// rollback repeats the results.
pub(crate) fn scene(data: &[u8]) {
    let mut r = Random::steered(data);
    let sleep = Sleep { steps: r.below(20) as u8, ..Sleep::default() };
    let mut one = Stage::new(SortSweep::<BODIES, SceneTag>::new(), sleep);
    let mut two = Stage::new(BruteForce::<BODIES, SceneTag>::new(), sleep);
    let grid = LooseGrid::<8, BODIES, SceneTag, true>::new(Vec2::ZERO, Fx::from_bits(1 << 20), 16).expect("a grid");
    let mut three = Stage::new(grid, sleep);
    let (mut key, mut saved) = (0, None);
    let mut since: Vec<(Change, Vec<Seen>)> = Vec::new();
    for _ in 0..MOST {
        if !Random::is_left() {
            break;
        }
        if r.one_in(10) {
            if let Some(snapshot) = saved.replace(one.clone()) {
                // Rolls back and applies the same changes again.
                let mut again: Stage<_> = snapshot;
                for (change, expected) in &since {
                    let _ = again.make(change);
                    assert_eq!(&seen(&again.scene), expected, "after a rollback");
                }
            }
            since.clear();
        }
        let change = change(&mut r, &mut key);
        // A body needs many steps to come to rest and fall asleep.
        let times = if matches!(change, Change::Step(_)) && r.one_in(4) { r.within(2, 24) } else { 1 };
        for _ in 0..times {
            let told = one.make(&change);
            let (second, third) = (two.make(&change), three.make(&change));
            let pairs = |told: &Told| told.map(|stepped| stepped.map(|stepped| Stepped { pairs: 0, ..stepped }));
            assert_eq!((pairs(&told), pairs(&told)), (pairs(&second), pairs(&third)), "told by three broad phases");
            let all = seen(&one.scene);
            assert_eq!((&all, &all), (&seen(&two.scene), &seen(&three.scene)), "by three broad phases");
            check(&one.scene);
            check(&three.scene);
            since.push((change, all));
        }
    }
}
