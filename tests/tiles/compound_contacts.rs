//! Compounds in levels: overlaps, contacts, `escape` and `turn` by the union of their parts.

use tilesat::motion::{escape, turn};
use tilesat::prelude::*;
use tilesat::shape::{AnyShape, Compound, Single};
use tilesat::world::{Cell, OneWay, Placed, Pushable, WorldContact};
use tilesat::{
    Aabb, AllShapes, Axis, Body, Capsule, Circle, ConvexPolygon, Fx, Grid, Joined, OrientedBox, Outside, Path,
    PathKind, Solid, Solids, TileMap, Vec2,
};
use tilesat_judge::solids::twins::KINDS;
use tilesat_judge::{Random, cases};

pub(super) const SIDE: i64 = 6;
const CELL: i64 = 16 << 16;
const MOST: usize = 5;
pub(super) type Any = AnyShape<MOST>;

pub(super) fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(i32::try_from(x).unwrap(), i32::try_from(y).unwrap())
}

pub(super) fn coordinate(random: &mut Random) -> i64 {
    random.within(0, 4 * SIDE) * CELL / 4 + random.around(3)
}

pub(super) fn boxed(random: &mut Random, c: (i64, i64), size: i64) -> Aabb {
    let (w, h) = (1 + random.magnitude(size), 1 + random.magnitude(size));
    let at = (c.0 + random.around(size), c.1 + random.around(size));
    Aabb::new(raw(at.0, at.1), raw(at.0 + w, at.1 + h)).unwrap()
}

pub(super) fn ball(random: &mut Random, c: (i64, i64), size: i64) -> Circle {
    let at = raw(c.0 + random.around(size), c.1 + random.around(size));
    Circle::new(at, Fx::from_bits(1 + random.magnitude(size) as i32)).unwrap()
}

pub(super) fn any(random: &mut Random, c: (i64, i64), size: i64) -> Any {
    let near = |random: &mut Random| raw(c.0 + random.around(size), c.1 + random.around(size));
    match random.below(5) {
        0 => boxed(random, c, size).into(),
        1 => ball(random, c, size).into(),
        2 => {
            let half = raw(1 + random.magnitude(size), 1 + random.magnitude(size));
            let direction = Axis::new(random.around(1 << 20) as i32 | 1, random.around(1 << 20) as i32);
            OrientedBox::new(near(random), half, direction).unwrap().into()
        }
        3 => {
            let radius = Fx::from_bits(1 + random.magnitude(size / 2) as i32);
            Capsule::new(near(random), near(random), radius).unwrap().into()
        }
        _ => {
            let points: Vec<_> = (0..4).map(|_| near(random)).collect();
            ConvexPolygon::hull(&points).map_or_else(|_| ball(random, c, size).into(), Any::from)
        }
    }
}

/// What of a contact depends on the shape, and on nothing else.
type Told = ((u8, Cell, u16), Fx, Axis, Vec2);

fn told(c: &WorldContact) -> Told {
    let f = c.feature();
    ((f.source, f.cell, f.index), c.depth(), c.axis(), c.push_out())
}

macro_rules! contacts {
    ($level:expr, $body:expr, $one_way:expr) => {{
        let mut out = tilesat::heapless::Vec::<_, 128>::new();
        $level.contacts($body, $one_way, &mut out).expect("128 are enough here");
        out.to_vec()
    }};
}

/// Compares a compound with its parts in one level. Counts contacts, and those of several parts.
macro_rules! judge {
    ($level:expr, $group:expr, $seen:expr) => {{
        let (level, group) = ($level, $group);
        let parts = group.parts();
        assert_eq!(level.overlaps(group), parts.iter().any(|p| level.overlaps(p)), "{group:?}");
        assert_eq!(level.touches(group), parts.iter().any(|p| level.touches(p)), "{group:?}");
        for one_way in [OneWay::Ignore, OneWay::Include] {
            let found = contacts!(level, group, one_way);
            let each: Vec<Told> = parts.iter().flat_map(|p| contacts!(level, p, one_way)).map(|c| told(&c)).collect();
            let mut features: Vec<_> = each.iter().map(|t| t.0).collect();
            features.sort_by_key(|(s, c, i)| (*s, c.x, c.y, *i));
            features.dedup();
            assert_eq!(found.len(), features.len(), "{group:?}");
            for contact in &found {
                let contact = told(contact);
                let same: Vec<_> = each.iter().filter(|t| t.0 == contact.0).collect();
                let deepest = same.iter().map(|t| t.1).max();
                assert_eq!(Some(contact.1), deepest, "{group:?}");
                assert!(same.iter().any(|t| **t == contact), "{group:?}");
                $seen[1] += u64::from(same.len() > 1);
            }
            assert!(found.is_sorted_by_key(WorldContact::depth), "{group:?}");
            $seen[0] += found.len() as u64;
            // A list that is too short keeps the nearest.
            let mut short = tilesat::heapless::Vec::<_, 2>::new();
            let fits = level.contacts(group, one_way, &mut short).is_ok();
            assert_eq!(fits, found.len() <= 2, "{group:?}");
            assert_eq!(short[..], found[..found.len().min(2)], "{group:?}");
            // In another order of the parts.
            let turned: Vec<_> = parts.iter().rev().copied().collect();
            let turned = Compound::<_, 3>::new(&turned).unwrap();
            let all = |list: &[WorldContact]| list.iter().map(|c| (told(c), c.point())).collect::<Vec<_>>();
            assert_eq!(all(&contacts!(level, &turned, one_way)), all(&found), "{group:?}");
        }
    }};
}

