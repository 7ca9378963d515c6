//! Questions to a scene about its bodies, against all bodies one by one: the exact time of each
//! hit, then the key, then the slot. Times and overlaps are judged by the exact sum of two shapes.

use super::sums::{cast_time, floor, sum};
use std::collections::BTreeSet;
use tilesat::broad::{BroadPhase, BruteForce, Handle, LooseGrid, SortSweep, SpatialHash};
use tilesat::scene::{BodyShape, SceneHit, SceneTag, Shape, WithCapsules};
use tilesat::shape::Compound;
use tilesat::{
    Aabb, Capsule, CastHit, Circle, Filter, Fx, Inside, LayerMask, Quantity, RangeError, Scene, SceneBody, TileKinds,
    TileMap, Vec2,
};
use tilesat_judge::casts::judge::ONE;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::scenes::BODIES;
use tilesat_judge::solids::shapes::{Any, mirrored_shape, plank};
use tilesat_judge::solids::{P, disc, raw, rect, vec2};
use tilesat_judge::{Random, cases, enough};

/// Bodies of a random scene. Only its own scene takes steps: each kind of scene that does compiles
/// a step.
const CROWD: u32 = 10;
/// The capacity of most tests, whose steps are compiled anyway.
const N: usize = BODIES;
type Near = SortSweep<N, SceneTag>;
type Bodies<B, S> = Scene<B, N, 0, S>;

/// A set of shapes, as the judge sees it.
pub(super) trait Set: BodyShape {
    fn of(any: &Any) -> Option<Self>;
    fn any(&self) -> Any;
    fn ray(&self, o: Vec2, d: Vec2, inside: Inside) -> Option<CastHit>;
}

macro_rules! sets {
    ($($set:ident: $($shape:ident)+;)+) => {$(
        impl Set for $set {
            fn of(any: &Any) -> Option<Self> {
                match any {
                    $(Any::$shape(it) => Some(Self::$shape(*it)),)+
                    _ => None,
                }
            }
            fn any(&self) -> Any {
                match self {
                    $(Self::$shape(it) => (*it).into(),)+
                }
            }
            fn ray(&self, o: Vec2, d: Vec2, inside: Inside) -> Option<CastHit> {
                match self {
                    $(Self::$shape(it) => it.cast_ray(o, d, inside).unwrap(),)+
                }
            }
        }
    )+};
}

sets! {
    Shape: Aabb Circle;
    WithCapsules: Aabb Circle Capsule;
}

impl Set for Any {
    fn of(any: &Any) -> Option<Self> {
        Some(*any)
    }
    fn any(&self) -> Any {
        *self
    }
    fn ray(&self, o: Vec2, d: Vec2, inside: Inside) -> Option<CastHit> {
        self.cast_ray(o, d, inside).unwrap()
    }
}

/// The time of a ray that hits. If it enters no inside (it meets a corner, or the very end), its
/// time at a sharp shape is that of the first touch, which must be whole to be exact.
fn ray_time(shape: &Any, o: P, d: P, hit: &CastHit) -> i64 {
    let set = sum(&disc(o, 0).into(), shape);
    if hit.inside {
        return 0;
    }
    if set.radius > 0 || set.met::<Int256>(d, ONE) {
        return floor(&set, d);
    }
    let toi = i64::from(hit.toi.raw());
    assert!(toi == 0 || !set.touched::<Int256>(d, toi - 1));
    assert!(set.touched::<Int256>(d, (toi + 1).min(ONE)));
    toi
}

