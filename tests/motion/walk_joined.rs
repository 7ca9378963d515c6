//! Walking from a floor of tiles to a floor of segments and back. At no phase and no speed does a
//! flush joint change height or speed.

use tilesat::{
    Aabb, Axis, Circle, Fx, Grid, Joined, Mover, PathKind, SegmentMap, TileKind, TileKinds, TileMap, Vec2, World,
};
use tilesat_judge::segments::{P, Scene, Shape};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// In raw units.
const CELL: i128 = 16 << 16;

/// The scene is seen with the floor below; it is built turned.
#[derive(Clone, Copy, Debug)]
struct Turn {
    quarter: u8,
    mirror: bool,
}

impl Turn {
    fn of(self, p: P) -> P {
        let p = if self.mirror { (-p.0, p.1) } else { p };
        match self.quarter {
            0 => p,
            1 => (-p.1, p.0),
            2 => (-p.0, -p.1),
            _ => (p.1, -p.0),
        }
    }

    fn back(self, p: P) -> P {
        let p = match self.quarter {
            0 => p,
            1 => (p.1, -p.0),
            2 => (-p.0, -p.1),
            _ => (-p.1, p.0),
        };
        if self.mirror { (-p.0, p.1) } else { p }
    }

    fn axis(self, a: (i32, i32)) -> Axis {
        let p = self.of((i128::from(a.0), i128::from(a.1)));
        Axis::new(p.0 as i32, p.1 as i32)
    }
}

fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

fn point(v: Vec2) -> P {
    (i128::from(v.raw().0), i128::from(v.raw().1))
}

/// The level after the tiles, whose floor is at height 0 from -8 cells to 0: a polygon or chain
/// with its top at the same height. Also whether the tiles can be a polygon of the same map. A
/// slope inside another polygon is still a face there. A circle that it stops up to a raw unit
/// early would be stopped by it before the floor.
fn ground(random: &mut Random) -> (bool, Vec<Shape>) {
    let c = CELL;
    let deep = [c, c / 2, 3 * c, 37][random.below(4) as usize];
    let solid = |points: Vec<P>| Shape { kind: PathKind::Solid, flags: 0, points };
    let wide = 8 * c;
    let shapes = match random.below(6) {
        0 => vec![solid(vec![(0, 0), (wide, 0), (wide, deep), (0, deep)])],
        // Into the tiles' solid.
        1 => vec![solid(vec![(-c / 3, 0), (wide, 0), (wide, deep), (-c / 3, deep)])],
        // In two polygons, the second one a triangle on its tip.
        2 => vec![
            solid(vec![(0, 0), (c + 5, 0), (c + 5, deep), (0, deep)]),
            solid(vec![(c + 5, 0), (wide, 0), (c + 5, deep)]),
        ],
        3 => vec![Shape { kind: PathKind::Wall, flags: 0, points: vec![(0, 0), (c / 7, 0), (wide, 0)] }],
        // A slope that starts below the tiles' floor and comes up into it.
        4 => return (false, vec![solid(vec![(-c, deep), (0, 0), (wide, 0), (wide, deep)])]),
        _ => vec![
            solid(vec![(0, 0), (wide, 0), (wide, deep), (0, 2 * deep)]),
            solid(vec![(0, deep), (-c, c), (c, 3 * c)]),
        ],
    };
    (true, shapes)
}

struct Walk<'a, W> {
    world: &'a W,
    turn: Turn,
    mover: Mover,
    case: &'a str,
}

/// The position of a body: its lowest corner in the turned scene, or its centre.
trait Place: tilesat::Body + Copy + std::fmt::Debug {
    fn at(p: P, size: P, turn: Turn) -> Self;
    fn place(&self, turn: Turn) -> P;
}

impl Place for Aabb {
    fn at(p: P, size: P, turn: Turn) -> Self {
        let (a, b) = (turn.of(p), turn.of((p.0 + size.0, p.1 - size.1)));
        Self::new(vec2((a.0.min(b.0), a.1.min(b.1))), vec2((a.0.max(b.0), a.1.max(b.1)))).unwrap()
    }

    fn place(&self, turn: Turn) -> P {
        let (a, b) = (turn.back(point(self.min())), turn.back(point(self.max())));
        (a.0.min(b.0), a.1.max(b.1))
    }
}

impl Place for Circle {
    fn at(p: P, size: P, turn: Turn) -> Self {
        Self::new(vec2(turn.of((p.0, p.1 - size.1))), Fx::from_bits(size.1 as i32)).unwrap()
    }

    fn place(&self, turn: Turn) -> P {
        let c = turn.back(point(self.centre()));
        (c.0, c.1 + i128::from(self.radius().to_bits()))
    }
}

