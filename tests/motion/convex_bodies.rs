//! Turned boxes, polygons and slanted capsules that move through random levels: never inside, never
//! through a wall, never faster, and not held by what leaves them a way.

use std::fmt::Debug;
use tilesat::motion::Body;
use tilesat::prelude::*;
use tilesat::shape::{AnyShape, Compound};
use tilesat::world::RayRules;
use tilesat::{
    Aabb, AllShapes, Axis, Capsule, ConvexPolygon, Fx, Grid, Inside, Joined, Mover, OrientedBox, Outside, Path,
    PathKind, Response, SegmentMap, TileKind, TileKinds, TileMap, TileShape, Vec2, World, segment_map,
};
use tilesat_judge::Random;

pub(super) const SIDE: usize = 14;
pub(super) const CELL: i64 = 16 << 16;

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

fn square(v: Vec2) -> i64 {
    let (x, y) = v.raw();
    i64::from(x) * i64::from(x) + i64::from(y) * i64::from(y)
}

/// A room with solid borders, one cell thick; one tile in three is of any shape.
pub(super) fn tiles(random: &mut Random) -> [u8; SIDE * SIDE] {
    let mut tiles = [0; SIDE * SIDE];
    for (i, tile) in tiles.iter_mut().enumerate() {
        let (x, y) = (i % SIDE, i / SIDE);
        *tile = if x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1 {
            1
        } else if random.one_in(4) {
            random.below(38) as u8
        } else {
            0
        };
    }
    tiles
}

fn level(tiles: &[u8]) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(Outside::Empty)
}

const fn at<const N: usize>(points: [(i16, i16); N]) -> [Vec2; N] {
    let (mut out, mut i) = ([Vec2::ZERO; N], 0);
    while i < N {
        out[i] = Vec2::from_ints(points[i].0, points[i].1);
        i += 1;
    }
    out
}

const ROOM: [Vec2; 5] = at([(4, 4), (4, 220), (220, 220), (220, 4), (4, 4)]);
const HILL: [Vec2; 5] = at([(20, 200), (60, 160), (90, 180), (140, 150), (150, 210)]);
const SHARD: [Vec2; 3] = at([(150, 60), (205, 30), (160, 80)]);
const NEEDLE: [Vec2; 2] = at([(60, 40), (100, 90)]);
const STEPS: [Vec2; 4] = at([(170, 120), (185, 115), (200, 120), (210, 130)]);
const PATHS: [Path<'static>; 5] = [
    Path::new(PathKind::Wall, &ROOM),
    Path::new(PathKind::Solid, &HILL),
    Path::new(PathKind::Solid, &SHARD),
    Path::new(PathKind::Wall, &NEEDLE),
    Path::new(PathKind::OneWay, &STEPS),
];
segment_map!(static SEGMENTS: PATHS, Fx::const_from_int(32));

/// One-way faces are solid to what is in front of them.
const SOLID: RayRules = RayRules { one_way: true, inside: Inside::Hit };

const MOST: usize = 6;
type Any = AnyShape<MOST>;

/// A figure around a point, up to about a cell in size.
fn figure(random: &mut Random, c: (i64, i64)) -> Option<Any> {
    let size = 1 + random.magnitude(CELL);
    let near = |random: &mut Random| raw(c.0 + random.around(size), c.1 + random.around(size));
    match random.below(4) {
        0 => {
            let half = raw(1 + random.magnitude(size), 1 + random.magnitude(size));
            let direction = [Axis::new(3, 4), Axis::new(1, 1), Axis::X, Axis::new(-5, 12)];
            let direction = if random.one_in(2) {
                direction[random.below(4) as usize]
            } else {
                Axis::new(random.around(1 << 20) as i32 | 1, random.around(1 << 20) as i32)
            };
            OrientedBox::new(raw(c.0, c.1), half, direction).ok().map(Any::from)
        }
        1 => {
            let radius = Fx::from_bits(1 + random.magnitude(size / 2) as i32);
            Capsule::new(near(random), near(random), radius).ok().map(Any::from)
        }
        kind => {
            let points: Vec<Vec2> = (0..random.within(3, MOST as i64)).map(|_| near(random)).collect();
            let sharp = ConvexPolygon::<MOST>::hull(&points).ok()?;
            let radius = if kind == 2 { 0 } else { random.magnitude(size / 2) };
            sharp.with_radius(Fx::from_bits(radius as i32)).ok().map(Any::from)
        }
    }
}

#[derive(Debug, Default)]
struct Tally {
    frames: u64,
    hits: u64,
    stops: u64,
    /// Stops that the same velocity does not end, though a way with a part of it is free.
    dead: u64,
    /// The same of bodies less than a sixteenth of a unit wide or high, which are a few roundings.
    tiny: u64,
}