fn shape(r: &mut Random, unit: i64, kinds: i64) -> Any {
    let c = (r.around(9) * unit, r.around(9) * unit);
    let c = if r.one_in(4) { (c.0 + r.around(3), c.1 + r.around(3)) } else { c };
    let (w, h) = (r.within(1, 4) * unit, r.within(1, 4) * unit);
    match r.below(kinds) {
        0 => rect(c, (c.0 + w, c.1 + h)).into(),
        1 => disc(c, w).into(),
        2 => {
            let end = if r.one_in(2) { (c.0 + h, c.1) } else { (c.0, c.1 + h) };
            Capsule::new(vec2(c), vec2(end), Fx::from_bits(w as i32)).unwrap().into()
        }
        _ => plank(c, (w, h), (r.around(4) | 1, r.around(4))),
    }
}

/// Bodies in the order of their slots.
fn filled<B: BroadPhase<Tag = SceneTag>, S: Set>(near: B, bodies: &[SceneBody<S>]) -> Bodies<B, S> {
    let mut scene = Bodies::<B, S>::new(near);
    for body in bodies {
        scene.insert(body).unwrap();
    }
    scene
}

/// All that a game does with a scene: some bodies are fixed, some sleep, some have moved, were
/// placed, or have the slot of another one that was removed.
fn play<S: Set>(bodies: &[(SceneBody<S>, S)], gone: usize) -> Bodies<Near, S> {
    let level = TileMap::from_ascii(".", &TileKinds::EMPTY).unwrap();
    let mut scene = Bodies::<Near, S>::new(Near::new());
    let mut handles: Vec<_> = bodies[..gone].iter().map(|(body, _)| scene.insert(body).unwrap()).collect();
    for old in handles.drain(..).rev() {
        scene.remove(old).unwrap();
    }
    for (body, to) in bodies {
        let handle = scene.insert(body).unwrap();
        if body.key % 3 == 0 {
            scene.place(handle, *to).unwrap();
        } else if body.key % 3 == 1 {
            scene.alter(handle, |body| body.shape = *to).unwrap();
        }
    }
    if gone % 2 == 1 {
        for _ in 0..35 {
            scene.step(&level, Vec2::ZERO, |_| {}).unwrap();
        }
    }
    scene
}

type Answer = Option<(u32, CastHit)>;

fn answer<S: Set, B: BroadPhase<Tag = SceneTag>>(scene: &Bodies<B, S>, hit: Option<SceneHit>) -> Answer {
    hit.map(|hit| (scene.body(hit.body).unwrap().key, hit.hit))
}

struct Question<S> {
    body: S,
    o: P,
    d: P,
    inside: Inside,
    mask: u16,
}

/// The answers of one scene: a ray, a cast, and the keys of the bodies that overlap, touch, and
/// contain a point.
fn ask<S: Set, B: BroadPhase<Tag = SceneTag>>(
    scene: &Bodies<B, S>,
    q: &Question<S>,
) -> (Answer, Answer, [Vec<u32>; 3]) {
    let wanted = |_: Handle, body: &SceneBody<S>| body.filter.layers.0 & q.mask != 0;
    let ray = scene.cast_ray(vec2(q.o), vec2(q.d), q.inside, wanted).unwrap();
    let cast = scene.cast_shape(&q.body, vec2(q.d), q.inside, wanted).unwrap();
    let mut found = [const { Vec::new() }; 3];
    scene.overlapping(&q.body, |_, body| found[0].push(body.key));
    scene.touching(&q.body, |_, body| found[1].push(body.key));
    scene.at_point(vec2(q.o), |_, body| found[2].push(body.key));
    for keys in &mut found {
        keys.sort_unstable();
    }
    (answer(scene, ray), answer(scene, cast), found)
}

/// What the cases were.
#[derive(Default)]
struct Seen {
    hits: u64,
    ties: u64,
    /// The bounds of the times would have named another body.
    close: u64,
    inside: u64,
    many: u64,
}

