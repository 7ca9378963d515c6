//! All queries on a level, for any kind of level.

use tilesat::heapless::Vec;
use tilesat::world::{
    Feature, Joined, Near, OneWay, Placed, RayHit, RayRules, SegmentMap, ShapeSet, Solids, Store, TileMap, World,
    WorldContact,
};
use tilesat::{Aabb, Circle, Fx, Inside, RangeError, Vec2, error::Truncated};

use super::encode::BodyFound;
use super::hash::{Encode, Hash};
use super::random::{Class, Draw, Random, UNIT, any_motion};

pub(crate) const VERBS: [&str; 7] =
    ["overlaps", "touches", "features", "cast_ray", "cast_ray_all", "line_of_sight", "cast_shape"];
/// For levels that are not a list of moving boxes.
pub(crate) const SURFACE: [&str; 2] = ["closest_point", "contacts"];
/// The counters of all of them.
pub(crate) const WORK: &str = "work";

/// Looks at this many hits of a ray.
const HITS: usize = 4;

type Cast<T> = Result<Option<T>, RangeError>;

/// The calls that all levels have, each as a separate method.
pub(crate) trait Asked: World {
    fn ray(&self, from: Vec2, motion: Vec2, rules: RayRules) -> Cast<RayHit>;
    fn rays(&self, from: Vec2, motion: Vec2, rules: RayRules, each: &mut dyn FnMut(RayHit)) -> Result<(), RangeError>;
    fn sees(&self, a: Vec2, b: Vec2) -> Result<bool, RangeError>;
    fn cast_box(&self, body: &Aabb, motion: Vec2, rules: RayRules) -> BodyFound<Aabb>;
    fn cast_circle(&self, body: &Circle, motion: Vec2, rules: RayRules) -> BodyFound<Circle>;
}

/// And those that most have.
pub(crate) trait Surfaced: Asked {
    fn near(&self, p: Vec2, within: Fx, one_way: OneWay) -> Cast<Near>;
    fn box_contacts(&self, b: &Aabb, one_way: OneWay, out: &mut Found) -> Result<u32, Truncated>;
    fn circle_contacts(&self, c: &Circle, one_way: OneWay, out: &mut Found) -> Result<u32, Truncated>;
}

pub(crate) type Found = Vec<WorldContact, 6>;

macro_rules! asked {
    ([$($of:tt)*] $level:ty) => {
        impl<$($of)*> Asked for $level {
            fn ray(&self, from: Vec2, motion: Vec2, rules: RayRules) -> Cast<RayHit> {
                self.cast_ray(from, motion, rules)
            }
            fn rays(&self, from: Vec2, motion: Vec2, rules: RayRules, each: &mut dyn FnMut(RayHit)) -> Result<(), RangeError> {
                self.cast_ray_all(from, motion, rules)?.take(HITS).for_each(each);
                Ok(())
            }
            fn sees(&self, a: Vec2, b: Vec2) -> Result<bool, RangeError> {
                self.line_of_sight(a, b)
            }
            fn cast_box(&self, body: &Aabb, motion: Vec2, rules: RayRules) -> BodyFound<Aabb> {
                self.cast_shape(body, motion, rules)
            }
            fn cast_circle(&self, body: &Circle, motion: Vec2, rules: RayRules) -> BodyFound<Circle> {
                self.cast_shape(body, motion, rules)
            }
        }
    };
}

macro_rules! surfaced {
    ([$($of:tt)*] $level:ty) => {
        asked!([$($of)*] $level);
        impl<$($of)*> Surfaced for $level {
            fn near(&self, p: Vec2, within: Fx, one_way: OneWay) -> Cast<Near> {
                self.closest_point(p, within, one_way)
            }
            fn box_contacts(&self, b: &Aabb, one_way: OneWay, out: &mut Found) -> Result<u32, Truncated> {
                self.contacts(b, one_way, out)
            }
            fn circle_contacts(&self, c: &Circle, one_way: OneWay, out: &mut Found) -> Result<u32, Truncated> {
                self.contacts(c, one_way, out)
            }
        }
    };
}

