//! Oriented boxes, polygons and slanted capsules that move through random levels: never inside,
//! never through a wall, never faster, and never held by what leaves them a way.

use std::fmt::Debug;
use tilesat::motion::Body;
use tilesat::prelude::*;
use tilesat::shape::{AnyShape, Compound};
use tilesat::world::RayRules;
use tilesat::{
    Aabb, AllShapes, Axis, Capsule, ConvexPolygon, Fx, Grid, Inside, Joined, Mover, OrientedBox, Outside, Path,
    PathKind, Response, TileKind, TileKinds, TileMap, TileShape, Vec2, World, segment_map,
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

/// The grid of a level, this many times as large.
fn grid(times: i32) -> Grid {
    Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16 * times), Vec2::ZERO).unwrap()
}

fn level(tiles: &[u8], times: i32) -> TileMap<'_, AllShapes> {
    TileMap::of(tiles, grid(times), &KINDS).unwrap().with_outside(Outside::Empty)
}

/// How much finer the lattice is in which a body that stopped is asked for a way on.
const FINE: i32 = 16;

const fn fine(v: Vec2) -> Vec2 {
    let (x, y) = v.raw();
    Vec2::from_raw(x * FINE, y * FINE)
}

const fn at<const N: usize>(points: [(i16, i16); N]) -> [Vec2; N] {
    let (mut out, mut i) = ([Vec2::ZERO; N], 0);
    while i < N {
        out[i] = Vec2::from_ints(points[i].0, points[i].1);
        i += 1;
    }
    out
}

