//! A scene, with each broad phase, in each kind of level, with capsules and with memory.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::broad::{BruteForce, Handle, LooseGrid, Pair, SortSweep, SpatialHash};
use tilesat::motion::Ride;
use tilesat::prelude::*;
use tilesat::scene::SceneFault;
use tilesat::scene::{Reply, SceneCharacter, SceneEvent, SceneTag, Shape, Sleep, Snapshot, WithCapsules};
use tilesat::shape::AnyShape;
use tilesat::world::{AllShapes, ConvexSolid, ConvexSolids, Joined, RayRules, SegmentMap, Solids, TileMap, Trail};
use tilesat::{Aabb, Capsule, Character, Circle, Fx, Input, Inside, OrientedBox, Scene, SceneBody, Solid, Vec2};
use tilesat_flash::keep;

type Near = SortSweep<16, SceneTag>;
type Pills = Scene<Near, 16, 0, WithCapsules>;
type Remembering = Scene<Near, 16, 24>;
type Any = Scene<Near, 16, 0, AnyShape<6>>;
type Rides = fn(Handle, Result<Ride, SceneFault>);
type Doors<'a> = Joined<'a, TileMap<'a, AllShapes>, Solids<'a>>;
type Planks<'a> = Joined<'a, TileMap<'a, AllShapes>, ConvexSolids<'a, OrientedBox>>;

macro_rules! scenes {
    ($($n:literal: $near:ty),+ $(,)?) => {
        $(keep! {
            |near: $near| Scene::<$near, $n>::new(near);
            |near: $near, sleep: Sleep| Scene::<$near, $n>::with_sleep(near, sleep);
            |s: &'static Scene<$near, $n>| s.near();
            |s: &mut Scene<$near, $n>, sleep: Sleep| s.set_sleep(sleep);
            |s: &Scene<$near, $n>| s.sleep();
            |s: &mut Scene<$near, $n>, body: &SceneBody| s.insert(body);
            |s: &mut Scene<$near, $n>, h: Handle| s.remove(h);
            |s: &'static Scene<$near, $n>, h: Handle| s.body(h);
            |s: &Scene<$near, $n>, h: Handle| s.is_awake(h);
            |s: &Scene<$near, $n>, h: Handle| s.is_supported(h);
            |s: &Scene<$near, $n>, pair: &Pair| s.rests(pair);
            |s: &'static Scene<$near, $n>| s.awake();
            |s: &mut Scene<$near, $n>, h: Handle, by: Vec2| s.push(h, by);
            |s: &mut Scene<$near, $n>, h: Handle, v: Vec2| s.set_velocity(h, v);
            |s: &mut Scene<$near, $n>, h: Handle, shape: Shape| s.place(h, shape);
            |s: &mut Scene<$near, $n>, h: Handle| s.wake(h);
            |s: &mut Scene<$near, $n>, region: &Aabb| s.wake_region(region);
            |s: &Scene<$near, $n>, o: Vec2, d: Vec2, inside: Inside, wanted: fn(Handle, &SceneBody) -> bool| {
                s.cast_ray(o, d, inside, wanted)
            };
            |s: &Scene<$near, $n>, a: &Shape, d: Vec2, inside: Inside, wanted: fn(Handle, &SceneBody) -> bool| {
                s.cast_shape(a, d, inside, wanted)
            };
            |s: &Scene<$near, $n>, l: &TileMap<'_>, o: Vec2, d: Vec2, rules: RayRules| {
                s.cast_ray_in(l, o, d, rules, |_, _| true)
            };
            |s: &Scene<$near, $n>, l: &TileMap<'_>, a: &Shape, d: Vec2, rules: RayRules| {
                s.cast_shape_in(l, *a, d, rules, |_, _| true)
            };
            |s: &Scene<$near, $n>, a: &Shape, each: fn(Handle, &SceneBody)| s.overlapping(a, each);
            |s: &Scene<$near, $n>, a: &Circle, each: fn(Handle, &SceneBody)| s.touching(a, each);
            |s: &Scene<$near, $n>, p: Vec2, each: fn(Handle, &SceneBody)| s.at_point(p, each);
            |s: &Scene<$near, $n>| s.snapshot();
            |s: &Scene<$near, $n>, into: &mut Snapshot<$near, $n>| s.snapshot_into(into);
            |s: &mut Scene<$near, $n>, from: &Snapshot<$near, $n>| s.restore(from);
            |s: &mut Scene<$near, $n>, blocks: &TileMap<'_>, g: Vec2, each: fn(SceneEvent<'_>)| s.step(blocks, g, each);
        })+
    };
}

