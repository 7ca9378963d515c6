//! Responses by the flags of the surface that was hit. If all hits of a body have one answer, the
//! call equals that of a mover with that response, bit for bit. Each hit gets the answer of its own
//! flags.

use std::fmt::Debug;

use tilesat::motion::{Body, ByFlags, Hit, Responses};
use tilesat::world::Trail;
use tilesat::{
    Aabb, AllShapes, Axis, Capsule, Circle, Fx, Grid, Moved, Mover, Outside, Ratio, Response, Solid, Solids, Surface,
    TileKind, TileKinds, TileMap, TileShape, Vec2,
};
use tilesat_judge::Random;

const SIDE: usize = 12;
const CELL: i64 = 16 << 16;
const GLUE: u8 = 1;
const SPRING: u8 = 2;
const ICE: u8 = 4;

/// Every shape, once without a flag and once with each.
static KINDS: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0);
    while id < 4 * 38 {
        let kind = TileKind::of(TileShape::ALL[id % 38]).with_flags([0, GLUE, SPRING, ICE][id / 38]);
        kinds = kinds.with(id as u8, kind);
        id += 1;
    }
    kinds
};

const RUBBER: Surface = Surface::new(Ratio::HALF, Ratio::percent(25).unwrap());
const UP: Mover<Surface> = Mover::platformer(Axis::NEG_Y).with_surface(RUBBER);
const TABLE: Mover<ByFlags<Surface>> = UP.with_responses(Responses::NONE.touching(GLUE).bouncing(SPRING).sliding(ICE));

fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(i32::try_from(x).unwrap(), i32::try_from(y).unwrap())
}

/// A few tiles in the void, some of them full, with some of the four flags.
fn tiles(random: &mut Random, flags: &[i64]) -> [u8; SIDE * SIDE] {
    let mut tiles = [0; SIDE * SIDE];
    tiles.fill_with(|| {
        let shape = if random.one_in(2) { 0 } else { [1, random.below(38)][random.below(2) as usize] };
        (38 * flags[random.below(flags.len() as i64) as usize] + shape) as u8
    });
    tiles
}

fn level(tiles: &[u8]) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(Outside::Empty)
}

