//! A motion that ends at its first look ends where the general way of a mover takes it: at one
//! surface, or without a hit.

use super::std::vec::Vec;
use crate::motion::order::First;
use crate::motion::response::Law;
use crate::motion::search::Around;
use crate::motion::{Body, MoveError, Moved, Mover, Response, StartInside, Surface, Work};
use crate::num::{Axis, Fx, Ratio, Raw, Vec2};
use crate::shape::{Aabb, Capsule, Circle};
use crate::world::{AllShapes, Blocks, Grid, Outside, ShapeSet, TileKind, TileKinds, TileMap, TileShape};
use tilesat_judge::{Random, cases, enough, thorough};

const SIDE: i32 = 6;

/// Mostly full tiles, with one-way ones. If the set has shapes, two of three levels have mostly
/// those, and one of these only halves and slopes: they often continue each other.
fn kinds<S: ShapeSet>(turn: usize, random: &mut Random) -> TileKinds {
    let one_way = [TileShape::OneWayUp, TileShape::OneWayRight, TileShape::OneWayDown, TileShape::OneWayLeft];
    let (shaped, shapes) = if S::SHAPED { [(4, 32), (14, 32), (18, 8)][turn % 3] } else { (0, 1) };
    (0..24).fold(TileKinds::EMPTY, |kinds, id: u8| {
        let shape = if id < 4 {
            one_way[usize::from(id)]
        } else if id < 4 + shaped {
            TileShape::ALL[2 + random.below(shapes) as usize]
        } else {
            TileShape::Full
        };
        kinds.with(id + 1, TileKind::of(shape).with_flags(1 << (id % 8)))
    })
}

/// How often each kind of case was seen.
#[derive(Default, Debug)]
struct Seen {
    free: u32,
    faces: u32,
    corners: u32,
    more: u32,
    errors: u32,
}

/// The same motion by sweeps and responses alone, from the start to the end.
fn general<S: Law, T: ShapeSet, B: Body>(
    mover: &Mover<S>,
    world: &TileMap<'_, T>,
    body: &B,
    v: Vec2,
) -> Result<Moved<B>, MoveError> {
    let (mut moved, mut around, mut first) = (Moved::freely(*body, v, 0), Around::nothing(), First::none());
    let mut run = mover.start(world, &mut moved, &mut around)?;
    mover.slide::<_, _, false>(world, &mut run, &mut first)?;
    run.end::<TileMap<'_, T>>();
    Ok(moved)
}

/// Frames of a body, with and without gravity. The number of sweeps is compared too, but not what
/// they looked at.
fn fly<S: Law, T: ShapeSet, B: Body + PartialEq + core::fmt::Debug>(
    mover: &Mover<S>,
    map: &TileMap<'_, T>,
    mut body: B,
    mut v: Vec2,
    (gravity, seen): (Vec2, &mut Seen),
) {
    for _ in 0..5 {
        if v == Vec2::ZERO {
            return;
        }
        let less = |moved: Result<Moved<B>, MoveError>| {
            moved.map(|moved| Moved { work: Work { features: 0, checks: 0, ..moved.work }, ..moved })
        };
        let (found, wanted) = (less(mover.move_and_slide(map, &body, v)), less(general(mover, map, &body, v)));
        assert_eq!(found, wanted, "{body:?} by {v:?} {:?}, inside {:?}", map.outside(), mover.inside);
        let Ok(moved) = found else {
            seen.errors += 1;
            return;
        };
        let first = moved.hits.first();
        match first.map(|hit| hit.axis.x != 0 && hit.axis.y != 0) {
            None => seen.free += 1,
            Some(false) if moved.hits.len() == 1 => seen.faces += 1,
            Some(true) if moved.hits.len() == 1 => seen.corners += 1,
            Some(_) => seen.more += 1,
        }
        body = moved.body;
        v = moved.velocity + gravity;
    }
}

/// Between two numbers, mostly near either of them or near a power of two.
fn number(random: &mut Random, most: i32) -> i32 {
    let most = i64::from(most.max(1));
    let size =
        if random.below(3) == 0 { 1 << random.below(i64::from(64 - (most as u64).leading_zeros())) } else { most };
    random.around(size.min(most)) as i32
}

