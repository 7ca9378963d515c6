//! Bodies without area at the ends of quarter arcs: no way of theirs enters the solid, and only
//! solid stops them.
//!
//! The inequalities of the 34 shapes in whole numbers judge them, cut at every line of the grid. A
//! way enters the union of the tiles if it enters the inside of one of them, or runs along a line
//! between two that both contain it.

use core::fmt::Debug;
use tilesat::motion::Body as Movable;
use tilesat::prelude::Overlaps;
use tilesat::{Aabb, AllShapes, Axis, Circle, Fx, Inside, Mover, Outside, Response, TileMap, Vec2, motion::BodyHit};
use tilesat_judge::Random;
use tilesat_judge::rooms::P;
use tilesat_judge::rooms::body::{point, vec2};
use tilesat_judge::shapes::level::Level;

/// The side of a cell, and the point where the four cells of a case meet.
const S: i64 = 256;

/// A shape's inequality in the frame of its solid corner, coordinates and the side in parts of a
/// raw unit: below 0 inside.
fn excess(id: u8, p: (i128, i128), s: i128) -> i128 {
    let (group, turn) = if id < 2 { (9, 0) } else { ((id - 2) / 4, (id - 2) % 4) };
    let (right, bottom) = (turn == 1 || turn == 2, turn >= 2);
    let (u, v) = (if right { s - p.0 } else { p.0 }, if bottom { s - p.1 } else { p.1 });
    match group {
        0 if turn % 2 == 0 => 2 * v - s,
        0 => 2 * u - s,
        1 => u + v - s,
        2 => u * u + v * v - s * s,
        3 => s * s - (s - u).pow(2) - (s - v).pow(2),
        4 => u + 2 * v - s,
        5 => u + 2 * v - 2 * s,
        6 => 2 * u + v - s,
        7 => 2 * u + v - 2 * s,
        _ => 1 - 2 * i128::from(id),
    }
}

/// The whole of a way, in the units of a moment.
const ALL: u32 = 1 << 30;

/// Whether the way of a point from `p` by `d`, up to a moment of it, enters the solid of the four
/// cells around (S, S). All other cells are empty.
fn enters(tiles: [u8; 4], p: P, d: P, until: u32) -> bool {
    // Moments are fractions of the way with one divisor, of which all crossings of lines are
    // multiples.
    let n = i128::from(d.0.abs().max(1) * d.1.abs().max(1)) * 16;
    let at = |t: i128| (i128::from(p.0) * n + i128::from(d.0) * t, i128::from(p.1) * n + i128::from(d.1) * t);
    let half = i128::from(S / 2) * n;
    let end = ((n * i128::from(until)) >> 30) & !3;
    let mut cuts = vec![0, end];
    for k in 0..=4 {
        for (x, d) in [(p.0, d.0), (p.1, d.1)] {
            if d != 0 {
                cuts.push((half * k - i128::from(x) * n) / i128::from(d));
            }
        }
    }
    cuts.retain(|t| (0..=end).contains(t));
    cuts.sort_unstable();
    cuts.windows(2).filter(|c| c[0] < c[1]).any(|c| {
        let middle = (i128::midpoint(at(c[0]).0, at(c[1]).0), i128::midpoint(at(c[0]).1, at(c[1]).1));
        let beside = |x: i128| [x - 1, x + 1].map(|x| x.div_euclid(2 * half));
        let (columns, rows) = (beside(middle.0), beside(middle.1));
        // One cell, or the two beside a line of the grid.
        rows.iter().all(|&row| {
            columns.iter().all(|&column| {
                if !(0..2).contains(&row) || !(0..2).contains(&column) {
                    return false;
                }
                let id = tiles[(2 * row + column) as usize];
                let inside = |q: (i128, i128)| excess(id, (q.0 - column * 2 * half, q.1 - row * 2 * half), 2 * half);
                // On a line the ends are deepest, even of a concave arc.
                inside(at(c[0])) < 0
                    || inside(at(c[1])) < 0
                    || ((10..14).contains(&id) && cuts_disc(id, (column, row), 2 * half, at(c[0]), at(c[1])))
            })
        })
    })
}

