//! All motion through levels, and all responses.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::heapless::VecView;
use tilesat::motion::response::{
    Link, Particle, Quiet, Stick, bounce, exchange, relax, respond, separate, slide, split,
};
use tilesat::motion::{Hit, Hits, Walked, escape};
use tilesat::world::{AllShapes, Bits, Blocks, Joined, Placed, SegmentMap, Slopes, Solid, Solids, TileMap};
use tilesat::{
    Aabb, Axis, Capsule, Character, Circle, Contact, Feel, Fx, Input, Moved, Mover, Ratio, Response, SlopeSpeed,
    Surface, Vec2, Walker,
    motion::{Acceleration, Carry, Energy, Masses, Speed, StartInside, Support},
};
use tilesat_flash::keep;

type Both<'a> = Joined<'a, TileMap<'a, AllShapes>, SegmentMap<'a>>;
type Doors<'a> = Joined<'a, Both<'a>, Solids<'a>>;

macro_rules! moves {
    ($($level:ty),+; $body:ty) => {
        $(keep! {
            |m: &Mover, l: &$level, b: &$body, v: Vec2| m.move_and_slide(l, b, v);
            |m: &Mover<Surface>, l: &$level, b: &$body, v: Vec2| m.move_and_slide(l, b, v);
            |m: &Mover, l: &$level, solids: &[Solid], b: &$body, follow: Fx| m.ride(l, solids, b, follow);
            |m: &Mover<Surface>, l: &$level, solids: &[Solid], b: &$body, follow: Fx| m.ride(l, solids, b, follow);
            |m: &Mover, l: &$level, b: &$body| m.supported(l, b);
            |w: &Walker, l: &$level, b: &$body, v: Vec2, floor: Option<Support>| w.walk(l, b, v, floor);
            |c: &mut Character<$body>, l: &$level, i: Input| c.step(l, i);
            |c: &mut Character<$body>, l: &$level, solids: &mut [Solid], i: Input| c.step_on(l, solids, i);
        })+
    };
}

macro_rules! escapes {
    ($($level:ty),+; $body:ty) => {
        $(keep! {
            |l: &$level, b: &$body| escape(l, b);
        })+
    };
}

macro_rules! particles {
    ($($level:ty),+) => {
        $(keep! {
            |p: Particle, l: &$level, m: &Mover, r: Fx, a: Vec2, drag: Ratio| p.step_in(l, m, r, a, drag);
            |p: Particle, l: &$level, m: &Mover<Surface>, r: Fx, a: Vec2, drag: Ratio| p.step_in(l, m, r, a, drag);
            |p: Particle, l: &$level, m: &Mover, r: Fx, by: Vec2| p.pushed_in(l, m, r, by);
            |p: &mut [Particle], links: &[Link], n: u32, l: &$level, m: &Mover, r: Fx| relax(p, links, n, l, m, r);
        })+
    };
}

fn boxes() {
    moves!(
        TileMap<'_>, TileMap<'_, Blocks, Bits>, TileMap<'_, Slopes>, TileMap<'_, AllShapes>, SegmentMap<'_>, Solids<'_>,
        Both<'_>, Doors<'_>, Placed<'_, TileMap<'_>>; Aabb
    );
    escapes!(
        TileMap<'_>, TileMap<'_, Blocks, Bits>, TileMap<'_, Slopes>, TileMap<'_, AllShapes>, SegmentMap<'_>, Solids<'_>,
        Both<'_>, Doors<'_>, Placed<'_, TileMap<'_>>; Aabb
    );
}

fn circles() {
    moves!(
        TileMap<'_>, TileMap<'_, Blocks, Bits>, TileMap<'_, Slopes>, TileMap<'_, AllShapes>, SegmentMap<'_>, Solids<'_>,
        Both<'_>, Doors<'_>, Placed<'_, TileMap<'_>>; Circle
    );
    escapes!(
        TileMap<'_>, TileMap<'_, Blocks, Bits>, TileMap<'_, Slopes>, TileMap<'_, AllShapes>, SegmentMap<'_>, Solids<'_>,
        Both<'_>, Doors<'_>, Placed<'_, TileMap<'_>>; Circle
    );
}

fn capsules() {
    moves!(
        TileMap<'_>, TileMap<'_, Blocks, Bits>, TileMap<'_, Slopes>, TileMap<'_, AllShapes>, SegmentMap<'_>, Solids<'_>,
        Both<'_>, Doors<'_>, Placed<'_, TileMap<'_>>; Capsule
    );
}