fn judge<S: Set>(
    bodies: &[SceneBody<S>],
    q: &Question<S>,
    (ray, cast, found): &(Answer, Answer, [Vec<u32>; 3]),
    seen: &mut Seen,
) {
    let case = || format!("{:?} {:?} {:?} {:?} among {bodies:?}", q.body, q.o, q.d, q.inside);
    let (o, d) = (vec2(q.o), vec2(q.d));
    let wanted = || bodies.iter().filter(|body| body.filter.layers.0 & q.mask != 0);
    let first = |times: &mut dyn Iterator<Item = (i64, u32, CastHit)>, answer: &Answer, seen: &mut Seen| {
        let mut all: Vec<_> = times.collect();
        let bound = all.iter().map(|(_, key, hit)| (hit.toi, *key)).min();
        all.sort_by_key(|(time, key, _)| (*time, *key));
        let wanted = all.first().map(|(time, key, hit)| (*time, *key, *hit));
        let got = answer.map(|(key, hit)| (i64::from(hit.toi.raw()), key, hit));
        assert_eq!(got.map(|g| (g.0, g.1)), wanted.map(|w| (w.0, w.1)), "{}", case());
        if let (Some(got), Some(wanted)) = (got, wanted) {
            assert_eq!(CastHit { toi: wanted.2.toi, ..got.2 }, wanted.2, "{}", case());
            seen.hits += 1;
            seen.ties += u64::from(all.iter().filter(|one| one.0 == wanted.0).count() > 1);
            seen.close += u64::from(bound.is_some_and(|bound| bound.1 != wanted.1));
            seen.inside += u64::from(got.2.inside);
        }
    };
    let rays = wanted().filter_map(|body| {
        let hit = body.shape.ray(o, d, q.inside)?;
        Some((ray_time(&body.shape.any(), q.o, q.d, &hit), body.key, hit))
    });
    first(&mut { rays }, ray, seen);
    let casts = wanted().filter_map(|body| {
        let time = cast_time(&q.body.any(), &body.shape.any(), q.d, q.inside)?;
        Some((time, body.key, q.body.cast_shape(&body.shape, d, q.inside).unwrap().expect("the judge says so")))
    });
    first(&mut { casts }, cast, seen);
    let keys = |test: &dyn Fn(&Any) -> bool| {
        let mut keys: Vec<_> = bodies.iter().filter(|b| test(&b.shape.any())).map(|b| b.key).collect();
        keys.sort_unstable();
        keys
    };
    let point: Any = disc(q.o, 0).into();
    assert_eq!(found[0], keys(&|b| sum(&q.body.any(), b).holds::<Int256>((0, 0))), "{}", case());
    assert_eq!(found[1], keys(&|b| sum(&q.body.any(), b).touched::<Int256>((0, 0), 0)), "{}", case());
    assert_eq!(found[2], keys(&|b| sum(&point, b).touched::<Int256>((0, 0), 0)), "{}", case());
    seen.many += u64::from(found[0].len() > 1 && found[1].len() > found[0].len());
}

fn flip(p: P) -> P {
    (-p.0, p.1)
}