const fn paths([room, hill, shard, needle, steps]: [&'static [Vec2]; 5]) -> [Path<'static>; 5] {
    [
        Path::new(PathKind::Wall, room),
        Path::new(PathKind::Solid, hill),
        Path::new(PathKind::Solid, shard),
        Path::new(PathKind::Wall, needle),
        Path::new(PathKind::OneWay, steps),
    ]
}

const ROOM: [Vec2; 5] = at([(4, 4), (4, 220), (220, 220), (220, 4), (4, 4)]);
const HILL: [Vec2; 5] = at([(20, 200), (60, 160), (90, 180), (140, 150), (150, 210)]);
const SHARD: [Vec2; 3] = at([(150, 60), (205, 30), (160, 80)]);
const NEEDLE: [Vec2; 2] = at([(60, 40), (100, 90)]);
const STEPS: [Vec2; 4] = at([(170, 120), (185, 115), (200, 120), (210, 130)]);
const PATHS: [Path<'static>; 5] = paths([&ROOM, &HILL, &SHARD, &NEEDLE, &STEPS]);
segment_map!(static SEGMENTS: PATHS, Fx::const_from_int(32));

const fn all_fine<const N: usize>(mut points: [Vec2; N]) -> [Vec2; N] {
    let mut i = 0;
    while i < N {
        (points[i], i) = (fine(points[i]), i + 1);
    }
    points
}

const FINE_ROOM: [Vec2; 5] = all_fine(ROOM);
const FINE_HILL: [Vec2; 5] = all_fine(HILL);
const FINE_SHARD: [Vec2; 3] = all_fine(SHARD);
const FINE_NEEDLE: [Vec2; 2] = all_fine(NEEDLE);
const FINE_STEPS: [Vec2; 4] = all_fine(STEPS);
const FINE_PATHS: [Path<'static>; 5] = paths([&FINE_ROOM, &FINE_HILL, &FINE_SHARD, &FINE_NEEDLE, &FINE_STEPS]);
segment_map!(static FINE_SEGMENTS: FINE_PATHS, Fx::const_from_int(256));

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

/// A body in a random level.
trait Mobile: Body + PartialEq + Debug {
    fn aabb(&self) -> Aabb;

    /// The same in the finer lattice.
    fn fine(&self) -> Self;

    /// The smallest radius of its corners, in raw units, if any is round.
    fn radius(&self) -> Option<i32>;
}

impl Mobile for Any {
    fn aabb(&self) -> Aabb {
        self.aabb()
    }

    fn fine(&self) -> Self {
        let hull = |corners: &[Vec2], radius: Fx| {
            let corners: Vec<_> = corners.iter().map(|&c| fine(c)).collect();
            ConvexPolygon::hull(&corners).unwrap().with_radius(radius * FINE).unwrap().into()
        };
        match self {
            Self::Capsule(it) => Capsule::new(fine(it.a()), fine(it.b()), it.radius() * FINE).unwrap().into(),
            Self::OrientedBox(it) => hull(&it.corners(), it.radius()),
            Self::Polygon(it) => hull(it.vertices(), it.radius()),
            _ => panic!("no such body: {self:?}"),
        }
    }

    fn radius(&self) -> Option<i32> {
        let radius = match self {
            Self::Capsule(it) => it.radius(),
            Self::OrientedBox(it) => it.radius(),
            Self::Polygon(it) => it.radius(),
            _ => panic!("no such body: {self:?}"),
        };
        Some(radius.to_bits()).filter(|&r| r > 0)
    }
}

impl Mobile for Compound<Any, 3> {
    fn aabb(&self) -> Aabb {
        self.aabb()
    }

    fn fine(&self) -> Self {
        Self::new(&self.parts().iter().map(Mobile::fine).collect::<Vec<_>>()).unwrap()
    }

    fn radius(&self) -> Option<i32> {
        self.parts().iter().filter_map(Mobile::radius).min()
    }
}

/// A level, and the same in the finer lattice.
struct Place<'a, W, B> {
    world: &'a W,
    fine: &'a W,
    bounds: Aabb,
    overlaps: fn(&W, &B) -> bool,
    /// Where a motion of the body hits first.
    first: fn(&W, &B, Vec2) -> Option<B>,
}

macro_rules! place {
    ($world:expr, $fine:expr, $bounds:expr) => {
        Place {
            world: $world,
            fine: $fine,
            bounds: $bounds,
            overlaps: |world, body| world.overlaps(body),
            first: |world, body, d| world.cast_shape(body, d, SOLID).unwrap().map(|hit| hit.body),
        }
    };
}

#[derive(Debug, Default)]
struct Tally {
    frames: u64,
    hits: u64,
    stops: u64,
}

impl<W: World, B: Mobile> Place<'_, W, B> {
    /// Whether a body that its velocity presses against something gets on by a unit, in a direction
    /// that has a tenth of the velocity or more.
    ///
    /// A stop is up to a raw unit before what it hits, and there a body is not held: one raw unit
    /// before the end of a ledge it has a way down. So the velocity presses it on in a lattice 16
    /// times as fine. What remains is a gap g of at most one unit of that lattice. Over a point,
    /// the gap opens ways to a disc of radius r. They have up to a part c of the velocity for which
    /// r (1 - sqrt(1 - c^2)) is g, so about c^2 r / 2. Ways of a disc need twice that square.
    fn has_a_way(&self, body: &B, v: Vec2) -> bool {
        let Some(pressed) = (self.first)(self.fine, &body.fine(), fine(v)) else { return true };
        let (x, y) = v.raw();
        let (x, y) = (f64::from(x), f64::from(y));
        let unit = |a: f64| (a / x.hypot(y) * f64::from(FINE << 15)) as i32;
        let least = body.radius().map_or(0.0, |r| (4.0 / f64::from(r * FINE)).sqrt());
        (-28..=28).map(|k| (f64::from(k) / 20.0).sin_cos()).filter(|&(_, cos)| cos > least).any(|(sin, cos)| {
            let way = Vec2::from_raw(unit(x * cos - y * sin), unit(x * sin + y * cos));
            (self.first)(self.fine, &pressed, way).is_none()
        })
    }

    fn play(&self, mut body: B, random: &mut Random, tally: &mut Tally) {
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
            let moved = mover.move_and_slide(self.world, &body, v).unwrap_or_else(|e| panic!("{e:?}: {}", case()));
            tally.frames += 1;
            tally.hits += u64::from(!moved.hits.is_empty());
            assert!(!(self.overlaps)(self.world, &moved.body), "inside {:?}: {}", moved.body, case());
            assert!(square(moved.velocity) <= square(v), "faster {:?}: {}", moved.velocity, case());
            assert!(self.bounds.contains(&moved.body.aabb()), "out of the room {:?}: {}", moved.body, case());
            if moved.velocity == Vec2::ZERO && !bounces && square(v) > 1 << 30 {
                tally.stops += 1;
                // What it met on the way took a part of the velocity. The same velocity there holds
                // it only if it has no way.
                let again = mover.move_and_slide(self.world, &moved.body, v).expect("it is free");
                let held = again.body == moved.body;
                assert!(!held || !self.has_a_way(&moved.body, v), "held {:?}: {}", moved.body, case());
            }
            (body, v) = (moved.body, moved.velocity);
        }
    }
}

