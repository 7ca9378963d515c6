//! Rays and segments that walk through grids: P21, P22, P25.

use super::config;
use proptest::prelude::*;
use tilesat::{Axis, Cell, Fx, Grid, Inside, Mover, TileKind, TileKinds, TileMap, world::RayRules};
use tilesat_judge::Random;
use tilesat_judge::paths::level::{level, placed, shape};
use tilesat_judge::paths::oracle::check_refs;
use tilesat_judge::rooms::body::{Body, vec2};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{PX, mosaic};

type P = (i64, i64);

static LEFT: TileKinds = TileKinds::EMPTY.with(0, TileKind::of(tilesat::TileShape::OneWayLeft));
static RIGHT: TileKinds = TileKinds::EMPTY.with(0, TileKind::of(tilesat::TileShape::OneWayRight));
static UP: TileKinds = TileKinds::EMPTY.with(0, TileKind::of(tilesat::TileShape::OneWayUp));
static DOWN: TileKinds = TileKinds::EMPTY.with(0, TileKind::of(tilesat::TileShape::OneWayDown));

/// A grid of 12 x 12 cells at an origin, and numbers on, beside and between its lines.
#[derive(Clone, Copy, Debug)]
struct Lattice {
    cell: i64,
    origin: P,
}

const SIDE: i64 = 12;

fn grids() -> impl Strategy<Value = Lattice> {
    let cell = prop::sample::select(&[256i64, 258, 896, 16 << 16, (1 << 24) - 2][..]);
    let origin = || prop_oneof![Just(0i64), -40_000i64..40_000, Just(1 - (1 << 29)), Just(-16 << 16)];
    (cell, origin(), origin()).prop_map(|(cell, x, y)| Lattice { cell, origin: (x, y) })
}

/// Quarters of a cell and up to 2 raw beside them, within the grid.
fn place() -> impl Strategy<Value = (i64, i64)> {
    (0i64..=4 * SIDE, prop_oneof![Just(0i64), -2i64..=2])
}

impl Lattice {
    fn at(&self, (x, y): ((i64, i64), (i64, i64))) -> P {
        let on = |(k, off): (i64, i64), origin: i64| origin + (k * self.cell / 4 + off).clamp(0, SIDE * self.cell);
        (on(x, self.origin.0), on(y, self.origin.1))
    }
}

/// The moments and cells at which a ray crosses the lines of one axis: 2^-30 parts rounded down,
/// and the cell beyond the line along the axis. Across it, one cell, or two on a line of the other
/// axis.
fn crossings(
    g: &Lattice,
    (o, across): (i64, i64),
    (d, along): (i64, i64),
    (o0, a0): (i64, i64),
) -> Vec<(u32, i64, Vec<i64>)> {
    let lines = (0..=SIDE).map(|k| o0 + k * g.cell);
    // A ray meets a one-way edge from in front of it or from on it.
    let mut found: Vec<_> = lines
        .filter(|&line| (line - o) * d.signum() >= 0 && (line - o).abs() <= d.abs())
        .map(|line| {
            let (num, den) = (i128::from((line - o).abs()), i128::from(d.abs()));
            let toi = ((num << 30) / den) as u32;
            let cell = if d > 0 { (line - o0) / g.cell } else { (line - o0) / g.cell - 1 };
            // Its position across then, times den.
            let at = i128::from(across - a0) * den + i128::from(along) * num;
            let size = i128::from(g.cell) * den;
            let first = at.div_euclid(size) as i64;
            let others = if at.rem_euclid(size) == 0 { vec![first - 1, first] } else { vec![first] };
            (toi, cell, others)
        })
        .filter(|(_, cell, others)| (0..SIDE).contains(cell) && others.iter().any(|c| (0..SIDE).contains(c)))
        .collect();
    if d < 0 {
        found.reverse();
    }
    found
}