surfaced!([S: ShapeSet, T: Store] TileMap<'_, S, T>);
surfaced!([] SegmentMap<'_>);
surfaced!(['a, 'b, S: ShapeSet, T: Store] Joined<'a, TileMap<'b, S, T>, SegmentMap<'b>>);
surfaced!(['a, 'b, S: ShapeSet, T: Store] Joined<'a, TileMap<'b, S, T>, Solids<'b>>);
asked!(['a, 'b] Placed<'a, SegmentMap<'b>>);
asked!([] Solids<'_>);

/// One vector: a position, a body, a direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector {
    pub round: bool,
    pub ball: Circle,
    pub block: Aabb,
    pub motion: Vec2,
    pub rules: RayRules,
    pub one_way: OneWay,
    pub within: Fx,
}

/// Half a cell of all levels here.
const HALF: i32 = 8 * UNIT;

impl Vector {
    /// A vector of a class, in and around a level of `width` x `height` half cells from `at` on.
    pub(crate) fn draw(number: u32, r: &mut Random, at: Vec2, (width, height): (u32, u32)) -> Self {
        let class = Class::of(number);
        let (ox, oy) = at.raw();
        // A cell more on each side.
        let on_lattice = |r: &mut Random, origin: i32, cells: u32| origin + (r.below(cells + 4) as i32 - 2) * HALF;
        let (x, y) = (on_lattice(r, ox, width), on_lattice(r, oy, height));
        let (x, y) = match class {
            Class::Lattice | Class::Touch => (x, y),
            Class::Near => (x + r.small(2), y + r.small(2)),
            _ => (x + r.signed(19), y + r.signed(19)),
        };
        let p = Vec2::from_raw(x, y);
        let (size, other) = match class {
            Class::Lattice | Class::Touch => (r.below(4) as i32 * (HALF / 2), r.below(4) as i32 * (HALF / 2)),
            Class::Near => (r.below(4) as i32 * (HALF / 2) + r.small(2), r.below(4) as i32 * (HALF / 2) + r.small(2)),
            // Large ones are expensive: one in 64.
            Class::Domain if r.once_in(64) => (r.signed(24), r.signed(24)),
            Class::Domain => (r.signed(13), r.signed(13)),
            Class::Uniform | Class::Far => (r.signed(20), r.signed(20)),
        };
        let end = Vec2::from_raw(on_lattice(r, ox, width), on_lattice(r, oy, height));
        let aim = match class {
            // A slow one, and one through everything.
            Class::Lattice if r.once_in(2) => Vec2::from_raw(x + r.small(3) * HALF, y + r.small(3) * HALF),
            Class::Touch => Vec2::from_raw(x + r.small(9) * (HALF / 4), y + r.small(9) * (HALF / 4)),
            _ => end,
        };
        let inside = if number & 8 == 0 { Inside::Hit } else { Inside::Ignore };
        Self {
            round: number & 16 == 0,
            ball: Circle::spread(p, (size.abs(), 0)),
            block: Aabb::spread(p, (size, other)),
            motion: any_motion(r, class, p, aim),
            rules: RayRules { inside, one_way: number & 32 == 0 },
            one_way: if number & 64 == 0 { OneWay::Include } else { OneWay::Ignore },
            within: Fx::from_bits(if r.once_in(64) { 20 * HALF } else { r.signed(21).abs() }),
        }
    }

    fn from(&self) -> Vec2 {
        self.ball.centre()
    }
}

fn body<B: Encode>(found: BodyFound<B>, cast: &mut Hash, work: &mut Hash) {
    if let Ok(Some(hit)) = &found {
        work.add(hit.work);
    }
    cast.add(found);
}

/// Runs everything in [`VERBS`] on a level.
pub(crate) fn ask<W: Asked>(level: &W, v: &Vector, hashes: &mut [Hash; VERBS.len()], work: &mut Hash) {
    let [overlaps, touches, features, ray, all, sight, cast] = hashes;
    if v.round {
        overlaps.add(level.overlaps_circle(&v.ball));
        touches.add(level.touches_circle(&v.ball));
        body(level.cast_circle(&v.ball, v.motion, v.rules), cast, work);
    } else {
        overlaps.add(level.overlaps_aabb(&v.block));
        touches.add(level.touches_aabb(&v.block));
        body(level.cast_box(&v.block, v.motion, v.rules), cast, work);
    }
    // In their order, which games can see.
    let mut count = 0u32;
    World::features(level, &v.block).for_each(|feature: Feature| {
        count += 1;
        features.add(feature);
    });
    features.add(count);
    let hit = level.ray(v.from(), v.motion, v.rules);
    if let Ok(Some(hit)) = &hit {
        work.add(hit.cells);
    }
    ray.add(hit);
    let whole = level.rays(v.from(), v.motion, v.rules, &mut |hit| {
        work.add(hit.cells);
        all.add(hit);
    });
    all.add(whole);
    sight.add(level.sees(v.from(), v.from() + v.motion));
}

/// Runs everything in [`SURFACE`] on a level.
pub(crate) fn ask_surface<W: Surfaced>(level: &W, v: &Vector, hashes: &mut [Hash; SURFACE.len()], work: &mut Hash) {
    let [closest, contacts] = hashes;
    let near = level.near(v.from(), v.within, v.one_way);
    if let Ok(Some(near)) = &near {
        work.add(near.features);
    }
    closest.add(near);
    let mut found = Found::new();
    let looked = if v.round {
        level.circle_contacts(&v.ball, v.one_way, &mut found)
    } else {
        level.box_contacts(&v.block, v.one_way, &mut found)
    };
    for &contact in &found {
        contacts.add(contact);
    }
    contacts.add(looked.map(|features| work.add(features)));
}
