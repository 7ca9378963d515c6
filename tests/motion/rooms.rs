//! A level cut into rooms behaves like the level: bodies that run over the borders equal those in
//! the uncut level, frame by frame, bit for bit.
//!
//! The apron is the least that [`Room::apron_for`] allows. With a cell less, the border affects
//! some bodies.

use std::fmt::Debug;
use tilesat::world::World;
use tilesat::{
    Aabb, AllShapes, Axis, Body, Cell, Circle, Fx, Grid, MoveError, Moved, Mover, Outside, Room, Rooms, TileKind,
    TileKinds, TileMap, Vec2, Walker, motion::Support,
};
use tilesat_judge::Random;
use tilesat_judge::rooms::frames::{RESPONSES, any_velocity};
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::{KINDS, Level};

/// Beyond a level there are no flags, because the outside has none.
const BEYOND: u8 = 255;
static WITH_BEYOND: TileKinds = KINDS.with(BEYOND, TileKind::FULL);

const OUTSIDES: [Outside; 3] = [Outside::Empty, Outside::Solid, Outside::Edge];

/// A body that crosses into another room.
trait Guest: Body + Copy + PartialEq + Debug {
    fn to(&self, by: Vec2) -> Self;
    fn is_free<W: World>(&self, world: &W) -> bool;
}

impl Guest for Aabb {
    fn to(&self, by: Vec2) -> Self {
        self.translated(by).unwrap()
    }
    fn is_free<W: World>(&self, world: &W) -> bool {
        !world.overlaps_aabb(self)
    }
}

impl Guest for Circle {
    fn to(&self, by: Vec2) -> Self {
        self.translated(by).unwrap()
    }
    fn is_free<W: World>(&self, world: &W) -> bool {
        !world.overlaps_circle(self)
    }
}

fn raw(p: P) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

fn fx(raw: i64) -> Fx {
    Fx::from_bits(raw as i32)
}

/// A level's rooms of this many cells. Its own first corner is the origin.
fn cut(level: &Level, room: (u16, u16), apron: u16) -> Rooms<'_> {
    let size = (level.width as u16, level.height as u16);
    Rooms::of(&level.tiles, size, fx(level.cell), &KINDS, room, apron).unwrap().with_outside(level.outside)
}

fn apron(level: &Level, body: i64, motion: i64) -> u16 {
    Room::<AllShapes>::apron_for(fx(level.cell), fx(body), fx(motion))
}

/// The offset from the world to a room.
fn into(room: &Room<'_>, cell: i64) -> Vec2 {
    let (x, y) = room.first();
    raw((-i64::from(x) * cell, -i64::from(y) * cell))
}

/// The whole report of a motion, with the cells of the world.
type Said<B> = (B, Vec<(u32, Axis, (i32, i32), u16, u8, bool)>, [Vec2; 2], [bool; 3], u8, tilesat::motion::Work);

fn said<B: Guest>(moved: &Moved<B>, by: Vec2, place: impl Fn(Cell) -> (i32, i32)) -> Said<B> {
    let hits = moved.hits.iter().map(|h| (h.toi.raw(), h.axis, place(h.cell), h.index, h.flags, h.one_way)).collect();
    let (velocities, sides) = ([moved.velocity, moved.remaining], [moved.floor, moved.wall, moved.ceiling]);
    // Without the number of features read: beyond a map is one block, and a window has a different
    // surrounding.
    (moved.body.to(by), hits, velocities, sides, moved.flags, tilesat::motion::Work { features: 0, ..moved.work })
}

fn here(cell: Cell) -> (i32, i32) {
    (cell.x.into(), cell.y.into())
}

/// One motion in the world and in the room of each cut that has the body's position. Returns how
/// many differ.
fn differing<B: Guest>(
    map: &TileMap<'_, AllShapes>,
    cuts: &[Rooms<'_>],
    body: &B,
    v: Vec2,
    mover: &Mover,
) -> (u64, u64) {
    let place = body.position();
    let cell = map.cell().to_bits().into();
    if !body.is_free(map) || map.tile(map.cell_at(place)).is_none() {
        return (0, 0);
    }
    let moved = said(&mover.move_and_slide(map, body, v).unwrap(), Vec2::ZERO, here);
    let differs = |rooms: &&Rooms<'_>| {
        let corner = rooms.room(0, 0).unwrap();
        let room = rooms.next(&corner, place).map_or(corner, |(room, _)| room);
        let by = into(&room, cell);
        assert!(room.holds(place + by));
        let there = mover.move_and_slide(room.map(), &body.to(by), v);
        there.is_err() || moved != said(&there.unwrap(), -by, |cell| room.in_world(cell))
    };
    (cuts.iter().filter(differs).count() as u64, cuts.len() as u64)
}