#[test]
fn tiles_of_all_shapes() {
    let mut random = Random::new(5);
    let mut tally = Tally::default();
    let bounds = Aabb::new(Vec2::ZERO, raw(SIDE as i64 * CELL, SIDE as i64 * CELL)).unwrap();
    let inner = |random: &mut Random| random.within(2 * CELL, (SIDE as i64 - 2) * CELL);
    for _ in 0..tilesat_judge::cases(60) {
        let tiles = tiles(&mut random);
        let (map, fine) = (level(&tiles, 1), level(&tiles, FINE));
        let mut done = 0;
        while done < 12 {
            let c = (inner(&mut random), inner(&mut random));
            let Some(body) = figure(&mut random, c) else { continue };
            if map.overlaps(&body) || !bounds.contains(&body.aabb()) {
                continue;
            }
            done += 1;
            place!(&map, &fine, bounds).play(body, &mut random, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8 && tally.stops > 0, "{tally:?}");
}

/// Two or three figures that move as one.
#[test]
fn compounds() {
    let mut random = Random::new(8);
    let mut tally = Tally::default();
    let bounds = Aabb::new(Vec2::ZERO, raw(SIDE as i64 * CELL, SIDE as i64 * CELL)).unwrap();
    for _ in 0..tilesat_judge::cases(60) {
        let tiles = tiles(&mut random);
        let (map, fine) = (level(&tiles, 1), level(&tiles, FINE));
        let mut done = 0;
        while done < 12 {
            let c = (random.within(2 * CELL, 12 * CELL), random.within(2 * CELL, 12 * CELL));
            let parts: Vec<Any> = (0..random.within(2, 3)).filter_map(|_| figure(&mut random, c)).collect();
            let Ok(body) = Compound::<Any, 3>::new(&parts) else { continue };
            if map.overlaps(&body) || !bounds.contains(&body.aabb()) {
                continue;
            }
            done += 1;
            place!(&map, &fine, bounds).play(body, &mut random, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8 && tally.stops > 0, "{tally:?}");
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
        let [map, fine] =
            [1, FINE].map(|times| TileMap::on_grid(&tiles, grid(times), &FULL).unwrap().with_outside(Outside::Empty));
        let mut done = 0;
        while done < 12 {
            let c = (inner(&mut random), inner(&mut random));
            let Some(body) = figure(&mut random, c) else { continue };
            if map.overlaps(&body) || !bounds.contains(&body.aabb()) {
                continue;
            }
            done += 1;
            place!(&map, &fine, bounds).play(body, &mut random, &mut tally);
        }
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8 && tally.stops > 0, "{tally:?}");
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
        let (map, fine) = (level(&tiles, 1), level(&tiles, FINE));
        let (joined, fine) = (Joined::new(&map, &SEGMENTS), Joined::new(&fine, &FINE_SEGMENTS));
        let mut done = 0;
        while done < 12 {
            let c = (random.within(20 << 16, 200 << 16), random.within(20 << 16, 200 << 16));
            let Some(body) = figure(&mut random, c) else { continue };
            if !bounds.contains(&body.aabb()) {
                continue;
            }
            if !SEGMENTS.overlaps(&body) {
                place!(&SEGMENTS, &FINE_SEGMENTS, bounds).play(body, &mut random, &mut tally);
                done += 1;
            }
            if !joined.overlaps(&body) {
                place!(&joined, &fine, bounds).play(body, &mut random, &mut both);
                done += 1;
            }
        }
    }
    println!("{tally:?} {both:?}");
    for tally in [tally, both] {
        assert!(tally.hits > tally.frames / 8 && tally.stops > 0, "{tally:?}");
    }
}