fn level<T: ShapeSet>(turns: usize, seed: u64) -> Seen {
    let (mut random, mut seen) = (Random::new(seed), Seen::default());
    for turn in 0..turns {
        let kinds = kinds::<T>(turn / 2, &mut random);
        let cell = [1 << 20, 1002, 256, 1 << 16][turn % 4];
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(cell), Vec2::from_raw(-cell, 3)).expect("a grid");
        let dense = 2 + random.below(14);
        let tiles: Vec<u8> =
            (0..SIDE * SIDE).map(|_| if random.below(dense) == 0 { 1 + random.below(24) as u8 } else { 0 }).collect();
        let outside = [Outside::Empty, Outside::Solid, Outside::Edge][turn % 3];
        let map: TileMap<'_, T> = TileMap::of(&tiles, grid, &kinds).expect("a level").with_outside(outside);
        for _ in 0..60 {
            let r = &mut random;
            let at = Raw {
                x: r.within(-1, 6 * 64) as i32 * (cell / 64) - cell,
                y: r.within(-1, 6 * 64) as i32 * (cell / 64),
            };
            let at = Raw { x: at.x + r.below(3) as i32, y: at.y + r.below(7) as i32 };
            let radius = [0, 1, 5, cell / 8, cell / 2, cell / 2 - 3, cell, 2 * cell][r.below(8) as usize];
            let most = [8, cell / 16, cell, 4 * cell][r.below(4) as usize];
            let v = Vec2::from_raw(number(r, most), number(r, most));
            let gravity = Vec2::from_raw(0, [0, 1, 40, cell / 16][r.below(4) as usize]);
            let inside = if r.below(4) == 0 { StartInside::Ignore } else { StartInside::Report };
            let mover = Mover::platformer([Axis::NEG_Y, Axis::new(1, -3)][r.below(2) as usize])
                .with_inside(inside)
                .with_drop_through(r.below(8) == 0)
                .with_response(
                    [Response::Slide, Response::Slide, Response::Touch, Response::Bounce][r.below(4) as usize],
                );
            let rough = Surface::new(Ratio::percent(30).unwrap(), Ratio::percent(20).unwrap())
                .resting_below(Fx::from_bits(r.below(i64::from(cell)) as i32));
            let size = Raw { x: number(r, 2 * cell).abs(), y: number(r, 2 * cell).abs() };
            let boxed = Aabb::from_raw_unchecked(at, at.add(size));
            let ball = Circle::from_raw_unchecked(at, radius);
            let end = if r.below(2) == 0 { Raw { x: 0, y: size.y } } else { Raw { x: size.x, y: 0 } };
            let capsule = Capsule::new(at.vec2(), at.add(end).vec2(), Fx::from_bits(radius.max(1))).expect("a capsule");
            if r.below(3) == 0 {
                let mover = mover.with_surface(rough);
                fly(&mover, &map, ball, v, (gravity, &mut seen));
                fly(&mover, &map, boxed, v, (gravity, &mut seen));
            } else {
                fly(&mover, &map, ball, v, (gravity, &mut seen));
                fly(&mover, &map, capsule, v, (gravity, &mut seen));
                fly(&mover, &map, boxed, v, (gravity, &mut seen));
            }
        }
    }
    seen
}

#[test]
fn short_ways_end_where_the_general_way_does() {
    for seen in [level::<Blocks>(cases(thorough(1500, 6000)), 31), level::<AllShapes>(cases(thorough(750, 3000)), 32)] {
        let Seen { free, faces, corners, more, errors } = seen;
        assert!(enough([free, faces, corners, more, errors].into_iter().all(|n| n > thorough(750, 3000))), "{seen:?}");
    }
}

/// Balls that come to a tip of a quarter pipe, in front of which is the pipe.
#[test]
fn tips_of_pipes_have_the_pipe_in_front() {
    let (mut random, mut seen) = (Random::new(33), Seen::default());
    let shapes = [
        TileShape::ConcaveTopLeft,
        TileShape::ConcaveTopRight,
        TileShape::ConcaveBottomRight,
        TileShape::ConcaveBottomLeft,
    ];
    let cell = 24 << 16;
    for turn in 0..cases(20_000) {
        let kinds = TileKinds::EMPTY.with(1, TileKind::of(shapes[turn % 4]));
        let grid = Grid::new(3, 3, Fx::from_bits(cell), Vec2::ZERO).expect("a grid");
        let map: TileMap<'_, AllShapes> = TileMap::of(&[0, 0, 0, 0, 1, 0, 0, 0, 0], grid, &kinds).expect("a level");
        let r = &mut random;
        let radius = [cell / 8, cell / 3, cell / 2][r.below(3) as usize];
        let tip = Raw { x: cell << r.below(2), y: cell << r.below(2) };
        let mut part = |most: i32| r.within(-i64::from(most), i64::from(most)) as i32;
        let ball = Circle::from_raw_unchecked(tip.add(Raw { x: part(2 * radius), y: part(2 * radius) }), radius);
        let v = Vec2::from_raw(part(2 * cell), part(2 * cell));
        fly(&Mover::new(), &map, ball, v, (Vec2::ZERO, &mut seen));
    }
    assert!(enough(seen.corners > 1000 && seen.more > 50), "{seen:?}");
}
