//! Capsules, oriented boxes, polygons, shapes of any kind and compounds: all queries, and motion.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::heapless::VecView;
use tilesat::motion::{Mover, escape, turn};
use tilesat::prelude::*;
use tilesat::query::Separation;
use tilesat::shape::{AnyShape, Compound, ConvexParts};
use tilesat::world::{
    AllShapes, ConvexSolid, ConvexSolids, Joined, OneWay, RayRules, SegmentMap, Solids, TileMap, WorldContact,
};
use tilesat::{Aabb, Axis, Capsule, Character, Circle, ConvexPolygon, Fx, Input, Inside, OrientedBox, Segment, Vec2};
use tilesat_flash::keep;

type Quad = ConvexPolygon<4>;
type Any = AnyShape<4>;
type Group = Compound<Any, 3>;
type Lifts = Joined<'static, TileMap<'static, AllShapes>, ConvexSolids<'static, Any>>;

macro_rules! shapes {
    ($($shape:ty),+) => {
        $(keep! {
            |s: &$shape, by: Vec2| s.translated(by);
            |s: &$shape| s.aabb();
            |s: &$shape, p: Vec2| s.closest_point(p);
            |s: &$shape, p: &Vec2| s.distance(p);
            |s: &$shape, p: &Vec2| s.contains(p);
            |s: &$shape, o: Vec2, d: Vec2, inside: Inside| s.cast_ray(o, d, inside);
        })+
    };
}

macro_rules! pairs {
    ($($a:ty: $($b:ty),+;)+) => {
        $($(keep! {
            |a: &$a, b: &$b| a.overlaps(b);
            |a: &$a, b: &$b, last: &mut Separation| a.overlaps_from(b, last);
            |a: &$a, b: &$b| a.touches(b);
            |a: &$a, b: &$b| a.contact(b);
            |a: &$a, b: &$b| a.manifold(b);
            |a: &$a, b: &$b| a.contains(b);
            |a: &$a, b: &$b| a.distance(b);
            |a: &$a, b: &$b| a.closest_points(b);
            |a: &$a, b: &$b, motion: Vec2, inside: Inside| a.cast_shape(b, motion, inside);
            |a: &$a, b: &$b, motion: Vec2, inside: Inside| a.exact_toi(b, motion, inside);
        })+)+
    };
}

macro_rules! bodies {
    ($($level:ty: $($body:ty),+;)+) => {
        $($(keep! {
            |l: &$level, b: &$body| l.overlaps(b);
            |l: &$level, b: &$body| l.touches(b);
            |l: &$level, b: &$body, d: Vec2, rules: RayRules| l.cast_shape(b, d, rules);
            |l: &$level, b: &$body, d: Vec2| Mover::platformer(Axis::NEG_Y).move_and_slide(l, b, d);
            |l: &$level, b: &$body, way: OneWay, out: &mut VecView<WorldContact>| l.contacts(b, way, out);
            |l: &$level, b: &$body| escape(l, b);
            |l: &$level, b: &$body, turned: &$body| turn(l, b, turned);
        })+)+
    };
}

fn main_part() {
    shapes!(Capsule, OrientedBox, Quad, Any);
    keep! {
        |a: Vec2, b: Vec2, r: Fx| Capsule::new(a, b, r);
        |c: Vec2, half: Vec2, direction: Axis| OrientedBox::new(c, half, direction);
        |b: OrientedBox, r: Fx| b.with_radius(r);
        |points: &[Vec2]| Quad::new(points);
        |points: &[Vec2]| Quad::hull(points);
        |p: Quad, r: Fx| p.with_radius(r);
        |points: &[Vec2]| ConvexParts::<4, 4>::of(points);
        |parts: &[Any]| Group::new(parts);
        |g: &Group, by: Vec2| g.translated(by);
        |g: &Group, o: Vec2, d: Vec2, inside: Inside| g.cast_ray(o, d, inside);
        |g: &Group, b: &Aabb| g.overlaps(b);
        |g: &Group, b: &Circle| g.contact(b);
        |g: &Group, b: &Segment| g.manifold(b);
        |g: &Group, b: &Group| g.distance(b);
        |g: &Group, b: &Quad| g.closest_points(b);
        |g: &Group, b: &Any, motion: Vec2, inside: Inside| g.cast_shape(b, motion, inside);
        |a: &Any, g: &Group, motion: Vec2, inside: Inside| a.cast_shape(g, motion, inside);
        |l: &TileMap<'static, AllShapes>, g: &Group, d: Vec2| Mover::new().move_and_slide(l, g, d);
    }
}