proptest! {
    #![proptest_config(config(1))]

    /// A level of only edges toward one side reports each line that a ray crosses, and the cell
    /// beyond: exactly those of the definition, in order.
    #[test]
    fn p21_walked_cells(g in grids(), from in (place(), place()), to in (place(), place())) {
        let (o, e) = (g.at(from), g.at(to));
        let d = (e.0 - o.0, e.1 - o.1);
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(g.cell as i32), vec2(g.origin)).unwrap();
        let tiles = [0u8; (SIDE * SIDE) as usize];
        let rules = RayRules { inside: Inside::Ignore, one_way: true };
        for by_x in [true, false] {
            let speed = if by_x { d.0 } else { d.1 };
            if speed == 0 {
                continue;
            }
            let kinds = match (by_x, speed > 0) {
                (true, true) => &LEFT,
                (true, false) => &RIGHT,
                (false, true) => &UP,
                (false, false) => &DOWN,
            };
            let map = TileMap::<tilesat::AllShapes>::of(&tiles, grid, kinds).unwrap();
            let hits = map.cast_ray_all(vec2(o), vec2(d), rules).unwrap();
            let of = |c: Cell| if by_x { (i64::from(c.x), i64::from(c.y)) } else { (i64::from(c.y), i64::from(c.x)) };
            let seen: Vec<_> = hits.map(|h| (h.toi.raw(), of(h.cell))).collect();
            let flip = |p: P| if by_x { p } else { (p.1, p.0) };
            let expected = crossings(&g, flip(o), flip(d), flip(g.origin));
            prop_assert_eq!(seen.len(), expected.len(), "{:?} {:?}", seen, expected);
            for (seen, (toi, cell, across)) in seen.iter().zip(&expected) {
                prop_assert_eq!((seen.0, seen.1.0), (*toi, *cell), "{:?}", expected);
                prop_assert!(across.contains(&seen.1.1), "{seen:?}, not one of {across:?}");
            }
        }
    }

    /// Every cell whose closed square a segment meets lists it, and no other does.
    #[test]
    fn p22_rasterised_cells(g in grids(), from in (place(), place()), to in (place(), place())) {
        let (a, b) = (g.at(from), g.at(to));
        if a != b {
            check_refs(&level(&placed(&[shape(tilesat::PathKind::Wall, &[a, b])], 1, (0, 0)), g.cell));
        }
    }

    /// The work of a call: at most four sweeps, and at most the features of the cells under the
    /// motion.
    #[test]
    fn p25_bounded_work(seed in any::<u64>(), fast in 0i64..=2000, x in -8i64..=8, y in -8i64..=8, round in any::<bool>()) {
        let mut r = Random::new(seed);
        let cell = 16 * PX;
        let level = mosaic(&mut r, (16, 12), cell, 70, 10);
        let room = Room::new(&level);
        let size = r.within(2, 3 * cell);
        let kind = if round { Body::Disc((0, 0), size / 2) } else { Body::Rect((0, 0), (size, r.within(2, 3 * cell))) };
        let free = (0..60)
            .map(|_| kind.at((r.below(16 * cell), r.below(12 * cell))))
            .find(|b| !room.overlaps(*b, (0, 0), 0));
        if let Some(body) = free {
            let v = (x * fast * PX / 8, y * fast * PX / 8);
            let out = body.step(&Mover::platformer(Axis::NEG_Y), &level.all(), v).unwrap();
            prop_assert!(out.work.iterations <= Mover::ITERATIONS && out.hits.len() as u32 <= out.work.iterations);
            // Cells under the box around the whole motion and one ring. No cell has more than eight
            // faces, corners and arcs. The search for a position looks at up to nine, twice for
            // each sweep.
            let (lo, hi) = body.bounds();
            let cells = |lo: i64, hi: i64, d: i64| (hi - lo + d.abs()) / cell + 4;
            let most = cells(lo.0, hi.0, v.0) * cells(lo.1, hi.1, v.1) * 8 * i64::from(Mover::ITERATIONS);
            prop_assert!(i64::from(out.work.features) <= most, "{:?}, at most {most}", out.work);
            prop_assert!(out.work.checks <= 18 * Mover::ITERATIONS + 2, "{:?}", out.work);
        }
    }
}