trait Judge {
    fn of<B: Body + PartialEq + Debug>(&mut self, level: &TileMap<'_, AllShapes>, body: B, v: Vec2);
}

/// Bodies of each kind on the lattice of quarter cells and a few raw units off, so that they meet
/// corners, seams and faces.
fn try_all(seed: u64, flags: &[i64], judge: &mut impl Judge) {
    let mut random = Random::new(seed);
    for _ in 0..tilesat_judge::cases(400) {
        let tiles = tiles(&mut random, flags);
        let level = level(&tiles);
        for n in 0..60 {
            let mut near = || random.within(0, 4 * SIDE as i64) * CELL / 4 + random.around(2);
            let (x, y) = (near(), near());
            let (w, h) = (random.magnitude(CELL) + 3, random.magnitude(CELL) + 3);
            let fastest = if random.one_in(4) { 4 * CELL } else { CELL };
            // Also straight at a face that the body touches.
            let mut part = || if random.one_in(4) { 0 } else { random.around(fastest) };
            let v = raw(part(), part());
            let r = Fx::from_bits(w as i32);
            match n % 3 {
                0 => judge.of(&level, Aabb::new(raw(x, y), raw(x + w, y + h)).unwrap(), v),
                1 => judge.of(&level, Circle::new(raw(x, y), r).unwrap(), v),
                _ => judge.of(&level, Capsule::new(raw(x, y), raw(x, y + h), r).unwrap(), v),
            }
        }
    }
}

fn told<B: Body>(moved: &Moved<B>) -> impl PartialEq + Debug + use<B> {
    (moved.velocity, moved.remaining, moved.hits, (moved.floor, moved.wall, moved.ceiling), moved.flags)
}

struct One {
    /// The response of the mover under the table, which no answer equals.
    below: Response,
    wanted: Response,
    calls: u32,
}

impl Judge for One {
    fn of<B: Body + PartialEq + Debug>(&mut self, level: &TileMap<'_, AllShapes>, body: B, v: Vec2) {
        let by_table = TABLE.with_response(self.below).move_and_slide(level, &body, v);
        let plain = UP.with_response(self.wanted).move_and_slide(level, &body, v);
        match (&by_table, &plain) {
            (Ok(one), Ok(other)) => {
                assert_eq!((&one.body, told(one)), (&other.body, told(other)), "{body:?} by {v:?}");
                self.calls += u32::from(!one.hits.is_empty());
            }
            (one, other) => assert_eq!(one.as_ref().err(), other.as_ref().err(), "{body:?} by {v:?}"),
        }
    }
}

#[test]
fn levels_of_one_flag_are_levels_of_one_response() {
    for (flag, wanted) in [(1, Response::Touch), (2, Response::Bounce), (3, Response::Slide)] {
        for below in [Response::Touch, Response::Bounce, Response::Slide] {
            let mut one = One { below, wanted, calls: 0 };
            try_all(7, &[flag], &mut one);
            assert!(one.calls > 1_000, "{}", one.calls);
        }
    }
}

/// The number of calls with one hit only, and with more than one, by the answer to the first.
struct Each {
    once: [u32; 3],
    more: [u32; 3],
}

impl Judge for Each {
    fn of<B: Body + PartialEq + Debug>(&mut self, level: &TileMap<'_, AllShapes>, body: B, v: Vec2) {
        let Ok(moved) = TABLE.move_and_slide(level, &body, v) else { return };
        let Some(first) = moved.hits.first() else { return };
        // A face or a corner of several tiles has the flags of all.
        let kind_of = |flags: u8| {
            if flags & GLUE != 0 {
                0
            } else if flags & SPRING != 0 {
                1
            } else {
                2
            }
        };
        let kind = kind_of(first.flags);
        let response = [Response::Touch, Response::Bounce, Response::Slide][kind];
        let plain = UP.with_response(response).move_and_slide(level, &body, v).unwrap();
        assert_eq!(plain.hits.first(), Some(first), "{body:?} by {v:?}");
        // All hits up to the first difference are equal. Nothing follows a touch.
        if moved.hits.iter().all(|hit| kind_of(hit.flags) == kind) {
            assert_eq!((&moved.body, told(&moved)), (&plain.body, told(&plain)), "{body:?} by {v:?}");
            self.once[kind] += 1;
        } else {
            assert!(kind != 0, "{body:?} by {v:?} goes on after a touch");
            self.more[kind] += 1;
        }
    }
}

#[test]
fn each_hit_gets_its_own_answer() {
    let mut each = Each { once: [0; 3], more: [0; 3] };
    try_all(8, &[0, 1, 2, 3], &mut each);
    let Each { once, more } = each;
    assert!(once.iter().all(|&n| n > 300) && more[1] > 100 && more[2] > 100, "{once:?} {more:?}");
}

#[test]
fn touching_goes_before_bouncing_and_that_before_sliding() {
    let all = Responses::NONE.sliding(4).sliding(3).bouncing(2).bouncing(3).touching(1).touching(16);
    let mover = Mover::new().with_responses(all);
    let body = Aabb::new(Vec2::ZERO, Vec2::from_ints(8, 8)).unwrap();
    for (flags, v) in [(1, (0, 0)), (3, (0, 0)), (7, (0, 0)), (2, (-10, 3)), (6, (-10, 3)), (4, (0, 3)), (8, (0, 3))] {
        let wall = Aabb::new(Vec2::from_ints(10, -50), Vec2::from_ints(20, 50)).unwrap();
        let wall = [Solid::new(wall, 0).unwrap().with_flags(flags)];
        let moved = mover.move_and_slide(&Solids::new(&wall), &body, Vec2::from_ints(10, 3)).unwrap();
        assert_eq!(moved.velocity, Vec2::from_ints(v.0, v.1), "flags {flags}");
    }
}

#[test]
fn the_order_of_the_builders_does_not_matter() {
    let table = Responses::NONE.bouncing(SPRING);
    let first = Mover::new().with_responses(table).with_response(Response::Touch);
    let last = Mover::new().with_response(Response::Touch).with_responses(table);
    assert_eq!(first, last);
    let tiles = [0, 38 * 2 + 1];
    let grid = Grid::new(2, 1, Fx::from_num(16), Vec2::ZERO).unwrap();
    let level = TileMap::<AllShapes>::of(&tiles, grid, &KINDS).unwrap();
    let body = Aabb::new(Vec2::from_ints(2, 2), Vec2::from_ints(10, 10)).unwrap();
    for mover in [first, last] {
        let moved = mover.move_and_slide(&level, &body, Vec2::from_ints(9, 0)).unwrap();
        assert_eq!((moved.position(), moved.velocity), (Vec2::from_ints(5, 2), Vec2::from_ints(-9, 0)));
    }
}

/// The response to all other surfaces is that of a mover with this response of its own.
#[test]
fn what_has_no_flag_receives_the_other_response() {
    let table = Responses::NONE.touching(GLUE);
    let body = Aabb::new(Vec2::ZERO, Vec2::from_ints(8, 8)).unwrap();
    let wall = Aabb::new(Vec2::from_ints(10, -50), Vec2::from_ints(20, 50)).unwrap();
    for (flags, response) in [0, GLUE, ICE]
        .into_iter()
        .flat_map(|flags| [Response::Slide, Response::Touch, Response::Bounce].map(|response| (flags, response)))
    {
        let wall = [Solid::new(wall, 0).unwrap().with_flags(flags)];
        let after = |mover: Mover<ByFlags>| {
            mover.move_and_slide(&Solids::new(&wall), &body, Vec2::from_ints(10, 3)).map(|moved| moved.velocity)
        };
        let expected = after(Mover::new().with_response(response).with_responses(table));
        assert_eq!(after(Mover::new().with_responses(table.otherwise(response))), expected, "{flags} {response:?}");
        // The table wins over the mover's own response.
        let other = if response == Response::Touch { Response::Slide } else { Response::Touch };
        assert_eq!(after(Mover::new().with_response(other).with_responses(table.otherwise(response))), expected);
    }
}

/// A function that answers as the table does, and keeps what it was asked.
struct Function {
    calls: u32,
}

impl Judge for Function {
    fn of<B: Body + PartialEq + Debug>(&mut self, level: &TileMap<'_, AllShapes>, body: B, v: Vec2) {
        let table = Responses::NONE.touching(GLUE).bouncing(SPRING).sliding(ICE);
        let asked = core::cell::RefCell::new(Vec::new());
        let answer = |hit: &Hit| {
            asked.borrow_mut().push(*hit);
            table.response_to(hit.flags)
        };
        let by_function = UP.with_answers(&answer).move_and_slide(level, &body, v);
        assert_eq!(by_function, TABLE.move_and_slide(level, &body, v), "{body:?} by {v:?}");
        let Ok(moved) = by_function else { return };
        let asked = asked.into_inner();
        let told = |hit: &Hit| moved.hits.iter().any(|told| told == hit);
        // A later hit may be reported later than it was asked for, never before the previous one.
        let told = |hit: &Hit| told(hit) || moved.hits.iter().any(|told| Hit { toi: hit.toi, ..*told } == *hit);
        assert!(asked.iter().all(told), "{body:?} by {v:?}: asked {asked:?}, told {:?}", moved.hits);
        assert!(moved.hits.is_empty() || !asked.is_empty(), "{body:?} by {v:?}: {moved:?}");
        self.calls += u32::from(!asked.is_empty());
    }
}

#[test]
fn a_function_that_answers_as_a_table_is_the_table() {
    let mut function = Function { calls: 0 };
    try_all(9, &[0, 1, 2, 3], &mut function);
    assert!(function.calls > 3_000, "{}", function.calls);
}

/// Every answer by the normal: each hit gets that of its own side, and no other surface is touched.
#[test]
fn answers_by_the_normal() {
    let walls = [(-100, 20, 200, 10), (20, -100, 10, 200), (-100, -30, 200, 10), (-30, -100, 10, 200)];
    let solids: Vec<_> = (0..)
        .zip(walls)
        .map(|(key, (x, y, w, h))| {
            let at = Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap();
            Solid::new(at, key).unwrap()
        })
        .collect();
    let body = Circle::new(Vec2::ZERO, Fx::from_num(4)).unwrap();
    for key in 0..4_u16 {
        let answer = move |hit: &Hit| (hit.solid() == Some(key)).then_some(Response::Bounce);
        let mover = Mover::new().with_answers(answer);
        for (hit, v) in [(0_u16, (0, 30)), (1, (30, 0)), (2, (0, -30)), (3, (-30, 0))] {
            let moved = mover.move_and_slide(&Solids::new(&solids), &body, Vec2::from_ints(v.0, v.1)).unwrap();
            let back = if hit == key { Vec2::from_ints(-v.0, -v.1) } else { Vec2::ZERO };
            assert_eq!(moved.velocity, back, "{key} {hit}");
        }
    }
}

/// The way that a call tells: the call is the same, its parts lead from the start to the end, and
/// the body is free wherever one of them ends.
struct Told {
    parts: [u32; 5],
}

impl Judge for Told {
    fn of<B: Body + PartialEq + Debug>(&mut self, level: &TileMap<'_, AllShapes>, body: B, v: Vec2) {
        let mut trail = Trail::default();
        for response in [Response::Slide, Response::Bounce] {
            let mover = UP.with_response(response);
            let told = mover.move_along(level, &body, v, &mut trail);
            assert_eq!(told, mover.move_and_slide(level, &body, v), "{body:?} by {v:?}");
            let Ok(moved) = told else {
                assert_eq!(trail, Trail::default());
                continue;
            };
            let parts: Vec<_> = trail.parts().collect();
            assert!(parts.iter().all(|part| part.1 != Vec2::ZERO), "{body:?} by {v:?}: {parts:?}");
            let (mut at, mut place) = (Vec2::ZERO, body.position());
            for &(from, by) in &parts {
                assert_eq!(from, at, "{body:?} by {v:?}: {parts:?}");
                (at, place) = (at + by, place + by);
            }
            assert_eq!(place, moved.position(), "{body:?} by {v:?}: {parts:?}");
            // Each sweep makes one at most.
            assert!(parts.len() <= moved.work.iterations as usize, "{body:?} by {v:?}: {parts:?} {:?}", moved.work);
            self.parts[parts.len()] += 1;
        }
    }
}

#[test]
fn the_way_that_is_told_is_the_way_that_was_made() {
    let mut told = Told { parts: [0; 5] };
    try_all(10, &[0], &mut told);
    assert!(told.parts[..4].iter().all(|&n| n > 100), "{:?}", told.parts);
}

/// What crosses some tiles moves as if they were not there.
struct Crosses {
    passed: u32,
}

/// The same tiles, and nothing where they would be crossed.
static GHOSTS: TileKinds = KINDS.passing(GLUE | ICE);
/// The last id has no shape.
static WITH_HOLES: TileKinds = KINDS.with(151, TileKind::EMPTY);

impl Judge for Crosses {
    fn of<B: Body + PartialEq + Debug>(&mut self, level: &TileMap<'_, AllShapes>, body: B, v: Vec2) {
        let region = level.bounds();
        let mut without = [151; SIDE * SIDE];
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
        for tile in level.tiles_in(&region) {
            if !tile.kind.flag(GLUE | ICE) {
                without[tile.cell.y as usize * SIDE + tile.cell.x as usize] = tile.id;
            }
        }
        let without = TileMap::<AllShapes>::of(&without, grid, &WITH_HOLES).unwrap().with_outside(Outside::Empty);
        let ghosts = level.with_kinds::<AllShapes>(&GHOSTS).unwrap();
        let moved = UP.move_and_slide(&ghosts, &body, v);
        assert_eq!(moved, UP.move_and_slide(&without, &body, v), "{body:?} by {v:?}");
        self.passed += u32::from(moved != UP.move_and_slide(level, &body, v));
    }
}

#[test]
fn crossing_a_set_of_tiles_is_moving_without_them() {
    let mut crosses = Crosses { passed: 0 };
    try_all(11, &[0, 1, 2, 3], &mut crosses);
    assert!(crosses.passed > 3_000, "{}", crosses.passed);
}