fn movers() {
    keep! {
        |_any: u8| Mover::new();
        |up: Axis| Mover::platformer(up);
        |m: Mover, surface: Surface| m.with_surface(surface);
        |m: Mover, response: Response| m.with_response(response);
        |m: Mover, rise: u16, run: u16| m.with_slope_limit(rise, run);
        |m: Mover, on: bool| m.with_drop_through(on);
        |m: Mover, inside: StartInside| m.with_inside(inside);
        |m: Mover| Walker::new(m);
        |w: Walker, length: Fx| w.with_snap(length);
        |w: Walker, height: Fx| w.with_step(height);
        |w: Walker, speed: SlopeSpeed, on: bool| w.with_slope_speed(speed).with_drop_through(on);
        |w: &Walked<Aabb>| w.on_floor();
        |b: Aabb, limits: Aabb, feel: Feel| Character::new(b, limits, feel);
        |c: &mut Character, b: Aabb| c.place(b);
        |c: &Character| (c.body(), c.position(), c.limits(), c.floor(), c.on_floor(), c.ridden(), c.wall());
        |c: &Character, run: Fx| c.stopping_distance(run);
        |feel: &Feel| feel.check();
        |hit: Hit| Support::from(hit);
        |hit: &Hit, floor: &Support| (hit.solid(), floor.solid());
        |m: &Moved<Aabb>| m.position();
        |m: &Moved<Circle>| m.position();
        |hits: &Hits| (hits.len(), hits.is_empty(), hits.first());
        |hits: &Hits| hits.iter().fold(0_u32, |sum, hit| sum ^ core::hint::black_box(hit).toi.raw());
        |hits: &Hits| hits.into_iter().fold(0_u32, |sum, hit| sum ^ core::hint::black_box(hit).toi.raw());
        |hits: &Hits, out: &mut VecView<Hit>| hits.copy_to(out);
    }
}

fn responses() {
    keep! {
        |by: Vec2, frames: u32| Acceleration::new(by, frames);
        |a: &Acceleration, v: Vec2, carry: Carry| a.act(v, carry);
        |a: &Acceleration, v: Vec2, carry: Carry| a.supported(v, carry);
        |p: Vec2, v: Vec2, g: Vec2| Energy::of(p, v, g);
        |e: Energy| e.raw();
        |e: Energy, p: Vec2, v: Vec2, g: Vec2| e.speed(p, v, g);
        |a: u8, b: u8| Masses::new(a, b);
        |m: Masses| m.swapped();
        |m: Masses| m.share_of_a();
        |c: &Contact, share: Ratio| separate(c, share);
        |a: Vec2, b: Vec2, n: Axis, m: Masses, s: &Surface| exchange(a, b, n, m, s);
        |v: Vec2| Speed::of(v);
        |s: Speed| s.squared();
        |s: Speed, from: Vec2, to: Vec2| s.changed(from, to);
        |s: Speed, v: Vec2, n: Axis| s.bounce(v, n);
        |v: Vec2, n: Axis| split(v, n);
        |v: Vec2, n: Axis| slide(v, n);
        |v: Vec2, n: Axis, r: Ratio| bounce(v, n, r);
        |v: Vec2, n: Axis, r: Ratio, f: Ratio| respond(v, n, r, f);
        |length: Fx| Stick::new(length);
        |length: Fx| Stick::rope(length);
        |s: Stick, share: Ratio| s.with_share_of_a(share);
        |s: &Stick| s.length();
        |s: &Stick, a: Vec2, b: Vec2| s.pull(a, b);
        |r: Ratio, f: Ratio| Surface::new(r, f);
        |s: Surface, speed: Fx| s.resting_below(speed);
        |s: Surface, speed: Speed| s.with_speed(speed);
        |s: &Surface| (s.restitution(), s.friction());
        |s: &Surface, v: Vec2, n: Axis| s.respond(v, n);
        |p: Vec2| Particle::at(p);
        |p: Vec2, v: Vec2| Particle::moving(p, v);
        |p: &Particle| p.velocity();
        |p: Particle, a: Vec2, drag: Ratio| p.step(a, drag);
        |q: Quiet, points: &[Particle], still: Fx| q.watch(points, still);
        |q: Quiet, steps: u16| q.for_steps(steps);
    }
    particles!(TileMap<'_>, TileMap<'_, AllShapes>, SegmentMap<'_>, Both<'_>);
}

tilesat_flash::everything!(boxes, circles, capsules, movers, responses);
