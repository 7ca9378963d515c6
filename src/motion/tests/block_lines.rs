//! Boxes among blocks: the search from line to line against a sweep of all faces near.

use super::std::vec::Vec;
use crate::motion::body::{Body, kernel::Kernel};
use crate::motion::order::First;
use crate::motion::search::{Around, Search};
use crate::num::{Fx, Raw, Vec2};
use crate::shape::Aabb;
use crate::world::{Blocks, Feature, Grid, Outside, TileKind, TileKinds, TileMap, TileShape, World};
use tilesat_judge::Random;

const SIDE: i32 = 4;
/// No power of two. Places are multiples of half of it, or a raw unit beside them.
const CELL: i32 = 1002;

/// Half full, with one-way tiles of all sides. Each tile has its own flag among its neighbours.
fn kinds() -> TileKinds {
    let one_way = [TileShape::OneWayUp, TileShape::OneWayRight, TileShape::OneWayDown, TileShape::OneWayLeft];
    (0..64).fold(TileKinds::EMPTY, |kinds, id: u8| {
        let kind = match id % 8 {
            0..4 => TileKind::FULL,
            side => TileKind::of(one_way[usize::from(side - 4)]),
        };
        kinds.with(id + 1, kind.with_flags(1 << (id / 8)))
    })
}

/// Where each kind of case must have been seen.
#[derive(Default, Debug)]
struct Seen {
    hits: u32,
    ends: u32,
    one_way: u32,
    thin: u32,
    inside: u32,
    joined: u32,
}

fn agree(map: &TileMap<'_, Blocks>, body: &Aabb, d: Raw, pass_one_way: bool, seen: &mut Seen) {
    let mut wanted = First::none();
    let (lo, hi) = (body.lo(), body.hi());
    let near = Aabb::from_raw_unchecked(
        Raw { x: lo.x + d.x.min(0) - 1, y: lo.y + d.y.min(0) - 1 },
        Raw { x: hi.x + d.x.max(0) + 1, y: hi.y + d.y.max(0) + 1 },
    );
    for feature in World::features_near(map, &near, true).filter(|f| !(f.one_way && pass_one_way)) {
        if let Some(entry) = body.sweep_block(d, &feature) {
            wanted.add::<Aabb, TileMap<'_, Blocks>>(&entry, &feature, d);
        }
    }
    let (mut around, mut found) = (Around::nothing(), First::none());
    let mut search = Search::new(body, &mut around);
    search.pass_one_way = pass_one_way;
    search.find_by_lines(map, d, &mut found);
    let facts = |first: &First| {
        let (entry, feature) = first.hit::<Aabb, TileMap<'_, Blocks>>(body, d)?;
        let Feature { cell, index, flags, one_way, .. } = *feature;
        Some((entry.displacement(d), entry.normal, entry.at_end, cell, index, flags, one_way))
    };
    let (found, wanted) = (facts(&found), facts(&wanted));
    assert_eq!(found, wanted, "{body:?} by {d:?} {:?} {pass_one_way}", map.outside());
    let Some((.., at_end, _, _, flags, one_way)) = found else { return };
    seen.hits += 1;
    seen.ends += u32::from(at_end);
    seen.one_way += u32::from(one_way);
    seen.thin += u32::from(lo.x == hi.x || lo.y == hi.y);
    seen.inside += u32::from(body.overlaps_world(map));
    seen.joined += u32::from(flags.count_ones() > 1);
    assert_eq!(body.position(), body.min());
}

/// A multiple of half a cell, mostly.
fn place(random: &mut Random, from: i32, to: i32) -> i32 {
    let at = (from + random.below(i64::from(to - from + 1)) as i32) * (CELL / 2);
    if random.below(8) == 0 { at + random.below(3) as i32 - 1 } else { at }
}

#[test]
fn lines_find_what_a_sweep_of_all_faces_finds() {
    let (kinds, mut random, mut seen) = (kinds(), Random::new(23), Seen::default());
    for turn in 0..150 {
        let full = 1 + random.below(3);
        let tiles: Vec<u8> =
            (0..SIDE * SIDE).map(|_| if random.below(4) < full { 0 } else { 1 + random.below(64) as u8 }).collect();
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL), Vec2::ZERO).expect("a grid");
        let outside = [Outside::Empty, Outside::Solid, Outside::Edge][turn % 3];
        let map: TileMap<'_, Blocks> = TileMap::of(&tiles, grid, &kinds).expect("a level").with_outside(outside);
        for _ in 0..4000 {
            let r = &mut random;
            let lo = Raw { x: place(r, -3, 2 * SIDE + 3), y: place(r, -3, 2 * SIDE + 3) };
            let size = Raw { x: place(r, 0, 4).max(0), y: place(r, 0, 4).max(0) };
            let d = Raw { x: place(r, -7, 7), y: place(r, -7, 7) };
            let body = Aabb::from_raw_unchecked(lo, lo.add(size));
            if !d.is_zero() {
                agree(&map, &body, d, r.below(4) == 0, &mut seen);
            }
        }
    }
    let Seen { hits, ends, one_way, thin, inside, joined } = seen;
    assert!([hits, ends, one_way, thin, inside, joined].into_iter().all(|n| n > 2000), "{seen:?}");
}