// The names of levels and scenes are those of the rows of bounds.
macro_rules! steps {
    ($($l:ident: $level:ty),+) => {
        $(keep! {
            |s: &mut Scene<SortSweep<64, SceneTag>, 64>, $l: &$level, g: Vec2, each: fn(SceneEvent<'_>)| s.step($l, g, each);
            |s: &Shape, l: &$level| s.overlaps_level(l);
        })+
    };
}

fn shapes() {
    keep! {
        |shape: Shape, key: u32| SceneBody::new(shape, key);
        |shape: Shape, key: u32| SceneBody::fixed(shape, key);
        |shape: Shape, key: u32| SceneBody::of_shape(shape, key);
        |shape: Aabb| Shape::from(shape);
        |shape: Circle| Shape::from(shape);
        |s: &Shape| (s.aabb(), s.position());
        |a: &Shape, b: &Shape| a.contact(b);
        |a: &Shape, b: &Shape| a.overlaps(b);
        |a: &Shape, b: &Shape| a.touches(b);
        |a: &Shape, o: Vec2, d: Vec2, inside: Inside| a.cast_ray(o, d, inside);
        |a: &Shape, b: &Shape, d: Vec2, inside: Inside| (a.cast_shape(b, d, inside), a.exact_toi(b, d, inside));
        |a: &Shape, b: &Capsule, d: Vec2, inside: Inside| (a.cast_shape(b, d, inside), b.would_hit(a, d, inside));
        |a: &Shape, b: &Circle| (b.overlaps(a), b.touches(a), b.contact(a), b.manifold(a));
        |a: &Shape, b: &Aabb| (a.distance(b), a.closest_points(b), a.contains(b), b.contains(a));
        |a: &Shape, p: &Vec2| (a.distance(p), a.contains(p));
        |_any: u8| Sleep::default();
    }
}

fn phases() {
    scenes!(
        32: BruteForce<32, SceneTag>,
        64: SortSweep<64, SceneTag>,
        300: LooseGrid<24, 300, SceneTag, true>,
        40: SpatialHash<64, 64, SceneTag>,
    );
}

fn levels() {
    steps!(shapes: TileMap<'_, AllShapes>, segments: SegmentMap<'_>, lifts: Doors<'_>, planks: Planks<'_>);
}

fn sets() {
    keep! {
        |shape: Capsule, key: u32| SceneBody::<WithCapsules>::of(shape, key);
        |shape: Capsule| WithCapsules::from(shape);
        |s: &WithCapsules| (s.aabb(), s.position());
        |a: &WithCapsules, b: &WithCapsules| (a.contact(b), a.overlaps(b), a.touches(b));
        |a: &WithCapsules, o: Vec2, d: Vec2, inside: Inside| a.cast_ray(o, d, inside);
        |a: &WithCapsules, b: &WithCapsules, d: Vec2, inside: Inside| (a.cast_shape(b, d, inside), a.distance(b));
        |s: &Pills, o: Vec2, d: Vec2, inside: Inside| s.cast_ray(o, d, inside, |_, _| true);
        |s: &Pills, a: &Capsule, d: Vec2, inside: Inside| s.cast_shape(a, d, inside, |_, _| true);
        |s: &Pills, a: &OrientedBox, each: fn(Handle, &SceneBody<WithCapsules>)| s.overlapping(a, each);
        |s: &Pills, l: &Doors<'_>, o: Vec2, d: Vec2, inside: Inside| s.cast_ray_in(l, o, d, inside, |_, _| true);
        |s: &Pills, l: &Doors<'_>, a: &WithCapsules, d: Vec2| s.cast_shape_in(l, *a, d, Inside::Ignore, |_, _| true);
        |s: &Any, l: &SegmentMap<'_>, a: &AnyShape<6>, d: Vec2| s.cast_shape_in(l, *a, d, Inside::Hit, |_, _| true);
        |s: &Any, o: Vec2, d: Vec2, inside: Inside| s.cast_ray(o, d, inside, |_, _| true);
        |s: &Any, a: &AnyShape<6>, d: Vec2, inside: Inside| s.cast_shape(a, d, inside, |_, _| true);
        |s: &Any, a: &AnyShape<6>, each: fn(Handle, &SceneBody<AnyShape<6>>)| s.touching(a, each);
        |s: &mut Pills, body: &SceneBody<WithCapsules>| s.insert(body);
        |s: &mut Pills, h: Handle, shape: WithCapsules| s.place(h, shape);
        |s: &mut Pills, h: Handle| s.remove(h);
        |pills: &mut Pills, shapes: &TileMap<'_, AllShapes>, g: Vec2, each: fn(SceneEvent<'_>)| pills.step(shapes, g, each);
        |s: &Pills, into: &mut Snapshot<Near, 16, WithCapsules>| s.snapshot_into(into);
        |s: &mut Pills, from: &Snapshot<Near, 16, WithCapsules>| s.restore(from);
        |shape: AnyShape<6>, key: u32| SceneBody::<AnyShape<6>>::of(shape, key);
        |s: &mut Any, body: &SceneBody<AnyShape<6>>| s.insert(body);
        |s: &mut Any, h: Handle, shape: AnyShape<6>| s.place(h, shape);
        |any: &mut Any, shapes: &TileMap<'_, AllShapes>, g: Vec2, each: fn(SceneEvent<'_>)| any.step(shapes, g, each);
    }
}