/// Every position on the lattice of half cells, every velocity of a few, every cut into rooms of 1
/// x 1 to 3 x 3 cells. The apron is this many cells too small. Returns how many motions differ from
/// those in the world, and how many there were.
fn lattice(levels: u64, less: u16) -> (u64, u64) {
    let mut sum = (0, 0);
    for seed in 0..levels {
        let mut r = Random::new(seed);
        let (cell, dense) = (16 * PX, r.within(10, 70));
        let mut level = mosaic(&mut r, (8, 7), cell, dense, 8);
        level.outside = OUTSIDES[(seed % 3) as usize];
        let map = level.all();
        // Together as far as a cell, less, and more. The last ones as far as the apron allows.
        let (side, speed) = [(8, 8), (11, 4), (12, 12), (6, 25)][(seed % 4) as usize];
        let mover = Mover::platformer(Axis::NEG_Y).with_response(RESPONSES[(seed / 4 % 4) as usize]);
        let sizes = (1..=3).flat_map(|w| (1..=3).map(move |h| (w, h)));
        let cuts: Vec<_> = sizes.map(|size| cut(&level, size, apron(&level, side * PX, speed * PX) - less)).collect();
        for k in 0..16 * 14 {
            let at = (k % 16 * cell / 2 + (seed as i64 % 3 - 1), k / 16 * cell / 2);
            let square = Aabb::new(raw(at), raw((at.0 + side * PX, at.1 + side * PX))).unwrap();
            let disc = Circle::new(raw(at), fx(side * PX / 2)).unwrap();
            for v in [(5, 0), (0, 5), (-5, 0), (0, -5), (3, 4), (-3, 4), (4, -3), (-4, -3)] {
                let v = raw((v.0 * speed * PX / 5, v.1 * speed * PX / 5));
                let of = [differing(&map, &cuts, &square, v, &mover), differing(&map, &cuts, &disc, v, &mover)];
                sum = of.iter().fold(sum, |sum, of| (sum.0 + of.0, sum.1 + of.1));
            }
        }
    }
    sum
}

#[test]
fn every_border_on_a_lattice() {
    let (differ, all) = lattice(48, 0);
    assert!(differ == 0 && all > 500_000, "{differ} of {all}");
    // The apron is not wider than necessary.
    let (differ, all) = lattice(48, 1);
    assert!(differ > all / 1000, "{differ} of {all}");
}

/// The rooms of a world, however it is cut.
enum Cut<'a> {
    Equal(Rooms<'a>),
    Table(Vec<Room<'a>>),
}

impl<'a> Cut<'a> {
    fn next(&self, from: &Room<'a>, place: Vec2) -> Option<(Room<'a>, Vec2)> {
        match self {
            Self::Equal(rooms) => rooms.next(from, place),
            Self::Table(rooms) => from.next_of(rooms, place).map(|(room, by)| (*room, by)),
        }
    }
}

/// The tiles of a part of a level and of its apron. Beyond the level they are those of its outside.
fn copy(level: &Level, (x, y): P, (width, height): P, apron: i64) -> Vec<u8> {
    let beyond = if level.outside == Outside::Solid { BEYOND } else { 0 };
    let cells = (y - apron..y + height + apron).flat_map(|y| (x - apron..x + width + apron).map(move |x| (x, y)));
    let inside = |&(x, y): &P| (0..level.width).contains(&x) && (0..level.height).contains(&y);
    cells.map(|p| if inside(&p) { level.tiles[(p.1 * level.width + p.0) as usize] } else { beyond }).collect()
}

/// A level in rectangles of all sizes: cut across, and each part across the other way.
fn rectangles(r: &mut Random, level: &Level) -> Vec<(P, P)> {
    let mut parts = Vec::new();
    let mut x = 0;
    while x < level.width {
        let width = r.within(1, level.width - x);
        let mut y = 0;
        while y < level.height {
            let height = r.within(1, level.height - y);
            parts.push(((x, y), (width, height)));
            y += height;
        }
        x += width;
    }
    parts
}

/// A body in the world, and its copy in the rooms.
struct Pair<'a, B> {
    body: B,
    floor: Option<Support>,
    room: Room<'a>,
    double: B,
}