fn random_scenes<S: Set>(kinds: i64, seed: u64) {
    let (mut r, mut seen) = (Random::new(seed), Seen::default());
    for case in 0..cases(160) {
        let unit = [1, 1 << 10, 1 << 16, 1 << 24][(case % 4) as usize];
        let pick = |r: &mut Random| loop {
            if let Some(shape) = S::of(&shape(r, unit, kinds)) {
                return shape;
            }
        };
        let count = r.within(1, CROWD.into()) as u32;
        let body = |key, r: &mut Random| {
            let velocity =
                if r.one_in(3) { vec2((r.around(unit / 64 + 1), r.around(unit / 64 + 1))) } else { Vec2::ZERO };
            let body = SceneBody { velocity, floats: true, ..SceneBody::of(pick(r), 7 * key % 31) };
            let layers = 1 << r.below(3);
            let filter = Filter::new(LayerMask(layers), LayerMask::ALL).with_sensor(r.one_in(5));
            let fixed = SceneBody { mass: None, velocity: Vec2::ZERO, ..body };
            (SceneBody { filter, ..if r.one_in(3) { fixed } else { body } }, pick(r))
        };
        let mut bodies: Vec<_> = (0..count).map(|key| body(key, &mut r)).collect();
        let gone = r.below(i64::from(count) + 1) as usize;
        let scene = play(&bodies, gone);
        let state: Vec<_> = scene.bodies().map(|(_, body)| *body).collect();
        // The same bodies, in another order and on other broad phases, and in a mirror.
        r.shuffle(&mut bodies);
        let now = |of: &dyn Fn(&Any) -> Any| -> Vec<_> {
            let it = |(body, _): &(SceneBody<S>, S)| {
                let shape = state.iter().find(|b| b.key == body.key).unwrap().shape;
                SceneBody { shape: S::of(&of(&shape.any())).unwrap(), ..*body }
            };
            bodies.iter().map(it).collect()
        };
        let (same, mirror) = (now(&|any| *any), filled(Near::new(), &now(&mirrored_shape)));
        let cell = Fx::from_bits((4 * unit).max(4) as i32);
        let brute = filled(BruteForce::<N, SceneTag>::new(), &same);
        let grid = filled(LooseGrid::<24, N, SceneTag, true>::new(Vec2::ZERO, cell, 32).unwrap(), &same);
        let hash = filled(SpatialHash::<64, N, SceneTag, true>::new(cell).unwrap(), &same);
        for _ in 0..12 {
            let jitter = |r: &mut Random| if r.one_in(3) { r.around(2) } else { 0 };
            let o = (r.around(12) * unit + jitter(&mut r), r.around(12) * unit + jitter(&mut r));
            // Casts take motions below 2^28 raw.
            let reach = if unit == 1 << 24 { 15 } else { 24 };
            let (x, y) =
                [(r.around(reach), r.around(reach)), (r.around(reach), 0), (0, r.around(reach))][r.below(3) as usize];
            let d = (x * unit + jitter(&mut r), y * unit + jitter(&mut r));
            let inside = [Inside::Ignore, Inside::Hit][r.below(2) as usize];
            let q = Question { body: pick(&mut r), o, d, inside, mask: [7, 3, 5][r.below(3) as usize] };
            let answers = ask(&scene, &q);
            judge(&state, &q, &answers, &mut seen);
            assert_eq!(answers, ask(&brute, &q));
            assert_eq!(answers, ask(&grid, &q));
            assert_eq!(answers, ask(&hash, &q));
            let image = Question { body: S::of(&mirrored_shape(&q.body.any())).unwrap(), o: flip(o), d: flip(d), ..q };
            let image = ask(&mirror, &image);
            let first = |a: &Answer| a.map(|(key, hit)| (key, hit.toi, hit.inside));
            assert_eq!((first(&answers.0), first(&answers.1)), (first(&image.0), first(&image.1)));
            assert_eq!(answers.2, image.2);
        }
    }
    let Seen { hits, ties, close, inside, many } = seen;
    println!("{hits} hits, {ties} ties, {close} close, {inside} inside, {many} with bodies that only touch");
    assert!(enough(hits > 1000 && ties > 50 && inside > 100 && many > 10), "{hits} {ties} {inside} {many}");
}

#[test]
fn boxes_and_circles() {
    random_scenes::<Shape>(2, 1);
}

#[test]
fn capsules() {
    random_scenes::<WithCapsules>(3, 2);
}

#[test]
fn any_shapes() {
    random_scenes::<Any>(4, 3);
}