fn rides() {
    keep! {
        |s: &mut Scene<Near, 16>, l: &TileMap<'_, AllShapes>, lifts: &mut [Solid], g: Vec2, follow: Fx, each: Rides| s.ride(l, lifts, g, follow, each);
        |s: &mut Scene<Near, 16>, l: &TileMap<'_, AllShapes>, planks: &mut [ConvexSolid<OrientedBox>], g: Vec2, follow: Fx, each: Rides| s.ride(l, planks, g, follow, each);
        |pills: &mut Pills, l: &TileMap<'_, AllShapes>, lifts: &mut [Solid], g: Vec2, follow: Fx, each: Rides| pills.ride(l, lifts, g, follow, each);
        |any: &mut Any, l: &TileMap<'_, AllShapes>, solids: &mut [ConvexSolid<AnyShape<6>>], g: Vec2, follow: Fx, each: Rides| any.ride(l, solids, g, follow, each);
    }
}

fn characters() {
    keep! {
        |hero: Character, h: Handle| SceneCharacter::new(hero, h);
        |hero: &SceneCharacter| (hero.handle(), hero.stands_on());
        |body: Aabb, key: u32| SceneBody::<Shape>::led(body, key);
        |hero: &mut SceneCharacter, s: &mut Scene<Near, 16>, l: &TileMap<'_, AllShapes>, lifts: &[Solid], i: Input| hero.lead(s, l, lifts, i);
        |hero: &mut SceneCharacter, s: &Scene<Near, 16>, l: &TileMap<'_, AllShapes>, lifts: &[Solid]| hero.follow(s, l, lifts);
        |hero: &SceneCharacter, s: &Scene<Near, 16>, l: &TileMap<'_, AllShapes>, lifts: &[Solid], far: Fx| hero.ledge_ahead(s, l, lifts, far);
        |hero: &mut SceneCharacter, s: &Scene<Near, 16>, l: &TileMap<'_, AllShapes>, lifts: &[Solid], body: Aabb| hero.set_body(s, l, lifts, body);
        |hero: &SceneCharacter, s: &Scene<Near, 16>| hero.pressed_by(s);
        |pill: &mut SceneCharacter<Capsule>, s: &mut Pills, l: &TileMap<'_, AllShapes>, lifts: &[Solid], i: Input| pill.lead(s, l, lifts, i);
        |pill: &mut SceneCharacter<Capsule>, s: &Pills, l: &TileMap<'_, AllShapes>, lifts: &[Solid]| pill.follow(s, l, lifts);
    }
}

fn memory() {
    keep! {
        |near: Near, sleep: Sleep| Remembering::remembering(near, sleep);
        |s: &mut Remembering, body: &SceneBody| s.insert(body);
        |s: &mut Remembering, h: Handle, v: Vec2| s.set_velocity(h, v);
        |s: &mut Remembering, region: &Aabb| s.wake_region(region);
        |remembering: &mut Remembering, shapes: &TileMap<'_, AllShapes>, g: Vec2, each: fn(SceneEvent<'_>)| remembering.step(shapes, g, each);
        |s: &mut Remembering, l: &TileMap<'_, AllShapes>, g: Vec2, replies: fn(Pair) -> Reply, passed: fn(Handle, &Shape, &Trail)| s.step_along(|_| l, g, replies, |_| (), passed);
        |l: &TileMap<'_>, s: &Shape, trail: &Trail| l.tiles_on(s, trail).map(Iterator::count);
    }
}

tilesat_flash::everything!(shapes, phases, levels, sets, rides, characters, memory);