/// Frames of one body, walking or flying. Returns the number of crossings.
fn run<'a, B: Guest>(
    r: &mut Random,
    level: &'a Level,
    cut: &Cut<'a>,
    body: B,
    late: i64,
    fastest: i64,
    frames: u32,
) -> u32 {
    let map = level.all();
    let mut room = match cut {
        Cut::Equal(rooms) => rooms.room(0, 0).unwrap(),
        Cut::Table(rooms) => rooms[0],
    };
    if let Some((next, _)) = cut.next(&room, body.position() + into(&room, level.cell)) {
        room = next;
    }
    let mut pair = Pair { body, floor: None, room, double: body.to(into(&room, level.cell)) };
    let mover = Mover::platformer(Axis::NEG_Y).with_response(RESPONSES[[0, 0, 0, 1, 2, 3][r.below(6) as usize]]);
    // A walker's step and snap are a part of its motion.
    let walks = r.one_in(2);
    let share = if walks { fastest / 4 } else { 0 };
    let walker = Walker::new(mover).with_snap(fx(share)).unwrap().with_step(fx(share)).unwrap();
    let limit = fastest - 2 * share;
    let (mut v, mut over) = ((0, 0), 0);
    for frame in 0..frames {
        v.1 += PX / 4;
        if r.one_in(12) || v == (0, PX / 4) {
            v = any_velocity(r, (limit / PX).max(1));
        }
        while len2(v) > i128::from(limit).pow(2) {
            v = (v.0 * 3 / 4, v.1 * 3 / 4);
        }
        let by = into(&pair.room, level.cell);
        let (moved, there) = if walks {
            let walked = walker.walk(&map, &pair.body, raw(v), pair.floor).unwrap();
            let there = walker.walk(pair.room.map(), &pair.double, raw(v), pair.floor).unwrap();
            let of = |walked: &tilesat::Walked<B>| {
                (walked.floor.map(|f| (f.axis, f.index, f.flags)), walked.stepped, walked.snapped)
            };
            assert_eq!(of(&walked), of(&there), "frame {frame}");
            pair.floor = walked.floor;
            (walked.moved, there.moved)
        } else {
            let moved = |world: &TileMap<'_, AllShapes>, body| -> Result<_, MoveError> {
                mover.move_and_slide(world, body, raw(v))
            };
            (moved(&map, &pair.body).unwrap(), moved(pair.room.map(), &pair.double).unwrap())
        };
        // A map has one name for everything beyond it.
        let last = |cell: (i32, i32)| (cell.0.clamp(-1, level.width as i32), cell.1.clamp(-1, level.height as i32));
        let (expected, seen) =
            (said(&moved, Vec2::ZERO, here), said(&there, -by, |cell| last(pair.room.in_world(cell))));
        assert_eq!(seen, expected, "frame {frame}: {:?} by {v:?} in {:?} of {level:?}", pair.body, pair.room.first());
        (pair.body, pair.double, v) =
            (moved.body, there.body, (moved.velocity.raw().0.into(), moved.velocity.raw().1.into()));

        // Crosses at the border, or up to this many cells late.
        let place = pair.double.position();
        let near = |side: Vec2| pair.room.holds(place + side);
        let slack = late * level.cell;
        let must = ![(slack, 0), (-slack, 0), (0, slack), (0, -slack)].iter().any(|&side| near(raw(side)));
        if !pair.room.holds(place) && (must || r.one_in(3)) {
            let Some((next, by)) = cut.next(&pair.room, place) else { break };
            (pair.room, pair.double, over) = (next, pair.double.to(by), over + 1);
        }
    }
    over
}

#[test]
fn bodies_run_over_the_borders() {
    let mut over = [0, 0];
    for seed in 0..tilesat_judge::cases(3000) {
        let r = &mut Random::new(seed);
        let cell = [16 * PX, 24 * PX, 2 * 7 * 64 * r.within(100, 900)][r.below(3) as usize];
        let (dense, one_way) = (r.within(5, 45), if r.one_in(2) { 0 } else { 8 });
        let mut level = mosaic(r, (16, 12), cell, dense, one_way);
        level.outside = OUTSIDES[r.below(3) as usize];
        let fastest = 4 * PX + r.below(2 * cell);
        let size = [cell, cell / 2, 2 + r.below(2 * cell)][r.below(3) as usize] & !1;
        let late = r.below(3);
        let apron = apron(&level, size, fastest) + late as u16;
        let tables: Vec<_> = rectangles(r, &level)
            .iter()
            .map(|&(first, size)| (first, size, copy(&level, first, size, apron.into())))
            .collect();
        let table = level.outside != Outside::Edge && r.one_in(2);
        let cut = if table {
            Cut::Table(tables.iter().map(|(first, size, tiles)| placed(&level, *first, *size, apron, tiles)).collect())
        } else {
            Cut::Equal(cut(&level, (r.within(1, 9) as u16, r.within(1, 9) as u16), apron))
        };
        for _ in 0..4 {
            let at = (r.below(level.width * cell), r.below(level.height * cell));
            let square = Aabb::new(raw(at), raw((at.0 + size, at.1 + size))).unwrap();
            let disc = Circle::new(raw(at), fx(size / 2)).unwrap();
            let map = level.all();
            over[usize::from(table)] += match r.one_in(2) {
                true if square.is_free(&map) => run(r, &level, &cut, square, late, fastest, 200),
                false if disc.is_free(&map) => run(r, &level, &cut, disc, late, fastest, 200),
                _ => 0,
            };
        }
    }
    assert!(over.iter().all(|&over| over > 5000), "{over:?}");
}

fn placed<'a>(level: &Level, first: P, size: P, apron: u16, tiles: &'a [u8]) -> Room<'a> {
    let wide = |cells: i64| cells as u16 + 2 * apron;
    let grid = Grid::new(wide(size.0), wide(size.1), fx(level.cell), Vec2::ZERO).unwrap();
    let map = TileMap::of(tiles, grid, &WITH_BEYOND).unwrap().with_outside(level.outside);
    Room::new(map, first.0 as i32, first.1 as i32, apron).unwrap()
}