/// A box and another one three units to the right of it, as one shape.
fn pair_of_boxes(scene: &Bodies<Near, Shape>, q: &Question<Shape>, [a, b]: &[(Answer, Answer, [Vec<u32>; 3]); 2]) {
    let second = q.body.aabb().translated(vec2((3 * raw(q.body.aabb().size()).0, 0))).unwrap();
    let both = Compound::<Aabb, 2>::new(&[second, q.body.aabb()]).unwrap();
    let hit = scene.cast_shape(&both, vec2(q.d), q.inside, |_, _| true).unwrap();
    // One that starts in a body and ignores it ignores the hits of the other one, too.
    if q.inside == Inside::Hit {
        let early = |hit: &Answer| hit.map(|(key, hit)| (hit.toi, key));
        assert_eq!(early(&answer(scene, hit)), early(&a.1).into_iter().chain(early(&b.1)).min());
    }
    let (mut inside, mut near) = (BTreeSet::new(), BTreeSet::new());
    scene.overlapping(&both, |_, body| assert!(inside.insert(body.key)));
    scene.touching(&both, |_, body| assert!(near.insert(body.key)));
    let either = |i: usize| a.2[i].iter().chain(&b.2[i]).copied().collect::<BTreeSet<_>>();
    assert_eq!([inside, near], [either(0), either(1)]);
}

/// Every ray and every motion of a unit box on a lattice, among three bodies that touch.
#[test]
fn every_question_of_a_lattice() {
    const UNIT: i64 = 64;
    let p = |x: i64, y: i64| (x * UNIT, y * UNIT);
    let bodies: [Shape; 3] =
        [rect(p(0, 0), p(1, 2)).into(), disc(p(2, 1), UNIT).into(), rect(p(-1, -1), p(1, 0)).into()];
    let bodies = [2, 0, 1].map(|i| SceneBody::new(bodies[i], [9, 4, 6][i]));
    let scene = filled(Near::new(), &bodies);
    let square = |n: i64| (-n..=n).flat_map(move |x| (-n..=n).map(move |y| (x, y)));
    let mut seen = Seen::default();
    for o in square(2) {
        let o = p(o.0, o.1);
        let box_at = |o: P| Shape::from(rect(o, (o.0 + UNIT, o.1 + UNIT)));
        for (d, inside) in square(4).flat_map(|d| [(d, Inside::Ignore), (d, Inside::Hit)]) {
            let q = |o| Question { body: box_at(o), o, d: p(d.0, d.1), inside, mask: !0 };
            let answers = [o, (o.0 + 3 * UNIT, o.1)].map(|o| ask(&scene, &q(o)));
            judge(&bodies, &q(o), &answers[0], &mut seen);
            pair_of_boxes(&scene, &q(o), &answers);
        }
    }
    assert!(seen.hits > 1500 && seen.ties > 150 && seen.inside > 200, "{} {} {}", seen.hits, seen.ties, seen.inside);
}

/// A ball and a box are hit within a raw unit of travel. The bound of the ball's time is early, so
/// it must not count: exact times decide.
#[test]
fn a_bound_is_not_a_time() {
    let (mut r, mut seen) = (Random::new(9), Seen::default());
    for _ in 0..cases(4000) {
        let (radius, reach) = (r.within(2, 1 << 9), r.within(1 << 8, 1 << 11));
        let (d, y) = ((reach, r.around(1 << 8)), r.around(radius - 1));
        let ball = disc((radius + r.below(1 << 8), y), radius);
        let Some(hit) = ball.cast_ray(Vec2::ZERO, vec2(d), Inside::Hit).unwrap() else { continue };
        // The first whole coordinate that the ray reaches not before the bound.
        let x = (i64::from(hit.toi.raw()) * reach + ONE - 1) / ONE;
        let wall = rect((x, -(1 << 12)), (x + 1, 1 << 12));
        let bodies = [SceneBody::new(ball, 2), SceneBody::new(wall, 1)];
        let scene = filled(Near::new(), &bodies);
        let q = Question { body: rect((-8, -8), (-4, -4)).into(), o: (0, 0), d, inside: Inside::Hit, mask: !0 };
        judge(&bodies, &q, &ask(&scene, &q), &mut seen);
    }
    assert!(enough(seen.close > 5), "{}", seen.close);
}