fn out_of<S>(map: &TileMap<'_, AllShapes>, group: &Compound<S, 3>, seen: &mut [u64; 5])
where
    S: Single,
    Compound<S, 3>: Body + Pushable + core::fmt::Debug,
    for<'a> TileMap<'a, AllShapes>: Overlaps<S> + Overlaps<Compound<S, 3>>,
{
    let is_free = |g: &Compound<S, 3>| g.parts().iter().all(|p| !map.overlaps(p));
    match escape(map, group) {
        Ok(free) => {
            assert!(is_free(&free), "{group:?}");
            seen[2] += u64::from(map.overlaps(group));
        }
        Err(_) => assert!(!is_free(group), "{group:?}"),
    }
    // As a turn, to the place from one beside it.
    let from = group.translated(raw(CELL / 8, -CELL / 3)).unwrap();
    match turn(map, &from, group) {
        Ok(turned) => {
            assert!(is_free(&turned) && is_free(&from), "{group:?}");
            seen[3] += u64::from(turned.aabb() != group.aabb());
        }
        Err(_) => seen[4] += 1,
    }
}

fn play<S>(mut part: impl FnMut(&mut Random, (i64, i64), i64) -> S, seed: u64)
where
    S: Single + PartialEq + core::fmt::Debug,
    Compound<S, 3>: Body + Pushable,
    S: Pushable,
    for<'a> TileMap<'a, AllShapes>: Overlaps<S> + Overlaps<Compound<S, 3>> + Touches<S> + Touches<Compound<S, 3>>,
    for<'a> tilesat::SegmentMap<'a>: Overlaps<S> + Overlaps<Compound<S, 3>> + Touches<S> + Touches<Compound<S, 3>>,
    for<'a> Solids<'a>: Overlaps<S> + Overlaps<Compound<S, 3>> + Touches<S> + Touches<Compound<S, 3>>,
    for<'a, 'b> Joined<'a, TileMap<'b, AllShapes>, Solids<'b>>:
        Overlaps<S> + Overlaps<Compound<S, 3>> + Touches<S> + Touches<Compound<S, 3>>,
    for<'a, 'b> Placed<'a, TileMap<'b, AllShapes>>:
        Overlaps<S> + Overlaps<Compound<S, 3>> + Touches<S> + Touches<Compound<S, 3>>,
{
    tilesat::segment_map!(static WEDGES: [
        Path::new(PathKind::Solid, &WEDGE),
        Path::new(PathKind::Solid, &STAR)
    ], tilesat::fx!(32));
    let (mut random, mut seen) = (Random::new(seed), [0u64; 5]);
    for _ in 0..cases(600) {
        let mut tiles = [0u8; (SIDE * SIDE) as usize];
        tiles.fill_with(|| if random.one_in(3) { random.below(38) as u8 } else { 0 });
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
        let map = TileMap::<AllShapes>::of(&tiles, grid, &KINDS).unwrap().with_outside(Outside::Empty);
        let list: Vec<_> = (0..3)
            .map(|key| {
                let c = (coordinate(&mut random), coordinate(&mut random));
                Solid::new(boxed(&mut random, c, CELL), key).unwrap()
            })
            .collect();
        let solids = Solids::new(&list);
        for _ in 0..10 {
            let c = (coordinate(&mut random), coordinate(&mut random));
            let size = 1 + random.magnitude(CELL);
            let count = random.within(1, 3);
            let parts: Vec<S> = (0..count).map(|_| part(&mut random, c, size)).collect();
            let group = Compound::<S, 3>::new(&parts).unwrap();
            judge!(&map, &group, seen);
            judge!(&WEDGES, &group, seen);
            judge!(&solids, &group, seen);
            judge!(&Joined::new(&map, &solids), &group, seen);
            judge!(&Placed::new(&map, raw(CELL / 3, 777)).unwrap(), &group, seen);
            out_of(&map, &group, &mut seen);
        }
    }
    println!("{seen:?}: contacts, of several parts, escapes, turns that pushed, refused");
    assert!(seen.iter().all(|&n| n > 30), "{seen:?}");
}

const WEDGE: [Vec2; 3] = [Vec2::from_ints(4, 60), Vec2::from_ints(70, 20), Vec2::from_ints(80, 66)];
const STAR: [Vec2; 4] =
    [Vec2::from_ints(20, 4), Vec2::from_ints(50, 12), Vec2::from_ints(34, 14), Vec2::from_ints(30, 40)];

#[test]
fn boxes() {
    play(boxed, 701);
}

#[test]
fn circles() {
    play(ball, 702);
}

#[test]
fn shapes_of_any_kind() {
    play(any, 703);
}

const THIN: [Vec2; 2] = [Vec2::from_ints(50, -20), Vec2::from_ints(50, 40)];

/// No part gets behind a thin wall in a turn, not only the first one.
#[test]
fn turns_of_parts_stay_on_their_side() {
    tilesat::segment_map!(static WALL: [Path::new(PathKind::Wall, &THIN)], tilesat::fx!(32));
    let boxed = |x: i16, w: i16| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + w, 8)).unwrap();
    let group = |x: i16, w: i16| Compound::<Aabb, 2>::new(&[boxed(0, 4), boxed(x, w)]).unwrap();
    let from = group(40, 6);
    // Pushed back to the left by 1, and out to the right by 1: that would be through the wall.
    assert_eq!(turn(&WALL, &from, &group(42, 9)).unwrap().aabb().max(), Vec2::from_ints(50, 8));
    assert_eq!(escape(&WALL, &group(49, 8)).unwrap().aabb().max(), Vec2::from_ints(58, 8));
    assert!(turn(&WALL, &from, &group(49, 8)).is_err());
}