/// Whether the way from `a` to `b` passes inside of the disc of a convex arc between its ends.
fn cuts_disc(id: u8, (column, row): (i128, i128), s: i128, a: (i128, i128), b: (i128, i128)) -> bool {
    let turn = id - 10;
    let centre = ((column + i128::from(turn == 1 || turn == 2)) * s, (row + i128::from(turn >= 2)) * s);
    let (m, e) = ((a.0 - centre.0, a.1 - centre.1), (b.0 - a.0, b.1 - a.1));
    let (dot, length) = (-(m.0 * e.0 + m.1 * e.1), e.0 * e.0 + e.1 * e.1);
    let cross = m.0 * e.1 - m.1 * e.0;
    let big = |v: i128| num_bigint::BigInt::from(v);
    0 < dot && dot < length && big(cross).pow(2) < big(s).pow(2) * length
}

fn level(tiles: [u8; 4], (x, y): P) -> Level {
    Level { tiles: tiles.into(), width: 2, height: 2, cell: S, x, y, outside: Outside::Empty }
}

/// Whether one of the four cells has a convex arc that ends in their common point.
fn has_end(tiles: [u8; 4]) -> bool {
    // For the cell at the top left that point is the bottom right corner. An arc ends in the two
    // corners beside its solid one.
    tiles.iter().zip([[11, 13], [10, 12], [10, 12], [11, 13]]).any(|(id, ends)| ends.contains(id))
}

#[derive(Debug, Default)]
struct Tally {
    cases: u64,
    hits: u64,
    free: u64,
    grazes: u64,
    /// The test skips starts in the solid.
    inside: u64,
}

struct Case<'a> {
    tiles: [u8; 4],
    by: P,
    map: TileMap<'a, AllShapes>,
    tally: &'a mut Tally,
}

impl Case<'_> {
    /// The result for a body whose first point is at `front` and whose last one is at `back`.
    fn judge<B>(&mut self, body: &B, back: P, front: P, d: P)
    where
        B: Movable + Debug + PartialEq,
        for<'a> TileMap<'a, AllShapes>: Overlaps<B>,
    {
        let (map, by) = (&self.map, self.by);
        let found = map.cast_shape(body, vec2(d), Inside::Hit).unwrap();
        let case = || format!("{:?} at {by:?}: {front:?} by {d:?}: {found:?}", self.tiles);
        let made = |to: &B| {
            let (to, from) = (point(to.position()), point(body.position()));
            (to.0 - from.0, to.1 - from.1)
        };
        let whole = (front.0 - back.0 + d.0, front.1 - back.1 + d.1);
        self.tally.cases += 1;
        match &found {
            None => assert!(!enters(self.tiles, back, whole, ALL), "passes: {}", case()),
            Some(BodyHit { body: at, hit, inside: false, .. }) => {
                let askew = d.0 != 0 && d.1 != 0;
                let made = if askew { d } else { made(at) };
                let way = (front.0 - back.0 + made.0, front.1 - back.1 + made.1);
                let until = if askew { hit.toi.raw() } else { ALL };
                assert!(!enters(self.tiles, back, way, until), "is inside: {}", case());
                // The way out of the end of a quarter pipe is a tangent.
                assert!(hit.axis.dot(Axis::new(d.0 as i32, d.1 as i32)) <= 0, "does not oppose: {}", case());
                self.tally.hits += 1;
                // An acute corner stops a body without area that only grazes it.
                self.tally.grazes += u64::from(!enters(self.tiles, back, whole, ALL));
            }
            Some(_) => {
                self.tally.inside += 1;
                return;
            }
        }
        self.tally.free += u64::from(found.is_none());
        if !self.tally.cases.is_multiple_of(4) {
            return;
        }
        let touch = Mover::new().with_response(Response::Touch).move_and_slide(map, body, vec2(d)).unwrap();
        let end = found.map_or(d, |hit| made(&hit.body));
        assert_eq!((made(&touch.body), touch.hits.first()), (end, found.map(|hit| hit.hit)), "{}", case());
        let slid = Mover::new().move_and_slide(map, body, vec2(d)).unwrap();
        assert_eq!(slid.hits.first(), touch.hits.first(), "{}", case());
        assert!(!map.overlaps(&slid.body), "ends inside: {}", case());
    }

    fn disc(&mut self, p: P, d: P) {
        let at = (p.0 + self.by.0, p.1 + self.by.1);
        self.judge(&Circle::new(vec2(at), Fx::ZERO).unwrap(), p, p, d);
    }

    /// A box of the given length along a motion along x or y, and none across it.
    fn bar(&mut self, p: P, d: P, length: i64) {
        let back = (p.0 - d.0.signum() * length, p.1 - d.1.signum() * length);
        let corner = |p: P, q: P| (p.0.min(q.0) + self.by.0, p.1.min(q.1) + self.by.1);
        let far = |p: P, q: P| (p.0.max(q.0) + self.by.0, p.1.max(q.1) + self.by.1);
        let body = Aabb::new(vec2(corner(p, back)), vec2(far(p, back))).unwrap();
        self.judge(&body, back, p, d);
    }
}

