//! Which features capsules, oriented boxes and polygons overlap, and how they get out: contacts,
//! `escape` and `turn`.

use tilesat::motion::{escape, turn};
use tilesat::prelude::*;
use tilesat::shape::AnyShape;
use tilesat::world::{OneWay, Pushable, WorldContact};
use tilesat::{
    Aabb, AllShapes, Axis, Body, Capsule, ConvexPolygon, Fx, Grid, Mover, OrientedBox, Outside, TileKind, TileKinds,
    TileMap, TileShape, Vec2, world::Geometry,
};
use tilesat_judge::{Random, cases};

const SIDE: usize = 6;
const CELL: i64 = 16 << 16;

static KINDS: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0);
    while id < 38 {
        kinds = kinds.with(id as u8, TileKind::of(TileShape::ALL[id]));
        id += 1;
    }
    kinds
};

fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(i32::try_from(x).unwrap(), i32::try_from(y).unwrap())
}

fn level(tiles: &[u8]) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(Outside::Empty)
}

fn tiles(random: &mut Random) -> [u8; SIDE * SIDE] {
    let mut tiles = [0; SIDE * SIDE];
    tiles.fill_with(|| if random.one_in(3) { random.below(38) as u8 } else { 0 });
    tiles
}

fn contacts(map: &TileMap<'_, AllShapes>, body: &impl Pushable) -> Vec<WorldContact> {
    let mut out = tilesat::heapless::Vec::<_, 64>::new();
    map.contacts(body, OneWay::Ignore, &mut out).expect("64 are enough here");
    out.to_vec()
}

/// Oriented boxes along x and y overlap what plain ones do, as deep and the same way out, but in
/// the order of rounded depths.
#[test]
fn upright_boxes_are_boxes() {
    let mut random = Random::new(91);
    let (mut found, mut ties) = (0u64, 0u64);
    for _ in 0..cases(4_000) {
        let tiles = tiles(&mut random);
        let map = level(&tiles);
        for _ in 0..10 {
            let mut place = || random.within(0, 4 * SIDE as i64) * CELL / 4 + random.around(3);
            let c = (place(), place());
            let h = (1 + random.magnitude(CELL), 1 + random.magnitude(CELL));
            let turned = OrientedBox::new(raw(c.0, c.1), raw(h.0, h.1), Axis::X).unwrap();
            let plain = Aabb::new(raw(c.0 - h.0, c.1 - h.1), raw(c.0 + h.0, c.1 + h.1)).unwrap();
            // Of arcs, boxes know which of their ends are in sight.
            let told = |c: &WorldContact| {
                let f = c.feature();
                let arc = matches!(f.geometry, Geometry::Arc { .. });
                (!arc && !c.is_degenerate()).then_some((
                    f.cell.x,
                    f.cell.y,
                    f.index,
                    c.axis().unit(),
                    c.depth(),
                    c.push_out(),
                ))
            };
            let (a, b) = (contacts(&map, &turned), contacts(&map, &plain));
            let degenerate = |all: &[WorldContact]| all.iter().any(WorldContact::is_degenerate);
            if degenerate(&a) || degenerate(&b) {
                ties += 1;
                continue;
            }
            let sorted = |all: &[WorldContact]| {
                let mut told: Vec<_> = all.iter().filter_map(told).map(|t| format!("{t:?}")).collect();
                told.sort();
                told
            };
            // A spare one is there only where nothing is in its region, arcs among that.
            if a.iter().chain(&b).any(|c| matches!(c.feature().geometry, Geometry::Arc { .. })) {
                continue;
            }
            assert_eq!(sorted(&a), sorted(&b), "{tiles:?} {plain:?}");
            assert!(a.is_sorted_by_key(WorldContact::depth));
            found += a.len() as u64;
        }
    }
    println!("{found} contacts, {ties} ties");
    assert!(found > cases(4_000), "{found}");
}

const MOST: usize = 6;
type Any = AnyShape<MOST>;

fn figure(random: &mut Random, c: (i64, i64), size: i64) -> Option<Any> {
    let near = |random: &mut Random| raw(c.0 + random.around(size), c.1 + random.around(size));
    match random.below(3) {
        0 => {
            let half = raw(1 + random.magnitude(size), 1 + random.magnitude(size));
            let direction = Axis::new(random.around(1 << 20) as i32 | 1, random.around(1 << 20) as i32);
            OrientedBox::new(raw(c.0, c.1), half, direction).ok().map(Any::from)
        }
        1 => {
            let radius = Fx::from_bits(1 + random.magnitude(size / 2) as i32);
            Capsule::new(near(random), near(random), radius).ok().map(Any::from)
        }
        _ => {
            let points: Vec<Vec2> = (0..random.within(3, MOST as i64)).map(|_| near(random)).collect();
            let radius = if random.one_in(2) { 0 } else { random.magnitude(size / 2) };
            ConvexPolygon::<MOST>::hull(&points).ok()?.with_radius(Fx::from_bits(radius as i32)).ok().map(Any::from)
        }
    }
}