impl<W: World> Walk<'_, W> {
    /// Walks over the joint with gravity pressing, or along without it.
    fn walk<B: Place>(&self, from: P, size: P, speed: i128, gravity: i128) {
        let mut body = B::at(from, size, self.turn);
        for step in 0..40 {
            let v = vec2(self.turn.of((speed, gravity)));
            let moved = self.mover.move_and_slide(self.world, &body, v).unwrap();
            let (place, velocity) = (moved.body.place(self.turn), self.turn.back(point(moved.velocity)));
            let case = || format!("{} {body:?} step {step} by {speed}, {gravity}: {moved:?}", self.case);
            assert_eq!(place, (from.0 + speed * (step + 1), 0), "{}", case());
            assert_eq!(velocity, (speed, 0), "{}", case());
            let up = self.turn.axis((0, -1));
            assert!(moved.hits.iter().all(|h| h.axis == up) && moved.floor == (gravity > 0), "{}", case());
            body = moved.body;
            if place.0.abs() > 6 * CELL {
                break;
            }
        }
    }

    /// Lands near the joint from above: only on the floor.
    fn land<B: Place>(&self, from: P, size: P, v: P) {
        let body = B::at(from, size, self.turn);
        let moved = self.mover.move_and_slide(self.world, &body, vec2(self.turn.of(v))).unwrap();
        let case = || format!("{} {body:?} by {v:?}: {moved:?}", self.case);
        assert_eq!(moved.body.place(self.turn), (from.0 + v.0, 0), "{}", case());
        assert_eq!(self.turn.back(point(moved.velocity)), (v.0, 0), "{}", case());
        assert!(moved.hits.iter().all(|h| h.axis == self.turn.axis((0, -1))) && moved.floor, "{}", case());
    }

    fn all(&self, random: &mut Random) {
        for _ in 0..6 {
            let size = (i128::from(random.within(1, 20 << 16)), i128::from(random.within(1, 12 << 16)));
            let speed = random.sign() as i128
                * [1, 3 << 15, 3 << 16, 16 << 16, 61 << 16, i128::from(random.within(1, 40 << 16))]
                    [random.below(6) as usize];
            let gravity = [0, 1, 1 << 14, 3 << 16][random.below(4) as usize];
            let phase = i128::from(random.below(1 << 16));
            // From far, or so near that it reaches the joint with every remainder.
            let far = if random.one_in(2) { 3 * CELL + phase } else { i128::from(random.within(-3, 3)) };
            let from = (-speed.signum() * far, 0);
            self.walk::<Aabb>(from, size, speed, gravity);
            self.walk::<Circle>(from, size, speed, gravity);
            let height = i128::from(random.magnitude(2 << 16)) + 1;
            let v = (i128::from(random.around(1 << 18)), height + i128::from(random.within(1, 1 << 18)));
            let from = (i128::from(random.around(4)) - v.0 * i128::from(random.within(0, 2)) / 2, -height);
            self.land::<Aabb>(from, size, v);
            self.land::<Circle>(from, size, v);
        }
    }
}

#[test]
fn a_flush_joint_is_no_joint() {
    let mut random = Random::new(51);
    for _ in 0..cases(tilesat_judge::thorough(400, 1_000)) {
        let turn = Turn { quarter: random.below(4) as u8, mirror: random.one_in(2) };
        let (in_one, mut shapes) = ground(&mut random);
        // The same in one map: the tiles as a polygon.
        let fine = 1 + random.below(2) as i128;
        let rows = fine * i128::from(random.within(1, 2));
        let depth = rows * CELL / fine;
        let mut all = shapes.clone();
        let tiles = vec![(-8 * CELL, 0), (0, 0), (0, depth), (-8 * CELL, depth)];
        all.insert(0, Shape { kind: PathKind::Solid, flags: 0, points: tiles });
        for p in all.iter_mut().flat_map(|s| s.points.iter_mut()) {
            *p = turn.of(*p);
        }
        for p in shapes.iter_mut().flat_map(|s| s.points.iter_mut()) {
            *p = turn.of(*p);
        }
        let cell = [8 << 16, 16 << 16, 24 << 16, 1_000_002][random.below(4) as usize];
        let scene = Scene { shapes, origin: (0, 0), cell, grid: None };
        let bytes = scene.bytes();
        let segments = SegmentMap::from_bytes(&bytes).unwrap();
        // Eight columns of tiles, one or two rows deep, of cells or half cells.
        let columns = 8 * fine;
        let (a, b) = (turn.of((-8 * CELL, 0)), turn.of((0, depth)));
        let size = ((a.0 - b.0).abs() * fine / CELL, (a.1 - b.1).abs() * fine / CELL);
        assert_eq!(size.0 * size.1, columns * rows);
        let tiles = vec![1; (size.0 * size.1) as usize];
        let first = vec2((a.0.min(b.0), a.1.min(b.1)));
        let grid = Grid::new(size.0 as u16, size.1 as u16, Fx::from_bits((CELL / fine) as i32), first).unwrap();
        let map = TileMap::on_grid(&tiles, grid, &KINDS).unwrap();
        let mover = Mover::platformer(turn.axis((0, -1)));
        let case = format!("{scene:?} {turn:?} {fine} {rows}");
        let (one, other) = (Joined::new(&map, &segments), Joined::new(&segments, &map));
        Walk { world: &one, turn, mover, case: &case }.all(&mut random);
        Walk { world: &other, turn, mover, case: &case }.all(&mut random);
        if in_one {
            let bytes = Scene { shapes: all, origin: (0, 0), cell, grid: None }.bytes();
            Walk { world: &SegmentMap::from_bytes(&bytes).unwrap(), turn, mover, case: &case }.all(&mut random);
        }
    }
}