/// Whether the body gets on by a unit in a direction that has a tenth of the velocity or more.
fn has_a_way<W: World, B: Body>(world: &W, body: &B, v: Vec2, cast: &impl Fn(&W, &B, Vec2) -> bool) -> bool {
    let (x, y) = v.raw();
    let (x, y) = (f64::from(x), f64::from(y));
    let length = x.hypot(y);
    (-28..=28).any(|k| {
        let (sin, cos) = (f64::from(k) / 20.0).sin_cos();
        let unit = |a: f64| (a / length * 32768.0) as i32;
        cast(world, body, Vec2::from_raw(unit(x * cos - y * sin), unit(x * sin + y * cos)))
    })
}

#[expect(clippy::too_many_arguments, reason = "each differs between levels and bodies")]
fn play<W: World, B: Body + PartialEq + Debug>(
    world: &W,
    mut body: B,
    random: &mut Random,
    bounds: &Aabb,
    cast: &impl Fn(&W, &B, Vec2) -> bool,
    overlaps: &impl Fn(&B) -> bool,
    aabb: &impl Fn(&B) -> Aabb,
    tally: &mut Tally,
) {
    let mut v = Vec2::ZERO;
    for frame in 0..40 {
        let push = if frame % 8 == 0 { [2, 8, 40][random.below(3) as usize] } else { 0 };
        v += raw(random.around(1 + (push << 16)), random.around(1 + (push << 16)) + (1 << 14));
        let (x, y) = v.raw();
        v = Vec2::from_raw(x.clamp(-64 << 16, 64 << 16), y.clamp(-64 << 16, 64 << 16));
        let mover = [Mover::new(), Mover::platformer(Axis::NEG_Y)][random.below(2) as usize];
        let bounces = random.one_in(6);
        let mover = mover.with_response(if bounces { Response::Bounce } else { Response::Slide });
        let case = || format!("{body:?} by {v:?}");
        let moved = mover.move_and_slide(world, &body, v).unwrap_or_else(|e| panic!("{e:?}: {}", case()));
        tally.frames += 1;
        tally.hits += u64::from(!moved.hits.is_empty());
        assert!(!overlaps(&moved.body), "inside {:?}: {}", moved.body, case());
        assert!(square(moved.velocity) <= square(v), "faster {:?}: {}", moved.velocity, case());
        assert!(bounds.contains(&aabb(&moved.body)), "out of the room {:?}: {}", moved.body, case());
        if moved.velocity == Vec2::ZERO && !bounces && square(v) > 1 << 30 {
            tally.stops += 1;
            // What it met on the way took a part of the velocity. The same velocity there holds it
            // only if it has no way.
            let again = mover.move_and_slide(world, &moved.body, v).expect("it is free");
            if again.body == moved.body && has_a_way(world, &moved.body, v, cast) {
                let size = aabb(&moved.body).size();
                let is_tiny = size.x.min(size.y) < Fx::from_bits(1 << 12);
                *if is_tiny { &mut tally.tiny } else { &mut tally.dead } += 1;
            }
        }
        (body, v) = (moved.body, moved.velocity);
    }
}

fn any_aabb(shape: &Any) -> Aabb {
    shape.aabb()
}