/// The solid of one full tile is the box of its cell: contacts are there exactly where they
/// overlap, and no shallower than the pair's least exit. What has a contact gets out.
#[test]
fn one_block_is_a_box() {
    let mut random = Random::new(92);
    let mut tiles = [0; SIDE * SIDE];
    tiles[2 * SIDE + 2] = 1;
    let map = level(&tiles);
    let block = Aabb::new(raw(2 * CELL, 2 * CELL), raw(3 * CELL, 3 * CELL)).unwrap();
    let (mut hits, mut freed) = (0u64, 0u64);
    for _ in 0..cases(20_000) {
        let size = 1 + random.magnitude(2 * CELL);
        let c = (2 * CELL + random.within(-8, 24) * CELL / 16, 2 * CELL + random.within(-8, 24) * CELL / 16);
        let Some(body) = figure(&mut random, c, size) else { continue };
        let found = contacts(&map, &body);
        let pair = body.contact(&block);
        assert!(pair.is_some() || found.is_empty(), "{body:?} {found:?}");
        let Some(pair) = pair else { continue };
        hits += 1;
        for contact in &found {
            assert!(contact.depth() >= Fx::from_bits(1));
            // No feature is left by less than the least exit of the whole block, less its rounding.
            assert!(contact.depth() + Fx::from_bits(1) >= pair.depth() || found.len() > 1, "{body:?} {contact:?}");
        }
        if let Ok(free) = escape(&map, &body) {
            assert!(!free.overlaps(&block), "{body:?}");
            freed += 1;
        } else {
            assert!(block.contains(&body) || body.contains(&block) || found.is_empty(), "held: {body:?} {found:?}");
        }
    }
    println!("{hits} overlap, {freed} freed");
    assert!(hits > cases(20_000) / 8 && freed > hits / 5, "{hits} {freed}");
}

/// What is pushed out is free, and no farther away than it was deep.
#[test]
fn bodies_escape_from_random_levels() {
    let mut random = Random::new(93);
    let (mut freed, mut stuck, mut deep) = (0u64, 0u64, 0u64);
    for _ in 0..cases(1_500) {
        let tiles = tiles(&mut random);
        let map = level(&tiles);
        for _ in 0..20 {
            let mut place = || random.within(0, 8 * SIDE as i64) * CELL / 8 + random.around(3);
            let c = (place(), place());
            let Some(body) = figure(&mut random, c, CELL / 4) else { continue };
            if !map.overlaps(&body) {
                assert!(contacts(&map, &body).is_empty(), "{body:?}");
                continue;
            }
            match escape(&map, &body) {
                Ok(free) => {
                    assert!(!map.overlaps(&free), "{body:?}");
                    freed += 1;
                }
                // Deep in the solid it reaches no surface.
                Err(_) if contacts(&map, &body).is_empty() => deep += 1,
                Err(_) => stuck += 1,
            }
        }
    }
    println!("{freed} freed, {stuck} stuck, {deep} deep");
    assert!(freed > 100 * stuck, "{freed} {stuck} {deep}");
}

/// Turned in a room of thin walls: free, on its side of every wall, or refused.
#[test]
fn turning_never_ends_inside() {
    let mut random = Random::new(94);
    let (mut same, mut pushed, mut refused) = (0u64, 0u64, 0u64);
    for _ in 0..cases(2_500) {
        let tiles = tiles(&mut random);
        let map = level(&tiles);
        for _ in 0..12 {
            let mut place = || random.within(CELL, (SIDE as i64 - 1) * CELL);
            let (c, half) = (raw(place(), place()), raw(1 + random.magnitude(CELL), 1 + random.magnitude(CELL / 4)));
            let mut plank = |_| {
                let direction = Axis::from_turns(Fx::from_bits(random.below(1 << 16) as i32));
                OrientedBox::new(c, half, direction).unwrap()
            };
            let (body, turned) = (plank(0), plank(1));
            let result = turn(&map, &body, &turned);
            if map.overlaps(&body) {
                assert!(result.is_err());
                continue;
            }
            match result {
                Ok(free) if free == turned => same += 1,
                Ok(free) => {
                    assert!(!map.overlaps(&free) && map.overlaps(&turned), "{body:?} {turned:?}");
                    assert_eq!((free.along(), free.across()), (turned.along(), turned.across()));
                    let sight = map.line_of_sight(body.position(), free.position()).unwrap();
                    assert!(
                        sight || map.touches(&Aabb::new(body.position(), body.position()).unwrap()),
                        "{body:?} {free:?}"
                    );
                    pushed += 1;
                }
                Err(_) => {
                    assert!(map.overlaps(&turned), "{body:?} {turned:?}");
                    refused += 1;
                }
            }
        }
    }
    println!("{same} as asked, {pushed} pushed, {refused} refused");
    assert!(same > 100 && pushed > 100 && refused > 5, "{same} {pushed} {refused}");
}