const WAYS: [P; 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

/// One of 43 of the 287 760 quads of tiles with such an end in their middle, or all.
#[test]
fn along_the_lines_of_the_grid() {
    along_the_lines(tilesat_judge::thorough(43, 1));
}

/// Points and bars along the four lines through the middle, from both sides, to it and beyond.
fn along_the_lines(step: usize) {
    let mut tally = Tally::default();
    for code in (0..34u32.pow(4)).step_by(step) {
        let tiles = [0, 1, 2, 3].map(|k| (code / 34u32.pow(k) % 34) as u8);
        if !has_end(tiles) {
            continue;
        }
        let far = if code % 3 == 0 { (i64::from(code) - 500_000, 1_048_576 - i64::from(code)) } else { (0, 0) };
        let level = level(tiles, far);
        let mut case = Case { tiles, by: far, map: level.all(), tally: &mut tally };
        for way in WAYS {
            let at = |k: i64| (S + way.0 * k, S + way.1 * k);
            for (from, to) in [(-S, 2 * S), (-7, 1), (0, S / 2)] {
                let (p, d) = (at(from), (way.0 * (to - from), way.1 * (to - from)));
                case.disc(p, d);
                case.bar(p, d, 5);
            }
        }
    }
    println!("{tally:?}");
    let least = 1_000_000 / step as u64;
    assert!(tally.hits > least && tally.free > least && tally.inside > 0, "{tally:?}");
}

/// One of 25 of the ways, or all.
#[test]
fn from_everywhere_to_everywhere() {
    everywhere(tilesat_judge::thorough(25, 1));
}

/// Each arc tile that ends there with each neighbour in each of the three other cells, the rest
/// empty or full. Points from all positions of a lattice of quarter cells to all of one of half
/// cells.
fn everywhere(step: usize) {
    let (mut tally, mut first) = (Tally::default(), 0);
    for (place, id) in (0..4).flat_map(|place| (10..14).map(move |id| (place, id))) {
        for (other, neighbour, rest) in (0..4).flat_map(|o| (0..34).flat_map(move |n| (0..4).map(move |r| (o, n, r)))) {
            let mut tiles = [rest & 1; 4];
            tiles[(place + 1) % 4] = rest >> 1;
            (tiles[place], tiles[other]) = (id, neighbour);
            if place == other || !has_end(tiles) {
                continue;
            }
            let level = level(tiles, (0, 0));
            let mut case = Case { tiles, by: (0, 0), map: level.all(), tally: &mut tally };
            // Other ways for each quad.
            first = (first + 1) % step;
            for k in (0..81 * 25).skip(first).step_by(step) {
                let at = |k: i64, n: i64| (2 * S / (n - 1) * (k % n), 2 * S / (n - 1) * (k / n));
                let (p, q) = (at(k / 25, 9), at(k % 25, 5));
                if p != q {
                    case.disc(p, (q.0 - p.0, q.1 - p.1));
                }
            }
        }
    }
    println!("{tally:?}");
    let least = 1_000_000 / step as u64;
    assert!(tally.hits > least && tally.free > least && tally.inside > 0, "{tally:?}");
}

/// Full cells beside an arc that are outside the map instead of tiles.
#[test]
fn at_the_end_of_the_map() {
    for (id, neighbour) in (10..14).flat_map(|id| (0..34).map(move |n| (id, n))) {
        for tiles in [[id, neighbour], [neighbour, id]] {
            let all = level([1, tiles[0], 1, tiles[1]], (0, 0));
            let cut = Level { width: 1, x: S, outside: Outside::Solid, tiles: tiles.into(), ..all.clone() };
            for (from, length) in [(1, 2 * S - 2), (S - 1, 2), (S + 1, -2), (2 * S - 1, 2 - 2 * S)] {
                let (point, d) = (Circle::new(vec2((S, from)), Fx::ZERO).unwrap(), vec2((0, length)));
                let cast = |level: &Level| level.all().cast_shape(&point, d, Inside::Hit).unwrap();
                let told = |level: &Level| cast(level).map(|hit| (hit.body, hit.hit.toi, hit.hit.axis, hit.inside));
                assert_eq!(told(&cut), told(&all), "{tiles:?} from {from} by {length}");
            }
        }
    }
}

/// Points and bars on the lines of small maps, many of them along the outside. No cast misses a
/// solid in which it would end, and no motion ends in the solid.
#[test]
fn no_end_is_in_the_solid() {
    let (mut r, mut moved) = (Random::new(3), 0);
    for room in 0..3000 {
        let tiles = (0..9).map(|_| r.below(34) as u8).collect();
        let outside = [Outside::Solid, Outside::Edge, Outside::Empty][room % 3];
        let level = Level { width: 3, height: 3, x: 0, y: 0, outside, tiles, ..level([0; 4], (0, 0)) };
        let map = level.all();
        for _ in 0..60 {
            let place = |r: &mut Random| r.below(7) * S / 2;
            let (p, long) = ((place(&mut r), place(&mut r)), r.below(2) * r.below(S));
            let bar = if r.one_in(2) { (long, 0) } else { (0, long) };
            let body = Aabb::new(vec2(p), vec2((p.0 + bar.0, p.1 + bar.1))).unwrap();
            let d = (r.around(2) * r.below(2 * S), r.around(2) * r.below(2 * S));
            if map.overlaps(&body) {
                continue;
            }
            let case = || format!("{body:?} by {d:?}\n{level:?}");
            let whole = Aabb::new(body.min() + vec2(d), body.max() + vec2(d)).unwrap();
            let missed = map.cast_shape(&body, vec2(d), Inside::Hit).unwrap().is_none();
            assert!(!missed || !map.overlaps(&whole), "passes: {}", case());
            let end = Mover::new().move_and_slide(&map, &body, vec2(d)).unwrap().body;
            assert!(!map.overlaps(&end), "ends inside: {}", case());
            moved += u32::from(end != body);
        }
    }
    println!("{moved} moved");
    assert!(moved > 30_000, "{moved}");
}

/// Out of the gap below an arc into a quarter pipe that begins where the gap ends: the point meets
/// the pipe. The way up the pipe only grazes the end of the arc, which stops a body without area.
/// It rests there, and gathers no velocity.
#[test]
fn from_under_an_arc_into_a_pipe() {
    let level = level([11, 16, 1, 1], (0, 0));
    let point = Circle::new(vec2((S / 2, S)), Fx::ZERO).unwrap();
    let moved = Mover::new().move_and_slide(&level.all(), &point, vec2((S, 0))).unwrap();
    assert_eq!(moved.hits.first().unwrap().axis, Axis::new(0, -1));
    assert_eq!((moved.body.centre(), moved.velocity, moved.remaining), (vec2((S, S)), Vec2::ZERO, Vec2::ZERO));
}