#[test]
fn tiles_of_all_shapes() {
    let mut random = Random::new(5);
    let mut tally = Tally::default();
    let bounds = Aabb::new(Vec2::ZERO, raw(SIDE as i64 * CELL, SIDE as i64 * CELL)).unwrap();
    let inner = |random: &mut Random| random.within(2 * CELL, (SIDE as i64 - 2) * CELL);
    for _ in 0..tilesat_judge::cases(60) {
        let tiles = tiles(&mut random);
        let map = level(&tiles);
        let mut done = 0;
        while done < 12 {
            let c = (inner(&mut random), inner(&mut random));
            let Some(body) = figure(&mut random, c) else { continue };
            if map.overlaps(&body) || !bounds.contains(&body.aabb()) {
                continue;
            }
            done += 1;
            let cast = |w: &TileMap<'_, AllShapes>, b: &Any, d| w.cast_shape(b, d, SOLID).unwrap().is_none();
            play(&map, body, &mut random, &bounds, &cast, &|b| map.overlaps(b), &any_aabb, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8, "{tally:?}");
    assert!(tally.dead * 50_000 <= tally.frames && tally.tiny * 5_000 <= tally.frames, "{tally:?}");
}

/// Two or three figures that move as one.
#[test]
fn compounds() {
    let mut random = Random::new(8);
    let mut tally = Tally::default();
    let bounds = Aabb::new(Vec2::ZERO, raw(SIDE as i64 * CELL, SIDE as i64 * CELL)).unwrap();
    for _ in 0..tilesat_judge::cases(60) {
        let tiles = tiles(&mut random);
        let map = level(&tiles);
        let mut done = 0;
        while done < 12 {
            let c = (random.within(2 * CELL, 12 * CELL), random.within(2 * CELL, 12 * CELL));
            let parts: Vec<Any> = (0..random.within(2, 3)).filter_map(|_| figure(&mut random, c)).collect();
            let Ok(body) = Compound::<Any, 3>::new(&parts) else { continue };
            if map.overlaps(&body) || !bounds.contains(&body.aabb()) {
                continue;
            }
            done += 1;
            let cast =
                |w: &TileMap<'_, AllShapes>, b: &Compound<Any, 3>, d| w.cast_shape(b, d, SOLID).unwrap().is_none();
            let aabb = |b: &Compound<Any, 3>| b.aabb();
            play(&map, body, &mut random, &bounds, &cast, &|b| map.overlaps(b), &aabb, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8, "{tally:?}");
    assert!(tally.dead * 50_000 <= tally.frames && tally.tiny * 5_000 <= tally.frames, "{tally:?}");
}

static FULL: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

#[test]
fn blocks() {
    let mut random = Random::new(6);
    let mut tally = Tally::default();
    let bounds = Aabb::new(Vec2::ZERO, raw(SIDE as i64 * CELL, SIDE as i64 * CELL)).unwrap();
    let inner = |random: &mut Random| random.within(2 * CELL, (SIDE as i64 - 2) * CELL);
    for _ in 0..tilesat_judge::cases(60) {
        let mut tiles = tiles(&mut random);
        for tile in &mut tiles {
            *tile = u8::from(*tile != 0);
        }
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
        let map = TileMap::on_grid(&tiles, grid, &FULL).unwrap().with_outside(Outside::Empty);
        let mut done = 0;
        while done < 12 {
            let c = (inner(&mut random), inner(&mut random));
            let Some(body) = figure(&mut random, c) else { continue };
            if map.overlaps(&body) || !bounds.contains(&body.aabb()) {
                continue;
            }
            done += 1;
            let cast = |w: &TileMap<'_>, b: &Any, d| w.cast_shape(b, d, SOLID).unwrap().is_none();
            play(&map, body, &mut random, &bounds, &cast, &|b| map.overlaps(b), &any_aabb, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8, "{tally:?}");
    assert!(tally.dead * 50_000 <= tally.frames && tally.tiny * 5_000 <= tally.frames, "{tally:?}");
}

#[test]
fn segments_and_joined_levels() {
    let mut random = Random::new(7);
    let (mut tally, mut both) = (Tally::default(), Tally::default());
    let bounds = Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(220, 220)).unwrap();
    for _ in 0..tilesat_judge::cases(60) {
        let mut tiles = tiles(&mut random);
        for tile in &mut tiles {
            *tile = if random.one_in(3) { *tile } else { 0 };
        }
        let map = level(&tiles);
        let joined = Joined::new(&map, &SEGMENTS);
        let mut done = 0;
        while done < 12 {
            let c = (random.within(20 << 16, 200 << 16), random.within(20 << 16, 200 << 16));
            let Some(body) = figure(&mut random, c) else { continue };
            if !bounds.contains(&body.aabb()) {
                continue;
            }
            if !SEGMENTS.overlaps(&body) {
                let cast = |w: &SegmentMap<'_>, b: &Any, d| w.cast_shape(b, d, SOLID).unwrap().is_none();
                play(&SEGMENTS, body, &mut random, &bounds, &cast, &|b| SEGMENTS.overlaps(b), &any_aabb, &mut tally);
                done += 1;
            }
            if !joined.overlaps(&body) {
                let cast = |w: &Joined<'_, TileMap<'_, AllShapes>, SegmentMap<'_>>, b: &Any, d| {
                    w.cast_shape(b, d, SOLID).unwrap().is_none()
                };
                play(&joined, body, &mut random, &bounds, &cast, &|b| joined.overlaps(b), &any_aabb, &mut both);
                done += 1;
            }
        }
    }
    println!("{tally:?} {both:?}");
    for tally in [tally, both] {
        assert!(tally.hits > tally.frames / 8, "{tally:?}");
        assert!(tally.dead * 50_000 <= tally.frames && tally.tiny * 5_000 <= tally.frames, "{tally:?}");
    }
}