/// At one time the smaller key is first, and with equal keys the smaller slot. A slot that was used
/// before has another handle.
#[test]
fn ties() {
    let at = |x: i64| Shape::from(rect((x, 0), (x + 8, 8)));
    let mut scene = Bodies::<Near, Shape>::new(Near::new());
    let old = scene.insert(&SceneBody::new(at(0), 0)).unwrap();
    let _ = scene.insert(&SceneBody::new(at(100), 5)).unwrap();
    scene.remove(old).unwrap();
    let new = scene.insert(&SceneBody::fixed(at(100), 5)).unwrap();
    assert!(new.slot() == old.slot() && new != old);
    let ray = |scene: &Bodies<Near, Shape>, not: Option<Handle>| {
        scene.cast_ray(vec2((50, 4)), vec2((100, 0)), Inside::Hit, |body, _| Some(body) != not).unwrap().unwrap().body
    };
    assert_eq!(ray(&scene, None), new);
    let small = scene.insert(&SceneBody::new(at(100), 4)).unwrap();
    assert_eq!((ray(&scene, None), ray(&scene, Some(small))), (small, new));
    scene.alter(small, |body| body.key = 6).unwrap();
    assert_eq!(ray(&scene, None), new);
}

/// Rays over the whole domain meet bodies in its corners. Others are refused, before any question.
#[test]
fn the_border_of_the_range() {
    const END: i64 = (1 << 29) - 1;
    let mut scene = Bodies::<Near, Shape>::new(Near::new());
    let corner = scene.insert(&SceneBody::fixed(rect((END - 5, END - 5), (END, END)), 1)).unwrap();
    let ball = scene.insert(&SceneBody::fixed(disc((2 - END, 2 - END), 2), 2)).unwrap();
    let all = |_: Handle, _: &SceneBody| true;
    let never = |_: Handle, _: &SceneBody| -> bool { panic!("a refused question") };
    let across = vec2((2 * END, 2 * END));
    let hit = scene.cast_ray(vec2((-END, -END)), across, Inside::Ignore, all).unwrap().unwrap();
    assert_eq!(hit.body, ball);
    let hit = scene.cast_ray(vec2((-END, -END)), across, Inside::Ignore, |body, _| body != ball).unwrap().unwrap();
    assert_eq!((hit.body, hit.hit.displacement), (corner, vec2((2 * END - 5, 2 * END - 5))));
    // From the border inward, and to it.
    let at = vec2((END, END));
    assert!(scene.cast_ray(at, vec2((-1, -1)), Inside::Ignore, all).unwrap().is_some());
    assert!(scene.cast_ray(at, Vec2::ZERO, Inside::Hit, all).unwrap().is_none());
    let error = |what, value| Err(RangeError { what, value });
    assert_eq!(scene.cast_ray(at, vec2((1, 0)), Inside::Hit, never), error(Quantity::EndX, 1 << 29));
    assert_eq!(scene.cast_ray(vec2((0, 1 << 29)), Vec2::ZERO, Inside::Hit, never), error(Quantity::Y, 1 << 29));
    let small = Circle::new(vec2((END - 4, 0)), Fx::from_bits(3)).unwrap();
    assert_eq!(scene.cast_shape(&small, vec2((2, 0)), Inside::Hit, never), error(Quantity::EndX, 1 << 29));
    let far = Vec2::from_raw(-1 << 28, 0);
    assert_eq!(scene.cast_shape(&small, far, Inside::Hit, never), error(Quantity::MotionX, -1 << 28));
    let mut found = Vec::new();
    for point in [at, vec2((1 << 30, 0)), Vec2::from_raw(i32::MAX, i32::MIN)] {
        scene.at_point(point, |body, _| found.push(body));
    }
    assert_eq!(found, [corner]);
    let bounds = Aabb::new(at, at).unwrap();
    scene.touching(&bounds, |body, _| found.push(body));
    scene.overlapping(&bounds, |body, _| found.push(body));
    assert_eq!(found, [corner; 2]);
}