/// A box that lies in a nook turns by up to twelve degrees wherever a free place is within a sixth
/// of its size, but for one in fifty. With one push after another, each for itself, one in twelve
/// was refused.
#[test]
fn bodies_turn_in_nooks() {
    let mut random = Random::new(95);
    let (mut pushed, mut refused) = (0u64, 0u64);
    for _ in 0..cases(6_000) {
        let mut tiles = [0; SIDE * SIDE];
        tiles.fill_with(|| if random.one_in(4) { random.below(34) as u8 } else { 0 });
        let map = level(&tiles).with_outside(Outside::Solid);
        let half = raw(random.within(2 << 16, 12 << 16), random.within(2 << 16, 8 << 16));
        let c = raw(random.within(10 << 16, 86 << 16), random.within(10 << 16, 86 << 16));
        let turns = Fx::from_bits(random.below(1 << 16) as i32);
        let mut body = OrientedBox::new(c, half, Axis::from_turns(turns)).unwrap();
        if map.overlaps(&body) {
            continue;
        }
        let gravity = raw(random.around(4 << 16), random.around(4 << 16));
        for _ in 0..20 {
            let Ok(moved) = Mover::new().move_and_slide(&map, &body, gravity) else { break };
            body = moved.body;
        }
        let turns = turns + Fx::from_bits(random.around(2_200) as i32);
        let turned = OrientedBox::new(body.position(), half, Axis::from_turns(turns)).unwrap();
        if let Ok(free) = turn(&map, &body, &turned) {
            pushed += u64::from(free != turned);
            continue;
        }
        let step = half.x.max(half.y).to_bits() / 6 / 16;
        let mut ways = (0..33 * 33).map(|k| (k % 33 - 16, k / 33 - 16)).filter(|(x, y)| x * x + y * y <= 256);
        refused += u64::from(ways.any(|(x, y)| {
            let free = turned.translated(Vec2::from_raw(x * step, y * step)).unwrap();
            !map.overlaps(&free) && map.line_of_sight(body.position(), free.position()).unwrap()
        }));
    }
    println!("{pushed} pushed, {refused} refused with room");
    assert!(pushed > 100 && 50 * refused < pushed, "{pushed} {refused}");
}

/// A car turns between walls that are nearly parallel to it. The place beyond both was 47 units
/// away, past the end of the level's walls.
#[test]
fn a_turn_leads_no_farther_than_the_body_is_long() {
    static TIGHT: TileKinds = TileKinds::EMPTY
        .with(b'#', TileKind::FULL)
        .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
        .with(b'_', TileKind::of(TileShape::HalfBottom))
        .with(b'[', TileKind::of(TileShape::HalfLeft))
        .with(b'7', TileKind::of(TileShape::SlopeTopRight))
        .with(b'P', TileKind::of(TileShape::SlopeTopLeft))
        .with(b'^', TileKind::of(TileShape::HalfTop))
        .with(b']', TileKind::of(TileShape::HalfRight));
    let rows = "############\n#....a#.[7.#\n#P...#_....#\n#.]......a.#\n#.....^.._.#\n############";
    let map = TileMap::<AllShapes>::of_ascii(rows, &TIGHT).unwrap();
    let car = |turn: f64| {
        let (x, y) = ((9.14 + turn).cos() * 1e6, (9.14 + turn).sin() * 1e6);
        let half = Vec2::from_raw(625_139, 86_602);
        OrientedBox::new(Vec2::from_raw(7_764_317, 2_063_186), half, Axis::new(x as i32, y as i32)).unwrap()
    };
    let (mut turned, start) = (0, car(0.0));
    for step in 1..100 {
        let Ok(end) = turn(&map, &start, &car(f64::from(step) / 300.0)) else { continue };
        let by = (end.centre() - start.centre()).length();
        assert!(by < 20 && !map.overlaps(&end), "{step}: {by}");
        turned += 1;
    }
    assert!(turned > 40, "{turned}");
}