fn pair_part() {
    pairs! {
        Capsule: Aabb, Circle, Segment, Capsule, OrientedBox, Quad;
        OrientedBox: Aabb, OrientedBox, Quad;
        Quad: Aabb, Circle, Quad;
        Any: Any;
        Aabb: Quad, OrientedBox;
    }
}

fn solid_part() {
    keep! {
        |shape: Any, key: u16, flags: u8, by: Vec2| ConvexSolid::new(shape, key).map(|s| s.with_flags(flags).with_motion(by));
        |solid: ConvexSolid<Quad>, next: Quad| solid.with_turn(next);
        |solid: &mut ConvexSolid<Any>, by: Vec2, next: Any| (solid.set_motion(by), solid.set_turn(next));
        |shape: Any, key: u16| shape.convex_solid(key);
        |shape: Quad, key: u16| shape.convex_solid(key);
        |list: &mut [ConvexSolid<Quad>]| ConvexSolid::move_all(list);
        |l: &ConvexSolids<'static, Any>, b: &Quad| (l.overlaps(b), l.touches(b));
        |l: &ConvexSolids<'static, Any>, b: &Aabb, c: &Circle| (l.flags_touched(b), l.flags_touched(c));
        |l: &Lifts, p: &Vec2| l.flags_touched(p);
        |l: &ConvexSolids<'static, Any>, b: &Circle, d: Vec2| Mover::new().move_and_slide(l, b, d);
        |l: &ConvexSolids<'static, Any>, b: &Group, way: OneWay, out: &mut VecView<WorldContact>| l.contacts(b, way, out);
        |l: &ConvexSolids<'static, Any>, o: Vec2, d: Vec2, rules: RayRules| l.cast_ray(o, d, rules);
        |l: &ConvexSolids<'static, Quad>, o: Vec2, d: Vec2, rules: RayRules| l.cast_ray_all(o, d, rules).map(Iterator::count);
        |l: &ConvexSolids<'static, Any>, a: Vec2, b: Vec2| l.line_of_sight(a, b);
        |l: &ConvexSolids<'static, Any>, p: Vec2, f: Fx, way: OneWay| l.closest_point(p, f, way);
        |l: &Lifts, o: Vec2, d: Vec2, rules: RayRules| l.cast_ray(o, d, rules);
        |hero: &mut Character<Circle>, l: &TileMap<'static, AllShapes>, list: &mut [ConvexSolid<Any>], input: Input| hero.step_on(l, list, input);
        |l: &TileMap<'static, AllShapes>, b: &Group, turned: &Group| turn(l, b, turned);
        |l: &TileMap<'static, AllShapes>, list: &[ConvexSolid<Any>], b: &Aabb, f: Fx| Mover::new().ride_convex(l, list, b, f);
        |l: &TileMap<'static>, list: &[ConvexSolid<Any>], b: &Circle, f: Fx| Mover::new().ride_convex(l, list, b, f);
        |l: &SegmentMap<'static>, list: &[ConvexSolid<Quad>], b: &Quad, f: Fx| Mover::new().ride_convex(l, list, b, f);
    }
}

fn body_part() {
    bodies! {
        TileMap<'static>: OrientedBox;
        TileMap<'static, AllShapes>: OrientedBox, Quad, Any;
        SegmentMap<'static>: Quad;
        Solids<'static>: OrientedBox;
    }
}

tilesat_flash::everything!(main_part, pair_part, solid_part, body_part);
