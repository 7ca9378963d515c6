//! The four broad phases: which bodies are near each other, in a region, on the way, nearest.

use tilesat::broad::{
    BroadHit, BroadPhase, BruteForce, Handle, Keyed, LooseGrid, Nearest, Pair, SortSweep, SpatialHash,
};
use tilesat::heapless::Vec;
use tilesat::{Aabb, Filter, Fx, LayerMask, Toi, Vec2};

use super::VECTORS;
use super::family::Run;
use super::hash::{Encode, Hash};
use super::random::{Class, Draw, Random, UNIT, any_motion};

const BODIES: usize = 20;
const QUERIES: [&str; 9] =
    ["pairs", "pairs_of", "region", "at_point", "nearest", "neighbours", "along", "body_ray", "body_cast"];

type Kind = Keyed<Filter>;

/// Half of it covers the cells of a grid.
fn shape(r: &mut Random, class: Class) -> Aabb {
    let (x, y) = match class {
        Class::Lattice | Class::Touch => (r.small(16) * 16 * UNIT, r.small(8) * 16 * UNIT),
        Class::Near => (r.small(16) * 16 * UNIT + r.small(2), r.small(8) * 16 * UNIT + r.small(2)),
        Class::Domain => (r.signed(29), r.signed(29)),
        Class::Uniform | Class::Far => (r.signed(24), r.signed(23)),
    };
    let size = match class {
        Class::Domain => (r.signed(26), r.signed(26)),
        Class::Lattice | Class::Touch | Class::Near => (r.below(3) as i32 * 16 * UNIT, r.below(3) as i32 * 16 * UNIT),
        Class::Uniform | Class::Far => (r.signed(20), r.signed(20)),
    };
    Aabb::spread(super::random::point(x, y), size)
}

fn tag(r: &mut Random, key: u32) -> Kind {
    let layers = LayerMask(r.word() as u16 | 1);
    Keyed {
        key,
        tag: Filter::new(layers, LayerMask(r.word() as u16 | 1)).with_still(r.once_in(4)).with_group(r.small(1) as i16),
    }
}

/// Keys are unique, so ordered answers are the same from all four.
fn fill<B: BroadPhase<Tag = Kind>>(near: &mut B, r: &mut Random, sum: &mut Hash) {
    for key in 0..BODIES as u32 {
        let class = Class::of(key);
        let body = shape(r, class);
        sum.add(near.insert(&body, tag(r, key.wrapping_mul(7) % 32)));
    }
}

/// A frame: most bodies move a little. One leaves and returns at another position.
fn advance<B: BroadPhase<Tag = Kind>>(near: &mut B, number: u32, r: &mut Random, sum: &mut Hash) {
    // By handle: bodies come in no particular order.
    let seed = r.word();
    let moved = near.move_each(|handle, bounds| {
        let mut r = Random::new(seed ^ (handle.slot() as u32 * 0x2545));
        let by = Vec2::from_raw(r.signed(19), r.signed(19));
        bounds.translated(by).unwrap_or(*bounds)
    });
    sum.add(moved.map_err(|(handle, _)| handle));
    let found = near.bodies().nth(r.below(BODIES as u32) as usize);
    if let Some((handle, _, tag)) = found {
        sum.add(near.remove(handle).is_ok());
        sum.add(near.insert(&shape(r, Class::of(number)), tag));
    }
}

fn list<T: Copy + Encode>(found: &[T], hash: &mut Hash) {
    found.len().encode(hash);
    for &one in found {
        hash.add(one);
    }
}

fn ask<B: BroadPhase<Tag = Kind>>(near: &mut B, number: u32, r: &mut Random, hashes: &mut [Hash; 9]) {
    let [pairs, of, region, point, nearest, neighbours, along, ray, cast] = hashes;
    let class = Class::of(number);
    let mut found = Vec::<Pair, 20>::new();
    let whole = near.pairs_sorted(&mut found);
    list(&found, pairs);
    pairs.add(whole);
    let bodies = shape(r, class);
    let mut here = Vec::<Handle, 12>::new();
    let whole = near.collect_region(&bodies, &mut here);
    list(&here, region);
    region.add(whole);
    // In no order, so as a sum.
    let (mut sum, mut count) = (0u32, 0u32);
    let told = near.pairs_of(here.get(..4).unwrap_or(&here), |pair| {
        let mut one = Hash::new();
        one.add(pair);
        (sum, count) = (sum.wrapping_add(one.value()), count + 1);
    });
    of.add([sum, count]);
    of.add(told);
    let p = bodies.min();
    (sum, count) = (0, 0);
    near.at_point(p, |handle| (sum, count) = (sum.wrapping_add(handle.slot() as u32 * 977), count + 1));
    point.add([sum, count]);
    let within = Fx::from_bits(r.signed(26).abs());
    nearest.add(near.nearest(p, Fx::MAX, |handle, _| handle.slot() & 1 == 0));
    let mut around = Vec::<Nearest, 6>::new();
    let whole = near.neighbours(p, within, |_, tag| tag.key & 3 != 0, &mut around);
    list(&around, neighbours);
    neighbours.add(whole);
    let motion = any_motion(r, class, p, Vec2::ZERO);
    let mut hits = Vec::<BroadHit, 6>::new();
    let whole = near.cast_ray(p, motion, |_, _| true, &mut hits);
    list(&hits, ray);
    ray.add(whole);
    let small = Aabb::spread(p, (r.signed(20), r.signed(20)));
    let whole = near.cast_shape(&small, motion, |_, tag| tag.key & 4 == 0, &mut hits);
    list(&hits, cast);
    cast.add(whole);
    (sum, count) = (0, 0);
    let told = near.along(&small, motion, |handle, _, toi| {
        (sum, count) = (sum.wrapping_add((handle.slot() as u32 + 1).wrapping_mul(toi.raw())), count + 1);
        Toi::ONE
    });
    along.add([sum, count]);
    along.add(told);
}

fn phase<B: BroadPhase<Tag = Kind>>(run: &mut Run<'_>, of: &'static str, empty: Option<B>) {
    let Some(mut near) = empty else { return };
    let mut other = Random::new(3);
    let mut filled = false;
    run.family(of, VECTORS / 4, QUERIES, |number, _, hashes| {
        // All four get the same bodies and the same queries, so their lines differ only in the
        // name.
        let r = &mut other;
        if !filled {
            fill(&mut near, r, &mut hashes[0]);
            filled = true;
        }
        if number % 8 == 7 {
            advance(&mut near, number, r, &mut hashes[0]);
        }
        ask(&mut near, number, r, hashes);
    });
}

pub(crate) fn run(run: &mut Run<'_>) {
    // 16 x 8 cells of 32 units: half of the bodies are outside at times, some are larger than a
    // cell.
    let corner = Vec2::from_ints(-256, -128);
    phase(run, "brute_force", Some(BruteForce::<BODIES, Kind>::new()));
    phase(run, "sort_sweep", Some(SortSweep::<BODIES, Kind>::new()));
    phase(run, "loose_grid", LooseGrid::<4, BODIES, Kind, true>::new(corner, Fx::const_from_int(32), 16).ok());
    phase(run, "spatial_hash", SpatialHash::<64, BODIES, Kind, true>::new(Fx::const_from_int(32)).ok());
}
